// What docs/explain.md says of the page on depth sort, and the page of itself, is to be found there.
#include <algorithm>
#include <catch2/catch.hpp>
#include <map>

#include "study/explain/explain_pages.h"
#include "study/explain/explained_methods.h"
#include "tests/study/traces.h"

namespace hsr::internal {
namespace {

const ExplainedMethod& depth_sort_method() {
  const std::vector<ExplainedMethod>& all = explained_methods();
  return *std::find_if(all.begin(), all.end(), [](const ExplainedMethod& m) { return m.name == "depth-sort"; });
}

bool has(const Json& step, const std::string& words) {
  return step["says"].get<std::string>().find(words) != std::string::npos;
}

TEST_CASE("the answers to what an outsider asks of depth sort are on its page", "[study][explain]") {
  const std::string page = explain_page(depth_sort_method(), example_trace(depth_sort_method(), 16), "", {"painter"});
  const std::vector<Json> traces = traces_of(page);
  REQUIRE(traces.size() == 1);
  const Json& runs = traces[0]["runs"];
  // How often steps of a line, or that say something, are there, in one run or in any.
  const auto count = [&](auto is_meant, int run = -1) {
    std::size_t n = 0;
    for (std::size_t r = 0; r < runs.size(); ++r)
      if (run < 0 || r == static_cast<std::size_t>(run))
        for (const Json& step : runs[r]["steps"]) n += is_meant(step) ? 1U : 0U;
    return n;
  };
  const auto of_line = [](const std::string& line) { return [line](const Json& step) { return step["line"] == line; }; };
  const auto that_says = [](const std::string& words) { return [words](const Json& step) { return has(step, words); }; };
  REQUIRE(runs[0]["name"] == "few cuts");
  // 1. Why is it not enough to sort by depth?
  CHECK(count([&](const Json& step) { return step["line"] == "sort" && has(step, "first guess"); }, 0) == 1);
  CHECK(count([&](const Json& step) { return step["kind"] == "test" && has(step, "is painted before"); }, 0) > 1);
  CHECK(page.find("<a href=\"painter.html\">") != std::string::npos);
  // 2. What do the tests compare?
  for (const char* const test : {"sides", "depths", "plane-of-first", "plane-of-second", "coplanar", "common"})
    CHECK(count([&](const Json& step) { return step["kind"] == "test" && step["line"] == test; }) > 0);
  CHECK(count([](const Json& step) { return step["kind"] == "test" && step.contains("choices"); }, 0) > 1);
  // 3. Which side of a plane?
  CHECK(count(that_says("on one side of the plane of")) > 1);
  CHECK(count(that_says("away from the viewer")) > 0);
  CHECK(count(that_says("toward the viewer")) > 0);
  // 4. Can it be that no order is right?
  CHECK(count([&](const Json& step) { return step["line"] == "met" && has(step, "The search comes back to"); }, 0) == 1);
  CHECK(count([&](const Json& step) { return step["line"] == "loop" && has(step, "A cycle: "); }, 0) == 1);
  REQUIRE(runs[1]["name"] == "as the paper cuts");
  CHECK(count([&](const Json& step) { return step["line"] == "pierce" && has(step, "pierce each other"); }, 1) > 0);
  // 5. Where is a face cut, and does that end?
  CHECK(count([](const Json& step) { return step["line"] == "split" && has(step, " is cut along ") && step.contains("marks"); },
              0) == 1);
  CHECK(count(of_line("relate"), 0) > 0);
  CHECK(count([&](const Json& step) { return step["line"] == "planes" && has(step, "are ordered by planes at once"); }) == 1);
  // What is to be chosen under "Show".
  for (const char* const name : {"plates of which an order exists", "ten sheets through one axis"})
    CHECK(std::any_of(runs.begin(), runs.end(), [&](const Json& run) { return run["name"] == name; }));
}

TEST_CASE("a test of depth sort that is not asked is not said to have failed", "[study][explain]") {
  const Json trace = Json::parse(trace_json(example_trace(depth_sort_method(), 16)));
  for (const Json& run : trace["runs"]) {
    const Json& faces = (run.contains("scene") ? run["scene"] : trace["scene"])["faces"];
    for (const Json& step : run["steps"]) {
      if (step["kind"] != "test") continue;
      bool are_triangles = true;
      for (const Json& piece : step["pieces"])
        are_triangles = are_triangles && faces[piece.get<std::size_t>()]["rings"][0].size() == 3;
      for (const Json& change : step["changes"])
        for (const Json& item : change.value("items", Json::array()))
          if (item[0].get<std::string>().rfind("2 depths apart: no", 0) == 0) CHECK(are_triangles);
    }
  }
}

}  // namespace
}  // namespace hsr::internal
