#include "tests/study/traces.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstddef>

namespace hsr::internal {

Ended ended(const Json& run) {
  Ended end;
  std::map<int, int> face_of;
  for (const Json& step : run["steps"]) {
    for (const Json& change : step.value("changes", Json::array())) {
      const std::string what = change["do"];
      if (what == "piece") face_of[change["piece"]] = change["face"];
      if (what == "paint") end.painted.push_back(face_of.at(change["piece"]));
      if (what == "unpaint") end.painted.clear();
      if (what == "node") end.nodes.insert(change["node"].get<int>());
      if (what == "add" && change["name"] == "kept") end.kept.push_back(change["item"][1]);
      if (what == "undraw") end.drawn.clear();
      if (what == "draw")
        for (const Json& line : change["lines"]) end.drawn.push_back(line);
      if (what == "cells")
        for (const Json& c : change["cells"]) {
          end.cells[{c[0], c[1]}] = {c[2], c[3]};
          end.colours[{c[0], c[1]}] = c.size() > 4 ? c[4] : "";
        }
      if (what == "bars" && change["name"] == "visible" && step["kind"] == "result")
        for (const Json& bar : change["bars"]) end.visible[step["edges"][0]].emplace_back(bar[0], bar[1]);
    }
  }
  return end;
}

void check_form(const Json& trace) {
  CHECK(trace["format"] == "hsr-trace/1");
  std::set<std::string> lines;
  for (const Json& line : trace["pseudocode"]) CHECK(lines.insert(line[0]).second);
  for (const Json& run : trace["runs"]) {
    const Json& scene = run.contains("scene") ? run["scene"] : trace["scene"];
    for (const Json& step : run["steps"]) {
      CHECK(lines.count(step["line"]) == 1);
      CHECK(!step["says"].get<std::string>().empty());
      for (const Json& face : step.value("faces", Json::array())) CHECK(face < scene["faces"].size());
      for (const Json& edge : step.value("edges", Json::array())) CHECK(edge < scene["edges"].size());
      if (step.contains("choices")) {
        CHECK(step["right"] < step["choices"].size());
        CHECK(step["choices"].size() > 1);
      }
    }
  }
}

void check_end(const Json& trace) {
  for (const Json& run : trace["runs"]) {
    const Ended end = ended(run);
    const Json& result = run["result"];
    if (result.contains("painted")) CHECK(Json(end.painted) == result["painted"]);
    if (result.contains("kept")) CHECK(Json(end.kept) == result["kept"]);
    if (result.contains("nodes")) CHECK(end.nodes.size() == result["nodes"]);
    if (result.contains("faces"))
      for (std::size_t j = 0; j < result["faces"].size(); ++j)
        for (std::size_t i = 0; i < result["faces"][j].size(); ++i) {
          const auto cell = end.cells.find({static_cast<int>(i), static_cast<int>(j)});
          CHECK((cell == end.cells.end() ? -1 : cell->second.second) == result["faces"][j][i]);
          if (cell != end.cells.end() && run["name"] == "float, less, from the plane")
            CHECK(std::stod(cell->second.first) == Approx(result["depths"][j][i].get<double>()).epsilon(6e-4));
        }
    if (result.contains("colours")) {
      std::size_t fragments = 0, most = 0;
      for (std::size_t j = 0; j < result["colours"].size(); ++j)
        for (std::size_t i = 0; i < result["colours"][j].size(); ++i) {
          const std::pair<int, int> at{static_cast<int>(i), static_cast<int>(j)};
          CHECK(end.colours.at(at) == result["colours"][j][i]);
          const std::size_t count = std::stoul(end.cells.at(at).first);
          fragments += count;
          most = std::max(most, count);
        }
      CHECK(fragments == result["fragments"]);
      CHECK(most == result["most_fragments"]);
    }
    if (result.contains("lines")) {
      std::map<int, std::vector<std::pair<double, double>>> visible;
      for (const Json& line : result["lines"])
        for (const Json& part : line["visible"]) visible[line["edge"]].emplace_back(part[0], part[1]);
      std::size_t count = 0;
      for (auto& [edge, parts] : visible) {
        // Told are also the parts that are of no class that is drawn.
        const auto& told = end.visible.at(edge);
        for (const auto& part : parts) CHECK(std::count(told.begin(), told.end(), part) == 1);
        count += parts.size();
      }
      CHECK(std::count_if(end.drawn.begin(), end.drawn.end(), [](const Json& line) { return line.size() == 2; }) ==
            static_cast<std::ptrdiff_t>(count));
    }
  }
}

std::vector<Json> traces_of(const std::string& page) {
  std::vector<Json> traces;
  const std::string begin = "<script class=\"trace\" type=\"application/json\">";
  for (std::size_t at = page.find(begin); at != std::string::npos; at = page.find(begin, at + 1)) {
    const std::size_t from = at + begin.size();
    traces.push_back(Json::parse(page.substr(from, page.find("</script>", from) - from)));
  }
  return traces;
}

}  // namespace hsr::internal
