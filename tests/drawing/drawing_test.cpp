#include "hsr/drawing/drawing.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "geometry/error.h"
#include "hsr/lines/visible_lines.h"
#include "tests/drawing/hand_made_lines.h"

using namespace hsr;

namespace {

using Points = std::vector<PaperPoint>;
using Edges = std::vector<std::array<std::uint32_t, 2>>;

Points points(const Drawing& d, std::size_t k) {
  const auto p = d.points_of(d.polylines.at(k));
  return {p.begin(), p.end()};
}
Edges edges(const Drawing& d, std::size_t k) {
  const auto e = d.edges_of(d.polylines.at(k));
  return {e.begin(), e.end()};
}

Mesh box() {
  const std::vector<Point3> corners = {{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {0, 2, 0}, {0, 0, 3}, {4, 0, 3}, {4, 2, 3}, {0, 2, 3}};
  Polygons faces;
  for (const std::array<std::uint32_t, 4>& f : std::initializer_list<std::array<std::uint32_t, 4>>{
           {0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}) {
    faces.corners.insert(faces.corners.end(), f.begin(), f.end());
    faces.first.push_back(static_cast<std::uint32_t>(faces.corners.size()));
  }
  return make_mesh(corners, faces);
}

}  // namespace

TEST_CASE("A box seen face-on is one closed path of four lines", "[drawing]") {
  const Mesh mesh = box();
  for (const char* name : {"front", "back", "left", "right", "top", "bottom"}) {
    const View view = named_view(name, centre(mesh));
    DrawingOptions options;
    options.hidden = HiddenLines::dashed;
    const Drawing d = draw(mesh, view, visible_lines(mesh, view, {.method = LineMethod::roberts}), options);
    INFO(name);
    REQUIRE(d.polylines.size() == 1);
    CHECK(d.polylines[0].closed);
    CHECK_FALSE(d.polylines[0].hidden);
    CHECK(d.points_of(d.polylines[0]).size() == 4);
    CHECK(d.hidden_under_visible == 4);
  }
}

TEST_CASE("A hidden line behind a visible one is not drawn", "[drawing][duplicates]") {
  HandMadeLines h;
  h.add({-10, 0, 0}, {10, 0, 0});
  h.add({-10, 5, 0}, {10, 5, 0}, EdgeClass::outline, true);
  const Drawing d = h.draw();
  REQUIRE(d.polylines.size() == 1);
  CHECK(points(d, 0) == Points{{40000, 50000}, {60000, 50000}});
  CHECK(edges(d, 0) == Edges{{0, 1}});
  CHECK(d.hidden_under_visible == 1);
  CHECK(d.visible_under_visible == 0);
  CHECK(d.hidden_under_hidden == 0);
}

TEST_CASE("Where a hidden line reaches beyond a visible one, the rest of it is drawn", "[drawing][duplicates]") {
  HandMadeLines h;
  h.add({-5, 0, 0}, {5, 0, 0});
  h.add({-10, 5, 0}, {10, 5, 0}, EdgeClass::outline, true);
  const Drawing d = h.draw();
  REQUIRE(d.polylines.size() == 3);
  CHECK(d.polylines[0].hidden);
  CHECK(points(d, 0) == Points{{40000, 50000}, {45000, 50000}});
  CHECK(points(d, 1) == Points{{55000, 50000}, {60000, 50000}});
  CHECK_FALSE(d.polylines[2].hidden);
  CHECK(points(d, 2) == Points{{45000, 50000}, {55000, 50000}});
}

TEST_CASE("Of two hidden lines one behind the other one is drawn, and it names both", "[drawing][duplicates]") {
  HandMadeLines h;
  h.add({-10, 0, 0}, {10, 0, 0}, EdgeClass::sharp, true);
  h.add({10, 5, 0}, {-10, 5, 0}, EdgeClass::sharp, true);
  const Drawing d = h.draw();
  REQUIRE(d.polylines.size() == 1);
  CHECK(d.polylines[0].hidden);
  CHECK(edges(d, 0) == Edges{{0, 1}, {2, 3}});
  CHECK(d.hidden_under_hidden == 1);
}

TEST_CASE("Visible lines that overlap are merged into one", "[drawing][duplicates][D4]") {
  HandMadeLines h;
  h.add({-10, 0, -10}, {2, 0, 2});
  h.add({10, 5, 10}, {-2, 5, -2});
  const Drawing d = h.draw();
  REQUIRE(d.polylines.size() == 1);
  CHECK(points(d, 0) == Points{{60000, 40000}, {40000, 60000}});
  CHECK(edges(d, 0) == Edges{{0, 1}, {2, 3}});
  CHECK(d.visible_under_visible == 1);
  CHECK(d.merged == 1);
}

TEST_CASE("Where visible lines of two classes coincide the first class is drawn", "[drawing][duplicates][D2]") {
  HandMadeLines h;
  h.add({-10, 0, 0}, {10, 0, 0}, EdgeClass::sharp);
  h.add({0, 5, 0}, {4, 5, 0}, EdgeClass::boundary);
  const Drawing d = h.draw();
  REQUIRE(d.polylines.size() == 3);
  CHECK(d.polylines[0].edge_class == EdgeClass::sharp);
  CHECK(points(d, 0) == Points{{40000, 50000}, {50000, 50000}});
  CHECK(points(d, 1) == Points{{54000, 50000}, {60000, 50000}});
  CHECK(d.polylines[2].edge_class == EdgeClass::boundary);
  CHECK(points(d, 2) == Points{{50000, 50000}, {54000, 50000}});
  CHECK(edges(d, 2) == Edges{{0, 1}, {2, 3}});
}

TEST_CASE("Lines one ulp apart in slope are two lines", "[drawing][duplicates]") {
  HandMadeLines h;
  h.add({-10, 0, 0}, {10, 0, 0});
  h.add({-10, 5, 0}, {10, 5, 5e-324}, EdgeClass::outline, true);
  const Drawing d = h.draw();
  CHECK(d.polylines.size() == 2);
  CHECK(d.hidden_under_visible == 0);
}

TEST_CASE("Ends one ulp or one subnormal apart are two ends", "[drawing][duplicates]") {
  HandMadeLines h;
  h.add({-10, 0, 0}, {1, 0, 0});
  h.add({std::nextafter(1.0, 2), 0, 0}, {10, 0, 0});
  CHECK(h.draw().merged == 0);
  HandMadeLines least;  // too close for any enclosure
  least.add({-10, 0, 0}, {0, 0, 0});
  least.add({5e-324, 3, 0}, {10, 0, 0});
  CHECK(least.draw().merged == 0);
  HandMadeLines k;
  k.add({-10, 0, 0}, {1, 0, 0});
  k.add({1, 3, 0}, {10, 0, 0});
  CHECK(k.draw().merged == 1);
}

TEST_CASE("Hidden lines are left out on demand and leave the rest in its place", "[drawing]") {
  HandMadeLines h;
  h.add({-5, 0, 0}, {5, 0, 0});
  h.add({-20, 5, 3}, {20, 5, 8}, EdgeClass::outline, true);
  const Mesh mesh = h.mesh();
  const View view = named_view("front");
  const Drawing without = draw(mesh, view, h.lines(mesh), {.hidden = HiddenLines::none});
  const Drawing with = draw(mesh, view, h.lines(mesh), {.hidden = HiddenLines::dashed});
  REQUIRE(without.polylines.size() == 1);
  REQUIRE(with.polylines.size() == 2);
  CHECK(points(without, 0) == points(with, 1));
}

TEST_CASE("A square becomes one closed path and a cross two straight ones", "[drawing][join]") {
  HandMadeLines h;
  h.add({-10, 0, -10}, {10, 0, -10});
  h.add({10, 7, -10}, {10, 3, 10});
  h.add({-10, 2, 10}, {10, 1, 10});
  h.add({-10, 0, 10}, {-10, 0, -10});
  const Drawing square = h.draw();
  REQUIRE(square.polylines.size() == 1);
  CHECK(square.polylines[0].closed);
  CHECK(square.points.size() == 4);

  HandMadeLines k;
  k.add({0, 0, 0}, {-10, 0, -1});
  k.add({0, 0, 0}, {1, 0, 10});
  k.add({0, 0, 0}, {10, 0, 1});
  k.add({0, 0, 0}, {-1, 0, -10});
  const Drawing cross = k.draw();
  CHECK(cross.polylines.size() == 2);
  CHECK(cross.merged == 2);  // they are straight to the last bit
  k.points[5] = {10, 0, 2};
  const Drawing bent = k.draw();
  REQUIRE(bent.polylines.size() == 2);
  CHECK(bent.merged == 1);
  CHECK(bent.points.size() == 5);
}

TEST_CASE("Dashes run on: a hidden line in twenty collinear pieces is one path of two points", "[drawing][join][D4]") {
  HandMadeLines h;
  for (int k = -10; k < 10; ++k)
    h.add({1.0 * k, 0.7 * k, 3.0 * k}, {k + 1.0, 0.7 * k + 1, 3.0 * k + 3}, EdgeClass::sharp, true);
  const Drawing d = h.draw();
  REQUIRE(d.polylines.size() == 1);
  CHECK(points(d, 0) == Points{{60000, 20000}, {40000, 80000}});
  CHECK(edges(d, 0).size() == 20);
  CHECK(d.merged == 19);
}

TEST_CASE("Lines under a hundredth of a millimetre are dropped, unless they join others", "[drawing][join][D5]") {
  HandMadeLines h;
  h.add({-10, 0, 0}, {10, 0, 0});
  h.add({0, 0, 5}, {0.0094, 0, 5});
  h.add({0, 0, 7}, {0.0101, 0, 7});
  const Drawing d = h.draw();
  CHECK(d.polylines.size() == 2);
  CHECK(d.short_dropped == 1);

  HandMadeLines arc;  // forty pieces of 0.004 mm each: a line all the same
  for (int k = 0; k < 40; ++k) {
    const auto at = [](int i) { return Point3{0.004 * i, 0, 0.0001 * i * i}; };
    arc.add(at(k), at(k + 1));
  }
  const Drawing e = arc.draw();
  REQUIRE(e.polylines.size() == 1);
  CHECK(e.short_dropped == 0);
}

TEST_CASE("Coordinates are rounded from the exact value, halves away from zero", "[drawing][rounding][E3][D6]") {
  // 0.0625 and 0.1875 mm are 62.5 and 187.5 thousandths.
  HandMadeLines h;
  h.add({-0.0625, 0, -0.1875}, {0.0625, 0, 0.1875});
  const Drawing d = h.draw();
  REQUIRE(d.polylines.size() == 1);
  CHECK(points(d, 0) == Points{{49938, 50188}, {50063, 49813}});
  // One ulp less than a half goes down.
  HandMadeLines k;
  k.add({-0.0625, 0, 0}, {std::nextafter(0.0625, 0), 0, 0});
  CHECK(k.draw().points.back().x == 50062);
}

TEST_CASE("Scale and unit give lengths on paper", "[drawing][page]") {
  const Mesh mesh = box();
  const View view = named_view("front", centre(mesh));
  DrawingOptions options;
  options.scale = parse_scale("1:5");
  options.unit = parse_unit("cm");
  const Drawing d = draw(mesh, view, visible_lines(mesh, view, {.method = LineMethod::roberts}), options);
  CHECK(d.scale == 2);
  CHECK(d.width == 297);
  CHECK(points(d, 0) == Points{{144500, 108000}, {152500, 108000}, {152500, 102000}, {144500, 102000}});
  CHECK(d.fits);
  options.scale = 100;
  CHECK_FALSE(draw(mesh, view, visible_lines(mesh, view, {.method = LineMethod::roberts}), options).fits);
}

TEST_CASE("A fitted drawing fills the page less its margins, turned to its shape", "[drawing][page]") {
  const Mesh mesh = box();
  for (const char* name : {"front", "left", "iso"}) {
    const View view = named_view(name, centre(mesh));
    const Drawing d = draw(mesh, view, visible_lines(mesh, view, {.method = LineMethod::roberts}));
    std::int64_t low_x = 1e9, high_x = 0, low_y = 1e9, high_y = 0;
    for (const PaperPoint& p : d.points) {
      low_x = std::min(low_x, p.x);
      high_x = std::max(high_x, p.x);
      low_y = std::min(low_y, p.y);
      high_y = std::max(high_y, p.y);
    }
    INFO(name);
    const bool wide = std::string(name) == "front";
    CHECK(d.width == (wide ? 297 : 210));
    CHECK(low_x >= 10000);
    CHECK(low_y >= 10000);
    CHECK(high_x <= 1000 * d.width - 10000);
    CHECK(high_y <= 1000 * d.height - 10000);
    CHECK(std::min(low_x, low_y) <= 10002);
  }
}

TEST_CASE("A fitted page is the drawing and its margins", "[drawing][page]") {
  const Mesh mesh = box();
  const View view = named_view("front", centre(mesh));
  DrawingOptions options;
  options.page = parse_page("fit");
  options.page.margin = 5;
  options.scale = 10;
  const Drawing d = draw(mesh, view, visible_lines(mesh, view, {.method = LineMethod::roberts}), options);
  CHECK(d.width == 50);
  CHECK(d.height == 40);
  CHECK(points(d, 0) == Points{{5000, 35000}, {45000, 35000}, {45000, 5000}, {5000, 5000}});
}

TEST_CASE("Nothing to draw is an empty page; a straight line is drawn; neither has a scale of infinity", "[drawing][page]") {
  const Mesh nothing = make_mesh({}, Polygons{});
  const Drawing empty = draw(nothing, named_view("iso"), {});
  CHECK(empty.polylines.empty());
  CHECK(empty.width == 210);
  DrawingOptions options;
  options.page = parse_page("fit");
  options.page.margin = 0;
  CHECK(draw(nothing, named_view("iso"), {}, options).width > 0);

  HandMadeLines h;
  h.add({3, 0, 7}, {5, 0, 7});
  const Mesh mesh = h.mesh();
  const Drawing line = draw(mesh, named_view("front"), h.lines(mesh));
  REQUIRE(line.points.size() == 2);
  CHECK(line.points[0].y == 105000);
  CHECK(line.points[1].x - line.points[0].x > 276000);
}

TEST_CASE("Scenes at both ends of the range of doubles fill the page like any other", "[drawing][range]") {
  const Mesh mesh = box();
  const Drawing usual = draw(mesh, named_view("iso"), visible_lines(mesh, named_view("iso"), {.method = LineMethod::roberts}),
                             {.hidden = HiddenLines::dashed});
  for (const int exponent : {-1074, -900, 900, 1021}) {
    Mesh scaled = mesh;
    for (Point3& p : scaled.points) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
    const View view = named_view("iso");
    const Drawing d =
        draw(scaled, view, visible_lines(scaled, view, {.method = LineMethod::roberts}), {.hidden = HiddenLines::dashed});
    INFO(exponent);
    CHECK(d.points == usual.points);
  }
}

TEST_CASE("A far origin takes nothing from the drawing", "[drawing][range]") {
  const Mesh mesh = box();
  const Drawing usual = draw(mesh, named_view("iso"), visible_lines(mesh, named_view("iso"), {.method = LineMethod::roberts}));
  Mesh far = mesh;
  for (Point3& p : far.points) p = {p.x + 0x1p50, p.y - 0x1p50, p.z + 0x1p49};
  const View view = named_view("iso");
  CHECK(draw(far, view, visible_lines(far, view, {.method = LineMethod::roberts})).points == usual.points);
}

TEST_CASE("A scale that makes a drawing of more than a thousand kilometres is refused", "[drawing][range]") {
  HandMadeLines h;
  h.add({-1e300, 0, 0}, {1e300, 0, 1});
  CHECK_THROWS_AS(h.draw(HiddenLines::dashed, 1), InputError);
  CHECK(h.draw(HiddenLines::dashed, 1e-300).polylines.size() == 1);
}

TEST_CASE("In perspective a point is drawn where its line of sight meets the paper", "[drawing][perspective][V5]") {
  HandMadeLines h;  // twice as far: half as large
  h.add({-4, 0, -4}, {4, 0, 4});
  h.add({-4, 10, 4}, {4, 10, 4});
  const Mesh mesh = h.mesh();
  const View view = perspective_view({0, -10, 0}, {0, 0, 0}, {0, 0, 1});
  DrawingOptions options;
  options.page = parse_page("100x100mm");
  options.scale = 1;
  const Drawing d = draw(mesh, view, h.lines(mesh), options);
  CHECK(points(d, 0) == Points{{46000, 54000}, {54000, 46000}});
  CHECK(points(d, 1) == Points{{48000, 48000}, {52000, 48000}});
}

TEST_CASE("A field of view cuts the picture to its frame", "[drawing][perspective]") {
  HandMadeLines h;
  h.add({-100, 0, 0}, {100, 0, 0});
  h.add({-3, 0, 2}, {3, 0, 2});
  h.add({-3, 0, 200}, {3, 0, 200});
  const Mesh mesh = h.mesh();
  const View view = perspective_view({0, -10, 0}, {0, 0, 0}, {0, 0, 1});
  DrawingOptions options;
  options.page = parse_page("120x100mm");
  options.field_of_view = 90;  // 10 units to each side of the target
  const Drawing d = draw(mesh, view, h.lines(mesh), options);
  REQUIRE(d.polylines.size() == 2);
  CHECK(d.scale == Approx(4).epsilon(1e-5));
  CHECK(points(d, 0)[0].x == Approx(10000).margin(1));
  CHECK(points(d, 0)[1].x == Approx(110000).margin(1));
  CHECK(points(d, 1)[0].x == Approx(48000).margin(1));
  CHECK(points(d, 1)[0].y == Approx(42000).margin(1));
  options.field_of_view = 180;
  CHECK_THROWS_AS(draw(mesh, view, h.lines(mesh), options), InputError);
}

TEST_CASE("A drawing is the same for any number of threads", "[drawing][threads]") {
  HandMadeLines h;
  for (int k = 0; k < 3000; ++k) {
    const double x = k % 40 - 20, z = (k * 7) % 60 - 30;
    h.add({x, 0.1 * k, z}, {x + 1 + k % 5, 0.2 * k, z + (k / 5) % 3}, static_cast<EdgeClass>(k % 6), k % 4 == 0);
  }
  const Mesh mesh = h.mesh();
  const VisibleLines lines = h.lines(mesh);
  const auto with_threads = [&](std::size_t n) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, n);
    DrawingOptions options;
    options.hidden = HiddenLines::dashed;
    return draw(mesh, named_view("front"), lines, options);
  };
  const Drawing one = with_threads(1), three = with_threads(3);
  CHECK(one.points == three.points);
  CHECK(one.edges == three.edges);
  CHECK(one.merged == three.merged);
  CHECK(one.decisions.zero == three.decisions.zero);
  CHECK(one.visible_under_visible > 0);
}
