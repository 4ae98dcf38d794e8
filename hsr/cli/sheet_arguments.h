#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hsr/cli/command_line.h"
#include "hsr/cli/format_arguments.h"
#include "hsr/cli/line_arguments.h"
#include "hsr/cli/scene_arguments.h"
#include "hsr/io/write/format.h"
#include "hsr/io/write/png.h"
#include "hsr/io/write/svg.h"
#include "hsr/model.h"
#include "hsr/sheet/sheet.h"

namespace hsr::cli {

using namespace internal;

/// The options that say what is on a sheet.
struct SheetArguments {
  std::string page = "A3", angle, scale = "standard", unit, up_axis, views = "front,top,side,iso";
  std::vector<std::string> sections, details, titles, pens;
  std::string title_file, dimensions = "overall", centre_lines = "on", hidden = "dashed", fit_arcs, size;
  FormatArguments formats;
  SceneArguments scene;
  LineArguments lines;

  void add_to(Options& options);
  /// @throws InputError naming the option
  SheetOptions options() const;
  /// What the model says, where the options say nothing: its unit, what is up, a title of its name. @return a note, or nothing
  std::string adopt(const Model& model, SheetOptions& options) const;
  std::optional<PixelSize> pixels() const;
};

/// A sheet as a file of that format. @param title of the document
std::string sheet_bytes(const Sheet& sheet, const SheetOptions& options, const SheetArguments& arguments, Format format);

/// What a file of a sheet in units of the model is made of: its lower left corner is at the origin.
Drawing from_lower_left(const Sheet& sheet);

}  // namespace hsr::cli
