#include "geometry/triangulate.h"

#include <CGAL/Mpzf.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "geometry/constrained_delaunay.h"
#include "geometry/ear_cutting.h"
#include "geometry/flat_orientation.h"

namespace hsr::internal {

namespace {

using Points = IndexedVector<VertexId, Point3>;
using Ring = std::vector<VertexId>;

// Ears of fewer corners are as good, and cheaper.
constexpr std::size_t most_corners_of_ears = 12;

Ring reduce(const Points& points, std::span<const VertexId> polygon, Predicates& predicates) {
  Ring ring;
  const auto is_spike_between = [&](VertexId a, VertexId b, VertexId c) {
    return is_spike(points[a], points[b], points[c], predicates);
  };
  for (const VertexId v : polygon) {
    while (ring.size() >= 2 && ring.back() != v && is_spike_between(ring[ring.size() - 2], ring.back(), v)) ring.pop_back();
    if (ring.empty() || ring.back() != v) ring.push_back(v);
  }
  // The same across the seam. Corners that go are taken from either end.
  std::size_t first = 0;
  const auto size = [&] { return ring.size() - first; };
  while (size() >= 2) {
    if (ring.back() == ring[first] || (size() >= 3 && is_spike_between(ring[ring.size() - 2], ring.back(), ring[first])))
      ring.pop_back();
    else if (size() >= 3 && is_spike_between(ring.back(), ring[first], ring[first + 1]))
      ++first;
    else
      break;
  }
  ring.erase(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(first));
  if (ring.size() < 3) ring.clear();
  return ring;
}

VertexId corner(const Ring& ring, std::size_t k) { return ring[k < ring.size() ? k : k - ring.size()]; }

// The first corner of all at the lowest vertex.
std::size_t lowest_corner(const Ring& ring) {
  return static_cast<std::size_t>(std::min_element(ring.begin(), ring.end()) - ring.begin());
}

bool is_coplanar(const Points& points, const Ring& ring, Predicates& predicates) {
  // Reduced, so not all straight: a closed way along a line turns back somewhere.
  std::size_t k = 0;
  while (k + 1 < ring.size() &&
         !has_area(points[ring[k]], points[corner(ring, k + 1)], points[corner(ring, k + 2)], predicates))
    ++k;
  const Plane plane = Plane::of_face(points[ring[k]], points[corner(ring, k + 1)], points[corner(ring, k + 2)]);
  for (std::size_t i = 3; i < ring.size(); ++i)
    if (predicates.side(plane, points[corner(ring, k + i)]) != Sign::zero) return false;
  return true;
}

struct Axis {
  int axis;
  Sign turn;
};

// Of the normal (values, errors): the axis whose component is certainly the largest, and certainly not zero. If `any` axis will
// do, one that is certainly not zero.
std::optional<Axis> certain_axis(const double (&value)[3], const double (&error)[3], bool any) {
  int best = 0;
  for (int k = 1; k < 3; ++k)
    if (std::fabs(value[k]) > std::fabs(value[best])) best = k;
  const double low = std::fabs(value[best]) - error[best];
  if (!(low > 0) || !std::isfinite(low)) return {};
  for (int k = 0; k < 3 && !any; ++k)
    if (k != best && !(std::fabs(value[k]) + error[k] < low)) return {};
  return Axis{best, sign_of(value[best])};
}

// The Newell normal in doubles, as a fan around the first corner. Each cross product of the fan is off by at most
// 4.6e-16 (|l| + |r|) + 1e-300 (flat_orientation.h), each of the m additions by u = 1.2e-16 of a partial sum, which is at most
// the sum S of all |l| + |r|. With u (m + 1) for S itself being a rounded sum: error <= (4.6e-16 + 1.2e-16 m)(1 + 1.2e-16 m) S
// + 1e-300 m
// <= 5e-16 (m + 1) S + 1e-300 m for m < 2^32.
std::optional<Axis> certain_newell_axis(const Points& points, const Ring& ring, bool any) {
  double value[3] = {0, 0, 0}, sum[3] = {0, 0, 0}, error[3];
  const Point3& o = points[ring[0]];
  for (std::size_t k = 1; k + 1 < ring.size(); ++k) {
    const Point3 &p = points[ring[k]], &q = points[ring[k + 1]];
    const Point3 a{p.x - o.x, p.y - o.y, p.z - o.z}, b{q.x - o.x, q.y - o.y, q.z - o.z};
    for (int axis = 0; axis < 3; ++axis) {
      const int i = axis == 2 ? 0 : axis + 1;
      const int j = axis == 0 ? 2 : axis - 1;
      const double l = a[i] * b[j], r = a[j] * b[i];
      value[axis] += l - r;
      sum[axis] += std::fabs(l) + std::fabs(r);
    }
  }
  const auto m = static_cast<double>(ring.size());
  for (int axis = 0; axis < 3; ++axis) error[axis] = 5e-16 * (m + 1) * sum[axis] + 1e-300 * m;
  return certain_axis(value, error, any);
}

std::optional<Axis> exact_newell_axis(const Points& points, std::span<const VertexId> ring) {
  CGAL::Mpzf value[3] = {0, 0, 0};
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point3 &p = points[ring[k]], &q = points[ring[k + 1 == ring.size() ? 0 : k + 1]];
    const CGAL::Mpzf a[3] = {p.x, p.y, p.z}, b[3] = {q.x, q.y, q.z};
    for (int axis = 0; axis < 3; ++axis) {
      const int i = axis == 2 ? 0 : axis + 1;
      const int j = axis == 0 ? 2 : axis - 1;
      value[axis] = value[axis] + (a[i] * b[j] - a[j] * b[i]);
    }
  }
  int best = 0;
  for (int k = 1; k < 3; ++k)
    if (CGAL::abs(value[k]) > CGAL::abs(value[best])) best = k;
  const auto sign = static_cast<Sign>(static_cast<int>(CGAL::sign(value[best])));
  if (sign == Sign::zero) return {};
  return Axis{best, sign};
}

// Rule 2. Coplanar corners look the same along every axis that the normal has a part in.
Axis flattening(const Points& points, const Ring& ring, bool is_coplanar, Predicates& predicates) {
  if (const auto axis = certain_newell_axis(points, ring, is_coplanar)) return *axis;
  if (const auto axis = exact_newell_axis(points, ring)) return *axis;
  std::size_t lowest = ring.size();
  const auto triple = [&](std::size_t k) {
    return std::array{corner(ring, k + ring.size() - 1), corner(ring, k), corner(ring, k + 1)};
  };
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const auto [a, b, c] = triple(k);
    if ((lowest == ring.size() || ring[k] < ring[lowest]) && has_area(points[a], points[b], points[c], predicates)) lowest = k;
  }
  return *exact_newell_axis(points, triple(lowest));
}

// Rule 3. True if the quad is cut at a diagonal inside it.
bool cut_quad(const FlatPlane& plane, const Ring& ring, std::vector<FaceTriangle>& triangles) {
  const std::size_t k = lowest_corner(ring);
  const VertexId a = ring[k], b = corner(ring, k + 1), c = corner(ring, k + 2), d = corner(ring, k + 3);
  const Sign abc = plane.orientation(a, b, c), acd = plane.orientation(a, c, d);
  if (abc == Sign::positive && acd == Sign::positive) {
    triangles.push_back({{a, b, c}, 0b011});
    triangles.push_back({{a, c, d}, 0b110});
    return true;
  }
  if (plane.orientation(b, c, d) == Sign::positive && plane.orientation(b, d, a) == Sign::positive) {
    triangles.push_back({{b, c, d}, 0b011});
    triangles.push_back({{b, d, a}, 0b110});
    return true;
  }
  for (const FaceTriangle& t : {FaceTriangle{{a, b, c}, 0b011}, FaceTriangle{{a, c, d}, 0b110}})
    if (has_area(plane.points[t.corners[0]], plane.points[t.corners[1]], plane.points[t.corners[2]], plane.predicates))
      triangles.push_back(t);
  return false;
}

// Reduced, so that each corner is at another vertex than the two before it: with three vertices it runs around one triangle, more
// than once. Ears and spikes take off one turn after the other.
bool is_triangle_over_and_over(const Ring& ring) {
  if (ring.size() % 3 != 0) return false;
  for (std::size_t k = 3; k < ring.size(); ++k)
    if (ring[k] != ring[k - 3]) return false;
  return true;
}

// Adds each of `added` once. A side in the ring of one is in the ring of all that equal it.
void append_once(std::vector<FaceTriangle>& triangles, const std::vector<FaceTriangle>& added) {
  std::vector<FaceTriangle> from_lowest = added;  // equal ones look equal
  for (FaceTriangle& t : from_lowest)
    while (t.corners[0] > t.corners[1] || t.corners[0] > t.corners[2]) {
      std::rotate(t.corners.begin(), t.corners.begin() + 1, t.corners.end());
      t.ring_sides = static_cast<std::uint8_t>(t.ring_sides >> 1U | (t.ring_sides & 1U) << 2U);
    }
  std::vector<std::uint32_t> order(added.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t s, std::uint32_t t) { return from_lowest[s].corners < from_lowest[t].corners; });
  std::vector<char> is_first(added.size(), 0);
  for (std::size_t k = 0, first = 0; k < order.size(); ++k) {
    if (k == 0 || from_lowest[order[k]].corners != from_lowest[order[first]].corners) {
      first = k;
      is_first[order[k]] = 1;
    } else {
      from_lowest[order[first]].ring_sides |= from_lowest[order[k]].ring_sides;
    }
  }
  for (std::size_t t = 0; t < added.size(); ++t)
    if (is_first[t]) triangles.push_back(from_lowest[t]);
}

}  // namespace

FaceUse triangulate(const Points& points, std::span<const VertexId> polygon, Predicates& predicates,
                    std::vector<FaceTriangle>& triangles) {
  const Ring ring = reduce(points, polygon, predicates);
  if (ring.empty()) return FaceUse::no_area;
  if (ring.size() == 3) {
    triangles.push_back({{ring[0], ring[1], ring[2]}});
    return FaceUse::planar;
  }
  if (is_triangle_over_and_over(ring)) {
    append_once(triangles, {{{ring[0], ring[1], ring[2]}}});
    return FaceUse::crosses_itself;
  }
  const bool coplanar = is_coplanar(points, ring, predicates);
  const FaceUse cut = coplanar ? FaceUse::crosses_itself : FaceUse::not_coplanar;
  const auto [axis, turn] = flattening(points, ring, coplanar, predicates);
  const FlatPlane plane{points, predicates, axis, turn};
  if (ring.size() == 4) return cut_quad(plane, ring, triangles) && coplanar ? FaceUse::planar : cut;
  const bool is_large = ring.size() > most_corners_of_ears;
  if (coplanar && is_large) {
    const std::vector<FaceTriangle> delaunay = constrained_delaunay(plane, ring);
    if (!delaunay.empty()) {
      triangles.insert(triangles.end(), delaunay.begin(), delaunay.end());
      return FaceUse::planar;
    }
  }
  EarCutting ears = cut_ears(plane, ring);
  if (coplanar && ears.only_ears && is_free_of_overlap(plane, ring, ears.triangles)) {
    if (is_large) flip_to_delaunay(plane, ears.triangles);
    triangles.insert(triangles.end(), ears.triangles.begin(), ears.triangles.end());
    return FaceUse::planar;
  }
  append_once(triangles, ears.triangles);
  return cut;
}

}  // namespace hsr::internal
