#include "geometry/mesh.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "geometry/bit_range.h"
#include "geometry/error.h"
#include "geometry/flat_orientation.h"
#include "geometry/merge_points.h"
#include "geometry/mesh_edges.h"
#include "geometry/predicates.h"
#include "geometry/triangulate.h"

namespace hsr {

using namespace internal;

namespace {

void normalise(std::vector<Point3>& points) {
  for (std::size_t k = 0; k < points.size(); ++k)
    for (double* x : {&points[k].x, &points[k].y, &points[k].z}) {
      if (!std::isfinite(*x)) {
        throw InputError("point " + std::to_string(k) + ": a finite coordinate expected, found " +
                         (std::isnan(*x) ? "nan"
                          : *x < 0       ? "-inf"
                                         : "inf"));
      }
      *x += 0.0;  // -0 + 0 = 0
    }
}

void check(const Polygons& polygons, std::size_t points) {
  const auto& first = polygons.first;
  require(!first.empty() && first.front() == 0 && first.back() == polygons.corners.size() &&
              std::is_sorted(first.begin(), first.end()),
          "make_mesh: Polygons::first must ascend from 0 to the number of corners");
  const auto fail = [&](const char* what, std::size_t k, std::uint32_t index) {
    throw InputError(what + std::to_string(k) + ": an index below " + std::to_string(points) + " expected, found " +
                     std::to_string(index));
  };
  for (std::size_t k = 0; k < polygons.corners.size(); ++k) {
    if (polygons.corners[k] < points) continue;
    const auto face = std::upper_bound(first.begin(), first.end(), k) - first.begin() - 1;
    fail("face ", static_cast<std::size_t>(face), polygons.corners[k]);
  }
  for (std::size_t k = 0; k < polygons.segments.size(); ++k)
    for (const std::uint32_t end : polygons.segments[k])
      if (end >= points) fail("segment ", k, end);
}

// The triangles of some faces in a row. Blocks are made in parallel and joined in order.
using Block = std::vector<FaceTriangle>;

void make_faces(Mesh& mesh, const Polygons& polygons, std::size_t from, std::size_t to, Predicates& predicates, Block& block) {
  std::vector<VertexId> polygon;
  block.reserve(to - from);
  for (std::size_t f = from; f < to; ++f) {
    const auto corners = polygons[f];
    const std::size_t before = block.size();
    FaceUse use = FaceUse::no_area;
    if (corners.size() == 3) {
      const VertexId a = mesh.merged[VertexId(corners[0])], b = mesh.merged[VertexId(corners[1])],
                     c = mesh.merged[VertexId(corners[2])];
      if (a != b && b != c && c != a && has_area(mesh.points[a], mesh.points[b], mesh.points[c], predicates)) {
        block.push_back({{a, b, c}});
        use = FaceUse::planar;
      }
    } else if (corners.size() > 3) {
      polygon.clear();
      for (const std::uint32_t corner : corners) polygon.push_back(mesh.merged[VertexId(corner)]);
      use = triangulate(mesh.points, polygon, predicates, block);
    }
    mesh.faces[FaceId(f)] = use;
    mesh.first_triangle[FaceId(f + 1)] = static_cast<std::uint32_t>(block.size() - before);
  }
}

/// The polygons, but those whose flag is not `kept` without corners.
Polygons some_of(const Polygons& polygons, std::uint8_t kept) {
  Polygons some;
  for (std::size_t f = 0; f < polygons.size(); ++f) {
    if (polygons.is_ghost[f] == kept) some.corners.insert(some.corners.end(), polygons[f].begin(), polygons[f].end());
    some.first.push_back(static_cast<std::uint32_t>(some.corners.size()));
  }
  return some;
}

Mesh mesh_of_solids(std::vector<Point3> points, const Polygons& polygons, double tolerance,
                    std::span<const std::array<std::uint32_t, 2>> edges_of_ghosts);

/// Both kinds of faces over the same points: which points are one does not depend on who uses them.
Mesh mesh_with_ghosts(std::vector<Point3> points, const Polygons& polygons, double tolerance) {
  auto ghosts = std::make_shared<Mesh>(mesh_of_solids(points, some_of(polygons, 1), tolerance, {}));
  std::vector<std::array<std::uint32_t, 2>> edges;
  for (const Edge& e : ghosts->edges) edges.push_back({e.a.value, e.b.value});
  Polygons solids = some_of(polygons, 0);
  solids.segments = polygons.segments;
  Mesh mesh = mesh_of_solids(std::move(points), solids, tolerance, edges);
  for (std::size_t f = 0; f < polygons.size(); ++f)
    if (polygons.is_ghost[f] != 0 && ghosts->faces[FaceId(f)] != FaceUse::no_area) mesh.faces[FaceId(f)] = FaceUse::ghost;
  mesh.ghosts = std::move(ghosts);
  return mesh;
}

}  // namespace

EdgeId Mesh::find_edge(VertexId a, VertexId b) const {
  const auto ends = std::pair(std::min(a, b), std::max(a, b));
  const auto at = std::lower_bound(edges.begin(), edges.end(), ends,
                                   [](const Edge& e, const auto& key) { return std::pair(e.a, e.b) < key; });
  return at != edges.end() && std::pair(at->a, at->b) == ends ? EdgeId(static_cast<std::size_t>(at - edges.begin())) : EdgeId();
}

Mesh make_mesh(std::vector<Point3> points, const Polygons& polygons, double tolerance) {
  require(!polygons.first.empty(), "make_mesh: Polygons::first must begin with 0");
  require(polygons.is_ghost.empty() || polygons.is_ghost.size() == polygons.size(),
          "make_mesh: Polygons::is_ghost must be empty or have a flag for each polygon");
  check_countable(points.size(), "points");
  check_countable(polygons.size(), "faces");
  check(polygons, points.size());
  normalise(points);
  const bool has_ghosts = std::any_of(polygons.is_ghost.begin(), polygons.is_ghost.end(), [](auto flag) { return flag != 0; });
  return has_ghosts ? mesh_with_ghosts(std::move(points), polygons, tolerance)
                    : mesh_of_solids(std::move(points), polygons, tolerance, {});
}

namespace {

Mesh mesh_of_solids(std::vector<Point3> points, const Polygons& polygons, double tolerance,
                    std::span<const std::array<std::uint32_t, 2>> edges_of_ghosts) {
  Mesh mesh;
  static_cast<std::vector<Point3>&>(mesh.points) = std::move(points);
  mesh.merged = merge_points(mesh.points);
  if (tolerance > 0) merge_clusters(mesh.points, tolerance, mesh.merged);

  const std::size_t faces = polygons.size();
  mesh.faces.resize(faces);
  mesh.first_triangle.assign(faces + 1, 0);
  constexpr std::size_t faces_of_block = 4096;
  std::vector<Block> blocks((faces + faces_of_block - 1) / faces_of_block);
  const BitRange all = bit_range(mesh.points);
  const auto for_each_block = [&](const auto& visit) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, blocks.size(), 1), [&](const auto& range) {
      for (std::size_t k = range.begin(); k != range.end(); ++k)
        visit(k, k * faces_of_block, std::min(faces, (k + 1) * faces_of_block));
    });
  };
  for_each_block([&](std::size_t k, std::size_t from, std::size_t to) {
    Predicates predicates(all);
    make_faces(mesh, polygons, from, to, predicates, blocks[k]);
  });
  for (std::size_t f = 0; f < faces; ++f) mesh.first_triangle[FaceId(f + 1)] += mesh.first_triangle[FaceId(f)];
  const std::uint32_t triangles = mesh.first_triangle[FaceId(faces)];
  mesh.triangles.resize(triangles);
  mesh.face_of.resize(triangles);
  std::vector<std::uint8_t> ring_sides(triangles);
  for_each_block([&](std::size_t k, std::size_t from, std::size_t to) {
    const FaceTriangle* triangle = blocks[k].data();
    for (std::size_t f = from; f < to; ++f)
      for (std::uint32_t t = mesh.first_triangle[FaceId(f)]; t < mesh.first_triangle[FaceId(f + 1)]; ++t, ++triangle) {
        mesh.triangles[TriangleId(t)] = triangle->corners;
        mesh.face_of[TriangleId(t)] = FaceId(f);
        ring_sides[t] = triangle->ring_sides;
      }
  });
  connect_edges(mesh, ring_sides, polygons.segments, edges_of_ghosts);
  return mesh;
}

}  // namespace

Mesh make_mesh(std::span<const Point3> points, std::span<const std::uint32_t> corners, std::span<const std::uint32_t> first) {
  Polygons polygons;
  polygons.first.assign(first.begin(), first.end());
  polygons.corners.assign(corners.begin(), corners.end());
  return make_mesh({points.begin(), points.end()}, polygons);
}

Mesh make_mesh(std::span<const Point3> points, std::span<const std::array<std::uint32_t, 3>> triangles) {
  check_countable(3 * triangles.size(), "corners");
  Polygons polygons;
  polygons.corners.reserve(3 * triangles.size());
  for (const auto& t : triangles) {
    polygons.corners.insert(polygons.corners.end(), t.begin(), t.end());
    polygons.first.push_back(static_cast<std::uint32_t>(polygons.corners.size()));
  }
  return make_mesh({points.begin(), points.end()}, polygons);
}

}  // namespace hsr
