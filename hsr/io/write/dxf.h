#pragma once

#include <cstdint>
#include <string>

#include "hsr/drawing/drawing.h"

namespace hsr::internal {

enum class DxfVersion : std::uint8_t { r12, r2000 };

struct DxfOptions {
  DxfVersion version = DxfVersion::r12;
  double unit = 1;        ///< millimetres in a unit of the model: 1, 10, 1000 and 25.4 are told to the reader ($INSUNITS)
  double page_scale = 1;  ///< millimetres of paper to a unit of the model, at which dashes are 3 mm long
};

/// The lines of a drawing as DXF, in units of the model: 1:1, whatever the page. No fills.
///
///   (1) a layer for each visibility and class that occurs, VISIBLE_OUTLINE; dashed ones in the line type ACAD_ISO02W100, or one of
///       their own for other dashes; colours are the nearest of the 255 numbered ones
///   (2) release 12 (AC1009): LINE and POLYLINE. Release 2000 (AC1015): LINE and LWPOLYLINE, and layers have line weights. Arcs are
///       CIRCLE, ARC and bulges of polylines where they are of circles; else ELLIPSE, or in release 12 short lines of a polyline
///   (3) extended data of the application HSR: "edges", then two numbers for each edge; "faces", then a number for each face; of
///       long lines the first 1000 numbers of each, and "and N more"; "object", then the object's name, where objects are told apart
///
/// @param drawing made with DrawingOptions::in_frame_units; y is up in the file
std::string dxf(const Drawing& drawing, const DxfOptions& options = {});

}  // namespace hsr::internal
