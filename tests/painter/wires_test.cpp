#include "hsr/painter/wires.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "geometry/rational_vector.h"
#include "hsr/painter/bsp/bsp.h"
#include "hsr/painter/sort/depth_sort.h"
#include "hsr/painter/sort/z_sort.h"
#include "hsr/painter/verify/verify.h"
#include "tests/scenes/random_scenes.h"

namespace hsr {

using namespace internal;

namespace {

/// Two squares one above the other, and wires: one through both, one between them, one on the lower, one above all.
scenes::TestScene two_squares() {
  scenes::TestScene scene;
  scene.view = scenes::from_direction({0, 0, 1});
  scene.add_face(std::vector<Point3>{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}});
  scene.add_face(std::vector<Point3>{{1, 1, 2}, {5, 1, 2}, {5, 3, 2}, {1, 3, 2}});
  scene.points.insert(scene.points.end(),
                      {{-1, 2, -1}, {6, 2, 3}, {-1, 2.5, 1}, {6, 2.5, 1}, {0.5, 0.5, 0}, {3.5, 3.5, 0}, {2, -1, 5}, {2, 5, 5}});
  scene.polygons.segments = {{8, 9}, {10, 11}, {12, 13}, {14, 15}};
  return scene;
}

/// Any faces, with a wire between any two of their points and beyond.
scenes::TestScene with_wires(scenes::TestScene scene, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const std::size_t n = scene.points.size();
  if (n == 0) return scene;
  for (int k = 0; k < 6; ++k) {
    const auto a = static_cast<std::uint32_t>(random() % n), b = static_cast<std::uint32_t>(random() % n);
    if (k % 2 == 0) {
      scene.polygons.segments.push_back({a, b});
      continue;
    }
    const Point3 p = scene.points[a], q = scene.points[b];
    const Point3 beyond = {2 * q.x - p.x, 2 * q.y - p.y, 1.5 * q.z - 0.5 * p.z};
    if (!std::isfinite(beyond.x) || !std::isfinite(beyond.y) || !std::isfinite(beyond.z)) continue;
    scene.points.push_back(beyond);
    scene.polygons.segments.push_back({a, static_cast<std::uint32_t>(scene.points.size() - 1)});
  }
  return scene;
}

std::uint64_t count_of_wires(const Mesh& mesh) {
  return static_cast<std::uint64_t>(std::count_if(mesh.edges.begin(), mesh.edges.end(), [](const Edge& e) { return e.wire; }));
}

/// What is wrong with the wires of an order; nothing: nothing.
std::string wrong_wires(const SceneView& scene, const PaintersOrder& order) {
  std::string wrong;
  const Verdict verdict = verify(painted_polygons(scene, order), scene.view());
  if (verdict.wrong > 0) wrong += std::to_string(verdict.wrong) + " pairs are wrong\n";
  std::vector<OrderedWire> wires = order.wires;
  std::stable_sort(wires.begin(), wires.end(), [](const auto& a, const auto& b) { return a.edge < b.edge; });
  std::sort(wires.begin(), wires.end(),
            [](const auto& a, const auto& b) { return a.edge != b.edge ? a.edge < b.edge : a.from < b.from; });
  for (std::size_t k = 0; k < wires.size(); ++k) {
    const bool is_first = k == 0 || wires[k - 1].edge != wires[k].edge;
    if (!(wires[k].from < wires[k].to)) wrong += "a part has no length\n";
    if (!is_first && wires[k].from != wires[k - 1].to) wrong += "parts leave a gap\n";
    if (!scene.view().is_perspective() && is_first && wires[k].from.sign() != Sign::zero) wrong += "a wire begins later\n";
    if (is_first) continue;
    // No place in the order for both.
    PaintersOrder together = order;
    std::erase_if(together.wires, [&](const OrderedWire& w) { return w.edge == wires[k].edge; });
    for (std::uint32_t before = 0; before <= order.pieces.size(); ++before) {
      PaintersOrder tried = together;
      tried.wires = {{wires[k].edge, wires[k - 1].from, wires[k].to, before}};
      if (verify(painted_polygons(scene, tried), scene.view()).wrong == 0) wrong += "a cut is needless\n";
    }
  }
  return wrong;
}

PaintedPolygon polygon(std::initializer_list<Point3> corners) {
  PaintedPolygon p;
  for (const Point3& c : corners) p.corners.push_back(rational(c));
  return p;
}

const View from_above = scenes::from_direction({0, 0, 1});
const PaintedPolygon square = polygon({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}});

bool is_right(const std::vector<PaintedPolygon>& far_to_near, const View& view = from_above) {
  return verify(far_to_near, view).is_correct();
}

}  // namespace

TEST_CASE("wires come between what they are in front of and what they are behind, cut where a face passes between",
          "[painter][wires][P20]") {
  const scenes::TestScene scene = two_squares();
  const Mesh mesh = scene.mesh();
  const SceneView view(mesh, scene.view);
  for (const PaintersOrder& order : {depth_sort(view).order, BspTree(mesh).order(view)}) {
    REQUIRE(order.pieces.size() == 2);
    struct Expected {
      std::uint32_t a;
      Rational from, to;
      std::uint32_t before;
    };
    // The first wire meets the lower square at x = 0.75, and the upper one at 4.25.
    const Rational low = Rational::from_string("1/4"), high = Rational::from_string("3/4");
    const Expected expected[] = {{8, 0.0, low, 0},  {8, low, high, 1}, {10, 0.0, 1.0, 1},
                                 {12, 0.0, 1.0, 1}, {8, high, 1.0, 2}, {14, 0.0, 1.0, 2}};
    REQUIRE(order.wires.size() == std::size(expected));
    for (std::size_t k = 0; k < std::size(expected); ++k) {
      CHECK(mesh.edges[order.wires[k].edge].a == VertexId(expected[k].a));
      CHECK(order.wires[k].from == expected[k].from);
      CHECK(order.wires[k].to == expected[k].to);
      CHECK(order.wires[k].before == expected[k].before);
    }
    CHECK(wrong_wires(view, order).empty());
  }
}

TEST_CASE("wires among random faces are in an order that is right, with no cut too many", "[painter][wires][property][P20]") {
  std::size_t parts = 0;
  for (const scenes::Family& family : scenes::families())
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      const scenes::TestScene scene = with_wires(family.make(seed), seed);
      const Mesh mesh = scene.mesh();
      const SceneView view(mesh, scene.view);
      CAPTURE(family.name, seed);
      for (const PaintersOrder& order : {depth_sort(view).order, BspTree(mesh).order(view)}) {
        CHECK(wrong_wires(view, order) == "");
        parts += order.wires.size();
      }
    }
  CHECK(parts > 1000);
}

TEST_CASE("wires in orders by one depth each are whole", "[painter][wires][P12][P20]") {
  const scenes::TestScene scene = two_squares();
  const Mesh mesh = scene.mesh();
  const PaintersOrder order = z_sort(SceneView(mesh, scene.view), DepthKey::centroid);
  REQUIRE(order.wires.size() == count_of_wires(mesh));
  CHECK(
      std::is_sorted(order.wires.begin(), order.wires.end(), [](const auto& a, const auto& b) { return a.before < b.before; }));
  for (const OrderedWire& wire : order.wires) {
    CHECK(wire.from == Rational(0.0));
    CHECK(wire.to == Rational(1.0));
  }
  CHECK(order.wires.back().before == 2);
}

TEST_CASE("a wire seen as a point has no part in an order", "[painter][wires][P20]") {
  scenes::TestScene scene = two_squares();
  scene.points.push_back({2, 2, -1});
  scene.points.push_back({2, 2, 7});
  scene.polygons.segments = {{16, 17}, {8, 9}};
  CHECK(depth_sort(scene.mesh(), scene.view).order.wires.size() == 3);
  scene.view = scenes::from_eye({2, 2, 9}, {2, 2, 0});
  CHECK(depth_sort(scene.mesh(), scene.view).order.wires.size() == 3);
  scene.view = scenes::from_eye({2, 2.5, 9}, {2, 2, 0});
  CHECK(depth_sort(scene.mesh(), scene.view).order.wires.size() == 6);
}

TEST_CASE("a wire comes as late as it may, and ends at the near plane", "[painter][wires][P20]") {
  scenes::TestScene scene = two_squares();
  scene.points.insert(scene.points.end(), {{9, 9, -5}, {9, 8, -5}, {7, 7, 0}, {7, 7, 8}});
  scene.polygons.segments = {{16, 17}};
  const PaintersOrder apart = depth_sort(scene.mesh(), scene.view).order;  // beside all faces
  REQUIRE(apart.wires.size() == 1);
  CHECK(apart.wires[0].before == 2);
  scene.polygons.segments = {{18, 19}};
  scene.view = scenes::from_eye({2, 2, 10}, {2, 2, 0}, 0.5);  // the near plane is z = 5
  const PaintersOrder cut = depth_sort(scene.mesh(), scene.view).order;
  REQUIRE(cut.wires.size() == 1);
  CHECK(cut.wires[0].from == Rational(0.0));
  CHECK(cut.wires[0].to == Rational::from_string("5/8"));
}

TEST_CASE("a scene of wires alone has an order", "[painter][wires][P20]") {
  scenes::TestScene scene = two_squares();
  scene.polygons.first = {0};
  scene.polygons.corners.clear();
  const Mesh mesh = scene.mesh();
  CHECK(depth_sort(mesh, scene.view).order.wires.size() == 4);
  CHECK(BspTree(mesh).order(scene.view).wires.size() == 4);
}

TEST_CASE("a wire is judged where its image runs inside that of a polygon", "[painter][verify][wires][P21]") {
  const PaintedPolygon above = polygon({{1, 1, 1}, {3, 2, 1}}), below = polygon({{-1, 1, -1}, {5, 2, -1}}),
                       on = polygon({{1, 1, 0}, {9, 1, 0}});
  CHECK(is_right({square, above}));
  CHECK_FALSE(is_right({above, square}));
  CHECK(is_right({below, square}));
  CHECK_FALSE(is_right({square, below}));
  CHECK(is_right({square, on}));
  CHECK_FALSE(is_right({on, square}));
  const Verdict wrong = verify({square, above, below}, from_above);
  CHECK(wrong.wires == 2);
  CHECK(wrong.polygons == 1);
  CHECK(wrong.wrong == 1);
  CHECK(wrong.overlapping == 2);
  CHECK(wrong.order_exists);
  REQUIRE(wrong.first.size() == 1);
  CHECK(wrong.first[0].earlier == 0);
  CHECK(wrong.first[0].later == 2);
  // In the middle of where it is: x from 0 to 4.
  CHECK(wrong.first[0].witness.of_earlier == RationalVector{2.0, 1.5, 0.0});
  CHECK(wrong.first[0].witness.of_later == RationalVector{2.0, 1.5, -1.0});
}

TEST_CASE("a wire beside a polygon, along its side, at its corner, seen as a point, or at another wire is never wrong",
          "[painter][verify][wires][P21]") {
  for (const auto& [a, b] : {std::pair{Point3{5, 0, 9}, Point3{5, 4, 9}},
                             {Point3{4, 0, 9}, Point3{4, 4, 9}},     // along a side
                             {Point3{3, 5, 9}, Point3{5, 3, 9}},     // at a corner
                             {Point3{4, 2, 9}, Point3{9, 2, 9}},     // from a side on
                             {Point3{2, 2, 9}, Point3{2, 2, 5}}}) {  // a point
    CHECK(is_right({polygon({a, b}), square}));
    CHECK(is_right({square, polygon({a, b})}));
  }
  const PaintedPolygon over = polygon({{0, 0, 5}, {4, 4, 5}}), under = polygon({{4, 0, 1}, {0, 4, 1}});
  CHECK(is_right({over, under}));
  CHECK(is_right({under, over}));
  // Through a corner into the square.
  CHECK_FALSE(is_right({polygon({{-1, -1, 9}, {2, 2, 9}}), square}));
}

TEST_CASE("a wire through a polygon has no order whole, and one as its parts", "[painter][verify][wires][P21]") {
  const Verdict whole = verify({square, polygon({{1, 1, -1}, {3, 3, 1}})}, from_above);
  CHECK(whole.piercing == 1);
  CHECK_FALSE(whole.order_exists);
  CHECK(whole.cycle.size() == 2);
  CHECK(is_right({polygon({{1, 1, -1}, {2, 2, 0}}), square, polygon({{2, 2, 0}, {3, 3, 1}})}));
  // An ulp off and it is not cut where it should be.
  const double x = std::nextafter(2.0, 3.0);
  CHECK_FALSE(is_right({polygon({{1, 1, -1}, {x, x, x - 2}}), square, polygon({{x, x, x - 2}, {3, 3, 1}})}));
  // Where it passes through the plane beside the square nothing is wrong.
  CHECK(is_right({polygon({{3, 3, -1}, {7, 7, 1}}), square}));
}

TEST_CASE("of a wire what the near plane cuts off is not there", "[painter][verify][wires][P21]") {
  const View view = scenes::from_eye({2, 2, 10}, {2, 2, 0}, 0.5);  // the near plane is z = 5
  CHECK(is_right({polygon({{1, 1, 6}, {3, 3, 9}}), square}, view));
  CHECK_FALSE(is_right({polygon({{1, 1, 4}, {3, 3, 9}}), square}, view));
  CHECK(is_right({square, polygon({{1, 1, 4}, {3, 3, 9}})}, view));
  CHECK_FALSE(is_right({square, polygon({{-9, 1, -9}, {9, 3, -1}})}, view));
  CHECK(is_right({polygon({{-9, 1, -9}, {9, 3, -1}}), square}, view));
  // Before the square only where it is not there.
  CHECK(is_right({polygon({{6, 2, 4}, {2, 2, 9}}), square}, view));
  CHECK(is_right({square, polygon({{6, 2, 4}, {2, 2, 9}})}, view));
}

}  // namespace hsr
