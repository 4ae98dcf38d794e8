#pragma once

#include <string>

#include "hsr/cli/command_line.h"

namespace hsr::cli {

/// The options that say how files of one format or another are written.
struct FormatArguments {
  std::string dxf_release = "r12", id_prefix;
  bool exact = false;  ///< JSON: numbers as strings "p/q"

  void add_dxf_to(Options& options);
  void add_id_prefix_to(Options& options);
  /// Begins the group of options about numbers. @param help what is exact
  void add_exact_to(Options& options, const std::string& help = "JSON: exact numbers as strings \"p/q\"");
};

}  // namespace hsr::cli
