#pragma once

#include <optional>
#include <vector>

#include "geometry/rational_vector.h"
#include "hsr/view/view.h"

namespace hsr::internal {

/// What a near plane, sections and a far plane leave of a polygon or of a wire, in rationals. It knows nothing of the cells that parts of the
/// image fall into: what is behind the first plane is left, of the rest what is behind the second, and so on.
class WhatIsLeft {
 public:
  using Ring = std::vector<RationalVector>;

  explicit WhatIsLeft(const View& view);

  /// Whether nothing is taken away of what has these corners, or all of it. Neither may be said where it is so: of() tells.
  /// @param side (plane, corner) the sign of a plane at a corner
  template <typename Corners, typename Side>
  bool is_whole(const Corners& corners, const Side& side) const;
  template <typename Corners, typename Side>
  bool is_nothing(const Corners& corners, const Side& side) const;

  /// Convex parts of a convex polygon, or of a wire, which has two corners. They share no more than sides, and what lies in a plane stays.
  /// @throws InputError if a section of a perspective leaves something that is before the near plane
  std::vector<Ring> of(const Ring& ring) const;

 private:
  /// What is in front of all of these is taken away.
  struct Taker {
    Plane plane;
    bool takes_place_of_near;
  };
  /// All of these corners on that side of a plane, or, unless is_strict, in it.
  template <typename Corners, typename Side>
  static bool is_all(const Corners& corners, const Side& side, const Plane& plane, Sign sign, bool is_strict) {
    for (const auto& c : corners) {
      const Sign s = side(plane, c);
      if (s == -sign || (is_strict && s == Sign::zero)) return false;
    }
    return true;
  }
  void add_behind(const Taker& taker, const Ring& ring, std::vector<Ring>& left) const;

  std::vector<Taker> takers_;  // those that are seen edge-on first
  std::optional<Plane> far_;   // only beside takers
  std::optional<Plane> near_;  // of a perspective
};

template <typename Corners, typename Side>
bool WhatIsLeft::is_whole(const Corners& corners, const Side& side) const {
  if (far_ && !is_all(corners, side, *far_, Sign::negative, false)) return false;
  if (near_ && !is_all(corners, side, *near_, Sign::positive, false)) return false;
  for (const Taker& taker : takers_)
    if (is_all(corners, side, taker.plane, Sign::positive, false)) return true;
  return takers_.empty();
}

template <typename Corners, typename Side>
bool WhatIsLeft::is_nothing(const Corners& corners, const Side& side) const {
  if (far_ && is_all(corners, side, *far_, Sign::positive, true)) return true;
  for (const Taker& taker : takers_)
    if (!is_all(corners, side, taker.plane, Sign::negative, true)) return false;
  return !takers_.empty();
}

}  // namespace hsr::internal
