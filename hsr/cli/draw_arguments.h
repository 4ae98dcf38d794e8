#pragma once

#include <string>
#include <vector>

#include "hsr/cli/command_context.h"
#include "hsr/cli/fill_arguments.h"
#include "hsr/cli/format_arguments.h"
#include "hsr/cli/line_arguments.h"
#include "hsr/cli/page_arguments.h"
#include "hsr/cli/scene_arguments.h"

namespace hsr::cli {

/// What hsr draw is given, as it is given.
struct DrawArguments {
  ModelArguments models;
  std::vector<std::string> outputs;
  ViewOptions view;
  SceneArguments scene;
  LineArguments lines;
  bool fill = false, outline_only = false;
  FillArguments fills;
  bool check = false;
  std::string hidden = "none", overhead = "off";
  bool section_each = false;
  PageArguments page;
  FormatArguments formats;
  bool why = false;
  std::string arithmetic = "staged";
  CommonArguments common;

  /// Declares the verb.
  Options add_to(CommandLine& command);
};

}  // namespace hsr::cli
