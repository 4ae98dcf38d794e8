#pragma once

#include "geometry/mesh.h"

namespace hsr {

/// The planar pieces that hide and are seen: a planar face, or one triangle of a face that is cut. Named by its first triangle.
inline TriangleId facet_of(const Mesh& mesh, TriangleId t) {
  const FaceId f = mesh.face_of[t];
  return mesh.faces[f] == FaceUse::planar ? TriangleId(mesh.first_triangle[f]) : t;
}
/// One past the last triangle of the facet that is named by t.
inline TriangleId facet_end(const Mesh& mesh, TriangleId t) {
  const FaceId f = mesh.face_of[t];
  return mesh.faces[f] == FaceUse::planar ? TriangleId(mesh.first_triangle[FaceId(f.value + 1U)]) : TriangleId(t.value + 1U);
}

}  // namespace hsr
