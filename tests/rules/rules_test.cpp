#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "hsr/check/sample_checks.h"
#include "hsr/painter/bsp/bsp.h"
#include "hsr/painter/sort/depth_sort.h"
#include "hsr/surfaces/visible_fragments.h"
#include "tests/lines/checked_lines.h"
#include "tests/oracle/painting_oracle.h"
#include "tests/scenes/random_scenes.h"
#include "tests/surfaces/checked_surfaces.h"

// Rules of docs/conventions.md that no other test shows: one test each, small enough to work out by hand. Where lines are asked
// for, roberts, appel and the oracle must agree on the whole scene.

namespace hsr {
namespace {

using scenes::TestScene;

const Point3 top = {0, 0, 1};

TestScene from_above() {
  TestScene scene;
  scene.view = parallel_view(top, {0, 1, 0});
  return scene;
}

void add_wire(TestScene& scene, const Point3& a, const Point3& b) {
  const auto n = static_cast<std::uint32_t>(scene.points.size());
  scene.points.push_back(a);
  scene.points.push_back(b);
  scene.polygons.segments.push_back({n, n + 1});
}

CheckedLines checked(const TestScene& scene, const LineOptions& options = all_edges()) {
  CheckedLines lines(scene, options);
  INFO(scenes::to_text(scene));
  CHECK(lines.differences() == "");
  return lines;
}

bool equal(const Point3& a, const Point3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

TEST_CASE("the named views look from where the table says, y up turned and the model not", "[rules][V2][V3]") {
  struct Named {
    const char* name;
    Point3 toward_viewer, up;
  };
  const std::array<Named, 7> table = {{{"front", {0, -1, 0}, {0, 0, 1}},
                                       {"back", {0, 1, 0}, {0, 0, 1}},
                                       {"left", {-1, 0, 0}, {0, 0, 1}},
                                       {"right", {1, 0, 0}, {0, 0, 1}},
                                       {"top", {0, 0, 1}, {0, 1, 0}},
                                       {"bottom", {0, 0, -1}, {0, -1, 0}},
                                       {"iso", {1, -1, 1}, {0, 0, 1}}}};
  const auto turned = [](const Point3& p) { return Point3{p.x, p.z, -p.y}; };
  for (const Named& n : table) {
    INFO(n.name);
    const View z = named_view(n.name), y = named_view(n.name, {}, true);
    CHECK(z.viewpoint.is_direction);
    CHECK(equal(z.viewpoint.at, n.toward_viewer));
    CHECK(equal(z.up, n.up));
    CHECK(equal(y.viewpoint.at, turned(n.toward_viewer)));
    CHECK(equal(y.up, turned(n.up)));
  }
}

TEST_CASE("the near plane is a thousandth of the way to the target, if nothing else is asked for", "[rules][V7]") {
  CHECK(perspective_view({0, 0, 3}, {0, 0, 0}, {0, 1, 0}).near == 0.001);
  CHECK(perspective_view({0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 1).near == 0.25);
}

TEST_CASE("the frame decides nothing", "[rules][V6]") {
  for (const char* family : {"triangles", "edge_on", "around_the_eye"}) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      TestScene scene = scenes::family(family).make(seed);
      const Mesh mesh = scene.mesh();
      const auto lines = [&] {
        return oracle::to_text(oracle::seen_edges(mesh, scene.view, visible_lines(mesh, scene.view, all_edges())));
      };
      const std::string as_made = lines(), fragments = sorted_text(mesh, scene.view, visible_fragments(mesh, scene.view));
      const Frame f = scene.view.frame;
      const auto sum = [](const Point3& p, double a, const Point3& q, double b) {
        return Point3{a * p.x + b * q.x, a * p.y + b * q.y, a * p.z + b * q.z};
      };
      // Turned, not square, of another size, and around another point.
      scene.view.frame = {sum(f.origin, 1, f.right, 100), sum(f.right, 3, f.up, 1), sum(f.up, 0.25, f.right, -1)};
      CHECK(lines() == as_made);
      CHECK(sorted_text(mesh, scene.view, visible_fragments(mesh, scene.view)) == fragments);
    }
  }
}

TEST_CASE("which way round faces are given changes no line and no fragment", "[rules][F10][C1]") {
  for (const char* family : {"triangles", "edge_on", "boxes", "around_the_eye"}) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const TestScene scene = scenes::family(family).make(seed);
      TestScene turned = scene;
      turned.polygons.first = {0};
      turned.polygons.corners.clear();
      for (std::size_t f = 0; f < scene.polygons.size(); ++f) {
        std::vector<std::uint32_t> corners(scene.polygons[f].begin(), scene.polygons[f].end());
        if ((seed + f) % 3 != 0) std::reverse(corners.begin() + 1, corners.end());
        turned.add_face(corners);
      }
      const auto lines = [](const TestScene& s) {
        const Mesh mesh = s.mesh();
        std::vector<oracle::SeenEdge> all = oracle::seen_edges(mesh, s.view, visible_lines(mesh, s.view, all_edges()));
        std::erase_if(all, [](const oracle::SeenEdge& e) { return !e.a.is_valid(); });  // their order may change with triangles
        return oracle::to_text(all);
      };
      INFO(family << " " << seed << "\n" << scenes::to_text(scene));
      CHECK(lines(turned) == lines(scene));
      const Mesh one = scene.mesh(), other = turned.mesh();
      CHECK(visible_areas(one, scene.view, visible_fragments(one, scene.view)) ==
            visible_areas(other, scene.view, visible_fragments(other, scene.view)));
    }
  }
}

TEST_CASE("a single point that shows between two hidden parts is in neither list", "[rules][H8]") {
  TestScene scene = from_above();
  // The wire runs along x at z = 0. One slope is above it where x < 0, the other one where x > 0, and both contain its middle.
  scene.add_face({{-2, -1, 2}, {2, -1, -2}, {2, 1, -2}, {-2, 1, 2}});
  scene.add_face({{-2, -1, -2}, {2, -1, 2}, {2, 1, 2}, {-2, 1, -2}});
  add_wire(scene, {-1, 0, 0}, {1, 0, 0});
  CHECK(checked(scene).intervals(8, 9).find("visible") == std::string::npos);
}

TEST_CASE("a face that is cut into triangles has the fragments of its triangles", "[rules][S5][F7]") {
  TestScene scene = from_above();
  scene.add_face({{0, 0, 0}, {4, 0, 0}, {4, 4, 1}, {0, 4, 0}});
  const Mesh mesh = scene.mesh();
  const VisibleFragments found = visible_fragments(mesh, scene.view);
  REQUIRE(found.fragments.size() == 2);
  CHECK(found.fragments[0].facet == FacetId(0));
  CHECK(found.fragments[1].facet == FacetId(1));
  CHECK(wrong_fragments(scene) == "");
}

TEST_CASE("a face that is cut into triangles pierces as its triangles do", "[rules][I4]") {
  TestScene scene = from_above();
  scene.add_face({{0, 0, 0}, {4, 0, 0}, {4, 4, 1}, {0, 4, 0}});        // cut from corner 0 to corner 2
  scene.add_face({{1, 2, -5}, {3, 2, -5}, {3, 2.5, 5}, {1, 2.5, 5}});  // through both of its triangles
  int intersections = 0;
  const CheckedLines lines = checked(scene);
  for (const oracle::SeenEdge& e : lines.edges()) intersections += e.a.is_valid() ? 0 : 1;
  CHECK(intersections == 2);
}

TEST_CASE("a floor through an edge of a wall crosses it, its corners shared or not", "[rules][C10]") {
  for (const bool shares : {false, true}) {
    TestScene scene;
    scene.points = {{0, 0, 0}, {4, 0, 0}, {4, 0, 2}, {0, 0, 2}, {4, 0, 4}, {0, 0, 4}};
    scene.add_face({0, 1, 2, 3});
    scene.add_face({3, 2, 4, 5});
    const auto n = static_cast<std::uint32_t>(scene.points.size());
    for (const Point3& p : {Point3{0, -2, 2}, {4, -2, 2}, {4, 2, 2}, {0, 2, 2}}) scene.points.push_back(p);
    if (shares)
      scene.add_face({n, n + 1, 2, n + 2, n + 3, 3});
    else
      scene.add_face({n, n + 1, n + 2, n + 3});
    scene.view = scenes::from_direction({1, -3, 1});
    CHECK(checked(scene)(2, 3) == "intersection: 0 visible 1");
  }
}

TEST_CASE("a face counts where an edge runs along its border, longer or shorter", "[rules][C12]") {
  TestScene scene;
  scene.points = {{1, 0, 0}, {3, 0, 0}, {3, 0, 2}, {1, 0, 2}};
  scene.add_face({0, 1, 2, 3});
  scene.add_face({{0, 0, 0}, {0, -2, 0}, {4, -2, 0}, {4, 0, 0}});  // a floor before the wall, longer than it
  scene.view = scenes::from_direction({1, -3, 1});
  const CheckedLines lines = checked(scene);
  CHECK(lines(0, 1) == "sharp: 0 visible 1");
  CHECK(lines(4, 7) == "boundary: 0 visible 1/4");  // and so on
}

TEST_CASE("an edge that is seen as a point, or not beyond the near plane, has its class by its own faces", "[rules][C13]") {
  // An edge of one face in the middle of another: seen as a line it would be no boundary.
  const auto class_of = [](const View& view) {
    TestScene scene;
    scene.points = {{0, 0, 0}, {0, 0, 1}, {3, 0, 1}, {3, 0, 0}};
    scene.add_face({0, 1, 2, 3});
    scene.add_face({{0, -2, -2}, {0, 2, -2}, {0, 2, 3}, {0, -2, 3}});
    scene.view = view;
    return checked(scene)(0, 1);
  };
  CHECK(class_of(scenes::from_direction({3, -1, 1})).find("boundary") == std::string::npos);
  CHECK(class_of(scenes::from_direction(top)) == "boundary: nothing");
  CHECK(class_of(scenes::from_eye({9, -3, 3}, {20, 1, 0})) == "boundary: nothing");
}

TEST_CASE("a wire is a wire unless faces make it more than smooth", "[rules][C16]") {
  const auto class_of = [](double rise) {
    TestScene scene = from_above();
    scene.points = {{0, 0, 0}, {0, 4, 0}, {3, 2, rise}, {-3, 2, rise}};
    scene.add_face({0, 1, 2});
    scene.add_face({0, 1, 3});
    scene.polygons.segments.push_back({0, 1});
    return checked(scene)(0, 1);
  };
  CHECK(class_of(0) == "wire: 0 visible 1");
  CHECK(class_of(-3) == "sharp: 0 visible 1");
}

TEST_CASE("exactly flat is never sharp, whatever the crease", "[rules][C7]") {
  TestScene scene = from_above();
  scene.points = {{0, 0, 0}, {0, 4, 0}, {3, 2, 0}, {-3, 2, 0}, {3, 2, 0x1p-8}};
  scene.add_face({0, 1, 2});
  scene.add_face({0, 1, 3});
  LineOptions options = all_edges();
  options.crease = 0;
  CHECK(checked(scene, options)(0, 1) == "smooth: 0 visible 1");
  TestScene bent = from_above();
  bent.points = scene.points;
  bent.add_face({0, 1, 4});
  bent.add_face({0, 1, 3});
  CHECK(checked(bent, options)(0, 1) == "sharp: 0 visible 1");
}

TEST_CASE("one tree orders the faces for every view", "[rules][P11]") {
  const TestScene scene = scenes::family("triangles").make(7);
  const Mesh mesh = scene.mesh();
  const BspTree tree(mesh);
  for (const View& view :
       {scenes::from_direction({0, 0, 1}), scenes::from_direction({1, -2, 3}), scenes::from_direction({-1, 0, 0}),
        scenes::from_eye({9, 2, -7}, {0, 0, 0}), scenes::from_eye({0, 0, 0}, {1, 2, 3})})
    CHECK(oracle::wrong_with_order(mesh, view, tree.order(view)) == std::vector<std::string>{});
}

TEST_CASE("a pair that no plane of the two separates is cut by the classic cuts only", "[rules][P10]") {
  // Each passes through the plane of the other, beside it, and one is over the other: only their images overlap.
  TestScene scene = from_above();
  scene.add_face({{-4, -1, 0}, {4, -1, 0}, {4, 1, 0}, {-4, 1, 0}});
  scene.add_face({{-1, -4, -6}, {1, -4, -6}, {1, 4, 10}, {-1, 4, 10}});
  const Mesh mesh = scene.mesh();
  TestScene apart = from_above();
  apart.add_face({{0, 0, 0}, {8, 0, 8}, {0, 2, 0}});
  apart.add_face({{1, -3, 4}, {2, -3, 4}, {1.5, 6, -5.5}});
  const Mesh no_plane = apart.mesh();
  for (const Mesh* m : {&mesh, &no_plane}) {
    DepthSortOptions classic;
    classic.classic = true;
    const DepthSort few = depth_sort(*m, scene.view), more = depth_sort(*m, scene.view, classic);
    CHECK(oracle::wrong_with_order(*m, scene.view, few.order).empty());
    CHECK(oracle::wrong_with_order(*m, scene.view, more.order).empty());
    INFO(few.order.pieces.size() << " " << more.order.pieces.size());
    CHECK(few.order.pieces.size() <= more.order.pieces.size());
    if (m == &no_plane) {
      CHECK(few.order.pieces.size() == 2);
      CHECK(more.order.pieces.size() > 2);
    }
  }
}

TEST_CASE("a cycle of more than 4096 faces is cut by planes, and in order", "[rules][P9]") {
  TestScene scene = from_above();
  constexpr int n = 4200;
  for (int k = 0; k < n; ++k) {
    const double a = 2 * std::numbers::pi * k / n, b = 2 * std::numbers::pi * (k + 1.5) / n;
    const auto corner = [](double angle, double radius, double z) {
      return Point3{radius * std::cos(angle), radius * std::sin(angle), z};
    };
    scene.add_face({corner(a, 9, 1), corner(a, 10, 1), corner(b, 9.5, 0)});
  }
  const Mesh mesh = scene.mesh();
  const DepthSort result = depth_sort(mesh, scene.view);
  CHECK(result.counts.largest_component == n);
  CHECK(result.counts.cuts_in_cycles > 1);  // one cut would do, as it does for a thousand
  const SampleGrid grid = sample_grid(scene.view, paper_rectangle(mesh, scene.view), 300, 300);
  CHECK(check_order(mesh, scene.view, result.order, grid).wrong == 0);
}

}  // namespace
}  // namespace hsr
