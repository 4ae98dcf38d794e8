#pragma once

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "hsr/raster/bounded.h"
#include "hsr/raster/sample_projection.h"

namespace hsr::internal {

/// One triangle, scanned row by row. N: float, double, or Bounded of one of them, which scans the same samples.
template <class N>
class ScannedTriangle {
  using Real = std::remove_cvref_t<decltype(raw(std::declval<N>()))>;

 public:
  /// Farther away than this a corner is not drawn: products of coordinates stay finite.
  static constexpr double far = 0x1p60;
  static bool is_drawable(const Seen<N>& c) {
    return std::fabs(raw(c.x)) < far && std::fabs(raw(c.y)) < far && std::isfinite(raw(c.nearness));
  }

  /// The first sample at or after x, within 0 ... end.
  static int first_sample(Real x, int end) {
    if (!(x > 0)) return 0;
    if (!(x < static_cast<Real>(end))) return end;
    const int whole = static_cast<int>(x);
    return whole + (static_cast<Real>(whole) < x ? 1 : 0);
  }
  /// Of a side, columns a row. Where a side is that flat, it crosses at most one row, next to its end.
  static N slope(const N& x, const N& y) {
    const N s = x / y;
    return std::isfinite(raw(s)) ? s : N{};
  }

  /// The samples left ... right - 1 of rows top ... bottom - 1, around a triangle.
  struct Box {
    int left = 0, right = 0, top = 0, bottom = 0;
    bool is_empty() const { return left == right || top == bottom; }
  };
  static Box box(const Seen<N>& a, const Seen<N>& b, const Seen<N>& c, int width, int height) {
    Box box;
    box.left = first_sample(least(raw(a.x), raw(b.x), raw(c.x)), width);
    box.right = first_sample(most(raw(a.x), raw(b.x), raw(c.x)), width);
    if (box.left == box.right) return box;
    box.top = first_sample(least(raw(a.y), raw(b.y), raw(c.y)), height);
    box.bottom = first_sample(most(raw(a.y), raw(b.y), raw(c.y)), height);
    return box;
  }

  /// False: no row has a sample of it. @pre corners are drawable
  bool set(Seen<N> a, Seen<N> b, Seen<N> c, int width, int height) {
    // Most triangles of a large mesh lie between the samples: leave early.
    const Box around = box(a, b, c, width, height);
    if (around.is_empty()) return false;
    left_ = around.left;
    right_ = around.right;
    top_ = around.top;
    bottom_ = around.bottom;
    if (raw(b.y) < raw(a.y)) std::swap(a, b);
    if (raw(c.y) < raw(a.y)) std::swap(a, c);
    if (raw(c.y) < raw(b.y)) std::swap(b, c);
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
  int left() const { return left_; }
  int right() const { return right_; }
  /// The samples begin ... end - 1 of a row are drawn, left() <= begin, end <= right(). @pre top() <= j < bottom()
  std::pair<int, int> span(int j) const {
    const N y{static_cast<Real>(j)};
    const int at_long = column(a_, y, long_side_);
    const int at_short = j < middle_ ? column(a_, y, upper_side_) : column(b_, y, lower_side_);
    return b_on_right_ ? std::pair(at_long, at_short) : std::pair(at_short, at_long);
  }
  /// The nearness along a row. At each sample on its own, so that a span may begin anywhere, and samples side by side be
  /// computed at once.
  struct Row {
    N at_corner, corner, step;
    N operator()(int i) const { return at_corner + (N{static_cast<Real>(i)} - corner) * step; }
  };
  Row row(int j) const { return {a_.nearness + (N{static_cast<Real>(j)} - a_.y) * step_y_, a_.x, step_x_}; }
  N nearness(int i, int j) const { return row(j)(i); }
  /// A corner; the depths of the plane are told from there.
  const Seen<N>& corner() const { return a_; }
  /// From one sample to the next, and from one row to the next.
  const N& step() const { return step_x_; }
  const N& step_down() const { return step_y_; }

 private:
  // Of two at a time: these are one instruction, std::minmax of three is a loop.
  static Real least(Real a, Real b, Real c) { return std::min(std::min(a, b), c); }
  static Real most(Real a, Real b, Real c) { return std::max(std::max(a, b), c); }
  int column(const Seen<N>& from, const N& y, const N& side) const {
    const Real x = raw(from.x + (y - from.y) * side);
    // The first sample at or after x. Rounding may put the side beyond the corners, by less than a sample.
    const Real within = std::min(std::max(static_cast<Real>(left_), x), static_cast<Real>(right_));
    const int whole = static_cast<int>(within);
    return whole + (static_cast<Real>(whole) < within ? 1 : 0);
  }

  int left_ = 0, right_ = 0, top_ = 0, middle_ = 0, bottom_ = 0;
  bool b_on_right_ = false;
  Seen<N> a_, b_;
  N long_side_{}, upper_side_{}, lower_side_{}, step_x_{}, step_y_{};
};

}  // namespace hsr::internal
