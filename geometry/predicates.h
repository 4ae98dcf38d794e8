#pragma once

#include <cstdint>

#include "geometry/bit_range.h"
#include "geometry/number.h"
#include "geometry/plane.h"
#include "geometry/point.h"
#include "geometry/view_plane.h"

namespace hsr {

/// Which arithmetic decides. All but `staged` are for comparison: `double_only` trusts the sign of a double and may be wrong,
/// `interval` leaves out the double filter, `rational` leaves out every filter.
enum class Arithmetic : unsigned char { staged, double_only, interval, rational };

/// How often each stage decided a sign, and how many of these signs were zero.
struct DecisionCounts {
  std::uint64_t filter = 0, interval = 0;
  std::uint64_t narrow = 0;  // 128-bit integers
  std::uint64_t fixed = 0;   // integers of 192, 384 or 768 bits
  std::uint64_t big = 0;     // big floats; rationals where these are forced
  std::uint64_t zero = 0;

  std::uint64_t exact() const { return narrow + fixed + big; }
  std::uint64_t all() const { return filter + interval + exact(); }

  DecisionCounts& operator+=(const DecisionCounts& o);
  bool operator==(const DecisionCounts&) const = default;
};

/// The three predicates that carry everything (docs/conventions.md, "Predicates"), for points under one bit range.
///
///   (1) each sign is the sign of the polynomial over the rationals, for every finite input, except under `double_only`
///   (2) negating or swapping arguments as the polynomial does negates the sign
///   (3) multiplying all points, or the direction, by a power of two that rounds nothing changes no sign
///
/// Stages: a double with a proven error bound; where the bit range allows 128-bit integers, these at once; else an interval
/// ([0, 0] is a certified zero); then exactly: wider fixed-width integers after lossless scaling where the bit range allows,
/// big floats (CGAL::Mpzf) otherwise. One object per thread; it only counts. Cost: bench/predicates prints it for each stage.
/// Source: Shewchuk 1997; Bronnimann, Burnikel & Pion 2001 (intervals).
class Predicates {
 public:
  /// @param points bit range of every point, an eye included, that will be passed
  /// @param direction bit range of the direction toward the viewer, if there is one
  explicit Predicates(const BitRange& points, const BitRange& direction = {}, Arithmetic arithmetic = Arithmetic::staged);

  /// On which side of `x` the point lies: the sign of x(p). Degree 3 (near_line: 6).
  Sign side(const Plane& x, const Point3& p);
  /// The sign of x(p) for a caller whose PlaneFilter could not decide it: starts after the double filter.
  Sign side_beyond_filter(const Plane& x, const Point3& p);

  /// The sign of x(p) y(q) - x(q) y(p). Degree 6 for spans.
  Sign cross(const Plane& x, const Plane& y, const Point3& p, const Point3& q);

  /// How the value of c changes along the line where a and b meet, which runs along the cross product of their gradients; zero:
  /// they meet in no single point. Degree 6 for spans.
  Sign turn(const Plane& a, const Plane& b, const Plane& c);

  /// On which side of `x` the common point of a, b and c lies. Degree 9 for spans.
  /// @throws PreconditionError unless a is a span, and they meet in one point
  Sign side(const Plane& x, const Plane& a, const Plane& b, const Plane& c);

  /// On which side of the line l of the image the image of p lies: positive, to its left as seen. Degree 3; of a meet 6.
  Sign side(const Camera& camera, const ViewPlane& l, const Point3& p);
  /// How m turns against l, where each runs with its positive side on its left: positive, to the left, so that the values of m
  /// fall along l; zero, they are parallel in the image. Degree 4 and up (of the planes' own degrees).
  Sign turn(const Camera& camera, const ViewPlane& l, const ViewPlane& m);
  /// On which side of the line n the crossing of l and m lies. Degree 6; of three meets 15.
  /// @throws PreconditionError if turn(l, m) is zero
  Sign side(const Camera& camera, const ViewPlane& n, const ViewPlane& l, const ViewPlane& m);

  Arithmetic arithmetic() const { return arithmetic_; }
  const DecisionCounts& counts() const { return counts_; }
  DecisionCounts& counts() { return counts_; }

  /// Below this the error bound of a PlaneFilter holds; else its answers must not be used.
  bool filter_is_proven() const { return filter_is_proven_; }

 private:
  template <class Polynomial>
  Sign staged(const Polynomial& polynomial, bool only_spans, int degree);
  template <class Polynomial>
  Sign beyond_filter(const Polynomial& polynomial, bool only_spans, int degree);
  Sign crossing_weight(const Camera& camera, const ViewPlane& l, const ViewPlane& m);

  BitRange points_, direction_;
  Arithmetic arithmetic_;
  bool filter_is_proven_;
  bool is_narrow_;  // the scales below are doubles
  int width_;       // bits of a coordinate difference or a direction, whichever is more
  double scale_, direction_scale_;
  DecisionCounts counts_;
};

}  // namespace hsr
