#include "hsr/drawing/fit_arcs.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "hsr/drawing/circle_image.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/surfaces/regions.h"
#include "hsr/surfaces/visible_fragments.h"
#include "tests/drawing/distance_to_arc.h"
#include "tests/drawing/hand_made_lines.h"
#include "tests/drawing/round_models.h"

using namespace hsr;
using namespace hsr::internal;

namespace {

constexpr double pi = std::numbers::pi;

DrawingOptions arcs_within(double tolerance) {
  DrawingOptions options;
  options.page = parse_page("300x300mm");
  options.scale = 1;
  options.hidden = HiddenLines::dashed;
  options.leave_out_near = true;
  options.fit_arcs = tolerance;
  return options;
}

Drawing drawn(const Mesh& mesh, const View& view, const DrawingOptions& options) {
  const SceneView scene(mesh, view);
  return draw(mesh, view, visible_lines(scene), options);
}

/// Rules of all arcs: where they begin and end, and how near they are to the lines.
void check_arcs(const Drawing& d, double tolerance) {
  for (const Polyline& p : d.polylines) {
    std::uint32_t last = p.first_point;
    for (const DrawnArc& arc : d.arcs_of(p)) {
      CHECK(arc.first_line >= last);
      CHECK(arc.end_line >= arc.first_line + 4);
      CHECK(arc.end_line <= p.end_point - (p.closed ? 0 : 1));
      last = arc.end_line;
      const auto point = [&](std::uint32_t k) { return millimetres(d.points[k == p.end_point ? p.first_point : k]); };
      const EllipseArc& e = arc.ellipse;
      CHECK(e.long_radius() >= e.short_radius());
      CHECK(std::fabs(e.long_axis.x * e.short_axis.x + e.long_axis.y * e.short_axis.y) < 1e-9 * e.long_radius());
      CHECK(e.long_axis.x * e.short_axis.y - e.long_axis.y * e.short_axis.x > 0);
      CHECK(e.is_whole() == (p.closed && arc.end_line - arc.first_line == p.end_point - p.first_point));
      if (!e.is_whole()) {
        CHECK(distance(e.at(e.from), point(arc.first_line)) < 0.0011);
        CHECK(distance(e.at(e.to), point(arc.end_line)) < 0.0011);
      }
      double worst = 0;
      for (std::uint32_t k = arc.first_line; k < arc.end_line; ++k) {
        const Point2 a = point(k), b = point(k + 1);
        for (const double t : {0.0, 0.25, 0.5, 1.0})
          worst = std::max(worst, distance({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}, e));
      }
      CHECK(worst <= tolerance + 0.001);
    }
  }
}

std::size_t lines_in_arcs(const Drawing& d) {
  std::size_t count = 0;
  for (const DrawnArc& arc : d.arcs) count += arc.end_line - arc.first_line;
  return count;
}

/// A curve of wires as seen from the front; x, depth and z by the parameter.
template <class Curve>
Drawing wires(int lines, const Curve& curve, double tolerance) {
  HandMadeLines h;
  for (int k = 0; k < lines; ++k) h.add(curve(k), curve(k + 1));
  const Mesh mesh = h.mesh();
  return draw(mesh, named_view("front"), h.lines(mesh), arcs_within(tolerance));
}

/// As wires(), with marks: line k lies on circle number circle_of_line(k) of `circles`.
template <class Curve, class CircleOfLine>
Drawing marked_wires(int lines, const Curve& curve, const std::vector<KnownCircle>& circles, const CircleOfLine& circle_of_line,
                     double tolerance) {
  HandMadeLines h;
  FaceLabels labels;
  labels.circles = circles;
  for (int k = 0; k < lines; ++k) {
    const std::uint32_t first = h.add(curve(k), curve(k + 1));
    labels.marks.push_back({{first + 1, first}, EdgeMark::sharp, 0, circle_of_line(k)});
  }
  const Mesh mesh = h.mesh();
  DrawingOptions options = arcs_within(tolerance);
  options.labels = &labels;
  return draw(mesh, named_view("front"), h.lines(mesh), options);
}

auto circle_of(int sides, double radius, double rise = 0) {
  return [=](int k) {
    const double t = 2 * pi * (k % sides) / sides;
    return Point3{radius * std::cos(t), rise * k, radius * std::sin(t)};
  };
}

}  // namespace

TEST_CASE("A circle seen face-on is a whole circle, and seen at a slant an ellipse in parts by visibility",
          "[drawing][arcs][D22]") {
  const Mesh mesh = cylinder(96, 25, 60);
  const Drawing top = drawn(mesh, named_view("top"), arcs_within(0.05));
  REQUIRE(top.arcs.size() == 1);
  const EllipseArc& circle = top.arcs[0].ellipse;
  CHECK(circle.is_whole());
  CHECK(circle.is_circle());
  CHECK(circle.long_radius() == Approx(25).margin(1e-9));
  CHECK(circle.centre.x == Approx(150).margin(1e-3));
  check_arcs(top, 0.05);

  const Drawing iso = drawn(mesh, named_view("iso"), arcs_within(0.05));
  CHECK(iso.arcs.size() == 4);  // the rim of the roof, where it is an outline and where not; of the floor, seen and hidden
  for (const DrawnArc& arc : iso.arcs) {
    CHECK(arc.ellipse.long_radius() == Approx(25).margin(1e-9));
    CHECK(arc.ellipse.short_radius() == Approx(25 / std::sqrt(3)).margin(1e-9));
    CHECK(std::fabs(arc.ellipse.sweep()) == Approx(pi).margin(0.04));
  }
  CHECK(lines_in_arcs(iso) == 192);
  check_arcs(iso, 0.05);
  CHECK(drawn(mesh, named_view("front"), arcs_within(0.05)).arcs.empty());  // straight there
}

TEST_CASE("Arcs are near the lines that they stand for, from their first point to their last, in every view",
          "[drawing][arcs][property][D22]") {
  const Mesh plate = plate_with_holes(48), can = cylinder(64, 25, 60);
  const View views[] = {named_view("front"),
                        named_view("iso"),
                        parallel_view({0.3, -1, 0.2}, {0, 0, 1}),
                        parallel_view({1, -0.0625, 4}, {0, 1, 0}),
                        oblique_view(named_view("front"), 45, 0.5),
                        oblique_view(named_view("top"), 30, 1),
                        perspective_view({-40, -150, 120}, {60, 5, 40}, {0, 0, 1}),
                        perspective_view({10, -60, 90}, {10, 5, 30}, {0, 0, 1})};
  std::size_t found = 0;
  for (const View& view : views)
    for (const Mesh* mesh : {&plate, &can})
      for (const double tolerance : {0.02, 0.1, 0.5}) {
        DrawingOptions options = arcs_within(tolerance);
        for (const bool sorted : {false, true}) {
          options.sort_for_pen = sorted;
          const Drawing d = drawn(*mesh, view, options);
          CAPTURE(view.viewpoint.at.x, view.viewpoint.at.y, tolerance, sorted);
          CHECK(d.arc_tolerance == tolerance);
          check_arcs(d, tolerance);
          found += d.arcs.size();
        }
      }
  CHECK(found > 500);
}

TEST_CASE("In perspective an arc is the image of the circle, not of its polygon", "[drawing][arcs][D22]") {
  const View view = perspective_view({-40, -150, 120}, {60, 5, 40}, {0, 0, 1});
  const Drawing d = drawn(plate_with_holes(96), view, arcs_within(0.05));
  // A circle of many more corners, on the same page.
  const Drawing fine = drawn(plate_with_holes(768), view, arcs_within(0));
  CHECK(fine.arcs.empty());
  int seen = 0;
  for (const DrawnArc& arc : d.arcs) {
    if (arc.ellipse.long_radius() < 5) continue;
    ++seen;
    double worst = 0;
    for (int k = 1; k < 64; ++k) {
      const Point2 p = arc.ellipse.at(arc.ellipse.from + k * arc.ellipse.sweep() / 64);
      double least = HUGE_VAL;
      for (const PaperPoint& q : fine.points) least = std::min(least, distance(p, millimetres(q)));
      worst = std::max(worst, least);
    }
    CHECK(worst < 0.08);  // half of a line between two of its points
  }
  CHECK(seen > 3);
}

TEST_CASE("The holes of a plate are circles, one each, also of its outline alone and in units of the model",
          "[drawing][arcs][D22]") {
  const Mesh mesh = plate_with_holes(48);
  const View view = named_view("front");
  const SceneView scene(mesh, view);
  const auto check_holes = [&](const Drawing& d, double scale) {
    CHECK(d.arcs.size() == plate_holes.size());
    for (const Hole& hole : plate_holes)
      CHECK(std::count_if(d.arcs.begin(), d.arcs.end(), [&](const DrawnArc& arc) {
              return arc.ellipse.is_whole() && arc.ellipse.is_circle() &&
                     std::fabs(arc.ellipse.long_radius() - scale * hole.radius) < 1e-6;
            }) == (hole.radius == 8 ? 2 : 1));
    check_arcs(d, 0.05 * scale);
  };
  check_holes(drawn(mesh, view, arcs_within(0.05)), 1);
  DrawingOptions options = arcs_within(0.05);
  options.in_frame_units = true;
  check_holes(drawn(mesh, view, options), 10);
  options.in_frame_units = false;
  options.outline_only = true;
  const Regions all =
      regions_of(scene, visible_fragments(scene), std::vector<Colour>(mesh.faces.size(), Colour{}), Merge::colour);
  LineOptions every;
  every.classes.fill(true);
  check_holes(draw(mesh, view, visible_lines(scene, every), options, &all), 1);
}

TEST_CASE("What only looks like a circle is none: helices, hexagons, coarse polygons, waves, short and straight runs",
          "[drawing][arcs][D22]") {
  CHECK(wires(48, circle_of(48, 20), 0.05).arcs.size() == 1);
  const Drawing helix =
      wires(48, circle_of(48, 20, 0.5), 0.05);  // along the line of sight; any curve is near a circle for a while
  CHECK(helix.arcs.size() > 4);
  for (const DrawnArc& arc : helix.arcs) CHECK(arc.end_line - arc.first_line < 12);
  const auto crown = [](int k) {
    return Point3{20 * std::cos(k % 48 * pi / 24), k % 2 * 1.0, 20 * std::sin(k % 48 * pi / 24)};
  };
  CHECK(wires(48, crown, 0.05).arcs.empty());
  CHECK(wires(47, circle_of(48, 20), 0.05).arcs.size() == 1);  // a gap
  CHECK(wires(4, circle_of(48, 20), 0.05).arcs.size() == 1);
  CHECK(wires(3, circle_of(48, 20), 0.05).arcs.empty());
  CHECK(wires(48, circle_of(48, 20), 0.03).arcs.empty());  // the middle of a side is 0.043 mm off
  CHECK(wires(6, circle_of(6, 20), 5).arcs.empty());       // 60 degrees each
  CHECK(wires(11, circle_of(11, 20), 5).arcs.size() == 1);
  CHECK(wires(48, circle_of(48, 0.02), 0.05).arcs.empty());  // a straight line is as near
  // A wave of half circles turns the other way each time.
  const auto wave = [](int k) {
    const double t = pi * (k % 12) / 12, up = k / 12 % 2 == 0 ? 1 : -1;
    return Point3{10 * (k / 12 * 2 + 1 - std::cos(t)), 0, up * 10 * std::sin(t)};
  };
  const Drawing waves = wires(48, wave, 0.1);
  CHECK(waves.arcs.size() == 4);
  for (const DrawnArc& arc : waves.arcs) CHECK(arc.ellipse.long_radius() == Approx(10).margin(1e-3));
  // Noise below the tolerance leaves a circle, noise above it none.
  const auto noisy = [](double noise) {
    return [=](int k) {
      const double t = 2 * pi * (k % 96) / 96, r = 20 + noise * std::sin(7.3 * (k % 96) * (k % 96));
      return Point3{r * std::cos(t), 0, r * std::sin(t)};
    };
  };
  CHECK(wires(96, noisy(0.03), 0.06).arcs.size() == 1);
  check_arcs(wires(96, noisy(0.03), 0.06), 0.06);
  CHECK(lines_in_arcs(wires(96, noisy(0.5), 0.06)) < 20);
  // Sides that are 0.17 mm off in space, where that is seen an eighth as long.
  const auto slanted = [](int k) {
    const double t = pi / 3 + k * pi / 12;
    return Point3{20 * std::cos(t), -19.84 * std::sin(t), 2.5 * std::sin(t)};
  };
  CHECK(wires(4, slanted, 0.1).arcs.empty());
  CHECK(wires(4, slanted, 0.2).arcs.size() == 1);
  // Edge-on.
  CHECK(wires(
            96,
            [](int k) {
              return Point3{20 * std::cos(k * pi / 48), 20 * std::sin(k * pi / 48), 0};
            },
            0.1)
            .arcs.empty());
}

TEST_CASE("A fine polygon is an arc at every tolerance that it bows by, however little its first edges do",
          "[drawing][arcs][D22]") {
  // Half a circle: four edges of it rise by less than 0.2 mm from their chord.
  for (const double tolerance : {0.02, 0.1, 0.2, 0.5, 2.0}) {
    const Drawing d = wires(100, circle_of(200, 60), tolerance);
    INFO(tolerance);
    REQUIRE(d.arcs.size() == 1);
    CHECK(lines_in_arcs(d) == 100);
    check_arcs(d, tolerance);
  }
}

TEST_CASE("On a circle that is known few lines are an arc, of its very radius", "[drawing][arcs][D22]") {
  const std::vector<KnownCircle> circle = {{{0, 0, 0}, {0, 1, 0}, 20}};
  const auto first = [](int) { return 0U; };
  for (const int lines : {1, 2, 3, 5}) {
    INFO(lines);
    const Drawing d = marked_wires(lines, circle_of(48, 20), circle, first, 0.05);
    REQUIRE(d.arcs.size() == 1);
    CHECK(lines_in_arcs(d) == static_cast<std::size_t>(lines));
    CHECK(d.arcs[0].ellipse.long_radius() == Approx(20).margin(1e-12));
    CHECK(std::fabs(d.arcs[0].ellipse.sweep()) == Approx(lines * pi / 24).margin(1e-3));
  }
  CHECK(wires(3, circle_of(48, 20), 0.05).arcs.empty());  // a circle by chance
  const Drawing around = marked_wires(48, circle_of(48, 20), circle, first, 0.05);
  REQUIRE(around.arcs.size() == 1);
  CHECK(around.arcs[0].ellipse.is_whole());
  CHECK(around.arcs[0].ellipse.long_radius() == Approx(20).margin(1e-12));
}

TEST_CASE("What a mark says of a circle counts only where the edges are on it", "[drawing][arcs][D22]") {
  const auto first = [](int) { return 0U; };
  for (const KnownCircle& wrong : {KnownCircle{{0, 0, 0}, {0, 1, 0}, 21}, KnownCircle{{1, 0, 0}, {0, 1, 0}, 20},
                                   KnownCircle{{0, 0, 0}, {1, 0, 0}, 20}, KnownCircle{{0, 0, 0}, {0, 0, 1}, 20}}) {
    CHECK(marked_wires(3, circle_of(48, 20), {wrong}, first, 0.05).arcs.empty());
    const Drawing d = marked_wires(12, circle_of(48, 20), {wrong}, first, 0.05);
    REQUIRE(d.arcs.size() == 1);  // found without it
    CHECK(d.arcs[0].ellipse.long_radius() == Approx(20).margin(1e-6));
  }
  // Too coarse: chords of 60 degrees are far from their circle.
  CHECK(marked_wires(6, circle_of(6, 20), {{{0, 0, 0}, {0, 1, 0}, 20}}, first, 0.05).arcs.empty());
  // A number that names no circle.
  CHECK(marked_wires(3, circle_of(48, 20), {}, first, 0.05).arcs.empty());
}

TEST_CASE("Known circles that meet smoothly are an arc each, and parts of one circle are one", "[drawing][arcs][D22]") {
  // A quarter of radius 20, then one of radius 5 on the same line of centres: two lines of each.
  const auto curve = [](int k) {
    const double radius = k <= 2 ? 20 : 5, from = k <= 2 ? 0 : 15, t = k * pi / 48;
    return Point3{from * std::cos(pi / 24) + radius * std::cos(t), 0, from * std::sin(pi / 24) + radius * std::sin(t)};
  };
  const std::vector<KnownCircle> two = {{{0, 0, 0}, {0, 1, 0}, 20},
                                        {{15 * std::cos(pi / 24), 0, 15 * std::sin(pi / 24)}, {0, -1, 0}, 5}};
  const Drawing smooth = marked_wires(
      4, curve, two, [](int k) { return k < 2 ? 0U : 1U; }, 0.05);
  REQUIRE(smooth.arcs.size() == 2);
  std::set<double> radii;
  for (const DrawnArc& arc : smooth.arcs) radii.insert(std::round(arc.ellipse.long_radius() * 1e9) / 1e9);
  CHECK(radii == std::set<double>{5, 20});
  // As B-reps have them, in halves that say the same of the circle, here with the axis turned around.
  const std::vector<KnownCircle> halves = {{{0, 0, 0}, {0, 1, 0}, 20}, {{0, 0, 0}, {0, -1, 0}, 20}};
  const Drawing one = marked_wires(
      48, circle_of(48, 20), halves, [](int k) { return k < 24 ? 0U : 1U; }, 0.05);
  REQUIRE(one.arcs.size() == 1);
  CHECK(one.arcs[0].ellipse.is_whole());
}

TEST_CASE("A plate with round corners has an arc at each, wherever its outline begins", "[drawing][arcs][D22]") {
  constexpr int quarter = 12;
  for (int shift = 0; shift < 4 * (quarter + 1); ++shift) {
    const auto rounded = [&](int k) {
      const int i = (k + shift) % (4 * (quarter + 1)), corner = i / (quarter + 1);
      const double t = pi / 2 * (corner + double(i % (quarter + 1)) / quarter);
      const double x = corner == 0 || corner == 3 ? 20 : -20, z = corner < 2 ? 10 : -10;
      return Point3{x + 8 * std::cos(t), 0, z + 8 * std::sin(t)};
    };
    const Drawing d = wires(4 * (quarter + 1), rounded, 0.05);
    REQUIRE(d.arcs.size() == 4);
    for (const DrawnArc& arc : d.arcs) {
      CHECK(arc.end_line - arc.first_line == quarter);
      CHECK(arc.ellipse.long_radius() == Approx(8).margin(1e-6));
    }
    check_arcs(d, 0.05);
  }
}

TEST_CASE("Where something hides a part of a circle in mid-edge, the arc keeps the circle and the line its end",
          "[drawing][arcs][D22]") {
  ModelMaker maker;
  std::vector<std::uint32_t> disc;
  for (int k = 0; k < 48; ++k) disc.push_back(maker.add(20 * std::cos(pi * k / 24), 0, 20 * std::sin(pi * k / 24)));
  maker.add_face(disc);
  maker.add_face({maker.add(-30, -1, -3.3), maker.add(30, -1, -3.3), maker.add(30, -1, 4.4), maker.add(-30, -1, 4.4)});
  const Mesh mesh = maker.mesh();
  DrawingOptions options = arcs_within(0.1);
  options.hidden = HiddenLines::none;
  const Drawing with = drawn(mesh, named_view("front"), options);
  options.fit_arcs = 0;
  const Drawing without = drawn(mesh, named_view("front"), options);
  REQUIRE(with.points == without.points);
  CHECK(with.arcs.size() == 2);
  for (const DrawnArc& arc : with.arcs) CHECK(arc.ellipse.long_radius() == Approx(20).margin(1e-9));
  check_arcs(with, 0.1);
  // What is left beside the arcs are the parts of edges at the cuts.
  for (const Polyline& p : with.polylines) {
    if (with.arcs_of(p).empty()) continue;
    CHECK(with.arcs_of(p)[0].first_line == p.first_point + 1);
    CHECK(with.arcs_of(p)[0].end_line == p.end_point - 2);
  }
}

TEST_CASE("In an order for a pen each line keeps its edges, so the same are drawn by arcs", "[drawing][arcs][D18][D22]") {
  const Mesh mesh = plate_with_holes(48);
  for (const char* const view : {"front", "iso", "left"}) {
    DrawingOptions options = arcs_within(0.05);
    const auto edges_in_arcs = [&] {
      std::multiset<std::pair<PaperPoint, PaperPoint>> all;
      const Drawing d = drawn(mesh, named_view(view), options);
      for (const Polyline& p : d.polylines)
        for (const DrawnArc& arc : d.arcs_of(p))
          for (std::uint32_t k = arc.first_line; k < arc.end_line; ++k)
            all.insert(std::minmax(d.points[k], d.points[k + 1 == p.end_point ? p.first_point : k + 1]));
      return all;
    };
    const auto before = edges_in_arcs();
    options.sort_for_pen = true;
    CHECK(before == edges_in_arcs());
    CHECK((view == std::string("left") || before.size() > 250));
  }
}

TEST_CASE(
    "The image of a circle is the ellipse through the images of its points, and none where the circle reaches behind the eye",
    "[drawing][arcs]") {
  const Mesh mesh = cylinder(12, 1, 1);
  const View view = perspective_view({3, -4, 2}, {0, 0, 0}, {0, 0, 1});
  Projection projection(mesh, view, {0, 0, 0});
  projection.place({Rational(0.0), Rational(0.0)}, Rational(100.0), 50, 50);
  const PaperMap map(projection);
  for (const double radius : {0.1, 1.0, 3.0}) {
    SpaceCircle circle = {{0.25, 0.5, 0.125}, {0.6, 0, 0.8}, {0, 1, 0}, radius};
    const auto ellipse = map.image(circle);
    REQUIRE(ellipse);
    for (int k = 0; k < 32; ++k) {
      const double c = radius * std::cos(k * pi / 16), s = radius * std::sin(k * pi / 16);
      const Point2 p = map.at({circle.centre[0] + c * circle.u[0], circle.centre[1] + s, circle.centre[2] + c * circle.u[2]});
      CHECK(distance(p, ellipse->at(ellipse->parameter_of(p))) < 1e-9 * ellipse->long_radius());
    }
  }
  CHECK_FALSE(map.image({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 6}));
  // The plane of the circle holds the eye.
  CHECK_FALSE(map.image({{0, 0, 0}, {0.6, -0.8, 0}, {0, 0, 1}, 1}));
}
