#pragma once

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>
#include <array>
#include <cstddef>
#include <cstdint>
#include <gp_Pnt.hxx>
#include <vector>

#include "hsr/edge_marks.h"
#include "hsr/known_shapes.h"

namespace hsr::internal {

/// The mesh of one shape where it was defined, whatever places it.
struct ShapeMesh {
  std::vector<gp_Pnt> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> face_of;                  ///< by triangle: index into faces
  std::vector<std::array<std::uint32_t, 2>> segments;  ///< of edges that no face has
  std::vector<MarkedEdge> marks;                       ///< object: 0
  std::vector<KnownSurface> faces;
  std::vector<KnownCircle> circles;
  std::size_t faces_without_mesh = 0;
};

/// Cuts the faces and edges of a shape into triangles and chords.
/// @param chord how far these are from them, at most
/// @param faces all faces of the shape, in the order in which ShapeMesh::faces has them, from 1 @param shape without a location
ShapeMesh mesh_of(const TopoDS_Shape& shape, const TopTools_IndexedMapOfShape& faces, double chord);

/// Has each edge know whether its faces are tangent there, for mesh_of(). Not for two threads at once.
void find_tangent_edges(const TopoDS_Shape& shape);

}  // namespace hsr::internal
