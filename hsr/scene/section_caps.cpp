#include "hsr/scene/section_caps.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "geometry/constructed_point.h"
#include "geometry/disjoint_sets.h"
#include "geometry/near_value.h"
#include "geometry/view_plane.h"

namespace hsr::internal {

namespace {

/// How far v leans over u: with no simple ratio in it, ends of sides that run along an axis have no v in common.
constexpr double lean = 0.41421356237309515;

// Found before the template below, which calls it and that of doubles with bounds.
Rational quotient(const Rational& a, const Rational& b) { return a / b; }
using hsr::quotient;

/// Where the line of sight of p meets the plane, in numbers of any kind.
template <class N>
std::array<N, 3> seen_on(const std::array<N, 3>& p, const std::array<N, 3>& eye, bool eye_is_direction,
                         const std::array<N, 3>& at, const std::array<N, 3>& normal) {
  const auto along = [&](const std::array<N, 3>& d) -> N { return normal[0] * d[0] + normal[1] * d[1] + normal[2] * d[2]; };
  const auto from = [](const std::array<N, 3>& a, const std::array<N, 3>& b) {
    return std::array<N, 3>{a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  };
  const N beyond = along(from(p, at));
  const std::array<N, 3> toward = eye_is_direction ? eye : from(eye, p);
  const N s = quotient(-beyond, along(toward));
  return {p[0] + s * toward[0], p[1] + s * toward[1], p[2] + s * toward[2]};
}

std::array<ErrorBounded, 3> bounded(const Point3& p) { return {{{p.x, 0}, {p.y, 0}, {p.z, 0}}}; }

template <class N>
std::array<N, 2> flat(const std::array<N, 3>& p, int dropped, const N& leaning) {
  const N &i = p[static_cast<std::size_t>(dropped + 1) % 3], &j = p[static_cast<std::size_t>(dropped + 2) % 3];
  return {i, j + leaning * i};
}

ErrorBounded bounded(const Rational& x) {
  const double d = x.to_double();
  return {d, ErrorBounded::u * std::fabs(d) + 0x1p-1074};
}

/// Twice the area of a, b, p: positive, p is to the left of a -> b.
template <class N>
N turn(const std::array<N, 2>& a, const std::array<N, 2>& b, const std::array<N, 2>& p) {
  return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

Sign certain(const ErrorBounded& x) { return x.is_certain() ? sign_of(x.value) : Sign::zero; }

}  // namespace

/// The winding numbers about a place, object by object.
struct SectionCaps::Counter {
  struct Count {
    std::uint32_t object;
    int winding = 0, crossed = 0;
    bool is_inside() const { return (winding != 0) != (crossed % 2 != 0); }
  };
  std::vector<Count> counts;

  void add(const CapSide& side, int winding) {
    auto count = std::find_if(counts.begin(), counts.end(), [&](const Count& c) { return c.object == side.object; });
    if (count == counts.end()) count = counts.insert(count, Count{side.object});
    (side.counts_once ? count->crossed : count->winding) += winding;
  }
  bool is_inside_any() const {
    return std::any_of(counts.begin(), counts.end(), [](const Count& c) { return c.is_inside(); });
  }
};

SectionCaps::SectionCaps(const ProjectedMesh& projected, const View& view, const FaceLabels& labels)
    : mesh_(projected.mesh()), view_(view), plane_(view.near_plane()), dropped_(largest_axis(plane_.normal)) {
  find_sides(projected, labels);
  leave_out_open();
  place_corners();
  fill_slabs();
}

/// Of a triangle some corners stay and some go: the cap's border runs from where its ring comes back to where it leaves, with the
/// inside of the body, which is behind the triangle, on its left as seen from where it leaves to.
void SectionCaps::find_sides(const ProjectedMesh& projected, const FaceLabels& labels) {
  struct Found {
    CapCorner from, to;
    TriangleId triangle;
    std::uint32_t object;
  };
  std::vector<Found> found;
  for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
    const TriangleId t(i);
    const auto& c = mesh_.triangles[t];
    CapCorner from, to;
    bool is_cut = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexId p = c[k], q = c[(k + 1) % 3];
      const Sign at_p = projected.beyond_near(p), at_q = projected.beyond_near(q);
      if ((at_p == Sign::negative) == (at_q == Sign::negative)) continue;
      is_cut = true;
      const VertexId kept = at_p == Sign::negative ? q : p;
      const bool is_vertex = projected.beyond_near(kept) == Sign::zero;
      const CapCorner here = is_vertex ? CapCorner{kept, kept} : CapCorner{std::min(p, q), std::max(p, q)};
      (at_p == Sign::negative ? from : to) = here;
    }
    if (!is_cut || from == to) continue;
    const FaceId face = mesh_.face_of[t];
    found.push_back({from, to, t, labels.object.empty() ? 0 : labels.object[face.value]});
  }
  for (const Found& f : found) {
    corners_.push_back(f.from);
    corners_.push_back(f.to);
  }
  std::sort(corners_.begin(), corners_.end());
  corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
  const auto index = [&](const CapCorner& c) {
    return static_cast<std::uint32_t>(std::lower_bound(corners_.begin(), corners_.end(), c) - corners_.begin());
  };
  for (const Found& f : found) sides_.push_back({index(f.from), index(f.to), f.triangle, f.object});
  cancel_opposite();
}

/// A body that touches the plane from the viewer's side in an edge has two sides there, and no cap between them.
void SectionCaps::cancel_opposite() {
  const auto key = [](const CapSide& s) { return std::tuple(s.object, std::min(s.from, s.to), std::max(s.from, s.to)); };
  std::stable_sort(sides_.begin(), sides_.end(), [&](const CapSide& a, const CapSide& b) { return key(a) < key(b); });
  std::vector<CapSide> left;
  for (auto first = sides_.begin(); first != sides_.end();) {
    const auto end = std::find_if(first, sides_.end(), [&](const CapSide& s) { return key(s) != key(*first); });
    const auto forward = std::count_if(first, end, [](const CapSide&s) { return s.from < s.to; }), all = end - first;
    // Of those that run as most do, as many as are more.
    const bool is_forward = 2 * forward > all;
    std::ptrdiff_t more = std::abs(2 * forward - all);
    for (auto s = first; s != end; ++s)
      if ((s->from < s->to) == is_forward && more-- > 0) left.push_back(*s);
    first = end;
  }
  sides_ = std::move(left);
}

namespace {

/// Which sides bound something, and which outlines do not close.
struct ClosedOutlines {
  std::vector<CapSide> closed, open;
  std::size_t open_outlines = 0;
};

/// Outlines are connected sides of one object. Those from which every corner is left as often as it is reached have a direction; of
/// others loose ends are taken away, and what is left closes if every corner has an even number of sides.
class OutlineSorter {
 public:
  explicit OutlineSorter(const std::vector<CapSide>& sides) : sides_(sides) {
    for (const CapSide& s : sides) {
      keys_.push_back({s.object, s.from});
      keys_.push_back({s.object, s.to});
    }
    std::sort(keys_.begin(), keys_.end());
    keys_.erase(std::unique(keys_.begin(), keys_.end()), keys_.end());
    outlines_.reset(keys_.size());
    balance_.resize(keys_.size(), 0);
    degree_.resize(keys_.size(), 0);
    for (const CapSide& s : sides) {
      const std::array<std::uint32_t, 2> ends = {node(s, s.from), node(s, s.to)};
      ends_.push_back(ends);
      outlines_.join(ends[0], ends[1]);
      --balance_[ends[0]];
      ++balance_[ends[1]];
      for (const std::uint32_t n : ends) ++degree_[n];
    }
  }

  ClosedOutlines sorted() {
    std::vector<char> has_direction(keys_.size(), 1), is_open(keys_.size(), 0), bounds_nothing(keys_.size(), 0);
    for (std::uint32_t n = 0; n < keys_.size(); ++n)
      if (balance_[n] != 0) has_direction[outline(n)] = 0;
    const std::vector<char> is_loose = loose_sides();
    for (std::uint32_t k = 0; k < sides_.size(); ++k)
      if (is_loose[k] != 0) is_open[outline(ends_[k][0])] = 1;
    for (std::uint32_t n = 0; n < keys_.size(); ++n)
      if (has_direction[outline(n)] == 0 && degree_[n] % 2 != 0) bounds_nothing[outline(n)] = is_open[outline(n)] = 1;
    ClosedOutlines result;
    result.open_outlines = static_cast<std::size_t>(std::count(is_open.begin(), is_open.end(), char{1}));
    for (std::uint32_t k = 0; k < sides_.size(); ++k) {
      const std::uint32_t of = outline(ends_[k][0]);
      const bool is_closed = is_loose[k] == 0 && bounds_nothing[of] == 0;
      (is_closed ? result.closed : result.open).push_back(sides_[k]);
      if (is_closed) result.closed.back().counts_once = has_direction[of] == 0;
    }
    return result;
  }

 private:
  std::uint32_t node(const CapSide& s, std::uint32_t corner) const {
    return static_cast<std::uint32_t>(std::lower_bound(keys_.begin(), keys_.end(), std::array{s.object, corner}) -
                                      keys_.begin());
  }
  std::uint32_t outline(std::uint32_t n) { return outlines_.find(n); }

  /// Those that lead to an end where nothing goes on. Their ends are taken from the degrees.
  std::vector<char> loose_sides() {
    Ragged<std::uint32_t> sides_at;
    sides_at.assign(keys_.size(), [&](const auto& add) {
      for (std::uint32_t k = 0; k < ends_.size(); ++k)
        for (const std::uint32_t n : ends_[k]) add(n, k);
    });
    std::vector<char> is_loose(sides_.size(), 0);
    std::vector<std::uint32_t> ends;
    for (std::uint32_t n = 0; n < keys_.size(); ++n)
      if (degree_[n] == 1) ends.push_back(n);
    while (!ends.empty()) {
      const std::uint32_t n = ends.back();
      ends.pop_back();
      for (const std::uint32_t k : sides_at[n]) {
        if (std::exchange(is_loose[k], char{1}) != 0) continue;
        for (const std::uint32_t end : ends_[k])
          if (--degree_[end] == 1) ends.push_back(end);
      }
    }
    return is_loose;
  }

  const std::vector<CapSide>& sides_;
  std::vector<std::array<std::uint32_t, 2>> keys_;  // an object and a corner of it
  std::vector<std::array<std::uint32_t, 2>> ends_;  // of each side, among the keys
  DisjointSets outlines_;
  std::vector<int> balance_, degree_;
};

}  // namespace

/// What does not close within its object may be a patch of a surface that several objects make: such outlines are taken for one of the
/// lowest of these.
void SectionCaps::leave_out_open() {
  ClosedOutlines own = OutlineSorter(sides_).sorted();
  sides_ = std::move(own.closed);
  DisjointSets connected(corners_.size());
  for (const CapSide& s : own.open) connected.join(s.from, s.to);
  std::vector<std::uint32_t> lowest(corners_.size(), 0xffffffffU);
  for (const CapSide& s : own.open) {
    std::uint32_t& object = lowest[connected.find(s.from)];
    object = std::min(object, s.object);
  }
  for (CapSide& s : own.open) s.object = lowest[connected.find(s.from)];
  const ClosedOutlines together = OutlineSorter(own.open).sorted();
  sides_.insert(sides_.end(), together.closed.begin(), together.closed.end());
  open_outlines_ = together.open_outlines;
}

RationalVector SectionCaps::point(std::uint32_t corner) const {
  const auto& [a, b] = corners_[corner];
  if (a == b) return rational(mesh_.points[a]);
  return ConstructedPoint::on_edge(mesh_.points[a], mesh_.points[b], plane_).exact();
}

void SectionCaps::place_corners() {
  exact_places_.resize(corners_.size());
  places_.resize(corners_.size());
  for (std::uint32_t k = 0; k < corners_.size(); ++k) {
    exact_places_[k] = flat<Rational>(point(k), dropped_, lean);
    places_[k] = {bounded(exact_places_[k][0]), bounded(exact_places_[k][1])};
  }
}

std::size_t SectionCaps::slab_of(double v) const {
  const double s = (v - bottom_) * slabs_per_unit_;
  return s > 0 ? static_cast<std::size_t>(std::min(s, static_cast<double>(slab_count_ - 1))) : 0;
}

/// A place that is known to the last bit is looked for in one slab, so each side is in all that it may touch.
void SectionCaps::fill_slabs() {
  left_ = bottom_ = HUGE_VAL;
  right_ = top_ = -HUGE_VAL;
  for (const CapSide& s : sides_)
    for (const std::uint32_t c : {s.from, s.to}) {
      const auto& [u, v] = places_[c];
      left_ = std::min(left_, u.value - u.error);
      right_ = std::max(right_, u.value + u.error);
      bottom_ = std::min(bottom_, v.value - v.error);
      top_ = std::max(top_, v.value + v.error);
    }
  slab_count_ = std::clamp<std::size_t>(sides_.size(), 1, 4096);
  const double height = top_ - bottom_;
  margin_ = std::max(height, 0x1p-20 * std::max(std::fabs(top_), std::fabs(bottom_))) * 0x1p-30;
  slabs_per_unit_ = height > 0 ? static_cast<double>(slab_count_) / height : 0;
  if (!(slabs_per_unit_ < HUGE_VAL)) slabs_per_unit_ = 0;
  slabs_.assign(slab_count_, [&](const auto& add) {
    for (std::uint32_t k = 0; k < sides_.size(); ++k) {
      const ErrorBounded &a = places_[sides_[k].from][1], &b = places_[sides_[k].to][1];
      const std::size_t last = slab_of(std::max(a.value, b.value) + margin_);
      for (std::size_t s = slab_of(std::min(a.value, b.value) - margin_); s <= last; ++s) add(s, k);
    }
  });
}

SectionCaps::Place SectionCaps::seen_at(const std::array<ErrorBounded, 3>& p) const {
  return flat<ErrorBounded>(
      seen_on(p, bounded(plane_.eye), plane_.eye_is_direction, bounded(plane_.target), bounded(plane_.normal)), dropped_,
      {lean, 0});
}

SectionCaps::ExactPlace SectionCaps::seen_at(const RationalVector& p) const {
  return flat<Rational>(
      seen_on(p, rational(plane_.eye), plane_.eye_is_direction, rational(plane_.target), rational(plane_.normal)), dropped_,
      lean);
}

/// How often the outlines wind around the place: by the sides that a ray along u crosses.
std::optional<bool> SectionCaps::covers(const Place& at) const {
  if (sides_.empty()) return false;
  const auto& [u, v] = at;
  if (!(u.error < HUGE_VAL && v.error < HUGE_VAL)) return std::nullopt;
  if (u.value - u.error > right_ || u.value + u.error < left_ || v.value - v.error > top_ || v.value + v.error < bottom_)
    return false;
  if (!(2 * v.error < margin_)) return std::nullopt;
  Counter counter;
  for (const std::uint32_t k : slabs_[slab_of(v.value)]) {
    const Place &a = places_[sides_[k].from], &b = places_[sides_[k].to];
    if (certain(a[0] - u) == Sign::negative && certain(b[0] - u) == Sign::negative) continue;
    const Sign above_a = certain(a[1] - v), above_b = certain(b[1] - v);
    if (above_a == Sign::zero || above_b == Sign::zero) return std::nullopt;
    if (above_a == above_b) continue;
    const Sign left = certain(turn(a, b, at));
    if (left == Sign::zero) return std::nullopt;
    if (above_a == Sign::negative && left == Sign::positive) counter.add(sides_[k], 1);
    if (above_a == Sign::positive && left == Sign::negative) counter.add(sides_[k], -1);
  }
  return counter.is_inside_any();
}

bool SectionCaps::covers(const ExactPlace& at) const {
  if (sides_.empty()) return false;
  Counter counter;
  for (const std::uint32_t k : slabs_[slab_of(at[1].to_double())]) {
    const ExactPlace &a = exact_places_[sides_[k].from], &b = exact_places_[sides_[k].to];
    const Sign at_a = (a[1] - at[1]).sign(), at_b = (b[1] - at[1]).sign();
    if (at_a * at_b == Sign::positive) continue;
    const Sign left = turn(a, b, at).sign();
    if (left == Sign::zero && ((a[0] - at[0]).sign() * (b[0] - at[0]).sign() != Sign::positive)) {
      // On the side: which may have nothing on either hand, where others lie along it.
      const ExactPlace across = {a[1] - b[1], b[0] - a[0]};
      std::optional<std::uint32_t> least;
      return !objects_beside(at, across, least).empty() || !objects_beside(at, {-across[0], -across[1]}, least).empty();
    }
    const bool is_below_a = at_a == Sign::positive, is_below_b = at_b == Sign::positive;
    if (is_below_a == is_below_b) continue;
    if (is_below_b && left == Sign::positive) counter.add(sides_[k], 1);
    if (is_below_a && left == Sign::negative) counter.add(sides_[k], -1);
  }
  return counter.is_inside_any();
}

/// As covers(), about a place that is moved toward: where that decides, the signs are those of the way.
std::vector<std::uint32_t> SectionCaps::objects_beside(const ExactPlace& at, const ExactPlace& toward,
                                                       std::optional<std::uint32_t>& least_side, const ExactPlace& then) const {
  Counter counter;
  const auto first_of = [](Sign a, Sign b) { return a != Sign::zero ? a : b; };
  const Sign up = first_of(toward[1].sign(), then[1].sign());
  for (const std::uint32_t k : slabs_[slab_of(at[1].to_double())]) {
    const ExactPlace &a = exact_places_[sides_[k].from], &b = exact_places_[sides_[k].to];
    Sign at_a = (a[1] - at[1]).sign(), at_b = (b[1] - at[1]).sign();
    if (at_a * at_b == Sign::positive) continue;
    Sign left = turn(a, b, at).sign();
    if (left == Sign::zero) {
      if ((a[0] - at[0]).sign() * (b[0] - at[0]).sign() != Sign::positive) least_side = std::min(k, least_side.value_or(k));
      const auto along = [&](const ExactPlace& d) { return ((b[0] - a[0]) * d[1] - (b[1] - a[1]) * d[0]).sign(); };
      left = first_of(along(toward), along(then));
    }
    if (at_a == Sign::zero) at_a = -up;
    if (at_b == Sign::zero) at_b = -up;
    const bool is_below_a = at_a == Sign::positive, is_below_b = at_b == Sign::positive;
    if (is_below_a == is_below_b) continue;
    if (is_below_b && left == Sign::positive) counter.add(sides_[k], 1);
    if (is_below_a && left == Sign::negative) counter.add(sides_[k], -1);
  }
  std::vector<std::uint32_t> inside;
  for (const Counter::Count& c : counter.counts)
    if (c.is_inside()) inside.push_back(c.object);
  std::sort(inside.begin(), inside.end());
  return inside;
}

}  // namespace hsr::internal
