#include "hsr/step/step.h"

#include <Standard_Failure.hxx>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "geometry/error.h"
#include "geometry/vector3.h"
#include "hsr/drawing/drawing.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/step/fault_guard.h"
#include "tests/io/read/temporary_directory.h"
#include "tests/step/shapes.h"

// Shapes of Open CASCADE, written as STEP, read again and drawn.

namespace hsr {
namespace {

using namespace internal;
using test::TemporaryDirectory;

BrepModel read_again(const TopoDS_Shape& shape, const std::string& unit = "MM") {
  const TemporaryDirectory directory;
  shapes::write_step(shape, directory.file("part.step"), unit);
  return read_brep(directory.file("part.step"));
}

std::vector<std::pair<const char*, TopoDS_Shape>> all_shapes() {
  return {{"plate", shapes::plate()},
          {"bottle", shapes::bottle()},
          {"loft", shapes::loft()},
          {"pipe", shapes::pipe()},
          {"cylinder", shapes::cylinder()}};
}

struct Drawn {
  Model model;
  Mesh mesh;
  View view;
  VisibleLines lines;

  Drawn(Model m, const View& v) : model(std::move(m)), mesh(make_mesh(model.points, model.polygons)), view(v) {
    LineOptions options;
    options.classes.fill(true);
    lines = visible_lines(SceneView(Scene::of(mesh, labels_of(model)), view), options);
  }
  double length(const Line& line) const {
    const Edge& e = mesh.edges[line.edge];
    const Point3 d = minus(mesh.points[e.b], mesh.points[e.a]);
    return std::sqrt(dot(d, d));
  }
  std::size_t lines_of(EdgeClass c) const {
    return static_cast<std::size_t>(std::ranges::count(lines.lines, c, &Line::edge_class));
  }
};

View iso() { return parallel_view({1, -1, 1}, {0, 0, 1}); }

TEST_CASE("faces that share an edge share its points: solids are closed", "[step]") {
  for (const auto& [name, shape] : all_shapes()) {
    const Model model = read_again(shape).tessellated(0.05);
    const Mesh mesh = make_mesh(model.points, model.polygons);
    INFO(name);
    CHECK(mesh.triangles.size() > 10);
    CHECK(model.notes.empty());
    for (const Point3& p : model.points)  // of 64, at most
      for (const double x : {p.x, p.y, p.z}) CHECK(std::ldexp(x, 38) == std::round(std::ldexp(x, 38)));
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) CHECK(mesh.triangles_at(EdgeId(e)).size() == 2);
    // By the numbers of points, too, not only where they are.
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    for (std::size_t f = 0; f < model.polygons.size(); ++f)
      for (std::size_t k = 0; k < 3; ++k) ++sides[std::minmax(model.polygons[f][k], model.polygons[f][(k + 1) % 3])];
    CHECK(std::ranges::all_of(sides, [](const auto& side) { return side.second == 2; }));
  }
}

TEST_CASE("within a face there is no line but an outline, and seams are none", "[step][C23]") {
  for (const auto& [name, shape] : all_shapes()) {
    const Drawn drawn(read_again(shape).tessellated(0.05), iso());
    INFO(name);
    for (const Line& line : drawn.lines.lines) {
      if (line.is_intersection()) continue;
      const auto faces = faces_at(drawn.mesh, drawn.lines, line);
      REQUIRE(faces.size() == 2);
      const bool is_within = drawn.model.face_surface[faces[0].value] == drawn.model.face_surface[faces[1].value];
      CHECK((line.edge_class == EdgeClass::outline || !is_within));
    }
  }
  // The seam is toward the viewer.
  const Drawn cylinder(read_again(shapes::cylinder()).tessellated(0.05), parallel_view({0, -1, 0}, {0, 0, 1}));
  for (const Line& line : cylinder.lines.lines) {
    const Edge& e = cylinder.mesh.edges[line.edge];
    const bool is_upright = cylinder.mesh.points[e.a].z != cylinder.mesh.points[e.b].z;
    CHECK((!is_upright || std::fabs(cylinder.mesh.points[e.a].x) > 9));
  }
  CHECK(cylinder.lines_of(EdgeClass::smooth) == 0);
}

TEST_CASE("edges of fillets are smooth, other edges sharp whatever their angle", "[step][C24]") {
  const Drawn plate(read_again(shapes::plate()).tessellated(0.05), iso());
  double smooth_on_top = 0;
  for (const Line& line : plate.lines.lines) {
    const Point3 &a = plate.mesh.points[plate.mesh.edges[line.edge].a], &b = plate.mesh.points[plate.mesh.edges[line.edge].b];
    const bool is_on_top = a.z == 8 && b.z == 8, is_at_hole = line.edge_class == EdgeClass::sharp && is_on_top;
    if (is_on_top && line.edge_class == EdgeClass::smooth) smooth_on_top += plate.length(line);
    if (!is_at_hole) continue;
    // On the rim of a hole.
    double nearest = 1e9;
    for (const double x : {12.0, 30.0, 48.0})
      for (const double y : {12.0, 28.0}) nearest = std::min(nearest, std::fabs(std::hypot(a.x - x, a.y - y) - 4));
    CHECK(nearest < 1e-9);
  }
  const double pi = std::acos(-1.0);
  CHECK(smooth_on_top == Approx(2 * (48 + 28) + 2 * pi * 4).epsilon(0.002));  // rounded by 6, less the fillet of 2
  // Its sides bend by three degrees.
  const Drawn loft(read_again(shapes::loft()).tessellated(0.05), iso());
  const auto is_bend = [&](const Line& line) {
    const Edge& e = loft.mesh.edges[line.edge];
    return line.edge_class == EdgeClass::sharp && loft.mesh.points[e.a].z == 15 && loft.mesh.points[e.b].z == 15;
  };
  CHECK(std::ranges::count_if(loft.lines.lines, is_bend) == 4);
}

/// How far the middles of edges and triangles are from cylinders and planes that they stand for, at most.
double chord_error(const Model& model) {
  double most = 0;
  for (std::size_t f = 0; f < model.polygons.size(); ++f) {
    const KnownSurface& s = model.surfaces[model.face_surface[f]];
    if (s.kind != SurfaceKind::cylinder && s.kind != SurfaceKind::plane && s.kind != SurfaceKind::sphere) continue;
    const auto corners = model.polygons[f];
    const auto check = [&](const Point3& p) {
      const Point3 d = minus(p, s.point);
      const double along = dot(d, s.direction);
      const double off = s.kind == SurfaceKind::plane    ? std::fabs(along)
                         : s.kind == SurfaceKind::sphere ? std::fabs(std::sqrt(dot(d, d)) - s.radius)
                                                         : std::fabs(std::sqrt(dot(d, d) - along * along) - s.radius);
      most = std::max(most, off);
    };
    const Point3 &a = model.points[corners[0]], &b = model.points[corners[1]], &c = model.points[corners[2]];
    check({(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3, (a.z + b.z + c.z) / 3});
    for (const auto& [p, q] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
      check({(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2});
  }
  return most;
}

TEST_CASE("chords are no farther from what they stand for than was asked, and no finer than that takes", "[step]") {
  for (const auto& [name, shape] : all_shapes()) {
    const BrepModel brep = read_again(shape);
    for (const double chord : {0.2, 0.02, 0.002}) {
      INFO(name << " " << chord);
      const double found = chord_error(brep.tessellated(chord));
      CHECK(found <= chord);
    }
    const std::string planar = "loft";
    if (name != planar) CHECK(brep.tessellated(0.002).polygons.size() > 2 * brep.tessellated(0.2).polygons.size());
  }
}

TEST_CASE("a mesh is the same each time, finer ones made in between or not", "[step][M5]") {
  const BrepModel brep = read_again(shapes::bottle());
  const Model first = brep.tessellated(0.05);
  static_cast<void>(brep.tessellated(0.01));
  const Model again = brep.tessellated(0.05);
  CHECK(first.points == again.points);
  CHECK(first.polygons.corners == again.polygons.corners);
  CHECK(first.marks == again.marks);
}

TEST_CASE("the circles of edges are known, with the axis and the radius that they have", "[step]") {
  const Model model = read_again(shapes::plate()).tessellated(0.05);
  std::set<std::uint32_t> holes;
  for (const MarkedEdge& mark : model.marks) {
    if (mark.circle == 0xffffffffU) continue;
    const KnownCircle& c = model.circles[mark.circle];
    CHECK(std::sqrt(dot(c.axis, c.axis)) == Approx(1));
    for (const std::uint32_t p : mark.points) {
      const Point3 d = minus(model.points[p], c.centre);
      CHECK(std::sqrt(dot(d, d)) == Approx(c.radius).epsilon(1e-9));
      CHECK(std::fabs(dot(d, c.axis)) < 1e-9);
    }
    if (c.radius == Approx(4) && std::fabs(c.axis.z) == Approx(1) && mark.mark == EdgeMark::sharp) holes.insert(mark.circle);
  }
  CHECK(holes.size() == 12);
}

TEST_CASE("circles of holes are drawn as arcs of the very radius", "[step][D22]") {
  const Drawn plate(read_again(shapes::plate()).tessellated(0.004), parallel_view({0, 0, 1}, {0, 1, 0}));
  DrawingOptions options;
  options.fit_arcs = 0.02;
  const Drawing drawing = draw(plate.mesh, plate.view, plate.lines, options);
  std::size_t whole = 0;
  for (const DrawnArc& arc : drawing.arcs) {
    if (!arc.ellipse.is_whole()) continue;
    ++whole;
    CHECK(arc.ellipse.long_radius() == Approx(4 * drawing.scale).epsilon(1e-6));
  }
  CHECK(whole == 6);
}

TEST_CASE("walls along an axis are seen as one line from above", "[step][D22]") {
  // The corners of the plate: a circle at the foot, one at the fillet, and facets between them.
  const Drawn plate(read_again(shapes::plate()).tessellated(0.004), parallel_view({0, 0, 1}, {0, 1, 0}));
  DrawingOptions options;
  options.fit_arcs = 0.02;
  options.leave_out_near = true;
  VisibleLines drawn = lines_of_classes(plate.mesh, plate.lines, drawn_classes);
  const Drawing drawing = draw(plate.mesh, plate.view, drawn, options);
  CHECK(drawing.polylines.size() == 7);
  CHECK(drawing.arcs.size() == 10);
}

TEST_CASE("an assembly has an object for each instance, in its place and in its colours", "[step]") {
  const TemporaryDirectory directory;
  shapes::write_assembly(directory.file("assembly.step"));
  const Model model = read_brep(directory.file("assembly.step")).tessellated(0.05);
  CHECK(model.objects == std::vector<std::string>{"Plate", "Bolts/Bolt", "Bolts/Bolt [2]", "Bolts/Bolt [3]", "Bolts/Bolt [4]"});
  std::map<std::uint32_t, std::set<Colour>> colours;
  std::map<std::uint32_t, Point3> sums;
  std::map<std::uint32_t, double> counts;
  for (std::size_t f = 0; f < model.polygons.size(); ++f) {
    const std::uint32_t object = model.face_object[f];
    colours[object].insert(model.palette[model.face_colour[f]]);
    for (const std::uint32_t c : model.polygons[f]) {
      Point3& p = sums[object];
      p = {p.x + model.points[c].x, p.y + model.points[c].y, p.z + model.points[c].z};
      ++counts[object];
    }
  }
  const Colour blue = {30, 60, 200, 255}, red = {200, 0, 0, 255}, green = {20, 160, 60, 255}, yellow = {250, 210, 0, 255};
  CHECK(colours[0] == std::set<Colour>{green, yellow});
  CHECK(colours[1] == std::set<Colour>{blue});
  CHECK(colours[2] == std::set<Colour>{red});
  CHECK(colours[4] == std::set<Colour>{blue});
  CHECK(sums[2].x / counts[2] == Approx(12).margin(0.2));
  CHECK(sums[2].y / counts[2] == Approx(28).margin(0.2));
  CHECK(sums[3].x / counts[3] == Approx(48).margin(0.2));
  CHECK(model.notes == std::vector<std::string>{"coordinates of placed parts are rounded to doubles"});
  for (const MarkedEdge& mark : model.marks) CHECK(mark.object < model.objects.size());
}

TEST_CASE("a pin that fills a hole pierces nothing but the plane that it passes", "[step][I6]") {
  const TemporaryDirectory directory;
  shapes::write_pin_in_block(directory.file("pin.step"));
  const BrepModel brep = read_brep(directory.file("pin.step"));
  // Of two cylinders.
  const auto pierced = [](const Drawn& drawn, const Model& known) {
    return std::ranges::count_if(drawn.lines.lines, [&](const Line& line) {
      if (line.edge_class != EdgeClass::intersection) return false;
      return std::ranges::all_of(faces_at(drawn.mesh, drawn.lines, line), [&](FaceId f) {
        return known.surfaces[known.face_surface[f.value]].kind == SurfaceKind::cylinder;
      });
    });
  };
  const Model model = brep.tessellated(0.02);
  CHECK(pierced(Drawn(model, iso()), model) == 0);
  // As two surfaces of which nothing is known, their facets pierce each other.
  Model unknown = model;
  unknown.surfaces.clear();
  CHECK(pierced(Drawn(unknown, iso()), model) > 50);
}

TEST_CASE("the rim of a pin and that of its hole are one dashed circle", "[step][D16]") {
  const TemporaryDirectory directory;
  shapes::write_pin_in_block(directory.file("pin.step"));
  const Drawn drawn(read_brep(directory.file("pin.step")).tessellated(0.004), iso());
  const SceneObjects objects = objects_of(drawn.model, drawn.mesh);
  DrawingOptions options;
  options.hidden = HiddenLines::dashed;
  options.leave_out_near = true;
  options.objects = &objects;
  const Drawing drawing = draw(drawn.mesh, drawn.view, drawn.lines, options);
  CHECK(std::ranges::count_if(drawing.polylines, [](const Polyline& p) { return p.hidden; }) < 40);
}

TEST_CASE("lengths stay in the file's unit", "[step]") {
  const Model model = read_again(shapes::cylinder(), "INCH").tessellated(0.05);
  CHECK(model.unit == 25.4);
  CHECK(std::ranges::max(model.points, {}, &Point3::z).z == 30);
  CHECK(read_again(shapes::cylinder()).millimetres() == 1);
}

TEST_CASE("IGES has the same lines as STEP", "[step]") {
  const TemporaryDirectory directory;
  shapes::write_iges(shapes::plate(), directory.file("plate.igs"));
  const Model iges = read_brep(directory.file("plate.igs")).tessellated(0.05);
  CHECK(iges.format == "IGES");
  const Drawn a(iges, iso()), b(read_again(shapes::plate()).tessellated(0.05), iso());
  CHECK(a.lines_of(EdgeClass::outline) == b.lines_of(EdgeClass::outline));
  CHECK(a.lines_of(EdgeClass::boundary) == 0);
}

std::string refusal(const std::string& path, const std::string& bytes) {
  try {
    static_cast<void>(read_brep(path, bytes).tessellated(1));
  } catch (const InputError& e) {
    return e.what();
  }
  return "nothing was refused";
}

/// A file without its entities of a kind.
std::string without(std::string text, const std::string& kind) {
  for (std::size_t at = text.find(kind); at != std::string::npos; at = text.find(kind)) {
    const std::size_t begin = text.rfind('#', at), end = text.find(';', at) + 1;
    text.erase(begin, end - begin);
  }
  return text;
}

int depth_of_calls(const volatile int* above) {
  const volatile int here = *above + 1;
  return here < 0 ? here : depth_of_calls(&here) + here;
}

TEST_CASE("a stack that comes to its end within Open CASCADE is refused as other faults are", "[step]") {
  const volatile int start = 0;
  CHECK_THROWS_AS(internal::survive_faults([&] { static_cast<void>(depth_of_calls(&start)); }), Standard_Failure);
  CHECK_THROWS_AS(internal::survive_faults([] { throw PreconditionError("within"); }), PreconditionError);
  CHECK_NOTHROW(internal::survive_faults([] {}));
}

TEST_CASE("files that are no STEP are refused in one line", "[step]") {
  CHECK(refusal("a.step", "") == "a.step: found an empty file, expected a model");
  const std::string no_step =
      "a.step: found STEP that Open CASCADE cannot read, expected entities of ISO 10303-21 from HEADER to END-ISO-10303-21";
  CHECK(refusal("a.step", "hello") == no_step);
  CHECK(refusal("a.step", "ISO-10303-21;\nHEADER;\n") == no_step);
  CHECK(refusal("a.igs", "hello").starts_with("a.igs: found IGES that is compressed or not a file of its own"));
  const TemporaryDirectory directory;
  shapes::write_step(shapes::cylinder(), directory.file("a.step"));
  std::ifstream file(directory.file("a.step"));
  std::string text(std::istreambuf_iterator<char>(file), {});
  CHECK(refusal("a.step", text.substr(0, text.size() / 2)) == no_step);
  std::string no_number = text;
  const std::size_t point = no_number.find("CARTESIAN_POINT"), number = no_number.find("(0.", point);
  no_number.replace(number + 1, 2, "NaN");
  CHECK(refusal("a.step", no_number).find(": found \"NaN\", expected a finite number") != std::string::npos);
  // Open CASCADE follows pointers to what is missing.
  const std::string no_vectors = without(text, "= VECTOR(");
  for (int again = 0; again < 2; ++again)
    CHECK(refusal("a.step", no_vectors) == "a.step: found no shape with a size, expected surfaces or solids");
  CHECK(read_brep("a.step", text).tessellated(0.1).polygons.size() > 0);
  // One that fails leaves no unit behind.
  shapes::write_iges(shapes::plate(), directory.file("plate.igs"));
  const double size = read_brep(directory.file("plate.igs")).size();
  shapes::write_step(shapes::plate(), directory.file("inch.step"), "INCH");
  std::ifstream inch_file(directory.file("inch.step"));
  const std::string inch(std::istreambuf_iterator<char>(inch_file), {});
  CHECK(refusal("inch.step", without(inch, "= VECTOR(")) ==
        "inch.step: found no shape with a size, expected surfaces or solids");
  CHECK(read_brep(directory.file("plate.igs")).size() == size);
  const std::string word = "CYLINDRICAL_SURFACE";
  text.replace(text.find(word), word.size(), "CYLINDRICAL_SURFAXE");
  const Model model = read_brep("a.step", text).tessellated(0.1);
  REQUIRE(model.notes.size() == 1);
  CHECK(model.notes[0].starts_with("entities that Open CASCADE does not understand are left out"));
}

}  // namespace
}  // namespace hsr
