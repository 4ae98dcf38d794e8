#include <catch2/catch.hpp>

#include "geometry/error.h"
#include "geometry/mesh.h"

namespace hsr {

namespace {

std::vector<std::uint32_t> merged(const std::vector<Point3>& points, double tolerance) {
  Polygons polygons;
  polygons.segments = {{0, 1}};
  const Mesh mesh = make_mesh(points, polygons, tolerance);
  std::vector<std::uint32_t> all;
  for (const VertexId v : mesh.merged) all.push_back(v.value);
  return all;
}

TEST_CASE("points within a tolerance are one, that of the lowest index", "[geometry][mesh][T3]") {
  const std::vector<Point3> points = {{0, 0, 0}, {5, 0, 0}, {0.75, 0, 0}, {5, 0, -0.5}, {-0.75, 0.0, 0}, {0, 9, 0}, {5, 0, 0}};
  CHECK(merged(points, 0) == std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 1});
  CHECK(merged(points, 0.5) == std::vector<std::uint32_t>{0, 1, 2, 1, 4, 5, 1});
  CHECK(merged(points, 1) == std::vector<std::uint32_t>{0, 1, 0, 1, 0, 5, 1});
}

TEST_CASE("a cluster wider than twice the tolerance is refused", "[geometry][mesh][T4]") {
  const std::vector<Point3> chain = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  CHECK_THROWS_AS(merged(chain, 1), InputError);
  CHECK_NOTHROW(merged({chain.begin(), chain.begin() + 3}, 1));
  CHECK_NOTHROW(merged(chain, 0.5));
}

}  // namespace
}  // namespace hsr
