#include "geometry/weighted_disjoint_sets.h"

#include <tbb/parallel_for.h>

#include <catch2/catch.hpp>
#include <random>

namespace hsr {

using namespace internal;

namespace {

TEST_CASE("a relative count follows from a chain of others, and a contradiction is told", "[lines][appel]") {
  WeightedDisjointSets counts(5);
  REQUIRE(counts.join(3, 4, 2));
  REQUIRE(counts.join(4, 1, -5));
  REQUIRE(counts.find(4).root == 1);
  REQUIRE(counts.find(4).above == 5);
  REQUIRE(counts.find(3).above == 3);
  REQUIRE(counts.find(0).root == 0);
  REQUIRE(counts.join(1, 3, 3));
  REQUIRE_FALSE(counts.join(1, 3, 4));
}

TEST_CASE("relative counts do not depend on the order of joins that agree, nor on threads", "[lines][appel][property]") {
  constexpr std::uint32_t n = 20000;
  std::mt19937 random(7);
  std::vector<std::int32_t> count(n);
  for (auto& c : count) c = static_cast<std::int32_t>(random() % 100);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> joins(n);
  for (auto& [a, b] : joins) {
    a = random() % n;
    b = random() % n;
  }
  WeightedDisjointSets forth(n), back(n), together(n);
  const auto join = [&](WeightedDisjointSets& counts, std::size_t k) {
    const auto [a, b] = joins[k];
    return counts.join(a, b, count[b] - count[a]);
  };
  for (std::size_t k = 0; k < n; ++k) REQUIRE(join(forth, k));
  for (std::size_t k = n; k-- > 0;) REQUIRE(join(back, k));
  tbb::parallel_for(std::size_t{0}, std::size_t{n}, [&](std::size_t k) { join(together, k); });
  for (std::uint32_t k = 0; k < n; ++k) {
    const auto [root, above] = forth.find(k);
    REQUIRE(root <= k);
    REQUIRE(above == count[k] - count[root]);
    for (WeightedDisjointSets* other : {&back, &together}) {
      REQUIRE(other->find(k).root == root);
      REQUIRE(other->find(k).above == above);
    }
  }
}

}  // namespace
}  // namespace hsr
