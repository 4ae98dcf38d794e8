#pragma once

#include <array>

#include "geometry/rational_vector.h"
#include "hsr/view/view.h"

namespace hsr::internal {

/// A place in the image of ImageRows.
using ImagePlace = std::array<Rational, 2>;

/// An image as two linear functions over a third (in parallel views: over 1), in rationals. It is that of the view's frame up
/// to a projective map that keeps every turn, and needs no frame that is exact.
struct ImageRows {
  bool parallel = true;
  RationalVector eye;  ///< or the direction toward the viewer
  std::array<RationalVector, 2> across;
  RationalVector away;

  explicit ImageRows(const View& view);

  RationalVector from_eye(const RationalVector& p) const { return parallel ? p : minus(p, eye); }
  Rational depth(const RationalVector& p) const { return dot(from_eye(p), away); }
  ImagePlace place(const RationalVector& p) const;
  /// The point that is seen at a place, on the plane through `on` square to `normal`. @pre the plane is not seen edge-on
  RationalVector point(const RationalVector& normal, const RationalVector& on, const ImagePlace& at) const;
};

}  // namespace hsr::internal
