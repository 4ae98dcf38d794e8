// Each filter says how far its value may be from the exact one. Here a search climbs toward the largest share of the bound that
// the true error, in rationals, takes up: never more than all of it, and not much less than some of it.
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <random>
#include <span>
#include <vector>

#include "geometry/plane_filter.h"
#include "geometry/plane_intersection.h"
#include "geometry/polynomials.h"
#include "geometry/rational_arithmetic.h"
#include "hsr/painter/sort/image_triangle.h"
#include "hsr/scene/affine_depth.h"
#include "hsr/scene/line_filter.h"
#include "hsr/scene/projected_mesh.h"
#include "hsr/scene/segment_filter.h"
#include "hsr/scene/triangle_filter.h"
#include "tests/scenes/test_scene.h"

using namespace hsr;
using namespace hsr::internal;

namespace {

/// How the numbers of a search become coordinates: offset + spread x, times 2^power; and whether all points but the first two
/// lie near the line through these.
struct Layout {
  double offset = 0, spread = 1;
  int power = 0;
  bool is_sliver = false;

  double coordinate(double x) const { return std::ldexp(offset + spread * x, power); }
};

/// Each shape at each of the powers of two.
std::vector<Layout> layouts(std::initializer_list<int> powers) {
  std::vector<Layout> all;
  for (const int power : powers)
    for (const Layout& shape : {Layout{}, Layout{1, 0x1p-20}, Layout{1, 0x1p-45}, Layout{0, 1, 0, true}})
      all.push_back({shape.offset, shape.spread, power, shape.is_sliver});
  return all;
}

/// The numbers of a search, each from -1 to 1, handed out one after the other.
class Numbers {
 public:
  Numbers(std::span<const double> x, const Layout& layout) : x_(x), layout_(layout) {}

  double next() { return x_[used_++]; }
  std::size_t used() const { return used_; }
  ImagePoint point2() {
    const Point3 p = placed({next(), next(), 0});
    return {layout_.coordinate(p.x), layout_.coordinate(p.y)};
  }
  Point3 point3() {
    const Point3 p = placed({next(), next(), next()});
    return {layout_.coordinate(p.x), layout_.coordinate(p.y), layout_.coordinate(p.z)};
  }

 private:
  Point3 placed(const Point3& p) {
    ++points_;
    if (points_ <= 2) first_[points_ - 1] = p;
    if (points_ <= 2 || !layout_.is_sliver) return p;
    const auto at = [&](double a, double b, double away) { return a + (p.x + 1) / 2 * (b - a) + 0x1p-30 * away; };
    return {at(first_[0].x, first_[1].x, p.x), at(first_[0].y, first_[1].y, p.y), at(first_[0].z, first_[1].z, p.z)};
  }

  std::span<const double> x_;
  const Layout& layout_;
  std::size_t used_ = 0, points_ = 0;
  std::array<Point3, 2> first_;
};

Rational magnitude(const Rational& x) { return x.sign() == Sign::negative ? -x : x; }

/// The share of its bound that an error takes up. An unbounded error claims nothing.
double share(double value, double error, const Rational& exact) {
  if (!(error < HUGE_VAL)) return 0;
  if (!std::isfinite(value)) return HUGE_VAL;
  const Rational off = magnitude(Rational(value) - exact);
  if (off.sign() == Sign::zero) return 0;
  return error > 0 ? (off / Rational(error)).to_double() : HUGE_VAL;
}
double share(const ErrorBounded& x, const Rational& exact) { return share(x.value, x.error, exact); }

/// A share of the bound for the numbers of a search.
using Search = std::function<double(Numbers&)>;

/// Climbs from several starts in each layout: changes one number, here by much, there by its last bits, and keeps what is worse.
/// @param count of the numbers @param least the share that the worst error has to reach somewhere
void check_bound(std::size_t count, std::span<const Layout> layouts, double least, int steps, const Search& search) {
  double worst = 0;
  for (const Layout& layout : layouts)
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      std::mt19937_64 random(seed);
      const auto unit = [&] { return std::ldexp(static_cast<double>(static_cast<std::int64_t>(random())), -63); };
      std::vector<double> x(count), y;
      for (double& each : x) each = unit();
      double best = 0;
      for (int step = 0; step < steps; ++step) {
        y = x;
        double& each = y[random() % count];
        const std::uint64_t kind = random() % 8;
        each = kind == 0   ? -each
               : kind == 1 ? std::copysign(1.0, each)
                           : each + std::ldexp(unit(), -static_cast<int>(random() % 53));
        each = std::fmin(std::fmax(each, -1), 1);
        Numbers numbers(y, layout);
        const double found = search(numbers);
        REQUIRE(numbers.used() <= count);
        if (found >= best) {
          best = found;
          x = y;
        }
      }
      CAPTURE(layout.offset, layout.spread, layout.power, layout.is_sliver, seed);
      CHECK(best <= 1);
      worst = std::fmax(worst, best);
    }
  INFO("the largest share of the bound");
  CHECK(worst >= least);
}

/// A number that is only known within `error` of p may be this.
Rational moved(double p, double error, double by) { return Rational(p) + Rational(error) * Rational(by); }

struct Exact2 {
  Rational x, y;
};
Exact2 moved(const ImagePoint& p, double error, Numbers& by) {
  return {moved(p.x, error, by.next()), moved(p.y, error, by.next())};
}
Exact2 minus(const Exact2& a, const Exact2& b) { return {a.x - b.x, a.y - b.y}; }
Rational det(const Exact2& a, const Exact2& b) { return a.x * b.y - a.y * b.x; }
Rational dot(const Exact2& a, const Exact2& b) { return a.x * b.x + a.y * b.y; }

using Exact3 = polynomials::Vector<Rational>;
Exact3 moved(const Point3& p, double error, Numbers& by) {
  return {moved(p.x, error, by.next()), moved(p.y, error, by.next()), moved(p.z, error, by.next())};
}
Exact3 exact(const Point3& p) { return {p.x, p.y, p.z}; }
Exact3 minus(const Exact3& a, const Exact3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

/// Errors of points from none to as large as the coordinates.
constexpr std::array<double, 4> errors = {0, 0x1p-50, 0x1p-20, 1};

}  // namespace

TEST_CASE("the bound of a point on a segment is above its error, and not far above", "[scene][filters]") {
  const auto all = layouts({0, 90, -90, 500, -500});
  for (const double error : {0.0, 0x1p-40, 0.5})
    check_bound(8, all, error == 0 ? 0.15 : 0.5, 400, [&](Numbers& x) {
      const Point3 a = x.point3(), b = x.point3();
      const ErrorBounded t{x.next(), error};
      const Rational exact_t = moved(t.value, error, x.next());
      const BoundedPoint3 p = between(a, b, t);
      double most = 0;
      for (int k = 0; k < 3; ++k)
        most = std::fmax(most, share(p.p[k], p.error, Rational(a[k]) + exact_t * (Rational(b[k]) - Rational(a[k]))));
      return most;
    });
}

TEST_CASE("the bounds of a segment's turn and of what lies along it are above the errors, and not far above",
          "[scene][filters]") {
  const auto all = layouts({0, 1, 100, -100, 450, -450, 1000});
  for (const double relative : errors)
    for (const bool is_turn : {true, false})
      check_bound(12, all, relative > 0 ? 0.3 : 0.1, 300, [&](Numbers& x) {
        const ImagePoint p = x.point2(), q = x.point2(), r = x.point2();
        const double error = relative * std::fmax(std::fabs(q.x - p.x), std::fabs(q.y - p.y));
        const SegmentFilter segment(p, q, error);
        const Exact2 a = moved(p, error, x), b = moved(q, error, x), c = moved(r, error, x);
        return is_turn ? share(segment.turn(r), det(minus(b, a), minus(c, a)))
                       : std::fmax(share(segment.along(r, p), dot(minus(b, a), minus(c, a))),
                                   share(segment.along(r, q), dot(minus(b, a), minus(c, b))));
      });
}

TEST_CASE("the bound of a triangle's sides at a segment is above the error, and not far above", "[scene][filters]") {
  const auto all = layouts({0, 1, 100, -100, 450, -450, 1000});
  for (const double relative : errors)
    check_bound(20, all, relative > 0 ? 0.3 : 0.2, 150, [&](Numbers& x) {
      std::array<ImagePoint, 3> corner;
      for (ImagePoint& c : corner) c = x.point2();
      const ImagePoint p = x.point2(), q = x.point2();
      const double error = relative * std::fmax(std::fabs(corner[1].x - corner[0].x), std::fabs(corner[1].y - corner[0].y));
      TriangleFilter triangle;
      triangle.facing = p.x > q.x ? 1 : -1;
      std::array<Exact2, 3> exact;
      for (std::size_t k = 0; k < 3; ++k) {
        triangle.x[k] = corner[k].x;
        triangle.y[k] = corner[k].y;
        exact[k] = moved(corner[k], error, x);
      }
      const Exact2 a = moved(p, error, x), b = moved(q, error, x);
      const TriangleFilter::Overlap overlap = triangle.overlap(SegmentFilter(p, q, error));
      double most = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const Exact2 &from = exact[k], side = minus(exact[(k + 1) % 3], from);
        const auto turn = [&](const Exact2& end) { return Rational(triangle.facing) * det(side, minus(end, from)); };
        most = std::fmax(most, std::fmax(share(overlap.at_p(k), turn(a)), share(overlap.at_q(k), turn(b))));
        if (overlap.is_none && turn(a).sign() != Sign::positive && turn(b).sign() != Sign::positive) return most;
        if ((overlap.is_within >> k & 1U) != 0 && (turn(a).sign() != Sign::positive || turn(b).sign() != Sign::positive))
          return HUGE_VAL;
      }
      // The sides after the one that tells that there is nothing in common are left out; one that tells must be right.
      return overlap.is_none ? HUGE_VAL : most;
    });
}

TEST_CASE("the bound of a plane's value at a bounded point is above the error, and not far above", "[geometry][filters]") {
  // All numbers below 2^100; far below 1 underflow takes everything, and the bound says so.
  const auto all = layouts({0, 1, 60, 98, -60, -200, -350});
  for (const int kind : {0, 1, 2, 3, 4, 5, 6, 7, 8})
    for (const double relative : {0.0, 0x1p-40, 1.0})
      check_bound(27, all, relative > 0 ? 0.5 : 0.1, 60, [&](Numbers& x) {
        const Point3 a = x.point3(), b = x.point3(), c = x.point3(), p = x.point3(), eye = x.point3();
        const double k = x.next();
        const Plane plane = kind == 0   ? Plane::of_face(a, b, c)
                            : kind == 1 ? Plane::of_sight({eye, false}, a, b)
                            : kind == 2 ? Plane::of_sight({eye, true}, a, b)
                            : kind == 3 ? Plane::along_axis(a, b, 1)
                            : kind == 4 ? Plane::near(eye, a, k)
                            : kind == 5 ? Plane::near_line(eye, a, k, Plane::of_face(a, b, c))
                            : kind == 6
                                ? Plane::section({eye, true}, a, b)
                                : Plane::section({eye, kind == 7}, x.point3(), x.point3()).line_with(Plane::of_face(a, b, c));
        const double error = relative * std::fabs(a.x - b.x);
        const Exact3 at = moved(p, error, x);
        // value() is affine: that at p, and the gradient times how far the point has moved.
        const RationalArithmetic q;
        const Rational value =
            polynomials::value(q, plane, p) + polynomials::dot(polynomials::gradient(q, plane), minus(at, exact(p)));
        return share(PlaneFilter(plane, Arithmetic::staged)(BoundedPoint3{p, error}), value);
      });
}

TEST_CASE("the bounds of where three planes meet are above the errors, and not far above", "[geometry][filters]") {
  const auto all = layouts({0, 1, 30, -30, -60});
  for (const bool is_point : {true, false})
    check_bound(27, all, 0.1, 60, [&](Numbers& x) {
      std::vector<Point3> p;
      while (p.size() < 9) p.push_back(x.point3());
      Predicates exact(bit_range(p));
      const Plane s = Plane::of_face(p[0], p[1], p[2]), t = Plane::of_face(p[3], p[4], p[5]),
                  plane = Plane::of_face(p[6], p[7], p[8]);
      if (exact.turn(s, t, plane) == Sign::zero) return 0.0;
      const PlaneIntersection line(s, t, exact);
      const PlaneIntersection::Place place = line.place(plane);
      const auto at = line.exact_point(place);
      if (!is_point) {  // it is one of the coordinates, and far from the others
        double least = HUGE_VAL;
        for (const Rational& each : at) least = std::fmin(least, share(place.at, each));
        return least;
      }
      double most = 0;
      const auto bounded = line.bounded_point(place);
      for (std::size_t k = 0; k < 3; ++k) most = std::fmax(most, share(bounded[k], at[k]));
      return most;
    });
}

TEST_CASE("places along the line in which two planes meet are in the order of the exact points", "[geometry][filters]") {
  int compared = 0, by_filter = 0;
  for (const Layout& layout : layouts({0, 30, -30, -200})) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      CAPTURE(layout.offset, layout.spread, layout.power, layout.is_sliver, seed);
      std::mt19937_64 random(seed);
      std::vector<double> numbers(36);
      for (double& each : numbers) each = std::ldexp(static_cast<double>(static_cast<std::int64_t>(random())), -63);
      // Often the two planes differ by the last bits of one corner.
      if (seed % 2 == 0)
        for (std::size_t k = 0; k < 9; ++k) numbers[27 + k] = numbers[18 + k] + (k == seed % 9 ? 0x1p-52 : 0);
      Numbers x(numbers, layout);
      std::vector<Point3> p;
      while (p.size() < 12) p.push_back(x.point3());
      Predicates predicates(bit_range(p));
      const auto plane = [&](std::size_t k) { return Plane::of_face(p[3 * k], p[3 * k + 1], p[3 * k + 2]); };
      const RationalArithmetic q;
      const Exact3 along = polynomials::cross(polynomials::gradient(q, plane(0)), polynomials::gradient(q, plane(1)));
      if (along.x.sign() == Sign::zero && along.y.sign() == Sign::zero && along.z.sign() == Sign::zero) continue;
      const PlaneIntersection line(plane(0), plane(1), predicates);
      const PlaneIntersection::Place a = line.place(plane(2)), b = line.place(plane(3));
      if (a.rise == Sign::zero || b.rise == Sign::zero) continue;
      const auto of = [&](const PlaneIntersection::Place& place) {
        const auto at = line.exact_point(place);
        return Exact3{at[0], at[1], at[2]};
      };
      ++compared;
      const std::uint64_t filtered = predicates.counts().filter;
      CHECK(line.order(a, b) == polynomials::dot(along, minus(of(a), of(b))).sign());
      if (predicates.counts().filter > filtered) ++by_filter;
    }
  }
  CHECK(compared > 400);
  CHECK(by_filter > 100);
}

TEST_CASE("the bound of an affine depth is above its error over the triangle, and not far above", "[scene][filters]") {
  const auto all = layouts({0, 1, 40, -40, 200});
  for (const double relative : {0.0, 0x1p-50, 0x1p-20})
    for (const double width : {0.0, 0x1p-21})
      check_bound(20, all, relative + width > 0 ? 0.3 : 0.02, 200, [&](Numbers& x) {
        DepthCorners corners;
        for (ImagePoint& p : corners.image) p = x.point2();
        const double size =
            std::fabs(corners.image[1].x - corners.image[0].x) + std::fabs(corners.image[2].y - corners.image[0].y);
        corners.image_error = relative * size;
        std::array<Rational, 3> depth;
        std::array<Exact2, 3> seen;
        double reach_x = 0, reach_y = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          const double at = x.next(), half = width * std::fabs(at);
          corners.low[k] = at - half;
          corners.high[k] = at + half;
          depth[k] = moved(at, half, x.next());
          if (depth[k] < Rational(corners.low[k])) depth[k] = Rational(corners.low[k]);
          if (depth[k] > Rational(corners.high[k])) depth[k] = Rational(corners.high[k]);
          seen[k] = moved(corners.image[k], corners.image_error, x);
          reach_x = std::fmax(reach_x, std::fabs(corners.image[k].x) + std::fabs(corners.image[k].x - corners.image[0].x));
          reach_y = std::fmax(reach_y, std::fabs(corners.image[k].y) + std::fabs(corners.image[k].y - corners.image[0].y));
        }
        const AffineDepth n = affine_depth(corners, reach_x, reach_y);
        if (!(n.error < HUGE_VAL)) return 0.0;
        double most = 0;
        const auto look = [&](const Exact2& p, const Rational& exact) {
          const Rational at =
              Rational(n.value) + Rational(n.dx) * (p.x - Rational(n.p.x)) + Rational(n.dy) * (p.y - Rational(n.p.y));
          most = std::fmax(most, (magnitude(at - exact) / Rational(n.error)).to_double());
          // As it is computed, at what the image rounds to.
          const double px = p.x.to_double(), py = p.y.to_double();
          most = std::fmax(most, share(n.value + n.dx * (px - n.p.x) + n.dy * (py - n.p.y), n.error, exact));
        };
        for (std::size_t k = 0; k < 3; ++k) look(seen[k], depth[k]);
        const Rational half = .5;
        look({half * (seen[0].x + seen[1].x), half * (seen[0].y + seen[1].y)}, half * (depth[0] + depth[1]));
        return most;
      });
}

TEST_CASE("the bound of a triangle's sides in floats is above the error, and not far above", "[painter][filters]") {
  std::vector<Layout> all = {{}, {1, 0x1p-7}, {-1, 0x1p-16}, {0, 0x1p-6}, {0, 1, 0, true}};
  for (const double error : {0x1p-60, 0x1p-24, 0x1p-11})
    check_bound(16, all, error > 0x1p-30 ? 0.3 : 0.1, 400, [&](Numbers& x) {
      // To multiples of 2^-24, which are floats. No conversion there and back: of pairs, GCC 12 leaves it out at -O2.
      const auto clamped = [](double c) { return std::round(std::fmin(std::fmax(c, -1), 1) * 0x1p24) * 0x1p-24; };
      std::array<ImagePoint, 4> p;
      std::array<Exact2, 4> seen;
      for (ImagePoint& each : p) {
        each = x.point2();
        each = {clamped(each.x), clamped(each.y)};
      }
      for (std::size_t k = 0; k < 4; ++k) seen[k] = moved(p[k], error, x);
      const auto three = [&](auto at) { return std::array<float, 4>{at(p[0]), at(p[1]), at(p[2]), at(p[2])}; };
      ImageTriangle triangle = {}, point = {};
      triangle.x = three([](const ImagePoint& c) { return static_cast<float>(c.x); });
      triangle.y = three([](const ImagePoint& c) { return static_cast<float>(c.y); });
      point.x.fill(static_cast<float>(p[3].x));
      point.y.fill(static_cast<float>(p[3].y));
      const ImageSides sides(triangle, static_cast<float>(error));
      const ImageCorner corner(point, 0);
      double most = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double reach = std::fabs(p[3].x - p[k].x) + std::fabs(p[3].y - p[k].y);
        const float rest = share_of_reach(static_cast<float>(error), static_cast<float>(reach * (1 + 0x1p-20)));
        alignas(16) std::array<float, 4> value, bound;
        sides.value(corner).store(value.data());
        (sides.bound + FourFloats::all(rest)).store(bound.data());
        const Exact2 &a = seen[k], &b = seen[(k + 1) % 3];
        most = std::fmax(most, share(value[k], bound[k], det(minus(b, a), minus(seen[3], a))));
      }
      return most;
    });
}

namespace {

/// A triangle and a view, and the same exactly: what ProjectedMesh takes images and depths of.
class ExactView {
 public:
  ExactView(const std::array<Point3, 3>& corners, const View& view) : mesh_(mesh_of(corners)) {
    if (!mesh_.triangles.empty()) projected_.emplace(mesh_, view, Arithmetic::staged);
  }

  bool is_empty() const { return !projected_.has_value(); }
  const ProjectedMesh& operator*() const { return *projected_; }
  const ProjectedMesh* operator->() const { return &*projected_; }

  /// Any point that is as these are scaled. Perspective: as the rows and the direction of view are in doubles, which are exact
  /// as they are; parallel: with exact ratios of the direction's entries.
  Exact2 image(const Exact3& p) const {
    const Point3& e = projected_->eye().at;
    if (projected_->is_perspective()) {
      const Exact3 q = minus(p, exact(e));
      const Rational m = polynomials::dot(exact(depth_row()), q);
      const Rational mirror = determinant() > 0 ? -1 : 1;
      return {mirror * polynomials::dot(exact(projected_->rows()[0]), q) / m,
              polynomials::dot(exact(projected_->rows()[1]), q) / m};
    }
    const int k = axis();
    const std::array<Rational, 3> at = {p.x, p.y, p.z};
    const auto row = [&](int i) {
      return at[static_cast<std::size_t>(i % 3)] - Rational(e[i % 3]) / Rational(e[k]) * at[static_cast<std::size_t>(k)];
    };
    return {Rational(e[k] > 0 ? 1 : -1) * row(k + 1), row(k + 2)};
  }
  Rational nearness(const Exact3& p) const {
    const Point3& e = projected_->eye().at;
    if (projected_->is_perspective()) return -polynomials::dot(exact(depth_row()), minus(p, exact(e)));
    const Exact3 d = minus(p, exact(projected_->point(mesh_.edges.front().a)));
    return Rational(e[axis()] > 0 ? 1 : -1) * (axis() == 0 ? d.x : axis() == 1 ? d.y : d.z);
  }

 private:
  static Mesh mesh_of(const std::array<Point3, 3>& corners) {
    Polygons one;
    one.corners = {0, 1, 2};
    one.first = {0, 3};
    return make_mesh({corners.begin(), corners.end()}, one);
  }
  int axis() const { return largest_axis(projected_->eye().at); }
  Point3 depth_row() const {
    const Point3 &e = projected_->eye().at, t = projected_->camera().target;
    const Point3 d = {t.x - e.x, t.y - e.y, t.z - e.z};
    const double most = std::fmax(std::fabs(d.x), std::fmax(std::fabs(d.y), std::fabs(d.z)));
    return {d.x / most, d.y / most, d.z / most};
  }
  double determinant() const {
    const Point3 &r = projected_->rows()[0], &s = projected_->rows()[1], t = depth_row();
    return r.x * (s.y * t.z - s.z * t.y) + r.y * (s.z * t.x - s.x * t.z) + r.z * (s.x * t.y - s.y * t.x);
  }

  Mesh mesh_;
  std::optional<ProjectedMesh> projected_;
};

/// A triangle, seen from a direction or from a point that is not among its corners.
std::optional<ExactView> random_view(Numbers& x, bool is_perspective, const Layout& layout) {
  const std::array<Point3, 3> corners = {x.point3(), x.point3(), x.point3()};
  const Point3 d = {x.next(), x.next(), x.next()};
  if (std::fabs(d.x) + std::fabs(d.y) + std::fabs(d.z) < 0.1) return std::nullopt;
  if (!is_perspective) return std::optional<ExactView>(std::in_place, corners, scenes::from_direction(d));
  const auto away = [&](double c, double by) { return c + std::ldexp(4 * layout.spread * by, layout.power); };
  const Point3 eye = {away(corners[0].x, d.x), away(corners[0].y, d.y), away(corners[0].z, d.z)};
  if (eye == corners[0]) return std::nullopt;
  return std::optional<ExactView>(std::in_place, corners, scenes::from_eye(eye, corners[0]));
}

}  // namespace

TEST_CASE("the bounds of images and nearness are above the errors, and not far above", "[scene][filters]") {
  const auto all = layouts({0, 60, -60, 700, -700});
  for (const bool is_perspective : {false, true})
    for (const double relative : {0.0, 0x1p-40, 0x1p-10}) {
      const auto search = [&](Numbers& x, const Layout& layout, bool is_nearness) {
        const auto view = random_view(x, is_perspective, layout);
        if (!view || view->is_empty()) return 0.0;
        const ProjectedMesh& projected = **view;
        double most = 0;
        for (std::uint32_t v = 0; v < 3; ++v) {
          const Point3& p = projected.point(VertexId(v));
          if (projected.beyond_near(VertexId(v)) == Sign::negative) continue;
          // Within the error in the sum of the coordinates.
          const double error = relative * std::fabs(p.x - projected.point(VertexId((v + 1) % 3)).x);
          const Exact3 by = moved({0, 0, 0}, error, x);
          const Rational sum = magnitude(by.x) + magnitude(by.y) + magnitude(by.z);
          const Rational part = sum > Rational(error) ? Rational(error) / sum : Rational(1);
          const Exact3 at = {Rational(p.x) + part * by.x, Rational(p.y) + part * by.y, Rational(p.z) + part * by.z};
          if (is_nearness) {
            if (is_perspective && view->nearness(at).sign() != Sign::negative) continue;
            most = std::fmax(most, share(projected.nearness(p, error), view->nearness(at)));
            continue;
          }
          const BoundedPoint2 image = projected.image(p, error);
          if (!(image.error < HUGE_VAL)) continue;
          const Exact2 seen = view->image(at);
          most = std::fmax(most, std::fmax(share(image.p.x, image.error, seen.x), share(image.p.y, image.error, seen.y)));
          if (!(projected.image_error() < HUGE_VAL)) continue;
          const ImagePoint& own = projected.image(VertexId(v));
          const Exact2 vertex = view->image(exact(p));
          most = std::fmax(most, std::fmax(share(own.x, projected.image_error(), vertex.x),
                                           share(own.y, projected.image_error(), vertex.y)));
        }
        return most;
      };
      for (const bool is_nearness : {false, true})
        for (const Layout& layout : all)
          check_bound(21, std::span(&layout, 1), 0, 15, [&](Numbers& x) { return search(x, layout, is_nearness); });
      for (const bool is_nearness : {false, true})
        check_bound(21, std::span(all).first(1), relative > 0 ? 0.3 : 0.1, 300,
                    [&](Numbers& x) { return search(x, all[0], is_nearness); });
    }
}

TEST_CASE("a triangle's share per eye is within its bound, and not far from it", "[scene][filters]") {
  const auto all = layouts({0, 60, -60});
  for (const bool is_perspective : {false, true})
    for (const Layout& layout : all)
      check_bound(21, std::span(&layout, 1), &layout == all.data() ? 0.1 : 0, 100, [&](Numbers& x) {
        const auto view = random_view(x, is_perspective, layout);
        if (!view || view->is_empty()) return 0.0;
        const ProjectedMesh& projected = **view;
        const RationalArithmetic q;
        const Plane plane = projected.face_plane(TriangleId(0));
        const Point3& e = projected.eye().at;
        const Rational at_eye =
            is_perspective ? polynomials::value(q, plane, e) : polynomials::dot(polynomials::gradient(q, plane), exact(e));
        const ErrorBounded per_eye = TriangleFilter(projected, TriangleId(0)).per_eye;
        if (at_eye.sign() == Sign::zero) return per_eye.error < HUGE_VAL ? HUGE_VAL : 0.0;
        return share(per_eye, Rational(-1) / at_eye);
      });
}

TEST_CASE("a line's filter is certain of nothing wrong, and of most that is not degenerate", "[scene][filters]") {
  int certain = 0, asked = 0;
  for (const bool is_perspective : {false, true})
    for (const Layout& layout : layouts({0, 60, -60, 700, -700}))
      for (std::uint64_t seed = 0; seed < 60; ++seed) {
        CAPTURE(is_perspective, layout.offset, layout.spread, layout.power, layout.is_sliver, seed);
        std::mt19937_64 random(seed);
        std::vector<double> numbers(12);
        for (double& each : numbers) each = std::ldexp(static_cast<double>(static_cast<std::int64_t>(random())), -63);
        if (seed % 4 == 0)  // small integers: often on one line, or one point
          for (double& each : numbers) each = std::round(2 * each) / 2;
        Numbers x(numbers, layout);
        const auto view = random_view(x, is_perspective, layout);
        if (!view || view->is_empty()) continue;
        const ProjectedMesh& projected = **view;
        const VertexId a(0), b(1), p(2);
        if (projected.beyond_near(a) == Sign::negative || projected.beyond_near(b) == Sign::negative ||
            projected.beyond_near(p) == Sign::negative)
          continue;
        Predicates predicates = projected.predicates();
        const LineFilter line(projected, a, b);
        const Exact2 at_a = view->image(exact(projected.point(a))), at_b = view->image(exact(projected.point(b))),
                     at_p = view->image(exact(projected.point(p)));
        const Sign turn = det(minus(at_b, at_a), minus(at_p, at_a)).sign();
        ++asked;
        if (line.certain_side(p) != Sign::zero) {
          ++certain;
          CHECK(line.certain_side(p) == turn);
        }
        if (line.side_by_doubles(p)) CHECK(*line.side_by_doubles(p) == turn);
        CHECK(line.side(p, predicates) == turn);
        CHECK(line.is_point(predicates) == (at_a.x == at_b.x && at_a.y == at_b.y));
        const Sign from_a = dot(minus(at_b, at_a), minus(at_p, at_a)).sign(),
                   from_b = dot(minus(at_b, at_a), minus(at_p, at_b)).sign();
        if (line.certainly_before_start(p)) CHECK(from_a == Sign::negative);
        if (line.certainly_after_start(p)) CHECK(from_a == Sign::positive);
        if (line.certainly_before_end(p)) CHECK(from_b == Sign::negative);
        if (line.certainly_after_end(p)) CHECK(from_b == Sign::positive);
      }
  CHECK(asked > 1000);
  CHECK(certain > asked / 2);
}
