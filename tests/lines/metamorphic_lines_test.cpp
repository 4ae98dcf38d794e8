#include <tbb/global_control.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <tuple>

#include "geometry/vector3.h"
#include "tests/lines/checked_lines.h"
#include "tests/scenes/random_scenes.h"

// The same picture, asked for in another way. These need no oracle.

namespace hsr {

using namespace internal;

namespace {

using oracle::SeenEdge;
using scenes::TestScene;

// An intersection from its other end.
SeenEdge turned(const SeenEdge& e) {
  SeenEdge r = e;
  if (e.cuts.size() % 2 == 1) r.starts_hidden = !e.starts_hidden;
  std::reverse(r.cuts.begin(), r.cuts.end());
  for (oracle::Q& t : r.cuts) t = 1 - t;
  return r;
}

// Intersections without their places and the numbers of their faces, from either end: these change with the scene.
std::vector<SeenEdge> seen(const TestScene& scene, const LineOptions& options = all_edges(),
                           const SceneOptions& of_scene = {}) {
  const Mesh mesh = scene.mesh();
  std::vector<SeenEdge> all =
      oracle::seen_edges(mesh, scene.view, visible_lines(SceneView(mesh, scene.view, of_scene), options));
  const auto key = [](const SeenEdge& e) { return std::tuple(e.cuts, e.starts_hidden); };
  const auto first = std::find_if(all.begin(), all.end(), [](const SeenEdge& e) { return !e.a.is_valid(); });
  for (auto e = first; e != all.end(); ++e) {
    e->s = e->t = FacetId(0);
    e->from = e->to = {};
    *e = std::min(*e, turned(*e), [&](const SeenEdge& x, const SeenEdge& y) { return key(x) < key(y); });
  }
  std::sort(first, all.end(), [&](const SeenEdge& x, const SeenEdge& y) { return key(x) < key(y); });
  return all;
}

// A scene without a view of its own can be moved: a view is given by what it was made of.
View view_with(const View& view, const Point3& at, const Point3& target) {
  return view.viewpoint.is_direction ? scenes::from_direction(at) : scenes::from_eye(at, target, view.near);
}

template <class Map>
TestScene mapped(TestScene scene, const Map& map) {
  for (Point3& p : scene.points) p = map(p);
  scene.view = view_with(scene.view, map(scene.view.viewpoint.at), map(scene.view.target));
  return scene;
}

template <class Check>
void on_random_scenes(std::initializer_list<const char*> families, int count, const Check& check) {
  for (const char* name : families) {
    for (std::uint64_t seed = 500'000; seed < 500'000 + static_cast<std::uint64_t>(count); ++seed) {
      const TestScene scene = scenes::family(name).make(seed);
      INFO(name << " " << seed << "\n" << scenes::to_text(scene));
      check(scene, seed);
    }
  }
}

TEST_CASE("the order of the faces changes no line", "[lines][metamorphic]") {
  on_random_scenes({"triangles", "polygons", "edge_on", "slopes", "around_the_eye"}, 60, [](const TestScene& scene, auto) {
    TestScene reversed = scene;
    reversed.polygons.first = {0};
    reversed.polygons.corners.clear();
    for (std::size_t f = scene.polygons.size(); f-- > 0;)
      reversed.add_face(std::vector<std::uint32_t>(scene.polygons[f].begin(), scene.polygons[f].end()));
    CHECK(oracle::to_text(seen(reversed)) == oracle::to_text(seen(scene)));
  });
}

TEST_CASE("turning the axes, mirroring and scaling by powers of two change no line", "[lines][metamorphic]") {
  on_random_scenes({"triangles", "edge_on", "boxes", "around_the_eye"}, 60, [](const TestScene& scene, std::uint64_t seed) {
    const std::string text = oracle::to_text(seen(scene));
    CHECK(oracle::to_text(seen(mapped(scene, [](const Point3& p) { return Point3{p.y, p.z, p.x}; }))) == text);
    CHECK(oracle::to_text(seen(mapped(scene, [](const Point3& p) { return Point3{p.x, p.y, -p.z}; }))) == text);
    CHECK(oracle::to_text(seen(mapped(scene, [](const Point3& p) { return Point3{p.x, p.z, p.y}; }))) == text);
    for (const int k : {900, -900, static_cast<int>(seed % 1800) - 900})
      CHECK(oracle::to_text(seen(mapped(scene, [k](const Point3& p) {
              return Point3{std::ldexp(p.x, k), std::ldexp(p.y, k), std::ldexp(p.z, k)};
            }))) == text);
  });
}

TEST_CASE("moving far away changes no line while no coordinate is rounded", "[lines][metamorphic]") {
  on_random_scenes({"triangles", "edge_on", "boxes", "around_the_eye"}, 60, [](const TestScene& scene, auto) {
    const std::string text = oracle::to_text(seen(scene));
    for (const double far : {0x1p20, 0x1p48}) {
      TestScene moved = scene;
      const auto move = [far](const Point3& p) { return Point3{p.x + far, p.y - far, p.z + 2 * far}; };
      for (Point3& p : moved.points) p = move(p);
      if (scene.view.is_perspective())
        moved.view = scenes::from_eye(move(scene.view.viewpoint.at), move(scene.view.target), scene.view.near);
      CHECK(oracle::to_text(seen(moved)) == text);
    }
  });
}

TEST_CASE("a face behind everything changes no line", "[lines][metamorphic]") {
  on_random_scenes({"triangles", "polygons", "edge_on", "boxes"}, 60, [](const TestScene& scene, auto) {
    const View& view = scene.view;
    const Point3 at = view.viewpoint.at;
    const Point3 away = view.is_perspective() ? Point3{view.target.x - at.x, view.target.y - at.y, view.target.z - at.z}
                                              : Point3{-at.x, -at.y, -at.z};
    const Point3 u = cross(away, away.x == 0 && away.y == 0 ? Point3{1, 0, 0} : Point3{0, 0, 1}), v = cross(away, u);
    double depth = view.is_perspective() ? dot(away, at) + 4 * dot(away, away) : 0;
    for (const Point3& p : scene.points) depth = std::max(depth, dot(away, p));
    const double m = std::ceil(depth / dot(away, away)) + 1;  // the plane away . p = m away^2 is behind every point
    const auto corner = [&](double i, double j) {
      return Point3{m * away.x + i * u.x + j * v.x, m * away.y + i * u.y + j * v.y, m * away.z + i * u.z + j * v.z};
    };
    TestScene more = scene;
    more.add_face({corner(200, 0), corner(-100, 150), corner(-100, -150)});
    std::vector<SeenEdge> edges = seen(more);
    std::erase_if(edges, [&](const SeenEdge& e) { return e.b.is_valid() && e.b.value >= scene.points.size(); });
    CHECK(oracle::to_text(edges) == oracle::to_text(seen(scene)));
  });
}

TEST_CASE("cutting a face in two changes no line but those at the cut", "[lines][metamorphic]") {
  on_random_scenes({"triangles", "around_the_eye", "slopes"}, 80, [](const TestScene& scene, auto) {
    const auto face = scene.polygons[0];
    if (face.size() != 3) return;
    const Point3 a = scene.points[face[0]], b = scene.points[face[1]];
    const Point3 middle = {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
    const oracle::Vec twice = oracle::Vec(a) + oracle::Vec(b);
    if (a == b || !(oracle::Q(2) * oracle::Vec(middle) == twice)) return;  // the middle of neighbouring doubles is no double
    TestScene cut{scene.name, scene.points, {}, scene.view};
    cut.polygons.segments = scene.polygons.segments;
    const auto m = static_cast<std::uint32_t>(cut.points.size());
    cut.points.push_back(middle);
    cut.add_face({face[0], m, face[2]});
    cut.add_face({m, face[1], face[2]});
    for (std::size_t f = 1; f < scene.polygons.size(); ++f)
      cut.add_face(std::vector<std::uint32_t>(scene.polygons[f].begin(), scene.polygons[f].end()));
    const Mesh mesh = cut.mesh();
    const auto at_cut = [&](const SeenEdge& e) {
      if (!e.a.is_valid()) return true;  // what pierces the face now pierces its halves
      const auto is = [&](std::uint32_t p, std::uint32_t q) {
        const VertexId i = mesh.merged[VertexId(p)], j = mesh.merged[VertexId(q)];
        return (e.a == i && e.b == j) || (e.a == j && e.b == i);
      };
      return is(face[0], face[1]) || is(face[0], m) || is(face[1], m) || is(face[2], m);
    };
    std::vector<SeenEdge> before = seen(scene), after = seen(cut);
    std::erase_if(before, at_cut);
    std::erase_if(after, at_cut);
    CHECK(oracle::to_text(after) == oracle::to_text(before));
  });
}

void same_bits(const VisibleLines& a, const VisibleLines& b) {
  REQUIRE(a.lines.size() == b.lines.size());
  for (std::size_t i = 0; i < a.lines.size(); ++i) {
    const Line &p = a.lines[i], &q = b.lines[i];
    CHECK(p.edge == q.edge);
    CHECK(p.intersection == q.intersection);
    CHECK(p.edge_class == q.edge_class);
    CHECK(p.starts_hidden == q.starts_hidden);
    CHECK(p.first_cut == q.first_cut);
    CHECK(p.end_cut == q.end_cut);
    CHECK(p.first_occluder == q.first_occluder);
    CHECK(p.end_occluder == q.end_occluder);
  }
  CHECK(a.cuts == b.cuts);
  CHECK(a.intersections == b.intersections);
  REQUIRE(a.occluders.size() == b.occluders.size());
  for (std::size_t i = 0; i < a.occluders.size(); ++i) {
    CHECK(a.occluders[i].face == b.occluders[i].face);
    CHECK(a.occluders[i].from == b.occluders[i].from);
    CHECK(a.occluders[i].to == b.occluders[i].to);
  }
  CHECK(a.pairs == b.pairs);
}

// Many scenes side by side: enough edges to be shared out among threads.
TestScene crowd(std::uint64_t seed) {
  TestScene all;
  for (std::uint64_t i = 0; i < 300; ++i) {
    const TestScene one = scenes::family(i % 2 == 0 ? "triangles" : "boxes").make(seed + i);
    const auto first = static_cast<std::uint32_t>(all.points.size());
    const double x = 5.0 * static_cast<double>(i % 20), y = 5.0 * std::floor(static_cast<double>(i) / 20);
    for (const Point3& p : one.points) all.points.push_back({p.x + x, p.y + y, p.z});
    for (std::size_t f = 0; f < one.polygons.size(); ++f) {
      std::vector<std::uint32_t> corners(one.polygons[f].begin(), one.polygons[f].end());
      for (auto& c : corners) c += first;
      all.add_face(corners);
    }
  }
  all.view = seed % 2 == 0 ? scenes::from_direction({1, -1, 1}) : scenes::from_eye({-20, -30, 25}, {50, 40, 0});
  return all;
}

TEST_CASE("one thread and two give the same bits", "[lines][metamorphic]") {
  for (const std::uint64_t seed : {600'000U, 600'001U}) {
    const TestScene scene = crowd(seed);
    for (const LineMethod method : {LineMethod::roberts, LineMethod::appel}) {
      LineOptions options = all_edges();
      options.method = method;
      options.why = method == LineMethod::roberts;
      SceneOptions always;
      always.stages.fill(When::always);
      const auto with_threads = [&](std::size_t n) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, n);
        const Mesh mesh = scene.mesh();
        return visible_lines(SceneView(mesh, scene.view, always), options);
      };
      const VisibleLines one = with_threads(1), two = with_threads(2);
      CHECK(one.lines.size() > 2000);
      same_bits(one, two);
      CHECK(one.decisions == two.decisions);
      CHECK(one.pairs == two.pairs);
    }
  }
}

TEST_CASE("both methods and every stage give the same lines of thousands of faces", "[lines][metamorphic][M1][M2]") {
  for (const std::uint64_t seed : {600'002U, 600'003U}) {
    const TestScene scene = crowd(seed);
    const Mesh mesh = scene.mesh();
    LineOptions options = all_edges();
    options.method = LineMethod::roberts;
    SceneOptions chosen;
    chosen.stages.fill(When::never);
    const auto text = [&] {
      const SceneView view(mesh, scene.view, chosen);
      return oracle::to_text(oracle::seen_edges(mesh, scene.view, visible_lines(view, options)));
    };
    const std::string reference = text();
    for (const LineMethod method : {LineMethod::roberts, LineMethod::appel})
      for (const When stages : {When::never, When::always}) {
        options.method = method;
        chosen.stages.fill(stages);
        CHECK(text() == reference);
      }
    // Few edges asked for: most faces are far from them.
    options.classes = {true, false, true, false, true, false};
    options.method = LineMethod::roberts;
    chosen.stages.fill(When::never);
    const std::string few = text();
    options.method = LineMethod::appel;
    CHECK(text() == few);
  }
}

TEST_CASE("every arithmetic that is exact gives the same lines", "[lines][metamorphic]") {
  on_random_scenes({"triangles", "edge_on", "stacks", "slopes", "around_the_eye", "scaled"}, 40,
                   [](const TestScene& scene, auto) {
                     LineOptions options = all_edges();
                     const std::string text = oracle::to_text(seen(scene, options));
                     options.method = LineMethod::appel;
                     for (const Arithmetic arithmetic : {Arithmetic::interval, Arithmetic::rational})
                       CHECK(oracle::to_text(seen(scene, options, {.arithmetic = arithmetic})) == text);
                   });
}

}  // namespace
}  // namespace hsr
