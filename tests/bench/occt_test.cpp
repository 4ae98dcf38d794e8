#include <catch2/catch.hpp>

#include "bench/peers/peer.h"
#include "bench/peers/probes.h"
#include "bench/scenes.h"
#include "bench/views.h"

using hsr::bench::Answer;

TEST_CASE("OCCT sees the same lines of a scene in shells and of one in a compound", "[bench][peers]") {
  for (const char* scene : {"knot500", "city20", "rand100"})
    for (const char* view_name : {"oblique", "perspective"}) {
      CAPTURE(scene, view_name);
      const hsr::Model model = hsr::bench::scene(scene);
      const hsr::Mesh mesh = hsr::make_mesh(model.points, model.polygons);
      const hsr::View view = hsr::bench::view_of(view_name, mesh);
      const auto probes = hsr::bench::make_probes(mesh, view, 500);
      std::vector<Answer> in_shells = hsr::bench::occt_poly({model, mesh, view, probes}).answers;
      std::vector<Answer> in_compound = hsr::bench::occt_poly_compound({model, mesh, view, probes}).answers;
      const std::vector<Answer> truth = hsr::bench::truth(mesh, view, probes);
      for (std::size_t k = 0; k < truth.size(); ++k)
        if (truth[k] == Answer::none) in_shells[k] = in_compound[k] = Answer::none;
      CHECK(in_shells == truth);
      CHECK(in_compound == truth);
    }
}
