#include "bench/peers/occt_shape.h"

#include <BRep_Builder.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <array>
#include <cstdint>
#include <gp_Pln.hxx>

#include "geometry/disjoint_sets.h"

namespace hsr::bench {

using namespace internal;

namespace {

constexpr double tolerance = 1e-7;  // what OCCT gives to everything

gp_Pnt point(const Point3& p) { return {p.x, p.y, p.z}; }

std::vector<TopoDS_Edge> edges_of(const Mesh& mesh, const std::vector<Point3>& points) {
  const BRep_Builder builder;
  std::vector<TopoDS_Vertex> vertices(points.size());
  std::vector<TopoDS_Edge> edges;
  for (const Edge& edge : mesh.edges) {
    const gp_Pnt a = point(points[edge.a.value]), b = point(points[edge.b.value]);
    for (const VertexId v : {edge.a, edge.b})
      if (vertices[v.value].IsNull()) builder.MakeVertex(vertices[v.value], point(points[v.value]), tolerance);
    TopoDS_Edge& e = edges.emplace_back();
    builder.MakeEdge(e, new Geom_Line(a, gp_Dir(gp_Vec(a, b))), tolerance);
    builder.Add(e, vertices[edge.a.value].Oriented(TopAbs_FORWARD));
    builder.Add(e, vertices[edge.b.value].Oriented(TopAbs_REVERSED));
    builder.Range(e, 0, a.Distance(b));
  }
  return edges;
}

/// The edge from corner k to corner k + 1 of a triangle.
using Sides = std::array<EdgeId, 3>;

std::vector<Sides> sides_of(const Mesh& mesh) {
  std::vector<Sides> sides(mesh.triangles.size());
  for (std::size_t e = 0; e < mesh.edges.size(); ++e)
    for (const TriangleId t : mesh.triangles_at(EdgeId(e)))
      for (std::size_t k = 0; k < 3; ++k) {
        const VertexId from = mesh.triangles[t][k], to = mesh.triangles[t][(k + 1) % 3];
        if (mesh.edges[EdgeId(e)].a == std::min(from, to) && mesh.edges[EdgeId(e)].b == std::max(from, to))
          sides[t.value][k] = EdgeId(e);
      }
  return sides;
}

TopoDS_Face face_of(const Mesh& mesh, TriangleId t, const std::vector<Point3>& points, const Sides& sides,
                    const std::vector<TopoDS_Edge>& edges) {
  const BRep_Builder builder;
  const auto& corners = mesh.triangles[t];
  TColgp_Array1OfPnt nodes(1, 3);
  for (int k = 1; k <= 3; ++k) nodes.SetValue(k, point(points[corners[static_cast<std::size_t>(k - 1)].value]));
  Poly_Array1OfTriangle one(1, 1);
  one.SetValue(1, Poly_Triangle(1, 2, 3));
  const Handle(Poly_Triangulation) triangulation = new Poly_Triangulation(nodes, one);

  const gp_Vec along(nodes(1), nodes(2)), normal = along.Crossed(gp_Vec(nodes(1), nodes(3)));
  TopoDS_Face face;
  builder.MakeFace(face, new Geom_Plane(gp_Ax3(nodes(1), gp_Dir(normal), gp_Dir(along))), tolerance);
  builder.UpdateFace(face, triangulation);
  TopoDS_Wire ring;
  builder.MakeWire(ring);
  for (std::size_t k = 0; k < 3; ++k) {
    const TopoDS_Edge& edge = edges[sides[k].value];
    const int from = static_cast<int>(k) + 1, to = from % 3 + 1;
    const bool forward = mesh.edges[sides[k]].a == corners[k];
    builder.Add(ring, edge.Oriented(forward ? TopAbs_FORWARD : TopAbs_REVERSED));
    TColStd_Array1OfInteger ends(1, 2);
    ends.SetValue(1, forward ? from : to);
    ends.SetValue(2, forward ? to : from);
    TColStd_Array1OfReal parameters(1, 2);
    parameters.SetValue(1, 0);
    parameters.SetValue(2, nodes(from).Distance(nodes(to)));
    builder.UpdateEdge(edge, new Poly_PolygonOnTriangulation(ends, parameters), triangulation);
  }
  ring.Closed(true);
  builder.Add(face, ring);
  return face;
}

TopoDS_Compound compound_of(const std::vector<TopoDS_Shape>& shapes) {
  const BRep_Builder builder;
  TopoDS_Compound all;
  builder.MakeCompound(all);
  for (const TopoDS_Shape& shape : shapes) builder.Add(all, shape);
  return all;
}

/// A shell for each connected component, turned outward if it is closed. A triangle alone stays a face: OCCT goes through all
/// faces of the shape once for each shell.
std::vector<TopoDS_Shape> shells_of(const Mesh& mesh, const std::vector<Point3>& points,
                                    const std::vector<TopoDS_Shape>& faces) {
  DisjointSets components(mesh.triangles.size());
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const auto triangles = mesh.triangles_at(EdgeId(e));
    for (const TriangleId t : triangles) components.join(t.value, triangles.front().value);
  }
  // Six times the volume, negative if a closed component looks inward; from a point of its own, so that little cancels.
  std::vector<double> volume(mesh.triangles.size(), 0);
  std::vector<std::size_t> size(mesh.triangles.size(), 0);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t component = components.find(t);
    ++size[component];
    const auto& corners = mesh.triangles[TriangleId(t)];
    const gp_Pnt origin = point(points[mesh.triangles[TriangleId(component)][0].value]);
    const auto from_origin = [&](std::size_t k) { return gp_Vec(origin, point(points[corners[k].value])); };
    volume[component] += from_origin(0).Dot(from_origin(1).Crossed(from_origin(2)));
  }

  const BRep_Builder builder;
  std::vector<TopoDS_Shape> shells;
  std::vector<std::size_t> place(mesh.triangles.size());  // in `shells`, of each component
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t component = components.find(t);
    if (size[component] == 1) {
      shells.push_back(faces[t]);
      continue;
    }
    if (component == t) {  // the least triangle stands for its component
      TopoDS_Shell shell;
      builder.MakeShell(shell);
      place[t] = shells.size();
      shells.push_back(shell);
    }
    builder.Add(shells[place[component]], volume[component] < 0 ? faces[t].Reversed() : faces[t]);
  }
  return shells;
}

}  // namespace

OcctShape::OcctShape(const Mesh& mesh, const std::vector<Point3>& points, OcctFaces put_together) {
  const std::vector<TopoDS_Edge> of_edges = edges_of(mesh, points);
  for (const TopoDS_Edge& e : of_edges) edges.Add(e);
  const std::vector<Sides> sides = sides_of(mesh);
  std::vector<TopoDS_Shape> faces;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    faces.push_back(face_of(mesh, TriangleId(t), points, sides[t], of_edges));
  shape = compound_of(put_together == OcctFaces::in_shells ? shells_of(mesh, points, faces) : faces);
}

}  // namespace hsr::bench
