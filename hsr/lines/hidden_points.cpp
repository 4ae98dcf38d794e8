#include "hsr/lines/hidden_points.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "geometry/bit_range.h"
#include "geometry/constructed_point.h"
#include "geometry/error.h"
#include "geometry/near_value.h"
#include "geometry/rational_vector.h"
#include "hsr/scene/view_parts.h"

namespace hsr {

using namespace internal;

namespace {

/// Tells what hides one point after the other. One object per thread.
class PointOcclusion {
 public:
  /// @param caps of a section, or nullptr
  PointOcclusion(const ProjectedMesh& projected, const Occluders& occluders, const SectionCaps* caps)
      : projected_(projected), occluders_(occluders), caps_(caps), exact_(projected.predicates()) {}

  bool is_hidden(const Point3& given) {
    const Point3 p = projected_.scaled(given);
    const Sign beyond = projected_.has_near() ? exact_.side(projected_.near_plane(), p) : Sign::positive;
    // What lies in the near plane has no face before it, but a cap, which is nearer than all that lies in its plane.
    if (beyond != Sign::negative && is_behind_cap(given)) return true;
    if (beyond != Sign::positive) return false;
    bool found = false;
    occluders_.tree.visit(projected_.box(p), [&](std::uint32_t i) {
      found = hides(occluders_.triangles[i], p);
      return !found;
    });
    return found;
  }

 private:
  bool is_behind_cap(const Point3& given) const {
    if (caps_ == nullptr) return false;
    const auto known = caps_->covers(caps_->seen_at({{{given.x, 0}, {given.y, 0}, {given.z, 0}}}));
    return known ? *known : caps_->covers(caps_->seen_at(rational(given)));
  }

  /// See TriangleOcclusion: p is strictly beyond the plane of the triangle, in the closed cone of the eye and the triangle, and
  /// where the near plane cuts the triangle, the line of sight meets it beyond that.
  bool hides(TriangleId t, const Point3& p) {
    const Sign facing = projected_.facing(t), beyond = exact_.side(projected_.face_plane(t), p);
    if (facing == Sign::zero) return beyond == Sign::zero && hides_edge_on(t, p);
    if (beyond * facing != Sign::negative) return false;
    const auto& c = projected_.mesh().triangles[t];
    for (std::size_t k = 0; k < 3; ++k)
      if (exact_.side(projected_.sight_plane(c[k], c[(k + 1) % 3]), p) * facing == Sign::negative) return false;
    return !projected_.reaches_before_near(t) ||
           exact_.side(projected_.near_line(projected_.face_plane(t)), p) * facing != Sign::negative;
  }

  /// For a triangle whose plane contains the line of sight. The part of this line that is in the triangle goes from one end to
  /// another: corners on the line, or where it cuts sides. It hides p iff one end is nearer than p, and one is beyond the near
  /// plane, or in it: the line goes through p, then the near plane, then the eye.
  bool hides_edge_on(TriangleId t, const Point3& p) {
    const auto& c = projected_.mesh().triangles[t];
    const int axis = flat_axis(t);
    const Plane sight = Plane::of_sight_along_axis(projected_.eye(), p, axis);
    std::array<Sign, 3> side;
    for (std::size_t k = 0; k < 3; ++k) side[k] = exact_.side(sight, projected_.point(c[k]));
    bool is_nearer = false, is_beyond_near = false;
    const auto add = [&](const RationalVector& q) {
      is_nearer = is_nearer || nearer(q, p);
      is_beyond_near = is_beyond_near || !projected_.has_near() || beyond_near(q);
    };
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      if (side[k] == Sign::zero) add(rational(projected_.point(c[k])));
      if (side[k] * side[next] == Sign::negative)
        add(ConstructedPoint::on_edge(projected_.point(c[k]), projected_.point(c[next]), sight).exact());
    }
    return is_nearer && is_beyond_near;
  }

  /// An axis along which the triangle's plane is not seen edge-on.
  int flat_axis(TriangleId t) {
    const auto& c = projected_.mesh().triangles[t];
    for (int axis = 0; axis < 2; ++axis)
      if (exact_.side(Plane::along_axis(projected_.point(c[0]), projected_.point(c[1]), axis), projected_.point(c[2])) !=
          Sign::zero)
        return axis;
    return 2;
  }

  /// Whether q, which is on the line of sight of p, is on the viewer's side of it.
  bool nearer(const RationalVector& q, const Point3& p) const {
    const Point3& e = projected_.eye().at;
    for (int axis = 0; axis < 3; ++axis) {
      const Sign toward = projected_.is_perspective() ? sign_of(e[axis] < p[axis]   ? -1
                                                                : e[axis] > p[axis] ? 1
                                                                                    : 0)
                                                      : sign_of(e[axis]);
      if (toward == Sign::zero) continue;
      const Rational change = q[static_cast<std::size_t>(axis)] - Rational(p[axis]);
      return change.sign() == toward;
    }
    return false;
  }

  /// Whether q is beyond the near plane, or in it.
  bool beyond_near(const RationalVector& q) const { return near_value(projected_.near_plane(), q).sign() != Sign::negative; }

  const ProjectedMesh& projected_;
  const Occluders& occluders_;
  const SectionCaps* caps_;
  Predicates exact_;
};

}  // namespace

namespace {

/// A point is asked about in each cell that it is in, or on a side of.
std::vector<bool> hidden_in_cells(const SceneView& scene, std::span<const Point3> points) {
  const ProjectedMesh& projected = scene.parts().with(bit_range(points)).projected();
  Predicates exact = projected.predicates();
  std::vector<bool> hidden(points.size(), false);
  for (const ViewParts::Cell& cell : scene.parts().cells()) {
    std::vector<std::size_t> own;
    std::vector<Point3> asked;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Point3 p = projected.scaled(points[k]);
      const bool is_in = std::all_of(cell.cell.sides.begin(), cell.cell.sides.end(), [&](const CellSide& side) {
        return exact.side(projected.fold_plane(side.u, side.v), p) * side.kept != Sign::negative;
      });
      if (!is_in) continue;
      own.push_back(k);
      asked.push_back(points[k]);
    }
    const std::vector<bool> found = hidden_points(cell.scene, asked);
    for (std::size_t k = 0; k < own.size(); ++k)
      if (found[k]) hidden[own[k]] = true;
  }
  return hidden;
}

}  // namespace

std::vector<bool> hidden_points(const SceneView& scene, std::span<const Point3> points) {
  for (std::size_t k = 0; k < points.size(); ++k)
    if (!std::isfinite(points[k].x) || !std::isfinite(points[k].y) || !std::isfinite(points[k].z))
      throw InputError("point " + std::to_string(k) + ": found a coordinate that is not finite, expected three finite numbers");
  if (scene.view().has_cells()) return hidden_in_cells(scene, points);
  const ViewParts& parts = scene.parts().with(bit_range(points));
  const ProjectedMesh& projected = parts.projected();
  const Occluders& occluders = parts.occluders(Excluded::none);
  const SectionCaps* const caps = parts.caps();
  std::vector<std::uint8_t> hidden(points.size());  // two threads may not write into one word of bits
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points.size(), 64), [&](const auto& range) {
    PointOcclusion occlusion(projected, occluders, caps);
    for (std::size_t k = range.begin(); k != range.end(); ++k) {
      const Point3& p = points[k];
      hidden[k] = occlusion.is_hidden({p.x + 0.0, p.y + 0.0, p.z + 0.0}) ? 1 : 0;  // -0 + 0 = 0
    }
  });
  return {hidden.begin(), hidden.end()};
}

}  // namespace hsr
