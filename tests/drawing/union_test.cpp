// What is drawn is the union of the parts: against the dumbest correct union, in rationals.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <random>

#include "hsr/drawing/drawing.h"
#include "hsr/lines/visible_lines.h"

using namespace hsr;

namespace {

using Interval = std::pair<Rational, Rational>;
using ImagePoint = std::array<Rational, 2>;

/// a x + b y + c = 0 with the first of a and b that is not 0 made 1.
std::array<Rational, 3> line_of(const ImagePoint& p, const ImagePoint& q) {
  std::array<Rational, 3> l = {p[1] - q[1], q[0] - p[0], p[0] * q[1] - p[1] * q[0]};
  const Rational divisor = l[0].sign() == Sign::zero ? l[1] : l[0];
  for (Rational& x : l) x = x / divisor;
  return l;
}

double covered(std::vector<Interval> intervals) {
  std::sort(intervals.begin(), intervals.end());
  Rational sum, end;
  bool any = false;
  for (const auto& [from, to] : intervals) {
    if (any && to <= end) continue;
    sum = sum + (to - (any && from < end ? end : from));
    end = to;
    any = true;
  }
  return sum.to_double();
}

struct Lengths {
  double visible = 0, hidden = 0;
};

Lengths expected(const Mesh& mesh, const View& view, const VisibleLines& lines) {
  struct OnLine {
    std::vector<Interval> visible, all;
  };
  std::map<std::array<Rational, 3>, OnLine> on_lines;
  for (const Line& line : lines.lines) {
    const SupportingLine support = supporting_line_of(mesh, lines, line);
    const auto cuts = lines.cuts_of(line);
    std::vector<ImagePoint> points;
    for (const Cut& cut : cuts) {
      points.push_back(image(view, exact_point(mesh, view, support, cut)));
    }
    for (std::uint32_t k = 0; k < line.intervals(); ++k) {
      const auto l = line_of(points[k], points[k + 1]);
      const std::size_t axis = l[1].sign() == Sign::zero ? 1 : 0;  // x, but for an upright line y
      const Interval interval = std::minmax(points[k][axis], points[k + 1][axis]);
      on_lines[l].all.push_back(interval);
      if (!line.hidden(k)) on_lines[l].visible.push_back(interval);
    }
  }
  Lengths result;
  for (const auto& [l, parts] : on_lines) {
    const double stretch = l[1].sign() == Sign::zero ? 1 : std::hypot(1, (l[0] / l[1]).to_double());
    const double visible = covered(parts.visible) * stretch;
    result.visible += visible;
    result.hidden += covered(parts.all) * stretch - visible;
  }
  return result;
}

Lengths drawn(const Drawing& d) {
  Lengths result;
  for (const Polyline& p : d.polylines) {
    const auto points = d.points_of(p);
    double length = 0;
    for (std::size_t k = 0; k + 1 < points.size() + (p.closed ? 1 : 0); ++k) {
      const PaperPoint &a = points[k], &b = points[(k + 1) % points.size()];
      length += std::hypot(static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y)) / 1000;
    }
    (p.hidden ? result.hidden : result.visible) += length;
  }
  return result;
}

struct Soup {
  Mesh mesh;
  View view;
};

Soup soup(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const bool boxes = seed % 2 == 0;
  const auto coordinate = [&] { return static_cast<double>(random() % 5) - 2; };
  std::vector<Point3> points;
  Polygons polygons;
  const auto face = [&](std::initializer_list<Point3> corners) {
    for (const Point3& p : corners) {
      polygons.corners.push_back(static_cast<std::uint32_t>(points.size()));
      points.push_back(p);
    }
    polygons.first.push_back(static_cast<std::uint32_t>(points.size()));
  };
  for (int k = 0; k < (boxes ? 4 : 8); ++k) {
    const Point3 a = {coordinate(), coordinate(), coordinate()}, b = {coordinate(), coordinate(), coordinate()};
    if (!boxes) {
      face({a, b, {coordinate(), coordinate(), coordinate()}});
      continue;
    }
    for (const double z : {a.z, b.z}) face({{a.x, a.y, z}, {b.x, a.y, z}, {b.x, b.y, z}, {a.x, b.y, z}});
    for (const double x : {a.x, b.x}) face({{x, a.y, a.z}, {x, b.y, a.z}, {x, b.y, b.z}, {x, a.y, b.z}});
    for (const double y : {a.y, b.y}) face({{a.x, y, a.z}, {b.x, y, a.z}, {b.x, y, b.z}, {a.x, y, b.z}});
  }
  for (int k = 0; k < 3; ++k) {
    const auto first = static_cast<std::uint32_t>(points.size());
    points.push_back({coordinate(), coordinate(), coordinate()});
    points.push_back({coordinate(), coordinate(), coordinate()});
    polygons.segments.push_back({first, first + 1});
  }
  Soup result{make_mesh(points, polygons), {}};
  switch (random() % 5) {
    case 0:
      result.view = named_view("front");
      break;
    case 1:
      result.view = named_view("top");
      break;
    case 2:
      result.view = parallel_view({1, 1, 1}, {0, 0, 1});
      break;
    case 3:
      result.view = parallel_view({1, -2, 0}, {0, 0, 1});
      break;
    default:
      result.view = perspective_view({3, -5, 2}, {0, 0, 0}, {0, 0, 1});
  }
  return result;
}

}  // namespace

TEST_CASE("What is drawn is the union of the parts, visible before hidden, on random scenes", "[drawing][property][D1]") {
  std::uint64_t duplicates = 0, merged = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    CAPTURE(seed);
    const Soup s = soup(seed);
    LineOptions all;
    all.method = LineMethod::roberts;
    all.classes.fill(true);
    const VisibleLines lines = visible_lines(s.mesh, s.view, all);
    DrawingOptions options;
    options.scale = 1000;
    options.hidden = HiddenLines::dashed;
    const Drawing d = draw(s.mesh, s.view, lines, options);
    const Lengths found = drawn(d), wanted = expected(s.mesh, s.view, lines);
    // Each end is rounded by at most half a thousandth either way.
    const double slack = 0.002 * static_cast<double>(d.points.size() + 1) + 0.01 * static_cast<double>(d.short_dropped) + 1e-6;
    REQUIRE(found.visible == Approx(1000 * wanted.visible).margin(slack).epsilon(0));
    REQUIRE(found.hidden == Approx(1000 * wanted.hidden).margin(slack).epsilon(0));
    duplicates += d.visible_under_visible + d.hidden_under_visible + d.hidden_under_hidden;
    merged += d.merged;

    options.hidden = HiddenLines::none;
    const Lengths visible_only = drawn(draw(s.mesh, s.view, lines, options));
    REQUIRE(visible_only.visible == Approx(found.visible).margin(slack).epsilon(0));
    REQUIRE(visible_only.hidden == 0);
  }
  CHECK(duplicates > 1000);  // the scenes are worth their name
  CHECK(merged > 100);
}

TEST_CASE("The union of the oracle counts a place once", "[drawing]") {
  CHECK(covered({{0.0, 2.0}, {1.0, 3.0}, {1.5, 1.75}, {4.0, 5.0}}) == 4);
  CHECK(covered({}) == 0);
}
