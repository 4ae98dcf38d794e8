#include "hsr/check/measure.h"

#include <malloc.h>

#include <cmath>
#include <fstream>
#include <string>

namespace hsr::internal {

namespace {

/// A line of /proc/self/status, in bytes.
std::size_t status(const std::string& name) {
  std::ifstream file("/proc/self/status");
  std::string line;
  while (std::getline(file, line))
    if (line.rfind(name + ":", 0) == 0) return std::stoull(line.substr(name.size() + 1)) * 1024;
  return 0;
}

}  // namespace

PeakMemory::PeakMemory() {
#ifdef __GLIBC__
  malloc_trim(0);  // or the work would use what others left
#endif
  std::ofstream file("/proc/self/clear_refs");
  is_told_ = static_cast<bool>(file << "5" << std::flush);  // the peak is forgotten
  before_ = status("VmRSS");
}

std::size_t PeakMemory::bytes() const {
  const std::size_t most = is_told_ ? status("VmHWM") : 0;
  return most > before_ ? most - before_ : 0;
}

double log_log_slope(const std::vector<double>& x, const std::vector<double>& y) {
  if (x.size() < 2) return 0;
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  const auto n = static_cast<double>(x.size());
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double u = std::log(x[k]), v = std::log(y[k]);
    sx += u;
    sy += v;
    sxx += u * u;
    sxy += u * v;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

}  // namespace hsr::internal
