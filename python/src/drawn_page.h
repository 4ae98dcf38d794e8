#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hsr/drawing/drawing.h"
#include "hsr/io/write/format.h"
#include "hsr/io/write/png.h"
#include "hsr/io/write/svg.h"
#include "python/src/arguments.h"

namespace hsr::python {

using namespace internal;

/// A drawing on a page, and what is written with it: of a scene's lines or of a painter's order.
struct DrawnPage {
  Drawing drawing;
  std::optional<Drawing> in_model_units;  ///< for DXF; only if a file wants it
  std::string json;                       ///< only if a file wants it
  SvgOptions captions;
  std::string scale;  ///< ", scale 1:2", or empty
  std::optional<PixelSize> size;
  bool is_in_frame_units = false;  ///< no page: a projection, see DrawingOptions
  std::string dxf_release = "r12";
  double unit = 1;  ///< millimetres in a unit of the model
  std::vector<std::string> notes;

  /// What the command writes into a file of that format.
  /// @throws InputError where the page has not what the format takes, or the format cannot show it
  std::string bytes(Format format) const;
};

/// The files that are asked for, each with the format that its ending chooses.
struct OutputPaths {
  std::vector<std::string> paths;
  std::vector<Format> formats;

  /// @throws InputError for an ending that is none of the expected
  OutputPaths(const Arguments& a, std::span<const Format> expected);
  bool wants(Format format) const;
  /// Writes all of the files, or none.
  void write(const DrawnPage& page) const;
};

}  // namespace hsr::python
