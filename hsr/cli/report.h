#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include "geometry/predicates.h"
#include "hsr/cli/json_value.h"

namespace hsr::cli {

/// Collects "hsr-report/1" while a command runs.
class Report {
 public:
  using Json = JsonValue;

  Report() : json_{{"format", "hsr-report/1"}, {"seconds", Json()}} {}

  /// Runs `work`, adds its wall time to the stage, and returns what it returns.
  template <class Work>
  auto timed(const std::string& stage, Work&& work) {
    struct Stopwatch {
      Report& report;
      const std::string& stage;
      std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
      ~Stopwatch() {
        report.add_seconds(stage, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
      }
    };
    add_seconds(stage, 0);  // takes the memory for it, as nothing may be thrown at the end
    const Stopwatch stopwatch{*this, stage};
    return work();
  }

  /// Adds a member, or replaces it.
  void set(const std::string& key, Json value) { json_.set(key, std::move(value)); }
  void add_seconds(const std::string& stage, double seconds);
  void leave_out(const std::string& stage, const std::string& why);
  void set_decisions(const DecisionCounts& counts);

  /// The whole text, with the peak memory of the process so far.
  std::string text();

 private:
  Json json_;
  std::vector<std::pair<std::string, double>> seconds_;
  Json left_out_ = Json::array();
};

}  // namespace hsr::cli
