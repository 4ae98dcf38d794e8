#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepLib.hxx>
#include <Geom_BezierSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Wire.hxx>
#include <array>
#include <initializer_list>

#include "tests/step/shapes.h"

namespace hsr::shapes {

namespace {

constexpr double half_width = 30, length = 40, height = 10, rise = 25;

/// Half of a barrel roof. Along u from the middle to the gable, along v over the arch.
Handle(Geom_BezierSurface) half_of_roof(double side, double first_step) {
  const std::array<double, 5> across = {0, first_step, 0.25, 0.6, 1};  // shares of the width
  const std::array<double, 3> arch = {0, 1, 0};                        // of the rise
  TColgp_Array2OfPnt poles(1, 5, 1, 3);
  for (int i = 0; i < 5; ++i)
    for (int k = 0; k < 3; ++k) {
      const double x = side * half_width * across[static_cast<std::size_t>(i)];
      poles(i + 1, k + 1) = gp_Pnt(x, length * k / 2, height + rise * arch[static_cast<std::size_t>(k)]);
    }
  return new Geom_BezierSurface(poles);
}

}  // namespace

TopoDS_Shape ridge(double first_step) {
  BRepBuilderAPI_Sewing sewing(1e-6);
  const double w = half_width;
  for (const double side : {-1.0, 1.0}) {
    const Handle(Geom_BezierSurface) roof = half_of_roof(side, first_step);
    sewing.Add(BRepBuilderAPI_MakeFace(roof, 1e-7).Face());
    const double x = side * w;
    BRepBuilderAPI_MakeWire gable(BRepBuilderAPI_MakeEdge(Handle(Geom_Curve)(roof->UIso(1))).Edge());
    gable.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(x, length, height), gp_Pnt(x, length, 0)).Edge());
    gable.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(x, length, 0), gp_Pnt(x, 0, 0)).Edge());
    gable.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(x, 0, 0), gp_Pnt(x, 0, height)).Edge());
    sewing.Add(BRepBuilderAPI_MakeFace(gable.Wire()).Face());
  }
  const auto wall = [&](std::initializer_list<gp_Pnt> corners) {
    BRepBuilderAPI_MakePolygon polygon;
    for (const gp_Pnt& p : corners) polygon.Add(p);
    polygon.Close();
    sewing.Add(BRepBuilderAPI_MakeFace(polygon.Wire()).Face());
  };
  for (const double side : {-1.0, 1.0}) wall({{0, 0, 0}, {side * w, 0, 0}, {side * w, length, 0}, {0, length, 0}});
  // Each of the other two in halves, whose edges end where those of the roof do.
  for (const double y : {0.0, length})
    for (const double side : {-1.0, 1.0}) wall({{0, y, 0}, {side * w, y, 0}, {side * w, y, height}, {0, y, height}});
  sewing.Perform();
  TopExp_Explorer shell(sewing.SewedShape(), TopAbs_SHELL);
  TopoDS_Solid solid = BRepBuilderAPI_MakeSolid(TopoDS::Shell(shell.Current())).Solid();
  BRepLib::OrientClosedSolid(solid);
  return solid;
}

}  // namespace hsr::shapes
