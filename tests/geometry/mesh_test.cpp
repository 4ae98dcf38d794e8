#include "geometry/mesh.h"

#include <tbb/global_control.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>

#include "geometry/error.h"

using namespace hsr;

namespace {

Polygons polygons(const std::vector<std::vector<std::uint32_t>>& faces,
                  std::vector<std::array<std::uint32_t, 2>> segments = {}) {
  Polygons p;
  for (const auto& face : faces) {
    p.corners.insert(p.corners.end(), face.begin(), face.end());
    p.first.push_back(static_cast<std::uint32_t>(p.corners.size()));
  }
  p.segments = std::move(segments);
  return p;
}

// "0-1 ring 0 2" ...: an edge, its flags, the triangles at it.
std::vector<std::string> edges(const Mesh& mesh) {
  std::vector<std::string> lines;
  for (std::size_t k = 0; k < mesh.edges.size(); ++k) {
    const Edge& e = mesh.edges[EdgeId(k)];
    std::string line = std::to_string(e.a.value) + "-" + std::to_string(e.b.value);
    if (e.of_face) line += " ring";
    if (e.diagonal) line += " diagonal";
    if (e.wire) line += " wire";
    for (const TriangleId t : mesh.triangles_at(EdgeId(k))) line += " " + std::to_string(t.value);
    lines.push_back(line);
  }
  return lines;
}

using Lines = std::vector<std::string>;

const std::vector<Point3> square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

// Any soup: triangles, quads and larger on few points, wires. The first half of the points are in one plane, and so is every
// other face; on a small grid, more is coplanar, and points repeat.
std::pair<std::vector<Point3>, Polygons> soup(unsigned seed, std::uint32_t faces, std::uint32_t points, int size) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> coordinate(0, size);
  std::uniform_int_distribution<std::uint32_t> corners(0, 7), vertex(0, points - 1), flat_vertex(0, points / 2);
  std::vector<Point3> p;
  for (std::uint32_t k = 0; k < points; ++k) {
    const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
    p.push_back({x, y, k <= points / 2 ? 0 : z});
  }
  std::vector<std::vector<std::uint32_t>> f(faces);
  for (std::uint32_t k = 0; k < faces; ++k)
    for (std::uint32_t c = corners(random); c > 0; --c) f[k].push_back(k % 2 == 0 ? flat_vertex(random) : vertex(random));
  std::vector<std::array<std::uint32_t, 2>> segments;
  for (std::uint32_t k = 0; k < faces / 4; ++k) segments.push_back({vertex(random), vertex(random)});
  return {p, polygons(f, segments)};
}

}  // namespace

TEST_CASE("Points that are bit-identical are merged, the lowest index stands for all", "[geometry][mesh][F1]") {
  const double next = std::nextafter(1.0, 2.0);
  const Mesh mesh =
      make_mesh({{1, 0, 0}, {1, 0, 0}, {next, 0, 0}, {0, 1, 0}, {1, -0.0, -0.0}, {0, 0, 1}}, polygons({{4, 3, 5}, {1, 2, 3}}));
  CHECK(mesh.merged ==
        IndexedVector<VertexId, VertexId>{VertexId(0), VertexId(0), VertexId(2), VertexId(3), VertexId(0), VertexId(5)});
  CHECK(mesh.triangles[TriangleId(0)] == std::array{VertexId(0), VertexId(3), VertexId(5)});
  CHECK(mesh.triangles[TriangleId(1)] == std::array{VertexId(0), VertexId(2), VertexId(3)});
  CHECK_FALSE(std::signbit(mesh.points[VertexId(4)].y));
  CHECK(edges(mesh) == Lines{"0-2 ring 1", "0-3 ring 0 1", "0-5 ring 0", "2-3 ring 1", "3-5 ring 0"});
}

TEST_CASE("Merging agrees with comparing all points", "[geometry][mesh][property][F1]") {
  const auto points = soup(1, 0, 3000, 12).first;
  const Mesh mesh = make_mesh(points, {});
  std::map<std::array<double, 3>, std::size_t> lowest;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto [place, is_new] = lowest.insert({{points[k].x, points[k].y, points[k].z}, k});
    REQUIRE(mesh.merged[VertexId(k)].value == place->second);
  }
  CHECK(lowest.size() < points.size());
}

TEST_CASE("A planar face has edges along its ring only, a bent one a diagonal too", "[geometry][mesh][F6]") {
  const Mesh planar = make_mesh(square, polygons({{0, 1, 2, 3}}));
  CHECK(planar.faces[FaceId(0)] == FaceUse::planar);
  CHECK(planar.triangles.size() == 2);
  CHECK(edges(planar) == Lines{"0-1 ring 0", "0-3 ring 1", "1-2 ring 0", "2-3 ring 1"});

  auto bent_points = square;
  bent_points[2].z = 1;
  const Mesh bent = make_mesh(bent_points, polygons({{0, 1, 2, 3}}));
  CHECK(bent.faces[FaceId(0)] == FaceUse::not_coplanar);
  CHECK(edges(bent) == Lines{"0-1 ring 0", "0-2 diagonal 0 1", "0-3 ring 1", "1-2 ring 0", "2-3 ring 1"});
}

TEST_CASE("A diagonal inside a planar face is not at an edge of another face, one of a bent face is", "[geometry][mesh]") {
  auto points = square;
  points.push_back({0.5, 0.5, 1});
  const Mesh planar = make_mesh(points, polygons({{0, 1, 2, 3}, {0, 2, 4}}));
  CHECK(edges(planar) ==
        Lines{"0-1 ring 0", "0-2 ring 2", "0-3 ring 1", "0-4 ring 2", "1-2 ring 0", "2-3 ring 1", "2-4 ring 2"});
  points[3].z = 1;
  const Mesh bent = make_mesh(points, polygons({{0, 1, 2, 3}, {0, 2, 4}}));
  CHECK(edges(bent)[1] == "0-2 ring diagonal 0 1 2");
}

TEST_CASE("Faces of no area keep their number and take their edges with them", "[geometry][mesh][F4]") {
  const std::vector<Point3> points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {7, 7, 7}};
  const Mesh mesh = make_mesh(points, polygons({{0, 1, 2}, {0, 1, 3}, {}, {4}, {0, 4, 0}, {0, 1, 4, 1}, {1, 2, 3}}));
  using enum FaceUse;
  CHECK(mesh.faces == IndexedVector<FaceId, FaceUse>{no_area, planar, no_area, no_area, no_area, no_area, planar});
  CHECK(mesh.first_triangle == IndexedVector<FaceId, std::uint32_t>{0, 0, 1, 1, 1, 1, 1, 2});
  CHECK(mesh.face_of == IndexedVector<TriangleId, FaceId>{FaceId(1), FaceId(6)});
  CHECK(edges(mesh) == Lines{"0-1 ring 0", "0-3 ring 0", "1-2 ring 1", "1-3 ring 0 1", "2-3 ring 1"});  // not 0-2, not 1-4
}

TEST_CASE("A spike has no edge, a keyhole has one with the face on both sides", "[geometry][mesh][F5]") {
  const Mesh spike = make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 0}}, polygons({{0, 1, 3, 1, 2}}));
  CHECK(edges(spike) == Lines{"0-1 ring 0", "0-2 ring 0", "1-2 ring 0"});

  const std::vector<Point3> points = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {1, 1, 0}, {3, 1, 0}, {3, 3, 0}, {1, 3, 0}};
  const Mesh keyhole = make_mesh(points, polygons({{0, 1, 2, 3, 0, 4, 7, 6, 5, 4}}));
  CHECK(keyhole.faces[FaceId(0)] == FaceUse::planar);
  REQUIRE(keyhole.edges.size() == 9);
  for (std::size_t k = 0; k < 9; ++k) {
    const Edge& e = keyhole.edges[EdgeId(k)];
    const bool is_bridge = e.a.value == 0 && e.b.value == 4;
    CHECK(keyhole.triangles_at(EdgeId(k)).size() == (is_bridge ? 2 : 1));
    CHECK(e.of_face);
  }
}

TEST_CASE("Duplicate and flipped faces and edges of many faces are kept", "[geometry][mesh]") {
  auto points = square;
  points.push_back({0, 0, 1});
  points.push_back({0, 0, -1});
  const Mesh mesh = make_mesh(points, polygons({{0, 1, 2}, {2, 1, 0}, {1, 2, 0}, {0, 1, 4}, {1, 0, 5}}));
  CHECK(mesh.triangles.size() == 5);
  CHECK(edges(mesh)[0] == "0-1 ring 0 1 2 3 4");
  CHECK(mesh.apex(TriangleId(3), mesh.edges[EdgeId(0)]) == VertexId(4));
}

TEST_CASE("Segments are wires, on an edge too, and none if they have no length", "[geometry][mesh]") {
  auto points = square;
  points.push_back({1, 0, -0.0});
  const Mesh mesh = make_mesh(points, polygons({{0, 1, 2}}, {{1, 4}, {3, 0}, {0, 3}, {2, 4}}));
  CHECK(edges(mesh) == Lines{"0-1 ring 0", "0-2 ring 0", "0-3 wire", "1-2 ring wire 0"});
}

TEST_CASE("A mesh may be empty", "[geometry][mesh]") {
  const Mesh mesh = make_mesh({}, Polygons{});
  CHECK(mesh.edges.empty());
  CHECK(mesh.first_side.size() == 1);
  CHECK(mesh.first_triangle.size() == 1);
}

TEST_CASE("What is no number and what is no point is refused with its place", "[geometry][mesh][R3]") {
  const double infinite = std::numeric_limits<double>::infinity();
  CHECK_THROWS_WITH(make_mesh({{0, 0, 0}, {0, std::nan(""), 0}}, {}), "point 1: a finite coordinate expected, found nan");
  CHECK_THROWS_WITH(make_mesh({{0, 0, -infinite}}, {}), "point 0: a finite coordinate expected, found -inf");
  CHECK_THROWS_WITH(make_mesh(square, polygons({{0, 1, 2}, {}, {1, 2, 3, 4}})), "face 2: an index below 4 expected, found 4");
  CHECK_THROWS_WITH(make_mesh(square, polygons({{0, 1, 2}}, {{0, 1}, {9, 0}})),
                    "segment 1: an index below 4 expected, found 9");
  CHECK_THROWS_AS(make_mesh(square, polygons({{4, 0, 1}})), InputError);
  Polygons broken = polygons({{0, 1, 2}});
  broken.first.back() = 4;
  CHECK_THROWS_AS(make_mesh(square, broken), PreconditionError);
}

TEST_CASE("More things than an index can tell apart are refused with the bound", "[geometry][mesh]") {
  CHECK_NOTHROW(check_countable(0xfffffffe, "faces"));
  CHECK_THROWS_WITH(check_countable(0xffffffff, "faces"), "fewer than 2^32 - 1 faces expected, found 4294967295");
  CHECK_THROWS_AS(check_countable(std::size_t{1} << 40, "points"), InputError);
}

TEST_CASE("A triangle has an area down to the smallest double and up to the largest", "[geometry][mesh]") {
  const double tiny = 5e-324, huge = std::numeric_limits<double>::max();
  const auto use = [](const Point3& a, const Point3& b, const Point3& c) {
    return make_mesh({a, b, c}, polygons({{0, 1, 2}})).faces[FaceId(0)];
  };
  CHECK(use({0, 0, 0}, {tiny, 0, 0}, {0, tiny, 0}) == FaceUse::planar);
  CHECK(use({0, 0, 0}, {tiny, tiny, tiny}, {2 * tiny, 2 * tiny, 2 * tiny}) == FaceUse::no_area);
  CHECK(use({0, 0, 0}, {1, 1, 1}, {3, 3, 3}) == FaceUse::no_area);
  CHECK(use({0, 0, 0}, {1, 1, 1}, {3, 3, std::nextafter(3.0, 4.0)}) == FaceUse::planar);
  CHECK(use({-huge, 0, 0}, {huge, 0, 0}, {0, tiny, 0}) == FaceUse::planar);
  CHECK(use({-huge, -huge, 1}, {huge, huge, 1}, {0, 0, 1}) == FaceUse::no_area);
  CHECK(use({0.1, 0.1, 0.1}, {0.2, 0.2, 0.2}, {0.3, 0.3, 0.3}) == FaceUse::no_area);
}

TEST_CASE("Edges are what the sides of the triangles say", "[geometry][mesh][property]") {
  for (unsigned seed = 0; seed < 30; ++seed) {
    auto [points, given] = soup(seed, 300, 60, 1000000);  // no three on a line
    for (std::size_t k = 0; k < 5; ++k) points[k + 7] = points[k];
    const Mesh mesh = make_mesh(points, given);
    CAPTURE(seed);
    // (2)
    REQUIRE(std::is_sorted(mesh.face_of.begin(), mesh.face_of.end()));
    REQUIRE(mesh.first_triangle.back() == mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const FaceId f = mesh.face_of[TriangleId(t)];
      REQUIRE(mesh.first_triangle[f] <= t);
      REQUIRE(t < mesh.first_triangle[FaceId(f.value + 1U)]);
    }
    // (3): by a map from pairs, the planar faces' own edges from the polygons as given.
    using Pair = std::pair<VertexId, VertexId>;
    std::map<Pair, std::vector<TriangleId>> expected;
    std::map<FaceId, std::map<Pair, int>> inner;  // sides within a face
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const VertexId a = mesh.triangles[TriangleId(t)][k], b = mesh.triangles[TriangleId(t)][(k + 1) % 3];
        ++inner[mesh.face_of[TriangleId(t)]][std::minmax(a, b)];
      }
    std::set<Pair> ring_edges;
    std::map<FaceId, std::set<Pair>> ring_of;
    for (std::size_t f = 0; f < given.size(); ++f) {
      std::vector<VertexId> ring;
      for (const std::uint32_t corner : given[f]) ring.push_back(mesh.merged[VertexId(corner)]);
      for (std::size_t k = 0; k < ring.size();) {
        const std::size_t n = ring.size();
        const bool goes = ring[k] == ring[(k + 1) % n] || ring[(k + n - 1) % n] == ring[(k + 1) % n];
        if (goes) ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(k));
        k = goes ? 0 : k + 1;
      }
      for (std::size_t k = 0; k < ring.size(); ++k)
        ring_of[FaceId(f)].insert(std::minmax(ring[k], ring[(k + 1) % ring.size()]));
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const VertexId a = mesh.triangles[TriangleId(t)][k], b = mesh.triangles[TriangleId(t)][(k + 1) % 3];
        const FaceId f = mesh.face_of[TriangleId(t)];
        const Pair pair = std::minmax(a, b);
        const bool in_ring = ring_of[f].contains(pair);
        if (mesh.faces[f] == FaceUse::planar && inner[f][pair] == 2 && !in_ring) continue;
        expected[pair].push_back(TriangleId(t));
        if (in_ring) ring_edges.insert(pair);
      }
    for (const auto& [from, to] : given.segments) {
      const VertexId a = mesh.merged[VertexId(from)], b = mesh.merged[VertexId(to)];
      if (a != b) expected[std::minmax(a, b)];
    }
    REQUIRE(mesh.edges.size() == expected.size());
    std::size_t k = 0;
    for (const auto& [pair, triangles] : expected) {
      const EdgeId e(k++);
      REQUIRE(Pair(mesh.edges[e].a, mesh.edges[e].b) == pair);
      const auto at = mesh.triangles_at(e);
      REQUIRE(std::vector<TriangleId>(at.begin(), at.end()) == triangles);
      REQUIRE(mesh.edges[e].of_face == ring_edges.contains(pair));
      REQUIRE((mesh.edges[e].of_face || mesh.edges[e].diagonal || mesh.edges[e].wire));
    }
  }
}

TEST_CASE("The mesh is the same for any number of threads", "[geometry][mesh][property]") {
  const auto [points, given] = soup(7, 60000, 20000, 30);
  const auto with_threads = [&, &p = points, &g = given](std::size_t threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    return make_mesh(p, g);
  };
  const Mesh one = with_threads(1);
  for (const std::size_t threads : {2U, 5U}) {
    const Mesh many = with_threads(threads);
    CHECK(many.merged == one.merged);
    CHECK(many.faces == one.faces);
    CHECK(many.first_triangle == one.first_triangle);
    CHECK(many.triangles == one.triangles);
    CHECK(many.face_of == one.face_of);
    CHECK(many.first_side == one.first_side);
    CHECK(many.sides == one.sides);
    CHECK(edges(many) == edges(one));
  }
}
