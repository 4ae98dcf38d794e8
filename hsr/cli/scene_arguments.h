#pragma once

#include <string>

#include "hsr/cli/command_line.h"
#include "hsr/scene/tie_rule.h"

namespace hsr::cli {

/// The options that say what of the scene is seen.
struct SceneArguments {
  std::string coplanar;  ///< empty: not asked for

  void add_to(Options& options);
  bool asks_for_coplanar() const { return !coplanar.empty(); }
  Coplanar which_coplanar() const { return coplanar == "last" ? Coplanar::last : Coplanar::first; }
};

}  // namespace hsr::cli
