#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <vector>

#include "geometry/error.h"
#include "hsr/cli/line_arguments.h"

namespace hsr::cli {

namespace {

constexpr std::array<const char*, stage_count> stage_names = {"frame", "convex-body", "back-faces", "hidden-tiles",
                                                              "far-faces"};
constexpr std::array<const char*, 3> when_names = {"auto", "always", "never"};

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

/// Its place among the names, or their number.
template <std::size_t n>
std::size_t place(const std::array<const char*, n>& names, const std::string& name) {
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

/// ", frame, convex-body"
template <std::size_t n>
std::string listed(const std::array<const char*, n>& names) {
  std::string text;
  for (const char* name : names) text += std::string(", ") + name;
  return text;
}

EdgeClasses parse_classes(const std::string& text) {
  EdgeClasses classes{};
  if (text == "all") {
    classes.fill(true);
    return classes;
  }
  for (const std::string& name : split(text, ',')) {
    const std::size_t k = place(edge_class_names, name);
    if (k == edge_class_names.size())
      throw InputError("--edges: found \"" + name + "\", expected all" + listed(edge_class_names));
    classes[k] = true;
  }
  return classes;
}

/// One angle, or a larger and a smaller.
std::vector<double> parse_creases(const std::string& text) {
  std::vector<double> angles;
  for (const std::string& part : split(text, ',')) {
    double angle = -1;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), angle);
    if (error != std::errc() || end != part.data() + part.size() || !(angle >= 0 && angle <= 180) || angles.size() == 2)
      throw InputError("--crease: found \"" + text + "\", expected degrees from 0 to 180, or two such as 30,25");
    angles.push_back(angle);
  }
  if (angles.size() == 2 && angles[1] > angles[0])
    throw InputError("--crease: found \"" + text + "\", expected the second angle to be the smaller");
  return angles;
}

std::array<When, stage_count> parse_stages(const std::string& text) {
  std::array<When, stage_count> stages{};
  if (text.empty()) return stages;
  for (const std::string& part : split(text, ',')) {
    const std::size_t equals = std::min(part.find('='), part.size());
    const std::string name = part.substr(0, equals);
    const std::size_t when = place(when_names, equals < part.size() ? part.substr(equals + 1) : "");
    const std::size_t stage = place(stage_names, name);
    if (when == when_names.size() || (stage == stage_names.size() && name != "all"))
      throw InputError("--stages: found \"" + part +
                       "\", expected STAGE=auto, STAGE=always or STAGE=never, where STAGE is all" + listed(stage_names));
    if (name == "all")
      stages.fill(static_cast<When>(when));
    else
      stages[stage] = static_cast<When>(when);
  }
  return stages;
}

}  // namespace

LineOptions LineArguments::options() const {
  if (!(tolerance >= 0 && std::isfinite(tolerance)))
    throw InputError(fmt::format("--tolerance: found {}, expected a length of 0 or more", tolerance));
  LineOptions options;
  options.tolerance = tolerance;
  options.classes = parse_classes(edges);
  const auto creases = parse_creases(crease);
  options.crease = creases.front();
  if (creases.size() == 2) options.crease_goes_on = creases.back();
  options.method = method == "appel" ? LineMethod::appel : method == "roberts" ? LineMethod::roberts : LineMethod::automatic;
  return options;
}

SceneOptions LineArguments::scene_options() const { return {.stages = parse_stages(stages)}; }

Arithmetic arithmetic_named(const std::string& name) {
  static const std::map<std::string, Arithmetic> names = {{"staged", Arithmetic::staged},
                                                          {"double", Arithmetic::double_only},
                                                          {"interval", Arithmetic::interval},
                                                          {"rational", Arithmetic::rational}};
  return names.at(name);
}

}  // namespace hsr::cli
