#include "hsr/surfaces/region_clipper.h"

#include <algorithm>
#include <utility>

namespace hsr::internal {

namespace {

/// Where the plane cuts the way from p to q, at which its values are a and b.
RationalVector between(const RationalVector& p, const RationalVector& q, const Rational& a, const Rational& b) {
  const Rational t = a / (a - b);
  RationalVector at;
  for (std::size_t k = 0; k < 3; ++k) at[k] = p[k] + t * (q[k] - p[k]);
  return at;
}

}  // namespace

/// A line just beside the border comes into the region where a side leads to the border, and leaves it where one leads away.
void keep(const CuttingPlane& plane, std::uint32_t name, const RationalVector& normal, std::vector<RegionSide>& sides) {
  struct End {
    Rational along;
    RationalVector at;
    int change;
  };
  const RationalVector direction = cross(plane.gradient, normal);
  std::vector<RegionSide> left;
  std::vector<End> ends;
  for (RegionSide side : sides) {
    const Rational a = plane.at(side.from), b = plane.at(side.to);
    if (a.sign() != Sign::positive && b.sign() != Sign::positive) continue;
    const RationalVector from = side.from, to = side.to;
    if (a.sign() == Sign::negative) side.from = between(from, to, a, b);
    if (b.sign() == Sign::negative) side.to = between(from, to, a, b);
    if (a.sign() != Sign::positive) ends.push_back({dot(direction, side.from), side.from, -1});
    if (b.sign() != Sign::positive) ends.push_back({dot(direction, side.to), side.to, 1});
    left.push_back(std::move(side));
  }
  std::stable_sort(ends.begin(), ends.end(), [](const End& x, const End& y) { return x.along < y.along; });
  int within = 0;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    within += ends[k].change;
    if (within > 0 && ends[k].along != ends[k + 1].along) left.push_back({ends[k].at, ends[k + 1].at, name});
  }
  sides = std::move(left);
}

bool keep(const CuttingPlane& plane, RationalVector& from, RationalVector& to) {
  const Rational a = plane.at(from), b = plane.at(to);
  if (a.sign() == Sign::zero && b.sign() == Sign::zero) return true;
  if (a.sign() != Sign::positive && b.sign() != Sign::positive) return false;
  const RationalVector p = from, q = to;
  if (a.sign() == Sign::negative) from = between(p, q, a, b);
  if (b.sign() == Sign::negative) to = between(p, q, a, b);
  return true;
}

}  // namespace hsr::internal
