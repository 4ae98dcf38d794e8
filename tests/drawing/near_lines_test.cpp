// What runs beside a stronger line at no more than 0.01 mm on the paper.
#include <tbb/global_control.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "tests/drawing/hand_made_lines.h"

using namespace hsr;

namespace {

using Points = std::vector<PaperPoint>;
using Edges = std::vector<std::array<std::uint32_t, 2>>;

Drawing distinct(const HandMadeLines& h) { return h.draw(HiddenLines::dashed, 1, true); }
Points points(const Drawing& d, std::size_t k) {
  const auto p = d.points_of(d.polylines.at(k));
  return {p.begin(), p.end()};
}
Edges edges(const Drawing& d, std::size_t k) {
  const auto e = d.edges_of(d.polylines.at(k));
  return {e.begin(), e.end()};
}

double distance(double x, double y, const PaperPoint& a, const PaperPoint& b) {
  const auto ax = static_cast<double>(a.x), ay = static_cast<double>(a.y);
  const auto dx = static_cast<double>(b.x) - ax, dy = static_cast<double>(b.y) - ay;
  const double t = std::clamp(((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  return std::hypot(x - ax - t * dx, y - ay - t * dy);
}

/// From the point to the nearest line of the drawing, thousandths of a millimetre.
double distance(double x, double y, const Drawing& d) {
  double least = 1e300;
  for (const Polyline& p : d.polylines) {
    const auto at = d.points_of(p);
    for (std::size_t k = 0; k + 1 < at.size() + (p.closed ? 1 : 0); ++k)
      least = std::min(least, distance(x, y, at[k], at[(k + 1) % at.size()]));
  }
  return least;
}

}  // namespace

TEST_CASE("Of two hidden lines 0.005 mm apart one is drawn and names both; 0.02 mm apart both are", "[drawing][near]") {
  for (const bool steep : {false, true}) {
    HandMadeLines h;
    const auto at = [&](double x, double z) { return steep ? Point3{z, 0, x} : Point3{x, 0, z}; };
    h.add(at(-10, 0), at(10, 0), EdgeClass::sharp, true);
    h.add(at(-10, 0.005), at(10, 0.005), EdgeClass::sharp, true);
    h.add(at(-10, 0.025), at(10, 0.025), EdgeClass::sharp, true);
    INFO(steep);
    const Drawing d = distinct(h);
    REQUIRE(d.polylines.size() == 2);
    CHECK(d.near_coincident == 1);
    CHECK(edges(d, 0) == Edges{{0, 1}, {2, 3}});
    CHECK(edges(d, 1) == Edges{{4, 5}});
    CHECK(h.draw().polylines.size() == 3);
    CHECK(h.draw().near_coincident == 0);
  }
}

TEST_CASE("Exactly 0.01 mm is near, 0.011 mm is not", "[drawing][near][D3]") {
  for (const int apart : {10, 11}) {
    HandMadeLines h;
    h.add({-10, 0, 0}, {10, 0, 0});
    h.add({-9, 0, 0.001 * apart}, {9, 0, 0.001 * apart});
    INFO(apart);
    CHECK(distinct(h).polylines.size() == (apart == 10 ? 1 : 2));
  }
}

TEST_CASE("A hidden line 0.005 mm beside a visible one is not drawn, longer or shorter", "[drawing][near][D3]") {
  for (const double end : {8.0, 10.009}) {
    HandMadeLines h;
    h.add({-end, 0, 0.005}, {end, 3, 0.005}, EdgeClass::outline, true);
    h.add({10, 0, 0}, {-10, 0, 0}, EdgeClass::smooth);
    const Drawing d = distinct(h);
    INFO(end);
    REQUIRE(d.polylines.size() == 1);
    CHECK_FALSE(d.polylines[0].hidden);
    CHECK(points(d, 0).size() == 2);
    CHECK(edges(d, 0) == Edges{{0, 1}, {2, 3}});
  }
}

TEST_CASE("Of visible lines beside each other the first class is drawn", "[drawing][near]") {
  HandMadeLines h;
  h.add({-20, 0, 0}, {20, 0, 0}, EdgeClass::sharp);
  h.add({-10, 0, 0.004}, {10, 0, 0.004}, EdgeClass::outline);
  const Drawing d = distinct(h);
  REQUIRE(d.polylines.size() == 3);
  CHECK(d.polylines[0].edge_class == EdgeClass::outline);
  CHECK(d.polylines[1].edge_class == EdgeClass::sharp);
  CHECK(d.polylines[2].edge_class == EdgeClass::sharp);
}

TEST_CASE("Where a line reaches beyond a stronger one beside it, the rest of it is drawn", "[drawing][near]") {
  HandMadeLines h;
  h.add({-5, 0, 0.004}, {5, 0, 0.004});
  h.add({-10, 5, 0}, {10, 5, 0}, EdgeClass::outline, true);
  const Drawing d = distinct(h);
  REQUIRE(d.polylines.size() == 3);
  CHECK(d.near_coincident == 1);
  CHECK(points(d, 0) == Points{{40000, 50002}, {44991, 50002}});
  CHECK(points(d, 1) == Points{{55009, 50002}, {60000, 50002}});
  CHECK(points(d, 2) == Points{{45000, 49998}, {55000, 49998}});
  CHECK(edges(d, 2) == Edges{{0, 1}, {2, 3}});
}

TEST_CASE("Of lines side by side 0.008 mm apart every second one is drawn", "[drawing][near]") {
  HandMadeLines h;
  for (int k = 0; k < 7; ++k) h.add({-10, 0, 0.008 * k}, {10, 0, 0.008 * k}, EdgeClass::sharp, true);
  const Drawing d = distinct(h);
  REQUIRE(d.polylines.size() == 4);
  CHECK(d.near_coincident == 3);
  for (const Polyline& p : d.polylines) CHECK(d.points_of(p)[0].y % 2 == d.points_of(d.polylines[0])[0].y % 2);
}

TEST_CASE("A fine polyline keeps all its points, straight, round and in zigzag", "[drawing][near]") {
  for (const double step : {0.001, 0.003, 0.007, 0.012, 0.02})
    for (const int shape : {0, 1, 2}) {
      const auto at = [&](int i) {
        if (shape == 0) return Point3{step * i, 0, 0.05 * i * step * (i % 2)};
        if (shape == 1) {
          const double angle = 6.283185307179586 / 200 * i, radius = step * 200 / 6.283185307179586;
          return Point3{radius * std::cos(angle), 0, radius * std::sin(angle)};
        }
        return Point3{step * i, 0, step * (i % 2)};
      };
      HandMadeLines h;
      for (int i = 0; i < 199; ++i) h.add(at(i), at(i + 1));
      const Drawing with = distinct(h), without = h.draw();
      INFO(step << " " << shape);
      CHECK(with.near_coincident == 0);
      CHECK(with.points == without.points);
      CHECK(with.polylines.size() == without.polylines.size());
    }
}

TEST_CASE("Lines that cross, or part at a common end, or continue each other stay whole", "[drawing][near]") {
  HandMadeLines h;
  h.add({-10, 0, 0}, {10, 0, 0});
  h.add({-10, 0, -5}, {10, 0, 5}, EdgeClass::outline, true);
  h.add({0, 0, -10}, {0, 0, 10}, EdgeClass::sharp);
  h.add({-10, 1, 0}, {10, 1, 1}, EdgeClass::sharp);
  h.add({10.004, 1, 0.001}, {20, 1, 0.001}, EdgeClass::sharp);
  const Drawing with = distinct(h);
  CHECK(with.near_coincident == 0);
  CHECK(with.points == h.draw().points);
}

TEST_CASE("Two rims 0.004 mm apart, cut differently, are drawn as one closed path", "[drawing][near]") {
  HandMadeLines h;
  const auto rim = [&](int n, double shift, double y) {
    const auto at = [&](int i) {
      const double angle = 6.283185307179586 / n * (i % n);
      return Point3{10 * std::cos(angle) + shift, y, 10 * std::sin(angle)};
    };
    for (int i = 0; i < n; ++i) h.add(at(i), at(i + 1), EdgeClass::sharp, true);
  };
  rim(100, 0, 0);
  rim(200, 0.004, 1);  // 10 mm (1 - cos(pi / 100)) are 0.005 mm
  const Drawing d = distinct(h);
  REQUIRE(d.polylines.size() == 1);
  CHECK(d.polylines[0].closed);
  CHECK(edges(d, 0).size() == 300);
}

TEST_CASE("Nothing is left out but beside a line that is drawn, for any number of threads", "[drawing][near][property]") {
  std::uint64_t left_out = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    std::mt19937_64 random(seed);
    const auto integer = [&](int n) { return static_cast<double>(random() % static_cast<std::uint64_t>(n)); };
    HandMadeLines h;
    const double size = seed % 2 == 0 ? 40 : 0.2;
    for (int k = 0; k < 60; ++k) {
      const auto coordinate = [&] { return integer(5) / 4 * size + 0.001 * integer(13); };
      const double y = integer(3);
      h.add({coordinate(), y, coordinate()}, {coordinate(), y, coordinate()}, static_cast<EdgeClass>(random() % 6),
            random() % 2 == 0);
    }
    const Drawing without = h.draw(), with = distinct(h);
    left_out += with.near_coincident;
    INFO(seed);
    for (const Polyline& p : without.polylines) {
      const auto at = without.points_of(p);
      for (std::size_t k = 0; k + 1 < at.size(); ++k)
        for (int i = 0; i <= 64; ++i) {
          const double t = i / 64.0;
          const double x = static_cast<double>(at[k].x) * (1 - t) + static_cast<double>(at[k + 1].x) * t;
          const double y = static_cast<double>(at[k].y) * (1 - t) + static_cast<double>(at[k + 1].y) * t;
          REQUIRE(distance(x, y, with) <= 10 + 10);  // 10 for what is dropped as too short
        }
    }
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    const Drawing alone = distinct(h);
    CHECK(alone.points == with.points);
    CHECK(alone.edges == with.edges);
  }
  CHECK(left_out > 300);
}

TEST_CASE("Of many lines each hides what runs beside it, however many are taken at once", "[drawing][near]") {
  HandMadeLines h;
  constexpr int n = 6000;
  for (int k = 0; k < n; ++k) h.add({0, 0, 0.05 * k}, {10, 0, 0.05 * k}, EdgeClass::sharp, false);
  for (int k = 0; k < n; ++k) h.add({0, 0, 0.05 * k + 0.005}, {10, 0, 0.05 * k + 0.005}, EdgeClass::sharp, true);
  const Drawing d = distinct(h);
  CHECK(d.near_coincident == n);
  CHECK(d.polylines.size() == n);
}
