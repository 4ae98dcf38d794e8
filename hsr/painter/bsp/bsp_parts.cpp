#include "hsr/painter/bsp/bsp_parts.h"

#include <algorithm>
#include <cmath>

#include "geometry/constructed_point.h"
#include "hsr/symbols/cut_plane.h"

namespace hsr::internal {

std::uint32_t BspParts::add(FacetId facet, std::span<const BspBounds::Corner> ring) {
  Part part{facet, static_cast<std::uint32_t>(corners_.size()), 0};
  for (const BspBounds::Corner& c : ring) corners_.push_back({{projected_.point(VertexId(c.a)), 0}, c});
  check_countable(corners_.size(), "corners of a BSP");
  part.end = static_cast<std::uint32_t>(corners_.size());
  parts_.push_back(part);
  return static_cast<std::uint32_t>(parts_.size() - 1);
}

std::uint32_t BspParts::add(const BspParts& from, const Part& part) {
  const auto first = static_cast<std::uint32_t>(corners_.size());
  const auto corners = from.corners(part);
  corners_.insert(corners_.end(), corners.begin(), corners.end());
  parts_.push_back(part);
  parts_.back().first = first;
  parts_.back().end = static_cast<std::uint32_t>(corners_.size());
  return static_cast<std::uint32_t>(parts_.size() - 1);
}

/// Rounding to floats never falls as a number rises, and so keeps what is apart in order. The margins are rounded themselves,
/// by less than 2^-52 of the coordinate and the error.
void BspParts::find_box(std::uint32_t index) {
  Part& part = parts_[index];
  part.low.fill(HUGE_VALF);
  part.high.fill(-HUGE_VALF);
  for (const Corner& c : corners(part))
    for (int k = 0; k < 3; ++k) {
      const double x = c.at.p[k], margin = c.at.error == 0 ? 0 : 1.01 * c.at.error + 0x1p-50 * std::fabs(x);
      float &low = part.low[static_cast<std::size_t>(k)], &high = part.high[static_cast<std::size_t>(k)];
      low = std::min(low, static_cast<float>(x - margin));
      high = std::max(high, static_cast<float>(x + margin));
    }
}

BspParts::Divider BspParts::divider(FacetId facet) const {
  Divider d;
  d.cut = {Cut::Kind::face, 0, facet.value, 0};
  d.id = BspBounds::facet(facet);
  d.filter = projected_.filter(projected_.face_plane(facet));
  d.vertices = projected_.mesh().triangles[first_triangle(facet)];
  return d;
}

BspParts::Divider BspParts::divider(VertexId v, int axis) const {
  Divider d;
  d.cut = {Cut::Kind::across, static_cast<std::uint8_t>(axis), v.value, 0};
  d.at = projected_.point(v)[axis];
  return d;
}

Plane BspParts::plane(BspBounds::Id id) const { return cut_plane(projected_, cut_of(id, sides_, acrosses_)); }

/// The bound of the filter holds for a place that is not exact, as long as its size and error are bounded (crossing()).
ErrorBounded BspParts::value(const Divider& d, const Corner& corner) const {
  if (d.is_across()) return ErrorBounded{corner.at.p[d.cut.axis], corner.at.error} - ErrorBounded{d.at, 0};
  return d.filter(corner.at);
}

Sign BspParts::side_beyond_filter(const Divider& d, const Corner& corner, FacetId facet) {
  const BspBounds::Corner& c = corner.bounds;
  const auto is_of_divider = [&](VertexId v) { return is_one_of(v, d.vertices); };
  if (c.is_vertex()) {
    if (d.is_across()) return sign_of(corner.at.p[d.cut.axis] - d.at);
    return is_of_divider(VertexId(c.a)) ? Sign::zero : exact_.side_beyond_filter(cut_plane(projected_, d.cut), corner.at.p);
  }
  if (c.a == d.id || c.b == d.id) return Sign::zero;
  // On an edge of the facet that is also one of the divider's.
  for (const BspBounds::Id id : {c.a, c.b})
    if (!d.is_across() && BspBounds::is_side(id)) {
      const BspBounds::Side& side = sides_[BspBounds::place(id)];
      if (is_of_divider(side.u) && is_of_divider(side.v)) return Sign::zero;
    }
  const Plane divider = cut_plane(projected_, d.cut);
  if (exact_.arithmetic() != Arithmetic::staged)
    return exact_.side(divider, projected_.face_plane(facet), plane(c.a), plane(c.b));
  const Sign s = exact_meet(facet, c).side(divider);
  ++exact_.counts().fixed;
  if (s == Sign::zero) ++exact_.counts().zero;
  return s;
}

const ExactMeet& BspParts::exact_meet(FacetId facet, const BspBounds::Corner& corner) {
  constexpr std::size_t places = 1024;
  if (meets_.empty()) {
    meets_.resize(places);
    bit_range_.emplace();
    for (const Edge& e : projected_.mesh().edges)
      for (const VertexId v : {e.a, e.b}) bit_range_->add(projected_.point(v));
  }
  const std::uint64_t name = (facet.value * 0x9e3779b97f4a7c15ULL ^ corner.a) * 0x9e3779b97f4a7c15ULL ^ corner.b;
  KnownMeet& known = meets_[name * 0x9e3779b97f4a7c15ULL >> 54U];
  if (!known.meet || known.facet != facet || known.a != corner.a || known.b != corner.b)
    known = {facet, corner.a, corner.b, ExactMeet(*bit_range_, projected_.face_plane(facet), plane(corner.a), plane(corner.b))};
  return *known.meet;
}

BspParts::Sides BspParts::sides(const Divider& d, const Part& part) {
  if (d.id == BspBounds::facet(part.facet)) return {};
  Sides found;
  for (const Corner& corner : corners(part)) {
    const ErrorBounded x = value(d, corner);
    const Sign s = x.is_certain() ? sign_of(x.value) : side_beyond_filter(d, corner, part.facet);
    found.before = found.before || s == Sign::positive;
    found.behind = found.behind || s == Sign::negative;
    if (found.before && found.behind) break;
  }
  return found;
}

/// Where the side that leaves corner k crosses the plane, which is X = A + t (B - A), t = F(A) / (F(A) - F(B)).
///
/// Let a and b be the values of F, of opposite signs, E the sum of their errors, s = a - b, and |s| > 4 E. The exact difference
/// S is off by E + u |s|, so |S| > 0.74 |s|, and t by at most (E + E + u |s|) / |S| + u < 2.8 E / |s| + 3 u. With A and B known
/// within e, and 0 <= t <= 1, X is off by e, by the error of t times |B - A|, and by 3.2 u |B - A| + u |A| for roundings.
/// Where that is too much, the three planes that meet in X tell its place.
BspParts::Corner BspParts::crossing(const Divider& d, const Part& part, std::size_t k) {
  const std::size_t n = part.end - part.first, next = (k + 1) % n;
  const Corner &from = corners_[part.first + k], &to = corners_[part.first + next];
  Corner out{{{}, HUGE_VAL}, {from.bounds.side, d.id, from.bounds.side}};
  const ErrorBounded &a = values_[k], &b = values_[next];
  const double fall = a.value - b.value, loss = a.error + b.error;
  if (a.is_certain() && b.is_certain() && std::fabs(fall) > 4 * loss) {
    const double t = a.value / fall, t_error = 3 * loss / std::fabs(fall) + 4 * ErrorBounded::u;
    const Point3 along = minus(to.at.p, from.at.p);
    out.at.p = sum(from.at.p, t, along);
    const double length = norm_one(along), size = norm_one(from.at.p);
    out.at.error =
        1.01 * (std::max(from.at.error, to.at.error) + length * (t_error + 4 * ErrorBounded::u) + 2 * ErrorBounded::u * size);
  }
  if (!(out.at.error < 0x1p-40)) {
    out.at = bounded_point(near_meet(projected_.face_plane(part.facet), plane(out.bounds.a), cut_plane(projected_, d.cut)));
  }
  // Beyond this a coordinate would break the bound of a filter.
  const bool is_usable = exact_.filter_is_proven() && norm_one(out.at.p) < 0x1p100 && out.at.error < 0x1p100;
  out.at.error = is_usable ? std::max(out.at.error, 0x1p-1000) : HUGE_VAL;
  return out;
}

std::array<std::uint32_t, 2> BspParts::split(std::uint32_t index, const Divider& d) {
  const Part part = parts_[index];
  const std::size_t n = part.end - part.first;
  signs_.clear();
  values_.clear();
  for (std::uint32_t k = part.first; k < part.end; ++k) {
    const ErrorBounded x = value(d, corners_[k]);
    values_.push_back(x);
    signs_.push_back(x.is_certain() ? sign_of(x.value) : side_beyond_filter(d, corners_[k], part.facet));
  }
  // A convex part has two sides that cross the plane, or fewer; both halves have the corners there.
  crossings_.clear();
  for (std::size_t k = 0; k < n; ++k)
    if (signs_[k] * signs_[(k + 1) % n] == Sign::negative) crossings_.push_back(crossing(d, part, k));
  std::array<std::uint32_t, 2> halves;
  for (const Sign wanted : {Sign::negative, Sign::positive}) {
    Part half{part.facet, static_cast<std::uint32_t>(corners_.size()), 0};
    auto crossing = crossings_.begin();
    for (std::size_t k = 0; k < n; ++k) {
      const Corner corner = corners_[part.first + k];
      const Sign here = signs_[k] * wanted, next = signs_[(k + 1) % n] * wanted;
      const auto along_cut = [&](Corner c) {  // here the plane takes over
        c.bounds.side = d.id;
        return c;
      };
      if (here == Sign::positive) {
        corners_.push_back(corner);
        if (next == Sign::negative) corners_.push_back(along_cut(*crossing++));
      } else if (here == Sign::zero) {
        corners_.push_back(next == Sign::positive ? corner : along_cut(corner));
      } else if (next == Sign::positive) {
        corners_.push_back(*crossing++);
      }
    }
    half.end = static_cast<std::uint32_t>(corners_.size());
    halves[wanted == Sign::positive ? 1 : 0] = static_cast<std::uint32_t>(parts_.size());
    parts_.push_back(half);
  }
  check_countable(corners_.size(), "corners of a BSP");
  return halves;
}

}  // namespace hsr::internal
