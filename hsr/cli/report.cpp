#include "hsr/cli/report.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>

namespace hsr::cli {

void Report::add_seconds(const std::string& stage, double seconds) {
  const auto found = std::find_if(seconds_.begin(), seconds_.end(), [&](const auto& s) { return s.first == stage; });
  auto& entry = found == seconds_.end() ? seconds_.emplace_back(stage, 0.0) : *found;
  entry.second = std::round((entry.second + seconds) * 1e6) / 1e6;
}

void Report::leave_out(const std::string& stage, const std::string& why) {
  if (left_out_.is_empty()) json_.set("left_out", Json());  // its place in the file is that of the first
  left_out_.push_back({{"stage", stage}, {"why", why}});
}

void Report::set_decisions(const DecisionCounts& c) {
  json_.set("decisions", {{"filter", c.filter}, {"interval", c.interval}, {"exact", c.exact()}, {"zero", c.zero}});
}

std::string Report::text() {
  Json seconds(std::initializer_list<Json::Member>{});
  for (const auto& [stage, spent] : seconds_) seconds.set(stage, spent);
  json_.set("seconds", std::move(seconds));
  json_.set("left_out", left_out_);
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  json_.set("memory_mb", std::round(static_cast<double>(usage.ru_maxrss) / 1024 * 10) / 10);
  return json_.text() + "\n";
}

}  // namespace hsr::cli
