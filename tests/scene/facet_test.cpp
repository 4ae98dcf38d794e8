#include "hsr/scene/facet.h"

#include <catch2/catch.hpp>
#include <type_traits>
#include <vector>

namespace hsr {
namespace {

using namespace internal;

template <class A, class B>
constexpr bool compare = requires(A a, B b) {
  a == b;
};

static_assert(compare<FacetId, FacetId> && !compare<FacetId, TriangleId> && !compare<TriangleId, FacetId>);
static_assert(!std::is_constructible_v<FacetId, TriangleId> && !std::is_constructible_v<TriangleId, FacetId>);

TEST_CASE("a planar face is one facet, and each triangle of any other is one", "[scene]") {
  const std::vector<Point3> points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 1}, {2, 1, 0}};
  Polygons polygons;
  polygons.corners = {0, 1, 2, 3, 1, 4, 5, 2};  // a square, and a quad that is not planar
  polygons.first = {0, 4, 8};
  const Mesh mesh = make_mesh(points, polygons);
  REQUIRE(mesh.triangles.size() == 4);
  std::vector<std::uint32_t> facets, counts;
  for (std::size_t t = 0; t < 4; ++t) {
    const FacetId facet = facet_of(mesh, TriangleId(t));
    facets.push_back(facet.value);
    counts.push_back(triangle_count(mesh, facet));
    CHECK(is_first(mesh, TriangleId(t)) == (first_triangle(facet) == TriangleId(t)));
    CHECK(facet_end(mesh, facet).value == facet.value + triangle_count(mesh, facet));
  }
  CHECK(facets == std::vector<std::uint32_t>{0, 0, 2, 3});
  CHECK(counts == std::vector<std::uint32_t>{2, 2, 1, 1});
}

}  // namespace
}  // namespace hsr
