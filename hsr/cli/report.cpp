#include "hsr/cli/report.h"

#include <sys/resource.h>

#include <cmath>

namespace hsr::cli {

void Report::add_seconds(const std::string& stage, double seconds) {
  Json& entry = json_["seconds"][stage];
  const double before = entry.is_number() ? entry.get<double>() : 0;
  entry = std::round((before + seconds) * 1e6) / 1e6;
}

void Report::leave_out(const std::string& stage, const std::string& why) {
  json_["left_out"].push_back({{"stage", stage}, {"why", why}});
}

void Report::set_decisions(const DecisionCounts& c) {
  json_["decisions"] = {{"filter", c.filter}, {"interval", c.interval}, {"exact", c.exact()}, {"zero", c.zero}};
}

std::string Report::text() {
  if (!json_.contains("left_out")) json_["left_out"] = Json::array();
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  json_["memory_mb"] = std::round(static_cast<double>(usage.ru_maxrss) / 1024 * 10) / 10;
  return json_.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace hsr::cli
