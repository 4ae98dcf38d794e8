#pragma once

#include <span>

#include "geometry/point.h"

namespace hsr {

/// How many bits a set of numbers needs: each is a multiple of 2^lowest and smaller than 2^highest in magnitude.
///
/// Bounds every polynomial of the numbers, and so says which exact arithmetic suffices and where a filter's proof holds
/// (docs/conventions.md, "Arithmetic"). All zero: bits() = 0.
struct BitRange {
  int lowest = 0;
  int highest = 0;

  int bits() const { return highest - lowest; }
  bool is_zero() const { return highest == lowest; }

  void add(double x);           ///< @throws PreconditionError unless finite
  void add(const Point3& p);    ///< @throws PreconditionError unless finite
  void add(const BitRange& c);  ///< of both sets of numbers

  friend bool operator==(const BitRange&, const BitRange&) = default;
};

/// The bit range of all coordinates of `points`. @throws PreconditionError unless finite. Cost: O(n).
BitRange bit_range(std::span<const Point3> points);

}  // namespace hsr
