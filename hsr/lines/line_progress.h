#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <mutex>
#include <stop_token>

#include "geometry/cancel.h"

namespace hsr::internal {

/// Calls the progress function from one thread at a time, each time another hundredth is done, and ends the work where a stop is
/// asked for.
class LineProgress {
 public:
  /// @throws CancelledError if a stop is asked for already
  LineProgress(const std::function<void(double)>& report, const std::stop_token& stop, std::size_t total)
      : report_(report), stop_(stop), total_(total) {
    throw_if_stopped(stop_);
  }

  /// @throws CancelledError if a stop is asked for
  void advance(std::size_t n) {
    throw_if_stopped(stop_);
    if (!report_) return;
    const std::size_t before = done_.fetch_add(n), after = before + n;
    if (before * 100 / total_ == after * 100 / total_) return;
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (lock) report_(static_cast<double>(after) / static_cast<double>(total_));
  }

 private:
  const std::function<void(double)>& report_;
  const std::stop_token& stop_;
  std::size_t total_;
  std::atomic<std::size_t> done_{0};
  std::mutex mutex_;
};

}  // namespace hsr::internal
