#pragma once

#include <cstddef>

namespace hsr {

/// Which of coincident faces is on top.
enum class Coplanar : unsigned char {
  first,  ///< the one of the lowest index, which GL_LESS leaves visible in file order
  last,   ///< the one of the highest index, as painters lay one on the other
};

/// The one place that decides between faces that coincide: of their indices, or those of their facets or triangles.
///
///   (1) of two different numbers exactly one is above the other
///   (2) the order of `last` is that of `first` backwards
class TieRule {
 public:
  constexpr TieRule(Coplanar coplanar = Coplanar::first) : is_last_(coplanar == Coplanar::last) {}

  /// Whether a is on top of b where they coincide: it is visible, and painted later.
  template <class Index>
  constexpr bool is_above(Index a, Index b) const {
    return is_last_ ? b < a : a < b;
  }
  /// The place of what is k-th from the top among n that ascend: for methods that keep the first of equally near ones.
  constexpr std::size_t from_top(std::size_t k, std::size_t n) const { return is_last_ ? n - 1 - k : k; }

 private:
  bool is_last_;
};

}  // namespace hsr
