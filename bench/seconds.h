#pragma once

#include <chrono>
#include <ctime>
#include <vector>

namespace hsr::bench {

/// Median and half the range of a few seconds; zeros of none.
struct Seconds {
  double median = 0, spread = 0;
};

Seconds seconds(std::vector<double> times);

/// What a piece of work took by the clock and, of all threads together, on the processors: other work on the machine disturbs
/// the second far less.
struct Elapsed {
  double clock = 0, processor = 0;
};

template <class Work>
Elapsed elapsed(Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t processor_start = std::clock();
  work();
  const std::clock_t processor_end = std::clock();
  return {std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
          static_cast<double>(processor_end - processor_start) / CLOCKS_PER_SEC};
}

/// A few of them.
struct Times {
  std::vector<double> clock, processor;

  void add(const Elapsed& one) {
    clock.push_back(one.clock);
    processor.push_back(one.processor);
  }
};

}  // namespace hsr::bench
