#pragma once

#include <functional>
#include <string>

namespace hsr::bench {

/// How a piece of work ended that ran in a process of its own.
struct Ended {
  enum class How { done, over_time, failed };
  How how = How::done;
  std::string bytes;  ///< done: what it returned; failed: why
};

struct Limits {
  double seconds = 300;
  double gigabytes = 0;  ///< of address space; 0: no limit
};

/// Runs `work` in a process of its own: what hangs, crashes or eats all memory there is only its own result.
/// @pre no other thread is running
Ended run_apart(const std::function<std::string()>& work, const Limits& limits);

}  // namespace hsr::bench
