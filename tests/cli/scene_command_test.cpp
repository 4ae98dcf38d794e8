// What makes the scene of a command: several models, standard input, objects by name, ghosts, oblique views, units.
#include <array>
#include <catch2/catch.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "tests/cli/run_command.h"

using nlohmann::json;
using namespace hsr::cli_tests;

namespace {

/// A box as an object of an OBJ file.
/// @param first the number of its first point
std::string box(const std::string& name, int first, double x, double y, double z, double size) {
  std::ostringstream text;
  for (int k = 0; k < 8; ++k)
    text << "v " << x + (k & 1) * size << ' ' << y + (k >> 1 & 1) * size << ' ' << z + (k >> 2 & 1) * size << '\n';
  if (!name.empty()) text << "o " << name << '\n';
  for (const auto& f : {std::array{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    text << 'f';
    for (const int corner : f) text << ' ' << first + corner;
    text << '\n';
  }
  return text.str();
}

/// A plate of two unequal blocks, one in front of the other, and a block above both.
std::string three_boxes() {
  return box("front block", 1, 0, 0, 0, 1) + box("back & block", 9, 0, 3, 0, 2) + box("above", 17, 0, 0, 3, 1);
}

/// Standard output and standard error apart, and the exit status.
struct Streams {
  int status;
  std::string out, error;
};
Streams streams(const Directory& d, const std::string& arguments, const std::string& input = "/dev/null") {
  const std::string out = d / "out", error = d / "error";
  const std::string command = HSR_COMMAND + (" " + arguments) + " < " + input + " > " + out + " 2> " + error;
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents(out), contents(error)};
}

/// The edges that have a visible part, "i-j".
std::set<std::string> visible_edges(const json& lines) {
  std::set<std::string> edges;
  for (const json& line : lines["lines"])
    if (!line["visible"].empty() && line.contains("edge")) edges.insert(line["edge"].dump());
  return edges;
}

/// The points of all lines, in space.
std::set<std::array<double, 3>> points_of(const json& lines) {
  std::set<std::array<double, 3>> points;
  for (const json& line : lines["lines"])
    for (const char* key : {"visible_points", "hidden_points"})
      for (const json& part : line[key])
        for (const json& p : part) points.insert({p[0].get<double>() + 0, p[1].get<double>() + 0, p[2].get<double>() + 0});
  return points;
}

}  // namespace

TEST_CASE("several models are one scene, each an object", "[cli][O1]") {
  const Directory d;
  const std::string near = write(d / "near.obj", box("", 1, 0, 0, 0, 2)),
                    far = write(d / "far.obj", box("", 1, 0.5, 3, 0.5, 1));
  REQUIRE(run("draw " + near + " " + far + " --view front -q -o " + (d / "x.json")).status == 0);
  const json both = json::parse(contents(d / "x.json"));
  CHECK(both["objects"] == json({"near.obj", "far.obj"}));
  for (const json& line : both["lines"]) {
    CHECK(line["object"] == (line["edge"][0] < 8 ? 0 : 1));
    if (line["object"] == 1) CHECK(line["visible"].empty());  // behind the near one
  }
  for (const std::string verb : {"order ", "info ", "verify "}) {
    INFO(verb);
    const Outcome o = run(verb + near + " " + far + (verb == "order " ? " -o " + (d / "o.json") : " --view front"));
    INFO(o.text);
    CHECK((o.status == 0 || verb == "verify "));
  }
  CHECK(json::parse(contents(d / "o.json"))["pieces"].size() > 3);
  CHECK(run("info " + near + " " + far).text.find("objects     2") != std::string::npos);
  // The title of a drawing names both.
  REQUIRE(run("draw " + near + " " + far + " -q -o " + (d / "x.svg")).status == 0);
  CHECK(contents(d / "x.svg").find("<title>near.obj + far.obj</title>") != std::string::npos);
  check_refused(run("draw " + near + " " + (d / "no.stl") + " -o " + (d / "x.svg")), {"no.stl"});
  check_refused(run("draw " + near + " " + far + " -o " + (d / "y.svg") + " --report " + far), {"is the model itself"});
}

TEST_CASE("objects are drawn, left out or ghosts by their names", "[cli][O3][O4]") {
  const Directory d;
  const std::string model = write(d / "boxes.obj", three_boxes());
  const auto lines = [&](const std::string& options) {
    REQUIRE(run("draw " + model + " --view front -q -o " + (d / "x.json") + " " + options).status == 0);
    return json::parse(contents(d / "x.json"));
  };
  const json all = lines(""), hidden = lines("--hide \"front block\""), ghost = lines("--ghost \"front block\"");
  const json only = lines("--only \"front block\" --only above");
  for (const json& line : hidden["lines"]) CHECK(line["object"] != 0);
  for (const json& line : only["lines"]) CHECK(line["object"] != 1);
  CHECK(visible_edges(all) != visible_edges(ghost));
  // What the ghost does not hide is there as without it; and all of the ghost, which does not hide its own back either.
  std::set<std::string> expected = visible_edges(hidden);
  const json alone = lines("--only \"front block\"");
  for (const json& line : alone["lines"])
    if (!line["visible"].empty() || !line["hidden"].empty()) expected.insert(line["edge"].dump());
  CHECK(visible_edges(ghost) == expected);
  check_refused(run("draw " + model + " -o " + (d / "x.svg") + " --ghost lid"),
                {"--ghost: found no object \"lid\"", "\"front block\"", "\"back & block\"", "\"above\""});
  check_refused(run("draw " + model + " -o " + (d / "x.svg") + " --only above --hide above"), {"above"});
  // What shows faces says that a ghost has none.
  for (const std::string verb : {"order", "compare"}) {
    check_refused(run(verb + " " + model + " -o " + (d / "x.svg") + " --ghost above"),
                  {"--ghost: found \"above\"", "hsr draw", "--hide"});
    CHECK(run(verb + " --help").text.find("--ghost") == std::string::npos);
  }
  // A file that names nothing is one object.
  const std::string plain = write(d / "plain.obj", cube);
  CHECK(run("draw " + plain + " -o " + (d / "x.svg") + " --ghost plain.obj").status == 0);
}

/// Three boxes with a wire of the first above it, one of an object of its own, and one of no object that is named.
std::string boxes_with_wires() {
  return "v 0 0 9\nv 1 0 9\nv 0 0 8\nv 1 0 8\nv 0 0 7\nv 1 0 7\nl 5 6\n" + box("front block", 7, 0, 0, 0, 1) + "l 1 2\n" +
         box("back & block", 15, 0, 3, 0, 2) + "o rail\nl 3 4\n";
}

TEST_CASE("wires are of the objects that they stand in", "[cli][wires][O1][O3][O7][O8]") {
  const Directory d;
  const std::string model = write(d / "a.obj", boxes_with_wires());
  const auto lines = [&](const std::string& options) {
    REQUIRE(run("draw " + model + " --view front -q -o " + (d / "x.json") + " -o " + (d / "x.svg") + " " + options).status ==
            0);
    return json::parse(contents(d / "x.json"));
  };
  // The names of the wires' objects, by height.
  const auto wires = [](const json& all) {
    std::map<int, std::string> names;
    for (const json& line : all["lines"])
      if (line["class"] == "wire") names[line["edge"][0]] = all["objects"][line["object"].get<std::size_t>()];
    return names;
  };
  using Names = std::map<int, std::string>;
  CHECK(wires(lines("")) == Names{{0, "front block"}, {2, "rail"}, {4, "default"}});
  const std::string svg = contents(d / "x.svg");
  for (const std::string name : {"front_block", "rail", "default"})
    CHECK(count(svg, "<g id=\"visible-wire-" + name + "\" class=\"object\"") == 1);
  CHECK(wires(lines("--only \"front block\"")) == Names{{0, "front block"}});
  CHECK(wires(lines("--only rail")) == Names{{2, "rail"}});
  CHECK(lines("--only rail")["lines"].size() == 1);
  CHECK(wires(lines("--hide rail")) == Names{{0, "front block"}, {4, "default"}});
  CHECK(wires(lines("--hide \"front block\" --hide default")) == Names{{2, "rail"}});
  // A wire hides nothing, so a ghost's is as it was.
  const json ghost = lines("--ghost \"front block\" --ghost rail");
  CHECK(wires(ghost) == wires(lines("")));
  CHECK(wires(lines("--only \"back & block\" --ghost rail")) == Names{{2, "rail"}});
  // A file that names nothing is one object, wires and all.
  const std::string rod = write(d / "rod.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n"), cube_file = write(d / "cube.obj", cube);
  REQUIRE(run("draw " + rod + " " + cube_file + " --only rod.obj -q -o " + (d / "x.json")).status == 0);
  CHECK(wires(json::parse(contents(d / "x.json"))) == Names{{0, "rod.obj"}});
  REQUIRE(run("draw " + rod + " --only rod.obj -q -o " + (d / "x.json")).status == 0);
  CHECK(json::parse(contents(d / "x.json"))["lines"].size() == 1);
  REQUIRE(
      run("order " + model + " --view front --only rail --only \"front block\" --edges wire -q -o " + (d / "x.svg")).status ==
      0);
  CHECK(count(contents(d / "x.svg"), "<g id=\"visible-wire-rail\"") == 1);
}

TEST_CASE("a wire along the edge of a face is of its own object only where it is a wire", "[cli][wires][O7]") {
  const Directory d;
  // Two flat triangles of one object, a wire of another along the diagonal between them and along one side.
  const std::string model = write(d / "a.obj",
                                  "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\no plate\nf 1 2 3\nf 1 3 4\no rail\nl 1 3\nl "
                                  "1 2\no rail 2\nl 2 1\nl 4 2\no rail\nl 2 4\n");
  REQUIRE(run("draw " + model + " --view top -q -o " + (d / "x.json")).status == 0);
  std::map<std::string, std::string> objects;
  const json all = json::parse(contents(d / "x.json"));
  for (const json& line : all["lines"])
    objects[line["edge"].dump() + " " + line["class"].get<std::string>()] =
        line.contains("object") ? all["objects"][line["object"].get<std::size_t>()] : "none";
  CHECK(objects["[0,2] wire"] == "rail");
  CHECK(objects["[0,1] boundary"] == "plate");
  CHECK(objects["[1,3] wire"] == "none");  // wires of two objects
  CHECK(objects.size() == 6);
}

TEST_CASE("a ghost has no fill, and a check of fragments does not see it", "[cli][O4]") {
  const Directory d;
  const std::string model = write(d / "boxes.obj", three_boxes());
  const std::string draw = "draw " + model + " --view front --fill -q --check --size 64x64 -o " + (d / "x.json");
  REQUIRE(run(draw + " --ghost \"front block\"").status == 0);
  const json with_ghost = json::parse(contents(d / "x.json"));
  REQUIRE(run(draw + " --hide \"front block\"").status == 0);
  CHECK(with_ghost["fragments"] == json::parse(contents(d / "x.json"))["fragments"]);
  CHECK(with_ghost["fragments"].size() == 2);
}

TEST_CASE("names of objects are groups in the layers of an SVG file", "[cli][O8]") {
  const Directory d;
  const std::string model = write(d / "boxes.obj", three_boxes() + box("above!", 25, 5, 0, 3, 1));
  REQUIRE(run("draw " + model + " --hidden dashed --fill -q -o " + (d / "x.svg")).status == 0);
  const std::string svg = contents(d / "x.svg");
  CHECK(count(svg,
              "<g id=\"visible-outline-front_block\" class=\"object\" data-object=\"front block\" "
              "inkscape:label=\"front block\">") == 1);
  CHECK(count(svg, "data-object=\"back &amp; block\"") >= 3);  // of fills, visible and hidden lines
  CHECK(count(svg, "id=\"fill-above\"") == 1);
  CHECK(count(svg, "id=\"fill-above_\"") == 1);
  std::set<std::string> ids;
  for (std::size_t at = svg.find(" id=\""); at != std::string::npos; at = svg.find(" id=\"", at + 1))
    CHECK(ids.insert(svg.substr(at, svg.find('"', at + 5) - at)).second);
  CHECK(count(svg, "<g ") == count(svg, "</g>"));
  // Each path of a group is of faces of that object alone.
  const std::size_t group = svg.find("id=\"visible-sharp-above\"");
  REQUIRE(group != std::string::npos);
  const std::string paths = svg.substr(group, svg.find("</g>", group) - group);
  for (std::size_t at = paths.find("data-face=\""); at != std::string::npos; at = paths.find("data-face=\"", at + 1)) {
    const int face = std::stoi(paths.substr(at + 11));
    CHECK((face >= 12 && face < 18));
  }
}

TEST_CASE("a model of one object is written as one of none", "[cli][O7][O8]") {
  const Directory d;
  const std::string plain = write(d / "a.obj", box("", 1, 0, 0, 0, 1));
  const auto written = [&](const std::string& format) {
    REQUIRE(run("draw " + plain + " --hidden dashed --fill -q -o " + (d / "x.") + format).status == 0);
    return contents(d / ("x." + format));
  };
  const std::string svg = written("svg"), lines = written("json");
  write(plain, box("only one", 1, 0, 0, 0, 1));
  CHECK(written("svg") == svg);
  CHECK(written("json") == lines);
}

TEST_CASE("names of objects in JSON are in the file's words, whatever these are", "[cli][O7]") {
  const Directory d;
  const std::string model = write(d / "a.obj", box("Wand \"S\xC3\xBC"
                                                   "d\" \\ 1",
                                                   1, 0, 0, 0, 1) +
                                                   box("bad \xFF", 9, 3, 0, 0, 1));
  REQUIRE(run("draw " + model + " --fill -q -o " + (d / "x.json")).status == 0);
  const json lines = json::parse(contents(d / "x.json"));
  CHECK(lines["format"] == "hsr-lines/1");
  CHECK(lines["objects"] == json({"Wand \"S\xC3\xBC"
                                  "d\" \\ 1",
                                  "bad \xEF\xBF\xBD"}));
  for (const json& line : lines["lines"]) CHECK(line["object"] == (line["faces"][0] < 6 ? 0 : 1));
  for (const json& fragment : lines["fragments"]) CHECK(fragment["object"] == (fragment["face"] < 6 ? 0 : 1));
}

TEST_CASE("a line of faces of two objects is of none of them", "[cli][O7]") {
  const Directory d;
  const std::string roof = "v 0 0 0\nv 1 0 0\nv 0 1 1\nv 0 -1 1\no left\nf 1 2 3\no right\nf 1 4 2\n";
  REQUIRE(run("draw " + write(d / "roof.obj", roof) + " --edges all -q -o " + (d / "x.json")).status == 0);
  const json lines = json::parse(contents(d / "x.json"));
  REQUIRE(lines["lines"].size() == 5);
  for (const json& line : lines["lines"]) CHECK(line.contains("object") == (line["faces"].size() == 1));
}

TEST_CASE("a model is read from standard input, by its content or by --from", "[cli]") {
  const Directory d;
  const std::string model = write(d / "cube.obj", cube);
  REQUIRE(run("draw " + model + " -q -o " + (d / "file.json")).status == 0);
  for (const std::string from : {"", " --from obj"}) {
    CHECK(streams(d, "draw - -q -o " + (d / "x.json") + from, model).status == 0);
    CHECK(contents(d / "x.json") == contents(d / "file.json"));
  }
  const std::string off = write(d / "t.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 1\n3 0 1 2\n");
  CHECK(streams(d, "info -", off).out.find("standard input: OFF") != std::string::npos);
  CHECK(streams(d, "order - -o " + (d / "x.svg"), model).status == 0);
  REQUIRE(run("order " + model + " -q -o " + (d / "o.json")).status == 0);
  CHECK(streams(d, "verify - --from json", d / "o.json").status == 0);
  const auto refused = [&](const std::string& arguments, const std::string& input, const std::vector<std::string>& words) {
    const Streams s = streams(d, arguments, input);
    check_refused({s.status, s.error}, words);
    CHECK(s.out.empty());
  };
  refused("info -", "/dev/null", {"standard input", "empty"});
  refused("info - --from obj", write(d / "bad.obj", "v 0 0 0\nf 1 2 x\n"), {"hsr: standard input: line 2"});
  refused("info - -", model, {"twice", "standard input"});
  refused("info " + model + " --from obj", "/dev/null", {"--from"});
  check_refused(run("info - <&-"), {"standard input", "cannot be read"});
}

TEST_CASE("any format goes to standard output, and messages do not", "[cli]") {
  const Directory d;
  const std::string model = write(d / "cube.obj", cube);
  for (const std::string format : {"svg", "json", "png"}) {
    REQUIRE(run("draw " + model + " -q -o " + (d / "file.") + format).status == 0);
    const Streams s = streams(d, "draw " + model + " -o " + format + ":-");
    CHECK(s.status == 0);
    CHECK(s.out == contents(d / ("file." + format)));
    CHECK(s.error.rfind("hsr: standard output: ", 0) == 0);
    CHECK(count(s.error, "\n") == 1);
  }
  CHECK(streams(d, "order " + model + " -q -o json:- -o " + (d / "o.svg")).out.find("hsr-order/1") != std::string::npos);
  CHECK(streams(d, "draw - -q -o svg:-", model).out.rfind("<?xml", 0) == 0);
  check_refused(run("draw " + model + " -o svg:- -o json:-"), {"standard output", "twice"});
  check_refused(run("draw " + model + " -o svg:- --report -"), {"standard output", "twice"});
  check_refused(run("draw " + model + " -o -"), {"svg:-"});
  check_refused(run("draw " + model + " -o bmp:-"), {"bmp", ".svg"});
}

TEST_CASE("a standard output that takes nothing ends in one line, and no other file is put in place", "[cli]") {
  const Directory d;
  const std::string model = write(d / "cube.obj", cube);
  const auto refused = [&](const std::string& before, const std::string& after) {
    const std::string error = d / "error", png = d / "x.png";
    const std::string command = HSR_COMMAND + (" draw " + model + " -o svg:- -o " + png + " 2> " + error + " ");
    const int status = std::system(("bash -c 'set -o pipefail; " + before + command + after + "'").c_str());
    INFO(before << command << after);
    check_refused({WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents(error)}, {"standard output: cannot be written"});
    CHECK_FALSE(std::filesystem::exists(png));
  };
  refused("", "> /dev/full");
  refused("", ">&-");
  refused("{ sleep 0.5; ", "; } | true");  // who reads is gone
}

TEST_CASE("an oblique view is drawn, said in the title and the report, and passes the check", "[cli][V12]") {
  const Directory d;
  const std::string model = write(d / "cube.obj", cube);
  const Outcome o = run("draw " + model + " --oblique 45,0.5 --fill --check --size 128x128 -o " + (d / "x.svg") + " --report " +
                        (d / "r.json"));
  INFO(o.text);
  CHECK(o.status == 0);
  CHECK(contents(d / "x.svg").find("view: front, oblique 45,0.5") != std::string::npos);
  const json eye = json::parse(contents(d / "r.json"))["view"]["eye"];
  CHECK(eye[1] == -1);
  CHECK(eye[3] == 0);
  CHECK(std::abs(eye[0].get<double>() - std::sqrt(0.125)) < 1e-15);
  CHECK(run("order " + model + " --view top --oblique 270,1 --check --size 64x64 -o " + (d / "x.svg")).status == 0);
  CHECK(run("draw " + model + " --direction 1,-2,1 --oblique -30,0.5 -q -o " + (d / "x.svg")).status == 0);
  check_refused(run("draw " + model + " -o " + (d / "x.svg") + " --oblique 45"), {"--oblique", "\"45\"", "45,0.5"});
  check_refused(run("draw " + model + " -o " + (d / "x.svg") + " --oblique 45,0"), {"--oblique", "above 0"});
  check_refused(run("draw " + model + " -o " + (d / "x.svg") + " --oblique 45,1 --eye 1,2,3"), {"--oblique", "--eye"});
}

TEST_CASE("pieces of a face that crosses itself cover each place once", "[cli][P14]") {
  const Directory d;
  const std::string bow = write(d / "bow.obj", "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 -2 0\nf 1 2 3 4\n");
  for (const std::string method : {"depth-sort", "bsp"}) {
    const std::string made = run("order " + bow + " --view top --method " + method + " -o " + (d / "bow.json")).text;
    CHECK(made.find("2 pieces") != std::string::npos);
    CHECK(run("verify " + (d / "bow.json")).status == 0);
  }
}

TEST_CASE("a drawing that is a dot on the paper says how large it is, and what would show it", "[cli]") {
  const Directory d;
  const std::string model = write(d / "cube.obj", cube);
  const auto note = [&](const std::string& options) {
    return run("draw " + model + " --view front -o " + (d / "x.svg") + " " + options).text;
  };
  const std::string said = note("--scale 1:100");
  CHECK(said.find("note: the drawing is 0.01 x 0.01 mm on the paper, no more than a dot: if the model is in metres, --unit m "
                  "makes it 10 x 10 mm; --scale 100:1 or --scale fit shows it larger") != std::string::npos);
  CHECK(note("--scale 1:1000").find("0.001 x 0.001 mm") != std::string::npos);
  CHECK(note("--scale 1:100 --unit m").find("note:") == std::string::npos);
  CHECK(note("").find("note:") == std::string::npos);
  CHECK(note("--scale 2:1").find("note:") == std::string::npos);
}

TEST_CASE("each model of a scene has the unit and the up axis that its own file says", "[cli][O2][R7]") {
  const Directory d;
  // One triangle, (0,0,0) (0.5,0,0) (0,0.25,0), in metres and with y up.
  const std::string sign = write(d / "sign.gltf",
                                 R"({"asset": {"version": "2.0"}, "nodes": [{"mesh": 0}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
"bufferViews": [{"buffer": 0, "byteLength": 36}],
"buffers": [{"byteLength": 36,
"uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAAAAPwAAAAAAAAAAAAAAAAAAgD4AAAAA"}]})");
  // The same one, in millimetres and with z up, is beside it and 3 mm away; no double is 3 mm in metres.
  const std::string plate = write(d / "plate.obj", "v 1000 3 0\nv 1500 3 0\nv 1000 3 250\nf 1 2 3\n");
  const auto points = [&](const std::string& models) {
    const Outcome o = run("draw " + models + " --edges all -q -o " + (d / "x.json"));
    INFO(o.text);
    REQUIRE(o.status == 0);
    return points_of(json::parse(contents(d / "x.json")));
  };
  using Points = std::set<std::array<double, 3>>;
  CHECK(points(plate + " " + sign) == Points{{1000, 3, 0}, {1500, 3, 0}, {1000, 3, 250}, {0, 0, 0}, {500, 0, 0}, {0, 0, 250}});
  // The first model's up axis is the scene's: z up becomes y up, and what was 3 back along y is at z = -3.
  CHECK(points(sign + " " + plate) ==
        Points{{1000, 0, -3}, {1500, 0, -3}, {1000, 250, -3}, {0, 0, 0}, {500, 0, 0}, {0, 250, 0}});
  // Both are the same size on paper, by the scene's unit.
  for (const std::string& models : {plate + " " + sign, sign + " " + plate}) {
    const Outcome o = run("draw " + models + " --view front --scale 1:10 -o " + (d / "x.svg"));
    INFO(o.text);
    CHECK(o.text.find("0.1 mm per unit") != std::string::npos);
  }
  // What is given for all is no reason to convert anything.
  CHECK(points(plate + " " + sign + " --unit mm --up-axis z") ==
        Points{{1000, 3, 0}, {1500, 3, 0}, {1000, 3, 250}, {0, 0, 0}, {0.5, 0, 0}, {0, 0.25, 0}});
}
