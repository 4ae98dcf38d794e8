// A gear, a flange and a spring: prisms, bodies of revolution and swept bodies with teeth, holes and turns.
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepLib.hxx>
#include <BRepOffsetAPI_MakePipeShell.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <GCE2d_MakeSegment.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopoDS_Wire.hxx>
#include <cmath>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <numbers>

#include "tests/step/shapes.h"

namespace hsr::shapes {

namespace {

gp_Pnt at(double radius, double angle) { return {radius * std::cos(angle), radius * std::sin(angle), 0}; }

TopoDS_Edge arc(const gp_Pnt& a, const gp_Pnt& b, const gp_Pnt& c) {
  return BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(a, b, c).Value()).Edge();
}

TopoDS_Shape drilled(const TopoDS_Shape& shape, double x, double y, double radius) {
  return BRepAlgoAPI_Cut(shape, BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, y, -1), gp_Dir(0, 0, 1)), radius, 60).Shape());
}

/// The angle by which an involute has turned where it is that far out.
double involute(double base, double radius) {
  const double t = std::sqrt(radius * radius / (base * base) - 1);
  return t - std::atan(t);
}

/// One flank, from the circle of its base to the tip. @param way 1: turned counter-clockwise with the radius, -1: clockwise
TopoDS_Edge flank(double base, double tip, double angle, double way) {
  TColgp_Array1OfPnt points(1, 9);
  for (int k = 0; k < 9; ++k) {
    const double radius = base + (tip - base) * k / 8;
    points(k + 1) = at(radius, angle + way * involute(base, radius));
  }
  const Handle(Geom_Curve) curve(GeomAPI_PointsToBSpline(points).Curve());
  return BRepBuilderAPI_MakeEdge(curve).Edge();
}

}  // namespace

TopoDS_Shape gear() {
  constexpr int teeth = 16;
  constexpr double pitch = 16, tip = 18, root = 13.5, step = 2 * std::numbers::pi / teeth;
  const double base = pitch * std::cos(20 * std::numbers::pi / 180);
  const double half = step / 4 + involute(base, pitch), turned = involute(base, tip);
  BRepBuilderAPI_MakeWire wire;
  for (int k = 0; k < teeth; ++k) {
    const double middle = k * step, low = middle - half, high = middle + half, next = low + step;
    wire.Add(BRepBuilderAPI_MakeEdge(at(root, low), at(base, low)).Edge());
    wire.Add(flank(base, tip, low, 1));
    wire.Add(arc(at(tip, low + turned), at(tip, middle), at(tip, high - turned)));
    wire.Add(flank(base, tip, high, -1));
    wire.Add(BRepBuilderAPI_MakeEdge(at(base, high), at(root, high)).Edge());
    wire.Add(arc(at(root, high), at(root, (high + next) / 2), at(root, next)));
  }
  const TopoDS_Shape body = BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire.Wire()).Face(), gp_Vec(0, 0, 8)).Shape();
  return drilled(body, 0, 0, 5);
}

TopoDS_Shape flange() {
  const auto point = [](double x, double z) { return gp_Pnt(x, 0, z); };
  const auto line = [&](double x, double z, double to_x, double to_z) {
    return BRepBuilderAPI_MakeEdge(point(x, z), point(to_x, to_z)).Edge();
  };
  // A disc, and a hub with a groove of radius 3 at its foot.
  BRepBuilderAPI_MakeWire wire;
  wire.Add(line(10, 0, 35, 0));
  wire.Add(line(35, 0, 35, 8));
  wire.Add(line(35, 8, 19, 8));
  wire.Add(arc(point(19, 8), point(19 - 3 * std::sqrt(0.5), 11 - 3 * std::sqrt(0.5)), point(16, 11)));
  wire.Add(line(16, 11, 14, 30));
  wire.Add(line(14, 30, 10, 30));
  wire.Add(line(10, 30, 10, 0));
  TopoDS_Shape shape =
      BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeFace(wire.Wire()).Face(), gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1))).Shape();
  for (int k = 0; k < 6; ++k) {
    const gp_Pnt hole = at(27, (k + 0.5) * std::numbers::pi / 3);
    shape = drilled(shape, hole.X(), hole.Y(), 3.5);
  }
  return shape;
}

TopoDS_Shape spring() {
  constexpr double radius = 12, rise = 9, turns = 2.5;
  const Handle(Geom_CylindricalSurface) around = new Geom_CylindricalSurface(gp_Ax3(), radius);
  const gp_Pnt2d from(0, 0), to(2 * std::numbers::pi * turns, rise * turns);
  const TopoDS_Edge helix = BRepBuilderAPI_MakeEdge(GCE2d_MakeSegment(from, to).Value(), around).Edge();
  BRepLib::BuildCurve3d(helix);
  BRepOffsetAPI_MakePipeShell swept(BRepBuilderAPI_MakeWire(helix).Wire());
  swept.SetMode(true);
  const gp_Dir along(0, 2 * std::numbers::pi * radius, rise);
  swept.Add(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(gp_Pnt(radius, 0, 0), along), 2)).Edge()).Wire());
  swept.Build();
  swept.MakeSolid();
  return swept.Shape();
}

}  // namespace hsr::shapes
