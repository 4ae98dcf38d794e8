#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "geometry/mesh.h"
#include "geometry/point.h"
#include "hsr/scene/box_tree.h"

namespace hsr::internal {

/// A straight way out of the scene, the same for every place that it starts from: along a coordinate axis, but for a slant. The
/// triangles as they are seen along it are in a tree, so that few are looked at for each start.
///
/// Exact: what it tells is certain; what doubles do not tell it says so. Cost: O(n log n) once, parallel; O(log n + k) for each start
/// that lies behind k boxes of triangles.
class WayOut {
 public:
  /// @pre `mesh` outlives this
  WayOut(const Mesh& mesh, int axis, bool forward, double slant);

  /// A place so far along the way from `start` that it is outside of all triangles, to a rounding. @param low, high a box around them
  Point3 outside(const Point3& start, const Point3& low, const Point3& high) const;

  enum class Crossing : std::uint8_t { no, yes, unknown };
  /// Calls f(triangle, crossing) for all triangles that the way from a place crosses, and for all of which doubles do not tell.
  template <class F>
  void visit(const Point3& start, F&& f) const {
    const Seen from = seen(start);
    const double margin = margin_ + rounding * norm_max(start);
    ImageBox ahead = ImageBox::nothing();
    ahead.add({from.u, from.v, from.along}, {margin, margin, margin});
    ahead.nearest = std::numeric_limits<float>::infinity();
    tree_.visit_touching(ahead, [&](std::uint32_t t) {
      const Crossing found = crossing(TriangleId(t), from, margin);
      if (found != Crossing::no) f(TriangleId(t), found);
      return true;
    });
  }

 private:
  /// A point as seen along the way, and how far along it is.
  struct Seen {
    double u, v, along;
  };
  static constexpr double rounding = 0x1p-38;  // far more than what is rounded

  static double norm_max(const Point3& p);
  Seen seen(const Point3& p) const;
  Crossing crossing(TriangleId t, const Seen& from, double margin) const;

  const Mesh& mesh_;
  int axis_;
  double sign_;
  std::array<double, 2> slope_;
  double margin_;
  BoxTree tree_;
};

}  // namespace hsr::internal
