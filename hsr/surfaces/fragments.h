#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <stop_token>
#include <vector>

#include "geometry/mesh.h"
#include "geometry/number.h"
#include "geometry/predicates.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/symbols/map_point.h"
#include "hsr/view/view.h"

namespace hsr {

/// A connected part of a face that is visible, as seen: its rings in the image.
struct Fragment {
  FacetId facet;                               ///< the planar piece of the face that it lies in
  std::uint32_t first_ring = 0, end_ring = 0;  ///< the outer ring first, counter-clockwise as seen; holes clockwise
};

struct VisibleFragments {
  std::vector<Fragment> fragments;                ///< ascending by facet, hence by face
  std::vector<std::uint32_t> first_corner = {0};  ///< ring r has corners[first_corner[r]] ... ; one more than rings
  std::vector<MapCorner> corners;
  DecisionCounts decisions;

  std::size_t rings() const { return first_corner.size() - 1; }
  std::span<const MapCorner> ring(std::uint32_t r) const {
    return {corners.data() + first_corner[r], corners.data() + first_corner[r + 1]};
  }
};

struct FragmentOptions {
  /// The visible lines of all edges of all classes, with LineOptions::diagonals, of this very view, where the caller has them:
  /// they need not be found again.
  /// For visible_fragments() only; changes no ring.
  const VisibleLines* lines = nullptr;
  std::function<void(double done)> progress = {};  ///< called now and then with the share done, 0 ... 1; may throw to cancel
  std::stop_token stop = {};                       ///< once it is asked to stop, the work ends in a CancelledError
};

/// The area of each fragment's image, in coordinates of the frame (View::frame: right by up, which are unit lengths but for
/// rounding), exactly. Perspective: in the plane of the frame.
/// Cost: some exact rationals for each corner, parallel.
std::vector<Rational> visible_areas(const Mesh& mesh, const View& view, const VisibleFragments& fragments);

}  // namespace hsr
