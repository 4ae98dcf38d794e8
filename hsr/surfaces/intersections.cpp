#include "hsr/surfaces/intersections.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <optional>

#include "hsr/surfaces/facet.h"
#include "hsr/surfaces/triangle_sides.h"

namespace hsr {

namespace {

class Finder {
 public:
  Finder(const Sight& sight, const Occluders& occluders, std::vector<std::uint8_t>& has_contact)
      : sight_(sight), mesh_(sight.mesh()), occluders_(occluders), map_(sight), has_contact_(has_contact) {}

  void look_around(TriangleId s, std::vector<Intersection>& found);
  const DecisionCounts& decisions() { return map_.exact().counts(); }

 private:
  std::array<Sign, 3> sides(const PlaneFilter& filter, const Plane& plane, TriangleId s, TriangleId t);
  void look_at(TriangleId s, const PlaneFilter& filter, const Plane& plane, TriangleId t, std::vector<Intersection>& found);
  void mark_contacts(TriangleId flat, TriangleId t, const std::array<Sign, 3>& at);
  bool may_lie_in(VertexId u, VertexId v, TriangleId t);
  bool is_inner_diagonal(TriangleId t, std::size_t k) const;
  bool passes_through(TriangleId t, const std::array<Sign, 3>& at) const;
  bool cross_beyond_common_corner(TriangleId s, TriangleId t);
  std::optional<Intersection> segment(TriangleId s, TriangleId t);

  const Sight& sight_;
  const Mesh& mesh_;
  const Occluders& occluders_;
  MapSight map_;
  std::vector<std::uint8_t>& has_contact_;
};

std::array<Sign, 3> Finder::sides(const PlaneFilter& filter, const Plane& plane, TriangleId s, TriangleId t) {
  const auto &c = mesh_.triangles[s], &d = mesh_.triangles[t];
  std::array<Sign, 3> at;
  for (std::size_t k = 0; k < 3; ++k) {
    const VertexId v = d[k];
    if (v == c[0] || v == c[1] || v == c[2]) {
      at[k] = Sign::zero;
      continue;
    }
    const ErrorBounded x = filter(sight_.point(v));
    at[k] = x.is_certain() ? sign_of(x.value) : map_.exact().side_beyond_filter(plane, sight_.point(v));
  }
  return at;
}

bool straddles(const std::array<Sign, 3>& at) {
  const auto any = [&](Sign s) { return at[0] == s || at[1] == s || at[2] == s; };
  return any(Sign::positive) && any(Sign::negative);
}

void Finder::look_around(TriangleId s, std::vector<Intersection>& found) {
  const Plane plane = sight_.face_plane(s);
  const PlaneFilter filter = sight_.filter(plane);
  const TriangleId facet = facet_of(mesh_, s);
  occluders_.tree.visit_touching(sight_.box(s), [&](std::uint32_t i) {
    const TriangleId t = occluders_.triangles[i];
    if (t > s && facet_of(mesh_, t) != facet) look_at(s, filter, plane, t, found);
    return true;
  });
}

void Finder::look_at(TriangleId s, const PlaneFilter& filter, const Plane& plane, TriangleId t,
                     std::vector<Intersection>& found) {
  const std::array<Sign, 3> at_t = sides(filter, plane, s, t);
  const auto zeros = [](const std::array<Sign, 3>& at) { return std::count(at.begin(), at.end(), Sign::zero); };
  if (!straddles(at_t) && zeros(at_t) < 2) return;  // on one side but for a point
  const Plane other = sight_.face_plane(t);
  const std::array<Sign, 3> at_s = sides(sight_.filter(other), other, t, s);
  if (zeros(at_t) >= 2) mark_contacts(s, t, at_t);
  if (zeros(at_s) >= 2) mark_contacts(t, s, at_s);
  if (!passes_through(t, at_t) || !passes_through(s, at_s)) return;
  if (straddles(at_t) && straddles(at_s) && !cross_beyond_common_corner(s, t)) return;
  if (const auto crossing = segment(s, t)) found.push_back(*crossing);
}

/// Marks the sides of t that lie in the plane of `flat` and may overlap it.
void Finder::mark_contacts(TriangleId flat, TriangleId t, const std::array<Sign, 3>& at) {
  const auto &c = mesh_.triangles[t], &d = mesh_.triangles[flat];
  const auto is_corner = [&](VertexId v) { return v == d[0] || v == d[1] || v == d[2]; };
  const bool is_single = facet_end(mesh_, flat).value - facet_of(mesh_, flat).value == 1;
  for (std::size_t k = 0; k < 3; ++k) {
    if (at[k] != Sign::zero || at[(k + 1) % 3] != Sign::zero) continue;
    const VertexId u = c[k], v = c[(k + 1) % 3];
    if (is_single && is_corner(u) && is_corner(v)) continue;
    if (!may_lie_in(u, v, flat)) continue;
    // A diagonal inside a planar face is no edge of the mesh; an edge of `flat` is no contact with it.
    const EdgeId e = mesh_.find_edge(u, v);
    if (!e.is_valid()) continue;
    const auto own = mesh_.triangles_at(e);
    if (std::find(own.begin(), own.end(), flat) != own.end()) continue;
    std::atomic_ref<std::uint8_t>(has_contact_[e.value]).store(1, std::memory_order_relaxed);
  }
}

/// Whether the segment uv, in the plane of t, may have more than a point in common with t.
bool Finder::may_lie_in(VertexId u, VertexId v, TriangleId t) {
  const auto& c = mesh_.triangles[t];
  for (std::size_t k = 0; k < 3; ++k) {
    const MapHalfPlane h = side_of_triangle(sight_, t, k);
    const Sign a = map_.side(h.line, u) * h.inner, b = map_.side(h.line, v) * h.inner;
    if (a != Sign::positive && b != Sign::positive && !(a == Sign::zero && b == Sign::zero)) return false;
  }
  // All of t on one side of the segment, but for a point.
  const MapLine line = MapLine::edge(u, v);
  bool positive = false, negative = false;
  int zeros = 0;
  for (const VertexId w : c) {
    const Sign s = map_.side(line, w);
    zeros += s == Sign::zero ? 1 : 0;
    positive = positive || s == Sign::positive;
    negative = negative || s == Sign::negative;
  }
  return (positive && negative) || zeros >= 2;
}

/// Whether the side of t from corner k on is a diagonal within its planar face.
bool Finder::is_inner_diagonal(TriangleId t, std::size_t k) const {
  if (facet_end(mesh_, t).value - facet_of(mesh_, t).value == 1) return false;
  const auto& c = mesh_.triangles[t];
  const EdgeId e = mesh_.find_edge(c[k], c[(k + 1) % 3]);
  if (!e.is_valid()) return true;
  const auto own = mesh_.triangles_at(e);
  return std::find(own.begin(), own.end(), t) == own.end();
}

/// Whether the face of t has points on both sides of a plane around t, t being on the sides `at` of it: where a diagonal lies
/// in the plane the face goes on behind it.
bool Finder::passes_through(TriangleId t, const std::array<Sign, 3>& at) const {
  if (straddles(at)) return true;
  for (std::size_t k = 0; k < 3; ++k)
    if (at[k] == Sign::zero && at[(k + 1) % 3] == Sign::zero && at[(k + 2) % 3] != Sign::zero) return is_inner_diagonal(t, k);
  return false;
}

/// Two triangles with a common corner v, each with points on both sides of the other's plane, pq and ab their other corners:
/// both cross the line of both planes in a segment that starts at v, and they have more in common iff both run the same way.
/// Where ab crosses the plane of vpq is on q's side of the line vp iff b is on q's side of the plane vpa.
bool Finder::cross_beyond_common_corner(TriangleId s, TriangleId t) {
  const auto &c = mesh_.triangles[s], &d = mesh_.triangles[t];
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      if (c[i] != d[k]) continue;
      const VertexId p = d[(k + 1) % 3], q = d[(k + 2) % 3], a = c[(i + 1) % 3], b = c[(i + 2) % 3];
      const Plane plane = Plane::of_face(sight_.point(c[i]), sight_.point(p), sight_.point(a));
      return sight_.side(plane, b, map_.exact()) * sight_.side(plane, q, map_.exact()) == Sign::positive;
    }
  return true;
}

/// Clips the line in which both planes meet to both triangles. @pre the face of each passes through the other's plane
std::optional<Intersection> Finder::segment(TriangleId s, TriangleId t) {
  Intersection found{s, t, {}, {}};
  const MapLine line = found.line();
  std::vector<MapHalfPlane> half_planes, within, parallel;  // within: the face goes on behind it
  for (const TriangleId x : {s, t}) {
    for (std::size_t k = 0; k < 3; ++k)
      (is_inner_diagonal(x, k) ? within : half_planes).push_back(side_of_triangle(sight_, x, k));
    if (sight_.reaches_before_near(x)) half_planes.push_back(beyond_near(sight_, x));
  }
  for (const MapHalfPlane& h : within)
    if (map_.turn(line, h.line) != Sign::zero) half_planes.push_back(h);
  std::optional<MapPoint> low, high;
  for (const MapHalfPlane& h : half_planes) {
    const Sign turn = map_.turn(line, h.line);
    if (turn == Sign::zero) {
      parallel.push_back(h);
      continue;
    }
    // Where the side's line turns to the left its values fall along the line.
    const MapPoint p = MapPoint::crossing(line, h.line);
    if (turn * h.inner == Sign::positive) {
      if (!high || map_.order(line, p, *high) == Sign::negative) high = p;
    } else {
      if (!low || map_.order(line, *low, p) == Sign::negative) low = p;
    }
  }
  if (!low || !high || map_.order(line, *low, *high) != Sign::negative) return std::nullopt;
  for (const MapHalfPlane& h : parallel)
    if (map_.side(h.line, *low) * h.inner != Sign::positive) return std::nullopt;
  for (const MapHalfPlane& h : within)
    if (map_.side(h.line, *low) * h.inner == Sign::negative) return std::nullopt;
  found.from = *low;
  found.to = *high;
  return found;
}

}  // namespace

Intersections find_intersections(const Sight& sight, const Occluders& occluders) {
  Intersections all;
  all.has_contact.resize(sight.mesh().edges.size(), 0);
  constexpr std::size_t block = 512;
  const std::size_t n = occluders.triangles.size();
  std::vector<std::vector<Intersection>> parts((n + block - 1) / block);
  std::vector<DecisionCounts> counts(parts.size());
  using Range = tbb::blocked_range<std::size_t>;
  tbb::parallel_for(Range(0, parts.size(), 1), [&](const Range& range) {
    for (std::size_t part = range.begin(); part < range.end(); ++part) {
      Finder finder(sight, occluders, all.has_contact);
      const std::size_t end = std::min((part + 1) * block, n);
      for (std::size_t i = part * block; i < end; ++i) finder.look_around(occluders.triangles[i], parts[part]);
      counts[part] = finder.decisions();
    }
  });
  for (std::size_t part = 0; part < parts.size(); ++part) {
    all.segments.insert(all.segments.end(), parts[part].begin(), parts[part].end());
    all.decisions += counts[part];
  }
  std::sort(all.segments.begin(), all.segments.end(),
            [](const Intersection& x, const Intersection& y) { return std::pair(x.s, x.t) < std::pair(y.s, y.t); });
  return all;
}

}  // namespace hsr
