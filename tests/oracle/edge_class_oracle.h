#pragma once

#include <optional>

#include "geometry/mesh.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/view.h"

namespace hsr::oracle {

struct ClassVerdict {
  EdgeClass edge_class = EdgeClass::smooth;
  /// The angle is so near to the crease, or a face so thin, that doubles may call the edge sharp or smooth.
  bool is_near_crease = false;
};

/// The class of an edge by the definition, in rationals from the half-planes of the triangles at it; nothing if the edge is
/// not listed (a diagonal that is no outline).
std::optional<ClassVerdict> class_of(const Mesh& mesh, const View& view, EdgeId edge, double crease);

}  // namespace hsr::oracle
