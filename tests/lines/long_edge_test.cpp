#include <catch2/catch.hpp>
#include <cmath>

#include "hsr/lines/visible_lines.h"

using namespace hsr;

namespace {

/// One wire behind a fence of `posts` separate quads, seen from the front.
Mesh fence(std::uint32_t posts) {
  std::vector<Point3> points = {{-1, 1, 0.5}, {2.0 * posts, 1, 0.5}};
  Polygons polygons;
  polygons.segments.push_back({0, 1});
  for (std::uint32_t i = 0; i < posts; ++i) {
    const auto at = static_cast<std::uint32_t>(points.size());
    const double x = 2.0 * ((i * 7919ULL) % posts);  // posts in no order along the wire
    for (const Point3& p : {Point3{x, 0, 0}, Point3{x + 1, 0, 0}, Point3{x + 1, 0, 1}, Point3{x, 0, 1}}) points.push_back(p);
    for (std::uint32_t k = 0; k < 4; ++k) polygons.corners.push_back(at + k);
    polygons.first.push_back(static_cast<std::uint32_t>(polygons.corners.size()));
  }
  return make_mesh(points, polygons);
}

}  // namespace

TEST_CASE("an edge behind many separate faces costs no more than sorting them", "[lines][cost]") {
  for (const bool why : {false, true}) {
    const std::uint32_t posts = 4096;
    const Mesh mesh = fence(posts);
    LineOptions options;
    options.method = LineMethod::roberts;
    options.classes = {false, false, false, false, true, false};
    options.why = why;
    const VisibleLines lines = visible_lines(mesh, named_view("front"), options);
    REQUIRE(lines.lines.size() == 1);
    CHECK(lines.lines[0].intervals() == 2 * posts + 1);
    CHECK(lines.occluders.size() == (why ? posts : 0));
    const DecisionCounts& n = lines.decisions;
    // 12 = log2 of the posts; each shadow takes a few dozen signs, and part in a few sorts
    CHECK(static_cast<double>(n.all()) < 20.0 * posts * 12);
  }
}
