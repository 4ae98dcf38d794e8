#include "hsr/view/frustum.h"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "geometry/number.h"

// What is said to be outside a picture has no point in it, asked in rationals; and most of what is outside is said to be.

using namespace hsr;
using namespace hsr::internal;

namespace {

using Point = std::array<Rational, 3>;

Rational square(const Rational& x) { return x * x; }

/// Whether a point is beyond the near plane, and its exact image in the picture.
bool is_in_picture(const View& view, const FrameSize& size, const Point& p) {
  const Point3 &e = view.viewpoint.at, &t = view.target;
  const Rational dx = Rational(t.x) - Rational(e.x), dy = Rational(t.y) - Rational(e.y), dz = Rational(t.z) - Rational(e.z);
  const Rational depth = (p[0] - Rational(e.x)) * dx + (p[1] - Rational(e.y)) * dy + (p[2] - Rational(e.z)) * dz;
  if ((depth - Rational(view.near) * (square(dx) + square(dy) + square(dz))).sign() == Sign::negative) return false;
  const auto at = image(view, p);
  const auto is_within = [](const Rational& x, double half) {
    return (square(x) - square(Rational(half))).sign() != Sign::positive;
  };
  return is_within(at[0], size.half_width) && is_within(at[1], size.half_height);
}

}  // namespace

TEST_CASE("what is outside the frame has no point in the picture", "[frame]") {
  std::mt19937_64 random(5);
  const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  std::size_t outside = 0, in_picture = 0, missed = 0;
  for (int round = 0; round < 400; ++round) {
    const double scale = round % 7 == 0 ? 1e100 : round % 7 == 1 ? 1e-120 : std::pow(10.0, round % 5 - 2);
    const auto point = [&] { return Point3{between(-5, 5) * scale, between(-5, 5) * scale, between(-5, 5) * scale}; };
    const Point3 eye = point(), target = round % 4 == 0 ? Point3{} : point();
    const View view = perspective_view(eye, target, {between(-1, 1), between(-1, 1), between(1, 2)});
    const double d = std::hypot(target.x - eye.x, target.y - eye.y, target.z - eye.z);
    const double half = d * std::pow(10.0, round % 3 == 0 ? between(-12, 12) : between(-2, 1));
    const FrameSize size{half, half * between(0.5, 2)};
    std::vector<Point3> points;
    Polygons polygons;
    for (int k = 0; k < 20; ++k) {
      const double x = between(-1.2, 1.2) * size.half_width, y = between(-1.2, 1.2) * size.half_height;
      for (int end = 0; end < 2; ++end) {
        const double m = (k % 9 == 0 ? -1 : 1) * (end == 0 ? 1 : std::pow(10.0, between(-2, 2)));
        const double u = x + end * between(-0.2, 0.2) * size.half_width, v = y + end * between(-0.2, 0.2) * size.half_height;
        const Frame& f = view.frame;
        const auto along = [&](double e, double o, double r, double up) { return e + m * (o - e + u * r + v * up); };
        points.push_back({along(eye.x, f.origin.x, f.right.x, f.up.x), along(eye.y, f.origin.y, f.right.y, f.up.y),
                          along(eye.z, f.origin.z, f.right.z, f.up.z)});
      }
      polygons.segments.push_back({static_cast<std::uint32_t>(2 * k), static_cast<std::uint32_t>(2 * k + 1)});
    }
    const Mesh mesh = make_mesh(points, polygons);
    const ViewFrustum frame(mesh, view, size);
    for (const Edge& e : mesh.edges) {
      bool any = false;
      for (int k = 0; k <= 4; ++k) {
        const Rational t(k / 4.0), s(1 - k / 4.0);
        const Point3 &a = mesh.points[e.a], &b = mesh.points[e.b];
        any = any || is_in_picture(view, size,
                                   {s * Rational(a.x) + t * Rational(b.x), s * Rational(a.y) + t * Rational(b.y),
                                    s * Rational(a.z) + t * Rational(b.z)});
      }
      const bool contains = frame.contains(e);
      if (contains) CHECK_FALSE(any);
      ++(contains ? outside : any ? in_picture : missed);
    }
  }
  CHECK(outside > 1000);
  CHECK(in_picture > 2000);
  CHECK(missed < 2000);
}
