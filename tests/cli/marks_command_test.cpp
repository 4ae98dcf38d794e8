// --marks: what is known of the edges of a mesh, from a file beside it.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/cli/run_command.h"

using nlohmann::json;
using namespace hsr::cli_tests;

namespace {

/// How many edges of a drawing are of a class.
int edges_of(const std::string& drawing, const char* edge_class) {
  int n = 0;
  const json all = json::parse(contents(drawing));
  for (const json& line : all["lines"]) n += line["class"] == edge_class ? 1 : 0;
  return n;
}

TEST_CASE("marks of a file stand above the crease", "[cli][marks][J7]") {
  const Directory d;
  const std::string model = write(d / "cube.obj", cube), out = " --edges all -q -o " + (d / "a.json");
  REQUIRE(run("draw " + model + out).status == 0);
  CHECK(edges_of(d / "a.json", "sharp") == 6);
  CHECK(edges_of(d / "a.json", "outline") == 6);
  // The corner toward the viewer of the iso view: two of its edges, in a row.
  const std::string marks =
      write(d / "cube.marks.json", R"({"format": "hsr-marks/1", "edges": [{"points": [4, 5, 1], "mark": "smooth"}]})");
  REQUIRE(run("draw " + model + " --marks " + marks + out).status == 0);
  CHECK(edges_of(d / "a.json", "sharp") == 4);
  CHECK(edges_of(d / "a.json", "smooth") == 2);
  write(marks, R"({"format": "hsr-marks/1", "surfaces": [0, 0, 0, 0, 0, 0]})");
  REQUIRE(run("draw " + model + " --marks " + marks + out).status == 0);
  CHECK(edges_of(d / "a.json", "sharp") == 0);
  CHECK(edges_of(d / "a.json", "outline") == 6);
  // The fills know them, too, and need the edges all the same.
  REQUIRE(run("draw " + model + " --marks " + marks + " --fill --check" + out).status == 0);
  CHECK(edges_of(d / "a.json", "smooth") == 0);
  CHECK(json::parse(contents(d / "a.json"))["fragments"].size() == 3);
}

TEST_CASE("of several models each has its own marks", "[cli][marks][J7]") {
  const Directory d;
  const std::string model = write(d / "cube.obj", cube), out = " --edges all -q -o " + (d / "a.json");
  std::string far = cube;
  for (std::size_t at = far.find("v "); at != std::string::npos; at = far.find("v ", at + 1)) far.insert(at + 2, "7");
  const std::string other = write(d / "far.obj", far);
  const std::string none = write(d / "none.json", R"({"format": "hsr-marks/1"})");
  const std::string one = write(d / "one.json", R"({"format": "hsr-marks/1", "surfaces": [0, 0, 0, 0, 0, 0]})");
  REQUIRE(run("draw " + model + " " + other + " --marks " + none + " --marks " + one + out).status == 0);
  CHECK(edges_of(d / "a.json", "sharp") == 6);
  const json all = json::parse(contents(d / "a.json"));
  for (const json& line : all["lines"]) CHECK((line["class"] != "sharp" || line["edge"][0] < 8));
}

TEST_CASE("marks and chords that make no sense are refused in one line", "[cli][marks]") {
  const Directory d;
  const std::string model = write(d / "cube.obj", cube), out = " -o " + (d / "a.svg");
  const std::string marks = write(d / "m.json", R"({"format": "hsr-marks/1", "surfaces": [0]})");
  check_refused(run("draw " + model + out + " --marks " + marks), {"m.json: surfaces: found 1 numbers", "6 faces"});
  check_refused(run("draw " + model + out + " --marks " + (d / "no.json")), {"no.json"});
  check_refused(run("draw " + model + out + " --marks " + marks + " --marks " + marks),
                {"--marks: found 2 files for 1 models"});
  check_refused(run("draw " + model + out + " --chord 0"), {"--chord: found 0"});
  CHECK(d.files() == 2);
}

}  // namespace
