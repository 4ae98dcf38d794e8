#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "hsr/drawing/drawing.h"

namespace hsr::cli {

/// The options that say how large and on what a picture is drawn.
struct PageArguments {
  std::string page = "A4", scale = "fit", unit = "mm", size;
  double margin = 10;

  void add_to(CLI::App& app);
  /// @throws InputError naming the option
  DrawingOptions options() const;
};

}  // namespace hsr::cli
