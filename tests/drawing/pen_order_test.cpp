#include "hsr/drawing/pen_order.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numeric>
#include <random>

#include "hsr/drawing/end_tree.h"
#include "hsr/drawing/pen_tour.h"

using namespace hsr;
using namespace hsr::internal;

namespace {

double distance(const PaperPoint& a, const PaperPoint& b) { return std::hypot(double(b.x - a.x), double(b.y - a.y)); }

PaperPoint any_point(std::mt19937& random, std::int64_t size) {
  return {static_cast<std::int64_t>(random() % size), static_cast<std::int64_t>(random() % size)};
}

void add(Drawing& d, const std::vector<PaperPoint>& points, bool closed = false, EdgeClass edge_class = EdgeClass::outline) {
  Polyline p;
  p.closed = closed;
  p.edge_class = edge_class;
  p.first_point = static_cast<std::uint32_t>(d.points.size());
  d.points.insert(d.points.end(), points.begin(), points.end());
  p.end_point = static_cast<std::uint32_t>(d.points.size());
  p.first_edge = static_cast<std::uint32_t>(d.edges.size());
  d.edges.push_back({p.first_edge, p.first_edge + 1});
  p.end_edge = static_cast<std::uint32_t>(d.edges.size());
  p.first_face = static_cast<std::uint32_t>(d.faces.size());
  d.faces.push_back(3);
  p.end_face = static_cast<std::uint32_t>(d.faces.size());
  d.polylines.push_back(p);
}

/// What is drawn: how often each straight piece of each class, whichever way.
std::map<std::tuple<EdgeClass, PaperPoint, PaperPoint>, int> ink(const Drawing& d) {
  std::map<std::tuple<EdgeClass, PaperPoint, PaperPoint>, int> pieces;
  for (const Polyline& p : d.polylines) {
    const auto points = d.points_of(p);
    for (std::size_t k = 0; k + (p.closed ? 0 : 1) < points.size(); ++k) {
      const auto [a, b] = std::minmax(points[k], points[(k + 1) % points.size()]);
      ++pieces[{p.edge_class, a, b}];
    }
  }
  return pieces;
}

Drawing any_drawing(std::mt19937& random, int lines) {
  Drawing d;
  for (const EdgeClass c : {EdgeClass::outline, EdgeClass::sharp})
    for (int k = 0; k < lines; ++k) {
      std::vector<PaperPoint> points = {any_point(random, 100000)};
      const bool closed = random() % 5 == 0;
      for (std::size_t n = 2 + random() % 4; points.size() < n + (closed ? 1 : 0);)
        points.push_back(
            {points.back().x + std::int64_t(random() % 4000) + 1, points.back().y + std::int64_t(random() % 4000)});
      add(d, points, closed, c);
    }
  return d;
}

}  // namespace

TEST_CASE("The nearest ends that are left are found as by looking at all", "[drawing][pen_order]") {
  std::mt19937 random(1);
  std::vector<PaperPoint> points;
  for (int k = 0; k < 500; ++k) points.push_back(any_point(random, 40));  // many in one place
  EndTree tree(points);
  std::vector<std::uint32_t> left(points.size());
  std::iota(left.begin(), left.end(), 0U);
  while (!left.empty()) {
    const PaperPoint place = any_point(random, 50);
    const auto order = [&](std::uint32_t i, std::uint32_t k) {
      return std::pair(distance(place, points[i]), i) < std::pair(distance(place, points[k]), k);
    };
    std::vector<std::uint32_t> sorted = left;
    std::sort(sorted.begin(), sorted.end(), order);
    const auto is_found = [&](std::uint32_t found, std::uint32_t expected) {
      const double d = distance(place, points[found]);
      return d == distance(place, points[expected]) && (d == 0 || found == expected);
    };
    REQUIRE(is_found(tree.nearest(place)->number, sorted.front()));
    std::erase_if(sorted, [](std::uint32_t i) { return i % 3 == 0; });
    sorted.resize(std::min<std::size_t>(sorted.size(), 8));
    const auto found = tree.nearest(place, 8, [](std::uint32_t i) { return i % 3 == 0; });
    REQUIRE(std::ranges::equal(found, sorted, is_found));
    const std::size_t out = random() % left.size();
    tree.take_out(left[out]);
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(out));
  }
  CHECK_FALSE(tree.nearest({0, 0}));
}

TEST_CASE("A tour that was shortened has each stroke once, and is nearly as short as any", "[drawing][pen_order]") {
  std::mt19937 random(2);
  double found = 0, least = 0, before = 0;
  for (int scene = 0; scene < 20; ++scene) {
    std::vector<PenStroke> strokes;
    for (int k = 0; k < 6; ++k) strokes.push_back({{any_point(random, 10000), any_point(random, 10000)}});
    PenTour tour;
    for (std::uint32_t k = 0; k < 6; ++k) tour.push_back(2 * k);
    before += pen_up(strokes, tour, {});
    shorten(strokes, tour, {});
    std::vector<std::uint32_t> drawn, order = {0, 1, 2, 3, 4, 5};
    for (const std::uint32_t pass : tour) drawn.push_back(pass / 2);
    std::sort(drawn.begin(), drawn.end());
    REQUIRE(drawn == order);
    found += pen_up(strokes, tour, {});
    double best = HUGE_VAL;
    do
      for (std::uint32_t turns = 0; turns < 64; ++turns) {
        for (std::uint32_t k = 0; k < 6; ++k) tour[k] = 2 * order[k] + (turns >> k & 1U);
        best = std::min(best, pen_up(strokes, tour, {}));
      }
    while (std::next_permutation(order.begin(), order.end()));
    least += best;
  }
  CHECK(found >= least - 1);
  CHECK(found < 1.1 * least);
  CHECK(found < 0.6 * before);
}

TEST_CASE("Sorted for a pen, a drawing has the same ink, layers and sources", "[drawing][pen_order][D18]") {
  std::mt19937 random(3);
  for (const int lines : {0, 1, 2, 10, 400}) {
    const Drawing before = any_drawing(random, lines);
    Drawing after = before;
    sort_for_pen(after);
    CHECK(ink(after) == ink(before));
    const auto of_class = [](const Polyline& p) { return p.edge_class; };
    CHECK(std::ranges::is_sorted(after.polylines, {}, of_class));
    auto edges = after.edges;
    std::sort(edges.begin(), edges.end());
    CHECK(edges == before.edges);
    const PenTravel was = pen_travel(before), is = pen_travel(after);
    CHECK(is.down == Approx(was.down));
    CHECK(is.up <= was.up + 1e-6);
    if (lines == 400) CHECK(is.up < 0.06 * was.up);
    Drawing again = before;
    sort_for_pen(again);
    CHECK(again.points == after.points);
  }
}

TEST_CASE("What begins at the end of another is one stroke", "[drawing][pen_order][D18]") {
  Drawing d;  // an outline in pieces, and a ring that it touches
  for (int k = 0; k < 37; ++k) {
    const PaperPoint a = {k * 1000, k % 2 * 500}, b = {(k + 1) * 1000, (k + 1) % 2 * 500};
    add(d, k % 3 == 0 ? std::vector{b, a} : std::vector{a, b});
  }
  std::vector<std::uint32_t> order(37);
  std::shuffle(d.polylines.begin(), d.polylines.end(), std::mt19937(4));
  const auto before = ink(d);
  sort_for_pen(d);
  REQUIRE(d.polylines.size() == 1);
  CHECK(ink(d) == before);
  CHECK(d.edges.size() == 37);
  CHECK(d.faces.size() == 1);

  Drawing ring;
  add(ring, {{0, 0}, {1000, 0}});
  add(ring, {{1000, 1000}, {0, 1000}, {0, 0}});
  add(ring, {{1000, 0}, {1000, 1000}});
  sort_for_pen(ring);
  REQUIRE(ring.polylines.size() == 1);
  CHECK(ring.polylines[0].closed);
  CHECK(ring.points.size() == 4);

  Drawing touched;
  add(touched, {{0, 0}, {5000, 0}});
  add(touched, {{9000, 0}, {9000, 900}, {5000, 0}, {6000, -900}}, true);
  const auto all = ink(touched);
  sort_for_pen(touched);
  CHECK(touched.polylines.size() == 1);
  CHECK(ink(touched) == all);
}
