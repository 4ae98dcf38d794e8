#include <catch2/catch.hpp>
#include <exception>

#include "geometry/error.h"
#include "hsr/check/sample_checks.h"
#include "hsr/painter/bsp/bsp.h"
#include "hsr/painter/sort/depth_sort.h"
#include "hsr/painter/verify/verify.h"
#include "hsr/raster/caster.h"
#include "tests/oracle/painting_oracle.h"
#include "tests/oracle/sample_oracle.h"
#include "tests/scenes/coincident_faces.h"
#include "tests/scenes/random_scenes.h"
#include "tests/surfaces/checked_surfaces.h"

// Scenes with many coincident faces, by every exact method, against the oracle under either rule.

namespace hsr {
namespace {

using scenes::TestScene;

/// Calls visit(scene, coplanar) for random scenes and both rules.
template <class Visit>
void for_each_scene(std::uint64_t count, const Visit& visit) {
  for (const char* family : {"triangles", "polygons", "edge_on", "boxes", "around_the_eye", "echoes"})
    for (std::uint64_t seed = 0; seed < count; ++seed) {
      const TestScene scene = scenes::with_coincident_faces(scenes::family(family).make(seed), seed);
      for (const Coplanar coplanar : {Coplanar::first, Coplanar::last}) {
        INFO(family << " " << seed << (coplanar == Coplanar::last ? ", last\n" : ", first\n") << scenes::to_text(scene));
        visit(scene, coplanar);
      }
    }
}

std::string wrong_order(const SceneView& scene, const PaintersOrder& order) {
  const Coplanar coplanar = scene.options().coplanar;
  std::string wrong;
  for (const std::string& text : oracle::wrong_with_order(scene.mesh(), scene.view(), order, coplanar)) wrong += text + "\n";
  const Verdict verdict = verify(painted_polygons(scene, order), scene.view(), {.ties = coplanar});
  if (verdict.wrong > 0) wrong += "verify finds " + std::to_string(verdict.wrong) + " pairs the wrong way round\n";
  return wrong;
}

TEST_CASE("fragments by both methods show the coincident face that the rule says", "[ties][surfaces][oracle][S8]") {
  for_each_scene(12, [](const TestScene& scene, Coplanar coplanar) { CHECK(wrong_fragments(scene, coplanar) == ""); });
}

TEST_CASE("orders paint the coincident face last that the rule says, and verify agrees", "[ties][painter][oracle][P18]") {
  std::uint64_t turned = 0;  // pairs that the other rule would turn
  for_each_scene(12, [&](const TestScene& scene, Coplanar coplanar) {
    const Mesh mesh = scene.mesh();
    const SceneView view(mesh, scene.view, {.coplanar = coplanar});
    const PaintersOrder sorted = depth_sort(view).order;
    CHECK(wrong_order(view, sorted) == "");
    CHECK(wrong_order(view, depth_sort(view, {.classic = true}).order) == "");
    CHECK(wrong_order(view, BspTree(mesh).order(view)) == "");
    const Coplanar other = coplanar == Coplanar::first ? Coplanar::last : Coplanar::first;
    turned += verify(painted_polygons(view, sorted), scene.view, {.ties = other}).wrong;
  });
  CHECK(turned > 200);
}

TEST_CASE("the caster sees the coincident face that the rule says, and so do painted orders", "[ties][caster][oracle][G7]") {
  for_each_scene(12, [](const TestScene& scene, Coplanar coplanar) {
    const Mesh mesh = scene.mesh();
    const SceneView view(mesh, scene.view, {.coplanar = coplanar});
    SampleGrid grid;
    CastImage seen;
    try {
      grid = sample_grid(scene.view, paper_rectangle(mesh, scene.view), 16, 16);
      seen = cast(view, grid);
    } catch (const std::exception&) {
      return;  // no samples: the eye is in their plane, or they are no doubles
    }
    CHECK(seen.triangles == oracle::seen_at_samples(mesh, scene.view, grid, coplanar));
    try {
      CHECK(check_order(view, depth_sort(view).order, grid).wrong == 0);
      CHECK(check_order(view, BspTree(mesh).order(view), grid).wrong == 0);
    } catch (const PreconditionError&) {
      // a corner that is not in front of the eye as the samples are
    }
  });
}

}  // namespace
}  // namespace hsr
