#include "hsr/scene/scene_facts.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/disjoint_sets.h"
#include "geometry/predicates.h"

namespace hsr::internal {

namespace {

void count_points(const Mesh& mesh, SceneFacts& facts) {
  facts.points = mesh.points.size();
  std::vector<char> is_used(mesh.points.size(), 0);
  for (const auto& triangle : mesh.triangles)
    for (const VertexId v : triangle) is_used[v.value] = 1;
  for (const Edge& e : mesh.edges)
    if (e.wire) is_used[e.a.value] = is_used[e.b.value] = 1;
  for (std::size_t k = 0; k < mesh.points.size(); ++k) {
    facts.distinct_points += mesh.merged[VertexId(k)] == VertexId(k);
    if (!is_used[k]) continue;
    const Point3& p = mesh.points[VertexId(k)];
    if (facts.used_points++ == 0) facts.lowest = facts.highest = p;
    facts.lowest = {std::min(facts.lowest.x, p.x), std::min(facts.lowest.y, p.y), std::min(facts.lowest.z, p.z)};
    facts.highest = {std::max(facts.highest.x, p.x), std::max(facts.highest.y, p.y), std::max(facts.highest.z, p.z)};
    facts.coordinates.add(p);
  }
}

// The vertices of each face that is used, ascending and once each; then faces are told apart by them.
void count_faces(const Mesh& mesh, const Polygons& polygons, SceneFacts& facts) {
  facts.faces = mesh.faces.size();
  facts.triangles = mesh.triangles.size();
  std::vector<std::uint32_t> vertices;
  struct Face {
    std::uint64_t hash;
    std::size_t first, end;  // in vertices
  };
  std::vector<Face> used;
  used.reserve(mesh.faces.size());
  vertices.reserve(polygons.corners.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto corners = polygons[f];
    facts.triangular += corners.size() == 3;
    facts.quadrangular += corners.size() == 4;
    facts.larger += corners.size() > 4;
    const FaceUse use = mesh.faces[FaceId(f)];
    ++facts.used_as[static_cast<std::size_t>(use)];
    if (use == FaceUse::no_area || use == FaceUse::ghost) continue;
    const std::size_t first = vertices.size();
    bool same[3] = {true, true, true};
    const Point3& o = mesh.points[VertexId(corners[0])];
    for (const std::uint32_t corner : corners) {
      const Point3& p = mesh.points[VertexId(corner)];
      for (int axis = 0; axis < 3; ++axis) same[axis] = same[axis] && p[axis] == o[axis];
      vertices.push_back(mesh.merged[VertexId(corner)].value);
    }
    facts.axis_parallel_faces += same[0] || same[1] || same[2];
    std::sort(vertices.begin() + static_cast<std::ptrdiff_t>(first), vertices.end());
    vertices.erase(std::unique(vertices.begin() + static_cast<std::ptrdiff_t>(first), vertices.end()), vertices.end());
    std::uint64_t hash = 0;
    for (std::size_t k = first; k < vertices.size(); ++k) hash = (hash ^ vertices[k]) * 0x9e3779b97f4a7c15ULL;
    used.push_back({hash, first, vertices.size()});
  }
  const auto vertices_of = [&](const Face& f) { return std::span(vertices).subspan(f.first, f.end - f.first); };
  std::sort(used.begin(), used.end(), [&](const Face& a, const Face& b) {
    return a.hash != b.hash ? a.hash < b.hash : std::ranges::lexicographical_compare(vertices_of(a), vertices_of(b));
  });
  for (std::size_t k = 1; k < used.size(); ++k)
    facts.duplicate_faces +=
        used[k].hash == used[k - 1].hash && std::ranges::equal(vertices_of(used[k]), vertices_of(used[k - 1]));
}

bool runs_forward(const Mesh& mesh, TriangleId t, const Edge& e) {
  const auto& [a, b, c] = mesh.triangles[t];
  return (a == e.a && b == e.b) || (b == e.a && c == e.b) || (c == e.a && a == e.b);
}

struct EdgeCounts {
  std::size_t boundary = 0, regular = 0, non_manifold = 0, odd = 0, flipped = 0, coplanar = 0;
};

// The sides at an edge, without those of diagonals: of a face that is cut and does not have the edge in its ring.
std::vector<TriangleId> sides_of_faces(const Mesh& mesh, const Polygons& polygons, EdgeId edge) {
  const Edge& e = mesh.edges[edge];
  std::vector<TriangleId> sides;
  for (const TriangleId t : mesh.triangles_at(edge)) {
    const auto corners = polygons[mesh.face_of[t].value];
    bool is_in_ring = mesh.faces[mesh.face_of[t]] == FaceUse::planar;
    for (std::size_t k = 0; k < corners.size() && !is_in_ring; ++k) {
      const VertexId a = mesh.merged[VertexId(corners[k])], b = mesh.merged[VertexId(corners[(k + 1) % corners.size()])];
      is_in_ring = (a == e.a && b == e.b) || (a == e.b && b == e.a);
    }
    if (is_in_ring) sides.push_back(t);
  }
  return sides;
}

void count_edges(const Mesh& mesh, const Polygons& polygons, SceneFacts& facts) {
  const BitRange all = bit_range(mesh.points);
  const auto add = [](EdgeCounts a, const EdgeCounts& b) {
    a.boundary += b.boundary;
    a.regular += b.regular;
    a.non_manifold += b.non_manifold;
    a.odd += b.odd;
    a.flipped += b.flipped;
    a.coplanar += b.coplanar;
    return a;
  };
  const EdgeCounts counts = tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, mesh.edges.size(), 4096), EdgeCounts{},
      [&](const tbb::blocked_range<std::size_t>& range, EdgeCounts sum) {
        Predicates predicates(all);
        for (std::size_t k = range.begin(); k != range.end(); ++k) {
          const Edge& e = mesh.edges[EdgeId(k)];
          if (!e.of_face) continue;
          auto at = mesh.triangles_at(EdgeId(k));
          std::vector<TriangleId> without_diagonals;
          if (e.diagonal) at = without_diagonals = sides_of_faces(mesh, polygons, EdgeId(k));
          sum.boundary += at.size() == 1;
          sum.odd += at.size() % 2;
          sum.non_manifold += at.size() > 2;
          if (at.size() != 2) continue;
          ++sum.regular;
          sum.flipped += runs_forward(mesh, at[0], e) == runs_forward(mesh, at[1], e);
          const auto& [a, b, c] = mesh.triangles[at[0]];
          const Plane plane = Plane::of_face(mesh.points[a], mesh.points[b], mesh.points[c]);
          sum.coplanar += predicates.side(plane, mesh.points[mesh.apex(at[1], e)]) == Sign::zero;
        }
        return sum;
      },
      add);
  facts.boundary_edges = counts.boundary;
  facts.regular_edges = counts.regular;
  facts.non_manifold_edges = counts.non_manifold;
  facts.odd_edges = counts.odd;
  facts.flipped_edges = counts.flipped;
  facts.coplanar_edges = counts.coplanar;
  facts.wires =
      static_cast<std::size_t>(std::count_if(mesh.edges.begin(), mesh.edges.end(), [](const Edge& e) { return e.wire; }));
}

std::uint32_t corner_at(const Mesh& mesh, TriangleId t, VertexId v) {
  const auto& triangle = mesh.triangles[t];
  return 3 * t.value + (triangle[0] == v ? 0U : triangle[1] == v ? 1U : 2U);
}

// Corners of triangles at one vertex belong together if their triangles share a side at it.
void count_pinches(const Mesh& mesh, SceneFacts& facts) {
  DisjointSets corners(3 * mesh.triangles.size());
  const auto join = [&](TriangleId s, TriangleId t, VertexId a, VertexId b) {
    corners.join(corner_at(mesh, s, a), corner_at(mesh, t, a));
    corners.join(corner_at(mesh, s, b), corner_at(mesh, t, b));
  };
  for (std::size_t k = 0; k < mesh.edges.size(); ++k) {
    const auto at = mesh.triangles_at(EdgeId(k));
    for (std::size_t i = 1; i < at.size(); ++i) join(at[0], at[i], mesh.edges[EdgeId(k)].a, mesh.edges[EdgeId(k)].b);
  }
  struct Side {
    VertexId a, b;
    TriangleId t;
  };
  std::vector<Side> sides;  // of one face: its inner diagonals are no edges
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const std::uint32_t first = mesh.first_triangle[FaceId(f)], end = mesh.first_triangle[FaceId(f + 1)];
    if (end - first < 2 || mesh.faces[FaceId(f)] != FaceUse::planar) continue;
    sides.clear();
    for (std::uint32_t t = first; t < end; ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const VertexId a = mesh.triangles[TriangleId(t)][k], b = mesh.triangles[TriangleId(t)][(k + 1) % 3];
        sides.push_back({std::min(a, b), std::max(a, b), TriangleId(t)});
      }
    std::sort(sides.begin(), sides.end(), [](const Side& s, const Side& t) { return s.a != t.a ? s.a < t.a : s.b < t.b; });
    for (std::size_t k = 1; k < sides.size(); ++k)
      if (sides[k].a == sides[k - 1].a && sides[k].b == sides[k - 1].b)
        join(sides[k - 1].t, sides[k].t, sides[k].a, sides[k].b);
  }
  std::vector<std::uint8_t> fans(mesh.points.size(), 0);  // 2: two or more
  for (std::uint32_t c = 0; c < 3 * mesh.triangles.size(); ++c) {
    std::uint8_t& n = fans[mesh.triangles[TriangleId(c / 3)][c % 3].value];
    if (corners.find(c) == c && n < 2) ++n;
  }
  facts.pinched_vertices = static_cast<std::size_t>(std::count(fans.begin(), fans.end(), 2));
}

void count_components(const Mesh& mesh, SceneFacts& facts) {
  DisjointSets vertices(mesh.points.size());
  std::vector<char> is_used(mesh.points.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[TriangleId(t)];
    vertices.join(a.value, b.value);
    vertices.join(a.value, c.value);
    is_used[a.value] = is_used[b.value] = is_used[c.value] = 1;
  }
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v) facts.components += is_used[v] && vertices.find(v) == v;
}

}  // namespace

SceneFacts scene_facts(const Mesh& mesh, const Polygons& polygons) {
  SceneFacts facts;
  count_points(mesh, facts);
  count_faces(mesh, polygons, facts);
  count_edges(mesh, polygons, facts);
  count_pinches(mesh, facts);
  count_components(mesh, facts);
  return facts;
}

}  // namespace hsr::internal
