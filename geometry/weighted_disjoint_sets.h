#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace hsr::internal {

/// Counts that are known only relative to one another: disjoint sets in which each member knows how far it lies above the one
/// that stands for its set, the least of it (weighted union, Tarjan 1975).
///
/// Threads may join and find at the same time (as Anderson and Woll 1991): a member and its distance change together, as one
/// word, and only what is a root still is hung on another, lesser one. Whatever is ever stored for a member is some ancestor of
/// it, with the true distance; so it does no harm that a late thread may store an older one again. Where no two joins
/// contradict each other the sets and the distances do not depend on their order.
class WeightedDisjointSets {
 public:
  struct alignas(8) Place {
    std::uint32_t root;
    std::int32_t above;
  };

  explicit WeightedDisjointSets(std::size_t n) : places_(n) {
    for (std::size_t k = 0; k < n; ++k) places_[k] = {static_cast<std::uint32_t>(k), 0};
  }

  /// The root of k's set, and how far k lies above it.
  Place find(std::uint32_t k) {
    std::int32_t above = 0;
    while (true) {
      Place own = load(k);
      if (own.root == k) return {k, above};
      const Place next = load(own.root);
      if (next.root != own.root) {  // path halving
        own = {next.root, own.above + next.above};
        std::atomic_ref(places_[k]).store(own, std::memory_order_relaxed);
      }
      above += own.above;
      k = own.root;
    }
  }

  /// Says count(b) - count(a) = difference. False: it is known to be another.
  bool join(std::uint32_t a, std::uint32_t b, std::int32_t difference) {
    while (true) {
      const Place p = find(a), q = find(b);
      const std::int32_t of_roots = p.above + difference - q.above;  // count(q.root) - count(p.root)
      if (p.root == q.root) return of_roots == 0;
      if (p.root < q.root ? hang(q.root, {p.root, of_roots}) : hang(p.root, {q.root, -of_roots})) return true;
    }
  }

 private:
  Place load(std::uint32_t k) { return std::atomic_ref(places_[k]).load(std::memory_order_relaxed); }
  /// False: it is no root any more.
  bool hang(std::uint32_t root, Place place) {
    Place expected = {root, 0};
    return std::atomic_ref(places_[root]).compare_exchange_strong(expected, place, std::memory_order_relaxed);
  }

  std::vector<Place> places_;  // of each member: one above it in its tree, or itself
};

}  // namespace hsr::internal
