#include <catch2/catch.hpp>
#include <stop_token>
#include <string>

#include "geometry/error.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/painter/sort/depth_sort.h"
#include "hsr/scene/view_parts.h"
#include "hsr/surfaces/visible_fragments.h"
#include "tests/oracle/seen_edges.h"
#include "tests/scenes/random_scenes.h"

// Whoever is asked to stop while a scene is prepared for it leaves a scene that others may ask.

namespace hsr {

using namespace internal;

namespace {

std::string lines_text(const SceneView& scene) {
  return oracle::to_text(oracle::seen_edges(scene.mesh(), scene.view(), visible_lines(scene)));
}

std::stop_token stopped() {
  std::stop_source source;
  source.request_stop();
  return source.get_token();
}

TEST_CASE("a part of a scene that is not made yet is not begun by one that is to stop", "[scene][stop]") {
  const scenes::TestScene scene = scenes::family("triangles").make(3);
  const Mesh mesh = scene.mesh();
  const SceneView view(mesh, scene.view);
  const ViewParts& parts = view.parts();
  const std::stop_token stop = stopped();
  CHECK_THROWS_AS(parts.projected(stop), CancelledError);
  parts.projected();
  CHECK_NOTHROW(parts.projected(stop));  // it is there
  CHECK_THROWS_AS(parts.bodies(stop), CancelledError);
  CHECK_THROWS_AS(parts.pyramid(stop), CancelledError);
  CHECK_THROWS_AS(parts.hidden(stop), CancelledError);
  CHECK_THROWS_AS(parts.has_edge_on(stop), CancelledError);
  CHECK_THROWS_AS(parts.occluders(Excluded::none, stop), CancelledError);
  CHECK_FALSE(parts.has_tree());
  parts.occluders(Excluded::none);
  CHECK_THROWS_AS(parts.intersections(stop), CancelledError);
  CHECK_THROWS_AS(parts.visible_intersections(stop), CancelledError);
  CHECK_THROWS_AS(parts.occluding_edges(Excluded::hidden, stop), CancelledError);
}

TEST_CASE("the search for intersections asks within itself whether it is to stop", "[scene][stop]") {
  std::size_t meeting = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const scenes::TestScene scene = scenes::family("triangles").make(seed);
    const Mesh mesh = scene.mesh();
    const SceneView view(mesh, scene.view);
    const ViewParts& parts = view.parts();
    const Occluders& occluders = parts.occluders(Excluded::none);
    const Intersections all = find_intersections(parts.projected(), occluders);
    if (all.segments.empty()) continue;
    ++meeting;
    CHECK_THROWS_AS(find_intersections(parts.projected(), occluders, nullptr, stopped()), CancelledError);
    CHECK_THROWS_AS(intersections_of(parts.projected(), meeting_faces(all), {}, stopped()), CancelledError);
  }
  CHECK(meeting > 2);
}

TEST_CASE("a scene that was stopped while it was prepared gives what a fresh one gives", "[scene][stop]") {
  for (const char* family : {"triangles", "boxes", "polygons"}) {
    const scenes::TestScene scene = scenes::family(family).make(5);
    const Mesh mesh = scene.mesh();
    const SceneView view(mesh, scene.view);
    LineOptions lines;
    FragmentOptions fragments;
    DepthSortOptions order;
    lines.stop = fragments.stop = order.stop = stopped();
    CHECK_THROWS_AS(visible_lines(view, lines), CancelledError);
    CHECK_THROWS_AS(visible_fragments(view, fragments), CancelledError);
    CHECK_THROWS_AS(depth_sort(view, order), CancelledError);
    CHECK(lines_text(view) == lines_text(SceneView(mesh, scene.view)));
  }
}

}  // namespace
}  // namespace hsr
