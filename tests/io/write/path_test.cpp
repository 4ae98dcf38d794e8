#include "hsr/io/write/path.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "hsr/io/write/dashes.h"
#include "hsr/io/write/dxf.h"
#include "hsr/io/write/eps.h"
#include "hsr/io/write/hpgl.h"
#include "hsr/io/write/svg.h"
#include "hsr/io/write/tikz.h"
#include "tests/drawing/distance_to_arc.h"

using namespace hsr;
using namespace hsr::internal;

namespace {

constexpr double pi = std::numbers::pi;

PaperPoint rounded(const Point2& p) { return {std::llround(p.x * 1000), std::llround(p.y * 1000)}; }

EllipseArc ellipse(double a, double b, double degrees, double from, double to) {
  const double c = std::cos(degrees * pi / 180), s = std::sin(degrees * pi / 180);
  return {{50, 40}, {a * c, a * s}, {-b * s, b * c}, from, to};
}
PathPart part_of(const EllipseArc& arc) { return {rounded(arc.at(arc.from)), rounded(arc.at(arc.to)), true, arc}; }

const EllipseArc arcs[] = {ellipse(10, 10, 0, 0, pi / 2),     ellipse(10, 10, 0, 1, -3),   ellipse(30, 12, 40, -2, 3),
                           ellipse(30, 12, -70, 2, -4.25),    ellipse(80, 5, 10, 0, 6.25), ellipse(100, 99, 3, 0.5, 0.75),
                           ellipse(20, 15, 30, 1, 1 + 2 * pi)};

/// From one point to another by an arc, then straight on: the arc stands for the lines between some points of the polyline.
Drawing with_arc(const EllipseArc& arc, bool closed = false, bool hidden = false) {
  Drawing d;
  Polyline p;
  for (int k = 0; k <= 8; ++k) d.points.push_back(rounded(arc.at(arc.from + k * arc.sweep() / 8)));
  if (arc.is_whole()) d.points.pop_back();
  if (!arc.is_whole()) d.points.push_back({d.points.back().x + 10000, d.points.back().y});
  p.end_point = static_cast<std::uint32_t>(d.points.size());
  p.closed = closed;
  p.hidden = hidden;
  p.end_arc = 1;
  d.arcs.push_back({0, 8, arc});
  d.arc_tolerance = 0.05;
  d.polylines.push_back(p);
  d.width = d.height = 100;
  return d;
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("Curves and chords are as near to an arc as they should be, from end to end", "[write][path][D22]") {
  for (const EllipseArc& arc : arcs)
    for (const double tolerance : {0.02, 1.0}) {
      const PathPart part = part_of(arc);
      const double allowed = std::max(tolerance / 100, 1e-4);
      Point2 at = arc.at(arc.from);
      double worst = 0;
      const auto curves = beziers(part, tolerance);
      for (std::size_t i = 0; i < curves.size(); ++i) {
        const Bezier& b = curves[i];
        const Point2 to = arc.at(arc.from + double(i + 1) * arc.sweep() / double(curves.size()));  // not rounded
        CHECK(distance(millimetres(b.to), to) < 0.00075);
        for (double t = 0.05; t < 1; t += 0.05) {
          const double s = 1 - t;
          const auto mix = [&](double p, double q, double r, double u) {
            return s * s * s * p + 3 * s * s * t * q + 3 * s * t * t * r + t * t * t * u;
          };
          const Point2 p = {mix(at.x, b.first.x, b.second.x, to.x), mix(at.y, b.first.y, b.second.y, to.y)};
          worst = std::max(worst, distance(p, arc));
        }
        at = to;
      }
      CHECK(worst <= allowed);
      CHECK(curves.back().to == part.to);
      const auto points = flattened({{part}, false}, tolerance);
      CHECK(points.front() == part.from);
      CHECK(points.back() == part.to);
      for (std::size_t k = 0; k + 1 < points.size(); ++k) {
        const Point2 a = millimetres(points[k]), b = millimetres(points[k + 1]), middle = {(a.x + b.x) / 2, (a.y + b.y) / 2};
        CHECK(distance(middle, arc) <= tolerance + 0.001);
      }
    }
}

TEST_CASE("An arc is as long as its chords, and is cut where it should be", "[write][path][D16]") {
  CHECK(part_of(ellipse(10, 10, 0, 0, pi / 2)).length() == Approx(5 * pi).epsilon(1e-12));
  CHECK(part_of(ellipse(2, 1, 25, 0, 2 * pi)).length() == Approx(9.688448220547675).epsilon(1e-9));
  for (const EllipseArc& arc : arcs) {
    const PathPart part = part_of(arc);
    double sum = 0;
    for (int k = 0; k < 100000; ++k)
      sum += distance(arc.at(arc.from + k * arc.sweep() / 1e5), arc.at(arc.from + (k + 1) * arc.sweep() / 1e5));
    CHECK(part.length() == Approx(sum).epsilon(2e-6));
    const double first = 0.3 * sum, second = 0.7 * sum;
    const PathPart a = part.between(0, first), b = part.between(first, second), c = part.between(second, part.length());
    CHECK(a.from == part.from);
    CHECK(a.to == b.from);
    CHECK(b.to == c.from);
    CHECK(c.to == part.to);
    CHECK(a.length() == Approx(first).epsilon(1e-5));
    CHECK(b.length() == Approx(second - first).epsilon(1e-5));
    const Point2 ahead = part.leaving(), from = arc.at(arc.from), next = arc.at(arc.from + arc.sweep() * 1e-6);
    CHECK((next.x - from.x) * ahead.x + (next.y - from.y) * ahead.y > 0);
  }
}

TEST_CASE("Arcs are dashed as the curve that they are", "[write][path][dashes][D16]") {
  const Pen pen = {.width = 0.25, .dashes = {3, 0.75}};
  const DashedPath whole = dashed_path({{part_of(ellipse(10, 10, 0, 0, 2 * pi))}, true}, pen);
  CHECK(whole.lengths.size() == 2);
  const auto dashes = dashes_of(whole);
  CHECK(dashes.size() == 17);
  for (const Path& dash : dashes) {
    REQUIRE(dash.parts.size() == 1);
    CHECK(dash.parts[0].is_arc);
    CHECK(dash.parts[0].length() == Approx(20 * pi / 17 - 0.75).margin(1e-3));
  }
  // A quarter of a circle, and straight on at a right angle: a dash over the corner, and one at each end.
  const Path bent = {{part_of(ellipse(10, 10, 0, 0, pi / 2)), {{50000, 50000}, {50000, 60000}}}, false};
  const auto pieces = dashes_of(dashed_path(bent, pen));
  CHECK(pieces.front().parts.front().from == PaperPoint{60000, 40000});
  CHECK(pieces.back().parts.back().to == PaperPoint{50000, 60000});
  CHECK(std::any_of(pieces.begin(), pieces.end(), [](const Path& p) { return p.parts.size() == 2; }));
}

TEST_CASE("Each format has arcs in its own words", "[write][svg][eps][dxf][tikz][hpgl][D13][D22]") {
  const Drawing circle = with_arc(ellipse(20, 20, 0, 0, 2 * pi), true), bend = with_arc(ellipse(20, 20, 0, 0, pi / 2)),
                oval = with_arc(ellipse(20, 10, 30, 0, -pi));
  CHECK(contains(svg(circle), "d=\"M70 40A20 20 0 0 1 40 57.321A20 20 0 0 1 40 22.679A20 20 0 0 1 70 40Z\""));
  CHECK(contains(svg(bend), "d=\"M70 40A20 20 0 0 1 50 60L60 60\""));
  CHECK(contains(svg(oval), "A20 10 30 0 0 "));
  CHECK(contains(eps(bend), "70 40 m\n70 "));
  CHECK(contains(eps(bend), " 60 c\n60 60 l\nS\n"));
  CHECK(contains(tikz(bend), "\\draw (70,40)\n..controls (70,"));
  CHECK(contains(tikz(bend), ")..(50,60)\n--(60,60);"));
  CHECK(contains(tikz(circle), ")..(70,40)\n--cycle;"));
  CHECK(contains(hpgl(circle), "PU2800,2400;PD2"));
  // In hundredths of the unit.
  Drawing d = circle;
  d.scale = 1;
  CHECK(contains(dxf(d), "CIRCLE\n8\nVISIBLE_OUTLINE\n10\n50.0\n20\n-40.0\n30\n0.0\n40\n20.0\n1001\nHSR\n"));
  CHECK(contains(dxf(bend), "VERTEX\n8\nVISIBLE_OUTLINE\n10\n70.0\n20\n-40.0\n30\n0.0\n42\n-0.414213562373\n0\nVERTEX\n"));
  Drawing only = bend;
  only.points.pop_back();
  only.polylines[0].end_point = 9;
  CHECK(contains(dxf(only), "ARC\n8\nVISIBLE_OUTLINE\n10\n50.0\n20\n-40.0\n30\n0.0\n40\n20.0\n50\n270.0\n51\n0.0\n1001\n"));
  CHECK(
      contains(dxf(oval, {DxfVersion::r2000}), "AcDbEllipse\n10\n50.0\n20\n-40.0\n30\n0.0\n11\n17.321\n21\n-10.0\n31\n0.0\n"));
  CHECK_FALSE(contains(dxf(oval), "ELLIPSE"));
}
