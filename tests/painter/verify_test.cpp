#include "hsr/painter/verify/verify.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "geometry/error.h"
#include "geometry/rational_vector.h"
#include "hsr/painter/sort/depth_sort.h"
#include "hsr/painter/sort/z_sort.h"
#include "tests/oracle/painting_oracle.h"
#include "tests/scenes/random_scenes.h"

namespace hsr {

using namespace internal;

namespace {

PaintedPolygon polygon(std::initializer_list<Point3> corners, std::optional<std::uint32_t> face = {}) {
  PaintedPolygon p;
  p.face = face;
  for (const Point3& c : corners) p.corners.push_back(rational(c));
  return p;
}

PaintedPolygon square(double x, double y, double size, double z, std::optional<std::uint32_t> face = {}) {
  return polygon({{x, y, z}, {x + size, y, z}, {x + size, y + size, z}, {x, y + size, z}}, face);
}

const View from_above = scenes::from_direction({0, 0, 1});

TEST_CASE("two squares, in order and not", "[painter][verify][P13]") {
  const Verdict right = verify({square(0, 0, 2, 0), square(1, 1, 2, 1)}, from_above);
  CHECK(right.is_correct());
  CHECK(right.overlapping == 1);
  CHECK(right.order_exists);
  const Verdict wrong = verify({square(1, 1, 2, 1), square(0, 0, 2, 0)}, from_above);
  CHECK(wrong.wrong == 1);
  CHECK(wrong.order_exists);
  REQUIRE(wrong.first.size() == 1);
  const Violation& v = wrong.first.front();
  CHECK(v.earlier == 0);
  CHECK(v.later == 1);
  CHECK(v.witness.of_earlier == std::array<Rational, 3>{1.5, 1.5, 1.0});
  CHECK(v.witness.of_later == std::array<Rational, 3>{1.5, 1.5, 0.0});
}

TEST_CASE("an ulp decides", "[painter][verify][E2]") {
  const double above = std::nextafter(1.0, 2.0);
  CHECK(verify({square(0, 0, 1, 1), square(0, 0, 1, above)}, from_above).is_correct());
  CHECK_FALSE(verify({square(0, 0, 1, above), square(0, 0, 1, 1)}, from_above).is_correct());
  CHECK_FALSE(verify({square(0, 0, 1, 5e-324), square(0, 0, 1, 0)}, from_above).is_correct());
}

TEST_CASE("touching and abutting are no overlap", "[painter][verify][P6]") {
  CHECK(verify({square(0, 0, 1, 9), square(1, 0, 1, 0), square(0, 1, 1, 5), square(1, 1, 1, 7)}, from_above).overlapping == 0);
}

TEST_CASE("of coplanar pieces the higher face comes first", "[painter][verify][P2][P14]") {
  CHECK(verify({square(0, 0, 2, 0, 7), square(1, 1, 2, 0, 3)}, from_above).is_correct());
  const Verdict wrong = verify({square(0, 0, 2, 0, 3), square(1, 1, 2, 0, 7)}, from_above);
  CHECK(wrong.wrong == 1);
  CHECK(wrong.first.at(0).fault == Fault::coplanar);
  CHECK(verify({square(0, 0, 2, 0), square(1, 1, 2, 0)}, from_above).is_correct());  // nothing says which
}

TEST_CASE("two pieces of one face cover a place once", "[painter][verify][P14]") {
  const Verdict twice = verify({square(0, 0, 2, 0, 3), square(1, 1, 2, 0, 3)}, from_above);
  CHECK_FALSE(twice.is_correct());
  CHECK(twice.covered_twice == 1);
  CHECK(twice.wrong == 0);
  CHECK(twice.order_exists);
  CHECK(twice.first.at(0).fault == Fault::covered_twice);
  CHECK(twice.first.at(0).witness.of_later == std::array<Rational, 3>{1.5, 1.5, 0.0});
  CHECK(verify({square(0, 0, 2, 0, 3), square(2, 0, 2, 0, 3)}, from_above).is_correct());
}

TEST_CASE("what pierces has no order", "[painter][verify][P16][P17]") {
  const Verdict v = verify({square(-2, -2, 4, 0), polygon({{-1, -1, -1}, {-1, 1, -1}, {1, 1, 1}, {1, -1, 1}})}, from_above);
  CHECK(v.piercing == 1);
  CHECK_FALSE(v.order_exists);
  CHECK(v.cycle == std::vector<std::uint32_t>{0, 1});
  CHECK(v.cuts_that_suffice == 2);
  CHECK(v.first.at(0).fault == Fault::piercing);
  // The witness is where the later is the farther: at x below 0.
  CHECK(v.first.at(0).witness.of_later[0].sign() == Sign::negative);
}

std::vector<PaintedPolygon> slats(int n) {
  std::vector<PaintedPolygon> all;
  for (int k = 0; k < n; ++k) {
    const double a = 2 * std::numbers::pi * k / n, b = 2 * std::numbers::pi * (k + 1.5) / n;
    all.push_back(polygon({{9 * std::cos(a), 9 * std::sin(a), 1},
                           {10 * std::cos(a), 10 * std::sin(a), 1},
                           {9.5 * std::cos(b), 9.5 * std::sin(b), 0}}));
  }
  return all;
}

TEST_CASE("a circle of slats has no order, and the circle is named", "[painter][verify][P16]") {
  for (const int n : {5, 100}) {
    const Verdict v = verify(slats(n), from_above);
    CHECK_FALSE(v.order_exists);
    CHECK(v.wrong == 1);
    CHECK(v.cycle.size() == static_cast<std::size_t>(n));
    CHECK(v.cycle_witnesses.size() == v.cycle.size());
    CHECK(v.cuts_that_suffice.has_value());
    for (const Witness& w : v.cycle_witnesses) CHECK(w.of_earlier[2] < w.of_later[2]);
  }
  std::vector<PaintedPolygon> open = slats(5);
  open.pop_back();
  const Verdict v = verify(open, from_above);
  CHECK(v.order_exists);
}

TEST_CASE("of several cycles a shortest is named", "[painter][verify]") {
  std::vector<PaintedPolygon> all = slats(40);
  for (PaintedPolygon p : slats(5)) {
    for (auto& corner : p.corners) corner[0] = corner[0] + Rational(30.0);
    all.push_back(std::move(p));
  }
  const Verdict v = verify(all, from_above);
  CHECK(v.cycle.size() == 5);
  CHECK(*std::min_element(v.cycle.begin(), v.cycle.end()) >= 40);
  CHECK(v.wrong == 2);
}

// Three bars around an empty triangle, each over the next.
std::vector<PaintedPolygon> three_bars() {
  return {polygon({{-3, 0, 1}, {3, 0, -1}, {3, 1, -1}, {-3, 1, 1}}), polygon({{2, -3, 1}, {2, 6, -1}, {1, 6, -1}, {1, -3, 1}}),
          polygon({{3, 5, 1}, {-3, -1, -1}, {-3, 0, -1}, {3, 6, 1}})};
}

TEST_CASE("three bars in a cycle have no order, in parallel and in perspective", "[painter][verify][P17]") {
  for (const View& view : {from_above, scenes::from_eye({0, 0, 50}, {0, 0, 0}, 0.001)}) {
    const Verdict v = verify(three_bars(), view);
    CHECK(v.overlapping == 3);
    CHECK(v.piercing == 0);
    CHECK_FALSE(v.order_exists);
    REQUIRE(v.cycle.size() == 3);
    REQUIRE(v.cycle_witnesses.size() == 3);
    for (const Witness& w : v.cycle_witnesses) CHECK(w.of_earlier[2] < w.of_later[2]);
    CHECK(v.cuts_that_suffice.value() >= 1);
  }
}

TEST_CASE("a bent polygon that is over and under another pierces it", "[painter][verify]") {
  // Triangles (0, 0) (4, 0) (4, 4), above at its middle, and (0, 0) (4, 4) (0, 4), below.
  const PaintedPolygon bent = polygon({{0, 0, 0}, {4, 0, 3}, {4, 4, 0}, {0, 4, -3}});
  const Verdict v = verify({bent, polygon({{1, 2, 0}, {2, 1, 0}, {2.5, 1.5, 0}, {1.5, 2.5, 0}})}, from_above);
  CHECK(v.overlapping == 1);
  CHECK(v.piercing == 1);
  CHECK_FALSE(v.order_exists);
  CHECK(v.cycle.size() == 2);
}

TEST_CASE("neighbours in a mesh have no relation, and points need be no doubles", "[painter][verify]") {
  CHECK(verify({polygon({{0, 0, 0}, {2, 0, 1}, {0, 2, 5}}), polygon({{2, 0, 1}, {2, 2, 0}, {0, 2, 5}})}, from_above)
            .overlapping == 0);
  PaintedPolygon third = square(0, 0, 1, 1);
  for (auto& corner : third.corners) corner[2] = Rational::from_string("1/3");
  CHECK(verify({square(0, 0, 1, 1.0 / 3), third}, from_above).is_correct());  // 1/3 rounds down
  CHECK_FALSE(verify({third, square(0, 0, 1, 1.0 / 3)}, from_above).is_correct());
  CHECK(verify({third, square(0, 0, 1, std::nextafter(1.0 / 3, 1.0))}, from_above).is_correct());
}

TEST_CASE("corners that no double tells apart", "[painter][verify]") {
  const Rational third = Rational::from_string("1/3"), least = Rational(1.0) / Rational(1e300) / Rational(1e300);
  const auto at = [](const Rational& x, const Rational& z) {  // from x to x + 1
    PaintedPolygon p;
    const Rational end = x + Rational(1.0);
    for (const auto& [u, v] : {std::pair(x, 0.0), std::pair(end, 0.0), std::pair(end, 1.0), std::pair(x, 1.0)})
      p.corners.push_back({u, v, z});
    return p;
  };
  for (const View& view : {from_above, scenes::from_eye({0, 0, 10}, {0, 0, 0})}) {
    CHECK(verify({at(third, third), at(third, third + least)}, view).is_correct());
    CHECK(verify({at(third, third + least), at(third, third)}, view).wrong == 1);
    // Beside each other in one plane: abutting, and overlapping by next to nothing.
    CHECK(verify({at(third, third), at(third + Rational(1.0), third)}, view).overlapping == 0);
    CHECK(verify({at(third, third), at(third + Rational(1.0) - least, third)}, view).overlapping == 1);
    CHECK(verify({at(third, third), at(third + Rational(1.0) + least, third)}, view).overlapping == 0);
  }
}

TEST_CASE("a product that overflows decides nothing", "[painter][verify]") {
  // The side from the first to the second corner of one triangle, and the first corner p of the other: one product of their
  // determinant, of doubles nearest to them, is 2^1024, the other the largest double; the exact ones differ the other way.
  const auto at = [](int power, double less) {  // 2^power (1 - less 2^-53)
    return Rational(std::ldexp(1.0, power)) - Rational(less) * Rational(std::ldexp(1.0, power - 53));
  };
  const auto overlapping = [&](double less) {
    const PaintedPolygon right = {{}, {{0.0, 0.0, 0.0}, {at(513, 0.51), at(513, 0.45), 0.0}, {at(513, 0), 0.0, 0.0}}};
    const PaintedPolygon left = {{},
                                 {{at(511, less), at(511, 0), 1.0}, {0.0, std::ldexp(1.2, 511), 1.0}, {0.0, at(513, 0), 1.0}}};
    return verify({right, left}, from_above).overlapping;
  };
  CHECK(overlapping(0.45) == 0);  // p to the left of the side: beside it
  CHECK(overlapping(0) == 1);     // to its right: on it
}

TEST_CASE("the pairs of an order and of its reverse are the same", "[painter][verify]") {
  std::vector<PaintedPolygon> all;
  for (int i = 0; i < 12; ++i)
    for (int k = 0; k < 12; ++k) all.push_back(square(i % 4, k % 4, 2, i * 12 + k));
  const Verdict right = verify(all, from_above);
  CHECK(right.is_correct());
  std::reverse(all.begin(), all.end());
  const Verdict wrong = verify(all, from_above);
  CHECK(wrong.wrong == right.overlapping);
  CHECK(wrong.overlapping == right.overlapping);
  CHECK(wrong.order_exists);
  CHECK(wrong.first.size() == 10);
}

TEST_CASE("what is before the near plane, or edge-on, is passed over", "[painter][verify]") {
  const View view = scenes::from_eye({0, 0, 10}, {0, 0, 0}, 0.5);  // the near plane: z = 5
  CHECK(verify({square(-1, -1, 2, 7), square(-1, -1, 2, 0)}, view).is_correct());
  CHECK_FALSE(verify({square(-1, -1, 2, 4), square(-1, -1, 2, 0)}, view).is_correct());
  CHECK_FALSE(verify({square(-1, -1, 2, 5), square(-1, -1, 2, 0)}, view).is_correct());  // in it
  const Verdict edge_on = verify({polygon({{0, 0, 0}, {1, 0, 0}, {1, 0, 9}}), square(0, 0, 1, 1)}, from_above);
  CHECK(edge_on.polygons == 1);
  CHECK(edge_on.is_correct());
}

TEST_CASE("polygons that are not planar are judged by their triangles", "[painter][verify][P15]") {
  const PaintedPolygon bent = polygon({{0, 0, 0}, {2, 0, 1}, {2, 2, 0}, {0, 2, 1}});
  const Verdict v = verify({square(0, 0, 2, -1), bent, square(0, 0, 2, 2)}, from_above);
  CHECK(v.triangulated == 1);
  CHECK(v.is_correct());
  const PaintedPolygon hook = polygon({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {3, 4, 0}, {3, 1, 0}, {0, 1, 0}});
  CHECK(verify({square(1, 2, 1, 5), hook}, from_above).overlapping == 0);  // in its corner
  PaintedPolygon third = bent;
  third.corners[0][0] = Rational::from_string("1/3");
  CHECK_THROWS_AS(verify({third}, from_above), InputError);
}

TEST_CASE("exact at every size", "[painter][verify]") {
  for (const int power : {900, -900}) {
    const double s = std::ldexp(1, power);
    CHECK(verify({square(0, 0, s, 0), square(0, 0, s, s)}, from_above).is_correct());
    CHECK_FALSE(verify({square(0, 0, s, s), square(0, 0, s, 0)}, from_above).is_correct());
  }
}

// The relations of faces in file order, against the oracle's.
TEST_CASE("verdicts on random soups are the oracle's", "[painter][verify][oracle]") {
  for (const char* name : {"triangles", "edge_on", "stacks", "slopes", "around_the_eye"})
    for (std::uint64_t seed = 800'000; seed < 800'060; ++seed) {
      const scenes::TestScene scene = scenes::family(name).make(seed);
      const Mesh mesh = scene.mesh();
      INFO(name << " " << seed << "\n" << scenes::to_text(scene));
      const PaintersOrder order = z_sort(mesh, scene.view, DepthKey::centroid);
      std::vector<PaintedPolygon> pieces;
      std::vector<oracle::PaintedPolygon> same;
      for (const OrderedPiece& piece : order.pieces) {
        PaintedPolygon p;
        oracle::PaintedPolygon q;
        p.face = q.rank = piece.facet.value;
        for (const PieceCorner& c : order.corners_of(piece)) {
          p.corners.push_back(exact_point(mesh, scene.view, piece.facet, c));
          const auto& at = p.corners.back();
          q.corners.emplace_back(oracle::exact(at[0]), oracle::exact(at[1]), oracle::exact(at[2]));
        }
        pieces.push_back(std::move(p));
        same.push_back(std::move(q));
      }
      std::uint64_t overlapping = 0, wrong = 0, piercing = 0;
      for (std::size_t i = 0; i < same.size(); ++i)
        for (std::size_t k = i + 1; k < same.size(); ++k) {
          const oracle::PairOrder how = oracle::pair_order(scene.view, same[i], same[k]);
          if (how == oracle::PairOrder::apart) continue;
          ++overlapping;
          piercing += how == oracle::PairOrder::piercing ? 1 : 0;
          const bool coplanar_wrong = how == oracle::PairOrder::coplanar && same[i].rank <= same[k].rank;
          wrong += how == oracle::PairOrder::piercing || how == oracle::PairOrder::second_behind || coplanar_wrong ? 1 : 0;
        }
      VerifyOptions options;
      options.limit = 100;
      const Verdict v = verify(pieces, scene.view, options);
      CHECK(v.overlapping == overlapping);
      CHECK(v.wrong == wrong);
      CHECK(v.piercing == piercing);
      CHECK(v.first.size() == wrong);
      // A sorter cuts iff there is no order of whole pieces.
      const DepthSort sorted = depth_sort(mesh, scene.view);
      const bool is_cut = sorted.counts.cuts_at_intersections + sorted.counts.cuts_in_cycles > 0;
      if (wrong > 0) CHECK(v.order_exists == !is_cut);
    }
}

}  // namespace
}  // namespace hsr
