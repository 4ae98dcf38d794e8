#pragma once

#include "hsr/drawing/enclosure.h"
#include "hsr/lines/visible_lines.h"

namespace hsr {

/// An enclosure of the parameter t of a cut; exact at the ends.
Enclosure enclosed_parameter(const Mesh& mesh, const View& view, const Edge& edge, const Cut& cut);

/// The parameter t of a cut, correctly rounded. Rationals only where an enclosure leaves two doubles open.
double rounded_parameter(const Mesh& mesh, const View& view, const Edge& edge, const Cut& cut);

}  // namespace hsr
