#include "hsr/painter/verify.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/box_tree.h"
#include "geometry/enclosure.h"
#include "geometry/error.h"
#include "geometry/rational_vector.h"

namespace hsr {

namespace {

using Place = std::array<Rational, 2>;
constexpr std::uint32_t none = 0xffffffffU;

Rational sum(const Rational& a, const Rational& b) { return a + b; }

/// The image as two linear functions over a third. Parallel: over 1.
struct Rows {
  bool parallel = true;
  RationalVector eye;  // or the direction toward the viewer
  std::array<RationalVector, 2> across;
  RationalVector away;
  Rational near;  // of the depth along `away`: what is before it is cut off

  explicit Rows(const View& view) : parallel(!view.is_perspective()), eye(rational(view.viewpoint.at)) {
    away = parallel ? minus(RationalVector{}, eye) : minus(rational(view.target), eye);
    for (std::size_t k = 0; k < 3; ++k) {
      RationalVector unit;
      unit[k] = 1.0;
      const RationalVector c = cross(away, unit);
      if (dot(c, c).sign() == Sign::zero) continue;
      across = {c, cross(away, c)};
      break;
    }
    if (!parallel) near = Rational(view.near) * dot(away, away);
  }
  RationalVector from_eye(const RationalVector& p) const { return parallel ? p : minus(p, eye); }
  Rational depth(const RationalVector& p) const { return dot(from_eye(p), away); }
  Place place(const RationalVector& p) const {
    const RationalVector d = from_eye(p);
    const Rational w = parallel ? Rational(1.0) : dot(d, away);
    return {dot(d, across[0]) / w, dot(d, across[1]) / w};
  }
};

/// A corner, exactly and about; corners at one point have one number.
struct Corner {
  RationalVector p;
  Place place;
  std::array<Enclosure, 3> near_p;
  std::array<Enclosure, 2> near_place;
  std::uint32_t number = 0;
};

/// A planar convex polygon, counter-clockwise in the image.
struct Polygon {
  std::uint32_t index = 0;  // of the painted polygon
  std::vector<Corner> corners;
  RationalVector normal;  // to the side of the eye
  std::array<Enclosure, 3> near_normal;
};

struct Pair {
  std::uint32_t behind = 0, before = 0;  // painted polygons
  bool piercing = false, coplanar = false;
  std::uint32_t a = 0, b = 0;  // the convex polygons, of the earlier and the later
};

Enclosure orientation(const std::array<Enclosure, 2>& a, const std::array<Enclosure, 2>& b, const std::array<Enclosure, 2>& p) {
  return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}
Rational orientation(const Place& a, const Place& b, const Place& p) {
  return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}
Sign sign_of_enclosure(const Enclosure& x) {
  if (std::fabs(x.middle) > x.error) return x.middle > 0 ? Sign::positive : Sign::negative;
  return Sign::zero;
}

class Verifier {
 public:
  Verifier(const std::vector<PaintedPolygon>& all, const View& view, const VerifyOptions& options)
      : all_(all), view_(view), options_(options), rows_(view) {}

  Verdict verdict() {
    for (std::uint32_t i = 0; i < all_.size(); ++i) add(i);
    find_pairs();
    count_and_describe();
    if (verdict_.wrong > 0) look_for_an_order();
    return std::move(verdict_);
  }

 private:
  void add(std::uint32_t index);
  void add_convex(std::uint32_t index, std::vector<RationalVector> ring);
  void add_triangles(std::uint32_t index);
  bool is_planar_and_convex(const std::vector<RationalVector>& ring, const RationalVector& normal) const;
  void cut_near(std::vector<RationalVector>& ring) const;

  Sign turn(const Corner& a, const Corner& b, const Corner& p) const;
  bool separates(const Polygon& a, const Polygon& b) const;
  Sign before_plane(const Polygon& plane, const Corner& c) const;
  std::vector<Place> common(const Polygon& a, const Polygon& b) const;
  Sign nearer(const Polygon& a, const Polygon& b, const Place& p) const;
  RationalVector point(const Polygon& polygon, const Place& p) const;
  std::optional<Pair> relation(std::uint32_t a, std::uint32_t b) const;
  void find_pairs();
  bool is_wrong(const Pair& pair) const;
  Witness witness(const Polygon& farther, const Polygon& nearer_one, bool anywhere) const;
  void count_and_describe();
  void look_for_an_order();
  std::optional<std::uint64_t> cuts(const std::vector<std::uint32_t>& left) const;

  const std::vector<PaintedPolygon>& all_;
  const View& view_;
  const VerifyOptions& options_;
  Rows rows_;
  std::vector<Polygon> polygons_;
  std::map<RationalVector, std::uint32_t> numbers_;
  std::vector<Pair> pairs_;
  Verdict verdict_;
};

RationalVector newell_normal(const std::vector<RationalVector>& ring) {
  RationalVector n;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const RationalVector c = cross(minus(ring[k], ring[0]), minus(ring[(k + 1) % ring.size()], ring[0]));
    for (std::size_t i = 0; i < 3; ++i) n[i] = sum(n[i], c[i]);
  }
  return n;
}

bool Verifier::is_planar_and_convex(const std::vector<RationalVector>& ring, const RationalVector& normal) const {
  const std::size_t n = ring.size();
  int turns = 0;  // around, in sign changes of the sides' first coordinate across
  for (std::size_t k = 0; k < n; ++k) {
    if (dot(normal, minus(ring[k], ring[0])).sign() != Sign::zero) return false;
    const RationalVector in = minus(ring[(k + 1) % n], ring[k]), out = minus(ring[(k + 2) % n], ring[(k + 1) % n]);
    const Sign s = dot(normal, cross(in, out)).sign();
    if (s == Sign::negative || (s == Sign::zero && dot(in, out).sign() == Sign::negative)) return false;
  }
  // All turns to the left may still go around twice: then the sides change their direction along an axis more than twice.
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (normal[i].sign() != Sign::zero) axis = i;
  const std::size_t u = (axis + 1) % 3;
  Sign last = Sign::zero, first = Sign::zero;
  for (std::size_t k = 0; k < n; ++k) {
    const Sign s = (ring[(k + 1) % n][u] - ring[k][u]).sign();
    if (s == Sign::zero) continue;
    if (first == Sign::zero) first = s;
    if (last != Sign::zero && s != last) ++turns;
    last = s;
  }
  return turns + (last != first ? 1 : 0) <= 2;
}

void Verifier::cut_near(std::vector<RationalVector>& ring) const {
  if (rows_.parallel) return;
  std::vector<RationalVector> out;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const RationalVector &p = ring[k], &q = ring[(k + 1) % ring.size()];
    const Rational s = rows_.depth(p) - rows_.near, t = rows_.depth(q) - rows_.near;
    if (s.sign() != Sign::negative) out.push_back(p);
    if (s.sign() * t.sign() != Sign::negative) continue;
    const Rational u = s / (s - t);
    const RationalVector d = minus(q, p);
    out.push_back({p[0] + u * d[0], p[1] + u * d[1], p[2] + u * d[2]});
  }
  ring = std::move(out);
}

void Verifier::add(std::uint32_t index) {
  std::vector<RationalVector> ring = all_[index].corners;
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  if (ring.size() < 3) return;
  const RationalVector normal = newell_normal(ring);
  const bool is_triangle = ring.size() == 3;
  if (is_triangle || (dot(normal, normal).sign() != Sign::zero && is_planar_and_convex(ring, normal))) {
    add_convex(index, std::move(ring));
  } else {
    ++verdict_.triangulated;
    add_triangles(index);
  }
}

/// By the rule for faces of a model.
void Verifier::add_triangles(std::uint32_t index) {
  std::vector<Point3> points;
  Polygons polygons;
  for (const RationalVector& p : all_[index].corners) {
    Point3 rounded = {p[0].to_double(), p[1].to_double(), p[2].to_double()};
    if (rational(rounded) != p)
      throw InputError("piece " + std::to_string(index) +
                       ": it is not planar or not convex, and has corners that are no doubles: expected convex planar pieces");
    polygons.corners.push_back(static_cast<std::uint32_t>(points.size()));
    points.push_back(rounded);
  }
  polygons.first = {0, static_cast<std::uint32_t>(points.size())};
  const Mesh mesh = make_mesh(points, polygons);
  for (const auto& t : mesh.triangles)
    add_convex(index, {rational(mesh.points[t[0]]), rational(mesh.points[t[1]]), rational(mesh.points[t[2]])});
}

void Verifier::add_convex(std::uint32_t index, std::vector<RationalVector> ring) {
  cut_near(ring);
  if (ring.size() < 3) return;
  Polygon out;
  out.index = index;
  out.normal = newell_normal(ring);
  // Toward the eye; seen edge-on it has no image.
  const Sign facing = (rows_.parallel ? dot(out.normal, rows_.eye) : dot(out.normal, minus(rows_.eye, ring[0]))).sign();
  if (facing == Sign::zero) return;
  if (facing == Sign::negative) out.normal = minus(RationalVector{}, out.normal);
  for (const RationalVector& p : ring) {
    Corner c;
    c.p = p;
    c.place = rows_.place(p);
    for (std::size_t k = 0; k < 3; ++k) c.near_p[k] = enclose(p[k]);
    for (std::size_t k = 0; k < 2; ++k) c.near_place[k] = enclose(c.place[k]);
    c.number = numbers_.emplace(p, static_cast<std::uint32_t>(numbers_.size())).first->second;
    out.corners.push_back(std::move(c));
  }
  for (std::size_t k = 0; k < 3; ++k) out.near_normal[k] = enclose(out.normal[k]);
  Rational area;
  for (std::size_t k = 1; k + 1 < out.corners.size(); ++k)
    area = area + orientation(out.corners[0].place, out.corners[k].place, out.corners[k + 1].place);
  if (area.sign() == Sign::negative) std::reverse(out.corners.begin(), out.corners.end());
  if (verdict_.polygons == 0 || polygons_.back().index != index) ++verdict_.polygons;
  polygons_.push_back(std::move(out));
}

Sign Verifier::turn(const Corner& a, const Corner& b, const Corner& p) const {
  if (p.number == a.number || p.number == b.number) return Sign::zero;
  const Sign s = sign_of_enclosure(orientation(a.near_place, b.near_place, p.near_place));
  return s != Sign::zero ? s : orientation(a.place, b.place, p.place).sign();
}

/// Whether a side of a has all of b on its outer side or on it.
bool Verifier::separates(const Polygon& a, const Polygon& b) const {
  for (std::size_t k = 0; k < a.corners.size(); ++k) {
    const Corner &from = a.corners[k], &to = a.corners[(k + 1) % a.corners.size()];
    if (std::all_of(b.corners.begin(), b.corners.end(), [&](const Corner& c) { return turn(from, to, c) != Sign::positive; }))
      return true;
  }
  return false;
}

/// On which side of a polygon's plane a corner lies: positive, on that of the eye.
Sign Verifier::before_plane(const Polygon& plane, const Corner& c) const {
  for (const Corner& own : plane.corners)
    if (own.number == c.number) return Sign::zero;
  Enclosure near(0.0);
  for (std::size_t k = 0; k < 3; ++k) near = near + plane.near_normal[k] * (c.near_p[k] - plane.corners[0].near_p[k]);
  const Sign s = sign_of_enclosure(near);
  return s != Sign::zero ? s : dot(plane.normal, minus(c.p, plane.corners[0].p)).sign();
}

std::vector<Place> Verifier::common(const Polygon& a, const Polygon& b) const {
  std::vector<Place> ring;
  for (const Corner& c : a.corners) ring.push_back(c.place);
  for (std::size_t k = 0; k < b.corners.size() && !ring.empty(); ++k) {
    const Place &from = b.corners[k].place, &to = b.corners[(k + 1) % b.corners.size()].place;
    std::vector<Place> out;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Place &p = ring[i], &q = ring[(i + 1) % ring.size()];
      const Rational s = orientation(from, to, p), t = orientation(from, to, q);
      if (s.sign() != Sign::negative) out.push_back(p);
      if (s.sign() * t.sign() != Sign::negative) continue;
      const Rational u = s / (s - t);
      out.push_back({p[0] + u * (q[0] - p[0]), p[1] + u * (q[1] - p[1])});
    }
    out.erase(std::unique(out.begin(), out.end()), out.end());
    ring = std::move(out);
  }
  return ring;
}

/// The point of a polygon's plane that is seen at a place.
RationalVector Verifier::point(const Polygon& polygon, const Place& p) const {
  const RationalVector& n = polygon.normal;
  const Rational s = p[0] / dot(rows_.across[0], rows_.across[0]), t = p[1] / dot(rows_.across[1], rows_.across[1]);
  RationalVector at;
  for (std::size_t k = 0; k < 3; ++k) at[k] = s * rows_.across[0][k] + t * rows_.across[1][k];
  if (rows_.parallel) {
    const Rational u = dot(n, minus(polygon.corners[0].p, at)) / dot(n, rows_.away);
    for (std::size_t k = 0; k < 3; ++k) at[k] = at[k] + u * rows_.away[k];
    return at;
  }
  const Rational w = Rational(1.0) / dot(rows_.away, rows_.away);
  for (std::size_t k = 0; k < 3; ++k) at[k] = at[k] + w * rows_.away[k];  // the ray
  const Rational u = dot(n, minus(polygon.corners[0].p, rows_.eye)) / dot(n, at);
  for (std::size_t k = 0; k < 3; ++k) at[k] = rows_.eye[k] + u * at[k];
  return at;
}

/// Positive: a is nearer than b where p is seen.
Sign Verifier::nearer(const Polygon& a, const Polygon& b, const Place& p) const {
  return (rows_.depth(point(b, p)) - rows_.depth(point(a, p))).sign();
}

std::optional<Pair> Verifier::relation(std::uint32_t i, std::uint32_t k) const {
  const Polygon &a = polygons_[i], &b = polygons_[k];
  if (separates(a, b) || separates(b, a)) return std::nullopt;
  Pair pair{a.index, b.index, false, false, i, k};
  bool nearer_a = false, nearer_b = false;
  const auto look = [&](const Polygon& of, const Polygon& plane, bool is_a) {
    bool before = false, behind = false;
    for (const Corner& c : of.corners) {
      const Sign s = before_plane(plane, c);
      before = before || s == Sign::positive;
      behind = behind || s == Sign::negative;
    }
    if (before && behind) return false;
    nearer_a = is_a ? before : behind;
    nearer_b = is_a ? behind : before;
    return true;
  };
  if (!look(a, b, true) && !look(b, a, false)) {
    for (const Place& p : common(a, b)) {
      const Sign s = nearer(a, b, p);
      nearer_a = nearer_a || s == Sign::positive;
      nearer_b = nearer_b || s == Sign::negative;
    }
  }
  pair.piercing = nearer_a && nearer_b;
  pair.coplanar = !nearer_a && !nearer_b;
  if (pair.coplanar) {
    const auto &f = all_[a.index].face, &g = all_[b.index].face;
    if (!f || !g) return std::nullopt;  // nothing says which comes first
    if (*f < *g) std::swap(pair.behind, pair.before);
  } else if (nearer_a) {
    std::swap(pair.behind, pair.before);
  }
  return pair;
}

bool Verifier::is_wrong(const Pair& pair) const {
  if (pair.piercing || pair.behind > pair.before) return true;
  const auto &f = all_[pair.behind].face, &g = all_[pair.before].face;
  return pair.coplanar && f && g && *f == *g;  // a face that covers a place twice
}

void Verifier::find_pairs() {
  std::vector<ImageBox> boxes;
  for (const Polygon& polygon : polygons_) {
    ImageBox box = ImageBox::nothing();
    for (const Corner& c : polygon.corners) {
      const auto bound = [&](std::size_t k) {
        return static_cast<double>(c.near_place[k].error) * 1.01 +
               std::fabs(static_cast<double>(c.near_place[k].middle)) * 0x1p-50;
      };
      box.add({static_cast<double>(c.near_place[0].middle), static_cast<double>(c.near_place[1].middle), 0},
              {bound(0), bound(1), 0});
    }
    boxes.push_back(box);
  }
  const BoxTree tree(boxes);
  constexpr std::size_t block = 32;
  std::vector<std::vector<Pair>> parts((tree.leaf_count() + block - 1) / block);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, parts.size(), 1), [&](const auto& range) {
    for (std::size_t part = range.begin(); part != range.end(); ++part) {
      std::vector<std::uint32_t> leaves;
      const std::size_t end = std::min<std::size_t>((part + 1) * block, tree.leaf_count());
      for (std::size_t leaf = part * block; leaf < end; ++leaf)
        tree.visit_pairs<BoxTree::Depth::any>(static_cast<std::uint32_t>(leaf), leaves, [&](std::uint32_t i, std::uint32_t k) {
          if (polygons_[i].index == polygons_[k].index) return;
          const bool in_order = polygons_[i].index < polygons_[k].index;
          if (const auto pair = relation(in_order ? i : k, in_order ? k : i)) parts[part].push_back(*pair);
        });
    }
  });
  for (const auto& part : parts) pairs_.insert(pairs_.end(), part.begin(), part.end());
  // Several triangles of two polygons may overlap: the wrong ones first.
  std::sort(pairs_.begin(), pairs_.end(), [&](const Pair& x, const Pair& y) {
    const auto key = [&](const Pair& p) {
      return std::tuple(std::minmax(p.behind, p.before), !p.piercing, !is_wrong(p), p.a, p.b);
    };
    return key(x) < key(y);
  });
}

/// A point where `farther` is the farther: of their common part, drawn from its middle toward a corner where it is.
Witness Verifier::witness(const Polygon& farther, const Polygon& nearer_one, bool anywhere) const {
  const std::vector<Place> part = common(farther, nearer_one);
  Place middle;
  for (const Place& p : part)
    for (std::size_t k = 0; k < 2; ++k) middle[k] = middle[k] + p[k] / Rational(static_cast<double>(part.size()));
  const auto is_there = [&](const Place& p) { return anywhere || nearer(nearer_one, farther, p) == Sign::positive; };
  for (const Place& corner : part) {
    if (is_there(middle)) break;
    if (!is_there(corner)) continue;
    while (!is_there(middle))
      for (std::size_t k = 0; k < 2; ++k) middle[k] = (middle[k] + corner[k]) / Rational(2.0);
  }
  Witness w;
  w.of_earlier = point(farther, middle);
  w.of_later = point(nearer_one, middle);
  w.place = image(view_, w.of_earlier);
  return w;
}

void Verifier::count_and_describe() {
  std::array<std::uint32_t, 2> last = {none, none};
  for (const Pair& pair : pairs_) {
    const std::array<std::uint32_t, 2> who = {std::min(pair.behind, pair.before), std::max(pair.behind, pair.before)};
    if (who == last) continue;
    last = who;
    ++verdict_.overlapping;
    if (!is_wrong(pair)) continue;
    ++verdict_.wrong;
    if (pair.piercing) ++verdict_.piercing;
    if (verdict_.first.size() >= options_.limit) continue;
    // The later is the farther there.
    Witness w = witness(polygons_[pair.b], polygons_[pair.a], pair.coplanar);
    std::swap(w.of_earlier, w.of_later);
    verdict_.first.push_back({who[0], who[1], pair.piercing, pair.coplanar, std::move(w)});
  }
}

/// What is left when, again and again, a polygon with nothing left behind it is painted.
void Verifier::look_for_an_order() {
  const auto n = static_cast<std::uint32_t>(all_.size());
  std::vector<std::vector<std::uint32_t>> before(n);  // by polygon: the pairs in which it is behind
  std::vector<std::uint32_t> behind(n, 0);
  for (std::uint32_t k = 0; k < pairs_.size(); ++k) {
    const Pair& p = pairs_[k];
    if (p.piercing && verdict_.cycle.empty()) {
      verdict_.order_exists = false;
      verdict_.cycle = {polygons_[p.a].index, polygons_[p.b].index};
      const std::uint32_t a = p.a, b = p.b;
      verdict_.cycle_witnesses = {witness(polygons_[a], polygons_[b], false), witness(polygons_[b], polygons_[a], false)};
    }
    before[p.behind].push_back(k);
    ++behind[p.before];
    if (p.piercing) {
      before[p.before].push_back(k);
      ++behind[p.behind];
    }
  }
  std::vector<std::uint32_t> ready;
  std::vector<std::uint8_t> is_painted(n, 0);
  for (std::uint32_t i = 0; i < n; ++i)
    if (behind[i] == 0) ready.push_back(i);
  while (!ready.empty()) {
    const std::uint32_t i = ready.back();
    ready.pop_back();
    is_painted[i] = 1;
    for (const std::uint32_t k : before[i]) {
      const std::uint32_t other = pairs_[k].behind == i ? pairs_[k].before : pairs_[k].behind;
      if (--behind[other] == 0) ready.push_back(other);
    }
  }
  std::vector<std::uint32_t> left;
  for (std::uint32_t i = 0; i < n; ++i)
    if (is_painted[i] == 0) left.push_back(i);
  if (left.empty()) return;
  verdict_.order_exists = false;
  verdict_.cuts_that_suffice = cuts(left);
  if (!verdict_.cycle.empty()) return;  // a pair that pierces says it best
  // Backward from any of them there is always another; where one comes again, the cycle is closed.
  std::vector<std::uint32_t> pair_behind(n, none);
  for (std::uint32_t k = 0; k < pairs_.size(); ++k)
    if (is_painted[pairs_[k].behind] == 0 && is_painted[pairs_[k].before] == 0) pair_behind[pairs_[k].before] = k;
  std::vector<std::uint8_t> is_seen(n, 0);
  std::uint32_t at = left.front();
  while (is_seen[at] == 0) {
    is_seen[at] = 1;
    at = pairs_[pair_behind[at]].behind;
  }
  std::vector<std::uint32_t> cycle, of_pair;
  for (std::uint32_t i = at; cycle.empty() || i != at; i = pairs_[pair_behind[i]].behind) {
    cycle.push_back(i);
    of_pair.push_back(pair_behind[i]);
  }
  std::reverse(cycle.begin(), cycle.end());
  std::reverse(of_pair.begin(), of_pair.end());
  verdict_.cycle = cycle;
  for (const std::uint32_t k : of_pair) {
    const Pair& p = pairs_[k];
    const bool a_is_behind = polygons_[p.a].index == p.behind;
    verdict_.cycle_witnesses.push_back(
        witness(polygons_[a_is_behind ? p.a : p.b], polygons_[a_is_behind ? p.b : p.a], p.coplanar));
  }
}

/// Each cut by the planes of all the others that pass through it: then every plane has every part on one side, and a tree of
/// these planes orders them.
std::optional<std::uint64_t> Verifier::cuts(const std::vector<std::uint32_t>& left) const {
  constexpr std::size_t most = 2000;
  if (left.size() > most) return std::nullopt;
  std::vector<std::uint32_t> parts;
  for (std::uint32_t k = 0; k < polygons_.size(); ++k)
    if (std::binary_search(left.begin(), left.end(), polygons_[k].index)) parts.push_back(k);
  std::uint64_t count = 0;
  for (const std::uint32_t i : parts)
    for (const std::uint32_t k : parts) {
      bool before = false, behind = false;
      for (const Corner& c : polygons_[i].corners) {
        const Sign s = before_plane(polygons_[k], c);
        before = before || s == Sign::positive;
        behind = behind || s == Sign::negative;
      }
      count += before && behind ? 1 : 0;
    }
  return count;
}

}  // namespace

Verdict verify(const std::vector<PaintedPolygon>& far_to_near, const View& view, const VerifyOptions& options) {
  return Verifier(far_to_near, view, options).verdict();
}

}  // namespace hsr
