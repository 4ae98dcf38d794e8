#pragma once

#include <cstdint>

namespace hsr {

/// Two doubles that are computed with at once, with the operators of one (vectors of GCC and Clang).
using TwoDoubles = double __attribute__((vector_size(16)));
/// What comparing them gives: all bits set where it holds.
using TwoTruths = std::int64_t __attribute__((vector_size(16)));

inline TwoDoubles absolute(const TwoDoubles& x) {
  constexpr TwoTruths magnitude = {0x7fffffffffffffff, 0x7fffffffffffffff};
  return reinterpret_cast<TwoDoubles>(reinterpret_cast<TwoTruths>(x) & magnitude);
}
inline bool both(const TwoTruths& x) { return (x[0] & x[1]) != 0; }

}  // namespace hsr
