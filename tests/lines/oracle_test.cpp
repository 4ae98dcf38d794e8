#include <catch2/catch.hpp>

#include "tests/lines/checked_lines.h"
#include "tests/oracle/seen_edges.h"
#include "tests/oracle/visible_lines_oracle.h"
#include "tests/scenes/random_scenes.h"

// The oracle itself, without roberts: examples by hand, and that the comparison reports wrong answers.

namespace hsr {
namespace {

using oracle::Interval;
using oracle::Q;
using oracle::SeenEdge;
using oracle::Vec;

// A square at z = 1, seen from above, and wires below it.
scenes::TestScene square_over(std::initializer_list<std::array<Point3, 2>> wires) {
  scenes::TestScene scene;
  scene.add_face({{0, 0, 1}, {4, 0, 1}, {4, 4, 1}, {0, 4, 1}});
  for (const auto& [a, b] : wires) {
    const auto n = static_cast<std::uint32_t>(scene.points.size());
    scene.points.push_back(a);
    scene.points.push_back(b);
    scene.polygons.segments.push_back({n, n + 1});
  }
  scene.view = scenes::from_direction({0, 0, 1});
  return scene;
}

std::string wire(const scenes::TestScene& scene, std::uint32_t a) {
  for (const SeenEdge& e : oracle::seen_by_oracle(SceneView(Scene(scene.mesh()), scene.view), all_edges()))
    if (e.a == VertexId(a) && e.b == VertexId(a + 1)) return oracle::intervals_text(e);
  return "absent";
}

TEST_CASE("the oracle hides what is strictly behind a closed face", "[lines][oracle][self]") {
  const auto scene = square_over({{{{-2, 2, 0}, {6, 2, 0}}},    // below
                                  {{{-2, 2, 2}, {6, 2, 2}}},    // above
                                  {{{-2, 2, 1}, {6, 2, 1}}},    // in the face's plane
                                  {{{-2, 0, 0}, {6, 0, 0}}},    // below its border
                                  {{{-2, -2, 0}, {2, 2, 0}}},   // to below its middle
                                  {{{-1, 1, 0}, {1, -1, 0}}},   // touches below a corner only
                                  {{{2, 1, 0}, {2, 1, -5}}},    // a point
                                  {{{2, 2, 3}, {2, 3, -1}}}});  // pierces
  CHECK(wire(scene, 4) == "0 visible 1/4 hidden 3/4 visible 1");
  CHECK(wire(scene, 6) == "0 visible 1");
  CHECK(wire(scene, 8) == "0 visible 1");
  CHECK(wire(scene, 10) == "0 visible 1/4 hidden 3/4 visible 1");
  CHECK(wire(scene, 12) == "0 visible 1/2 hidden 1");
  CHECK(wire(scene, 14) == "0 visible 1");
  CHECK(wire(scene, 16) == "nothing");
  CHECK(wire(scene, 18) == "0 visible 1/2 hidden 1");
}

TEST_CASE("the oracle answers the definition for single points", "[lines][oracle][self][H1]") {
  auto scene = square_over({});
  const Mesh mesh = scene.mesh();
  const auto hidden = [&](const Point3& p) {
    const oracle::VisibleLinesOracle oracle(mesh, scene.view);
    bool any = false;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) any |= oracle.hides(TriangleId(t), Vec(p));
    return any;
  };
  CHECK(hidden({2, 2, 0}));
  CHECK(hidden({0, 0, 0}));        // behind a corner
  CHECK(hidden({4, 1, 0}));        // behind a border
  CHECK(hidden({1, 1, 0}));        // behind the diagonal: no crack
  CHECK_FALSE(hidden({2, 2, 1}));  // on it
  CHECK_FALSE(hidden({2, 2, 2}));
  CHECK_FALSE(hidden({4.0000001, 1, 0}));

  scene.view = scenes::from_direction({1, 0, 0});  // edge-on
  CHECK(hidden({0, 0, 1}));
  CHECK(hidden({-7, 2, 1}));
  CHECK(hidden({3.5, 4, 1}));
  CHECK_FALSE(hidden({4, 2, 1}));
  CHECK_FALSE(hidden({2, 5, 1}));
  CHECK_FALSE(hidden({2, 2, 0}));

  scene.view = scenes::from_eye({2, 2, 5}, {2, 2, 1}, 0.5);  // near plane z = 3
  CHECK(hidden({2, 2, 0}));
  CHECK(hidden({-0.5, 2, 0}));  // exactly behind the border
  CHECK_FALSE(hidden({-0.6, 2, 0}));
  scene.view = scenes::from_eye({2, 2, 5}, {2, 2, 1}, 1);  // the near plane is the face's plane, and closed
  CHECK(hidden({2, 2, 0}));
  scene.view = scenes::from_eye({2, 2, 5}, {2, 2, 1}, 1.125);  // cut away
  CHECK_FALSE(hidden({2, 2, 0}));
}

TEST_CASE("the oracle gives nothing for edges seen as points or before the near plane", "[lines][oracle][self]") {
  auto scene = square_over({{{{2, 2, 0}, {2, 2, -5}}}, {{{0, 0, 8}, {4, 0, 8}}}, {{{2, 0, 5}, {2, 0, 1}}}});
  scene.view = scenes::from_eye({2, 2, 5}, {2, 2, 1}, 0.5);
  CHECK(wire(scene, 4) == "nothing");
  CHECK(wire(scene, 6) == "nothing");
  CHECK(wire(scene, 8) == "1/2 visible 1");
}

TEST_CASE("the comparison accepts the right answer and reports each wrong one", "[lines][oracle][self]") {
  int mutations = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const scenes::TestScene scene = scenes::family(seed % 2 == 0 ? "triangles" : "edge_on").make(seed);
    const auto right = oracle::seen_by_oracle(SceneView(Scene(scene.mesh()), scene.view), all_edges());
    CHECK(oracle::differences(right, right).empty());

    for (std::size_t i = 0; i < right.size(); ++i) {
      const auto reports = [&](const char* what, auto&& mutate) {
        auto wrong = right;
        mutate(wrong, wrong[i]);
        ++mutations;
        INFO(what << " of " << oracle::to_text(right[i]));
        CHECK_FALSE(oracle::differences(right, wrong).empty());
      };
      reports("missing edge", [&](auto& all, auto&) { all.erase(all.begin() + static_cast<std::ptrdiff_t>(i)); });
      reports("edge twice", [&](auto& all, auto&) { all.insert(all.begin() + static_cast<std::ptrdiff_t>(i), right[i]); });
      reports("other class", [](auto&, SeenEdge& e) {
        e.edge_class = e.edge_class == EdgeClass::boundary ? EdgeClass::outline : EdgeClass::boundary;
      });
      if (right[i].cuts.empty()) {
        reports("something of nothing", [](auto&, SeenEdge& e) { e.cuts = {0, 1}; });
        continue;
      }
      reports("nothing", [](auto&, SeenEdge& e) { e.cuts.clear(); });
      reports("hidden for visible", [](auto&, SeenEdge& e) { e.starts_hidden = !e.starts_hidden; });
      for (std::size_t k = 0; k < right[i].cuts.size(); ++k) {
        reports("an end shifted by 2^-1074", [&](auto&, SeenEdge& e) { e.cuts[k] += Q(5e-324); });
        reports("a cut left out", [&](auto&, SeenEdge& e) { e.cuts.erase(e.cuts.begin() + static_cast<std::ptrdiff_t>(k)); });
        if (k + 1 < right[i].cuts.size())
          reports("an interval of length 0",
                  [&](auto&, SeenEdge& e) { e.cuts.insert(e.cuts.begin() + static_cast<std::ptrdiff_t>(k), 2, e.cuts[k]); });
      }
      if (right[i].cuts.size() >= 4) {
        reports("an interval dropped", [](auto&, SeenEdge& e) { e.cuts.erase(e.cuts.begin() + 1, e.cuts.begin() + 3); });
      }
    }
  }
  CHECK(mutations > 3000);
}

TEST_CASE("hidden intervals of the oracle lie within its shadows, and grow with each face", "[lines][oracle][self]") {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const scenes::TestScene scene = scenes::family("triangles").make(seed);
    const Mesh mesh = scene.mesh();
    const oracle::VisibleLinesOracle oracle(mesh, scene.view);
    for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
      const auto v = oracle.visibility(EdgeId(i));
      Q total = 0;
      for (const auto* parts : {&v.hidden, &v.visible})
        for (const Interval& part : *parts) {
          CHECK(part.from < part.to);
          total += part.to - part.from;
        }
      if (v.is_seen) CHECK(total == v.beyond.to - v.beyond.from);
      for (const auto& s : v.shadows)
        CHECK(std::any_of(v.hidden.begin(), v.hidden.end(),
                          [&](const Interval& h) { return h.from <= s.interval.from && s.interval.to <= h.to; }));
    }
  }
}

TEST_CASE("a scene written as text reads back as the same scene", "[scenes]") {
  for (const scenes::Family& family : scenes::families()) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
      const scenes::TestScene scene = family.make(seed);
      const scenes::TestScene again = scenes::scene_from_text(scenes::to_text(scene));
      CHECK(again.points == scene.points);
      CHECK(again.polygons.corners == scene.polygons.corners);
      CHECK(again.polygons.first == scene.polygons.first);
      CHECK(again.polygons.segments == scene.polygons.segments);
      CHECK(again.view.viewpoint == scene.view.viewpoint);
      if (scene.view.is_perspective()) CHECK((again.view.target == scene.view.target && again.view.near == scene.view.near));
    }
  }
}

TEST_CASE("shrinking keeps only what the failure needs", "[scenes]") {
  scenes::TestScene scene = scenes::family("triangles").make(12);
  scene.add_face({{9, 9, 9}, {9, 8, 9}, {8, 9, 9}, {7, 7, 9}});
  const auto has_nine = [](const scenes::TestScene& s) {
    for (const std::uint32_t c : s.polygons.corners)
      if (s.points[c].x == 9) return true;
    return false;
  };
  const scenes::TestScene small = scenes::shrunk(scene, has_nine);
  CHECK(small.polygons.size() == 1);
  CHECK(small.points.size() == 3);
  CHECK(small.polygons.segments.empty());
  CHECK(has_nine(small));
}

}  // namespace
}  // namespace hsr
