#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace hsr::internal {

/// Calls visit(i) for each i in [0, n), in parallel.
template <class F>
void parallel_for_each(std::size_t n, const F& visit) {
  using Range = tbb::blocked_range<std::size_t>;
  tbb::parallel_for(Range(0, n, 1024), [&](const Range& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) visit(i);
  });
}

/// Visits [0, n) in blocks in parallel, visit(begin, end, part), and joins what each block appends to its part, in order: the
/// same for any number of threads.
template <class T, class F>
std::vector<T> parallel_collect(std::size_t n, const F& visit) {
  constexpr std::size_t block = 4096;
  using Range = tbb::blocked_range<std::size_t>;
  std::vector<std::vector<T>> parts((n + block - 1) / block);
  tbb::parallel_for(Range(0, parts.size(), 1), [&](const Range& range) {
    for (std::size_t k = range.begin(); k < range.end(); ++k) visit(k * block, std::min(n, (k + 1) * block), parts[k]);
  });
  std::vector<std::size_t> first(parts.size() + 1, 0);
  for (std::size_t k = 0; k < parts.size(); ++k) first[k + 1] = first[k] + parts[k].size();
  std::vector<T> all(first.back());
  tbb::parallel_for(Range(0, parts.size(), 1), [&](const Range& range) {
    for (std::size_t k = range.begin(); k < range.end(); ++k)
      std::copy(parts[k].begin(), parts[k].end(), all.begin() + static_cast<std::ptrdiff_t>(first[k]));
  });
  return all;
}

}  // namespace hsr::internal
