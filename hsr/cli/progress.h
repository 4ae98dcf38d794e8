#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace hsr::cli {

/// One line on a terminal's standard error that tells how far a long work is: from two seconds on, which stage runs, and the
/// time it has left where that can be told. Nothing where standard error is no terminal, or when quiet.
class ProgressLine {
 public:
  explicit ProgressLine(bool quiet);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// From now on this is what runs.
  void stage(const std::string& name);
  /// The share of the stage that is done, 0 ... 1. Any thread.
  void show(double done) { done_ = done; }
  /// The share that is done of the stage with this name, which is begun if another one runs.
  void show(const std::string& name, double done);
  /// Removes the line, to print something else.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  void print();

  bool stopped_ = false, shown_ = false;
  std::string stage_;
  std::atomic<double> done_ = 0;
  Clock::time_point start_ = Clock::now(), stage_start_ = start_;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::thread ticker_;
};

}  // namespace hsr::cli
