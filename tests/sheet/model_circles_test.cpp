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

TEST_CASE("A square with its corners cut off is no circle, an octagon is one", "[sheet][circles][L5]") {
  const auto cut_square = [](double cut) {
    return prism(8, 3, [&](int k) {
      const double a = 10 - cut;
      const Point2 corners[] = {{10, -a}, {10, a}, {a, 10}, {-a, 10}, {-10, a}, {-10, -a}, {-a, -10}, {a, -10}};
      return corners[k];
    });
  };
  CHECK(model_circles(cut_square(2), 30).empty());
  CHECK(model_circles(cut_square(10 * (2 - std::sqrt(2.0))), 30).size() == 2);
}

TEST_CASE("A circle with corners in odd places is found", "[sheet][circles][L5]") {
  // Beside some of them another one, as cutting solids leaves them.
  std::vector<double> places;
  for (int k = 0; k < 36; ++k) {
    places.push_back(k * std::numbers::pi / 18);
    if (k % 5 == 2) places.push_back(k * std::numbers::pi / 18 + 0.004);
    if (k % 7 == 3) places.push_back(k * std::numbers::pi / 18 + 0.1);
  }
  const auto circles = model_circles(prism(static_cast<int>(places.size()), 3,
                                           [&](int k) {
                                             const double t = places[static_cast<std::size_t>(k)];
                                             return Point2{7 * std::cos(t), 7 * std::sin(t)};
                                           }),
                                     5);
  REQUIRE(circles.size() == 2);
  CHECK(circles[0].edges.size() == places.size());
}
