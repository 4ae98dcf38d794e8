#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "geometry/mesh.h"

namespace hsr::internal {

/// The planar piece that hides and is seen, in which a triangle lies: a planar face, or the triangle of a face that is cut.
inline FacetId facet_of(const Mesh& mesh, TriangleId t) {
  const FaceId f = mesh.face_of[t];
  return FacetId(mesh.faces[f] == FaceUse::planar ? mesh.first_triangle[f] : t.value);
}
/// One past the last triangle of the facet.
inline TriangleId facet_end(const Mesh& mesh, FacetId facet) {
  const FaceId f = mesh.face_of[first_triangle(facet)];
  return TriangleId(mesh.faces[f] == FaceUse::planar ? mesh.first_triangle[FaceId(f.value + 1U)] : facet.value + 1U);
}
inline std::uint32_t triangle_count(const Mesh& mesh, FacetId facet) { return facet_end(mesh, facet).value - facet.value; }
/// Whether a triangle is the first of its facet.
inline bool is_first(const Mesh& mesh, TriangleId t) { return first_triangle(facet_of(mesh, t)) == t; }

/// Whether the side of t from corner k to the next is a diagonal within its planar face: no edge of the face.
inline bool is_inner_diagonal(const Mesh& mesh, TriangleId t, std::size_t k) {
  if (triangle_count(mesh, facet_of(mesh, t)) == 1) return false;
  const auto& c = mesh.triangles[t];
  const EdgeId e = mesh.find_edge(c[k], c[(k + 1) % 3]);
  if (!e.is_valid()) return true;
  const auto own = mesh.triangles_at(e);
  return std::find(own.begin(), own.end(), t) == own.end();
}

/// Whether the side of t from corner k to the next is an edge of its face: no diagonal by which the face was cut.
inline bool is_edge_of_face(const Mesh& mesh, TriangleId t, std::size_t k) {
  if (is_inner_diagonal(mesh, t, k)) return false;
  const auto& c = mesh.triangles[t];
  const EdgeId e = mesh.find_edge(c[k], c[(k + 1) % 3]);
  return !e.is_valid() || mesh.edges[e].of_face || !mesh.edges[e].diagonal;
}

/// Whether a ring of corners goes around a whole face, so that all of its sides are edges of it: rings of planar faces have two
/// corners more than the face has triangles.
inline bool goes_around_face(const Mesh& mesh, FacetId facet, std::size_t corners) {
  return mesh.faces[mesh.face_of[first_triangle(facet)]] == FaceUse::planar &&
         corners == std::size_t{triangle_count(mesh, facet)} + 2;
}

}  // namespace hsr::internal
