#include <BRepAdaptor_Curve.hxx>
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
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "hsr/drawing/drawing.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/step/step.h"
#include "tests/io/read/temporary_directory.h"
#include "tests/step/shapes.h"

// Drawings of shapes compared with those of Open CASCADE's exact hidden-line removal, which knows the surfaces themselves. What may
// differ, and why, is in docs/decisions/20-step.md.

namespace hsr {
namespace {

/// Lengths on paper in units of the model.
struct Lengths {
  double edges = 0;   ///< visible outlines and sharp edges
  double smooth = 0;  ///< visible tangent edges
};

double length_of(const TopoDS_Shape& lines) {
  if (lines.IsNull()) return 0;
  BRepLib::BuildCurves3d(lines);
  double sum = 0;
  for (TopExp_Explorer at(lines, TopAbs_EDGE); at.More(); at.Next()) {
    BRepAdaptor_Curve curve(TopoDS::Edge(at.Current()));
    sum += GCPnts_AbscissaPoint::Length(curve);
  }
  return sum;
}

/// It draws seams as edges that are tangent, unless they are more than that.
void leave_out_seams(const TopoDS_Shape& shape) {
  for (TopExp_Explorer f(shape, TopAbs_FACE); f.More(); f.Next()) {
    const TopoDS_Face& face = TopoDS::Face(f.Current());
    for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next()) {
      const TopoDS_Edge& edge = TopoDS::Edge(e.Current());
      if (BRep_Tool::IsClosed(edge, face)) BRep_Builder().Continuity(edge, face, face, GeomAbs_CN);
    }
  }
}

Lengths by_occt(const TopoDS_Shape& shape, const View& view) {
  BRepLib::EncodeRegularity(shape, 0.01);
  leave_out_seams(shape);
  const Frame& f = view.frame;
  const gp_Dir right(f.right.x, f.right.y, f.right.z), up(f.up.x, f.up.y, f.up.z);
  const Handle(HLRBRep_Algo) algorithm = new HLRBRep_Algo;
  algorithm->Add(shape);
  algorithm->Projector(HLRAlgo_Projector(gp_Ax2(gp_Pnt(0, 0, 0), right.Crossed(up), right)));
  algorithm->Update();
  algorithm->Hide();
  HLRBRep_HLRToShape found(algorithm);
  return {length_of(found.VCompound()) + length_of(found.OutLineVCompound()), length_of(found.Rg1LineVCompound())};
}

Lengths by_hsr(const TopoDS_Shape& shape, const View& view, double chord) {
  const test::TemporaryDirectory directory;
  shapes::write_step(shape, directory.file("part.step"));
  const Model model = read_brep(directory.file("part.step")).tessellated(chord);
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

/// @param ends how many ends of lines are where one surface goes behind another @param radius of these, the largest
void compare(const std::string& name, const TopoDS_Shape& shape, double ends, double radius) {
  const View view = parallel_view({1, -0.7, 0.8}, {0, 0, 1});
  const Lengths expected = by_occt(shape, view);
  for (const double chord : {0.02, 0.002}) {
    const Lengths found = by_hsr(shape, view, chord);
    INFO(name << ", chord " << chord << ": edges " << found.edges << ", OCCT " << expected.edges << "; smooth " << found.smooth
              << ", OCCT " << expected.smooth);
    const double tolerance = ends * std::sqrt(2 * radius * chord);
    CHECK(std::fabs(found.edges - expected.edges) <= tolerance);
    // A tangent edge that runs along just behind an outline, or before it, is hidden or visible in one piece.
    if (chord < 0.01) CHECK(std::fabs(found.smooth - expected.smooth) <= tolerance);
  }
}

TEST_CASE("visible lines are as long as those of Open CASCADE's exact hidden-line removal", "[step][peer]") {
  compare("plate", shapes::plate(), 20, 6);
  compare("cylinder", shapes::cylinder(), 4, 10);
  compare("pipe", shapes::pipe(), 10, 20);
  compare("loft", shapes::loft(), 10, 20);
  compare("bottle", shapes::bottle(), 20, 40);
}

}  // namespace
}  // namespace hsr
