#include "hsr/painter/sort/components.h"

#include <catch2/catch.hpp>

namespace hsr {

using namespace internal;

namespace {

using Nodes = std::vector<std::uint32_t>;

Graph graph(const std::vector<Nodes>& targets) {
  Graph g;
  for (const Nodes& t : targets) {
    for (const std::uint32_t node : t) g.push_back(node);
    g.end_row();
  }
  return g;
}

TEST_CASE("an order of a graph, its cycles, and the shortest of them", "[painter][components]") {
  CHECK(topological_order(graph({{1, 2}, {3}, {3}, {}})) == Nodes{0, 1, 2, 3});
  CHECK(topological_order(graph({{}, {0}, {1}})) == Nodes{2, 1, 0});
  CHECK(cyclic_components(graph({{1}, {2}, {}})).empty());
  const Graph two = graph({{1}, {2}, {0, 3}, {4}, {5}, {3}, {0}});
  CHECK(cyclic_components(two) == std::vector<Nodes>{{3, 4, 5}, {0, 1, 2}});
  CHECK(topological_order(two) == Nodes{6});
  CHECK(disjoint_cycles(two, {0}) == std::vector<Nodes>{{0, 1, 2}});
  CHECK(disjoint_cycles(two, {6}).empty());
  CHECK(disjoint_cycles(graph({{1}, {2, 3}, {3}, {0}}), {0}) == std::vector<Nodes>{{0, 1, 3}});
  CHECK(disjoint_cycles(two, {3, 4, 6, 1}) == std::vector<Nodes>{{3, 4, 5}, {1, 2, 0}});
}

TEST_CASE("a chain of a million nodes is no depth to recurse to", "[painter][components]") {
  Graph chain;
  constexpr std::uint32_t n = 1'000'000;
  for (std::uint32_t k = 0; k < n; ++k) {
    chain.push_back((k + 1) % n);
    chain.end_row();
  }
  const auto found = cyclic_components(chain);
  REQUIRE(found.size() == 1);
  CHECK(found.front().size() == n);
  CHECK(topological_order(chain).empty());
}

}  // namespace
}  // namespace hsr
