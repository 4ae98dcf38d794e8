#include "geometry/merge_points.h"

#include <catch2/catch.hpp>
#include <map>
#include <random>
#include <tuple>

using namespace hsr;
using namespace hsr::internal;

namespace {

/// By definition: the lowest index of an equal point.
void check_lowest(const IndexedVector<VertexId, Point3>& points) {
  std::map<std::tuple<double, double, double>, std::uint32_t> first;
  const auto merged = merge_points(points);
  REQUIRE(merged.size() == points.size());
  std::size_t wrong = 0;
  for (std::uint32_t k = 0; k < points.size(); ++k) {
    const Point3& p = points[VertexId(k)];
    wrong += merged[VertexId(k)].value == first.try_emplace({p.x, p.y, p.z}, k).first->second ? 0U : 1U;
  }
  CHECK(wrong == 0);
}

}  // namespace

TEST_CASE("Of equal points the first stands for all, few or millions", "[merge]") {
  std::mt19937 random(7);
  for (const std::size_t n : {0U, 1U, 17U, 5000U, 5000000U}) {  // the last in several shares of hashes
    INFO(n);
    IndexedVector<VertexId, Point3> points;
    for (std::size_t k = 0; k < n; ++k)
      points.push_back(
          {static_cast<double>(random() % 40), 0.1 * static_cast<double>(random() % 40), static_cast<double>(random() % 100)});
    check_lowest(points);
  }
}
