#pragma once

#include <array>
#include <cstddef>

#include "geometry/bit_range.h"
#include "geometry/mesh.h"

namespace hsr::internal {

/// What a scene is, counted. Exact: coplanar, straight and equal mean just that.
struct SceneFacts {
  std::size_t points = 0;           ///< as given
  std::size_t distinct_points = 0;  ///< positions among them
  std::size_t used_points = 0;      ///< positions at a triangle or a wire
  Point3 lowest, highest;           ///< the bounding box of the used points; zero if there are none
  BitRange coordinates;             ///< of the used points: bits() is what exact arithmetic needs

  std::size_t faces = 0;                                     ///< as given
  std::size_t triangular = 0, quadrangular = 0, larger = 0;  ///< by corners as given; the rest has fewer than three
  std::array<std::size_t, face_use_count> used_as = {};      ///< by FaceUse
  std::size_t duplicate_faces = 0;                           ///< used, with the vertices of an earlier face that is used
  std::size_t axis_parallel_faces = 0;                       ///< used, one coordinate the same at all corners
  std::size_t triangles = 0, wires = 0;
  std::size_t components = 0;  ///< of the faces, connected by common vertices

  // Edges of faces, by the number of their sides; a diagonal of a face that was cut is none.
  std::size_t boundary_edges = 0;      ///< one
  std::size_t regular_edges = 0;       ///< two
  std::size_t non_manifold_edges = 0;  ///< three and more
  std::size_t odd_edges = 0;           ///< one, three, five ...
  std::size_t flipped_edges = 0;       ///< regular, the two sides oriented differently
  std::size_t coplanar_edges = 0;      ///< regular, both sides in one plane
  std::size_t pinched_vertices = 0;    ///< the triangles around it hang together by more than one fan

  bool is_closed() const { return triangles > 0 && odd_edges == 0; }
  bool is_manifold() const { return non_manifold_edges == 0 && pinched_vertices == 0; }
  bool is_consistently_oriented() const { return flipped_edges == 0; }
  std::size_t faces_used() const {
    return faces - used_as[static_cast<std::size_t>(FaceUse::no_area)] - used_as[static_cast<std::size_t>(FaceUse::ghost)];
  }
};

/// @pre `mesh` was made of `polygons`. Cost: O(n log n)
SceneFacts scene_facts(const Mesh& mesh, const Polygons& polygons);

}  // namespace hsr::internal
