#include "tests/step/shapes.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepOffsetAPI_MakePipe.hxx>
#include <BRepOffsetAPI_MakeThickSolid.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <IGESControl_Writer.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPControl_Writer.hxx>
#include <TDF_Label.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <array>
#include <cmath>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <gp_Trsf.hxx>
#include <stdexcept>

namespace hsr::shapes {

namespace {

TopoDS_Face face(const TopoDS_Wire& wire) { return BRepBuilderAPI_MakeFace(wire).Face(); }

TopoDS_Wire square(double half, double z) {
  BRepBuilderAPI_MakePolygon polygon;
  for (const auto& [x, y] : {std::pair{-half, -half}, {half, -half}, {half, half}, {-half, half}}) polygon.Add(gp_Pnt(x, y, z));
  polygon.Close();
  return polygon.Wire();
}

gp_Ax2 upright(double x, double y, double z) { return {gp_Pnt(x, y, z), gp_Dir(0, 0, 1)}; }

TopoDS_Wire circle(const gp_Ax2& axes, double radius) {
  return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(axes, radius)).Edge()).Wire();
}

void check(bool is_done, const std::string& file) {
  if (!is_done) throw std::runtime_error("Open CASCADE cannot write " + file);
}

void say_nothing() { Message::DefaultMessenger()->ChangePrinters().Clear(); }

}  // namespace

TopoDS_Shape plate() {
  TopoDS_Shape shape = BRepPrimAPI_MakeBox(60, 40, 8).Shape();
  BRepFilletAPI_MakeFillet corners(shape);
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  for (int k = 1; k <= edges.Extent(); ++k) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges(k));
    const gp_Pnt a = BRep_Tool::Pnt(TopExp::FirstVertex(edge)), b = BRep_Tool::Pnt(TopExp::LastVertex(edge));
    if (std::fabs(a.Z() - b.Z()) > 1) corners.Add(6, edge);
    if (a.Z() > 7 && b.Z() > 7) corners.Add(2, edge);
  }
  shape = corners.Shape();
  for (const double x : {12.0, 30.0, 48.0})
    for (const double y : {12.0, 28.0})
      shape = BRepAlgoAPI_Cut(shape, BRepPrimAPI_MakeCylinder(upright(x, y, -1), 4, 10).Shape());
  return shape;
}

TopoDS_Shape bottle() {
  const double width = 50, thickness = 30, height = 70;
  const gp_Pnt p1(-width / 2, 0, 0), p2(-width / 2, -thickness / 4, 0), p3(0, -thickness / 2, 0),
      p4(width / 2, -thickness / 4, 0), p5(width / 2, 0, 0), p6(width / 2, thickness / 4, 0), p7(0, thickness / 2, 0),
      p8(-width / 2, thickness / 4, 0);
  BRepBuilderAPI_MakeWire wire;
  wire.Add(BRepBuilderAPI_MakeEdge(p1, p2).Edge());
  wire.Add(BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(p2, p3, p4).Value()).Edge());
  wire.Add(BRepBuilderAPI_MakeEdge(p4, p6).Edge());
  wire.Add(BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(p6, p7, p8).Value()).Edge());
  wire.Add(BRepBuilderAPI_MakeEdge(p8, p1).Edge());
  TopoDS_Shape body = BRepPrimAPI_MakePrism(face(wire.Wire()), gp_Vec(0, 0, height)).Shape();
  BRepFilletAPI_MakeFillet rounded(body);
  for (TopExp_Explorer at(body, TopAbs_EDGE); at.More(); at.Next()) rounded.Add(thickness / 12, TopoDS::Edge(at.Current()));
  body = rounded.Shape();
  body = BRepAlgoAPI_Fuse(body, BRepPrimAPI_MakeCylinder(upright(0, 0, height), thickness / 4, height / 10).Shape());
  TopTools_ListOfShape open;
  for (TopExp_Explorer at(body, TopAbs_FACE); at.More(); at.Next()) {
    const BRepAdaptor_Surface surface(TopoDS::Face(at.Current()));
    if (surface.GetType() == GeomAbs_Plane && std::fabs(surface.Plane().Location().Z() - height * 1.1) < 1e-6)
      open.Append(at.Current());
  }
  BRepOffsetAPI_MakeThickSolid hollow;
  hollow.MakeThickSolidByJoin(body, open, -thickness / 50, 1e-3);
  return hollow.Shape();
}

TopoDS_Shape loft() {
  BRepOffsetAPI_ThruSections sections(true, true);
  sections.AddWire(square(20, 0));
  sections.AddWire(square(12, 15));
  sections.AddWire(square(5, 30));
  return sections.Shape();
}

TopoDS_Shape pipe() {
  BRepBuilderAPI_MakeWire spine;
  spine.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(0, 0, 30)).Edge());
  const double c = 20 * (1 - std::sqrt(0.5)), s = 20 * std::sqrt(0.5);
  spine.Add(
      BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(gp_Pnt(0, 0, 30), gp_Pnt(c, 0, 30 + s), gp_Pnt(20, 0, 50)).Value()).Edge());
  spine.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(20, 0, 50), gp_Pnt(45, 0, 50)).Edge());
  return BRepOffsetAPI_MakePipe(spine.Wire(), face(circle(upright(0, 0, 0), 6))).Shape();
}

TopoDS_Shape cylinder() {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1), gp_Dir(0, -1, 0)), 10, 30).Shape();
}

void write_step(const TopoDS_Shape& shape, const std::string& file, const std::string& unit) {
  say_nothing();
  STEPControl_Writer writer;
  Interface_Static::SetCVal("write.step.unit", unit.c_str());
  check(writer.Transfer(shape, STEPControl_AsIs) == IFSelect_RetDone, file);
  Interface_Static::SetCVal("write.step.unit", "MM");
  check(writer.Write(file.c_str()) == IFSelect_RetDone, file);
}

void write_iges(const TopoDS_Shape& shape, const std::string& file) {
  say_nothing();
  IGESControl_Writer writer("MM", 1);
  check(writer.AddShape(shape), file);
  writer.ComputeModel();
  check(writer.Write(file.c_str()), file);
}

void write_pin_in_block(const std::string& file) {
  say_nothing();
  const Handle(TDocStd_Document) document = new TDocStd_Document("BinXCAF");
  const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  const TopoDS_Shape block = BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(gp_Pnt(-10, -10, 0), 20, 20, 20).Shape(),
                                             BRepPrimAPI_MakeCylinder(upright(0, 0, 0), 6, 20).Shape());
  const TDF_Label assembly = shapes->NewShape();
  gp_Trsf turned;
  turned.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 0.1);
  shapes->AddComponent(assembly, shapes->AddShape(block, false), TopLoc_Location());
  shapes->AddComponent(assembly, shapes->AddShape(BRepPrimAPI_MakeCylinder(6, 25).Shape(), false), TopLoc_Location(turned));
  shapes->UpdateAssemblies();
  STEPCAFControl_Writer writer;
  check(writer.Transfer(document, STEPControl_AsIs), file);
  check(writer.Write(file.c_str()) == IFSelect_RetDone, file);
}

namespace {

TopoDS_Shape bolt() {
  return BRepAlgoAPI_Fuse(BRepPrimAPI_MakeCylinder(upright(0, 0, -10), 3, 12).Shape(),
                          BRepPrimAPI_MakeCylinder(upright(0, 0, 0), 6, 4).Shape())
      .Shape();
}

/// Where the bolts are.
std::array<gp_Trsf, 4> places_of_bolts() {
  std::array<gp_Trsf, 4> places;
  int k = 0;
  for (const double x : {12.0, 48.0})
    for (const double y : {12.0, 28.0}) {
      gp_Trsf at, turned;
      at.SetTranslation(gp_Vec(x, y, 8.5));
      turned.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 0.3 * k);
      places[static_cast<std::size_t>(k++)] = at * turned;
    }
  return places;
}

}  // namespace

TopoDS_Shape assembly() {
  TopoDS_Compound all;
  BRep_Builder builder;
  builder.MakeCompound(all);
  builder.Add(all, plate());
  const TopoDS_Shape of_bolt = bolt();
  for (const gp_Trsf& place : places_of_bolts()) builder.Add(all, of_bolt.Located(TopLoc_Location(place)));
  return all;
}

void write_assembly(const std::string& file) {
  say_nothing();
  const Handle(TDocStd_Document) document = new TDocStd_Document("BinXCAF");
  const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  const Handle(XCAFDoc_ColorTool) colours = XCAFDoc_DocumentTool::ColorTool(document->Main());
  const auto named = [](const TDF_Label& label, const char* name) {
    TDataStd_Name::Set(label, TCollection_ExtendedString(name));
    return label;
  };
  const auto colour = [](int r, int g, int b) { return Quantity_Color(r / 255.0, g / 255.0, b / 255.0, Quantity_TOC_sRGB); };
  const TopoDS_Shape of_plate = plate();
  const TDF_Label plate_label = named(shapes->AddShape(of_plate, false), "Plate");
  colours->SetColor(plate_label, colour(20, 160, 60), XCAFDoc_ColorSurf);
  for (TopExp_Explorer at(of_plate, TopAbs_FACE); at.More(); at.Next()) {
    const BRepAdaptor_Surface surface(TopoDS::Face(at.Current()));
    if (surface.GetType() != GeomAbs_Plane || std::fabs(surface.Plane().Location().Z() - 8) > 1e-6) continue;
    TDF_Label of_face;
    shapes->AddSubShape(plate_label, at.Current(), of_face);
    colours->SetColor(of_face, colour(250, 210, 0), XCAFDoc_ColorSurf);
  }
  const TDF_Label bolt_label = named(shapes->AddShape(bolt(), false), "Bolt");
  colours->SetColor(bolt_label, colour(30, 60, 200), XCAFDoc_ColorSurf);
  const TDF_Label assembly = named(shapes->NewShape(), "Assembly"), bolts = named(shapes->NewShape(), "Bolts");
  int k = 0;
  for (const gp_Trsf& place : places_of_bolts()) {
    const TDF_Label instance = shapes->AddComponent(bolts, bolt_label, TopLoc_Location(place));
    if (++k == 2) colours->SetColor(instance, colour(200, 0, 0), XCAFDoc_ColorSurf);
  }
  shapes->AddComponent(assembly, plate_label, TopLoc_Location());
  gp_Trsf nothing;
  shapes->AddComponent(assembly, bolts, TopLoc_Location(nothing));
  shapes->UpdateAssemblies();
  STEPCAFControl_Writer writer;
  writer.SetColorMode(true);
  writer.SetNameMode(true);
  check(writer.Transfer(document, STEPControl_AsIs), file);
  check(writer.Write(file.c_str()) == IFSelect_RetDone, file);
}

}  // namespace hsr::shapes
