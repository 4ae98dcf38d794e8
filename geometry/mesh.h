#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "geometry/index.h"
#include "geometry/point.h"

namespace hsr {

/// Polygons and segments over shared points, as a file gives them.
struct Polygons {
  std::vector<std::uint32_t> first = {0};              ///< polygon f has corners[first[f]] ... corners[first[f + 1] - 1]
  std::vector<std::uint32_t> corners;                  ///< indices of points
  std::vector<std::array<std::uint32_t, 2>> segments;  ///< wires: drawn, they hide nothing
  std::vector<std::uint8_t> is_ghost;  ///< by polygon: 1, its edges are drawn, and it hides nothing; empty: none

  std::size_t size() const { return first.size() - 1; }
  std::span<const std::uint32_t> operator[](std::size_t f) const {
    return {corners.data() + first[f], corners.data() + first[f + 1]};
  }
};

/// How a face is used.
enum class FaceUse : std::uint8_t {
  planar,          ///< one planar face; its triangles are only a covering of it
  not_coplanar,    ///< cut into triangles that act as faces of their own
  crosses_itself,  ///< planar, and cut into triangles all the same
  no_area,         ///< dropped
  ghost,           ///< hides nothing: its triangles are those of Mesh::ghosts
};
constexpr std::size_t face_use_count = 5;

/// An undirected edge a < b.
struct Edge {
  VertexId a, b;
  bool of_face = false;   ///< in the ring of a face
  bool diagonal = false;  ///< a diagonal of a face that is cut into triangles
  bool wire = false;      ///< a segment of its own
  bool ghost = false;     ///< an edge of Mesh::ghosts

  bool is_only_of_ghosts() const { return ghost && !of_face && !diagonal && !wire; }
};

/// Whether v is one of the corners of a triangle.
inline bool is_one_of(VertexId v, const std::array<VertexId, 3>& corners) {
  return v == corners[0] || v == corners[1] || v == corners[2];
}

/// The faces as used (docs/conventions.md), and who meets whom: any soup, non-manifold, open, flipped or duplicate.
///
///   (1) points are as given, but -0 is 0; no index but the lowest of bit-identical points is used anywhere
///   (2) every triangle has an area; the triangles of one face are consecutive, faces ascending, corners in the face's order
///   (3) edges ascend by (a, b); each side of each triangle is an edge, except a diagonal inside a planar face
///   (4) the result is the same for any number of threads
///   (5) ghosts have no triangle here, so nothing that looks for what hides can come upon one; their edges are edges here
struct Mesh {
  IndexedVector<VertexId, Point3> points;
  IndexedVector<VertexId, VertexId> merged;  ///< the vertex that stands for each point
  IndexedVector<FaceId, FaceUse> faces;
  IndexedVector<FaceId, std::uint32_t> first_triangle;  ///< one more than faces
  IndexedVector<TriangleId, std::array<VertexId, 3>> triangles;
  IndexedVector<TriangleId, FaceId> face_of;
  IndexedVector<EdgeId, Edge> edges;
  IndexedVector<EdgeId, std::uint32_t> first_side;  ///< one more than edges
  std::vector<TriangleId> sides;                    ///< edge e has the triangles sides[first_side[e]] ...
  /// The faces that are drawn and hide nothing, as a mesh of their own with the same points and numbers of faces; null: none.
  std::shared_ptr<const Mesh> ghosts;

  std::span<const TriangleId> triangles_at(EdgeId e) const {
    return {sides.data() + first_side[e], sides.data() + first_side[EdgeId(e.value + 1U)]};
  }
  /// Whether a triangle has one of its edges as a -> b, not as b -> a.
  bool runs_along(TriangleId t, const Edge& e) const {
    const auto& c = triangles[t];
    const std::size_t k = c[0] == e.a ? 0 : c[1] == e.a ? 1 : 2;
    return c[(k + 1) % 3] == e.b;
  }
  /// The edge between two vertices; invalid if there is none. Cost: O(log n).
  EdgeId find_edge(VertexId a, VertexId b) const;
  bool has_corner(TriangleId t, VertexId v) const { return is_one_of(v, triangles[t]); }
  /// The corner of `t` that is not on the edge.
  VertexId apex(TriangleId t, const Edge& e) const {
    for (const VertexId v : triangles[t])
      if (v != e.a && v != e.b) return v;
    return {};
  }
};

/// @throws InputError if a coordinate is not finite or an index is out of range (readers report these with their line), or if
/// there is too much to count: 2^32 - 1 points, faces, or sides of triangles and segments, or 2^30 - 1 triangles.
/// Exact: yes. Cost: O(n log n) in corners; a polygon of m corners that is no triangle costs up to O(m^2) exact signs.
/// @param tolerance clusters of points that steps of at most this connect are one point each, that of the lowest index; 0: only
///   points that are equal are one. A cluster wider than twice this is an InputError.
/// @throws PreconditionError unless Polygons::first ascends from 0 to the number of corners
Mesh make_mesh(std::vector<Point3> points, const Polygons& polygons, double tolerance = 0);
/// Of faces in flat arrays: face f has the corners corners[first[f]] ... corners[first[f + 1] - 1], so there is one `first` more
/// than faces.
/// @throws InputError, PreconditionError as above
Mesh make_mesh(std::span<const Point3> points, std::span<const std::uint32_t> corners, std::span<const std::uint32_t> first);
/// Of triangles.
/// @throws InputError as above
Mesh make_mesh(std::span<const Point3> points, std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace hsr
