#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "hsr/io/write/dxf.h"
#include "hsr/io/write/path.h"
#include "tests/drawing/round_models.h"
#include "tests/io/write/other_programs.h"
#include "tests/io/write/plain_lines.h"

// DXF, read by programs that are not ours: ezdxf, and in the long tests LibreCAD and FreeCAD. What is missing is passed over.

using namespace hsr;
using namespace hsr::internal;

namespace {

/// What ezdxf reads from a file, as JSON: errors of its audit, and each entity's layer, points and extended data.
const char* const dxf_reader = R"(
import json, sys, ezdxf
document = ezdxf.readfile(sys.argv[1])
out = {"errors": [str(e.message) for e in document.audit().errors], "version": document.dxfversion,
       "units": document.header.get("$INSUNITS", 0), "scale": document.header["$LTSCALE"], "layers": {}, "entities": []}
for layer in document.layers:
    out["layers"][layer.dxf.name] = [layer.dxf.linetype, layer.dxf.get("lineweight", -3)]
for e in document.modelspace():
    if e.dxftype() == "LINE": points = [list(e.dxf.start)[:2], list(e.dxf.end)[:2]]
    elif e.dxftype() == "POLYLINE": points = [list(v.dxf.location)[:2] for v in e.vertices]
    else: points = [list(p)[:2] for p in e.get_points("xy")]
    closed = e.dxftype() != "LINE" and bool(e.is_closed if e.dxftype() == "POLYLINE" else e.closed)
    out["entities"].append({"type": e.dxftype(), "layer": e.dxf.layer, "points": points, "closed": closed,
                            "data": [tag.value for tag in e.get_xdata("HSR")]})
print(json.dumps(out))
)";

std::vector<PlainLine> lines_of(const nlohmann::json& entities) {
  std::vector<PlainLine> lines;
  for (const auto& e : entities) {
    const bool is_hidden = e["layer"].get<std::string>().starts_with("HIDDEN_");
    const auto& points = e["points"];
    for (std::size_t k = 0; k + (e["closed"] ? 0 : 1) < points.size(); ++k) {
      const auto &p = points[k], &q = points[(k + 1) % points.size()];
      lines.push_back({{p[0], p[1]}, {q[0], q[1]}, is_hidden});
    }
  }
  return lines;
}

}  // namespace

namespace {

nlohmann::json read_dxf(const Drawing& drawing, DxfVersion version) {
  const Workplace here("hsr_dxf");
  here.write("read.py", dxf_reader);
  here.write("drawn.dxf", dxf(drawing, {version, 1000, DrawnScene::scale}));
  int status = 0;
  const std::string said = here.run("/usr/bin/python3 read.py drawn.dxf", status);
  INFO(said);
  REQUIRE(status == 0);
  return nlohmann::json::parse(said);
}

void check_header(const nlohmann::json& read, bool is_2000) {
  CHECK(read["errors"].empty());
  CHECK(read["version"] == (is_2000 ? "AC1015" : "AC1009"));
  CHECK(read["units"] == 6);
  CHECK(read["scale"] == 0.05);  // 12 of the line type are 3 mm of paper, 0.6 units
  CHECK(read["layers"]["HIDDEN_SHARP"] == nlohmann::json({"ACAD_ISO02W100", is_2000 ? 25 : -3}));
  CHECK(read["layers"]["VISIBLE_OUTLINE"] == nlohmann::json({"CONTINUOUS", is_2000 ? 50 : -3}));
}

}  // namespace

TEST_CASE("A DXF is sound, and has each visible and hidden part at 1:1 with its edges and faces", "[write][others][D13]") {
  const Workplace here("hsr_ezdxf");
  int status = 0;
  (void)here.run("/usr/bin/python3 -c 'import ezdxf'", status);
  if (status != 0) {
    WARN("python3-ezdxf is missing: DXF is not tested with it");
    return;
  }
  const DrawnScene scene;
  const Drawing drawing = scene.draw_in_frame_units();
  std::vector<PlainLine> exact;
  for (const Segment& s : segments(scene.scene, scene.lines)) exact.push_back({s.from.paper, s.to.paper, s.is_hidden});
  for (const DxfVersion version : {DxfVersion::r12, DxfVersion::r2000}) {
    const nlohmann::json read = read_dxf(drawing, version);
    check_header(read, version == DxfVersion::r2000);
    const std::vector<PlainLine> lines = lines_of(read["entities"]);
    CHECK(strays(lines, exact, 1e-5) == 0);
    std::vector<PlainLine> drawn = lines;
    for (PlainLine l : lines) {  // a visible line lies over what is hidden there
      l.is_hidden = true;
      drawn.push_back(l);
    }
    CHECK(strays(exact, drawn, 1e-5) == 0);
    std::size_t numbers = 0;
    for (const auto& e : read["entities"]) {
      REQUIRE(e["data"][0] == "edges");
      numbers += e["data"].size() - 2;
    }
    CHECK(numbers == 2 * drawing.edges.size() + drawing.faces.size());
    Drawing told_apart = drawing;
    told_apart.objects = {
        "Wand S\xC3\xBC"
        "d"};
    told_apart.polylines[0].object = 0;
    const auto first = read_dxf(told_apart, version)["entities"][0]["data"];
    CHECK(first[first.size() - 2] == "object");
    CHECK(first.back() == "Wand S\\U+00FCd");
    Drawing planted = drawing;  // layers swapped
    for (Polyline& p : planted.polylines) p.hidden = !p.hidden;
    CHECK(strays(lines_of(read_dxf(planted, version)["entities"]), exact, 1e-5) > 50);
    planted = drawing;  // larger by a thousandth
    for (PaperPoint& p : planted.points) p = {p.x + p.x / 1000, p.y + p.y / 1000};
    CHECK(strays(lines_of(read_dxf(planted, version)["entities"]), exact, 1e-5) > 50);
  }
}

namespace {

/// What ezdxf makes of curves: the types of entities, and the points of all of them as short lines.
const char* const curve_reader = R"(
import json, sys, ezdxf, ezdxf.path
document = ezdxf.readfile(sys.argv[1])
out = {"errors": [str(e.message) for e in document.audit().errors], "types": {}, "circles": [], "lines": []}
for e in document.modelspace():
    out["types"][e.dxftype()] = out["types"].get(e.dxftype(), 0) + 1
    if e.dxftype() == "CIRCLE": out["circles"].append([e.dxf.center.x, e.dxf.center.y, e.dxf.radius])
    out["lines"].append([[p.x, p.y] for p in ezdxf.path.make_path(e).flattening(0.0005, segments=32)])
print(json.dumps(out))
)";

nlohmann::json read_curves(const Mesh& mesh, const View& view, double tolerance, DxfVersion version) {
  const Workplace here("hsr_dxf_curves");
  here.write("read.py", curve_reader);
  DrawingOptions options;
  options.hidden = HiddenLines::dashed;
  options.in_frame_units = true;
  options.fit_arcs = tolerance;
  here.write("drawn.dxf", dxf(draw(mesh, view, visible_lines(mesh, view), options), {version}));
  int status = 0;
  const std::string said = here.run("/usr/bin/python3 read.py drawn.dxf", status);
  INFO(said);
  REQUIRE(status == 0);
  return nlohmann::json::parse(said);
}

std::vector<PlainLine> lines_of_curves(const nlohmann::json& read) {
  std::vector<PlainLine> lines;
  for (const auto& points : read["lines"])
    for (std::size_t k = 0; k + 1 < points.size(); ++k)
      lines.push_back({{points[k][0], points[k][1]}, {points[k + 1][0], points[k + 1][1]}, false});
  return lines;
}

}  // namespace

TEST_CASE("A DXF has holes as circles, and curves that a reader draws within the tolerance of the lines",
          "[write][others][D13][D22]") {
  const Workplace here("hsr_ezdxf");
  int status = 0;
  (void)here.run("/usr/bin/python3 -c 'import ezdxf'", status);
  if (status != 0) {
    WARN("python3-ezdxf is missing: arcs in DXF are not tested with it");
    return;
  }
  const Mesh plate = plate_with_holes(48);
  for (const DxfVersion version : {DxfVersion::r12, DxfVersion::r2000}) {
    const nlohmann::json front = read_curves(plate, named_view("front"), 0.05, version);
    CHECK(front["errors"].empty());
    CHECK(front["types"]["CIRCLE"] == plate_holes.size());
    for (const Hole& hole : plate_holes)  // the origin of the frame is that of the model
      CHECK(std::count(front["circles"].begin(), front["circles"].end(), nlohmann::json({hole.x, hole.z, hole.radius})) == 1);
    const View views[] = {named_view("iso"), oblique_view(named_view("front"), 45, 0.5),
                          perspective_view({-40, -150, 120}, {60, 5, 40}, {0, 0, 1})};
    for (const View& view : views) {
      const nlohmann::json read = read_curves(plate, view, 0.05, version), straight = read_curves(plate, view, 0, version);
      CHECK(read["errors"].empty());
      const bool has_ellipses = version == DxfVersion::r2000 && &view != &views[1];  // circles stay circles in the oblique view
      CHECK(read["types"].contains("ELLIPSE") == has_ellipses);
      CHECK(read["types"].contains("ARC") == (&view == &views[1]));
      const auto curves = lines_of_curves(read), lines = lines_of_curves(straight);
      CHECK(strays(curves, lines, 0.052) == 0);
      CHECK(strays(lines, curves, 0.052) == 0);
      CHECK(strays(lines, curves, 0.004) > 50);
    }
  }
}

namespace {

Drawing drawn_plate(const char* view, double tolerance) {
  const Mesh mesh = plate_with_holes(48);
  DrawingOptions options;
  options.in_frame_units = true;
  options.fit_arcs = tolerance;
  return draw(mesh, named_view(view), visible_lines(mesh, named_view(view)), options);
}

/// The lines and arcs of a drawing in units of the model, y up; arcs as short chords.
std::vector<PlainLine> lines_in_units(const Drawing& drawing) {
  std::vector<PlainLine> lines;
  for (const Polyline& p : drawing.polylines) {
    std::vector<PaperPoint> points = flattened(path_of(drawing, p), 0.001);
    if (p.closed) points.push_back(points.front());
    const auto place = [&](const PaperPoint& at) {
      return Point2{double(at.x) / 1000 / drawing.scale, -double(at.y) / 1000 / drawing.scale};
    };
    for (std::size_t k = 0; k + 1 < points.size(); ++k) lines.push_back({place(points[k]), place(points[k + 1]), false});
  }
  return lines;
}

constexpr double pixels = 10;  // to a millimetre

/// A page as LibreCAD prints it: 1:1, the drawing's middle in its own.
struct PrintedPage {
  RenderedPage page;
  Point2 middle;

  PrintedPage(const Drawing& drawing, DxfVersion version, const std::vector<PlainLine>& lines) {
    const Workplace here("hsr_librecad");
    here.write("drawn.dxf", dxf(drawing, {version}));
    int status = 0;
    INFO(
        here.run("HOME=. QT_QPA_PLATFORM=offscreen librecad dxf2pdf -k -s 1 -c drawn.dxf && pdftoppm -r 254 -png -singlefile "
                 "drawn.pdf picture",
                 status));
    REQUIRE(status == 0);
    page = read_png(here / "picture.png");
    REQUIRE(page.width > 2000);
    Point2 low = {HUGE_VAL, HUGE_VAL}, high = {-HUGE_VAL, -HUGE_VAL};
    for (const PlainLine& l : lines)
      for (const Point2& p : {l.a, l.b}) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
      }
    middle = {(low.x + high.x) / 2, (low.y + high.y) / 2};
  }

  Point2 point(int x, int y) const {
    return {middle.x + (x + 0.5 - page.width / 2.0) / pixels, middle.y - (y + 0.5 - page.height / 2.0) / pixels};
  }
  bool is_inked(int x, int y) const { return page.at(x, y)[0] < 128; }
  bool is_inked_near(const Point2& p) const {
    const int x = int(page.width / 2.0 + (p.x - middle.x) * pixels), y = int(page.height / 2.0 - (p.y - middle.y) * pixels);
    for (int k = 0; k < 9; ++k)
      if (is_inked(x + k % 3 - 1, y + k / 3 - 1)) return true;
    return false;
  }
};

/// Samples of lines without ink, and pixels with ink that are far from each line.
std::array<int, 2> wrong_ink(const PrintedPage& printed, const std::vector<PlainLine>& lines) {
  std::array<int, 2> wrong = {0, 0};
  for (const PlainLine& l : lines)
    for (double t = 0; t <= 1; t += 0.125)
      if (!printed.is_inked_near({l.a.x + t * (l.b.x - l.a.x), l.a.y + t * (l.b.y - l.a.y)})) ++wrong[0];
  for (int y = 0; y < printed.page.height; ++y)
    for (int x = 0; x < printed.page.width; ++x)
      if (printed.is_inked(x, y) && !is_on_one(printed.point(x, y), lines, false, 0.45)) ++wrong[1];
  return wrong;
}

}  // namespace

TEST_CASE("LibreCAD prints a DXF as the exact drawing is, circles and ellipses too", "[write][others][long][D13][D22]") {
  if (!is_there("librecad") || !is_there("pdftoppm")) return;
  for (const char* const view : {"front", "iso"})
    for (const DxfVersion version : {DxfVersion::r12, DxfVersion::r2000}) {
      CAPTURE(view, version == DxfVersion::r2000);
      const Drawing drawing = drawn_plate(view, 0.05);
      const std::vector<PlainLine> lines = lines_in_units(drawing);
      CHECK(wrong_ink({drawing, version, lines}, lines) == std::array{0, 0});
      Drawing planted = drawing;
      for (DrawnArc& arc : planted.arcs)
        for (Point2* const axis : {&arc.ellipse.long_axis, &arc.ellipse.short_axis}) *axis = {axis->x * 1.1, axis->y * 1.1};
      const auto wrong = wrong_ink({planted, version, lines}, lines);
      CHECK(wrong[0] > 20);
      CHECK(wrong[1] > 20);
    }
}

namespace {

/// What FreeCAD makes of a file: how many edges of each kind, radii of circles, and all edges as short lines.
const char* const freecad_reader = R"(
import json, FreeCAD, Import
FreeCAD.newDocument("drawn")
Import.readDXF("drawn.dxf")
out = {"kinds": {}, "radii": [], "lines": []}
for thing in FreeCAD.ActiveDocument.Objects:
    for edge in getattr(thing, "Shape").Edges if hasattr(thing, "Shape") else []:
        kind = type(edge.Curve).__name__
        out["kinds"][kind] = out["kinds"].get(kind, 0) + 1
        if kind == "Circle": out["radii"].append(edge.Curve.Radius)
        points = edge.discretize(2) if kind == "Line" else edge.discretize(Deflection=0.0005)
        out["lines"].append([[p.x, p.y] for p in points])
json.dump(out, open("read.json", "w"))
)";

}  // namespace

TEST_CASE("FreeCAD reads a DXF as the exact drawing is, circles and ellipses too", "[write][others][long][D13][D22]") {
  if (!is_there("freecadcmd")) return;
  for (const char* const view : {"front", "iso"})
    for (const DxfVersion version : {DxfVersion::r12, DxfVersion::r2000}) {
      CAPTURE(view, version == DxfVersion::r2000);
      const Workplace here("hsr_freecad");
      const Drawing drawing = drawn_plate(view, 0.05);
      here.write("drawn.dxf", dxf(drawing, {version}));
      here.write("read.py", freecad_reader);
      int status = 0;
      INFO(here.run("HOME=. timeout 100 freecadcmd read.py", status));
      REQUIRE(status == 0);
      std::ifstream file(here / "read.json");
      const nlohmann::json read = nlohmann::json::parse(file);
      std::vector<PlainLine> lines;
      for (const auto& points : read["lines"])
        for (std::size_t k = 0; k + 1 < points.size(); ++k)
          lines.push_back({{points[k][0], points[k][1]}, {points[k + 1][0], points[k + 1][1]}, false});
      const std::vector<PlainLine> exact = lines_in_units(drawing);
      CHECK(strays(exact, lines, 0.006) == 0);
      // FreeCAD 0.20 makes whole ellipses of parts of some.
      const bool has_ellipses = read["kinds"].contains("Ellipse");
      CHECK((strays(lines, exact, 0.006) == 0) == !has_ellipses);
      CHECK(strays(lines_in_units(drawn_plate(view, 0)), lines, 0.006) > 100);  // chords are told from arcs
      if (view == std::string("iso")) {
        CHECK(has_ellipses == (version == DxfVersion::r2000));
        continue;
      }
      std::vector<double> radii = read["radii"];
      std::ranges::sort(radii);
      CHECK(radii == std::vector<double>{3.5, 5, 8, 8, 12, 15});
    }
}
