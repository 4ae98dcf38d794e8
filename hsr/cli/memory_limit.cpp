#include "hsr/cli/memory_limit.h"

#include <fmt/format.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <sys/resource.h>
#include <sys/sysinfo.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <thread>

namespace hsr::cli {

namespace {

constexpr rlim_t unknown = RLIM_INFINITY;

/// The number in a file, or unknown.
rlim_t number_in(const std::string& path) {
  rlim_t bytes = 0;
  return std::ifstream(path) >> bytes && bytes > 0 ? bytes : unknown;  // "max" is no number
}

/// The least limit of a control group and of those it is in; `file` says it.
rlim_t limit_of_group(const std::string& root, std::string group, const std::string& file) {
  rlim_t least = unknown;
  while (true) {
    least = std::min(least, number_in(std::string(root).append(group).append("/").append(file)));
    const std::size_t slash = group.rfind('/');
    if (slash == std::string::npos) return least;
    group.resize(slash);
  }
}

/// What this process may use: memory and swap of the machine, or of its control group (versions 1 and 2).
rlim_t memory() {
  struct sysinfo info {};
  rlim_t least = unknown;
  if (sysinfo(&info) == 0) least = (static_cast<rlim_t>(info.totalram) + info.totalswap) * info.mem_unit;
  // Lines such as 0::/user.slice and 4:memory:/docker/1a2b.
  std::ifstream groups("/proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (first == std::string::npos || second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1), group = line.substr(second + 1);
    if (controllers.empty()) least = std::min(least, limit_of_group("/sys/fs/cgroup", group, "memory.max"));
    if (controllers == "memory")
      least = std::min(least, limit_of_group("/sys/fs/cgroup/memory", group, "memory.limit_in_bytes"));
  }
  return least;
}

/// The least of the limits that make an allocation fail.
rlim_t allocation_limit() {
  rlim_t least = unknown;
  for (const auto resource : {RLIMIT_DATA, RLIMIT_AS}) {
    rlimit limit{};
    if (getrlimit(resource, &limit) == 0) least = std::min(least, limit.rlim_cur);
  }
  return least;
}

}  // namespace

void limit_memory_to_what_there_is() {
#ifdef __SANITIZE_ADDRESS__
  constexpr bool limits = false;  // its shadow memory is larger than any machine's
#else
  constexpr bool limits = true;
#endif
  // Stacks are counted whole, though little of them is used.
  constexpr rlim_t stack = 16U << 20U;
  const rlim_t bytes = memory();
  rlimit limit{};
  if (!limits || bytes == unknown || getrlimit(RLIMIT_DATA, &limit) != 0) return;
  limit.rlim_cur = std::min(limit.rlim_cur, bytes + stack * std::max(1U, std::thread::hardware_concurrency()));
  setrlimit(RLIMIT_DATA, &limit);
}

void keep_freed_memory() {
#ifdef __GLIBC__
  mallopt(M_MMAP_MAX, 0);  // large arrays of their own mapping would be given back at once
  mallopt(M_TRIM_THRESHOLD, -1);
#endif
}

std::string out_of_memory() {
  const rlim_t limit = allocation_limit();
  return "out of memory" + (limit == unknown ? "" : fmt::format(", limit {:.1f} GB", static_cast<double>(limit) / 1e9)) +
         ": the scene does not fit, expected fewer faces (a million triangles take 0.2 to 0.6 GB, all edges drawn with hidden "
         "lines 1 GB)";
}

}  // namespace hsr::cli
