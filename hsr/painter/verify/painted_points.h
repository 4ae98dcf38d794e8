#pragma once

#include <cmath>
#include <cstdint>
#include <map>
#include <span>
#include <unordered_map>
#include <vector>

#include "geometry/bounded_point.h"
#include "geometry/error_bounded.h"
#include "geometry/homogeneous_point.h"
#include "geometry/predicates.h"
#include "geometry/ragged.h"
#include "geometry/rational_vector.h"
#include "hsr/painter/verify/image_rows.h"
#include "hsr/painter/verify/verify.h"

namespace hsr::internal {

/// The distinct corners of painted polygons, by numbers: the same point, the same number. Doubles stay doubles.
class PaintedPoints {
 public:
  explicit PaintedPoints(const std::vector<PaintedPolygon>& polygons);

  /// The numbers of the corners of a polygon as given.
  std::span<const std::uint32_t> corners_of(std::uint32_t polygon) const { return corners_[polygon]; }
  /// The number of a point that may be new: where a polygon is cut.
  std::uint32_t number_of(const RationalVector& p);

  bool is_double(std::uint32_t number) const { return exact_[number] == not_exact; }
  /// @pre is_double
  const Point3& point(std::uint32_t number) const { return points_[number]; }
  RationalVector exact(std::uint32_t number) const {
    return is_double(number) ? rational(points_[number]) : rationals_[exact_[number]];
  }
  /// In doubles with proven bounds.
  const std::array<ErrorBounded, 3>& near(std::uint32_t number) const { return near_[number]; }
  HomogeneousPoint3 whole(std::uint32_t number) const;
  /// Once all points are there: where they are seen. Cost: O(n), parallel.
  void place(const ImageRows& rows);
  bool are_placed() const { return places_.size() == points_.size(); }
  /// Where it is seen, in coordinates of ImageRows; an infinite error: not known, or not before the eye. @pre are_placed
  const BoundedPoint2& place_of(std::uint32_t number) const { return places_[number]; }
  /// Of all that are doubles.
  const BitRange& bit_range() const { return bit_range_; }

 private:
  static constexpr std::uint32_t not_exact = 0xffffffffU;
  struct Hash {
    std::size_t operator()(const Point3& p) const;
  };
  std::uint32_t add_double(const Point3& p);
  std::uint32_t add_rational(const RationalVector& p);

  Ragged<std::uint32_t> corners_;  // by polygon
  std::vector<Point3> points_;
  std::vector<std::uint32_t> exact_;  // by number: the place in rationals_
  std::vector<RationalVector> rationals_;
  std::vector<HomogeneousPoint3> wholes_;          // of rationals_
  std::vector<std::array<ErrorBounded, 3>> near_;  // by number
  std::vector<BoundedPoint2> places_;              // by number
  std::unordered_map<Point3, std::uint32_t, Hash> doubles_seen_;
  std::map<RationalVector, std::uint32_t> rationals_seen_;
  BitRange bit_range_;
};

/// On which side painted points lie: by the predicates in stages where all are doubles; else in doubles with bounds, and by a
/// determinant of whole numbers where these do not tell. Signs are those of geometry/plane.h. One object per thread.
class PaintedSides {
 public:
  PaintedSides(const PaintedPoints& points, const ImageRows& rows, const View& view);

  /// Of the view plane of a and b: where the image of p lies beside the line of theirs; positive, to the left of a -> b.
  Sign turn(std::uint32_t a, std::uint32_t b, std::uint32_t p);
  /// Of the plane of a, b and c.
  Sign side(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t p);
  /// Of a near plane, a section or a far plane of the view.
  Sign side(const Plane& plane, std::uint32_t p);

 private:
  Sign certain_turn_in_image(std::uint32_t a, std::uint32_t b, std::uint32_t p) const;
  Sign turn_in_space(std::uint32_t a, std::uint32_t b, std::uint32_t p);

  const PaintedPoints& points_;
  const ImageRows& rows_;
  const View& view_;
  HomogeneousPoint3 whole_eye_;
  Predicates predicates_;
};

}  // namespace hsr::internal
