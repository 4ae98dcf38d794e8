#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <vector>

namespace hsr::internal {

/// How long a piece of work takes by the clock, in seconds.
template <class Work>
double seconds_of(const Work& work) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  work();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Ascending, so that the middle one is the median.
template <class Work>
std::vector<double> seconds_of_runs(int runs, const Work& work) {
  std::vector<double> all;
  for (int r = 0; r < runs; ++r) all.push_back(seconds_of(work));
  std::sort(all.begin(), all.end());
  return all;
}

/// How much memory the process takes at most while a piece of work runs, beyond what it had before. Where the system does not
/// tell (it is asked by /proc/self): 0.
class PeakMemory {
 public:
  PeakMemory();
  std::size_t bytes() const;

 private:
  bool is_told_ = false;
  std::size_t before_ = 0;
};

/// The exponent b of y = a x^b, by least squares of logarithms. @pre positive numbers; fewer than two: 0
double log_log_slope(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace hsr::internal
