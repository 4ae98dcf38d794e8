#include <catch2/catch.hpp>

#include "bench/peers/peer.h"
#include "bench/peers/probes.h"
#include "bench/scenes.h"
#include "bench/views.h"

using hsr::bench::Answer;

TEST_CASE("Blender's Line Art is asked for the scene that hsr sees", "[bench][peers][long]") {
  if (!hsr::bench::has_line_art()) {
    WARN("Blender is missing: Line Art is not tested");
    return;
  }
  for (const char* view_name : {"oblique", "perspective"}) {
    CAPTURE(view_name);
    const hsr::Model model = hsr::bench::scene("city20");
    const hsr::Mesh mesh = hsr::make_mesh(model.points, model.polygons);
    const hsr::View view = hsr::bench::view_of(view_name, mesh);
    const auto probes = hsr::bench::make_probes(mesh, view, 1000);
    const hsr::bench::Result result = hsr::bench::line_art({model, mesh, view, probes});
    CHECK(result.compute.clock > 0);
    const std::vector<Answer> truth = hsr::bench::truth(mesh, view, probes);
    std::size_t asked = 0, wrong = 0, visible = 0;
    for (std::size_t k = 0; k < truth.size(); ++k) {
      if (truth[k] == Answer::none || result.answers[k] == Answer::none) continue;
      ++asked;
      if (truth[k] != result.answers[k]) ++wrong;
      if (result.answers[k] == Answer::visible) ++visible;
    }
    // A camera that is off, or a scale, would show nothing in its place.
    CHECK(asked > 500);
    CHECK(visible > 100);
    CHECK(wrong < asked / 50);
  }
}
