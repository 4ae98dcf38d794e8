#include "hsr/drawing/reach.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "hsr/drawing/cut_seams.h"
#include "hsr/drawing/paint_layers.h"
#include "hsr/drawing/paper_sides.h"

namespace hsr {
namespace {

using namespace internal;

void add(Fills& fills, const std::vector<std::vector<PaperPoint>>& rings, double opacity = 1) {
  Fill fill;
  fill.opacity = opacity;
  fill.first_ring = static_cast<std::uint32_t>(fills.rings.size());
  for (const auto& ring : rings) {
    fills.rings.push_row(ring);
  }
  fill.end_ring = static_cast<std::uint32_t>(fills.rings.size());
  fills.fills.push_back(fill);
}

/// By the nonzero rule.
bool covers(const Fills& fills, const Fill& fill, double x, double y) {
  int winding = 0;
  for (std::uint32_t r = fill.first_ring; r < fill.end_ring; ++r) {
    const auto ring = fills.rings[r];
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const PaperPoint &p = ring[k], &q = ring[(k + 1) % ring.size()];
      const double px = static_cast<double>(p.x), py = static_cast<double>(p.y), qx = static_cast<double>(q.x),
                   qy = static_cast<double>(q.y);
      if ((py > y) == (qy > y)) continue;
      if (px + (y - py) / (qy - py) * (qx - px) > x) winding += qy > py ? 1 : -1;
    }
  }
  return winding != 0;
}

constexpr int none = -1;

int shown_at(const Fills& fills, double x, double y) {
  for (std::size_t i = fills.fills.size(); i-- > 0;)
    if (covers(fills, fills.fills[i], x, y)) return static_cast<int>(i);
  return none;
}

constexpr std::int64_t cell = 5000;
constexpr int cells = 6;

/// Everything leans, so that corners overhang the sides of their polygons.
PaperPoint leaning(const PaperPoint& p) { return {p.x + p.y, p.y}; }

/// A sheet of triangles, beside one of squares whose corners lie between theirs, and within it a frame around a hole that another
/// fill closes. In an order by chance.
Fills sheet(unsigned seed, double opacity = 1) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<std::int64_t> some(-cell / 5, cell / 5);
  std::vector<std::vector<std::vector<PaperPoint>>> polygons;
  std::vector<std::vector<PaperPoint>> at(cells + 1, std::vector<PaperPoint>(cells + 1));
  for (int i = 0; i <= cells; ++i)
    for (int j = 0; j <= cells; ++j) {
      const bool is_inner = i > 0 && i < cells && j > 0 && j < cells;
      at[i][j] = {i * cell + (is_inner ? some(random) : 0), j * cell + (is_inner ? some(random) : 0)};
    }
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j) {
      polygons.push_back({{at[i][j], at[i + 1][j], at[i + 1][j + 1]}});
      polygons.push_back({{at[i][j], at[i + 1][j + 1], at[i][j + 1]}});
    }
  for (int j = 0; j < cells / 2; ++j) {
    const std::int64_t x = cells * cell, y = 2 * j * cell + cell / 2;
    const std::int64_t low = j == 0 ? 0 : y, high = j + 1 == cells / 2 ? cells * cell : y + 2 * cell;
    const std::vector<PaperPoint> outer = {{x, low}, {x + 2 * cell, low}, {x + 2 * cell, high}, {x, high}};
    const std::vector<PaperPoint> hole = {{x + 900, y + 900}, {x + 900, y + 1900}, {x + 1900, y + 1900}, {x + 1900, y + 900}};
    polygons.push_back({outer, hole});
    polygons.push_back({{hole.rbegin(), hole.rend()}});
  }
  for (auto& polygon : polygons)
    for (auto& ring : polygon)
      for (PaperPoint& p : ring) p = leaning(p);
  std::shuffle(polygons.begin(), polygons.end(), random);
  Fills fills;
  for (const auto& polygon : polygons) {
    add(fills, polygon, opacity);
    // By an odd seed no two alike: then they reach beneath parts of one another only.
    if (seed % 2 == 1) fills.fills.back().colour = {static_cast<std::uint8_t>(fills.fills.size() * 89), 0, 0, 255};
  }
  return fills;
}

struct Samples {
  std::size_t all = 0, open = 0;
};

/// Small discs all over the sheet, each as a pixel is: how many no fill covers wholly.
/// @param corners where pixels are hardest
Samples discs(const Fills& fills, const std::vector<PaperPoint>& corners, double radius) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> x(2 * radius, (cells + 2) * cell - 2 * radius), y(radius, cells * cell - radius);
  Samples samples;
  const auto look_at = [&](double u, double v) {
    std::vector<std::array<double, 2>> around = {{u, v}};
    for (int k = 0; k < 16; ++k)
      around.push_back({u + radius * std::cos(k * 0.3927 + 0.1), v + radius * std::sin(k * 0.3927 + 0.1)});
    const bool is_covered = std::any_of(fills.fills.begin(), fills.fills.end(), [&](const Fill& fill) {
      return std::all_of(around.begin(), around.end(), [&](const auto& p) { return covers(fills, fill, p[0], p[1]); });
    });
    ++samples.all;
    if (!is_covered) ++samples.open;
  };
  for (int k = 0; k < 500; ++k) {
    const double v = y(random);
    look_at(x(random) + v, v);
  }
  for (const PaperPoint& p : corners)
    if (p.x - p.y > 100 && p.y > 100 && p.x - p.y < (cells + 2) * cell - 100 && p.y < cells * cell - 100)
      look_at(static_cast<double>(p.x) + 3.3, static_cast<double>(p.y) - 1.7);
  return samples;
}

TEST_CASE("fills reach beneath what is painted later beside them, and the picture stays", "[drawing][fills][reach][D10]") {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Fills plain = sheet(seed);
    Fills reaching = plain;
    reach_beneath(reaching);
    REQUIRE(reaching.fills.size() == plain.fills.size());
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> x(-cell, (2 * cells + 3) * cell), y(-cell, (cells + 1) * cell);
    std::size_t differing = 0;
    for (int k = 0; k < 3000; ++k) {
      const double u = x(random), v = y(random);
      if (shown_at(plain, u, v) != shown_at(reaching, u, v)) ++differing;
    }
    CHECK(differing == 0);
    CHECK(discs(plain, plain.rings.values(), 40).open > 100);
    const Samples samples = discs(reaching, plain.rings.values(), 40);
    CHECK(samples.all > 600);
    CHECK(samples.open == 0);
  }
}

TEST_CASE("nothing reaches beneath what is seen through, but in a sheet, which is painted opaque", "[drawing][fills][reach]") {
  const Fills sheet_of_one = sheet(1, 0.5);
  Fills plain = sheet_of_one;
  for (std::size_t i = 0; i < plain.fills.size(); ++i) plain.fills[i].layer = static_cast<std::uint32_t>(i);
  Fills reaching = plain;
  reach_beneath(reaching);
  CHECK(reaching.rings.values() == plain.rings.values());
  reaching = sheet_of_one;
  reach_beneath(reaching);
  CHECK(discs(reaching, sheet_of_one.rings.values(), 40).open == 0);
}

TEST_CASE("parts of a cut face lie over one another where nothing is painted between them", "[drawing][fills][cuts]") {
  // A face in two parts, cut at x = 10000; behind the second, and painted between the two, a face whose border is the cut.
  const std::vector<PaperPoint> first = {{0, 0}, {10000, 0}, {10000, 8000}, {0, 8000}},
                                second = {{10000, 0}, {20000, 0}, {20000, 8000}, {10000, 8000}};
  const auto covers_beyond = [](const std::vector<PaperPoint>& ring) {
    Fills fills;
    add(fills, {ring});
    return covers(fills, fills.fills[0], 9900, 4000);
  };
  const auto closed = [&](const std::vector<PaperPoint>& between) {
    std::vector<std::vector<PaperPoint>> rings = {first, between, second};
    const std::vector<std::uint32_t> facets = {0, 1, 0};
    close_cuts(rings, facets);
    CHECK(rings[0] == first);
    CHECK(rings[1] == between);
    return rings[2];
  };
  CHECK(covers_beyond(closed({{10000, -2000}, {15000, -2000}, {15000, 9000}, {10000, 9000}})));
  // One that hides a part of the first, beside the cut: there is no room.
  CHECK(closed({{5000, 3000}, {12000, 3000}, {12000, 5000}, {5000, 5000}}) == second);
  // Nothing between: nothing can show.
  std::vector<std::vector<PaperPoint>> rings = {first, second};
  close_cuts(rings, std::vector<std::uint32_t>{0, 0});
  CHECK(rings[1] == second);
  // Parts of a few thousandths get no side without length.
  rings = {{{0, 0}, {5, 0}, {5, 3}}, {{100, 0}, {200, 0}, {200, 90}}, {{5, 0}, {9, 0}, {5, 3}}};
  close_cuts(rings, std::vector<std::uint32_t>{0, 1, 0});
  for (const auto& ring : rings)
    for (std::size_t k = 0; k < ring.size(); ++k) CHECK(ring[k] != ring[(k + 1) % ring.size()]);
}

TEST_CASE("rings that are united wind as their polygons do", "[drawing][fills][reach]") {
  const std::vector<PaperPoint> a = {{0, 0}, {10, 0}, {10, 10}, {0, 10}}, b = {{10, 0}, {20, 0}, {20, 10}, {10, 10}};
  std::vector<PaperSide> sides;
  for (const auto& ring : {a, b}) append_sides(ring, 0, sides);
  const auto rings = united_rings(sides);
  REQUIRE(rings.size() == 1);
  CHECK(rings[0] == std::vector<PaperPoint>{{0, 0}, {10, 0}, {20, 0}, {20, 10}, {10, 10}, {0, 10}});
}

TEST_CASE("see-through pieces lie in as few layers as overlap", "[drawing][fills][layers]") {
  const auto square = [](std::int64_t x, std::int64_t y) {
    return std::vector<PaperPoint>{{x, y}, {x + 10000, y}, {x + 10000, y + 10000}, {x, y + 10000}};
  };
  // A row of neighbours, one of them a thousandth too long; one on top of two of them; one apart.
  CHECK(paint_layers({square(0, 0), square(10000, 0), square(19999, 0), square(5000, 5000), square(50000, 0),
                      square(5000, 5000)}) == std::vector<std::uint32_t>{0, 0, 0, 1, 0, 2});
  CHECK(paint_layers({square(0, 0), square(9990, 0)}) == std::vector<std::uint32_t>{0, 1});
}

}  // namespace
}  // namespace hsr
