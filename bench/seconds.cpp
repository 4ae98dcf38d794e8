#include "bench/seconds.h"

#include <algorithm>

namespace hsr::bench {

Seconds seconds(std::vector<double> times) {
  if (times.empty()) return {};
  std::sort(times.begin(), times.end());
  const std::size_t middle = times.size() / 2;
  const double median = times.size() % 2 == 1 ? times[middle] : (times[middle - 1] + times[middle]) / 2;
  return {median, (times.back() - times.front()) / 2};
}

}  // namespace hsr::bench
