#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace hsr::internal {

/// Disjoint sets of the numbers 0 ... n - 1, joined two at a time; the least member stands for each (Tarjan 1975).
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n = 0) { reset(n); }
  /// Each of 0 ... n - 1 alone again.
  void reset(std::size_t n) {
    parent_.resize(n);
    std::iota(parent_.begin(), parent_.end(), 0U);
  }
  std::size_t size() const { return parent_.size(); }
  std::uint32_t find(std::uint32_t k) {
    while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
    return k;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace hsr::internal
