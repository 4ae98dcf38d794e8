#include "geometry/enclosure.h"

#include <array>
#include <catch2/catch.hpp>
#include <random>
#include <span>

#include "hsr/drawing/cut_parameter.h"
#include "hsr/drawing/projection.h"
#include "hsr/lines/visible_lines.h"

using namespace hsr;
using namespace hsr::internal;

namespace {

bool contains(const Enclosure& e, const Rational& x) {
  const auto exact = [](long double y) {
    const auto first = static_cast<double>(y);
    return Rational(first) + Rational(static_cast<double>(y - first));
  };
  // Twice over: the exact rational of a long double is the sum of two doubles where it is in their range.
  return exact(e.low()) <= x && x <= exact(e.high());
}

double random_double(std::mt19937_64& random) {
  const double mantissa = std::ldexp(static_cast<double>(random() >> 11), -53) + 0.5;
  const int exponent =
      static_cast<int>(random() % 5) == 0 ? static_cast<int>(random() % 200) - 100 : static_cast<int>(random() % 6);
  const double x = std::ldexp(random() % 4 == 0 ? std::round(mantissa * 8) : mantissa, exponent);
  return random() % 2 == 0 ? x : -x;
}

}  // namespace

TEST_CASE("Enclosures contain the exact sum, difference, product and quotient", "[drawing][enclosure][property]") {
  std::mt19937_64 random(7);
  for (int k = 0; k < 20000; ++k) {
    const double a = random_double(random), b = random_double(random), c = random_double(random), d = random_double(random);
    CAPTURE(a, b, c, d);
    const Enclosure x = Enclosure(a) * Enclosure(b) - Enclosure(c) * Enclosure(d);
    const Rational exact = Rational(a) * Rational(b) - Rational(c) * Rational(d);
    REQUIRE(contains(x, exact));
    REQUIRE(contains(Enclosure::difference(a, b), Rational(a) - Rational(b)));
    const Enclosure e = Enclosure(c) + Enclosure(d);
    const Rational divisor = Rational(c) + Rational(d);
    const Enclosure quotient = x / e;
    if (quotient.is_finite()) REQUIRE(contains(quotient, exact / divisor));
    REQUIRE(contains(enclose(exact), exact));
    if (const auto r = rounded(x)) REQUIRE(*r == exact.to_double());
    if (const auto r = rounded(quotient)) REQUIRE(*r == (exact / divisor).to_double());
  }
}

TEST_CASE("Enclosures that know nothing say nothing", "[drawing][enclosure]") {
  const Enclosure unknown = Enclosure(1.0) / (Enclosure::difference(1, 1) * Enclosure(3.0));
  CHECK_FALSE(unknown.is_finite());
  CHECK_FALSE(certainly_less(unknown, 1.0));
  CHECK_FALSE(certainly_less(1.0, unknown));
  CHECK_FALSE(unknown.is_positive());
  CHECK_FALSE(rounded(unknown));
  CHECK_FALSE(rounded(unknown * Enclosure(0.5)));
}

TEST_CASE("Parameters and places are the exact ones rounded, on random scenes", "[drawing][enclosure][property][E3][J1]") {
  for (int seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    std::vector<Point3> corners;
    Polygons faces;
    const bool whole = seed % 2 == 0;
    const auto coordinate = [&] {
      return whole ? static_cast<double>(random() % 9) - 4 : static_cast<double>(random() % 8000001) * 1e-6 - 4;
    };
    for (std::uint32_t k = 0; k < 36; ++k) {
      corners.push_back({coordinate(), coordinate(), coordinate()});
      faces.corners.push_back(k);
      if (k % 3 == 2) faces.first.push_back(k + 1);
    }
    const Mesh mesh = make_mesh(corners, faces);
    const View view = seed % 4 < 2 ? parallel_view({1, 2, 3}, {0, 0, 1}) : perspective_view({1, 2, 3}, {0, 0, 0}, {0, 0, 1});
    LineOptions all;
    all.method = LineMethod::roberts;
    all.classes.fill(true);
    const VisibleLines lines = visible_lines(mesh, view, all);
    const Point3 anchor = view.frame.origin;
    Projection projection(mesh, view, anchor);
    projection.place({Rational(0.125), Rational(0.5)}, Rational(7.25), 105, 148.5);
    for (const Line& line : lines.lines) {
      const SupportingLine support = supporting_line_of(mesh, lines, line);
      for (const Cut& cut : lines.cuts_of(line)) {
        const Rational t = exact_parameter(mesh, view, support, cut);
        REQUIRE(rounded_parameter(mesh, view, support, cut) == t.to_double());
        const auto seen = image(view, exact_point(mesh, view, support, cut));
        const Rational x = Rational(105.0) + Rational(7.25) * (seen[0] - Rational(0.125));
        const Rational y = Rational(148.5) - Rational(7.25) * (seen[1] - Rational(0.5));
        REQUIRE(projection.exact(support, cut) == std::array<Rational, 2>{x, y});
        const HomogeneousPoint h = projection.at(support, cut);
        const PaperPoint rounded_place = projection.rounded(support, cut, h);
        REQUIRE(std::to_string(rounded_place.x) == (x * Rational(1000.0)).to_decimal(0));
        REQUIRE(std::to_string(rounded_place.y) == (y * Rational(1000.0)).to_decimal(0));
      }
    }
  }
}

TEST_CASE("The nearest integer is said only where no other can be nearest", "[drawing][enclosure]") {
  CHECK(Enclosure(2.25).nearest_integer() == 2);
  CHECK(Enclosure(-2.75).nearest_integer() == -3);
  CHECK_FALSE(Enclosure(2.5).nearest_integer());
  CHECK(Enclosure(2.25L, 0.249L).nearest_integer() == 2);
  CHECK_FALSE(Enclosure(2.25L, 0.25L).nearest_integer());
  CHECK_FALSE(Enclosure(0x1p62).nearest_integer());
  CHECK_FALSE((Enclosure(1.0) / Enclosure(0.0)).nearest_integer());
}

TEST_CASE("Images of vertices are enclosed, and not by much more than their last places", "[drawing][enclosure][property]") {
  std::mt19937_64 random(11);
  const std::array<std::array<std::uint32_t, 3>, 1> triangle = {{{0, 1, 2}}};
  for (int k = 0; k < 400; ++k) {
    CAPTURE(k);
    std::vector<Point3> corners(3);
    for (Point3& p : corners) p = {random_double(random), random_double(random), random_double(random)};
    const Mesh mesh = make_mesh(std::span<const Point3>(corners), triangle);
    if (mesh.triangles.empty()) continue;
    const View view = parallel_view({random_double(random), random_double(random), random_double(random)}, {0, 0, 1});
    Projection projection(mesh, view, corners[0]);
    projection.place({Rational(random_double(random)), Rational(1.0) / Rational(3.0)}, Rational(7.0) / Rational(3.0), 10.5,
                     -1.25);
    for (std::uint32_t v = 1; v < 3; ++v) {
      const HomogeneousPoint at = projection.at(VertexId(v));
      const auto exact = projection.exact(VertexId(v));
      CHECK(contains(at.x, exact[0]));
      CHECK(contains(at.y, exact[1]));
      // The terms that are added up, of which the last places of a sum are at most.
      const Point3 &p = corners[v], &o = projection.anchor();
      const std::array<double, 4> place = {p.x - o.x, p.y - o.y, p.z - o.z, 1};
      for (std::size_t i = 0; i < 2; ++i) {
        long double size = 0;
        for (std::size_t c = 0; c < 4; ++c)
          size += std::fabs(static_cast<long double>(projection.rounded_rows()[i][c]) * place[c]);
        CHECK((i == 0 ? at.x : at.y).error < 32 * Enclosure::eps * size);
      }
    }
  }
}
