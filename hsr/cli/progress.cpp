#include "hsr/cli/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace hsr::cli {

namespace {

std::string duration(double seconds) {
  if (seconds < 90) return fmt::format("{:.0f} s", seconds);
  if (seconds < 5400) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

}  // namespace

ProgressLine::ProgressLine(std::string what, bool quiet)
    : what_(std::move(what)), enabled_(!quiet && isatty(STDERR_FILENO) != 0) {}

void ProgressLine::show(double done) {
  if (!enabled_) return;
  const auto now = Clock::now();
  const double spent = std::chrono::duration<double>(now - start_).count();
  if (spent < 2 || now - last_ < std::chrono::milliseconds(200)) return;
  last_ = now;
  shown_ = true;
  const std::string left = done > 0 ? ", " + duration(spent / done * (1 - done)) + " left" : "";
  fmt::print(stderr, "\r\033[K{}: {:.0f} %{}", what_, done * 100, left);
  std::fflush(stderr);
}

void ProgressLine::clear() {
  if (shown_) fmt::print(stderr, "\r\033[K");
  shown_ = false;
}

}  // namespace hsr::cli
