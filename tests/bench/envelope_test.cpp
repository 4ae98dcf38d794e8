#include "bench/peers/envelope.h"

#include <catch2/catch.hpp>

#include "hsr/surfaces/visible_fragments.h"
#include "tests/scenes/random_scenes.h"

namespace hsr {
namespace {

TEST_CASE("fragments have the areas that CGAL's envelope finds", "[peers][surfaces]") {
  int compared = 0;
  for (const char* name : {"triangles", "polygons", "stacks", "slopes", "boxes", "echoes"})
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      const scenes::TestScene scene = scenes::family(name).make(seed);
      if (scene.view.is_perspective()) continue;
      const Mesh mesh = scene.mesh();
      const VisibleFragments found = visible_fragments(mesh, scene.view);
      const std::vector<Rational> of_fragment = visible_areas(mesh, scene.view, found);
      std::vector<Rational> areas(mesh.triangles.size()), expected(mesh.triangles.size());
      for (std::size_t k = 0; k < of_fragment.size(); ++k) {
        Rational& a = areas[found.fragments[k].facet.value];
        a = a + of_fragment[k];
      }
      const bench::Envelope peer = bench::envelope(mesh, scene.view, true);
      for (std::size_t t = 0; t < areas.size(); ++t) {
        const FaceId f = mesh.face_of[TriangleId(t)];
        Rational& a = expected[mesh.faces[f] == FaceUse::planar ? mesh.first_triangle[f] : t];
        a = a + peer.areas[t];
      }
      INFO(name << " " << seed);
      CHECK(areas == expected);
      ++compared;
    }
  CHECK(compared > 20);
}

}  // namespace
}  // namespace hsr
