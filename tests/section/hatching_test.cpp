#include "hsr/drawing/hatching.h"

#include <catch2/catch.hpp>
#include <cmath>

namespace hsr::internal {
namespace {

using Ring = std::vector<PaperPoint>;

double length_of(const std::vector<std::array<PaperPoint, 2>>& lines) {
  double sum = 0;
  for (const auto& [p, q] : lines) sum += std::hypot(static_cast<double>(q.x - p.x), static_cast<double>(q.y - p.y)) / 1000;
  return sum;
}

TEST_CASE("hatching covers a square evenly, and no hole in it", "[section][drawing][X7]") {
  const Ring square = {{0, 0}, {0, 40000}, {40000, 40000}, {40000, 0}},
             hole = {{10000, 10000}, {20000, 10000}, {20000, 20000}, {10000, 20000}};
  for (const double degrees : {45.0, 135.0, 0.0, 30.0}) {
    const Hatch hatch{degrees, 2, 0};
    // The lines are as long as the area is large, over their distance.
    CHECK(length_of(hatch_lines({square}, hatch)) == Approx(1600 / 2.0).epsilon(0.03));
    CHECK(length_of(hatch_lines({square, hole}, hatch)) == Approx(1500 / 2.0).epsilon(0.03));
    for (const auto& [p, q] : hatch_lines({square, hole}, hatch)) {
      const PaperPoint middle = {(p.x + q.x) / 2, (p.y + q.y) / 2};
      CHECK_FALSE((middle.x > 10001 && middle.x < 19999 && middle.y > 10001 && middle.y < 19999));
      const double turn = std::atan2(-static_cast<double>(q.y - p.y), static_cast<double>(q.x - p.x)) * 180 / M_PI;
      CHECK(std::fabs(std::remainder(turn - degrees, 180)) < 1);
    }
  }
}

TEST_CASE("a cap is hatched by its thickness, and filled where it is thin", "[section][drawing][X7]") {
  const auto strip = [](std::int64_t width) { return Ring{{0, 0}, {0, 100000}, {width, 100000}, {width, 0}}; };
  const auto alone = [](const Ring& ring, std::uint32_t style, double pen, double unit = 1) {
    return hatch_for(thickness_of({ring}), thickness_of({ring}), style, pen, unit);
  };
  CHECK(alone(strip(100000), 0, 0.25).spacing == 4);
  CHECK(alone(strip(6000), 0, 0.25).spacing == Approx(2).epsilon(0.1));
  CHECK(alone(strip(1500), 0, 0.25).spacing == 1);
  CHECK(alone(strip(600), 0, 0.25).spacing == 0.25);  // as wide as the pen
  CHECK(alone(strip(6000), 1, 0.25).degrees == 135);
  // All caps of an object are hatched as its thickest is, but for what is filled.
  CHECK(hatch_for(2, 6, 0, 0.25).spacing == hatch_for(6, 6, 0, 0.25).spacing);
  CHECK(hatch_for(0.6, 6, 0, 0.25).spacing == 0.25);
  // In other units of the same paper.
  Ring larger = strip(6000);
  for (PaperPoint& p : larger) p = {10 * p.x, 10 * p.y};
  CHECK(alone(larger, 0, 0.25, 10).spacing == Approx(10 * alone(strip(6000), 0, 0.25).spacing));
}

}  // namespace
}  // namespace hsr::internal
