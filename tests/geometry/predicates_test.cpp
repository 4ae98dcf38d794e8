#include "geometry/predicates.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <random>

#include "geometry/arithmetics.h"
#include "geometry/constructed_point.h"
#include "geometry/exact_meet.h"
#include "geometry/plane_filter.h"
#include "geometry/polynomials.h"

using namespace hsr;
using namespace hsr::internal;
using polynomials::value;

namespace {

Sign reference_side(const Plane& x, const Point3& p) { return sign_of(value(RationalArithmetic{}, x, p)); }
Sign reference_cross(const Plane& x, const Plane& y, const Point3& p, const Point3& q) {
  return sign_of(polynomials::cross_value(RationalArithmetic{}, x, y, p, q));
}

/// Numbers that love trouble, in families.
class Numbers {
 public:
  enum Family { small_integers, float32, doubles, any_exponent, any_bits, subnormals, near_one, sparse, families };

  explicit Numbers(std::uint64_t seed) : random_(seed) {}

  std::uint64_t operator()(std::uint64_t below) { return random_() % below; }
  double mantissa() { return std::ldexp(static_cast<double>(static_cast<std::int64_t>(random_())), -63); }

  double number(Family family) {
    switch (family) {
      case small_integers:
        return static_cast<double>(random_() % 9) - 4;
      case float32:
        return static_cast<double>(static_cast<float>(mantissa()));
      case doubles:
        return mantissa();
      case any_exponent:
        return std::ldexp(mantissa(), static_cast<int>(random_() % 2097) - 1074);
      case any_bits: {
        const std::uint64_t bits = random_();
        double x = 0;
        std::memcpy(&x, &bits, sizeof x);
        return std::isfinite(x) ? x : 1;
      }
      case subnormals:
        return 5e-324 * (static_cast<double>(random_() % 17) - 8);
      case near_one:
        return (random_() % 2 == 0 ? 1 : -1) * (1 + 0x1p-52 * static_cast<double>(random_() % 3));
      default:
        return random_() % 2 == 0 ? 0 : std::ldexp(1, static_cast<int>(random_() % 2000) - 1000);
    }
  }
  Point3 point(Family f) { return {number(f), number(f), number(f)}; }

  /// Sometimes one of `points` again, or the fourth corner of a parallelogram, one ulp off or not: exactly or nearly
  /// degenerate.
  Point3 point_near(Family f, const std::vector<Point3>& points) {
    if (points.size() < 3 || random_() % 2 == 0) return point(f);
    const auto pick = [&] { return points[random_() % points.size()]; };
    const Point3 a = pick(), b = pick(), c = pick();
    Point3 p = {a.x + (b.x - c.x), a.y + (b.y - c.y), a.z + (b.z - c.z)};
    if (!std::isfinite(p.x + p.y + p.z)) return a;
    if (random_() % 2 == 0) p.x = std::nextafter(p.x, random_() % 2 == 0 ? 1 : -1);
    return p;
  }

 private:
  std::mt19937_64 random_;
};

/// Points under one bit range, the viewpoint, and planes of every kind through them.
struct Configuration {
  Numbers::Family family;
  std::vector<Point3> points;
  Viewpoint eye;
  BitRange bit_range, direction;

  Configuration(Numbers& random, std::size_t count, bool with_direction) {
    family = static_cast<Numbers::Family>(random(Numbers::families));
    while (points.size() < count) points.push_back(random.point_near(family, points));
    eye = {points[0], with_direction};
    if (with_direction && eye.at == Point3{}) eye.at = {0, 0, 1};
    for (const Point3& p : points) bit_range.add(p);
    if (with_direction) direction.add(eye.at);
  }

  Plane plane(Numbers& random) const {
    const auto pick = [&]() -> const Point3& { return points[1 + random(points.size() - 1)]; };
    const auto axis = static_cast<int>(random(3));
    switch (random(4)) {
      case 0:
        return Plane::of_face(pick(), pick(), pick());
      case 1:
        return Plane::of_sight(eye, pick(), pick());
      case 2:
        return Plane::along_axis(pick(), pick(), axis);
      default:
        return Plane::of_sight_along_axis(eye, pick(), axis);
    }
  }
};

/// Every stage that decides must decide like the rationals. @return the number of stages that decided
template <class Polynomial>
int check_stages(const Polynomial& polynomial, Sign expected, const Configuration& c, int degree) {
  int decided = 0;
  const ErrorBounded x = polynomial(FilterArithmetic{});
  if (x.is_certain()) {
    ++decided;
    if (sign_of(x.value) != expected) return -1;
  }
  {
    const CGAL::Protect_FPU_rounding<true> directed;
    const auto y = polynomial(IntervalArithmetic{});
    if (y.inf() > 0 || y.sup() < 0 || (y.inf() == 0 && y.sup() == 0)) {
      ++decided;
      if ((y.inf() > 0 ? Sign::positive : y.sup() < 0 ? Sign::negative : Sign::zero) != expected) return -2;
    }
  }
  const int bits = degree * std::max({c.bit_range.bits() + 1, c.direction.bits(), 1}) + 13;
  const int lowest = c.bit_range.lowest, direction = c.direction.lowest;
  if (bits <= 127 && std::abs(lowest) < 1000 && std::abs(direction) < 1000) {
    ++decided;
    if (sign_of(polynomial(NarrowArithmetic{std::ldexp(1, -lowest), std::ldexp(1, -direction)})) != expected) return -3;
  }
  if (bits <= 192 && ++decided > 0 && polynomial(FixedArithmetic<3>{lowest, direction}).sign() != expected) return -4;
  if (bits <= 384 && ++decided > 0 && polynomial(FixedArithmetic<6>{lowest, direction}).sign() != expected) return -5;
  if (bits <= 768 && ++decided > 0 && polynomial(FixedArithmetic<12>{lowest, direction}).sign() != expected) return -6;
  if (static_cast<int>(CGAL::sign(polynomial(BigArithmetic{}))) != static_cast<int>(expected)) return -7;
  return decided + 1;
}

struct Fuzzed {
  std::size_t wrong = 0, zeros = 0;
  std::array<std::size_t, 9> stages_decided = {};

  void add(int stages, Sign answer, Sign expected) {
    if (stages < 0 || answer != expected) ++wrong;
    if (expected == Sign::zero) ++zeros;
    if (stages >= 0) ++stages_decided[static_cast<std::size_t>(stages)];
  }
  void check(std::size_t count) const {
    CHECK(wrong == 0);
    CHECK(zeros > count / 100);
    CHECK(stages_decided[1] > 0);  // some that nothing but big numbers decides
  }
};

void fuzz_side(std::size_t count, std::uint64_t seed) {
  Numbers random(seed);
  Fuzzed fuzzed;
  for (std::size_t i = 0; i < count; ++i) {
    const Configuration c(random, 6, i % 2 == 0);
    const Plane x = c.plane(random);
    const Point3& p = c.points[1 + random(5)];
    const Sign expected = reference_side(x, p);
    Predicates predicates(c.bit_range, c.direction);
    fuzzed.add(check_stages([&](const auto& a) { return value(a, x, p); }, expected, c, 3), predicates.side(x, p), expected);
    if (predicates.side_beyond_filter(x, p) != expected) ++fuzzed.wrong;
    if (predicates.filter_is_proven()) {
      const ErrorBounded y = PlaneFilter(x, Arithmetic::staged)(p);
      if (y.is_certain() && sign_of(y.value) != expected) ++fuzzed.wrong;
    }
  }
  fuzzed.check(count);
}

void fuzz_cross(std::size_t count, std::uint64_t seed) {
  Numbers random(seed);
  Fuzzed fuzzed;
  for (std::size_t i = 0; i < count; ++i) {
    const Configuration c(random, 8, i % 2 == 0);
    const Plane x = c.plane(random), y = random(8) == 0 ? x : c.plane(random);
    const Point3 &p = c.points[1 + random(7)], &q = c.points[1 + random(7)];
    const Sign expected = reference_cross(x, y, p, q);
    Predicates predicates(c.bit_range, c.direction);
    fuzzed.add(check_stages([&](const auto& a) { return polynomials::cross_value(a, x, y, p, q); }, expected, c, 6),
               predicates.cross(x, y, p, q), expected);
  }
  fuzzed.check(count);
}

void fuzz_meet(std::size_t count, std::uint64_t seed) {
  Numbers random(seed);
  Fuzzed fuzzed;
  for (std::size_t i = 0; i < count;) {
    const Configuration c(random, 10, i % 2 == 0);
    const Plane x = c.plane(random), p = c.plane(random), q = c.plane(random), r = c.plane(random);
    const Sign meet = sign_of(polynomials::meet_value(RationalArithmetic{}, p, q, r));
    if (meet == Sign::zero) continue;
    ++i;
    const auto polynomial = [&](const auto& a) { return polynomials::meet_side_value(a, x, p, q, r); };
    const Sign expected = sign_of(polynomial(RationalArithmetic{}));
    Predicates predicates(c.bit_range, c.direction);
    fuzzed.add(check_stages(polynomial, expected, c, 9), meet * predicates.side(x, p, q, r), expected);
  }
  fuzzed.check(count);
}

void fuzz_near(std::size_t count, std::uint64_t seed) {
  Numbers random(seed);
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Configuration c(random, 8, false);
    const Point3& target = c.points[1];
    const double k = random(2) == 0 ? 0.001 : std::fabs(random.number(c.family));
    const Plane near = Plane::near(c.eye.at, target, k), line = Plane::near_line(c.eye.at, target, k, c.plane(random));
    const Point3 &p = c.points[2 + random(6)], &q = c.points[2 + random(6)];
    const Plane y = c.plane(random);
    Predicates predicates(c.bit_range);
    for (const Plane& x : {near, line}) {
      const Sign expected = reference_side(x, p);
      if (predicates.side(x, p) != expected || predicates.side_beyond_filter(x, p) != expected) ++wrong;
      if (predicates.filter_is_proven()) {
        const ErrorBounded v = PlaneFilter(x, Arithmetic::staged)(p);
        if (v.is_certain() && sign_of(v.value) != expected) ++wrong;
      }
      if (predicates.cross(x, y, p, q) != reference_cross(x, y, p, q)) ++wrong;
    }
  }
  CHECK(wrong == 0);
}

Predicates for_points(const std::vector<Point3>& points, Arithmetic arithmetic = Arithmetic::staged) {
  return Predicates(bit_range(points), {}, arithmetic);
}

}  // namespace

TEST_CASE("every stage of side has the sign of the rationals", "[geometry][predicates][fuzz][E1][A1]") {
  fuzz_side(200'000, 1);
}
TEST_CASE("every stage of cross has the sign of the rationals", "[geometry][predicates][fuzz][A1]") { fuzz_cross(200'000, 2); }
TEST_CASE("every stage of side at three planes' meet has the sign of the rationals", "[geometry][predicates][fuzz][A1]") {
  fuzz_meet(200'000, 3);
}
TEST_CASE("the near plane and its lines have the signs of the rationals", "[geometry][predicates][fuzz][V7]") {
  fuzz_near(20'000, 4);
}

TEST_CASE("ten million sides have the sign of the rationals", "[.][long][side]") { fuzz_side(10'000'000, 11); }
TEST_CASE("ten million crosses have the sign of the rationals", "[.][long][cross]") { fuzz_cross(10'000'000, 12); }
TEST_CASE("ten million meets have the sign of the rationals", "[.][long][meet]") { fuzz_meet(10'000'000, 13); }

TEST_CASE("the fuzz test sees a polynomial that is wrong in its last bit", "[geometry][predicates]") {
  // orientation of four nearly coplanar points, once with the last coordinate rounded to a float as a careless stage would
  const double z = 1 + 0x1p-52;
  const Plane x = Plane::of_face({0, 0, 1}, {1, 0, 1}, {0, 1, 1});
  const Configuration c = [] {
    Numbers random(1);
    return Configuration(random, 3, false);
  }();
  const auto careless = [&](const auto& a) { return value(a, x, Point3{0.5, 0.5, static_cast<float>(z)}); };
  CHECK(check_stages(careless, reference_side(x, {0.5, 0.5, z}), c, 3) < 0);
}

TEST_CASE("the stage that decides is the cheapest that can", "[geometry][predicates][A2]") {
  const auto decide = [](const std::vector<Point3>& p) {
    Predicates predicates = for_points(p);
    const Sign s = predicates.side(Plane::of_face(p[0], p[1], p[2]), p[3]);
    return std::pair{s, predicates.counts()};
  };
  SECTION("the filter, where the points are far from degenerate") {
    const auto [s, n] = decide({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    CHECK(s == Sign::positive);
    CHECK(n == DecisionCounts{.filter = 1});
  }
  SECTION("128-bit integers, where few bits make a zero") {
    const auto [s, n] = decide({{0, 0, 0}, {1, 2, 3}, {4, 5, 6}, {5, 7, 9}});
    CHECK(s == Sign::zero);
    CHECK(n == DecisionCounts{.narrow = 1, .zero = 1});
  }
  SECTION("128-bit integers, where doubles lose the last bit of a determinant") {
    // 2^30 2^30 - (2^30 - 1) (2^30 + 1) = 1
    const auto [s, n] = decide({{0, 0, 0}, {0x1p30, 0x1p30 - 1, 0}, {0, 0, 1}, {0x1p30 + 1, 0x1p30, 0}});
    CHECK(s == Sign::negative);
    CHECK(n == DecisionCounts{.narrow = 1});
  }
  SECTION("the interval, for a zero of axis-parallel points with many bits") {
    const auto [s, n] = decide({{0.1, 0.2, 0.3}, {1.1, 0.2, 0.3}, {0.1, 1.7, 0.3}, {0x1p-60, 5.1, 0.3}});
    CHECK(s == Sign::zero);
    CHECK(n == DecisionCounts{.interval = 1, .zero = 1});
  }
  SECTION("the interval, for doubles that are exact where the filter's bound assumes a rounding") {
    // 2^26 2^26 - (2^26 - 1) (2^26 + 1) = 1, times 2^40
    const auto [s, n] = decide({{0, 0, 0}, {0x1p26, 0x1p26 - 1, 0}, {0, 0, 0x1p40}, {0x1p26 + 1, 0x1p26, 0}});
    CHECK(s == Sign::negative);
    CHECK(n == DecisionCounts{.interval = 1});
  }
  SECTION("wide integers, for one ulp beside a plane of full doubles") {
    // p = a + b - c but for the rounding of the sum
    const Point3 a = {0.1, 0.7, 0.3}, b = {0.9, 0.4, 0.15}, c = {0.55, 0.25, 0.8};
    const Point3 p = {a.x + b.x - c.x, a.y + b.y - c.y, a.z + b.z - c.z};
    const auto [s, n] = decide({a, b, c, p});
    CHECK(s == reference_side(Plane::of_face(a, b, c), p));
    CHECK(n.fixed == 1);
    CHECK(n.all() == 1);
  }
  SECTION("wide integers of each width, then big floats, as the bits grow") {
    // The plane of (e, 0), (1, 1) and the z axis; (2, 2) is beside it by e, which every difference in doubles loses.
    const auto beside = [&](int exponent) {
      const double e = std::ldexp(1, exponent);
      return decide({{e, 0, 0}, {1, 1, 0}, {e, 0, 1}, {2, 2, 0}});
    };
    for (const int exponent : {-56, -57, -120, -121, -248}) {  // 190, 193, 382, 385 and 766 bits
      const auto [s, n] = beside(exponent);
      CHECK(s == Sign::positive);
      CHECK(n == DecisionCounts{.fixed = 1});
    }
    const auto [s, n] = beside(-249);  // 769 bits
    CHECK(s == Sign::positive);
    CHECK(n == DecisionCounts{.big = 1});
  }
  SECTION("big floats, where the numbers are 2^1000 apart") {
    const auto [s, n] = decide({{0, 0, 0}, {1e-256, 0, 0}, {0, 0, 1}, {.5, 1e-256, .5}});
    CHECK(s == Sign::negative);  // the value is -1e-512
    CHECK(n == DecisionCounts{.big = 1});
  }
}

TEST_CASE("counts of stages add up", "[geometry][predicates][A3]") {
  DecisionCounts n = {.filter = 1, .interval = 2, .narrow = 4, .fixed = 8, .big = 16, .zero = 32};
  CHECK(n.exact() == 28);
  CHECK(n.all() == 31);
  n += n;
  CHECK(n == DecisionCounts{.filter = 2, .interval = 4, .narrow = 8, .fixed = 16, .big = 32, .zero = 64});
}

TEST_CASE("orientation does not lose what lies below the smallest double", "[geometry][predicates]") {
  // orient2d((0, 0), (0, 5e-324), (5e-324, 0)) is negative; along the z axis the plane's value is its opposite
  const std::vector<Point3> p = {{0, 0, 0}, {0, 5e-324, 0}, {5e-324, 0, 0}};
  CHECK(for_points(p).side(Plane::along_axis(p[0], p[1], 2), p[2]) == Sign::positive);
}

TEST_CASE("every arithmetic but plain doubles gives the same signs", "[geometry][predicates][A4]") {
  Numbers random(21);
  for (int i = 0; i < 500; ++i) {
    const Configuration c(random, 8, i % 2 == 0);
    const Plane x = c.plane(random), y = c.plane(random);
    for (const Arithmetic arithmetic : {Arithmetic::interval, Arithmetic::rational}) {
      Predicates staged(c.bit_range, c.direction), other(c.bit_range, c.direction, arithmetic);
      CHECK(staged.side(x, c.points[1]) == other.side(x, c.points[1]));
      CHECK(staged.cross(x, y, c.points[1], c.points[2]) == other.cross(x, y, c.points[1], c.points[2]));
      CHECK(other.counts().filter == 0);
      CHECK(other.counts().narrow == 0);
      if (arithmetic == Arithmetic::rational) CHECK(other.counts().big == other.counts().all());
    }
  }
}

TEST_CASE("plain doubles are wrong where the answer needs exactness, so the comparison means something",
          "[geometry][predicates][A4]") {
  const std::vector<Point3> p = {{0, 0, 0}, {1e-256, 0, 0}, {0, 0, 1}, {.5, 1e-256, .5}};
  CHECK(for_points(p, Arithmetic::double_only).side(Plane::of_face(p[0], p[1], p[2]), p[3]) == Sign::zero);
}

TEST_CASE("the widest numbers of each fixed width still fit", "[geometry][predicates]") {
  // For each degree, the most bits with which 127, 192, 384 and 768 bits are said to suffice; and one more, for the next stage.
  Numbers random(51);
  std::size_t exact = 0;
  for (const int bits : {11, 12, 18, 19, 28, 29, 37, 38, 40, 41, 58, 59, 60, 61, 82, 83, 122, 123, 124, 125}) {
    const double most = bits <= 53 ? std::ldexp(1, bits) - 1 : std::ldexp(0x1p53 - 1, bits - 53);
    for (int i = 0; i < 150; ++i) {
      std::vector<Point3> p = {{1, 1, 1}};  // the lowest bit
      const auto coordinate = [&] { return (random(2) == 0 ? -1 : 1) * (random(8) == 0 ? 1 : most); };
      while (p.size() < 14) p.push_back({coordinate(), coordinate(), coordinate()});
      const Viewpoint eye = {p[13], i % 2 == 0};
      BitRange direction;
      if (eye.is_direction) direction.add(eye.at);
      Predicates predicates(bit_range(p), direction);
      const Plane a = Plane::of_face(p[1], p[2], p[3]), b = Plane::of_sight(eye, p[4], p[5]),
                  c = Plane::of_face(p[6], p[7], p[8]);
      const Plane x = Plane::of_face(p[9], p[10], p[11]);
      CHECK(predicates.side_beyond_filter(a, p[12]) == reference_side(a, p[12]));
      CHECK(predicates.side_beyond_filter(b, p[12]) == reference_side(b, p[12]));
      CHECK(predicates.cross(a, b, p[12], p[0]) == reference_cross(a, b, p[12], p[0]));
      const Sign meet = sign_of(polynomials::meet_value(RationalArithmetic{}, a, b, c));
      if (meet != Sign::zero)
        CHECK(predicates.side(x, a, b, c) == meet * sign_of(polynomials::meet_side_value(RationalArithmetic{}, x, a, b, c)));
      const Plane d = Plane::of_face(p[4], p[5], p[6]);
      if (const Sign at = sign_of(polynomials::meet_value(RationalArithmetic{}, a, c, d)); at != Sign::zero) {
        const ExactMeet point(bit_range(p), a, c, d);
        CHECK(point.side(x) == at * sign_of(polynomials::meet_side_value(RationalArithmetic{}, x, a, c, d)));
        CHECK(point.side(c) == Sign::zero);
      } else {
        CHECK_THROWS_AS(ExactMeet(bit_range(p), a, c, d), PreconditionError);
      }
      exact += predicates.counts().exact();
    }
  }
  CHECK(exact > 1000);
}

TEST_CASE("a prepared plane is certain of nothing that overflows", "[geometry][predicates]") {
  Numbers random(61);
  for (int i = 0; i < 20000; ++i) {
    std::vector<Point3> p;
    while (p.size() < 6) p.push_back({random.mantissa() * 0x1p99, random.mantissa() * 0x1p99, random.mantissa() * 0x1p99});
    const double k = std::ldexp(1 + std::fabs(random.mantissa()), static_cast<int>(random(1000)));
    const Plane line = Plane::near_line(p[0], p[1], k, Plane::of_face(p[2], p[3], p[4]));
    const ErrorBounded v = PlaneFilter(line, Arithmetic::staged)(p[5]);
    if (v.is_certain() && sign_of(v.value) != reference_side(line, p[5])) FAIL("a wrong sign with k = " << k);
  }
}

TEST_CASE("the bound of a prepared plane is above the error, and not far above", "[geometry][predicates]") {
  // Climbs toward the worst error of a plane's value, relative to its bound.
  Numbers random(71);
  Rational worst;
  for (int climb = 0; climb < 60; ++climb) {
    std::vector<Point3> p;
    while (p.size() < 4) p.push_back(random.point(Numbers::doubles));
    Rational best;
    for (int step = 0; step < 400; ++step) {
      std::vector<Point3> q = p;
      Point3& moved = q[random(4)];
      double& x = random(3) == 0 ? moved.x : random(2) == 0 ? moved.y : moved.z;
      x += random.mantissa() * std::ldexp(1, -static_cast<int>(random(53)));
      const Plane plane = Plane::of_face(q[0], q[1], q[2]);
      const ErrorBounded v = PlaneFilter(plane, Arithmetic::staged)(q[3]);
      if (!(v.error > 0x1p-500)) continue;
      Rational error = Rational(v.value) - value(RationalArithmetic{}, plane, q[3]);
      if (error.sign() == Sign::negative) error = -error;
      const Rational share = error / Rational(v.error);
      if (share > best) {
        best = share;
        p = q;
      }
    }
    if (best > worst) worst = best;
  }
  CHECK(worst.to_double() <= 1);
  CHECK(worst.to_double() > 0.2);  // a bound that were a third of this one would be passed
}

TEST_CASE("the cross of two planes' values tells the order of the parameters at which they cut an edge",
          "[geometry][predicates]") {
  Numbers random(31);
  int compared = 0;
  for (int i = 0; i < 3000; ++i) {
    const Configuration c(random, 8, i % 2 == 0);
    const Plane x = c.plane(random), y = random(6) == 0 ? x : c.plane(random);
    const Point3 &p = c.points[1], &q = c.points[2];
    const auto cuts = [&](const Plane& plane) {
      const Sign s = reference_side(plane, p) * reference_side(plane, q);
      return s == Sign::negative || (s == Sign::zero && reference_side(plane, p) != reference_side(plane, q));
    };
    if (!cuts(x) || !cuts(y)) continue;
    ++compared;
    const Rational difference = parameter_of_cut(x, p, q) - parameter_of_cut(y, p, q);
    const auto fall = [&](const Plane& plane) {  // of the plane's value from p to q
      const Sign at_p = reference_side(plane, p);
      return at_p != Sign::zero ? at_p : -reference_side(plane, q);
    };
    CHECK(-(fall(x) * fall(y) * Predicates(c.bit_range, c.direction).cross(x, y, p, q)) == difference.sign());
  }
  CHECK(compared > 300);
}

TEST_CASE("scaling by powers of two changes no sign", "[geometry][predicates]") {
  Numbers random(41);
  for (int i = 0; i < 500; ++i) {
    std::vector<Point3> p;
    while (p.size() < 6) p.push_back(random.point_near(Numbers::float32, p));
    const int k = static_cast<int>(random(1801)) - 900;
    std::vector<Point3> q;
    for (const Point3& r : p) q.push_back({std::ldexp(r.x, k), std::ldexp(r.y, k), std::ldexp(r.z, k)});
    const auto signs = [](const std::vector<Point3>& r) {
      Predicates predicates = for_points(r);
      return std::pair{
          predicates.side(Plane::of_face(r[0], r[1], r[2]), r[3]),
          predicates.cross(Plane::of_face(r[0], r[1], r[2]), Plane::of_sight({r[3], false}, r[4], r[5]), r[1], r[5])};
    };
    CHECK(signs(p) == signs(q));
  }
}
