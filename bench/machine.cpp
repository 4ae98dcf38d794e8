#include "bench/machine.h"

#include <fmt/format.h>

#include <ctime>
#include <fstream>
#include <thread>

namespace hsr::bench {

namespace {

/// What follows `name` and a colon in a file of /proc.
std::string entry(const char* file, const std::string& name) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (line.rfind(name, 0) != 0) continue;
    const std::size_t start = line.find_first_not_of(" \t:", line.find(':'));
    if (start != std::string::npos) return line.substr(start);
  }
  return "unknown";
}

}  // namespace

std::string machine() {
  const std::time_t now = std::time(nullptr);
  char date[32] = "";
  std::strftime(date, sizeof date, "%Y-%m-%d", std::localtime(&now));
  double load = 0;
  std::ifstream("/proc/loadavg") >> load;
  const double kilobytes = std::strtod(entry("/proc/meminfo", "MemTotal").c_str(), nullptr);
  return fmt::format("{}: {}, {} processors, {:.0f} GB, {}; load {:.1f} before the start", date,
                     entry("/proc/cpuinfo", "model name"), std::thread::hardware_concurrency(), kilobytes / 1e6,
#ifdef __clang__
                     "clang " __clang_version__,
#else
                     "g++ " __VERSION__,
#endif
                     load);
}

}  // namespace hsr::bench
