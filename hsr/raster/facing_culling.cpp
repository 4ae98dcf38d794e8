#include "hsr/raster/facing_culling.h"

#include "geometry/error_bounded.h"
#include "hsr/raster/sample_projection.h"

namespace hsr::internal {

namespace {

using namespace projection_numbers;

template <class N>
using Corners = std::array<Vector<N>, 3>;

template <class N>
Vector<N> normal(const Corners<N>& c) {
  return cross(minus(c[1], c[0]), minus(c[2], c[0]));
}

template <class N>
N in_world(const View& view, const Corners<N>& c) {
  const Vector<N> from = vector<N>(view.viewpoint.at);
  return dot(normal(c), view.is_perspective() ? minus(from, c[0]) : from);
}

/// The axes of the paper; the third points toward the viewer.
template <class N>
std::array<Vector<N>, 3> axes(const View& view) {
  const Vector<N> right = vector<N>(view.frame.right), up = vector<N>(view.frame.up);
  return {right, up, cross(right, up)};
}
template <class N>
Vector<N> along(const std::array<Vector<N>, 3>& axes, const Vector<N>& p) {
  return {dot(axes[0], p), dot(axes[1], p), dot(axes[2], p)};
}

/// The axes turn like those of the world, so no sign changes.
template <class N>
N in_eye_space(const View& view, const Corners<N>& c) {
  const auto to_eye = axes<N>(view);
  const Vector<N> from = vector<N>(view.viewpoint.at);
  Corners<N> seen;
  for (std::size_t k = 0; k < 3; ++k) seen[k] = along(to_eye, view.is_perspective() ? minus(c[k], from) : c[k]);
  return view.is_perspective() ? -dot(normal(seen), seen[0]) : dot(normal(seen), along(to_eye, from));
}

/// Perspective: x = X / W and y = Y / W with W = -Z, so the determinant of (X, Y, W) is twice the area times the three W; where
/// they are not all positive it still tells the front.
template <class N>
N in_projection(const View& view, const Corners<N>& c) {
  const auto to_eye = axes<N>(view);
  const Vector<N> from = vector<N>(view.viewpoint.at);
  Corners<N> seen;
  if (view.is_perspective()) {
    for (std::size_t k = 0; k < 3; ++k) {
      seen[k] = along(to_eye, minus(c[k], from));
      seen[k][2] = -seen[k][2];
    }
    return dot(seen[0], cross(seen[1], seen[2]));
  }
  // Along the direction (d, e, f) to the paper: x = X - Z d / f, y = Y - Z e / f; both times f.
  const Vector<N> direction = along(to_eye, from);
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector<N> p = along(to_eye, c[k]);
    seen[k] = {p[0] * direction[2] - p[2] * direction[0], p[1] * direction[2] - p[2] * direction[1], N{}};
  }
  const Vector<N> ab = minus(seen[1], seen[0]), ac = minus(seen[2], seen[0]);
  return ab[0] * ac[1] - ab[1] * ac[0];
}

template <class N>
N value(const Mesh& mesh, const View& view, TriangleId t, FacingSpace space) {
  Corners<N> corners;
  for (std::size_t k = 0; k < 3; ++k) corners[k] = vector<N>(mesh.points[mesh.triangles[t][k]]);
  return space == FacingSpace::world ? in_world(view, corners)
         : space == FacingSpace::eye ? in_eye_space(view, corners)
                                     : in_projection(view, corners);
}

/// The sign is exact, the value as good as doubles are; 0 where these do not tell.
struct Faced {
  Sign sign;
  double value;
};

Faced faced(const Mesh& mesh, const View& view, TriangleId t, FacingSpace space) {
  const ErrorBounded near = value<ErrorBounded>(mesh, view, t, space);
  if (near.is_certain()) return {near.value > 0 ? Sign::positive : Sign::negative, near.value};
  return {value<Rational>(mesh, view, t, space).sign(), 0};
}

}  // namespace

Sign facing(const Mesh& mesh, const View& view, TriangleId t, FacingSpace space) { return faced(mesh, view, t, space).sign; }

Culled facing_culled(const Mesh& mesh, const View& view, Facing culled, FacingSpace space, CullingObserver* observer) {
  Culled result;
  const Sign kept = culled == Facing::back ? Sign::positive : Sign::negative;
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    ++result.tests;
    const Faced found = faced(mesh, view, TriangleId(k), space);
    if (observer != nullptr) observer->tested({k, k + 1, found.sign != kept, found.value});
    if (found.sign == kept)
      result.kept.push_back(TriangleId(k));
    else
      ++result.culled;
  }
  return result;
}

}  // namespace hsr::internal
