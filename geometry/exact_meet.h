#pragma once

#include <memory>

#include "geometry/bit_range.h"
#include "geometry/number.h"
#include "geometry/plane.h"

namespace hsr::internal {

/// The common point of three planes in whole numbers, made once for many questions on which side of a plane it is: a question then
/// takes 4 long products where the polynomial of all four planes takes 60.
///
/// By Cramer's rule the point is o + m / d, o a point of the first plane; x is there of the sign of x(o) d + n_x . m, and of d.
class ExactMeet {
 public:
  /// @param points of all planes, those that are asked about, too @pre the planes are spans of points and axes, and meet in one point
  ExactMeet(const BitRange& points, const Plane& a, const Plane& b, const Plane& c);
  ~ExactMeet();
  ExactMeet(ExactMeet&&) noexcept;
  ExactMeet& operator=(ExactMeet&&) noexcept;

  /// Of which sign a plane is at the point. @pre it is a span of points and axes. Exact: yes.
  Sign side(const Plane& x) const;

 private:
  struct Numbers;
  template <class Arithmetic>
  struct NumbersOf;

  std::unique_ptr<const Numbers> numbers_;
};

}  // namespace hsr::internal
