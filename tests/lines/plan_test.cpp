#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <random>
#include <vector>

#include "hsr/lines/image_mask.h"
#include "hsr/scene/occlusion_pyramid.h"
#include "hsr/scene/projected_mesh.h"
#include "tests/lines/checked_lines.h"
#include "tests/scenes/random_scenes.h"

// What the plan leaves out: that it is right the random scenes show, which ask the oracle with every stage on and off; here,
// that it leaves out what it should.

namespace hsr {

using namespace internal;

namespace {

/// A wall of 8 x 8 in the plane y = 0, as two triangles or one quad, and small squares: behind it, standing on its ground;
/// half beside it; before it.
scenes::TestScene wall_and_squares(bool as_triangles, const View& view) {
  scenes::TestScene scene;
  scene.view = view;
  if (as_triangles) {
    scene.points = {{0, 0, 0}, {8, 0, 0}, {8, 0, 8}, {0, 0, 8}};
    scene.add_face({0, 1, 2});
    scene.add_face({0, 2, 3});
  } else {
    scene.add_face(std::vector<Point3>{{0, 0, 0}, {8, 0, 0}, {8, 0, 8}, {0, 0, 8}});
  }
  scene.add_face(std::vector<Point3>{{3, 5, 0}, {5, 5, 0}, {5, 5, 3}, {3, 5, 3}});
  scene.add_face(std::vector<Point3>{{7, 5, 0}, {9, 5, 0}, {9, 5, 3}, {7, 5, 3}});
  scene.add_face(std::vector<Point3>{{3, -5, 1}, {5, -5, 1}, {5, -5, 3}, {3, -5, 3}});
  return scene;
}

std::vector<bool> hidden_faces(const scenes::TestScene& scene) {
  const Mesh mesh = scene.mesh();
  const ProjectedMesh projected(mesh, scene.view, Arithmetic::staged);
  const OcclusionPyramid tiles(projected, true);
  std::vector<bool> hidden(mesh.faces.size(), true);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (!tiles.hides(TriangleId(t))) hidden[mesh.face_of[TriangleId(t)].value] = false;
  return hidden;
}

TEST_CASE("tiles hide what lies behind a wall, the ground it stands on included", "[lines][plan]") {
  const View front = scenes::from_direction({0, -1, 0});
  CHECK(hidden_faces(wall_and_squares(true, front)) == std::vector<bool>{false, false, true, false, false});
  CHECK(hidden_faces(wall_and_squares(false, front)) == std::vector<bool>{false, true, false, false});
}

TEST_CASE("tiles hide behind a wall in a perspective view, but nothing in the plane of the wall", "[lines][plan]") {
  scenes::TestScene scene = wall_and_squares(true, scenes::from_eye({4, -40, 4}, {4, 0, 4}));
  scene.add_face(std::vector<Point3>{{3, 0, 3}, {5, 0, 3}, {5, 0, 5}, {3, 0, 5}});
  const auto hidden = hidden_faces(scene);
  CHECK(hidden == std::vector<bool>{false, false, true, false, false, false});
}

TEST_CASE("what the plan leaves out is hidden, and it leaves out some", "[lines][plan][oracle]") {
  std::size_t scenes_with_hidden = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const scenes::TestScene scene = scenes::family("boxes").make(seed);
    for (const bool hides : hidden_faces(scene))
      if (hides) {
        ++scenes_with_hidden;
        break;
      }
    CHECK(wrong_with(scene) == "");
  }
  CHECK(scenes_with_hidden > 3);
}

/// Of the edges of a scene: how many visible intervals lie in no part that the tiles leave as unhidden, and how much of all
/// edges the tiles leave out.
struct UnhiddenShare {
  std::size_t wrong = 0;
  double share = 0;
};

UnhiddenShare left_out(const scenes::TestScene& scene) {
  const Mesh mesh = scene.mesh();
  const ProjectedMesh projected(mesh, scene.view, Arithmetic::staged);
  const OcclusionPyramid tiles(projected, true);
  SceneOptions never;
  never.stages.fill(When::never);
  const VisibleLines lines = visible_lines(SceneView(mesh, scene.view, never), all_edges());
  UnhiddenShare found;
  std::vector<UnhiddenInterval> parts;
  for (const Line& line : lines.lines) {
    if (line.is_intersection() || !tiles.unhidden(mesh.edges[line.edge], parts)) continue;
    double left = 1;
    for (const UnhiddenInterval& part : parts) left -= std::min(part.to, 1.0) - std::max(part.from, 0.0);
    found.share += left;
    const Edge& edge = mesh.edges[line.edge];
    const double m = projected.is_perspective() ? projected.nearness(projected.point(edge.a), 0).value : 1,
                 n = projected.is_perspective() ? projected.nearness(projected.point(edge.b), 0).value : 1;
    const auto cuts = lines.cuts_of(line);
    for (std::uint32_t k = 0; k < line.intervals(); ++k) {
      if (line.hidden(k)) continue;
      const auto share = [&](const Cut& cut) {
        const double t = exact_parameter(mesh, scene.view, supporting_line_of(mesh, lines, line), cut).to_double();
        return t * n / (m + t * (n - m));
      };
      constexpr double rounding = 1e-9;
      const double from = share(cuts[k]), to = share(cuts[k + 1]);
      if (std::none_of(parts.begin(), parts.end(),
                       [&](const UnhiddenInterval& part) { return part.from <= from + rounding && part.to >= to - rounding; }))
        ++found.wrong;
    }
  }
  return found;
}

TEST_CASE("tiles leave every visible part of an edge, and not the hidden ones", "[lines][plan]") {
  // An edge that comes out from behind the wall, a quarter of it hidden, and one behind it that both walls of a gap hide.
  for (const View& view : {scenes::from_direction({0, -1, 0}), scenes::from_direction({0.03, -1, 0.02}),
                           scenes::from_eye({4, -40, 4}, {4, 0, 4})}) {
    scenes::TestScene scene = wall_and_squares(false, view);
    scene.add_face(std::vector<Point3>{{4, 5, 2}, {20, 5, 2}, {20, 30, 2.5}});
    scene.add_face(std::vector<Point3>{{12, 0, 0}, {20, 0, 0}, {20, 0, 8}, {12, 0, 8}});
    scene.add_face(std::vector<Point3>{{1, 9, 5}, {19, 9, 5}, {19, 9, 5.5}});
    const UnhiddenShare found = left_out(scene);
    CHECK(found.wrong == 0);
    CHECK(found.share > 2);
  }
  double share = 0;
  for (const char* family : {"boxes", "triangles", "slopes", "scaled", "magnitudes"})
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
      const UnhiddenShare found = left_out(scenes::family(family).make(seed));
      CHECK(found.wrong == 0);
      share += found.share;
    }
  CHECK(share > 100);
}

TEST_CASE("a mask touches every box that overlaps one of its own", "[lines][plan]") {
  std::mt19937 random(7);
  const auto box = [&](float size) {
    const auto at = [&] { return static_cast<float>(random() % 4096) / 64.0F; };
    const float x = at(), y = at();
    const float w = static_cast<float>(random() % 64) / 64.0F * size, h = static_cast<float>(random() % 64) / 64.0F * size;
    return ImageBox{{x, y}, {x + w, y + h}, 0, 1};
  };
  std::size_t missed = 0;
  for (int round = 0; round < 20; ++round) {
    std::vector<ImageBox> own;
    for (int k = 0; k < 10; ++k) own.push_back(box(4));
    const ImageMask mask(own, round % 2 == 0 ? 500 : 1'000'000);
    for (int k = 0; k < 500; ++k) {
      const ImageBox query = box(k % 2 == 0 ? 0.5F : 8.0F);
      bool overlaps = false;
      for (const ImageBox& b : own)
        overlaps = overlaps || (b.low[0] <= query.high[0] && query.low[0] <= b.high[0] && b.low[1] <= query.high[1] &&
                                query.low[1] <= b.high[1]);
      if (overlaps) CHECK(mask.touches(query));
      if (!mask.touches(query)) ++missed;
    }
  }
  CHECK(missed > 5000);
}

}  // namespace
}  // namespace hsr
