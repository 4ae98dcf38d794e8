#include "hsr/io/write/dashes.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

using namespace hsr;
using namespace hsr::internal;

namespace {

Pen dashed_pen(double width = 0.25) { return {.width = width, .dashes = {12 * width, 3 * width}}; }

DashedPath dashed(const std::vector<PaperPoint>& points, bool closed, const Pen& pen) {
  return dashed_path(path_of(points, closed), pen);
}

/// All points of a path of straight lines; of a closed one the first again at the end.
std::vector<PaperPoint> points_of(const Path& path) {
  std::vector<PaperPoint> points = {path.parts.front().from};
  for (const PathPart& part : path.parts) points.push_back(part.to);
  return points;
}

std::vector<std::vector<PaperPoint>> dash_points(const DashedPath& path) {
  std::vector<std::vector<PaperPoint>> all;
  for (const Path& dash : dashes_of(path)) all.push_back(points_of(dash));
  return all;
}

std::vector<double> lengths(double mm, const Pen& pen = dashed_pen()) {
  return dashed({{0, 0}, {std::llround(mm * 1000), 0}}, false, pen).lengths;
}

double length_of(const std::vector<PaperPoint>& line) {
  double sum = 0;
  for (std::size_t k = 0; k + 1 < line.size(); ++k)
    sum += std::hypot(double(line[k + 1].x - line[k].x), double(line[k + 1].y - line[k].y)) / 1000;
  return sum;
}

}  // namespace

TEST_CASE("A dashed line begins and ends with a dash, and its gaps are as they should be", "[write][dashes][D16]") {
  CHECK(lengths(6.75) == std::vector<double>{3, 0.75});
  CHECK(lengths(10.5) == std::vector<double>{3, 0.75});  // three dashes
  for (double mm = 2.5; mm < 40; mm += 0.123) {
    const DashedPath path = dashed({{0, 0}, {0, std::llround(mm * 1000)}}, false, dashed_pen());
    const auto dashes = dash_points(path);
    REQUIRE(dashes.size() >= 2);
    CHECK(dashes.front().front() == path.path.parts.front().from);
    CHECK(dashes.back().back() == path.path.parts.back().to);
    for (std::size_t k = 0; k + 1 < dashes.size(); ++k)
      CHECK(double(dashes[k + 1].front().y - dashes[k].back().y) == Approx(750).margin(1.1));
    for (const auto& dash : dashes) CHECK(length_of(dash) == Approx(length_of(dashes.front())).margin(0.0021));
    if (mm < 6.75) continue;
    CHECK(length_of(dashes.front()) > 2);
    CHECK(length_of(dashes.front()) < 4.2);
  }
}

TEST_CASE("What is too short for two dashes has two shorter ones, or is one dash", "[write][dashes][D16]") {
  CHECK(lengths(2.25) == std::vector<double>{0.75, 0.75});
  CHECK(lengths(1.5) == std::vector<double>{0.5, 0.5});
  CHECK(lengths(0.75) == std::vector<double>{0.25, 0.25});
  CHECK(lengths(0.7) == std::vector<double>{0.7});
  CHECK(lengths(1.5, dashed_pen(0.7)) == std::vector<double>{1.5});
  CHECK(dash_points({path_of(std::vector<PaperPoint>{{0, 0}, {1500, 0}}, false), lengths(1.5)}) ==
        std::vector<std::vector<PaperPoint>>{{{0, 0}, {500, 0}}, {{1000, 0}, {1500, 0}}});
}

TEST_CASE("Corners have dashes on both sides, curves run on", "[write][dashes][D16]") {
  const std::vector<PaperPoint> corner = {{0, 0}, {7000, 0}, {7000, 8000}};
  const auto dashes = dash_points(dashed(corner, false, dashed_pen()));
  REQUIRE(dashes.size() == 3);
  CHECK(dashes[0] == std::vector<PaperPoint>{{0, 0}, {3125, 0}});
  CHECK(dashes[1] == std::vector<PaperPoint>{{3875, 0}, {7000, 0}, {7000, 3625}});
  CHECK(dashes[2] == std::vector<PaperPoint>{{7000, 4375}, {7000, 8000}});

  const std::vector<PaperPoint> square = {{0, 5000}, {0, 0}, {10000, 0}, {10000, 10000}, {0, 10000}};
  const DashedPath around = dashed(square, true, dashed_pen());
  CHECK(points_of(around.path).front() == PaperPoint{0, 0});  // a corner
  CHECK(points_of(around.path).back() == PaperPoint{0, 0});
  CHECK(std::accumulate(around.lengths.begin(), around.lengths.end(), 0.0) == Approx(40));
  const auto sides = dash_points(around);
  CHECK(sides.size() == 8);
  int corners = 0;
  for (const auto& dash : sides)
    if (dash.size() == 3 && dash[1] != square[0]) ++corners;  // one has the point in the middle of a side
  CHECK(corners == 4);

  std::vector<PaperPoint> circle;
  for (int k = 0; k < 72; ++k)
    circle.push_back({std::llround(10000 * std::cos(k * 0.0872664626)), std::llround(10000 * std::sin(k * 0.0872664626))});
  const DashedPath ring = dashed(circle, true, dashed_pen());
  REQUIRE(ring.lengths.size() == 2);
  CHECK(ring.lengths[1] == 0.75);
  CHECK(62.81 / (ring.lengths[0] + 0.75) == Approx(17).epsilon(1e-3));
  CHECK(dashes_of(ring).size() == 17);
}

TEST_CASE("A zigzag of short pieces is dashed as one line", "[write][dashes][D16]") {
  std::vector<PaperPoint> zigzag;
  for (int k = 0; k <= 100; ++k) zigzag.push_back({k * 200, k % 2 * 300});
  const auto dashes = dash_points(dashed(zigzag, false, dashed_pen()));
  double inked = 0;
  for (const auto& dash : dashes) inked += length_of(dash);
  CHECK(dashes.size() > 7);
  CHECK(inked < 0.9 * length_of(zigzag));
}

TEST_CASE("Other patterns keep their dots and gaps, and stretch where dashes are the lesser part", "[write][dashes][D16]") {
  const Pen chain = {.width = 0.5, .dashes = {12, 1.5, 0.25, 1.5}};
  const auto period = lengths(30, chain);
  REQUIRE(period.size() == 4);
  CHECK(period[1] == 1.5);
  CHECK(period[2] == 0.25);
  CHECK(2 * period[0] + 3.25 == Approx(30));
  const auto dots = lengths(10, {.width = 0.5, .dashes = {0.25, 1.5}});
  CHECK(dots[0] / dots[1] == Approx(0.25 / 1.5));
  CHECK(7 * dots[0] + 6 * dots[1] == Approx(10));
}
