#pragma once

#include <string>

#include "hsr/drawing/drawing.h"
#include "hsr/image.h"
#include "hsr/model.h"

namespace hsr {

/// What some formats are told besides.
struct WriteOptions {
  std::string title = {};        ///< SVG, PDF and EPS; any text
  std::string description = {};  ///< SVG: of the view, say
  std::string id_prefix = {};    ///< SVG: before each id, so that those of several files in one page do not collide

  int width = 0, height = 0;  ///< PNG: pixels that the page is scaled to fit and centred in; 0: 150 dots to the inch

  bool is_dxf_2000 = false;  ///< DXF: release 2000 instead of release 12
  double unit = 1;           ///< DXF: millimetres in a unit of the model
  double page_scale = 1;     ///< DXF: millimetres of paper to a unit of the model, at which dashes are 3 mm long
};

/// A drawing in the format of that name: svg, pdf, eps, dxf, tex (LaTeX with TikZ), hpgl or plt, png. The same bytes for any number
/// of threads, on any day.
///
/// Each has a layer, or what the format has instead, for each visibility and class of lines that occurs, hidden ones first. DXF takes
/// a drawing that is made with DrawingOptions::in_frame_units, and is in units of the model, whatever the page. DXF and HPGL have no
/// fills, and EPS none that are seen through.
/// @throws InputError for another name, for EPS with fills that are seen through, or where the page or the picture is too large for the format or for memory
std::string written(const Drawing& drawing, const std::string& format, const WriteOptions& options = {});

/// A picture as PNG: 8 bits each of red, green, blue and opacity, sRGB.
/// @throws InputError if the picture is empty, or too large for the format or for memory
std::string written(const Image<Colour>& image);

}  // namespace hsr
