#include "hsr/painter/verify/what_is_left.h"

#include <algorithm>

#include "geometry/error.h"
#include "geometry/near_value.h"

namespace hsr::internal {

namespace {

using Ring = WhatIsLeft::Ring;

/// What of a convex ring is on one side of a plane, or lies in it; empty if it only touches that side. @param kept the side
Ring beside(const Ring& ring, const Plane& plane, Sign kept) {
  std::vector<Rational> values;
  bool is_beside = false, is_in = true;
  for (const RationalVector& p : ring) {
    values.push_back(near_value(plane, p));
    const Sign s = values.back().sign();
    is_beside = is_beside || s == kept;
    is_in = is_in && s == Sign::zero;
  }
  if (is_in) return ring;
  if (!is_beside) return {};
  Ring out;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const std::size_t next = (k + 1) % ring.size();
    const RationalVector &p = ring[k], &q = ring[next];
    const Rational &s = values[k], &t = values[next];
    if (s.sign() != -kept) out.push_back(p);
    if (s.sign() * t.sign() != Sign::negative) continue;
    const Rational u = s / (s - t);
    const RationalVector d = minus(q, p);
    out.push_back({p[0] + u * d[0], p[1] + u * d[1], p[2] + u * d[2]});
  }
  out.erase(std::unique(out.begin(), out.end()), out.end());
  if (out.size() > 1 && out.front() == out.back()) out.pop_back();
  return out;
}

}  // namespace

WhatIsLeft::WhatIsLeft(const View& view) {
  if (view.far) far_ = view.cutting_plane(View::far_number);
  if (view.is_perspective()) near_ = Plane::near(view.viewpoint.at, view.target, view.near);
  if (view.section) takers_.push_back({view.near_plane(), true});
  for (const bool edge_on : {true, false})
    for (std::size_t k = 0; k < view.planes.size(); ++k)
      if ((viewer_side(view, view.planes[k]) == Sign::zero) == edge_on)
        takers_.push_back({view.cutting_plane(static_cast<std::uint8_t>(k + 1)), !edge_on});
  if (takers_.empty() && near_) takers_.push_back({*near_, false});
}

void WhatIsLeft::add_behind(const Taker& taker, const Ring& ring, std::vector<Ring>& left) const {
  Ring part = beside(ring, taker.plane, Sign::positive);
  if (far_) part = beside(part, *far_, Sign::negative);
  if (near_ && taker.takes_place_of_near)
    for (const RationalVector& p : part)
      if (near_value(*near_, p).sign() == Sign::negative)
        throw InputError(
            "section: found a part of the model that it leaves before the near plane, expected none: see --eye and --near");
  if (near_ && !taker.takes_place_of_near) part = beside(part, *near_, Sign::positive);
  if (!part.empty()) left.push_back(std::move(part));
}

std::vector<Ring> WhatIsLeft::of(const Ring& ring) const {
  std::vector<Ring> left;
  Ring rest = ring;
  for (const Taker& taker : takers_) {
    add_behind(taker, rest, left);
    // What lies in the plane is behind it.
    if (std::none_of(rest.begin(), rest.end(),
                     [&](const RationalVector& p) { return near_value(taker.plane, p).sign() == Sign::negative; }))
      return left;
    rest = beside(rest, taker.plane, Sign::negative);
  }
  if (takers_.empty()) left.push_back(ring);
  return left;
}

}  // namespace hsr::internal
