#include "geometry/constrained_delaunay.h"

#include <algorithm>
#include <array>
#include <deque>
#include <utility>

#include "geometry/bit_range.h"
#include "geometry/half_edges.h"
#include "geometry/in_circle.h"
#include "geometry/spatial_order.h"

namespace hsr::internal {

namespace {

using Half = HalfEdges::Half;
using Vertex = HalfEdges::Vertex;
constexpr std::uint32_t none = HalfEdges::none;

// The vertices of a polygon once each, in the order of their insertion, and the polygon by these numbers.
struct Numbered {
  std::vector<VertexId> vertices;
  std::vector<Vertex> polygon;
};

Numbered number(const FlatPlane& plane, std::span<const VertexId> polygon) {
  std::vector<VertexId> sorted(polygon.begin(), polygon.end());
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  const int i = plane.axis == 2 ? 0 : plane.axis + 1;
  const int j = plane.axis == 0 ? 2 : plane.axis - 1;
  std::vector<double> x, y;
  for (const VertexId v : sorted) {
    x.push_back(plane.points[v][i]);
    y.push_back(plane.points[v][j]);
  }
  Numbered result;
  std::vector<Vertex> number_of(sorted.size());
  for (const std::uint32_t k : spatial_order({x, y})) {
    number_of[k] = static_cast<Vertex>(result.vertices.size());
    result.vertices.push_back(sorted[k]);
  }
  for (const VertexId v : polygon)
    result.polygon.push_back(
        number_of[static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), v) - sorted.begin())]);
  return result;
}

// Signs of numbered vertices.
class Places {
 public:
  Places(const FlatPlane& plane, std::vector<VertexId> vertices)
      : plane_(plane), vertices_(std::move(vertices)), in_circle_(bit_range_of_vertices()) {}

  std::size_t size() const { return vertices_.size(); }
  VertexId vertex(Vertex v) const { return vertices_[v]; }
  Sign orientation(Vertex a, Vertex b, Vertex c) const { return plane_.orientation(vertices_[a], vertices_[b], vertices_[c]); }
  bool is_in_circle(Vertex a, Vertex b, Vertex c, Vertex d) const {
    return in_circle_(point(a), point(b), point(c), point(d), plane_.axis) == plane_.turn;
  }
  // Of three on one line: whether b is where c is, seen from a.
  bool is_toward(Vertex a, Vertex b, Vertex c) const {
    const Point3 &p = point(a), &q = point(b), &r = point(c);
    for (int axis = 0; axis < 3; ++axis)
      if (p[axis] != q[axis]) return (p[axis] < q[axis]) == (p[axis] < r[axis]);
    return false;
  }

 private:
  const Point3& point(Vertex v) const { return plane_.points[vertices_[v]]; }
  BitRange bit_range_of_vertices() const {
    BitRange range;
    for (const VertexId v : vertices_) range.add(plane_.points[v]);
    return range;
  }

  FlatPlane plane_;
  std::vector<VertexId> vertices_;
  InCircle in_circle_;
};

// Flips every edge that `is_free` and not locally Delaunay, from those that are given on.
template <class IsFree>
void flip_until_delaunay(HalfEdges& mesh, const Places& at, std::vector<std::uint32_t> edges, const IsFree& is_free) {
  while (!edges.empty()) {
    const std::uint32_t e = edges.back();
    edges.pop_back();
    const Half h = mesh.half_of(e), g = mesh.twin(h);
    if (!is_free(e) || !at.is_in_circle(mesh.origin(h), mesh.target(h), mesh.apex(h), mesh.apex(g))) continue;
    mesh.flip(h);
    for (const Half side : {h, HalfEdges::next(h), g, HalfEdges::next(g)}) edges.push_back(mesh.edge(side));
  }
}

// The Delaunay triangles of points, inserted one by one. Beyond each edge of their hull lies a triangle with the vertex at
// infinity, whose circle is what is beyond that edge, and the inside of the edge.
class DelaunayPoints {
 public:
  explicit DelaunayPoints(const Places& at);
  HalfEdges take() { return std::move(mesh_); }

 private:
  void begin(Vertex c);
  void insert(Vertex v);
  Half locate(Vertex v) const;
  Half infinite_corner(Half h) const;
  bool is_in_conflict(Half h, Vertex v) const;

  const Places& at_;
  Vertex infinity_;
  HalfEdges mesh_;
  Vertex last_ = 0;
};

DelaunayPoints::DelaunayPoints(const Places& at) : at_(at), infinity_(static_cast<Vertex>(at.size())), mesh_(at.size() + 1) {
  mesh_.reserve(2 * at.size());
  Vertex third = 2;
  while (at_.orientation(0, 1, third) == Sign::zero) ++third;
  begin(third);
  for (Vertex v = 2; v < infinity_; ++v)
    if (v != third) insert(v);
}

void DelaunayPoints::begin(Vertex c) {
  Vertex a = 0, b = 1;
  if (at_.orientation(a, b, c) == Sign::negative) std::swap(a, b);
  const Half inside = mesh_.add_triangle(a, b, c);
  const Half beyond[3] = {mesh_.add_triangle(b, a, infinity_), mesh_.add_triangle(c, b, infinity_),
                          mesh_.add_triangle(a, c, infinity_)};
  for (unsigned k = 0; k < 3; ++k) {
    mesh_.glue(inside + k, beyond[k]);
    mesh_.glue(HalfEdges::previous(beyond[k]), HalfEdges::next(beyond[(k + 1) % 3]));
  }
}

// The half-edge of the triangle of h that begins at infinity, or none.
Half DelaunayPoints::infinite_corner(Half h) const {
  for (const Half k : {h, HalfEdges::next(h), HalfEdges::previous(h)})
    if (mesh_.origin(k) == infinity_) return k;
  return none;
}

bool DelaunayPoints::is_in_conflict(Half h, Vertex v) const {
  const Half corner = infinite_corner(h);
  if (corner == none) return at_.is_in_circle(mesh_.origin(h), mesh_.target(h), mesh_.apex(h), v);
  const Vertex a = mesh_.target(corner), b = mesh_.apex(corner);
  const Sign side = at_.orientation(a, b, v);
  return side == Sign::positive || (side == Sign::zero && at_.is_toward(a, v, b) && at_.is_toward(b, v, a));
}

// A walk from the point before: a Delaunay triangulation has no way round in circles.
Half DelaunayPoints::locate(Vertex v) const {
  Half h = mesh_.half_at(last_);
  if (const Half corner = infinite_corner(h); corner != none) {
    h = HalfEdges::next(corner);
    if (at_.orientation(mesh_.origin(h), mesh_.target(h), v) == Sign::positive) return h;
    h = mesh_.twin(h);
  }
  while (mesh_.apex(h) != infinity_) {
    Half onward = none;
    for (const Half side : {HalfEdges::next(h), HalfEdges::previous(h), h})
      if (at_.orientation(mesh_.origin(side), mesh_.target(side), v) == Sign::negative) {
        onward = mesh_.twin(side);
        break;
      }
    if (onward == none) return h;
    h = onward;
  }
  return h;
}

// On a side of its triangle a point makes a flat triangle, which the flip of that side takes away.
void DelaunayPoints::insert(Vertex v) {
  const Half h = locate(v);
  Half second, third;
  mesh_.split(h, v, second, third);
  std::vector<Half> opposite = {h, second, third};
  while (!opposite.empty()) {
    const Half side = opposite.back(), beyond = mesh_.twin(side);
    opposite.pop_back();
    if (!is_in_conflict(beyond, v)) continue;
    mesh_.flip(side);
    opposite.push_back(side);
    opposite.push_back(HalfEdges::next(beyond));
  }
  last_ = v;
}

// The triangles of a polygon among those of its vertices.
class PolygonTriangles {
 public:
  PolygonTriangles(const Places& at, std::vector<Vertex> polygon);
  std::vector<FaceTriangle> run();

 private:
  Half find(Vertex from, Vertex to) const;
  bool add_edge(std::size_t k);
  bool crossed_edges(Vertex from, Vertex to, std::vector<std::uint32_t>& crossed) const;
  Half first_crossed(Vertex from, Vertex to) const;
  bool flip_from_ends(Vertex from, Vertex to, const std::vector<std::uint32_t>& crossed);
  bool flip_in_turn(Vertex from, Vertex to, const std::vector<std::uint32_t>& crossed);
  bool would_cross(Vertex from, Vertex to, Half h) const;
  bool is_convex(Half h) const;
  bool mark_edges();
  bool add_fan(std::size_t k, std::vector<FaceTriangle>& triangles);
  bool is_finite(Half h) const;

  Vertex corner(std::size_t k) const { return polygon_[k < polygon_.size() ? k : k - polygon_.size()]; }

  const Places& at_;
  std::vector<Vertex> polygon_;
  Vertex infinity_;
  HalfEdges mesh_;
  std::vector<std::uint32_t> visits_;     // of each vertex
  std::vector<char> is_fixed_, crosses_;  // edges of the polygon; edges that cross the one in hand. char: vector<bool> is slow
  std::vector<char> is_given_;            // triangles
  std::vector<std::uint32_t> edge_of_;    // the edge of the polygon that a half-edge is
  std::vector<Half> half_of_;             // of each edge of the polygon
  std::vector<std::uint32_t> turned_;     // edges that may not be Delaunay
};

PolygonTriangles::PolygonTriangles(const Places& at, std::vector<Vertex> polygon)
    : at_(at),
      polygon_(std::move(polygon)),
      infinity_(static_cast<Vertex>(at.size())),
      mesh_(DelaunayPoints(at).take()),
      visits_(at.size()),
      is_fixed_(mesh_.edges()),
      crosses_(mesh_.edges()),
      is_given_(mesh_.halves() / 3),
      edge_of_(mesh_.halves(), none) {
  for (const Vertex v : polygon_) ++visits_[v];
}

bool PolygonTriangles::is_finite(Half h) const {
  return mesh_.origin(h) != infinity_ && mesh_.target(h) != infinity_ && mesh_.apex(h) != infinity_;
}

Half PolygonTriangles::find(Vertex from, Vertex to) const {
  const Half first = mesh_.half_at(from);
  Half h = first;
  do {
    if (mesh_.target(h) == to) return h;
    h = mesh_.turned(h);
  } while (h != first);
  return none;
}

// The side opposite to `from` that the way to `to` leaves its first triangle by; none if that is a vertex.
Half PolygonTriangles::first_crossed(Vertex from, Vertex to) const {
  const Half first = mesh_.half_at(from);
  Half h = first;
  do {
    if (is_finite(h) && at_.orientation(from, to, mesh_.target(h)) == Sign::negative &&
        at_.orientation(from, to, mesh_.apex(h)) == Sign::positive)
      return HalfEdges::next(h);
    h = mesh_.turned(h);
  } while (h != first);
  return none;
}

// False if the way from one vertex to another crosses an edge of the polygon, or a vertex.
bool PolygonTriangles::crossed_edges(Vertex from, Vertex to, std::vector<std::uint32_t>& crossed) const {
  for (Half h = first_crossed(from, to);;) {
    if (h == none || is_fixed_[mesh_.edge(h)] != 0) return false;
    crossed.push_back(mesh_.edge(h));
    const Half beyond = mesh_.twin(h);
    const Vertex apex = mesh_.apex(beyond);
    if (apex == to) return true;
    const Sign side = at_.orientation(from, to, apex);
    if (side == Sign::zero) return false;
    h = side == Sign::positive ? HalfEdges::next(beyond) : HalfEdges::previous(beyond);
  }
}

// Whether the other diagonal of the two triangles at h is inside them.
bool PolygonTriangles::is_convex(Half h) const {
  const Vertex u = mesh_.origin(h), w = mesh_.target(h), p = mesh_.apex(h), d = mesh_.apex(mesh_.twin(h));
  return at_.orientation(p, u, d) == Sign::positive && at_.orientation(d, w, p) == Sign::positive;
}

bool PolygonTriangles::would_cross(Vertex from, Vertex to, Half h) const {
  const Vertex p = mesh_.apex(h), d = mesh_.apex(mesh_.twin(h));
  if (p == from || p == to || d == from || d == to) return false;
  return at_.orientation(from, to, p) != at_.orientation(from, to, d);
}

// Turns what crosses the way: of all that may have changed, what does not cross when turned; only if there is no such edge one that
// still does, the latest first, so that the ends of the way grow into each other. Many edges between two straight rows of vertices
// are gone in linear time. False if something is left.
bool PolygonTriangles::flip_from_ends(Vertex from, Vertex to, const std::vector<std::uint32_t>& crossed) {
  std::vector<std::uint32_t> changed(crossed.rbegin(), crossed.rend()), convex;
  for (const std::uint32_t e : crossed) crosses_[e] = 1;
  std::size_t left = crossed.size(), patience = 64 + 32 * left;
  while (left > 0 && patience-- > 0) {
    const bool only_away = !changed.empty();
    std::vector<std::uint32_t>& candidates = only_away ? changed : convex;
    if (candidates.empty()) break;
    const std::uint32_t e = candidates.back();
    candidates.pop_back();
    const Half h = mesh_.half_of(e), g = mesh_.twin(h);
    if (crosses_[e] == 0 || !is_convex(h)) continue;
    if (!would_cross(from, to, h)) {
      crosses_[e] = 0;
      --left;
      turned_.push_back(e);
    } else if (only_away) {
      convex.push_back(e);
      continue;
    }
    mesh_.flip(h);
    for (const Half side : {h, HalfEdges::next(h), g, HalfEdges::next(g)})
      if (crosses_[mesh_.edge(side)] != 0) changed.push_back(mesh_.edge(side));
  }
  for (const std::uint32_t e : crossed) crosses_[e] = 0;
  return left == 0;
}

// Sloan: what still crosses, or cannot be turned yet, waits in a queue.
bool PolygonTriangles::flip_in_turn(Vertex from, Vertex to, const std::vector<std::uint32_t>& crossed) {
  std::deque<std::uint32_t> waiting(crossed.begin(), crossed.end());
  std::size_t patience = 64 + 8 * crossed.size() * crossed.size();
  while (!waiting.empty()) {
    if (patience-- == 0) return false;
    const std::uint32_t e = waiting.front();
    const Half h = mesh_.half_of(e);
    waiting.pop_front();
    const bool turns = is_convex(h), waits = !turns || would_cross(from, to, h);
    if (turns) mesh_.flip(h);
    if (waits)
      waiting.push_back(e);
    else
      turned_.push_back(e);
  }
  return true;
}

bool PolygonTriangles::add_edge(std::size_t k) {
  Vertex from = polygon_[k], to = corner(k + 1);
  if (visits_[to] < visits_[from]) std::swap(from, to);  // to turn around a vertex of many edges for each of them is slow
  Half h = find(from, to);
  if (h == none) {
    std::vector<std::uint32_t> crossed;
    if (!crossed_edges(from, to, crossed)) return false;
    if (!flip_from_ends(from, to, crossed)) {
      crossed.clear();
      if (!crossed_edges(from, to, crossed) || !flip_in_turn(from, to, crossed)) return false;
    }
    h = find(from, to);
  }
  is_fixed_[mesh_.edge(h)] = 1;
  return true;
}

// Which edge of the polygon has a triangle to its left; false if two have the same one.
bool PolygonTriangles::mark_edges() {
  for (std::size_t k = 0; k < polygon_.size(); ++k) {
    Vertex from = polygon_[k], to = corner(k + 1);
    const bool swapped = visits_[to] < visits_[from];
    if (swapped) std::swap(from, to);
    Half h = find(from, to);
    if (swapped) h = mesh_.twin(h);
    if (edge_of_[h] != none) return false;
    edge_of_[h] = static_cast<std::uint32_t>(k);
    half_of_.push_back(h);
  }
  return true;
}

// The triangles at corner k, from its edge on to the one before; false if another edge of the polygon comes first.
bool PolygonTriangles::add_fan(std::size_t k, std::vector<FaceTriangle>& triangles) {
  for (Half h = half_of_[k];; h = mesh_.turned(h)) {
    if (!is_finite(h)) return false;
    const Half next = HalfEdges::next(h), previous = HalfEdges::previous(h);
    if (is_given_[h / 3] == 0) {
      is_given_[h / 3] = 1;
      std::uint8_t ring_sides = 0;
      for (unsigned s = 0; const Half side : {h, next, previous}) {
        if (is_fixed_[mesh_.edge(side)] != 0) ring_sides |= static_cast<std::uint8_t>(1U << s);
        ++s;
      }
      triangles.push_back(
          {{at_.vertex(mesh_.origin(h)), at_.vertex(mesh_.origin(next)), at_.vertex(mesh_.origin(previous))}, ring_sides});
    }
    if (is_fixed_[mesh_.edge(previous)] != 0) return edge_of_[previous] == (k == 0 ? polygon_.size() : k) - 1;
  }
}

std::vector<FaceTriangle> PolygonTriangles::run() {
  for (std::size_t k = 0; k < polygon_.size(); ++k)
    if (!add_edge(k)) return {};
  flip_until_delaunay(mesh_, at_, std::move(turned_), [&](std::uint32_t e) {
    return is_fixed_[e] == 0 && is_finite(mesh_.half_of(e)) && is_finite(mesh_.twin(mesh_.half_of(e)));
  });
  if (!mark_edges()) return {};
  std::vector<FaceTriangle> triangles;
  triangles.reserve(polygon_.size() - 2);
  for (std::size_t k = 0; k < polygon_.size(); ++k)
    if (!add_fan(k, triangles)) return {};
  return triangles;
}

}  // namespace

std::vector<FaceTriangle> constrained_delaunay(const FlatPlane& plane, std::span<const VertexId> polygon) {
  Numbered numbered = number(plane, polygon);
  const Places at(plane, std::move(numbered.vertices));
  return PolygonTriangles(at, std::move(numbered.polygon)).run();
}

void flip_to_delaunay(const FlatPlane& plane, std::vector<FaceTriangle>& triangles) {
  std::vector<VertexId> vertices;
  for (const FaceTriangle& t : triangles) vertices.insert(vertices.end(), t.corners.begin(), t.corners.end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  const auto number_of = [&](VertexId v) {
    return static_cast<Vertex>(std::lower_bound(vertices.begin(), vertices.end(), v) - vertices.begin());
  };
  const Places at(plane, vertices);
  HalfEdges mesh(at.size());
  std::vector<std::pair<std::array<Vertex, 2>, Half>> diagonals;
  for (const FaceTriangle& t : triangles) {
    const Half first = mesh.add_triangle(number_of(t.corners[0]), number_of(t.corners[1]), number_of(t.corners[2]));
    for (Half side = first; side < first + 3; ++side) {
      const auto [low, high] = std::minmax({mesh.origin(side), mesh.target(side)});
      if ((t.ring_sides >> (side - first) & 1U) != 0)
        mesh.glue(side, none);
      else
        diagonals.push_back({{low, high}, side});
    }
  }
  std::sort(diagonals.begin(), diagonals.end());
  std::vector<std::uint32_t> edges;
  for (std::size_t k = 0; k + 1 < diagonals.size(); k += 2) {
    mesh.glue(diagonals[k].second, diagonals[k + 1].second);
    edges.push_back(mesh.edge(diagonals[k].second));
  }
  flip_until_delaunay(mesh, at, std::move(edges), [&](std::uint32_t e) { return mesh.twin(mesh.half_of(e)) != none; });
  for (Half first = 0; FaceTriangle & t : triangles) {
    t.ring_sides = 0;
    for (unsigned k = 0; k < 3; ++k) {
      t.corners[k] = at.vertex(mesh.origin(first + k));
      if (mesh.twin(first + k) == none) t.ring_sides |= static_cast<std::uint8_t>(1U << k);
    }
    first += 3;
  }
}

}  // namespace hsr::internal
