#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hsr/io/write/layers.h"

namespace hsr::internal {

/// The nearest of the 255 colours that AutoCAD has numbers for; 7 is black, on white paper.
int dxf_colour(const Colour& colour);

/// The nearest of the 24 line weights of DXF, hundredths of a millimetre.
int dxf_line_weight(double width);

/// What a layer's lines are drawn with. Dashes are in units of `dash_unit` mm on paper.
struct DxfLineType {
  std::string name = "CONTINUOUS";
  std::vector<double> dashes = {};
};
/// ISO 128's dashes are ACAD_ISO02W100; others have a line type with the name of their layer.
DxfLineType dxf_line_type(const Layer& layer, double dash_unit);

}  // namespace hsr::internal
