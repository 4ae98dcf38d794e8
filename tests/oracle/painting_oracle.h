#pragma once

#include <string>
#include <vector>

#include "geometry/mesh.h"
#include "hsr/painter/painters_order.h"
#include "hsr/scene/tie_rule.h"
#include "hsr/view/view.h"
#include "tests/oracle/exact_vector.h"

namespace hsr::oracle {

/// A convex polygon in space, beyond the near plane, and the number by which coplanar ones are ordered.
struct PaintedPolygon {
  std::vector<Vec> corners;
  std::uint32_t rank = 0;
};

/// How two polygons lie where their images overlap with an area.
enum class PairOrder { apart, first_behind, second_behind, coplanar, piercing };

/// By clipping their images and comparing depths at each corner of the common part, in rationals.
PairOrder pair_order(const View& view, const PaintedPolygon& a, const PaintedPolygon& b);

/// What is wrong with a painting order, by every pair of pieces: a text for each pair that is painted the wrong way round, and
/// for each face that its pieces do not cover exactly once. Empty: nothing.
/// @param coplanar which of coincident faces is painted last
std::vector<std::string> wrong_with_order(const Mesh& mesh, const View& view, const PaintersOrder& order,
                                          Coplanar coplanar = Coplanar::first);

}  // namespace hsr::oracle
