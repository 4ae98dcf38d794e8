#include "hsr/sheet/model_circles.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/drawing/round_models.h"

using namespace hsr;
using namespace hsr::internal;

TEST_CASE("A cylinder has two circles and one axis, of eight sides or of many", "[sheet][circles][L5]") {
  for (const int sides : {8, 9, 12, 31, 64, 400}) {
    CAPTURE(sides);
    const auto circles = model_circles(cylinder(sides, 5, 12), 30);
    REQUIRE(circles.size() == 2);
    for (const ModelCircle& c : circles) {
      CHECK(c.radius == Approx(5));
      CHECK(std::hypot(c.centre.x, c.centre.y) < 1e-9);
      CHECK(std::fabs(c.axis.z) == Approx(1));
    }
    const auto axes = axes_of(circles, 20);
    REQUIRE(axes.size() == 1);
    CHECK(axes[0].last - axes[0].first == Approx(12));
    CHECK(axes[0].radius == Approx(5));
  }
  CHECK(model_circles(cylinder(6, 5, 12), 30).empty());  // a nut
  CHECK(model_circles(cylinder(4, 5, 12), 30).empty());
}

TEST_CASE("The holes of a plate are found on both of its sides", "[sheet][circles][L5]") {
  const auto circles = model_circles(plate_with_holes(24), 30);
  REQUIRE(circles.size() == 2 * plate_holes.size());
  for (const Hole& hole : plate_holes)
    CHECK(std::ranges::count_if(circles, [&](const ModelCircle& c) {
            return std::fabs(c.centre.x - hole.x) < 1e-9 && std::fabs(c.centre.z - hole.z) < 1e-9 &&
                   std::fabs(c.radius - hole.radius) < 1e-9 && std::fabs(c.axis.y) > 1 - 1e-9;
          }) == 2);
  const auto axes = axes_of(circles, 150);
  CHECK(axes.size() == plate_holes.size());
  for (const ModelAxis& axis : axes) CHECK(axis.last - axis.first == Approx(10));
}

TEST_CASE("The round ends of a slot are circles, an ellipse and a rounded corner are none", "[sheet][circles][L5]") {
  const double step = std::numbers::pi / 16;
  const auto slot = model_circles(prism(34, 3,
                                        [&](int k) {
                                          const double t = (k % 17) * step - std::numbers::pi / 2, side = k < 17 ? 1 : -1;
                                          return Point2{side * (10 + 4 * std::cos(t)), side * 4 * std::sin(t)};
                                        }),
                                  30);
  REQUIRE(slot.size() == 4);
  for (const ModelCircle& c : slot) {
    CHECK(c.radius == Approx(4));
    CHECK(std::fabs(c.centre.x) == Approx(10));
  }
  CHECK(model_circles(prism(48, 3,
                            [&](int k) {
                              const double t = 2 * std::numbers::pi * k / 48;
                              return Point2{6 * std::cos(t), 5 * std::sin(t)};
                            }),
                      30)
            .empty());
  // A quarter at one corner of a square.
  CHECK(model_circles(prism(12, 3,
                            [&](int k) {
                              if (k < 9) return Point2{5 + 5 * std::cos(k * step), 5 + 5 * std::sin(k * step)};
                              return k == 9 ? Point2{0, 10} : k == 10 ? Point2{0, 0} : Point2{10, 0};
                            }),
                      30)
            .empty());
}

TEST_CASE("A circle of coordinates that are rounded to floats is found", "[sheet][circles][L5]") {
  const auto circles = model_circles(
      prism(90, 3,
            [](int k) {
              const double t = 2 * std::numbers::pi * k / 90;
              return Point2{static_cast<float>(1234.5 + 7 * std::cos(t)), static_cast<float>(-987 + 7 * std::sin(t))};
            }),
      30);
  REQUIRE(circles.size() == 2);
  CHECK(circles[0].radius == Approx(7).epsilon(1e-4));
  CHECK(axes_of(circles, 20).size() == 1);
}
