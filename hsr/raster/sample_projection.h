#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/error_bounded.h"
#include "geometry/rational_vector.h"
#include "geometry/vector3.h"
#include "hsr/raster/samples.h"
#include "hsr/view/view.h"

// From space to the samples of a z-buffer, in any kind of numbers: as it runs (double), with a proven bound of how far that is
// from what is true (ErrorBounded), and exactly (Rational). So its errors can be told from mistakes.

namespace hsr::internal {

namespace projection_numbers {

inline double over(double a, double b) { return a / b; }
inline ErrorBounded over(const ErrorBounded& a, const ErrorBounded& b) { return quotient(a, b); }
inline Rational over(const Rational& a, const Rational& b) { return a / b; }

template <class N>
using Vector = std::array<N, 3>;
template <class N>
Vector<N> vector(const Point3& p) {
  return {N{p.x}, N{p.y}, N{p.z}};
}
template <class N>
Vector<N> minus(const Vector<N>& a, const Vector<N>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <class N>
N dot(const Vector<N>& a, const Vector<N>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class N>
Vector<N> cross(const Vector<N>& a, const Vector<N>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// a + s b
template <class N>
Vector<N> sum(const Vector<N>& a, const N& s, const Vector<N>& b) {
  return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
}
template <class N>
Vector<N> times(const N& s, const Vector<N>& a) {
  return {s * a[0], s * a[1], s * a[2]};
}

/// Multiplies by a power of two, in two steps: 2^1070 is no double.
template <class N>
class Scaling {
 public:
  explicit Scaling(int power = 0) : half_{std::ldexp(1.0, power / 2)}, rest_{std::ldexp(1.0, power - power / 2)} {}
  Vector<N> operator()(const Vector<N>& a) const { return times(rest_, times(half_, a)); }

 private:
  N half_, rest_;
};

/// The power that makes the largest coordinate at least 1 and less than 2.
inline int power_to_one(const Point3& p) { return -std::ilogb(norm_max(p)); }

}  // namespace projection_numbers

/// Sample (i, j) is at (i, j). The nearness grows toward the viewer. Parallel: the way along the direction from the plane of
/// the samples, with lengths and direction scaled by powers of two so that the largest coordinates of SampleGrid::right and of
/// the direction are at least 1 and less than 2. Perspective: 1 / s - 1, where s is the depth over that of the plane of the
/// samples.
template <class N>
struct Seen {
  N x{}, y{}, nearness{};
};

/// From space to samples.
template <class N>
class SampleProjection {
  using V = projection_numbers::Vector<N>;

 public:
  SampleProjection(const View& view, const SampleGrid& grid) : is_perspective_(view.is_perspective()) {
    using namespace projection_numbers;
    scaled_ = Scaling<N>(power_to_one(grid.right));
    const V right = scaled_(vector<N>(grid.right)), down = scaled_(vector<N>(grid.down)), n = cross(right, down);
    // x and y of the plane of the samples: across . right = 1, across . down = 0, and so on.
    const N size = dot(n, n);
    across_ = times(over(N{1}, size), cross(down, n));
    down_ = times(over(N{1}, size), cross(n, right));
    if (is_perspective_) {
      from_ = vector<N>(view.viewpoint.at);
      const V to_samples = scaled_(minus(vector<N>(grid.origin), from_));
      depth_ = times(over(N{1}, dot(to_samples, n)), n);
      x_ = dot(across_, to_samples);
      y_ = dot(down_, to_samples);
    } else {
      from_ = vector<N>(grid.origin);
      const Point3& direction = view.viewpoint.at;
      const V e = Scaling<N>(power_to_one(direction))(vector<N>(direction));
      depth_ = times(over(N{1}, dot(e, n)), n);
      across_ = sum(across_, -dot(across_, e), depth_);
      down_ = sum(down_, -dot(down_, e), depth_);
    }
  }

  Seen<N> operator()(const V& p) const {
    using namespace projection_numbers;
    const V q = scaled_(minus(p, from_));
    const N depth = dot(depth_, q);
    if (!is_perspective_) return {dot(across_, q), dot(down_, q), depth};
    const N scale = over(N{1}, depth);
    return {dot(across_, q) * scale - x_, dot(down_, q) * scale - y_, (N{1} - depth) * scale};
  }
  Seen<N> operator()(const Point3& p) const { return (*this)(projection_numbers::vector<N>(p)); }

 private:
  bool is_perspective_;
  projection_numbers::Scaling<N> scaled_;
  V from_, across_, down_, depth_;
  N x_{}, y_{};
};

/// How far beyond the near plane, times a positive number.
template <class N>
N beyond_near(const View& view, const Point3& p) {
  using namespace projection_numbers;
  if (view.section) return dot(minus(vector<N>(p), vector<N>(view.section->point)), vector<N>(view.section->normal));
  const auto eye = vector<N>(view.viewpoint.at), to_target = minus(vector<N>(view.target), eye);
  return dot(minus(vector<N>(p), eye), to_target) - N{view.near} * dot(to_target, to_target);
}

/// Exact: a vertex that is in the near plane for one face is so for the next.
inline bool is_before_near(const View& view, const Point3& p) {
  const ErrorBounded x = beyond_near<ErrorBounded>(view, p);
  return x.is_certain() ? x.value < 0 : beyond_near<Rational>(view, p).sign() == Sign::negative;
}

/// The point where an edge meets the near plane. From the lower index, so that two faces cut their edge at the same point.
template <class N>
Seen<N> seen_near_cut(const SampleProjection<N>& project, const View& view, const Point3& lower, const Point3& higher) {
  using namespace projection_numbers;
  const N at_lower = beyond_near<N>(view, lower), at_higher = beyond_near<N>(view, higher);
  const auto p = vector<N>(lower);
  return project(sum(p, over(at_lower, at_lower - at_higher), minus(vector<N>(higher), p)));
}

/// The corners, as seen, of what is left of a triangle beyond the near plane: a convex polygon of at most four.
template <class N, class IsCutAway, class SeenVertex>
int seen_corners(const Mesh& mesh, const View& view, const SampleProjection<N>& project, TriangleId t,
                 const IsCutAway& is_cut_away, const SeenVertex& seen_vertex, std::array<Seen<N>, 4>& corners) {
  const auto& vertices = mesh.triangles[t];
  int count = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const VertexId from = vertices[k], to = vertices[(k + 1) % 3];
    if (!is_cut_away(from)) corners[count++] = seen_vertex(from);
    if (is_cut_away(from) != is_cut_away(to))
      corners[count++] = seen_near_cut(project, view, mesh.points[std::min(from, to)], mesh.points[std::max(from, to)]);
  }
  return count;
}

}  // namespace hsr::internal
