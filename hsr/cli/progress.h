#pragma once

#include <chrono>
#include <string>

namespace hsr::cli {

/// One line on a terminal's standard error that tells how far a long work is: from two seconds on, with the time left.
/// Nothing where standard error is no terminal, or when quiet. Called from one thread at a time.
class ProgressLine {
 public:
  ProgressLine(std::string what, bool quiet);
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(double done);
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  std::string what_;
  bool enabled_, shown_ = false;
  Clock::time_point start_ = Clock::now(), last_ = start_;
};

}  // namespace hsr::cli
