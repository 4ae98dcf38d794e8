#include "hsr/painter/verify/wire_relation.h"

#include <algorithm>
#include <utility>

namespace hsr::internal {

namespace {

Rational turn(const ImagePlace& a, const ImagePlace& b, const ImagePlace& p) {
  return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

ImagePlace between(const ImagePlace& a, const ImagePlace& b, const Rational& at) {
  return {a[0] + at * (b[0] - a[0]), a[1] + at * (b[1] - a[1])};
}

}  // namespace

WireRelation::WireRelation(const PaintedParts& all, const View& view, const PaintedPart& wire, const PaintedPart& part)
    : rows_(all.rows()), view_(view) {
  const PaintedPoints& points = all.points();
  for (std::size_t k = 0; k < 2; ++k) {
    ends_[k] = points.exact(all.corners_of(wire)[k]);
    places_[k] = rows_.place(ends_[k]);
  }
  // The corners go around the part so that inside is on the side of positive turns.
  const auto corners = all.corners_of(part);
  std::vector<ImagePlace> ring;
  for (const std::uint32_t c : corners) ring.push_back(rows_.place(points.exact(c)));
  Rational area;
  for (std::size_t k = 1; k + 1 < ring.size(); ++k) area = area + turn(ring[0], ring[k], ring[k + 1]);
  if (area.sign() == Sign::negative) std::reverse(ring.begin(), ring.end());
  for (std::size_t k = 0; k < ring.size() && low_ < high_; ++k) {
    const ImagePlace &from = ring[k], &to = ring[(k + 1) % ring.size()];
    const Rational a = turn(from, to, places_[0]), b = turn(from, to, places_[1]);
    if (a.sign() != Sign::positive && b.sign() != Sign::positive) high_ = low_;
    if (a.sign() == Sign::negative && b.sign() == Sign::positive) low_ = std::max(low_, a / (a - b));
    if (b.sign() == Sign::negative && a.sign() == Sign::positive) high_ = std::min(high_, a / (a - b));
  }
  if (!overlaps()) return;
  on_ = points.exact(part.plane[0]);
  normal_ = cross(minus(points.exact(part.plane[1]), on_), minus(points.exact(part.plane[2]), on_));
  const RationalVector toward = rows_.parallel ? rows_.eye : minus(rows_.eye, on_);
  if (dot(normal_, toward).sign() == Sign::negative)
    for (Rational& x : normal_) x = -x;
  const Rational a = dot(normal_, minus(ends_[0], on_)), b = dot(normal_, minus(ends_[1], on_));
  sides_ = {a.sign(), b.sign()};
  if (sides_[0] * sides_[1] != Sign::negative) return;
  // In space at a / (a - b); its place in the image by the depths of the ends.
  const Rational t = a / (a - b);
  const Rational wa = rows_.parallel ? Rational(1.0) : rows_.depth(ends_[0]),
                 wb = rows_.parallel ? Rational(1.0) : rows_.depth(ends_[1]);
  through_plane_ = t * wb / ((Rational(1.0) - t) * wa + t * wb);
}

std::pair<Rational, Rational> WireRelation::wire_stretch(bool in_front) const {
  const std::pair<Rational, Rational> nothing = {low_, low_}, all = {low_, high_};
  const Sign wanted = in_front ? Sign::positive : Sign::negative;
  if (!through_plane_) {
    const bool lies_on_it = sides_[0] == Sign::zero && sides_[1] == Sign::zero;
    const Sign side = sides_[0] != Sign::zero ? sides_[0] : sides_[1];
    return (lies_on_it && in_front) || side == wanted ? all : nothing;
  }
  if (sides_[0] == wanted) return {low_, std::min(high_, *through_plane_)};
  return {std::max(low_, *through_plane_), high_};
}

RationalVector WireRelation::point_of_wire(const Rational& at) const {
  const Rational wa = rows_.parallel ? Rational(1.0) : rows_.depth(ends_[0]),
                 wb = rows_.parallel ? Rational(1.0) : rows_.depth(ends_[1]);
  const Rational t = at * wa / (wb * (Rational(1.0) - at) + at * wa);
  RationalVector p;
  for (std::size_t k = 0; k < 3; ++k) p[k] = ends_[0][k] + t * (ends_[1][k] - ends_[0][k]);
  return p;
}

Witness WireRelation::witness(bool is_in_front) const {
  const auto [from, to] = wire_stretch(is_in_front);
  const Rational middle = (from + to) / Rational(2.0);
  Witness w;
  w.of_earlier = point_of_wire(middle);
  w.of_later = rows_.point(normal_, on_, between(places_[0], places_[1], middle));
  w.place = image(view_, w.of_earlier);
  return w;
}

}  // namespace hsr::internal
