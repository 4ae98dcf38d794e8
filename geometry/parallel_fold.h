#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <cstddef>
#include <utility>

namespace hsr::internal {

/// What add(all, i) makes of `none` for each i in [0, n), in blocks in parallel; join(all, more) adds the blocks to one another, in
/// order. @pre joining is associative, exactly: then the result is the same for any number of threads
template <class T, class Add, class Join>
T parallel_fold(std::size_t n, const T& none, const Add& add, const Join& join) {
  using Range = tbb::blocked_range<std::size_t>;
  constexpr std::size_t block = 4096;
  const auto fold = [&](const Range& range, T all) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) add(all, i);
    return all;
  };
  if (n <= block) return fold(Range(0, n), none);
  return tbb::parallel_reduce(Range(0, n, block), none, fold, [&](T all, const T& more) {
    join(all, more);
    return all;
  });
}

}  // namespace hsr::internal
