#include "hsr/cli/progress.h"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>

#include "hsr/cli/messages.h"

namespace hsr::cli {

namespace {

std::string duration(double seconds) {
  if (seconds < 90) return fmt::format("{:.0f} s", seconds);
  if (seconds < 5400) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

double seconds_since(std::chrono::steady_clock::time_point t) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - t).count();
}

}  // namespace

ProgressLine::ProgressLine(bool quiet) {
  if (quiet || isatty(STDERR_FILENO) == 0) return;
  ticker_ = std::thread([this] {
    std::unique_lock lock(mutex_);
    while (!stopped_) {
      wake_.wait_for(lock, std::chrono::milliseconds(250));
      if (!stopped_ && seconds_since(start_) > 2) print();
    }
  });
}

ProgressLine::~ProgressLine() {
  if (!ticker_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
  }
  wake_.notify_one();
  ticker_.join();
  clear();
}

void ProgressLine::stage(const std::string& name) {
  const std::lock_guard lock(mutex_);
  stage_ = name;
  done_ = 0;
  stage_start_ = Clock::now();
}

void ProgressLine::show(const std::string& name, double done) {
  if (name != stage_) stage(name);
  show(done);
}

void ProgressLine::print() {
  const double spent = seconds_since(stage_start_), done = done_;
  if (done > 0)
    tell("\r\033[K{}: {:.0f} %, {} left", stage_, done * 100, duration(spent / done * (1 - done)));
  else
    tell("\r\033[K{}: {} so far", stage_, duration(spent));
  std::fflush(stderr);
  shown_ = true;
}

void ProgressLine::clear() {
  const std::lock_guard lock(mutex_);
  if (shown_) tell("\r\033[K");
  shown_ = false;
}

}  // namespace hsr::cli
