#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/bit_range.h"
#include "geometry/point.h"
#include "hsr/lines/way_out.h"
#include "hsr/scene/made_once.h"
#include "hsr/scene/view_parts.h"

namespace hsr::internal {

/// Tells the inside of bodies from what is outside: by how many faces are crossed on six ways out of the scene, forward and
/// backward along each axis but for a slant. The way round that faces are given means nothing.
///
/// Exact: yes, for the point that is looked at. Cost: O(log n + k) for the k triangles whose boxes six ways pass, and once a tree for
/// each. Any number of threads may ask.
class InsideBodies {
 public:
  /// @param tolerance within which faces count as touching a point @pre `parts` outlives this
  InsideBodies(const ViewParts& parts, double tolerance);

  const View& view() const { return parts_.view(); }

  /// A part of an edge. One object serves all parts of an edge in turn.
  struct Place {
    Point3 a, b;      ///< the ends of the edge
    Point3 from, to;  ///< of the part, rounded
    std::vector<std::pair<TriangleId, bool>>
        in_plane{};  ///< what has been found: whether some triangles lie in a plane with it
  };
  /// Whether the middle of a part is inside where the eye is outside, or the other way round, by each of the ways: an odd number of
  /// faces is between the two. Faces that touch it do not count.
  /// @param copies how many times each face is stored
  bool contain_middle(Place& place, std::size_t copies) const;
  /// The triangles through whose inside or border an edge passes, from one side to the other: between two of them it does not lead
  /// into a body, or out of one. Exact: yes.
  std::vector<TriangleId> passed_through(const Edge& edge) const;

 private:
  static constexpr std::size_t directions = 6;  // forward and backward along each axis
  static constexpr std::array<double, 4> slants = {0x1p-7, 0x1.8p-6, 0x1.4p-5, 0x1.cp-8};

  const WayOut& way(std::size_t direction, std::size_t slant) const;
  std::optional<std::size_t> crossed(Place& place, std::size_t direction) const;
  std::optional<std::size_t> crossed(Place& place, const WayOut& way) const;
  bool is_in_plane(Place& place, TriangleId t) const;

  const ViewParts& parts_;
  double tolerance_;
  BitRange bits_;
  Point3 low_, high_;
  std::array<MadeOnce<WayOut>, directions * slants.size()> ways_;
  MadeOnce<std::array<std::optional<std::size_t>, directions>> at_eye_;  // faces between the eye and the outside
};

}  // namespace hsr::internal
