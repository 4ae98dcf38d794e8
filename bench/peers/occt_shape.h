#pragma once

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Ax2.hxx>
#include <vector>

#include "geometry/mesh.h"

namespace hsr::bench {

/// How the faces of a mesh are put together.
enum class OcctFaces {
  in_shells,   ///< each component of several a shell, turned outward if it is closed: what OCCT is best served with
  in_compound  ///< all free in one compound, turned as in the mesh: what OCCT makes of a file of triangles
};

/// A mesh as a shape of OCCT: each triangle a planar face that has itself as its triangulation; faces share the B-Rep edge
/// where triangles share one.
///
/// What is visible is the same either way. The box of a shell saves the tests of its faces, and of a closed shell the back
/// faces are left out; turned inward, the back of a closed shell is drawn. A single face with the whole triangulation has no
/// edges inside it, only outlines.
struct OcctShape {
  TopoDS_Shape shape;
  TopTools_IndexedMapOfShape edges;  ///< the number of a shape in it is one more than the edge of the mesh

  /// @param points where the vertices of the mesh are
  OcctShape(const Mesh& mesh, const std::vector<Point3>& points, OcctFaces faces);
};

}  // namespace hsr::bench
