#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "geometry/error_bounded.h"
#include "geometry/rational_vector.h"
#include "hsr/image/samples.h"
#include "hsr/view.h"

// What the z-buffer computes, step by step, in any kind of numbers: as it runs (float, double), with a proven bound of how far
// that is from what is true (Bounded), and exactly (Rational). So its errors can be told from mistakes.

namespace hsr {

/// A number as the z-buffer has it, and how far from it the true one is at most.
template <class Real>
struct Bounded {
  Real value = 0;
  double error = 0;

  static constexpr double u = std::numeric_limits<Real>::epsilon() / 2.0, lost = std::numeric_limits<Real>::denorm_min();
  static constexpr double grow = ErrorBounded::grow;

  friend Bounded operator+(Bounded a, Bounded b) {
    const Real v = a.value + b.value;
    return {v, (a.error + b.error + u * std::fabs(static_cast<double>(v))) * grow};
  }
  friend Bounded operator-(Bounded a) { return {-a.value, a.error}; }
  friend Bounded operator-(Bounded a, Bounded b) { return a + -b; }
  friend Bounded operator*(Bounded a, Bounded b) {
    const Real v = a.value * b.value;
    const double e = std::fabs(static_cast<double>(a.value)) * b.error + std::fabs(static_cast<double>(b.value)) * a.error +
                     a.error * b.error + u * std::fabs(static_cast<double>(v));
    return {v, e * grow + lost};
  }
  friend Bounded operator/(Bounded a, Bounded b) {
    const Real v = a.value / b.value;
    const double q = std::fabs(static_cast<double>(v)), below = std::fabs(static_cast<double>(b.value)) - b.error;
    if (!(below > b.error)) return {v, HUGE_VAL};
    return {v, ((a.error + q * b.error) / below + u * q) * 1.01 + lost};
  }
};

namespace z_buffer_numbers {

inline double over(double a, double b) { return a / b; }
inline ErrorBounded over(const ErrorBounded& a, const ErrorBounded& b) { return quotient(a, b); }
inline Rational over(const Rational& a, const Rational& b) { return a / b; }

/// What comparisons look at.
template <class Real>
Real raw(const Bounded<Real>& x) {
  return x.value;
}
inline float raw(float x) { return x; }
inline double raw(double x) { return x; }

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
inline int power_to_one(const Point3& p) { return -std::ilogb(std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)})); }

}  // namespace z_buffer_numbers

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
class Projection {
  using V = z_buffer_numbers::Vector<N>;

 public:
  Projection(const View& view, const SampleGrid& grid) : is_perspective_(view.is_perspective()) {
    using namespace z_buffer_numbers;
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
    using namespace z_buffer_numbers;
    const V q = scaled_(minus(p, from_));
    const N depth = dot(depth_, q);
    if (!is_perspective_) return {dot(across_, q), dot(down_, q), depth};
    const N scale = over(N{1}, depth);
    return {dot(across_, q) * scale - x_, dot(down_, q) * scale - y_, (N{1} - depth) * scale};
  }
  Seen<N> operator()(const Point3& p) const { return (*this)(z_buffer_numbers::vector<N>(p)); }

 private:
  bool is_perspective_;
  z_buffer_numbers::Scaling<N> scaled_;
  V from_, across_, down_, depth_;
  N x_{}, y_{};
};

/// How far beyond the near plane, times a positive number.
template <class N>
N beyond_near(const View& view, const Point3& p) {
  using namespace z_buffer_numbers;
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
Seen<N> seen_near_cut(const Projection<N>& project, const View& view, const Point3& lower, const Point3& higher) {
  using namespace z_buffer_numbers;
  const N at_lower = beyond_near<N>(view, lower), at_higher = beyond_near<N>(view, higher);
  const auto p = vector<N>(lower);
  return project(sum(p, over(at_lower, at_lower - at_higher), minus(vector<N>(higher), p)));
}

/// The corners, as seen, of what is left of a triangle beyond the near plane: a convex polygon of at most four.
template <class N, class IsCutAway, class SeenVertex>
int seen_corners(const Mesh& mesh, const View& view, const Projection<N>& project, TriangleId t, const IsCutAway& is_cut_away,
                 const SeenVertex& seen_vertex, std::array<Seen<N>, 4>& corners) {
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

/// One triangle, scanned row by row. N: float, double, or Bounded of one of them, which scans the same samples.
template <class N>
class ScannedTriangle {
 public:
  /// Farther away than this a corner is not drawn: products of coordinates stay finite.
  static constexpr double far = 0x1p60;
  static bool is_drawable(const Seen<N>& c) {
    using z_buffer_numbers::raw;
    return std::fabs(raw(c.x)) < far && std::fabs(raw(c.y)) < far && std::isfinite(raw(c.nearness));
  }

  /// False: no row has a sample of it. @pre corners are drawable
  bool set(Seen<N> a, Seen<N> b, Seen<N> c, int width, int height) {
    using z_buffer_numbers::raw;
    width_ = width;
    // Most triangles of a large mesh lie between the samples: leave early.
    const auto [low, high] = std::minmax({raw(a.x), raw(b.x), raw(c.x)});
    if (first_sample(low, width) == first_sample(high, width)) return false;
    if (raw(b.y) < raw(a.y)) std::swap(a, b);
    if (raw(c.y) < raw(a.y)) std::swap(a, c);
    if (raw(c.y) < raw(b.y)) std::swap(b, c);
    top_ = first_sample(raw(a.y), height);
    bottom_ = first_sample(raw(c.y), height);
    if (top_ == bottom_) return false;
    const N bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
    const N area = bx * cy - by * cx;
    if (raw(area) == 0) return false;
    const N bz = b.nearness - a.nearness, cz = c.nearness - a.nearness;
    step_x_ = (bz * cy - cz * by) / area;
    step_y_ = (cz * bx - bz * cx) / area;
    middle_ = first_sample(raw(b.y), height);
    a_ = a;
    b_ = b;
    long_side_ = slope(cx, cy);
    if (top_ < middle_) upper_side_ = slope(bx, by);
    if (middle_ < bottom_) lower_side_ = slope(c.x - b.x, c.y - b.y);
    // The long side ac is on the left where b is on the right of it.
    b_on_right_ = raw(area) > 0;
    return true;
  }

  int top() const { return top_; }
  int bottom() const { return bottom_; }
  /// The samples begin ... end - 1 of a row are drawn. @pre top() <= j < bottom()
  std::pair<int, int> span(int j) const {
    const N y{static_cast<Real>(j)};
    const int at_long = column(a_, y, long_side_);
    const int at_short = j < middle_ ? column(a_, y, upper_side_) : column(b_, y, lower_side_);
    return b_on_right_ ? std::pair(at_long, at_short) : std::pair(at_short, at_long);
  }
  /// At the first sample of a row; from there on step() is added.
  N nearness(int begin, int j) const {
    return a_.nearness + (N{static_cast<Real>(begin)} - a_.x) * step_x_ + (N{static_cast<Real>(j)} - a_.y) * step_y_;
  }
  const N& step() const { return step_x_; }

 private:
  using Real = std::remove_cvref_t<decltype(z_buffer_numbers::raw(std::declval<N>()))>;

  /// The first sample at or after x, within 0 ... end.
  static int first_sample(Real x, int end) {
    if (!(x > 0)) return 0;
    if (!(x < static_cast<Real>(end))) return end;
    const int whole = static_cast<int>(x);
    return whole + (static_cast<Real>(whole) < x ? 1 : 0);
  }
  /// Where a side is that flat, it crosses at most one row, next to its end.
  static N slope(const N& x, const N& y) {
    const N s = x / y;
    return std::isfinite(z_buffer_numbers::raw(s)) ? s : N{};
  }
  int column(const Seen<N>& from, const N& y, const N& side) const {
    return first_sample(z_buffer_numbers::raw(from.x + (y - from.y) * side), width_);
  }

  int width_ = 0, top_ = 0, middle_ = 0, bottom_ = 0;
  bool b_on_right_ = false;
  Seen<N> a_, b_;
  N long_side_{}, upper_side_{}, lower_side_{}, step_x_{}, step_y_{};
};

}  // namespace hsr
