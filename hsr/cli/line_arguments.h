#pragma once

#include <string>
#include <vector>

#include "hsr/cli/command_line.h"
#include "hsr/lines/line_options.h"
#include "hsr/scene/scene.h"

namespace hsr::cli {

/// What --edges takes, several of them with commas between: all, or the names of classes.
std::vector<std::string> classes_to_choose();

/// The options that say which lines are looked for, and how.
struct LineArguments {
  std::string edges = "outline,sharp,boundary,intersection,wire,material,section,hatching", method = "auto", stages;
  std::string crease = "30";
  double tolerance = 0;

  void add_to(Options& options);
  /// @throws InputError naming the option
  LineOptions options() const;
  SceneOptions scene_options() const;
};

/// @param name staged, double, interval or rational
Arithmetic arithmetic_named(const std::string& name);

}  // namespace hsr::cli
