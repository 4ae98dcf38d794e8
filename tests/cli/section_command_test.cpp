// --section: what is taken away, what is hatched, and what is said about it.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "tests/cli/run_command.h"

using nlohmann::json;
using namespace hsr::cli_tests;

namespace {

/// A box as an object of an OBJ file. @param first the number of its first point
std::string box(const std::string& name, int first, const std::array<double, 3>& low, const std::array<double, 3>& high) {
  std::ostringstream text;
  for (int k = 0; k < 8; ++k)
    text << "v " << ((k & 1) != 0 ? high : low)[0] << ' ' << ((k & 2) != 0 ? high : low)[1] << ' '
         << ((k & 4) != 0 ? high : low)[2] << '\n';
  text << "o " << name << '\n';
  for (const auto& f : {std::array{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    text << 'f';
    for (const int corner : f) text << ' ' << first + corner;
    text << '\n';
  }
  return text.str();
}

/// Two walls of one material that meet at a corner of the plan, on a slab.
std::string walls() {
  return box("slab", 1, {0, 0, -0.2}, {6, 4, 0}) + box("south", 9, {0, 0, 0}, {6, 0.3, 2.5}) +
         box("west", 17, {0, 0.3, 0}, {0.3, 4, 2.5});
}

std::set<std::string> layers_of(const std::string& svg) {
  std::set<std::string> layers;
  for (std::size_t at = svg.find("inkscape:label=\""); at != std::string::npos; at = svg.find("inkscape:label=\"", at + 1)) {
    const std::size_t begin = at + 16;
    const std::string label = svg.substr(begin, svg.find('"', begin) - begin);
    if (label.rfind("visible ", 0) == 0 || label.rfind("hidden ", 0) == 0) layers.insert(label);  // others are objects
  }
  return layers;
}

}  // namespace

TEST_CASE("a plan of walls has wide borders, hatching, and no line where walls of one material touch",
          "[cli][section][X6][X7]") {
  const Directory d;
  const std::string model = write(d / "walls.obj", walls());
  const std::string svg = d / "plan.svg", lines = d / "plan.json";
  const Outcome outcome = run("draw " + model + " --view top --section z=1.2 -o " + svg + " -o " + lines);
  INFO(outcome.text);
  REQUIRE(outcome.status == 0);
  const auto layers = layers_of(contents(svg));
  CHECK(layers.contains("visible section"));
  CHECK(layers.contains("visible hatching"));
  CHECK_FALSE(layers.contains("visible joint"));
  const json found = json::parse(contents(lines));
  CHECK(found["view"]["section"] == json{{"point", {0, 0, 1.2}}, {"normal", {0, 0, -1}}});
  REQUIRE(found["section"]["caps"].size() == 2);
  CHECK(found["section"]["caps"][0]["object"] == 1);
  CHECK(found["section"]["caps"][0]["rings"][0].size() == 4);
  CHECK(found["section"]["open_outlines"] == 0);
  const std::string with_joints = d / "joints.svg";
  REQUIRE(run("draw " + model + " --view top --section z=1.2 --edges section,joint -o " + with_joints).status == 0);
  CHECK(layers_of(contents(with_joints)) == std::set<std::string>{"visible section", "visible joint"});
}

TEST_CASE("materials that differ are parted in a section", "[cli][section][X6]") {
  const Directory d;
  std::string text = walls();
  text.insert(text.find("o south"), "usemtl brick\n");
  text.insert(text.find("o west"), "usemtl concrete\n");
  const std::string model = write(d / "walls.obj", text);
  const std::string svg = d / "plan.svg";
  REQUIRE(run("draw " + model + " --view top --section z=1.2 -o " + svg).status == 0);
  CHECK(layers_of(contents(svg)).contains("visible material"));
}

TEST_CASE("a body inside another is outlined in it where the materials differ", "[cli][section][X6]") {
  const Directory d;
  std::string text = box("block", 1, {0, 0, 0}, {10, 10, 10}) + box("pin", 9, {4, 4, 4}, {6, 6, 14});
  text.insert(text.find("o block"), "usemtl wood\n");
  text.insert(text.find("o pin"), "usemtl steel\n");
  const std::string model = write(d / "pin.obj", text), svg = d / "pin.svg";
  REQUIRE(run("draw " + model + " --view front --section y=5 -o " + svg).status == 0);
  CHECK(layers_of(contents(svg)).contains("visible material"));
}

TEST_CASE("an order has what lies in the plane of a section", "[cli][section][X2]") {
  const Directory d;
  const std::string model = write(
      d / "in_plane.obj", std::string(cube) + "v 3 0.5 0\nv 5 0.5 0\nv 5 0.5 1\nf 9 10 11\nv -4 0.5 0\nv -3 0.5 1\nl 12 13\n");
  const std::string order = d / "o.json", page = d / "o.svg";
  const Outcome outcome = run("order " + model + " --view front --section y=0.5 -o " + order + " -o " + page);
  INFO(outcome.text);
  REQUIRE(outcome.status == 0);
  CHECK(run("verify " + order).status == 0);
  // As large as the drawing of the lines: nine units on 277 mm.
  CHECK(outcome.text.find("30.78 mm per unit") != std::string::npos);
  CHECK(contents(page).find("visible wire") != std::string::npos);
}

TEST_CASE("a section that leaves nothing says so", "[cli][section]") {
  const Directory d;
  const std::string model = write(d / "cube.obj", cube);
  CHECK(run("draw " + model + " --section x=-5 -o " + (d / "a.svg")).text.find("the section leaves nothing") !=
        std::string::npos);
}

TEST_CASE("a section in the plane of a floor cuts what stands on it and not the floor", "[cli][section][X2]") {
  const Directory d;
  const std::string model = write(d / "walls.obj", walls());
  const std::string lines = d / "plan.json";
  REQUIRE(run("draw " + model + " --view top --section z=0 -o " + lines).status == 0);
  std::set<int> objects;
  const json found = json::parse(contents(lines));
  for (const json& cap : found["section"]["caps"]) objects.insert(cap["object"].get<int>());
  CHECK(objects == std::set<int>{1, 2});  // the walls
}

TEST_CASE("an open surface is cut to no cap, and a note says so", "[cli][section][X4]") {
  const Directory d;
  std::string open = cube;
  open = open.substr(0, open.rfind("f "));  // the side at x = 1 is missing
  const std::string model = write(d / "open.obj", open);
  const std::string svg = d / "open.svg";
  const Outcome outcome = run("draw " + model + " --view top --section z=0.5 -o " + svg);
  CHECK(outcome.status == 0);
  CHECK(outcome.text.find("1 outline of the cut does not close") != std::string::npos);
  CHECK(layers_of(contents(svg)) == std::set<std::string>{"visible boundary"});  // the cut is drawn all the same
  // A lid that is missing elsewhere leaves the outline closed.
  CHECK(run("draw " + model + " --view right --section x=0.5 -o " + svg).text.find("does not close") == std::string::npos);
  CHECK(layers_of(contents(svg)).contains("visible hatching"));
}

TEST_CASE("patches of one surface are cut together", "[cli][section][X4]") {
  const Directory d;
  std::string text = cube;
  for (std::size_t at = text.find("f "), k = 0; at != std::string::npos; at = text.find("\nf ", at), ++k) {
    if (k > 0) ++at;
    const std::string name = "o patch" + std::to_string(k) + "\n";
    text.insert(at, name);
    at += name.size();
  }
  const std::string model = write(d / "patches.obj", text), lines = d / "a.json";
  REQUIRE(run("draw " + model + " --view top --section z=0.5 -o " + lines).status == 0);
  const json section = json::parse(contents(lines))["section"];
  CHECK(section["open_outlines"] == 0);
  CHECK(section["caps"].size() == 1);
}

TEST_CASE("planes that are none, or have no viewer's side, are refused", "[cli][section][X1]") {
  const Directory d;
  const std::string model = write(d / "cube.obj", cube), svg = " -o " + (d / "a.svg");
  check_refused(run("draw " + model + " --section q=1" + svg), {"--section", "q=1", "x=12.5"});
  check_refused(run("draw " + model + " --section x=" + svg), {"--section"});
  check_refused(run("draw " + model + " --section 1,0@0,0,0" + svg), {"--section", "1,0"});
  check_refused(run("draw " + model + " --section 0,0,0@0,0,0" + svg), {"normal"});
  check_refused(run("draw " + model + " --view top --section x=0.5" + svg), {"edge-on"});
  check_refused(run("draw " + model + " --view top --section z=0.5.." + svg), {"z=0.5..", "viewer", "expected z=0.5"});
  check_refused(run("draw " + model + " --view top --depth 1" + svg), {"--depth", "--section"});
  check_refused(run("draw " + model + " --view top --section z=0.5 --depth 0" + svg), {"depth", "above 0"});
  check_refused(run("draw " + model + " --view top --section z=0.5.5.." + svg), {"--section", "x=12.5"});
  check_refused(run("verify " + model + " --eye 3,0.5,0.5 --target 0,0.5,0.5 --near 2.5 --section x=0.75"), {"near plane"});
  check_refused(run("draw " + model + " --eye 3,0.5,0.5 --target 0,0.5,0.5 --near 2.5 --section x=0.75" + svg), {"near plane"});
  check_refused(run("draw " + model + " --section x=0.5 --why -o " + (d / "a.json")), {"section", "why"});
  check_refused(run("draw " + model + " --section x=0.5 --outline-only" + svg), {"section", "outline"});
  check_refused(run("draw " + model + " --section x=0.5 -o " + (d / "a.csv")), {"csv"});
  check_refused(run("draw " + model + " --section x=0.5 --fill --method roberts" + svg), {"roberts"});
  check_refused(run("compare " + model + " --section x=0.5 -o " + (d / "c")), {"--section"});
}

TEST_CASE("fragments, the nearest face and orders agree beside the caps", "[cli][section][X5][X8]") {
  const Directory d;
  const std::string model = write(d / "walls.obj", walls());
  for (const char* view :
       {"--view iso --section 1,2,-3@3,0,1", "--eye 20,-15,12 --section y=0.15", "--view top --section z=1.2"}) {
    INFO(view);
    CHECK(run("draw " + model + " " + view + " --fill --check --size 300x200 -o " + (d / "a.svg")).status == 0);
    CHECK(run("order " + model + " " + view + " --check --size 300x200 -o " + (d / "o.json") + " -o " + (d / "o.svg")).status ==
          0);
    CHECK(run("verify " + (d / "o.json")).status == 0);
    // Caps are filled last: they alone have the grey that no slope darkens, or are all that there is to see.
    const std::string svg = contents(d / "o.svg"), cap = "fill=\"#c8c8c8\"";
    const std::size_t first_cap = svg.find(cap);
    REQUIRE(first_cap != std::string::npos);
    CHECK(svg.find(cap, first_cap + 1) != std::string::npos);
    CHECK(count(svg.substr(first_cap), "fill=\"#") == count(svg, cap));
  }
}

TEST_CASE("caps say of which face and object they are, in orders, too", "[cli][section][X8][J4]") {
  const Directory d;
  const std::string model = write(d / "walls.obj", walls());
  REQUIRE(run("order " + model + " --view top --section z=1.2 -o " + (d / "o.json") + " -o " + (d / "o.svg")).status == 0);
  const json order = json::parse(contents(d / "o.json"));
  REQUIRE(order["section"]["caps"].size() == 2);
  CHECK(order["section"]["caps"][0]["object"] == 1);
  CHECK(order["section"]["caps"][0]["rings"][0].size() == 4);
  REQUIRE(run("draw " + model + " --view top --section z=1.2 --fill -o " + (d / "a.svg")).status == 0);
  for (const char* file : {"o.svg", "a.svg"}) {
    const std::string svg = contents(d / file);
    CHECK(svg.find("data-face=\"\"") == std::string::npos);
    for (const json& cap : order["section"]["caps"])
      CHECK(svg.find("data-face=\"" + std::to_string(cap["face"].get<int>()) + "\"") != std::string::npos);
  }
}

TEST_CASE("several planes, a half section and a depth are drawn, and are in JSON", "[cli][section][X9][X10][X11][J3][J5]") {
  const Directory d;
  const std::string model = write(d / "walls.obj", walls()), svg = d / "a.svg", lines = d / "a.json";
  const auto draw = [&](const std::string& options) {
    const Outcome outcome = run("draw " + model + " " + options + " --fill --check --size 200x150 -o " + svg + " -o " + lines);
    INFO(options << "\n" << outcome.text);
    CHECK(outcome.status == 0);
    CHECK(outcome.text.find("cuts no closed body") == std::string::npos);
    return json::parse(contents(lines));
  };
  const json quarter = draw("--section x=3 --section y=0.15");
  CHECK(quarter["view"]["sections"].size() == 2);
  CHECK_FALSE(quarter["view"].contains("section"));
  CHECK(quarter["section"]["caps"][0].contains("plane"));
  CHECK(layers_of(contents(svg)).contains("visible hatching"));
  CHECK_FALSE(layers_of(contents(svg)).contains("visible joint"));
  draw("--section x=3 --section y=0.15 --edges section,joint");
  CHECK(layers_of(contents(svg)).contains("visible joint"));
  const json half = draw("--view front --section y=0.15 --section x=3..");
  CHECK(half["view"]["sections"][1] == json{{"point", {3, 0, 0}}, {"normal", {1, 0, 0}}});
  const json side = draw("--view front --section x=..3");
  CHECK(layers_of(contents(svg)).contains("visible section"));
  CHECK_FALSE(layers_of(contents(svg)).contains("visible hatching"));
  const json deep = draw("--view top --section z=1.2 --depth 1.3");
  CHECK(deep["view"]["far"] == json{{"point", {0, 0, 1.2 - 1.3}}, {"normal", {0, 0, -1}}});
}

TEST_CASE("what is above a plan is dashed in a layer of its own, and nothing else changes", "[cli][section][X13][D7]") {
  const Directory d;
  const std::string model = write(d / "house.obj", walls() + box("roof", 25, {-0.5, -0.5, 2.5}, {6.5, 4.5, 2.7}));
  const std::string svg = d / "a.svg", lines = d / "a.json", plan = "draw " + model + " --view top --section z=1.2 -o ";
  REQUIRE(run(plan + svg + " -o " + lines + " --overhead dashed --fill").status == 0);
  CHECK(layers_of(contents(svg)).contains("visible overhead"));
  json found = json::parse(contents(lines))["lines"], others = json::array();
  int overhead = 0;
  for (const json& line : found)
    if (line["class"] == "overhead")
      ++overhead;
    else
      others.push_back(line);
  CHECK(overhead == 4);
  REQUIRE(run(plan + lines + " --fill").status == 0);
  CHECK(json::parse(contents(lines))["lines"] == others);
  check_refused(run("draw " + model + " --view top --overhead dashed -o " + svg), {"overhead", "section"});
  check_refused(run("draw " + model + " --eye 9,9,9 --section z=1 --overhead dashed -o " + svg), {"overhead", "perspective"});
}

TEST_CASE("each section has a drawing where that is asked for", "[cli][section]") {
  const Directory d;
  const std::string model = write(d / "walls.obj", walls());
  const std::string each = "draw " + model + " --view top --section z=1 --section z=2 --section-each -o ";
  REQUIRE(run(each + (d / "plan.svg") + " -o " + (d / "plan.json")).status == 0);
  for (const int k : {1, 2}) {
    const json view = json::parse(contents(d / ("plan-" + std::to_string(k) + ".json")))["view"];
    CHECK(view["section"]["point"] == json{0, 0, k});
    CHECK(layers_of(contents(d / ("plan-" + std::to_string(k) + ".svg"))).contains("visible hatching"));
  }
  check_refused(run(each + "svg:-"), {"--section-each", "svg:-"});
  check_refused(run("draw " + model + " --section-each -o " + (d / "x.svg")), {"--section-each", "--section"});
}

TEST_CASE("orders of several planes are right beside the caps", "[cli][section][X8][X9][X10][X11]") {
  const Directory d;
  const std::string model = write(d / "walls.obj", walls() + "v 1 1 -1\nv 5 3 4\nl 25 26\n");
  for (const char* view :
       {"--section x=3 --section y=0.15", "--view front --section y=0.15 --section x=3..",
        "--eye 20,-15,12 --section y=0.15 --section x=4 --depth 2", "--view top --section z=1.2 --depth 1.3"}) {
    for (const char* method : {"depth-sort", "bsp"}) {
      INFO(view << " " << method);
      CHECK(run("order " + model + " " + view + " --method " + method + " --check --size 200x150 -o " + (d / "o.json") +
                " -o " + (d / "o.svg"))
                .status == 0);
      CHECK(run("verify " + (d / "o.json")).status == 0);
      const json order = json::parse(contents(d / "o.json"));
      CHECK(order["section"]["caps"].size() >= 2);
    }
  }
}

TEST_CASE("faces of a model are verified with several planes, a half section and a depth",
          "[cli][section][P13][X9][X10][X11]") {
  const Directory d;
  // A square and, painted after it, one that is behind it as seen from iso. Both are beyond x = 1 and beyond y = 1.
  const std::string model = write(d / "squares.obj",
                                  "v 2 2 1\nv 3 2 1\nv 3 3 1\nv 2 3 1\nv 1 3 0\nv 2 3 0\nv 2 4 0\nv 1 4 0\n"
                                  "f 1 2 3 4\nf 5 6 7 8\n");
  const auto status = [&](const std::string& options) {
    const Outcome outcome = run("verify " + model + " " + options);
    INFO(options << "\n" << outcome.text);
    CHECK((outcome.status == 0) == (outcome.text.find("correct: ") == 0));
    return outcome.status;
  };
  CHECK(status("") == 1);
  CHECK(status("--section x=1") == 0);
  CHECK(status("--section x=1 --section y=1") == 1);
  CHECK(status("--section x=1 --section y=4") == 0);
  CHECK(status("--section z=2 --depth 1.5") == 0);
  CHECK(status("--section z=2 --depth 2") == 1);
  // From the right, half of what the first plane takes away.
  CHECK(status("--direction 1,-1,1 --section x=1 --section \"1,1,0@0,6,0\"") == 0);
  CHECK(status("--direction 1,-1,1 --section x=1 --section \"1,1,0@0,5,0\"") == 1);
  const std::string picture = d / "a.svg";
  CHECK(run("verify " + model + " --section x=1 --section y=2.5 -o " + picture).status == 1);
  CHECK(count(contents(picture), "<path") == 2);
}

TEST_CASE("lines of a section are in the layers of their class, each of which is there once", "[cli][section][X4]") {
  const Directory d;
  // A box without its lid and with a wire: the class of wires stands between those of the borders and of the cut.
  const std::string model =
      write(d / "open.obj",
            "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 0 0 3\nv 4 0 3\nv 4 4 3\nv 0 4 3\nf 4 3 2 1\nf 1 2 6 5\nf "
            "2 3 7 6\nf 4 1 5 8\nl 1 7\n");
  const std::string svg = d / "x.svg";
  const Outcome outcome = run("draw " + model + " --section z=1 -o " + svg);
  INFO(outcome.text);
  REQUIRE(outcome.status == 0);
  const std::string text = contents(svg);
  std::multiset<std::string> ids;
  for (std::size_t at = text.find("id=\""); at != std::string::npos; at = text.find("id=\"", at + 1))
    ids.insert(text.substr(at + 4, text.find('"', at + 4) - at - 4));
  CHECK(ids.count("visible-boundary") == 1);
  CHECK(ids.count("visible-wire") == 1);
  for (const std::string& id : ids) CHECK(ids.count(id) == 1);
}
