#include "hsr/painter/verify/painted_parts.h"

#include <algorithm>

#include "geometry/error.h"
#include "geometry/mesh.h"

namespace hsr::internal {

namespace {

/// Three corners of a ring that have an area in the image, in the order of the ring; nothing: it has none.
std::optional<std::array<std::uint32_t, 3>> spanning(PaintedSides& sides, std::span<const std::uint32_t> ring) {
  for (std::size_t i = 0; i + 1 < ring.size(); ++i)
    for (std::size_t k = 0; k < ring.size(); ++k)
      if (sides.turn(ring[i], ring[i + 1], ring[k]) != Sign::zero) return std::array{ring[i], ring[i + 1], ring[k]};
  return {};
}

bool is_planar(PaintedSides& sides, std::span<const std::uint32_t> ring, const std::array<std::uint32_t, 3>& plane) {
  return std::all_of(ring.begin(), ring.end(),
                     [&](std::uint32_t c) { return sides.side(plane[0], plane[1], plane[2], c) == Sign::zero; });
}

/// Whether a planar ring goes once around a convex polygon. Beyond the near plane its image tells.
bool is_convex(PaintedSides& sides, std::span<const std::uint32_t> ring, Sign around) {
  // All corners on one side of each side: then only one that passes some corner twice goes around more than once.
  const std::size_t n = ring.size();
  std::vector<std::uint32_t> sorted(ring.begin(), ring.end());
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) return false;
  for (std::size_t k = 0; k < n; ++k)
    if (sides.turn(ring[k], ring[(k + 1) % n], ring[(k + 2) % n]) == -around) return false;
  for (std::size_t k = 0; k < n; ++k)
    for (const std::uint32_t c : ring)
      if (sides.turn(ring[k], ring[(k + 1) % n], c) == -around) return false;
  return true;
}

Rational sum(const Rational& a, const Rational& b) { return a + b; }

RationalVector newell_normal(const std::vector<RationalVector>& ring) {
  RationalVector n;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const RationalVector c = cross(minus(ring[k], ring[0]), minus(ring[(k + 1) % ring.size()], ring[0]));
    for (std::size_t i = 0; i < 3; ++i) n[i] = sum(n[i], c[i]);
  }
  return n;
}

/// Whether a polygon is planar and convex, decided in space: for those that the near plane cuts, or that have many corners.
/// O(n).
bool is_planar_and_convex(const std::vector<RationalVector>& ring) {
  const std::size_t n = ring.size();
  const RationalVector normal = newell_normal(ring);
  if (dot(normal, normal).sign() == Sign::zero) return false;
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

/// Without consecutive repeats.
std::vector<std::uint32_t> as_ring(std::span<const std::uint32_t> corners) {
  std::vector<std::uint32_t> ring(corners.begin(), corners.end());
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  return ring;
}

}  // namespace

PaintedParts::PaintedParts(const std::vector<PaintedPolygon>& polygons, const View& view)
    : points_(polygons), rows_(view), left_(view) {
  PaintedSides sides(points_, rows_, view);
  for (std::uint32_t i = 0; i < polygons.size(); ++i) {
    add(sides, i);
    parts_.end_row();
    if (!parts_[i].empty()) ++(parts_[i].front().is_wire() ? wires_ : polygons_with_area_);
  }
  points_.place(rows_);
}

bool PaintedParts::is_whole(PaintedSides& sides, std::span<const std::uint32_t> ring) const {
  return left_.is_whole(ring, [&](const Plane& plane, std::uint32_t c) { return sides.side(plane, c); });
}

bool PaintedParts::is_nothing(PaintedSides& sides, std::span<const std::uint32_t> ring) const {
  return left_.is_nothing(ring, [&](const Plane& plane, std::uint32_t c) { return sides.side(plane, c); });
}

void PaintedParts::add(PaintedSides& sides, std::uint32_t polygon) {
  if (points_.corners_of(polygon).size() == 2) return add_wire(polygon);
  std::vector<std::uint32_t> ring = as_ring(points_.corners_of(polygon));
  if (ring.size() < 3 || is_nothing(sides, ring)) return;
  constexpr std::size_t few = 64;
  bool is_one = ring.size() == 3;
  if (!is_one && ring.size() <= few && is_whole(sides, ring)) {
    const auto plane = spanning(sides, ring);
    if (!plane) return;  // seen edge-on
    is_one = is_planar(sides, ring, *plane) && is_convex(sides, ring, sides.turn((*plane)[0], (*plane)[1], (*plane)[2]));
  } else if (!is_one) {
    is_one = is_planar_and_convex(exact(ring));
  }
  if (is_one) {
    add_cut(sides, polygon, std::move(ring));
  } else {
    ++triangulated_;
    add_triangles(sides, polygon);
  }
}

std::vector<RationalVector> PaintedParts::exact(std::span<const std::uint32_t> corners) const {
  std::vector<RationalVector> points;
  points.reserve(corners.size());
  for (const std::uint32_t c : corners) points.push_back(points_.exact(c));
  return points;
}

void PaintedParts::add_wire(std::uint32_t polygon) {
  for (const std::vector<RationalVector>& ends : left_.of(exact(points_.corners_of(polygon)))) {
    if (rows_.place(ends[0]) == rows_.place(ends[1])) continue;  // seen as a point
    const auto first = static_cast<std::uint32_t>(corners_.size());
    for (std::size_t k = 0; k < 2; ++k) corners_.push_back(points_.number_of(ends[k]));
    parts_.push_back({polygon, first, first + 2, {}});
  }
}

void PaintedParts::add_triangles(PaintedSides& sides, std::uint32_t polygon) {
  std::vector<Point3> points;
  Polygons polygons;
  for (const std::uint32_t c : points_.corners_of(polygon)) {
    if (!points_.is_double(c))
      throw InputError("piece " + std::to_string(polygon) +
                       ": it is not planar or not convex, and has corners that are no doubles: expected convex planar pieces");
    polygons.corners.push_back(static_cast<std::uint32_t>(points.size()));
    points.push_back(points_.point(c));
  }
  polygons.first = {0, static_cast<std::uint32_t>(points.size())};
  const Mesh mesh = make_mesh(points, polygons);
  for (const auto& t : mesh.triangles) {
    std::vector<std::uint32_t> ring;
    ring.reserve(t.size());
    for (const VertexId v : t) ring.push_back(points_.number_of(rational(mesh.points[v])));
    add_cut(sides, polygon, std::move(ring));
  }
}

/// What is left of a convex ring.
void PaintedParts::add_cut(PaintedSides& sides, std::uint32_t polygon, std::vector<std::uint32_t> ring) {
  if (is_whole(sides, ring)) return add_convex(sides, polygon, std::move(ring));
  for (const std::vector<RationalVector>& part : left_.of(exact(ring))) {
    std::vector<std::uint32_t> corners;
    corners.reserve(part.size());
    for (const RationalVector& p : part) corners.push_back(points_.number_of(p));
    add_convex(sides, polygon, as_ring(corners));
  }
}

void PaintedParts::add_convex(PaintedSides& sides, std::uint32_t polygon, std::vector<std::uint32_t> ring) {
  if (ring.size() < 3) return;
  auto plane = spanning(sides, ring);
  if (!plane) return;  // seen edge-on
  if (sides.turn((*plane)[0], (*plane)[1], (*plane)[2]) == Sign::negative) {
    std::reverse(ring.begin(), ring.end());
    std::swap((*plane)[0], (*plane)[1]);
  }
  const auto first = static_cast<std::uint32_t>(corners_.size());
  corners_.insert(corners_.end(), ring.begin(), ring.end());
  parts_.push_back({polygon, first, static_cast<std::uint32_t>(corners_.size()), *plane});
}

std::vector<ImageBox> PaintedParts::boxes() const {
  std::vector<ImageBox> boxes;
  boxes.reserve(parts().size());
  for (const PaintedPart& part : parts()) {
    ImageBox box = ImageBox::nothing();
    for (const std::uint32_t c : corners_of(part)) {
      const BoundedPoint2& at = points_.place_of(c);
      box.add({at.p.x, at.p.y, 0}, {at.error, at.error, 0});
    }
    boxes.push_back(box);
  }
  return boxes;
}

Sign before_plane(PaintedSides& sides, const PaintedPart& part, std::uint32_t p) {
  // The corners are counter-clockwise as seen: the viewpoint is on the positive side.
  return sides.side(part.plane[0], part.plane[1], part.plane[2], p);
}

namespace {

using Corners = std::span<const std::uint32_t>;

/// Whether a side of a has all of b on its outer side or on it.
bool separates(PaintedSides& sides, Corners a, Corners b) {
  for (std::size_t k = 0; k < a.size(); ++k) {
    const std::uint32_t from = a[k], to = a[(k + 1) % a.size()];
    if (std::all_of(b.begin(), b.end(), [&](std::uint32_t c) { return sides.turn(from, to, c) != Sign::positive; }))
      return true;
  }
  return false;
}

bool is_within(PaintedSides& sides, Corners ring, std::uint32_t p) {
  for (std::size_t k = 0; k < ring.size(); ++k)
    if (sides.turn(ring[k], ring[(k + 1) % ring.size()], p) == Sign::negative) return false;
  return true;
}

/// At the corners of a that lie in b.
void add_corners(PaintedSides& sides, Corners a, const PaintedPart& b, Corners of_b, bool& a_nearer, bool& b_nearer) {
  for (const std::uint32_t c : a) {
    const Sign s = before_plane(sides, b, c);
    if ((s == Sign::positive && a_nearer) || (s == Sign::negative && b_nearer) || s == Sign::zero) continue;
    if (is_within(sides, of_b, c)) (s == Sign::positive ? a_nearer : b_nearer) = true;
  }
}

/// Where sides of the two cross.
void add_crossings(PaintedSides& sides, Corners a, Corners b, Nearer& found) {
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t k = 0; k < b.size(); ++k) {
      const std::uint32_t p = a[i], q = a[(i + 1) % a.size()], r = b[k], s = b[(k + 1) % b.size()];
      const Sign at_r = sides.turn(p, q, r);
      if (at_r == Sign::zero || at_r * sides.turn(p, q, s) != Sign::negative) continue;
      if (sides.turn(r, s, p) * sides.turn(r, s, q) != Sign::negative) continue;
      // rs leaves the plane of p, q and r toward s, and the eye is on the side of at_r.
      const Sign second = sides.side(p, q, r, s) * at_r;
      found.second = found.second || second == Sign::positive;
      found.first = found.first || second == Sign::negative;
      if (found.first && found.second) return;
    }
}

/// All of one on one side of the other's plane. Nothing: on both.
std::optional<Sign> side_of_all(PaintedSides& sides, const PaintedPart& plane, Corners corners) {
  Sign all = Sign::zero;
  for (const std::uint32_t c : corners) {
    const Sign s = before_plane(sides, plane, c);
    if (s == Sign::zero) continue;
    if (all == -s) return {};
    all = s;
  }
  return all;
}

}  // namespace

std::optional<Nearer> nearer(const PaintedParts& all, PaintedSides& sides, const PaintedPart& a, const PaintedPart& b) {
  const Corners of_a = all.corners_of(a), of_b = all.corners_of(b);
  if (separates(sides, of_a, of_b) || separates(sides, of_b, of_a)) return {};
  if (const auto s = side_of_all(sides, b, of_a)) return Nearer{*s == Sign::positive, *s == Sign::negative};
  if (const auto s = side_of_all(sides, a, of_b)) return Nearer{*s == Sign::negative, *s == Sign::positive};
  Nearer found;
  add_corners(sides, of_a, b, of_b, found.first, found.second);
  add_corners(sides, of_b, a, of_a, found.second, found.first);
  if (!(found.first && found.second)) add_crossings(sides, of_a, of_b, found);
  return found;
}

}  // namespace hsr::internal
