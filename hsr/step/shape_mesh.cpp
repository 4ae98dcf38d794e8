#include "hsr/step/shape_mesh.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Poly_Polygon3D.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <gp_Ax1.hxx>
#include <gp_Circ.hxx>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>
#include <gp_Sphere.hxx>
#include <gp_Torus.hxx>
#include <optional>

namespace hsr::internal {

namespace {

constexpr double tangent_angle = 0.01;  // radians: what CAD programs call tangent is so to a tenth of a degree or two
constexpr double most_turn = 0.35;      // radians between two chords of an edge, however small it is
constexpr std::uint32_t none = 0xffffffffU;

Point3 point_of(const gp_Pnt& p) { return {p.X(), p.Y(), p.Z()}; }
Point3 point_of(const gp_Dir& d) { return {d.X(), d.Y(), d.Z()}; }

KnownSurface known(SurfaceKind kind, const gp_Ax1& axis, double radius = 0) {
  return {kind, point_of(axis.Location()), point_of(axis.Direction()), radius};
}

KnownSurface surface_of(const TopoDS_Face& face) {
  const BRepAdaptor_Surface surface(face);
  switch (surface.GetType()) {
    case GeomAbs_Plane:
      return known(SurfaceKind::plane, surface.Plane().Axis());
    case GeomAbs_Cylinder:
      return known(SurfaceKind::cylinder, surface.Cylinder().Axis(), surface.Cylinder().Radius());
    case GeomAbs_Cone:
      return known(SurfaceKind::cone, surface.Cone().Axis());
    case GeomAbs_Sphere:
      return known(SurfaceKind::sphere, surface.Sphere().Position().Axis(), surface.Sphere().Radius());
    case GeomAbs_Torus:
      return known(SurfaceKind::torus, surface.Torus().Axis());
    case GeomAbs_SurfaceOfRevolution:
      return known(SurfaceKind::revolution, surface.AxeOfRevolution());
    default:
      return {};
  }
}

/// Puts the triangles of all faces together, so that faces that share an edge share its points.
class Stitcher {
 public:
  Stitcher(const TopoDS_Shape& shape, const TopTools_IndexedMapOfShape& faces) : faces_(faces) {
    TopExp::MapShapes(shape, TopAbs_EDGE, edges_);
    TopExp::MapShapes(shape, TopAbs_VERTEX, vertices_);
    TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces_at_);
    points_of_edges_.resize(static_cast<std::size_t>(edges_.Extent()));
    points_of_vertices_.resize(static_cast<std::size_t>(vertices_.Extent()), none);
  }

  ShapeMesh stitched() {
    for (int f = 1; f <= faces_.Extent(); ++f) add(TopoDS::Face(faces_(f)), static_cast<std::uint32_t>(f - 1));
    for (int e = 1; e <= edges_.Extent(); ++e) mark(TopoDS::Edge(edges_(e)), points_of_edges_[static_cast<std::size_t>(e - 1)]);
    return std::move(mesh_);
  }

 private:
  void add(const TopoDS_Face& face, std::uint32_t number) {
    mesh_.faces.push_back(surface_of(face));
    TopLoc_Location location;
    const Handle(Poly_Triangulation) triangles = BRep_Tool::Triangulation(face, location);
    if (triangles.IsNull() || triangles->NbTriangles() == 0) {
      ++mesh_.faces_without_mesh;
      return;
    }
    point_of_node_.assign(static_cast<std::size_t>(triangles->NbNodes()) + 1, none);
    const auto placed = [&](int node) { return triangles->Node(node).Transformed(location.Transformation()); };
    for (TopExp_Explorer at(face, TopAbs_EDGE); at.More(); at.Next()) {
      const TopoDS_Edge& edge = TopoDS::Edge(at.Current());
      const Handle(Poly_PolygonOnTriangulation) nodes = BRep_Tool::PolygonOnTriangulation(edge, triangles, location);
      if (!nodes.IsNull()) add(edge, *nodes, placed);
    }
    for (int node = 1; node <= triangles->NbNodes(); ++node)
      if (std::uint32_t& point = point_of_node_[static_cast<std::size_t>(node)]; point == none) point = new_point(placed(node));
    for (int t = 1; t <= triangles->NbTriangles(); ++t) {
      std::array<std::uint32_t, 3> corners;
      for (std::size_t k = 0; k < 3; ++k)
        corners[k] = point_of_node_[static_cast<std::size_t>(triangles->Triangle(t)(static_cast<int>(k) + 1))];
      if (face.Orientation() == TopAbs_REVERSED) std::swap(corners[1], corners[2]);
      if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
      mesh_.triangles.push_back(corners);
      mesh_.face_of.push_back(number);
    }
  }

  std::uint32_t new_point(const gp_Pnt& p) {
    mesh_.points.push_back(p);
    return static_cast<std::uint32_t>(mesh_.points.size() - 1);
  }

  /// The points of an edge along a face: those that another face gave it, if one did.
  template <class Placed>
  void add(const TopoDS_Edge& edge, const Poly_PolygonOnTriangulation& nodes, const Placed& placed) {
    std::vector<std::uint32_t>& points = points_of_edges_[static_cast<std::size_t>(edges_.FindIndex(edge) - 1)];
    TopoDS_Vertex first, last;
    TopExp::Vertices(TopoDS::Edge(edge.Oriented(TopAbs_FORWARD)), first, last);
    const int count = nodes.NbNodes();
    const bool is_point = BRep_Tool::Degenerated(edge);
    const bool is_known = static_cast<int>(points.size()) == count;
    std::vector<std::uint32_t> here;
    for (int k = 1; k <= count; ++k) {
      const int node = nodes.Nodes()(k);
      std::uint32_t& point = point_of_node_[static_cast<std::size_t>(node)];
      const TopoDS_Vertex& end = k == 1 || is_point ? first : last;
      if ((k == 1 || k == count || is_point) && !end.IsNull()) {
        std::uint32_t& of_vertex = points_of_vertices_[static_cast<std::size_t>(vertices_.FindIndex(end) - 1)];
        if (of_vertex == none) of_vertex = new_point(placed(node));
        point = of_vertex;
      } else if (is_known) {
        point = points[static_cast<std::size_t>(k - 1)];
      } else if (point == none) {
        point = new_point(placed(node));
      }
      here.push_back(point);
    }
    if (points.empty() && !is_point) points = std::move(here);
  }

  void mark(const TopoDS_Edge& edge, const std::vector<std::uint32_t>& points) {
    if (BRep_Tool::Degenerated(edge)) return;
    const TopTools_ListOfShape& at = faces_at_.FindFromKey(edge);
    if (at.IsEmpty()) {
      add_wire(edge);
      return;
    }
    const std::optional<EdgeMark> found = mark_of(edge, at);
    if (!found || points.size() < 2) return;
    const std::uint32_t circle = circle_of(edge);
    for (std::size_t k = 0; k + 1 < points.size(); ++k)
      if (points[k] != points[k + 1]) mesh_.marks.push_back({{points[k], points[k + 1]}, *found, 0, circle});
  }

  /// Nothing: the border of an open shell, a seam, or an edge of three faces or more.
  static std::optional<EdgeMark> mark_of(const TopoDS_Edge& edge, const TopTools_ListOfShape& at) {
    std::vector<TopoDS_Face> faces;
    for (const TopoDS_Shape& face : at) faces.push_back(TopoDS::Face(face));
    const TopoDS_Face &f = faces.front(), &g = faces.back();
    const bool is_seam = std::all_of(faces.begin(), faces.end(), [&](const TopoDS_Face& x) { return x.IsSame(f); });
    if (is_seam ? !BRep_Tool::IsClosed(edge, f) : faces.size() != 2) return std::nullopt;
    const bool is_tangent = BRep_Tool::HasContinuity(edge, f, g) && BRep_Tool::Continuity(edge, f, g) >= GeomAbs_G1;
    if (is_tangent) return is_seam ? EdgeMark::inner : EdgeMark::smooth;
    return EdgeMark::sharp;
  }

  std::uint32_t circle_of(const TopoDS_Edge& edge) {
    const BRepAdaptor_Curve curve(edge);
    if (curve.GetType() != GeomAbs_Circle) return none;
    const gp_Circ circle = curve.Circle();
    mesh_.circles.push_back({point_of(circle.Location()), point_of(circle.Axis().Direction()), circle.Radius()});
    return static_cast<std::uint32_t>(mesh_.circles.size() - 1);
  }

  void add_wire(const TopoDS_Edge& edge) {
    TopLoc_Location location;
    const Handle(Poly_Polygon3D) nodes = BRep_Tool::Polygon3D(edge, location);
    if (nodes.IsNull()) return;
    std::uint32_t last = none;
    for (int k = 1; k <= nodes->NbNodes(); ++k) {
      const std::uint32_t point = new_point(nodes->Nodes()(k).Transformed(location.Transformation()));
      if (last != none) mesh_.segments.push_back({last, point});
      last = point;
    }
  }

  const TopTools_IndexedMapOfShape& faces_;
  TopTools_IndexedMapOfShape edges_, vertices_;
  TopTools_IndexedDataMapOfShapeListOfShape faces_at_;
  std::vector<std::vector<std::uint32_t>> points_of_edges_;
  std::vector<std::uint32_t> points_of_vertices_, point_of_node_;
  ShapeMesh mesh_;
};

}  // namespace

void find_tangent_edges(const TopoDS_Shape& shape) { BRepLib::EncodeRegularity(shape, tangent_angle); }

ShapeMesh mesh_of(const TopoDS_Shape& shape, const TopTools_IndexedMapOfShape& faces, double chord) {
  BRepTools::Clean(shape);
  IMeshTools_Parameters parameters;
  parameters.Deflection = chord;
  parameters.Angle = most_turn;
  parameters.InParallel = true;
  BRepMesh_IncrementalMesh mesher(shape, parameters);
  return Stitcher(shape, faces).stitched();
}

}  // namespace hsr::internal
