#include "bench/scenes.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <map>

#include "geometry/error.h"
#include "geometry/mesh.h"

using hsr::Model;

namespace {

/// FNV-1a of the bits of all coordinates.
std::uint64_t hash(const Model& model) {
  std::uint64_t h = 0xcbf29ce484222325U;
  for (const auto& p : model.points)
    for (int axis = 0; axis < 3; ++axis) {
      std::uint64_t bits = 0;
      const double x = p[axis];
      std::memcpy(&bits, &x, sizeof bits);
      h = (h ^ bits) * 0x100000001b3U;
    }
  return h;
}

}  // namespace

TEST_CASE("a scene has about as many triangles as its name says", "[bench][scenes]") {
  for (const auto& [name, triangles] : {std::pair{"knot1k", 1000.0},
                                        {"knot100k", 100e3},
                                        {"city100", 1200.0},
                                        {"city1k", 12e3},
                                        {"rand1k", 1000.0},
                                        {"terrain1k", 1000.0},
                                        {"terrain100k", 100e3}}) {
    CAPTURE(name);
    CHECK(static_cast<double>(hsr::bench::scene(name).polygons.size()) == Approx(triangles).epsilon(0.02));
  }
}

TEST_CASE("a plate is closed and planar, as one polygon and of quads", "[bench][scenes]") {
  for (const auto& [name, faces] : {std::pair{"plate36", 36 * 16 + 6U}, {"quadplate36", 36 * 48 + 6 * 16U}}) {
    CAPTURE(name);
    const hsr::Model model = hsr::bench::scene(name);
    const hsr::Mesh mesh = hsr::make_mesh(model.points, model.polygons);
    CHECK(mesh.faces.size() == faces);
    CHECK(std::all_of(mesh.faces.begin(), mesh.faces.end(), [](hsr::FaceUse use) { return use == hsr::FaceUse::planar; }));
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) REQUIRE(mesh.triangles_at(hsr::EdgeId(e)).size() == 2);
  }
}

TEST_CASE("the coordinates of the scenes are float32 values", "[bench][scenes]") {
  for (const char* name : {"knot1k", "city1k", "rand1k", "terrain1k", "plate100", "quadplate100"}) {
    CAPTURE(name);
    const Model model = hsr::bench::scene(name);
    CHECK(std::all_of(model.points.begin(), model.points.end(), [](const hsr::Point3& p) {
      return p.x == static_cast<float>(p.x) && p.y == static_cast<float>(p.y) && p.z == static_cast<float>(p.z);
    }));
  }
}

TEST_CASE("the coordinates of the scenes are the same on every platform", "[bench][scenes]") {
  CHECK(hash(hsr::bench::scene("knot1k")) == 0x54a9ea8bd004f37dU);
  CHECK(hash(hsr::bench::scene("city1k")) == 0x0db020f1e1889625U);
  CHECK(hash(hsr::bench::scene("rand1k")) == 0x460fab3fb1931845U);
  CHECK(hash(hsr::bench::scene("terrain1k")) == 0xab4cf2c19b1ca285U);
}

TEST_CASE("the knot and the boxes of the city are closed", "[bench][scenes]") {
  for (const char* name : {"knot1k", "city1k"}) {
    CAPTURE(name);
    const Model model = hsr::bench::scene(name);
    std::map<std::array<std::uint32_t, 2>, int> balance;
    for (std::size_t f = 0; f < model.polygons.size(); ++f)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = model.polygons[f][k], b = model.polygons[f][(k + 1) % 3];
        balance[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
      }
    CHECK(std::all_of(balance.begin(), balance.end(), [](const auto& edge) { return edge.second == 0; }));
  }
}

TEST_CASE("the crossing triangles lie about eight layers deep in a straight view, whatever their number", "[bench][scenes]") {
  for (const char* name : {"rand1k", "rand10k"}) {
    CAPTURE(name);
    const Model model = hsr::bench::scene(name);
    double area = 0;
    for (std::size_t f = 0; f < model.polygons.size(); ++f) {
      const auto &a = model.points[3 * f], &b = model.points[3 * f + 1], &c = model.points[3 * f + 2];
      area += std::fabs((b.x - a.x) * (c.z - a.z) - (b.z - a.z) * (c.x - a.x)) / 2;
    }
    CHECK(area == Approx(8).epsilon(0.1));
  }
}

TEST_CASE("an unknown scene is refused with what is expected", "[bench][scenes]") {
  for (const char* name : {"", "knot", "knot0", "knot1x", "torus10k", "knot-5", "rand99999999999999999999", "knot1kk"}) {
    CAPTURE(name);
    CHECK_THROWS_AS(hsr::bench::scene(name), hsr::InputError);
  }
}
