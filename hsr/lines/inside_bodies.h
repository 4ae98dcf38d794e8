#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/bit_range.h"
#include "geometry/point.h"
#include "hsr/scene/view_parts.h"

namespace hsr::internal {

/// Tells the inside of bodies from what is outside: by how many faces are crossed on six ways out of the scene, forward and
/// backward along each axis but for a slant. The way round that faces are given means nothing.
///
/// Exact: yes, for the point that is looked at. Cost: O(log n + k) for k triangles in six narrow boxes, and once a tree.
class InsideBodies {
 public:
  /// @param tolerance within which faces count as touching a point @pre `parts` outlives this
  InsideBodies(const ViewParts& parts, double tolerance);

  const View& view() const { return parts_.view(); }

  /// Whether the middle of a segment is inside where the eye is outside, or the other way round, by each of the ways: an odd
  /// number of faces is between the two. Faces that touch it do not count.
  /// @param copies how many times each face is stored
  bool contain_middle(const Point3& from, const Point3& to, std::size_t copies) const;
  /// The triangles through whose inside or border an edge passes, from one side to the other: between two of them it does not lead
  /// into a body, or out of one. Exact: yes.
  std::vector<TriangleId> passed_through(const Edge& edge) const;

 private:
  std::optional<std::size_t> crossed(const Point3& from, const Point3& to, int axis, bool forward) const;
  std::optional<std::size_t> crossed(const Point3& from, const Point3& to, const Point3& outside, int axis) const;

  const ViewParts& parts_;
  double tolerance_;
  BitRange bits_;
  Point3 low_, high_;
};

}  // namespace hsr::internal
