#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace hsr::internal {

/// Two polygons the first of which has to be painted earlier than the second.
struct Precedence {
  std::uint32_t first, second;
};

/// What the precedences of n polygons say of all orders. Its own code: it judges what the sorters' graph code has done.
struct OrderWitness {
  std::vector<std::vector<std::uint32_t>> components;  ///< each ascending: polygons that are all in cycles with one another
  std::vector<std::uint32_t> cycle;                    ///< precedences, by number, head to tail; empty: an order exists
};

/// The cycle is as short as there is one, of those through the polygons that fit into a hundred million steps of search (else
/// the shortest through those). Never recursive. Cost: O(n + precedences), and the search. Source: Tarjan 1972 for the
/// components.
OrderWitness order_witness(std::uint32_t polygons, const std::vector<Precedence>& all);

}  // namespace hsr::internal
