#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <sstream>
#include <vector>

#include "hsr/drawing/drawing.h"
#include "hsr/scene/input_noise.h"
#include "tests/scenes/test_scene.h"

// Noise of the input: with a tolerance a drawing is that of the model without the noise.

namespace hsr {

namespace {

using internal::InputNoise;
using internal::noise_of;
using scenes::TestScene;

/// A slab, two walls on it that meet, a column that touches the underside, a beam through a wall, and a step beside the slab.
TestScene building() {
  TestScene scene;
  scene.add_box({0, 0, 0}, {10, 6, 0.3});
  scene.add_box({0, 0, 0.3}, {10, 0.4, 3});
  scene.add_box({0, 0.4, 0.3}, {0.4, 6, 2.5});
  scene.add_box({2, 2, -3}, {2.5, 2.5, 0});
  scene.add_box({4, -1, 2}, {4.3, 3, 2.3});
  scene.add_box({10, 1, 0}, {11, 4, 0.3});
  scene.view = parallel_view({1, -1, 1}, {0, 0, 1});
  return scene;
}

Point3 turned(const Point3& p, double degrees) {
  const double angle = degrees * 3.14159265358979323846 / 180, c = std::cos(angle), s = std::sin(angle);
  return {c * p.x - s * p.y, s * p.x + c * p.y, p.z};
}

struct Segment {
  bool hidden;
  EdgeClass edge_class;
  std::array<PaperPoint, 2> ends;
};

/// What is drawn with hidden lines.
std::vector<Segment> drawn(const TestScene& scene, double tolerance) {
  const Mesh mesh = make_mesh(scene.points, scene.polygons, tolerance);
  LineOptions options;
  options.tolerance = tolerance;
  DrawingOptions page;
  page.hidden = HiddenLines::dashed;
  page.leave_out_near = true;
  const Drawing drawing = draw(mesh, scene.view, visible_lines(mesh, scene.view, options), page);
  std::vector<Segment> all;
  for (const Polyline& line : drawing.polylines) {
    const auto points = drawing.points_of(line);
    for (std::size_t k = 0; k + (line.closed ? 0 : 1) < points.size(); ++k) {
      std::array<PaperPoint, 2> ends = {points[k], points[(k + 1) % points.size()]};
      if (std::pair(ends[1].x, ends[1].y) < std::pair(ends[0].x, ends[0].y)) std::swap(ends[0], ends[1]);
      all.push_back({line.hidden, line.edge_class, ends});
    }
  }
  return all;
}

double distance(const PaperPoint& p, const std::array<PaperPoint, 2>& ends) {
  const auto x = [](std::int64_t v) { return static_cast<double>(v); };
  const double dx = x(ends[1].x - ends[0].x), dy = x(ends[1].y - ends[0].y);
  const double square = dx * dx + dy * dy;
  const double t = square > 0 ? std::clamp((x(p.x - ends[0].x) * dx + x(p.y - ends[0].y) * dy) / square, 0.0, 1.0) : 0;
  return std::hypot(x(p.x - ends[0].x) - t * dx, x(p.y - ends[0].y) - t * dy);
}

/// The segments of one that are not inked in the same style in the other, within 0.01 mm, and the other way round, wherever either is
/// cut. Empty: they are alike. Under a visible line, which is wider, a hidden one is no ink.
std::string difference(const std::vector<Segment>& x, const std::vector<Segment>& y) {
  std::ostringstream text;
  const auto look_for = [&](const char* sign, const std::vector<Segment>& some, const std::vector<Segment>& others) {
    for (const Segment& s : some) {
      constexpr int steps = 64;
      bool is_inked = true;
      for (int k = 0; k <= steps; ++k) {
        const PaperPoint p = {s.ends[0].x + (s.ends[1].x - s.ends[0].x) * k / steps,
                              s.ends[0].y + (s.ends[1].y - s.ends[0].y) * k / steps};
        is_inked = is_inked && std::any_of(others.begin(), others.end(), [&](const Segment& t) {
                     const bool is_same = s.hidden == t.hidden && s.edge_class == t.edge_class;
                     return (is_same || (s.hidden && !t.hidden)) && distance(p, t.ends) < 11;  // and a rounding
                   });
      }
      if (is_inked) continue;
      text << sign << (s.hidden ? " hidden " : " visible ") << edge_class_names[static_cast<std::size_t>(s.edge_class)];
      for (const PaperPoint& p : s.ends) text << " " << p.x << "," << p.y;
      text << "\n";
    }
  };
  look_for("-", x, y);
  look_for("+", y, x);
  return text.str();
}

TEST_CASE("a building turned by any angle is one drawing, with a tolerance", "[drawing][tolerance][T1][T2]") {
  const TestScene straight = building();
  const auto expected = drawn(straight, 0);
  REQUIRE(expected.size() > 40);
  CHECK(difference(expected, drawn(straight, 1e-9)) == "");
  int noisy = 0;
  for (const double degrees : {37.0, 11.0, 73.0, 122.5, 300.1}) {
    TestScene scene = straight;
    for (Point3& p : scene.points) p = turned(p, degrees);
    scene.view = parallel_view(turned({1, -1, 1}, degrees), {0, 0, 1});
    const InputNoise noise = noise_of(scene.mesh());
    INFO(degrees << " degrees, tolerance " << noise.tolerance);
    CHECK(noise.near_planes > 0);
    for (const double tolerance : {noise.tolerance, 1e-9}) CHECK(difference(expected, drawn(scene, tolerance)) == "");
    noisy += difference(expected, drawn(scene, 0)).empty() ? 0 : 1;
  }
  CHECK(noisy > 0);  // it is the tolerance that mends them
}

/// The same about an axis that is none of the scene's.
Point3 turned_askew(const Point3& p, double degrees) {
  const double angle = degrees * 3.14159265358979323846 / 180, c = std::cos(angle), s = std::sin(angle);
  const double n = std::sqrt(14.0), x = 1 / n, y = 2 / n, z = 3 / n, along = (x * p.x + y * p.y + z * p.z) * (1 - c);
  return {along * x + c * p.x + s * (y * p.z - z * p.y), along * y + c * p.y + s * (z * p.x - x * p.z),
          along * z + c * p.z + s * (x * p.y - y * p.x)};
}

// Turned, the sides of what fills a hole in a wall pierce the wall's, here and there, by an ulp. Elsewhere its rim is an ulp behind the
// wall's side, and hidden.
TEST_CASE("what fills a wall from side to side makes no line, turned by any angle, with a tolerance",
          "[drawing][tolerance][T1][T5]") {
  TestScene straight;
  straight.add_box({0, 0, 0}, {10, 0.3, 3});
  straight.add_box({1, 0, 1}, {2, 0.3, 2.1});
  straight.add_box({4, 0, 0}, {4.4, 0.3, 3});
  straight.add_box({6, -0.25, 1}, {7, 0, 1.1});
  straight.add_box({7, 0, 1}, {8, 0.5, 2});  // ends where the one beside it passes through the wall
  std::mt19937_64 random(1930);
  int noisy = 0;
  for (const Point3& direction : {Point3{1, -1, 1}, Point3{2.3, -3.1, -1.17}}) {
    straight.view = parallel_view(direction, {0, 0, 1});
    const auto expected = drawn(straight, 0);
    for (int k = 0; k < 10; ++k)
      for (const auto& turn : {turned, turned_askew}) {
        const double degrees = std::uniform_real_distribution<>(0, 360)(random);
        TestScene scene = straight;
        for (Point3& p : scene.points) p = turn(p, degrees);
        scene.view = parallel_view(turn(direction, degrees), turn({0, 0, 1}, degrees));
        INFO(degrees << " degrees" << (turn == turned ? "" : ", askew"));
        for (const double tolerance : {1e-13, 1e-9}) CHECK(difference(expected, drawn(scene, tolerance)) == "");
        noisy += difference(expected, drawn(scene, 0)).empty() ? 0 : 1;
      }
  }
  CHECK(noisy > 10);
}

TEST_CASE("what touches a single sheet from behind is dashed, turned by any angle, with a tolerance",
          "[drawing][tolerance][T1][T5]") {
  TestScene straight;
  straight.points = {{0, 0, 0}, {10, 0, 0}, {10, 8, 0}, {0, 8, 0}};
  straight.add_face({0, 1, 2, 3});
  straight.add_box({3, 3, -1}, {6, 5, 0});
  straight.add_box({6, 2, -2}, {7, 5, 0});
  straight.add_box({1, 6, 0}, {2, 7, 0.5});
  std::mt19937_64 random(1960);
  for (const Point3& direction : {Point3{1.1, -1.37, 1}, Point3{-3.2, 1.1, 2.3}, Point3{1, 2.2, -1.3}}) {
    straight.view = parallel_view(direction, {0, 0, 1});
    const auto expected = drawn(straight, 0);
    for (int k = 0; k < 10; ++k)
      for (const auto& turn : {turned, turned_askew}) {
        const double degrees = std::uniform_real_distribution<>(0, 360)(random);
        TestScene scene = straight;
        for (Point3& p : scene.points) p = turn(p, degrees);
        scene.view = parallel_view(turn(direction, degrees), turn({0, 0, 1}, degrees));
        INFO(degrees << " degrees" << (turn == turned ? "" : ", askew"));
        CHECK(difference(expected, drawn(scene, 1e-9)) == "");
      }
  }
}

/// A wall and boxes of which most end flush with its sides, or boxes of whole numbers that overlap.
TestScene flush_boxes(std::mt19937_64& random, bool has_wall) {
  const auto below = [&](int n) { return static_cast<double>(random() % static_cast<std::uint64_t>(n)); };
  const auto one_of = [&](std::initializer_list<double> all) { return all.begin()[random() % all.size()]; };
  TestScene scene;
  if (has_wall) scene.add_box({0, 0, 0}, {10, 0.3, 3});
  for (int k = 0; k < 3; ++k) {
    const double x = below(has_wall ? 9 : 4), z = below(3);
    const double y0 = has_wall ? one_of({0, 0, -0.2, 0.1}) : below(4),
                 y1 = has_wall ? one_of({0.3, 0.3, 0.5, 0.2}) : y0 + 1 + below(3);
    scene.add_box({x, y0, z}, {x + 1 + below(2), y1, z + one_of({0.5, 1, 1, 2})});
  }
  return scene;
}

TEST_CASE("boxes that end flush with others make the same lines turned by any angle, with a tolerance",
          "[drawing][tolerance][T1][T5][T6]") {
  std::mt19937_64 random(1943);
  const Point3 directions[] = {{1.1, -1.37, 1}, {2.3, -3.1, 1.17}, {-3.2, 1.1, 2.3}, {1, 2.2, -1.3}};
  for (int k = 0; k < 200; ++k) {
    TestScene straight = flush_boxes(random, k % 2 == 0);
    const Point3& direction = directions[random() % 4];
    straight.view = parallel_view(direction, {0, 0, 1});
    const auto expected = drawn(straight, 0);
    for (const auto& turn : {turned, turned_askew}) {
      const double degrees = std::uniform_real_distribution<>(0, 360)(random);
      TestScene scene = straight;
      for (Point3& p : scene.points) p = turn(p, degrees);
      scene.view = parallel_view(turn(direction, degrees), turn({0, 0, 1}, degrees));
      INFO("scene " << k << ", " << degrees << " degrees" << (turn == turned ? "" : ", askew") << "\n"
                    << scenes::to_text(scene));
      CHECK(difference(expected, drawn(scene, 1e-9)) == "");
    }
  }
}

TEST_CASE("an edge that begins beside where a wall is pierced makes the same lines turned, with a tolerance",
          "[drawing][tolerance][T1][T6]") {
  struct Turned {
    std::array<Point3, 6> boxes;
    Point3 direction;
    double degrees;
  };
  const Turned all[] = {
      // The rim of the first box is pierced by the second, and doubles do not tell where.
      {{{{3, 0, 1}, {5, 0.3, 2}, {4, -0.2, 1}, {6, 0.5, 2}, {0, -0.2, 2}, {2, 0.3, 3}}}, {1, 2.2, -1.3}, 69.75173986167033},
      {{{{7, 0.1, 0}, {9, 0.5, 1}, {8, 0.1, 0}, {9, 0.3, 1}, {4, 0, 0}, {5, 0.5, 1}}}, {-3.2, 1.1, 2.3}, 31.14733164189704},
      {{{{1, -0.2, 0}, {2, 0.2, 1}, {0, 0, 0}, {2, 0.3, 0.5}, {0, 0, 1}, {2, 0.3, 2}}}, {1.1, -1.37, 1}, 138.83674734892605},
      // The underside of a wall, of two long triangles of which an edge crosses the common side at a small angle.
      {{{{6, 0.1, 2}, {7, 0.2, 3}, {6, 0.1, 0}, {8, 0.2, 0.5}, {8, 0, 1}, {10, 0.3, 2}}}, {1, 2.2, -1.3}, 46.22756237728227}};
  for (const Turned& t : all) {
    TestScene straight;
    straight.add_box({0, 0, 0}, {10, 0.3, 3});
    for (std::size_t k = 0; k < 6; k += 2) straight.add_box(t.boxes[k], t.boxes[k + 1]);
    straight.view = parallel_view(t.direction, {0, 0, 1});
    const auto expected = drawn(straight, 0);
    for (const auto& turn : {turned, turned_askew}) {
      TestScene scene = straight;
      for (Point3& p : scene.points) p = turn(p, t.degrees);
      scene.view = parallel_view(turn(t.direction, t.degrees), turn({0, 0, 1}, t.degrees));
      INFO(t.degrees << " degrees" << (turn == turned ? "" : ", askew"));
      CHECK(difference(expected, drawn(scene, 1e-9)) == "");
    }
  }
}

TEST_CASE("a building on a national grid is one drawing, with a tolerance", "[drawing][tolerance][T1]") {
  const TestScene straight = building();
  const auto expected = drawn(straight, 0);
  TestScene moved = straight;
  for (Point3& p : moved.points) p = {p.x + 453'219.173, p.y + 5'412'007.961, p.z + 112.37};
  CHECK(difference(expected, drawn(moved, noise_of(moved.mesh()).tolerance)) == "");
  CHECK(difference(expected, drawn(moved, 1e-7)) == "");
}

TEST_CASE("a building turned and saved with six decimals is one drawing, with a tolerance", "[drawing][tolerance][T1]") {
  const TestScene straight = building();
  const auto expected = drawn(straight, 0);
  TestScene scene = straight;
  for (Point3& p : scene.points) {
    p = turned(p, 37);
    p = {std::round(p.x * 1e6) / 1e6, std::round(p.y * 1e6) / 1e6, std::round(p.z * 1e6) / 1e6};
  }
  scene.view = parallel_view(turned({1, -1, 1}, 37), {0, 0, 1});
  CHECK(noise_of(scene.mesh()).tolerance >= 1e-6);
  CHECK(difference(expected, drawn(scene, noise_of(scene.mesh()).tolerance)) == "");
}

/// As printf writes it and a reader reads it.
double printed(double x, const char* format) {
  std::array<char, 40> text;
  std::snprintf(text.data(), text.size(), format, x);
  return std::strtod(text.data(), nullptr);
}

TEST_CASE("a building turned and saved with six or seven digits is one drawing, with a tolerance", "[drawing][tolerance][T1]") {
  const auto expected = drawn(building(), 0);
  for (const char* format : {"%g", "%e"}) {
    TestScene scene = building();
    for (Point3& p : scene.points) {
      p = turned(p, 37);
      p = {printed(p.x, format), printed(p.y, format), printed(p.z, format)};
    }
    scene.view = parallel_view(turned({1, -1, 1}, 37), {0, 0, 1});
    const double tolerance = noise_of(scene.mesh()).tolerance;
    INFO(format << ": " << tolerance);
    CHECK(tolerance >= (format[1] == 'g' ? 1e-4 : 1e-5));
    CHECK(tolerance <= (format[1] == 'g' ? 2e-3 : 2e-4));
    CHECK(difference(expected, drawn(scene, tolerance)) == "");
    CHECK(difference(expected, drawn(scene, 0)) != "");
  }
}

TEST_CASE("a clean model of short numbers has no noise, however small its steps", "[drawing][tolerance]") {
  for (const double unit : {1.0, 0.5, 0.1, 0.01}) {
    TestScene steps;  // a floor of slabs, each a little higher
    for (int k = 0; k < 6; ++k) {
      const auto at = [&](double x) { return printed(x * unit, "%.2f"); };
      steps.add_box({at(20'000 * k), at(0), at(0)}, {at(20'000 * (k + 1)), at(30'007), at(12'345 + k)});
    }
    const InputNoise noise = noise_of(steps.mesh());
    INFO("unit " << unit << ": " << noise.near_planes << " " << noise.tolerance);
    CHECK(noise.tolerance == 0);
  }
}

TEST_CASE("faces beside a gap as narrow as the noise are nearly in one plane", "[drawing][tolerance]") {
  // In floats, so that the boxes of these faces do not touch: a gap, and a step as high, of a quarter of the noise.
  const double gap = 0x1p-20;
  TestScene boxes;
  boxes.add_box({0, 0, 0}, {1, 1, 1});
  boxes.add_box({1 + gap, 0, 0.25}, {2, 1, 1 + gap});
  const InputNoise noise = noise_of(boxes.mesh());
  CHECK(noise.near_planes == 4);  // the tops, and the two sides at the gap
  CHECK(noise.tolerance >= gap);
}

TEST_CASE("a round model has no near planes, however far from the origin", "[drawing][tolerance]") {
  for (const double far : {20.0, 200.0, 1000.0}) {
    TestScene ball;
    const int n = 40;
    const auto at = [&](int i, int j) {
      if (i == 0 || i == n) return Point3{far, 0, i == 0 ? 1.0 : -1.0};
      const double u = 3.14159265358979323846 * i / n, v = 2 * 3.14159265358979323846 * j / n;
      const auto as_float = [](double x) { return static_cast<double>(static_cast<float>(x)); };
      return Point3{as_float(far + std::sin(u) * std::cos(v)), as_float(std::sin(u) * std::sin(v)), as_float(std::cos(u))};
    };
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        ball.add_face({at(i, j), at(i + 1, j), at(i + 1, (j + 1) % n)});
        ball.add_face({at(i, j), at(i + 1, (j + 1) % n), at(i, (j + 1) % n)});
      }
    const InputNoise noise = noise_of(ball.mesh());
    INFO(noise.open_edges << " " << noise.near_planes << " " << noise.tolerance * 1e9);
    CHECK(noise.near_planes == 0);
  }
}

/// Every face has points of its own, each moved by some units in the last place of a float.
TestScene noisy(const TestScene& scene) {
  TestScene soup;
  soup.view = scene.view;
  std::uint32_t random = 12345;
  for (std::size_t f = 0; f < scene.polygons.size(); ++f) {
    std::vector<Point3> corners;
    for (const std::uint32_t k : scene.polygons[f]) {
      const auto moved = [&](double x) {
        random = random * 1'664'525U + 1'013'904'223U;
        const auto steps = static_cast<double>(random >> 16U) / 65'536 - 0.5;
        return static_cast<double>(static_cast<float>(x + steps * 1e-6));
      };
      const Point3& p = scene.points[k];
      corners.push_back({moved(p.x), moved(p.y), moved(p.z)});
    }
    // Triangles, as a file of them has it.
    soup.add_face({corners[0], corners[1], corners[2]});
    soup.add_face({corners[0], corners[2], corners[3]});
  }
  return soup;
}

TEST_CASE("a file of noisy triangles is drawn as the clean one, with a tolerance", "[drawing][tolerance][T1][T3]") {
  TestScene clean = building();
  for (Point3& p : clean.points) p = {std::round(p.x * 8) / 8, std::round(p.y * 8) / 8, std::round(p.z * 8) / 8};
  const TestScene noisy_scene = noisy(clean);
  const InputNoise noise = noise_of(noisy_scene.mesh());
  CHECK(noise.open_edges > 100);
  CHECK(noise_of(clean.mesh()).tolerance == 0);
  CHECK(difference(drawn(clean, 0), drawn(noisy_scene, noise.tolerance)) == "");
  CHECK(difference(drawn(clean, 0), drawn(noisy_scene, 0)) != "");
}

}  // namespace
}  // namespace hsr
