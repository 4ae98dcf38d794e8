#include "hsr/scene/section_caps.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "geometry/bounded_rational.h"
#include "geometry/constructed_point.h"
#include "geometry/disjoint_sets.h"
#include "geometry/near_value.h"
#include "geometry/parallel.h"
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
  std::vector<std::uint32_t> inside() const {
    std::vector<std::uint32_t> objects;
    for (const Count& c : counts)
      if (c.is_inside()) objects.push_back(c.object);
    std::sort(objects.begin(), objects.end());
    return objects;
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
  make_tree();
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
  open_sides_ = together.open;
  open_outlines_ = together.open_outlines;
}

void SectionCaps::place_corners() {
  points_.resize(corners_.size());
  exact_places_.resize(corners_.size());
  places_.resize(corners_.size());
  parallel_for_each(corners_.size(), [&](std::size_t k) {
    const auto& [a, b] = corners_[k];
    points_[k] =
        a == b ? rational(mesh_.points[a]) : ConstructedPoint::on_edge(mesh_.points[a], mesh_.points[b], plane_).exact();
    exact_places_[k] = flat<Rational>(points_[k], dropped_, lean);
    places_[k] = {bounded(exact_places_[k][0]), bounded(exact_places_[k][1])};
  });
}

void SectionCaps::make_tree() {
  for (const CapSide& s : sides_) boxes_.push_back(box_of(places_[s.from], places_[s.to]));
  tree_ = BoxTree(boxes_);
  // Sides of one object at one corner are of one outline.
  std::vector<std::array<std::uint32_t, 3>> at_corners;  // object, corner, side
  for (std::uint32_t k = 0; k < sides_.size(); ++k)
    for (const std::uint32_t corner : {sides_[k].from, sides_[k].to}) at_corners.push_back({sides_[k].object, corner, k});
  std::sort(at_corners.begin(), at_corners.end());
  DisjointSets connected(sides_.size());
  for (std::size_t i = 1; i < at_corners.size(); ++i)
    if (at_corners[i][0] == at_corners[i - 1][0] && at_corners[i][1] == at_corners[i - 1][1])
      connected.join(at_corners[i][2], at_corners[i - 1][2]);
  std::vector<std::array<std::uint32_t, 2>> by_outline;
  for (std::uint32_t k = 0; k < sides_.size(); ++k) by_outline.push_back({connected.find(k), k});
  std::sort(by_outline.begin(), by_outline.end());
  std::vector<ImageBox> around;
  std::vector<std::uint32_t> own;
  for (std::size_t i = 0; i < by_outline.size(); ++i) {
    if (own.empty()) around.push_back(ImageBox::nothing());
    own.push_back(by_outline[i][1]);
    around.back().add(boxes_[own.back()]);
    if (i + 1 < by_outline.size() && by_outline[i + 1][0] == by_outline[i][0]) continue;
    outlines_.push_row(own);
    own.clear();
  }
  outline_tree_ = BoxTree(around);
}

std::optional<std::size_t> SectionCaps::outlines_around(const Place& at, std::span<std::uint32_t> outlines) const {
  std::size_t count = 0, sides = 0;
  bool are_few = true;
  outline_tree_.visit_boxes<BoxTree::Depth::any>(box_of(at, at), [&](std::uint32_t outline, std::uint32_t /*at*/) {
    sides += outlines_[outline].size();
    are_few = count < outlines.size() && sides <= most_sides;
    if (are_few) outlines[count++] = outline;
    return are_few;
  });
  return are_few ? std::optional(count) : std::nullopt;
}

ImageBox SectionCaps::box_of(const Place& a, const Place& b) {
  ImageBox box = ImageBox::nothing();
  for (const Place& p : {a, b}) box.add({p[0].value, p[1].value, 0}, {p[0].error, p[1].error, 0});
  return box;
}

/// From the place along u.
ImageBox SectionCaps::ray_from(const Place& at) {
  ImageBox box = box_of(at, at);
  box.high[0] = std::numeric_limits<float>::infinity();
  return box;
}

/// What doubles tell of a ray from the place along u: 1 or -1, it crosses the side, which goes up or down; 0, it does not; nothing, they do
/// not tell.
std::optional<int> SectionCaps::certain_crossing(const CapSide& side, const Place& at) const {
  const auto& [u, v] = at;
  const Place &a = places_[side.from], &b = places_[side.to];
  if (certain(a[0] - u) == Sign::negative && certain(b[0] - u) == Sign::negative) return 0;
  const Sign above_a = certain(a[1] - v), above_b = certain(b[1] - v);
  if (above_a == Sign::zero || above_b == Sign::zero) return std::nullopt;
  if (above_a == above_b) return 0;
  const Sign left = certain(turn(a, b, at));
  if (left == Sign::zero) return std::nullopt;
  if (above_a == Sign::negative) return left == Sign::positive ? 1 : 0;
  return left == Sign::negative ? -1 : 0;
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
  if (!(at[0].error < HUGE_VAL && at[1].error < HUGE_VAL)) return std::nullopt;
  Counter counter;
  bool is_known = true;
  visit_ray(at, [&](std::uint32_t k) {
    const auto crossing = certain_crossing(sides_[k], at);
    is_known = crossing.has_value();
    if (is_known && *crossing != 0) counter.add(sides_[k], *crossing);
    return is_known;
  });
  if (!is_known) return std::nullopt;
  return counter.is_inside_any();
}

/// A ray along u from the hand that has the side between itself and what is farther along u crosses it, the other one does not.
std::optional<SectionCaps::Hands> SectionCaps::certain_hands(std::uint32_t side) const {
  const Place &a = places_[sides_[side].from], &b = places_[sides_[side].to];
  const Sign rise = certain(b[1] - a[1]);
  if (rise == Sign::zero) return std::nullopt;
  const ErrorBounded half = {0.5, 0};
  const Place middle = {half * (a[0] + b[0]), half * (a[1] + b[1])};
  Counter counter;
  bool is_known = true;
  visit_ray(middle, [&](std::uint32_t k) {
    if (k == side) return true;
    const auto crossing = certain_crossing(sides_[k], middle);
    is_known = crossing.has_value();
    if (is_known && *crossing != 0) counter.add(sides_[k], *crossing);
    return is_known;
  });
  if (!is_known) return std::nullopt;
  Hands hands;
  auto& beyond = rise == Sign::positive ? hands.right : hands.left;
  auto& before = rise == Sign::positive ? hands.left : hands.right;
  beyond = counter.inside();
  counter.add(sides_[side], rise == Sign::positive ? 1 : -1);
  before = counter.inside();
  return hands;
}

bool SectionCaps::covers(const ExactPlace& at) const {
  const Place about = {bounded(at[0]), bounded(at[1])};
  if (const auto known = covers(about)) return *known;
  // On a side, or level with an end of one. A side may have nothing on either hand, where others lie along it.
  std::optional<ExactPlace> along;
  visit_ray(about, [&](std::uint32_t k) {
    if (certain_crossing(sides_[k], about)) return true;
    const ExactPlace &a = exact_places_[sides_[k].from], &b = exact_places_[sides_[k].to];
    if (turn(a, b, at).sign() != Sign::zero) return true;
    const auto product = [&](std::size_t c) { return (a[c] - at[c]).sign() * (b[c] - at[c]).sign(); };
    if (product(0) == Sign::positive || product(1) == Sign::positive) return true;
    along = ExactPlace{b[0] - a[0], b[1] - a[1]};
    return false;
  });
  std::optional<std::uint32_t> least;
  if (!along) return !objects_beside(at, {Rational(1.0), Rational()}, least).empty();
  const ExactPlace left = {-(*along)[1], (*along)[0]}, right = {(*along)[1], -(*along)[0]};
  return !objects_beside(at, left, least).empty() || !objects_beside(at, right, least).empty();
}

/// As covers(), about a place that is moved toward: where that decides, the signs are those of the way.
std::vector<std::uint32_t> SectionCaps::objects_beside(const ExactPlace& at, const ExactPlace& toward,
                                                       std::optional<std::uint32_t>& least_side, const ExactPlace& then) const {
  const Place about = {bounded(at[0]), bounded(at[1])};
  Counter counter;
  const auto first_of = [](Sign a, Sign b) { return a != Sign::zero ? a : b; };
  const Sign up = first_of(toward[1].sign(), then[1].sign());
  visit_ray(about, [&](std::uint32_t k) {
    if (const auto known = certain_crossing(sides_[k], about)) {
      if (*known != 0) counter.add(sides_[k], *known);
      return true;
    }
    const ExactPlace &a = exact_places_[sides_[k].from], &b = exact_places_[sides_[k].to];
    Sign at_a = (a[1] - at[1]).sign(), at_b = (b[1] - at[1]).sign();
    if (at_a * at_b == Sign::positive) return true;
    Sign left = turn(a, b, at).sign();
    if (left == Sign::zero) {
      if ((a[0] - at[0]).sign() * (b[0] - at[0]).sign() != Sign::positive) least_side = std::min(k, least_side.value_or(k));
      const auto along = [&](const ExactPlace& d) { return ((b[0] - a[0]) * d[1] - (b[1] - a[1]) * d[0]).sign(); };
      left = first_of(along(toward), along(then));
    }
    if (at_a == Sign::zero) at_a = -up;
    if (at_b == Sign::zero) at_b = -up;
    const bool is_below_a = at_a == Sign::positive, is_below_b = at_b == Sign::positive;
    if (is_below_a == is_below_b) return true;
    if (is_below_b && left == Sign::positive) counter.add(sides_[k], 1);
    if (is_below_a && left == Sign::negative) counter.add(sides_[k], -1);
    return true;
  });
  return counter.inside();
}

}  // namespace hsr::internal
