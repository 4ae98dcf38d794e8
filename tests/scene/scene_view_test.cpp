#include <tbb/parallel_for.h>

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "hsr/lines/visible_lines.h"
#include "hsr/raster/caster.h"
#include "hsr/raster/samples.h"
#include "hsr/scene/scene_parts.h"
#include "hsr/scene/view_parts.h"
#include "hsr/surfaces/visible_fragments.h"
#include "tests/lines/checked_lines.h"
#include "tests/oracle/seen_edges.h"
#include "tests/scenes/random_scenes.h"
#include "tests/surfaces/checked_surfaces.h"

// One prepared scene: its parts are made once, by any thread, and views that share it give what each gives alone.

namespace hsr {

using namespace internal;

namespace {

std::string lines_text(const SceneView& scene) {
  return oracle::to_text(oracle::seen_edges(scene.mesh(), scene.view(), visible_lines(scene, all_edges())));
}

std::string fragments_text(const SceneView& scene) { return exact_text(scene.mesh(), scene.view(), visible_fragments(scene)); }

std::vector<View> views_of(const scenes::TestScene& scene) {
  return {scene.view, scenes::from_direction({1, -1, 1}), scenes::from_eye({9, -14, 11}, {0, 0, 0}),
          scenes::from_direction({0, 0, 1}), scenes::from_eye({0.5, 0.25, 0.125}, {3, 1, 2})};
}

TEST_CASE("views that share a scene see what each sees alone", "[scene][metamorphic]") {
  std::size_t meeting = 0;
  for (const char* family : {"triangles", "boxes", "polygons", "stacks", "slopes", "edge_on"})
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      const scenes::TestScene scene = scenes::family(family).make(seed);
      const Scene shared(scene.mesh());
      for (const View& view : views_of(scene))
        for (const bool hidden_lines : {true, false}) {
          const SceneOptions options{.hidden_lines = hidden_lines};
          const SceneView together(shared, view, options);
          const Mesh mesh = scene.mesh();
          const SceneView alone(mesh, view, options);
          INFO(family << " " << seed);
          if (hidden_lines) CHECK(lines_text(together) == lines_text(alone));
          CHECK(fragments_text(together) == fragments_text(alone));
        }
      const SceneView again(shared, scene.view);
      if (!again.parts().intersections().segments.empty()) ++meeting;
    }
  CHECK(meeting > 10);
}

TEST_CASE("what meets is looked for once for all views of a scene", "[scene]") {
  scenes::TestScene crossing;
  crossing.view = scenes::from_direction({1, -2, 3});
  crossing.add_face({Point3{-2, 0, 0}, Point3{2, 0, 0}, Point3{0, 0, 3}});
  crossing.add_face({Point3{0, -2, 1}, Point3{0, 2, 1}, Point3{0.5, 0, 2}});
  const Mesh mesh = crossing.mesh();
  const Scene scene(mesh);
  const auto pairs = [](const SceneView& view) { return view.parts().intersections().segments.size(); };
  const SceneView first(scene, crossing.view), second(scene, scenes::from_direction({-3, 1, 2}));
  CHECK(pairs(first) == 1);
  CHECK(pairs(second) == 1);
  // The second did not search: no tree was made for it.
  CHECK(first.parts().has_tree());
  CHECK_FALSE(second.parts().has_tree());
  CHECK(first.parts().intersections().segments[0].s == second.parts().intersections().segments[0].s);
}

TEST_CASE("a picture of samples takes the tree of the drawing", "[scene]") {
  std::size_t shared = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const scenes::TestScene scene = scenes::family("boxes").make(seed);
    const Mesh mesh = scene.mesh();
    const SceneView drawn(mesh, scene.view);
    const SampleGrid grid = sample_grid(scene.view, paper_rectangle(mesh, scene.view), 64, 48);
    const auto alone = cast(SceneView(mesh, scene.view), grid).triangles.pixels;
    (void)drawn.parts().occluders(Excluded::edge_on);
    CHECK(cast(drawn, grid).triangles.pixels == alone);
    const ViewParts& parts = drawn.parts().with(grid.bit_range());
    if (&parts.occluders(Excluded::edge_on) == &drawn.parts().occluders(Excluded::edge_on)) ++shared;
    CHECK(&parts == &drawn.parts().with(grid.bit_range()));
  }
  CHECK(shared > 10);
}

TEST_CASE("the parts of a view are made once, whatever threads ask", "[scene]") {
  const scenes::TestScene scene = scenes::family("boxes").make(5);
  const Mesh mesh = scene.mesh();
  const std::string expected = fragments_text(SceneView(mesh, scene.view)) + lines_text(SceneView(mesh, scene.view));
  for (int round = 0; round < 20; ++round) {
    const SceneView shared(mesh, scene.view);
    std::vector<std::string> found(8);
    std::vector<const ProjectedMesh*> projected(found.size());
    tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t k) {
      projected[k] = &shared.parts().projected();
      const std::string fragments = fragments_text(shared);
      found[k] = fragments + lines_text(shared);
    });
    for (const std::string& text : found) CHECK(text == expected);
    for (const ProjectedMesh* p : projected) CHECK(p == projected.front());
  }
}

}  // namespace
}  // namespace hsr
