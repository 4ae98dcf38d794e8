#pragma once

#include <chrono>
#include <nlohmann/json.hpp>
#include <string>

#include "geometry/predicates.h"

namespace hsr::cli {

/// Collects "hsr-report/1" while a command runs.
class Report {
 public:
  using Json = nlohmann::ordered_json;

  Report() : json_{{"format", "hsr-report/1"}, {"seconds", Json::object()}} {}

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
    const Stopwatch stopwatch{*this, stage};
    return work();
  }

  Json& operator[](const std::string& key) { return json_[key]; }
  void add_seconds(const std::string& stage, double seconds);
  void leave_out(const std::string& stage, const std::string& why);
  void set_decisions(const DecisionCounts& counts);

  /// The whole text, with the peak memory of the process so far.
  std::string text();

 private:
  Json json_;
};

}  // namespace hsr::cli
