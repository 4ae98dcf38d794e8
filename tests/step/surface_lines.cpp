#include "tests/step/surface_lines.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <HLRAlgo_Projector.hxx>
#include <HLRBRep_Algo.hxx>
#include <HLRBRep_HLRToShape.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <cmath>

#include "hsr/drawing/drawing.h"
#include "hsr/lines/visible_lines.h"
#include "tests/step/shapes.h"

namespace hsr::shapes {

namespace {

double length_of(const std::vector<TopoDS_Shape>& lines) {
  double sum = 0;
  for (const TopoDS_Shape& some : lines) {
    for (TopExp_Explorer at(some, TopAbs_EDGE); at.More(); at.Next()) {
      BRepAdaptor_Curve curve(TopoDS::Edge(at.Current()));
      sum += GCPnts_AbscissaPoint::Length(curve);
    }
  }
  return sum;
}

/// Open CASCADE draws seams as edges that are tangent, unless they are more than that.
void leave_out_seams(const TopoDS_Shape& shape) {
  for (TopExp_Explorer f(shape, TopAbs_FACE); f.More(); f.Next()) {
    const TopoDS_Face& face = TopoDS::Face(f.Current());
    for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next()) {
      const TopoDS_Edge& edge = TopoDS::Edge(e.Current());
      if (BRep_Tool::IsClosed(edge, face)) BRep_Builder().Continuity(edge, face, face, GeomAbs_CN);
    }
  }
}

}  // namespace

std::vector<ComparedShape> compared_shapes() {
  return {{"plate", plate(), 20, 6},       {"cylinder", cylinder(), 4, 10},
          {"pipe", pipe(), 4, 20, 1},      {"loft", loft(), 4, 20},
          {"bottle", bottle(), 20, 40},    {"gear", gear(), 10, 10},
          {"flange", flange(), 10, 35},    {"spring", spring(), 10, 12, 5},
          {"ridge", ridge(0.1), 4, 20, 1}, {"slow ridge", ridge(0.0002), 4, 20, 1, true},
          {"assembly", assembly(), 20, 6}};
}

View compared_view() { return parallel_view({1, -0.7, 0.8}, {0, 0, 1}); }

double bound_of(const ComparedShape& compared, double chord) {
  return compared.ends * std::sqrt(2 * compared.radius * chord) +
         compared.detours * 2 * std::cbrt(compared.radius * compared.radius * chord);
}

SurfaceLines::SurfaceLines(const TopoDS_Shape& shape) : shape_(BRepBuilderAPI_Copy(shape).Shape()) {
  BRepLib::EncodeRegularity(shape_, 0.01);
  leave_out_seams(shape_);
}

void SurfaceLines::find(const View& view) {
  const Frame& f = view.frame;
  const gp_Dir right(f.right.x, f.right.y, f.right.z), up(f.up.x, f.up.y, f.up.z);
  const Handle(HLRBRep_Algo) algorithm = new HLRBRep_Algo;
  algorithm->Add(shape_);
  algorithm->Projector(HLRAlgo_Projector(gp_Ax2(gp_Pnt(0, 0, 0), right.Crossed(up), right)));
  algorithm->Update();
  algorithm->Hide();
  HLRBRep_HLRToShape found(algorithm);
  edges_.clear();
  smooth_.clear();
  const auto add = [](std::vector<TopoDS_Shape>& lines, const TopoDS_Shape& some) {
    if (some.IsNull()) return;
    BRepLib::BuildCurves3d(some);
    lines.push_back(some);
  };
  add(edges_, found.VCompound());
  add(edges_, found.OutLineVCompound());
  add(smooth_, found.Rg1LineVCompound());
}

Lengths SurfaceLines::lengths() const { return {length_of(edges_), length_of(smooth_)}; }

TopoDS_Shape SurfaceLines::visible() const {
  TopoDS_Compound all;
  BRep_Builder builder;
  builder.MakeCompound(all);
  for (const auto* lines : {&edges_, &smooth_})
    for (const TopoDS_Shape& some : *lines) builder.Add(all, some);
  return all;
}

Lengths lengths_by_hsr(const Model& model, const View& view) {
  const Mesh mesh = make_mesh(model.points, model.polygons);
  LineOptions options;
  options.classes.fill(true);
  const VisibleLines lines = visible_lines(SceneView(Scene::of(mesh, labels_of(model)), view), options);
  DrawingOptions page;
  page.leave_out_near = true;
  const Drawing drawing = draw(mesh, view, lines, page);
  Lengths lengths;
  for (const Polyline& p : drawing.polylines) {
    if (p.hidden) continue;
    const auto points = drawing.points_of(p);
    double sum = 0;
    for (std::size_t k = 0; k + 1 < points.size() + (p.closed ? 1 : 0); ++k) {
      const PaperPoint &a = points[k], &b = points[(k + 1) % points.size()];
      sum += std::hypot(static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y)) / 1000 / drawing.scale;
    }
    (p.edge_class == EdgeClass::smooth ? lengths.smooth : lengths.edges) += sum;
  }
  return lengths;
}

}  // namespace hsr::shapes
