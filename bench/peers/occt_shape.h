#pragma once

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Ax2.hxx>
#include <vector>

#include "geometry/mesh.h"

namespace hsr::bench {

/// A mesh as OCCT is best served with: each triangle a planar face that has itself as its triangulation; faces share the B-Rep
/// edge where triangles share one; each connected component is a shell, turned outward if it is closed.
///
/// Measured against all faces free in one compound, which is how OCCT itself makes a shape of a mesh: the same lines, but the
/// box of a shell saves the tests of its faces (of a city 3.5 times faster), and of a closed shell the back faces are left out
/// (of a knot 1.5 times faster). Turned inward, the back of a closed shell is drawn. A single face with the whole triangulation
/// has no edges inside it, only outlines.
struct OcctShape {
  TopoDS_Shape shape;
  TopTools_IndexedMapOfShape edges;  ///< the number of a shape in it is one more than the edge of the mesh

  /// @param points where the vertices of the mesh are
  OcctShape(const Mesh& mesh, const std::vector<Point3>& points);
};

}  // namespace hsr::bench
