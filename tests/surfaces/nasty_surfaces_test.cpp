#include <tbb/global_control.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>
#include <random>

#include "hsr/check/sample_checks.h"
#include "hsr/surfaces/fragment_invariants.h"
#include "hsr/surfaces/roberts_surfaces.h"
#include "hsr/surfaces/visible_fragments.h"
#include "tests/surfaces/checked_surfaces.h"

namespace hsr {

using namespace internal;

namespace {

scenes::TestScene from_above() {
  scenes::TestScene scene;
  scene.view = parallel_view({0, 0, 1}, {0, 1, 0});
  return scene;
}

scenes::TestScene cycle() {
  scenes::TestScene scene = from_above();
  scene.add_face({{-8, -3, 0}, {8, -3, 16}, {8, -4, 16}});
  scene.add_face({{6, -7, 0}, {-2, 9, 16}, {-1, 9, 16}});
  scene.add_face({{2, 9, 0}, {-6, -7, 16}, {-7, -7, 16}});
  return scene;
}

TEST_CASE("three triangles over one another in a cycle show all but the overlaps", "[surfaces][nasty]") {
  const scenes::TestScene scene = cycle();
  CHECK(wrong_fragments(scene).empty());
  const Mesh mesh = scene.mesh();
  Rational sum;
  for (const Rational& a : visible_areas(mesh, scene.view, visible_fragments(mesh, scene.view))) sum = sum + a;
  const auto q = [](const char* text) { return Rational::from_string(text); };
  CHECK(sum == Rational(24.0) - q("2719/15438") - q("29/170") - q("2903/17490"));
}

TEST_CASE("two triangles with one image pierce each other in the middle", "[surfaces][nasty]") {
  scenes::TestScene scene = from_above();
  scene.add_face({{-2, -2, -2}, {2, -2, 2}, {0, 3, 0}});
  scene.add_face({{-2, -2, 2}, {2, -2, -2}, {0, 3, 0}});
  CHECK(wrong_fragments(scene).empty());
  CHECK(areas(scene) == "5 5");
}

TEST_CASE("what lies over the line in which two faces pierce each other counts on its own side", "[surfaces][nasty]") {
  using Face = std::vector<Point3>;
  const Face s = {{-2, -2, -2}, {2, -2, 2}, {0, 4, 0}}, t = {{-2, -3, 2}, {2, -3, -2}, {0, 3, 0}};
  const std::vector<std::vector<Face>> others = {
      {{{0, -1, 5}, {0, 1, 5}, {1, 0, 5}}},                                      // nearer, ends over the line, to its right
      {{{0, -1, 5}, {0, 1, 5}, {-1, 0, 5}}},                                     // to its left
      {{{0, -1, 5}, {0, 1, 5}, {1, 0, 5}}, {{0, 0, 6}, {0, 2, 6}, {-1, 0, 6}}},  // on both sides, apart
      {{{0, -1, -5}, {0, 1, -5}, {1, 0, -5}}},                                   // behind both
      {{{-1, -2, -3}, {1, -2, 3}, {0, 2.5, 0}}},                                 // through the line, steeper than both
      {{{0, -1, 0}, {0, 1, 0}, {1, 0, 3}}},                                      // ends at the line itself
      {{{0, -1, 0}, {0, 1, 0}, {-1, 0, 0}}},
      {{{-1, -1, -1}, {1, -1, 1}, {0, 1, 0}}},  // in the plane of one of them
      {s},
  };
  for (const std::vector<Face>& more : others) {
    std::vector<Face> faces = {s, t};
    faces.insert(faces.end(), more.begin(), more.end());
    std::vector<std::size_t> order(faces.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    do {
      scenes::TestScene scene = from_above();
      for (const std::size_t k : order) scene.add_face(faces[k]);
      CHECK(wrong_fragments(scene) == "");
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

TEST_CASE("of faces in one plane the lower index is seen", "[surfaces][nasty][S3]") {
  scenes::TestScene scene = from_above();
  scene.add_face({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
  scene.add_face({{1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}});  // the other way round
  scene.add_face({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
  CHECK(wrong_fragments(scene).empty());
  CHECK(areas(scene) == "4 3 -");
}

TEST_CASE("one subnormal nearer hides all", "[surfaces][nasty][E2]") {
  scenes::TestScene scene = from_above();
  scene.add_face({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  scene.add_face({{0, 0, 5e-324}, {1, 0, 5e-324}, {0, 1, 5e-324}});
  CHECK(wrong_fragments(scene).empty());
  CHECK(areas(scene) == "- 1/2");
}

TEST_CASE("a face seen edge-on has no fragment and cuts none", "[surfaces][nasty][S4]") {
  scenes::TestScene scene = from_above();
  scene.add_face({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}});
  scene.add_face({{1, 2, 1}, {3, 2, 1}, {2, 2, 5}});
  CHECK(wrong_fragments(scene).empty());
  CHECK(visible_fragments(scene.mesh(), scene.view).fragments.size() == 1);
  CHECK(areas(scene) == "16 -");
}

TEST_CASE("a window shows what is behind it, and the frame around it has a hole", "[surfaces][nasty][S1]") {
  scenes::TestScene scene = from_above();
  scene.add_face({{0, 0, 0}, {6, 0, 0}, {6, 6, 0}, {0, 6, 0}});
  scene.add_face({{2, 2, 1}, {4, 2, 1}, {4, 4, 1}, {2, 4, 1}});
  CHECK(wrong_fragments(scene).empty());
  const Mesh mesh = scene.mesh();
  const VisibleFragments found = visible_fragments(mesh, scene.view);
  REQUIRE(found.fragments.size() == 2);
  CHECK(found.fragments[0].end_ring - found.fragments[0].first_ring == 2);
  CHECK(areas(scene) == "32 4");
}

TEST_CASE("holes that touch the border and one another leave the parts that are connected", "[surfaces][nasty][S1][S2]") {
  scenes::TestScene scene = from_above();
  scene.add_face({{0, 0, 0}, {8, 0, 0}, {8, 4, 0}, {0, 4, 0}});
  // Two diamonds that touch each other, and the upper and the lower side.
  scene.add_face({{2, 2, 1}, {4, 0, 1}, {6, 2, 1}, {4, 4, 1}});
  CHECK(wrong_fragments(scene).empty());
  CHECK(visible_fragments(scene.mesh(), scene.view).fragments.size() == 3);
  scene.add_face({{6, 2, 1}, {7, 1, 1}, {8, 2, 1}, {7, 3, 1}});
  CHECK(wrong_fragments(scene).empty());
  CHECK(visible_fragments(scene.mesh(), scene.view).fragments.size() == 5);
}

TEST_CASE("strips over strips show each piece of the lower ones", "[surfaces][nasty]") {
  constexpr int m = 7;
  scenes::TestScene scene = from_above();
  for (int k = 0; k < m; ++k) {
    const double a = 2 * k, b = 2 * k + 1, end = 2 * m;
    scene.add_face({{a, -1, 1}, {b, -1, 1}, {b, end, 1}, {a, end, 1}});
    scene.add_face({{-1, a, 0}, {end, a, 0}, {end, b, 0}, {-1, b, 0}});
  }
  const Mesh mesh = scene.mesh();
  const VisibleFragments found = visible_fragments(mesh, scene.view);
  CHECK(found.fragments.size() == m + m * (m + 1));
  CHECK(canonical(mesh, scene.view, found) == canonical(mesh, scene.view, roberts_surfaces(mesh, scene.view)));
}

TEST_CASE("a face is cut by the near plane before it hides", "[surfaces][nasty][V8][S6]") {
  scenes::TestScene scene;
  scene.view = scenes::from_eye({0, 0, 10}, {0, 0, 0}, 0.5);
  scene.add_face({{-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0}});
  scene.add_face({{-1, -1, 8}, {1, -1, 8}, {0, 1, 2}});
  CHECK(wrong_fragments(scene).empty());
  CHECK(visible_fragments(scene.mesh(), scene.view).fragments.size() == 2);
}

/// Squares of side 1 at depths z, in an order of no meaning.
scenes::TestScene stack(const std::vector<double>& depths) {
  scenes::TestScene scene = from_above();
  std::vector<double> z = depths;
  std::shuffle(z.begin(), z.end(), std::mt19937(7));
  for (const double d : z) scene.add_face({{0, 0, d}, {1, 0, d}, {1, 1, d}, {0, 1, d}});
  return scene;
}

TEST_CASE("of fifty squares however near to one another the nearest is seen", "[surfaces][stiff]") {
  std::vector<double> tiny, least, ulp;
  double next = 1;
  for (int k = 0; k < 50; ++k) {
    tiny.push_back(1 + k * 1e-12);
    least.push_back(k * 1e-300);
    ulp.push_back(next);
    next = std::nextafter(next, 2);
  }
  for (const auto& depths : {tiny, least, ulp}) {
    const scenes::TestScene scene = stack(depths);
    const Mesh mesh = scene.mesh();
    const VisibleFragments found = visible_fragments(mesh, scene.view);
    REQUIRE(found.fragments.size() == 1);
    CHECK(mesh.points[mesh.triangles[first_triangle(found.fragments[0].facet)][0]].z ==
          *std::max_element(depths.begin(), depths.end()));
    CHECK(canonical(mesh, scene.view, found) == canonical(mesh, scene.view, roberts_surfaces(mesh, scene.view)));
    CHECK(check_fragments(mesh, scene.view, found, sample_grid(scene.view, paper_rectangle(mesh, scene.view), 64, 64))
              .is_right());
  }
}

TEST_CASE("triangles that cross at any slope cover the image once", "[surfaces][stiff]") {
  std::mt19937 random(11);
  const auto number = [&] { return static_cast<double>(random()) / 4294967296.0; };
  for (const double slope : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15}) {
    scenes::TestScene scene = from_above();
    for (int k = 0; k < 12; ++k) {
      const auto corner = [&](double x, double y) { return Point3{x + number() / 8, y + number() / 8, 1 + slope * number()}; };
      scene.add_face({corner(0, 0), corner(2, 0), corner(1, 2)});
    }
    const Mesh mesh = scene.mesh();
    const VisibleFragments found = visible_fragments(mesh, scene.view);
    CHECK(canonical(mesh, scene.view, found) == canonical(mesh, scene.view, roberts_surfaces(mesh, scene.view)));
    CHECK(check_fragments(mesh, scene.view, found, sample_grid(scene.view, paper_rectangle(mesh, scene.view), 96, 96))
              .is_right());
  }
}

TEST_CASE("the fragments are the same for any number of threads", "[surfaces]") {
  std::mt19937 random(5);
  const auto number = [&] { return static_cast<double>(random() % 64); };
  scenes::TestScene scene;
  scene.view = scenes::from_direction({1, 2, 3});
  for (int k = 0; k < 600; ++k) {
    const Point3 o = {number(), number(), number()};
    const auto corner = [&] { return Point3{o.x + number() / 8, o.y + number() / 8, o.z + number() / 8}; };
    scene.add_face({corner(), corner(), corner()});
  }
  const Mesh mesh = scene.mesh();
  const auto found = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return visible_fragments(mesh, scene.view);
  };
  const VisibleFragments one = found(1), two = found(2);
  CHECK(canonical(mesh, scene.view, one) == canonical(mesh, scene.view, two));
  CHECK(one.decisions == two.decisions);
  CHECK(canonical(mesh, scene.view, one) == canonical(mesh, scene.view, roberts_surfaces(mesh, scene.view)));
}

TEST_CASE("the check finds fragments that are wrong", "[surfaces][check]") {
  scenes::TestScene scene = from_above();
  scene.add_face({{0, 0, 0}, {6, 0, 0}, {6, 6, 0}, {0, 6, 0}});
  scene.add_face({{2, 2, 1}, {4, 2, 1}, {4, 4, 1}, {2, 4, 1}});
  const Mesh mesh = scene.mesh();
  const SampleGrid grid = sample_grid(scene.view, paper_rectangle(mesh, scene.view), 60, 60);
  const VisibleFragments right = visible_fragments(mesh, scene.view);
  const auto check = [&](const VisibleFragments& f) { return check_fragments(mesh, scene.view, f, grid); };
  REQUIRE(check(right).is_right());
  CHECK(check(right).covered == 3600);

  SECTION("a hole is dropped") {
    VisibleFragments wrong = right;
    wrong.fragments[0].end_ring = wrong.fragments[0].first_ring + 1;
    CHECK(check(wrong).overlapping == 400);
  }
  SECTION("faces are swapped") {
    VisibleFragments wrong = right;
    std::swap(wrong.fragments[0].facet, wrong.fragments[1].facet);
    CHECK(check(wrong).wrong == 3600);
  }
  SECTION("a fragment is missing") {
    VisibleFragments wrong = right;
    wrong.fragments.pop_back();
    CHECK(check(wrong).wrong == 400);
    REQUIRE(check(wrong).first_wrong.size() == 10);
    CHECK_FALSE(check(wrong).first_wrong[0].painted.is_valid());
    CHECK(check(wrong).first_wrong[0].cast == FaceId(1));
  }
  SECTION("a corner is somewhere else") {
    VisibleFragments wrong = right;
    // The square inside, with a corner moved to the middle of the outer one's.
    MapCorner& corner = wrong.rings[wrong.fragments[1].first_ring][0];
    MapCorner& before = wrong.rings[wrong.fragments[1].first_ring][3];
    const VertexId old = corner.at.vertex, outer = VertexId(0);
    corner.at = MapPoint::of_vertex(outer);
    const auto line_to = [&](MapCorner& c, VertexId from, VertexId to) {
      c.line = MapLine::edge(from, to);
      c.reversed = to < from;
    };
    line_to(corner, outer, wrong.rings[wrong.fragments[1].first_ring][1].at.vertex);
    line_to(before, before.at.vertex, outer);
    CHECK(old != outer);
    CHECK_FALSE(check(wrong).is_right());
  }
}

TEST_CASE("the invariants find fragments that are wrong", "[surfaces][check]") {
  scenes::TestScene scene = from_above();
  scene.add_face({{0, 0, 0}, {6, 0, 0}, {6, 6, 0}, {0, 6, 0}});
  scene.add_face({{2, 2, 1}, {4, 2, 1}, {4, 4, 1}, {2, 4, 1}});
  const Mesh mesh = scene.mesh();
  const ProjectedMesh projected(mesh, scene.view, Arithmetic::staged);
  const VisibleFragments right = visible_fragments(mesh, scene.view);
  CHECK_NOTHROW(check_invariants(projected, right));
  VisibleFragments wrong = right;
  SECTION("a fragment is there twice") {
    wrong.fragments.push_back(wrong.fragments.back());
    CHECK_THROWS_WITH(check_invariants(projected, wrong), Catch::Contains("run along one another"));
  }
  SECTION("a hole is a fragment of its own") {
    wrong.fragments.push_back({FacetId(0), wrong.fragments[0].first_ring + 1, wrong.fragments[0].end_ring});
    wrong.fragments[0].end_ring = wrong.fragments[0].first_ring + 1;
    CHECK_THROWS_WITH(check_invariants(projected, wrong), Catch::Contains("turns the wrong way"));
  }
  SECTION("a hole belongs to another fragment") {
    wrong.fragments[0].end_ring = wrong.fragments[0].first_ring + 1;
    // The square inside, with the outer one as what surrounds it: of the rings of fragment 0 the second is the hole.
    const std::uint32_t hole = right.fragments[0].first_ring + 1;
    std::vector<MapCorner> outer(right.rings[0].begin(), right.rings[0].end());
    CHECK(right.rings[hole].size() == 4);
    std::reverse(outer.begin(), outer.end());
    std::copy(outer.begin(), outer.end(), wrong.rings[wrong.fragments[1].first_ring].begin());
    CHECK_THROWS_AS(check_invariants(projected, wrong), InvariantError);
  }
  SECTION("a corner is somewhere else") {
    MapCorner& corner = wrong.rings[wrong.fragments[1].first_ring][0];
    const MapCorner& next = wrong.rings[wrong.fragments[1].first_ring][1];
    MapCorner& before = wrong.rings[wrong.fragments[1].first_ring][3];
    corner.at = MapPoint::of_vertex(VertexId(0));
    corner.line = MapLine::edge(VertexId(0), next.at.vertex);
    corner.reversed = false;
    before.line = MapLine::edge(VertexId(0), before.at.vertex);
    before.reversed = true;
    CHECK_THROWS_AS(check_invariants(projected, wrong), InvariantError);
  }
  SECTION("a fragment is missing") {
    wrong.fragments.pop_back();
    CHECK_THROWS_WITH(check_invariants(projected, wrong), Catch::Contains("do not cover"));
  }
}

}  // namespace
}  // namespace hsr
