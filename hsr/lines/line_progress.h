#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <mutex>

namespace hsr::internal {

/// Calls the progress function from one thread at a time, each time another hundredth is done.
class LineProgress {
 public:
  LineProgress(const std::function<void(double)>& report, std::size_t total) : report_(report), total_(total) {}

  void advance(std::size_t n) {
    if (!report_) return;
    const std::size_t before = done_.fetch_add(n), after = before + n;
    if (before * 100 / total_ == after * 100 / total_) return;
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (lock) report_(static_cast<double>(after) / static_cast<double>(total_));
  }

 private:
  const std::function<void(double)>& report_;
  std::size_t total_;
  std::atomic<std::size_t> done_{0};
  std::mutex mutex_;
};

}  // namespace hsr::internal
