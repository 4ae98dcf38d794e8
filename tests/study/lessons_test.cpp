// The lessons have the numbers of the lectures, and what their words say of a run is so.
#include "study/explain/lessons.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "hsr/raster/depth_format.h"
#include "tests/study/traces.h"

namespace hsr::internal {
namespace {

const std::string& page(const std::string& name) {
  static const std::vector<Lesson> lessons = all_lessons("");
  const auto found = std::find_if(lessons.begin(), lessons.end(), [&](const Lesson& l) { return l.name == name; });
  REQUIRE(found != lessons.end());
  return found->page;
}

/// What stands in the samples at the end, by row.
std::vector<std::string> texts(const Json& run) {
  std::vector<std::string> rows;
  for (const auto& [at, cell] : ended(run).cells) {
    rows.resize(std::max<std::size_t>(rows.size(), static_cast<std::size_t>(at.second) + 1));
    rows[static_cast<std::size_t>(at.second)] += (at.first == 0 ? "" : " ") + cell.first;
  }
  return rows;
}

std::string first_words(const Json& run) { return run["steps"][0]["says"]; }

/// The number of this name, where a step first has it.
std::string number(const Json& run, const std::string& name) {
  for (const Json& step : run["steps"])
    for (const Json& n : step.value("numbers", Json::array()))
      if (n[0] == name) return n[1];
  return "";
}

std::size_t steps(const std::vector<Json>& traces) {
  std::size_t count = 0;
  for (const Json& trace : traces)
    for (const Json& run : trace["runs"]) count += run["steps"].size();
  return count;
}

TEST_CASE("the runs of the lessons are those of the library, and have room in an hour", "[study][explain]") {
  std::size_t all = 0;
  for (const char* const name : {"lesson-image-space", "lesson-object-space"}) {
    const std::vector<Json> traces = traces_of(page(name));
    CHECK(traces.size() == 8);
    for (const Json& trace : traces) {
      check_form(trace);
      check_end(trace);
    }
    all += steps(traces);
    CHECK(page(name).find("{{") == std::string::npos);
  }
  CHECK(all < 620);
}

TEST_CASE("the lesson on image space has the numbers of the lectures", "[study][explain]") {
  const std::vector<Json> traces = traces_of(page("lesson-image-space"));
  const auto run = [&](std::size_t k, std::size_t r = 0) -> const Json& { return traces.at(k)["runs"].at(r); };
  using Rows = std::vector<std::string>;
  // 1: begins at 1; 0.5, 0.75 and 0.25.
  CHECK(first_words(run(0)).find("begins with 1, the depth of the far plane") != std::string::npos);
  std::vector<std::string> depths;
  for (const Json& step : run(0)["steps"])
    if (step["kind"] == "span") depths.push_back(step["numbers"][0][1]);
  CHECK(depths == Rows{"0.5", "0.75", "0.25"});
  CHECK(texts(run(0)) == Rows{"0.25"});
  // 2: initialised to -1, a face at -0.5, one that falls by 1/8.
  CHECK(first_words(run(1)).find("begins with -1, the depth of the far plane") != std::string::npos);
  CHECK(texts(run(1)) == Rows{"-1 -0.5 -0.125 -0.25 -0.375 -0.5 -0.625 -0.75"});
  CHECK(run(1)["steps"][5]["numbers"][3] == Json({"change from a sample to the next, −A/C", "-0.125"}));
  // 3: near 0, far 255, 64 and 127; "greater" begins at the near plane, and shows the farthest.
  CHECK(first_words(run(2)).find("begins with 255, the depth of the far plane") != std::string::npos);
  CHECK(texts(run(2))[7] == "255 64 64 64 64 64 64 127");
  CHECK(texts(run(2))[4] == "255 64 64 64 127 127 127 127");
  CHECK(first_words(run(2, 1)).find("begins with 0, the depth of the near plane") != std::string::npos);
  CHECK(texts(run(2, 1))[4] == "0 64 127 127 127 127 127 127");
  // 4: 64s, 5s, and 7 to 2.
  CHECK(first_words(run(3)).find("begins with 64,") != std::string::npos);
  CHECK(texts(run(3)) == Rows{"64 64 64 64 64 64 64 64", "5 5 5 5 5 5 64 64", "5 5 5 5 5 64 64 64", "5 5 5 5 64 64 64 64",
                              "5 5 5 5 64 64 64 64", "4 5 6 7 64 64 64 64", "3 4 5 6 7 64 64 64", "2 3 4 5 6 7 64 64"});
  // 5: -A/C = 2, -B/C = 3, and the same depths by steps.
  for (const std::size_t r : {0U, 1U}) {
    CHECK(number(run(4, r), "change from a sample to the next, −A/C") == "2");
    CHECK(number(run(4, r), "change from a row to the next, −B/C") == "3");
    CHECK(texts(run(4, r))[2] == "64 18 20 22 24 26 28 64 64 64");  // 10 + 2 column + 3 row
  }
  CHECK(number(run(4, 1), "left side: 1/m") == "0.2857");
  CHECK(number(run(4, 1), "right side: 1/m") == "4");
}

TEST_CASE("the lesson on image space says what few steps of depth do", "[study][explain]") {
  const std::vector<Json> traces = traces_of(page("lesson-image-space"));
  const Json& runs = traces.at(5)["runs"];
  const auto row = [&](std::size_t r) { return runs.at(r)["result"]["faces"][2].get<std::vector<int>>(); };
  CHECK(row(0) == std::vector<int>{0, 0, 0, 0, 0, 0, 1, 0});    // the first where both round to 101
  CHECK(row(1) == std::vector<int>{0, 0, 1, 1, 1, 1, 1, 0});    // the last
  CHECK(row(2) == std::vector<int>{0, 0, 0, 0, 0, 1, 1, 0});    // right: A is nearer up to column 3, and the first at 4
  CHECK(texts(runs.at(2))[2].find("e+") == std::string::npos);  // whole numbers
  CHECK(std::stod(number(runs.at(2), "change from a sample to the next, −A/C")) == 0.25 * 257);
  // 7: c = -n/f for n = 0.1 and f = 1.
  const auto depth = [](double z) { return transformed_depth(z, 0.1, 1); };
  CHECK(depth(-0.1) == 0);
  CHECK(depth(-1) == -1);
  CHECK(depth(-0.18) == Approx(-0.5).margin(0.01));
  CHECK(255 - std::round(-255 * depth(-0.9)) == 3);
  for (int k = 1; k <= 10; ++k) {
    const double z = -k / 10.0, c = -0.1;
    CHECK(depth(z) == Approx((c - z) / (z + z * c)).margin(1e-15));
  }
  CHECK(page("lesson-image-space").find("<td>-0.5</td><td>-0.8889</td><td>227</td>") != std::string::npos);
}

TEST_CASE("the lesson on image space says what culling leaves out", "[study][explain]") {
  const std::vector<Json> traces = traces_of(page("lesson-image-space"));
  const Json& runs = traces.at(7)["runs"];
  REQUIRE(runs.size() == 2);
  const auto keeps = [&](std::size_t r, int face) {
    const Json& kept = runs[r]["result"]["kept"];
    return std::find(kept.begin(), kept.end(), face) != kept.end();
  };
  CHECK(keeps(0, 1));  // B is turned to the viewer
  CHECK_FALSE(keeps(1, 1));
  CHECK_FALSE(keeps(0, 4));  // E is turned away
  CHECK(keeps(1, 4));
}

TEST_CASE("the lesson on object space says what its runs show", "[study][explain]") {
  const std::vector<Json> traces = traces_of(page("lesson-object-space"));
  const auto kinds = [&](std::size_t k) {
    std::set<std::string> all;
    for (const Json& step : traces.at(k)["runs"][0]["steps"]) all.insert(step["kind"]);
    return all;
  };
  CHECK(kinds(0).count("cycle") == 1);  // 1: of C, D and E no order is right
  for (const char* const cut : {"split", "pierce", "cycle"})
    CHECK(kinds(1).count(cut) == 0);    // 2: an order of whole faces exists
  CHECK(kinds(2).count("split") == 1);  // 3: none, until one is cut
  CHECK(kinds(3).count("pierce") == 1);
  CHECK(traces.at(4)["runs"].size() == 3);  // 5: one tree, two viewers
  // 6 and 7: the same lines, to the last digit.
  CHECK(traces.at(5)["runs"][0]["result"]["lines"] == traces.at(6)["runs"][0]["result"]["lines"]);
  CHECK(kinds(5).count("unite") == 1);
  CHECK(kinds(6).count("ray") == 1);
  // 8: no face is cut, but what is seen of one may be in several parts.
  CHECK(traces.at(7)["runs"][0]["result"]["painted"].size() >= 3);
}

}  // namespace
}  // namespace hsr::internal
