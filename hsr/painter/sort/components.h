#pragma once

#include <cstdint>
#include <vector>

#include "geometry/ragged.h"

namespace hsr::internal {

/// A directed graph: to which nodes each node leads.
using Graph = Ragged<std::uint32_t>;

/// @param for_each_edge calls its argument with (from, to) for each edge, and does so twice
template <class F>
Graph make_graph(std::size_t nodes, const F& for_each_edge) {
  Graph graph;
  graph.assign(nodes, for_each_edge);
  return graph;
}

/// The nodes in an order in which each comes before all that it leads to; those in cycles, and what only they lead to, are left
/// out. Of several that may come next, the one that could first. Cost: O(nodes + edges). Source: Kahn 1962.
std::vector<std::uint32_t> topological_order(const Graph& graph);

/// The strongly connected components of more than one node, each ascending. Never recursive. Cost: O(nodes + edges).
/// Source: Tarjan 1972.
std::vector<std::vector<std::uint32_t>> cyclic_components(const Graph& graph);

/// Cycles that share no node: through each of the nodes in turn, if none has it yet, one as short as the others leave. The
/// first node has one if there is any; the search for others ends after a few times as many edges as there are. Cost: O(nodes +
/// edges).
std::vector<std::vector<std::uint32_t>> disjoint_cycles(const Graph& graph, const std::vector<std::uint32_t>& nodes);

}  // namespace hsr::internal
