// hsr sheet: what is written, what is said, what is refused.
#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/cli/run_command.h"

using nlohmann::json;
using namespace hsr::cli_tests;

namespace {

/// A step of 40 x 30 x 20.
const char* const step = R"(v 0 0 0
v 40 0 0
v 40 30 0
v 0 30 0
v 0 0 20
v 20 0 20
v 20 30 20
v 0 30 20
v 40 0 8
v 40 30 8
v 20 0 8
v 20 30 8
f 4 3 2 1
f 1 2 9 11 6 5
f 4 8 7 12 10 3
f 1 5 8 4
f 5 6 7 8
f 6 11 12 7
f 11 9 10 12
f 2 3 10 9
)";

}  // namespace

TEST_CASE("a sheet is written in every format, and its places as JSON", "[cli][sheet][L8]") {
  const Directory d;
  const std::string model = write(d / "step.obj", step);
  std::string outputs;
  for (const char* format : {"pdf", "svg", "eps", "dxf", "tex", "hpgl", "png", "json"}) outputs += " -o " + (d / "x.") + format;
  const Outcome outcome = run("sheet " + model + outputs + " --section x=10 --title number=4711");
  INFO(outcome.text);
  REQUIRE(outcome.status == 0);
  CHECK(outcome.text.find("A3, 420 x 297 mm, scale 2:1, 5 views") != std::string::npos);
  const json places = json::parse(contents(d / "x.json"));
  CHECK(places["format"] == "hsr-sheet/1");
  CHECK(places["scale"] == 2);
  REQUIRE(places["views"].size() == 5);
  CHECK(places["views"][0]["name"] == "front");
  CHECK(places["views"][3]["name"] == "A-A");
  REQUIRE(places["dimensions"].size() == 3);
  CHECK(places["dimensions"][0]["text"] == "40");
  const std::string svg = contents(d / "x.svg");
  CHECK(svg.find("width=\"420mm\"") != std::string::npos);
  CHECK(svg.find("<title>step</title>") != std::string::npos);
  CHECK(svg.find("inkscape:label=\"side hidden outline\"") != std::string::npos);
  CHECK(svg.find("id=\"A-A-visible-section\"") != std::string::npos);
  // In units of the model: the front view is 40 wide.
  const std::string dxf = contents(d / "x.dxf");
  CHECK(dxf.find("FRONT_VISIBLE_") != std::string::npos);
  CHECK(dxf.find("$EXTMAX\n10\n207.5") != std::string::npos);  // 415 mm of paper at 2:1
}

TEST_CASE("a sheet is the same for any number of threads", "[cli][sheet]") {
  const Directory d;
  const std::string model = write(d / "step.obj", step);
  REQUIRE(run("sheet " + model + " --threads 1 --section y=12 -o " + (d / "a.pdf") + " -o " + (d / "a.svg")).status == 0);
  REQUIRE(run("sheet " + model + " --threads 2 --section y=12 -o " + (d / "b.pdf") + " -o " + (d / "b.svg")).status == 0);
  CHECK(contents(d / "a.pdf") == contents(d / "b.pdf"));
  CHECK(contents(d / "a.svg") == contents(d / "b.svg"));
}

TEST_CASE("fields of the title block come from options and from a file", "[cli][sheet]") {
  const Directory d;
  const std::string model = write(d / "step.obj", step);
  const std::string fields = write(d / "fields.json", R"({"title": "Step", "owner": "Müller"})");
  const auto svg_with = [&](const std::string& options) {
    const Outcome outcome = run("sheet " + model + " -o " + (d / "t.svg") + " " + options);
    INFO(outcome.text);
    REQUIRE(outcome.status == 0);
    return contents(d / "t.svg");
  };
  const std::string from_file = svg_with("--title-block " + fields);
  CHECK(from_file.find("<title>Step</title>") != std::string::npos);
  CHECK(svg_with("--title title=Step --title owner=Müller") == from_file);
  CHECK(svg_with("--title-block " + fields + " --title title=Other").find("<title>Other</title>") != std::string::npos);
}

TEST_CASE("what is no sheet is refused in one line, and nothing is written", "[cli][sheet]") {
  const Directory d;
  const std::string model = write(d / "step.obj", step), wrong = write(d / "wrong.json", "[1]"),
                    unknown = write(d / "unknown.json", R"({"titel": "x"})"),
                    number = write(d / "number.json", R"({"title": 3})");
  const std::pair<std::string, std::string> cases[] = {
      {"--page A7", "--page: found \"A7\", expected A0 ... A4, ANSI-A or ANSI-B"},
      {"--scale 10:1", "--scale: the views have no room on A3 at 10:1, expected 2:1 or less, or a larger sheet"},
      {"--scale fit", "--scale: found \"fit\", expected standard or a ratio like 1:5, as a sheet says its scale"},
      {"--views front,back", "--views: found \"back\", expected some of front, top, side, iso"},
      {"--section w=3", "--section: found \"w=3\""},
      {"--detail front:1,2,3:4",
       "--detail: found \"front:1,2,3:4\", expected VIEW:X,Y,Z:RADIUS:SCALE such as front:10,0,5:4:5:1"},
      {"--detail iso:1,2,3:4:0:1", "--detail: found"},
      {"--title colour=red", "--title: found the field \"colour\", expected one of owner, title"},
      {"--title red", "--title: found \"red\", expected FIELD=TEXT such as title=Bracket"},
      {"--title-block " + wrong, wrong + ": found no object of JSON"},
      {"--title-block " + unknown, unknown + ": found the field \"titel\""},
      {"--title-block " + number, number + ": found a field \"title\" that is no text"},
      {"--title-block " + (d / "none.json"), "--title-block: " + (d / "none.json") + ": cannot be read"},
      {"--fit-arcs 0", "--fit-arcs: found \"0\", expected millimetres, more than 0"},
  };
  for (const auto& [options, message] : cases) {
    const Outcome outcome = run("sheet " + model + " -o " + (d / "x.pdf") + " " + options);
    INFO(options << ": " << outcome.text);
    CHECK(outcome.status == 2);
    CHECK(outcome.text.find(message) != std::string::npos);
    CHECK(std::ranges::count(outcome.text, '\n') == 1);
    CHECK_FALSE(std::filesystem::exists(d / "x.pdf"));
  }
}
