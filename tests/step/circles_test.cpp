// Circles of a B-rep, in files that are drawn with arcs: the very centres and radii.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "hsr/drawing/drawing.h"
#include "hsr/io/write/write.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/step/step.h"
#include "tests/io/read/temporary_directory.h"
#include "tests/step/shapes.h"

namespace hsr {
namespace {

struct Circle {
  double x, y, radius;
};

/// A shape from above, at 1:1.
struct FromAbove {
  Model model;
  std::string dxf, svg;

  explicit FromAbove(const TopoDS_Shape& shape) {
    const test::TemporaryDirectory directory;
    shapes::write_step(shape, directory.file("part.step"));
    model = read_brep(directory.file("part.step")).tessellated(0.004);
    const Mesh mesh = make_mesh(model.points, model.polygons);
    const View view = parallel_view({0, 0, 1}, {0, 1, 0});
    const FaceLabels labels = labels_of(model);
    const VisibleLines lines = visible_lines(SceneView(Scene::of(mesh, labels), view), {});
    DrawingOptions options;
    options.labels = &labels;
    options.fit_arcs = 0.02;
    options.scale = 1;
    svg = written(draw(mesh, view, lines, options), "svg");
    options.in_frame_units = true;
    dxf = written(draw(mesh, view, lines, options), "dxf");
  }
  /// Those of the B-rep that are seen as circles.
  std::vector<Circle> known() const {
    std::vector<Circle> all;
    for (const KnownCircle& c : model.circles)
      if (std::fabs(std::fabs(c.axis.z) - 1) < 1e-12) all.push_back({c.centre.x, c.centre.y, c.radius});
    return all;
  }
  /// Entities CIRCLE of the DXF: groups of a code and a value.
  std::vector<Circle> in_dxf() const {
    std::vector<Circle> all;
    std::istringstream in(dxf);
    bool is_circle = false;
    for (std::string code, value; std::getline(in, code) && std::getline(in, value);) {
      const int number = std::stoi(code);
      if (number == 0) {
        is_circle = value == "CIRCLE";
        if (is_circle) all.push_back({});
      }
      if (!is_circle) continue;
      if (number == 10) all.back().x = std::stod(value);
      if (number == 20) all.back().y = std::stod(value);
      if (number == 40) all.back().radius = std::stod(value);
    }
    return all;
  }
  /// Radii of the arcs of the SVG.
  std::vector<double> in_svg() const {
    std::vector<double> all;
    const std::regex arc("A([0-9.]+) ([0-9.]+) ");
    for (std::sregex_iterator at(svg.begin(), svg.end(), arc), end; at != end; ++at) {
      CHECK((*at)[1].str() == (*at)[2].str());
      all.push_back(std::stod((*at)[1].str()));
    }
    return all;
  }
};

/// DXF has five digits behind the point here, SVG thousandths of a millimetre.
void check(const FromAbove& part, std::size_t circles, bool has_other_arcs) {
  const std::vector<Circle> known = part.known(), in_dxf = part.in_dxf();
  CHECK(in_dxf.size() == circles);
  for (const Circle& c : in_dxf) {
    INFO(c.x << ", " << c.y << ", radius " << c.radius);
    CHECK(std::ranges::any_of(known, [&](const Circle& k) {
      return std::fabs(k.x - c.x) <= 5.1e-6 && std::fabs(k.y - c.y) <= 5.1e-6 && std::fabs(k.radius - c.radius) <= 5.1e-6;
    }));
  }
  std::size_t arcs = 0;
  for (const double radius : part.in_svg()) {
    INFO("radius " << radius);
    const bool is_known = std::ranges::any_of(known, [&](const Circle& k) { return std::fabs(k.radius - radius) <= 5.1e-5; });
    CHECK((is_known || has_other_arcs));
    arcs += is_known ? 1U : 0U;
  }
  CHECK(arcs >= circles);
}

TEST_CASE("circles in DXF and SVG have the centres and radii of the B-rep's", "[step][D22]") {
  SECTION("plate") { check(FromAbove(shapes::plate()), 6, false); }
  SECTION("flange") { check(FromAbove(shapes::flange()), 10, false); }
  SECTION("gear") {
    // Its tips are arcs of three chords each; of its flanks some are within the tolerance of arcs.
    const FromAbove gear(shapes::gear());
    check(gear, 1, true);
    std::vector<double> tips = gear.in_svg();
    std::erase_if(tips, [](double radius) { return std::fabs(radius - 18) > 5.1e-5; });
    CHECK(tips.size() == 16);
  }
}

}  // namespace
}  // namespace hsr
