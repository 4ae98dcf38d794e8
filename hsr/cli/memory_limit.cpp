#include "hsr/cli/memory_limit.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <thread>

namespace hsr::cli {

namespace {

/// Bytes; 0: unknown.
rlim_t memory() {
  const long pages = sysconf(_SC_PHYS_PAGES), page = sysconf(_SC_PAGE_SIZE);
  rlim_t bytes = pages > 0 && page > 0 ? static_cast<rlim_t>(pages) * static_cast<rlim_t>(page) : 0;
  rlim_t of_group = 0;  // "max" is no number
  if (std::ifstream("/sys/fs/cgroup/memory.max") >> of_group && of_group > 0)
    bytes = bytes == 0 ? of_group : std::min(bytes, of_group);
  return bytes;
}

std::optional<rlim_t> data_limit() {
  rlimit limit{};
  if (getrlimit(RLIMIT_DATA, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return {};
  return limit.rlim_cur;
}

}  // namespace

void limit_memory_to_what_there_is() {
#ifndef __SANITIZE_ADDRESS__  // its shadow memory is larger than any machine's
  // Stacks are counted whole, though little of them is used.
  constexpr rlim_t stack = 16U << 20U;
  const rlim_t bytes = memory();
  rlimit limit{};
  if (bytes == 0 || getrlimit(RLIMIT_DATA, &limit) != 0) return;
  limit.rlim_cur = std::min(limit.rlim_cur, bytes + stack * std::max(1U, std::thread::hardware_concurrency()));
  setrlimit(RLIMIT_DATA, &limit);
#endif
}

std::string out_of_memory() {
  const auto limit = data_limit();
  const std::string bound = limit ? fmt::format(", limit {:.1f} GB", static_cast<double>(*limit) / 1e9) : "";
  return "out of memory" + bound +
         ": the scene does not fit, expected fewer faces (a million triangles take 0.2 to 0.6 GB, drawn with --edges all and "
         "hidden "
         "lines 1 GB)";
}

}  // namespace hsr::cli
