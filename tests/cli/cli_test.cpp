// The command as a user meets it: runs it, and looks at what it prints, writes and returns.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/cli/run_command.h"

namespace fs = std::filesystem;
using nlohmann::json;
using namespace hsr::cli_tests;

TEST_CASE("draw writes every format that was asked for", "[cli][J5]") {
  const Directory d;
  const std::string model = write(d / "cube.obj", cube);
  const Outcome o = run("draw " + model + " -o " + (d / "a.svg") + " -o " + (d / "a.png") + " -o " + (d / "a.json") +
                        " --report " + (d / "r.json") + " --hidden dashed");
  CHECK(o.status == 0);
  CHECK(count(o.text, "\n") == 4);  // one for each file
  CHECK(contents(d / "a.svg").find("<svg") != std::string::npos);
  CHECK(contents(d / "a.png").rfind("\x89PNG", 0) == 0);
  const json lines = json::parse(contents(d / "a.json"));
  CHECK(lines["format"] == "hsr-lines/1");
  CHECK(lines["lines"].size() == 12);
  const json report = json::parse(contents(d / "r.json"));
  CHECK(report["format"] == "hsr-report/1");
  for (const char* key : {"seconds", "pairs", "decisions", "left_out", "memory_mb"}) CHECK(report.contains(key));
  CHECK(report["lines"]["visible_intervals"] == 9);
  CHECK(report["lines"]["hidden_intervals"] == 3);
  CHECK(d.files() == 5);
}

TEST_CASE("draw and order say what they wrote and at which scale", "[cli]") {
  const Directory d;
  const std::string model = write(d / "cube.obj", cube), svg = d / "a.svg", other = d / "a.json", picture = d / "a.png";
  const auto said = [&](const std::string& arguments) {
    const Outcome o = run(arguments);
    CHECK(o.status == 0);
    return o.text;
  };
  const std::string front = "draw " + model + " --view front -o " + svg;
  CHECK(said(front + " --scale 1:2") == "hsr: " + svg + ": 210 x 297 mm, scale 1:2 (0.5 mm per unit), 4 lines\n");
  CHECK(said(front + " --scale 1:2 --unit in") == "hsr: " + svg + ": 210 x 297 mm, scale 1:2 (12.7 mm per unit), 4 lines\n");
  // The page fits the drawing: a side of the cube is one unit, and there are two margins of 10 mm.
  CHECK(said(front + " --scale 20:1 --unit cm --page fit") ==
        "hsr: " + svg + ": 220 x 220 mm, scale 20:1 (200 mm per unit), 4 lines\n");
  // Found by fitting: 35 mm are left for one unit.
  CHECK(said(front + " --page 37x40mm --margin 1 --unit cm") ==
        "hsr: " + svg + ": 37 x 40 mm, scale 3.5:1 (35 mm per unit), 4 lines\n");
  CHECK(said(front + " --page 37.123x40mm --margin 1").find("37.123 x 40 mm, scale 35.12 mm per unit, 4 lines") !=
        std::string::npos);
  CHECK(said(front + " --scale 10000:1 --page fit").find("scale 10000:1 (10000 mm per unit)") != std::string::npos);
  CHECK(said("draw " + model + " --eye 3,-4,5 --scale 20:1 -o " + svg)
            .find("scale 20:1 at the target (20 mm per unit), 9 lines") != std::string::npos);
  CHECK(said("draw " + model + " --edges wire -o " + svg).find(svg + ": 210 x 297 mm, no lines\n") != std::string::npos);

  CHECK(said("draw " + model + " --view front --fill -o " + other + " -o " + picture + " --size 64x48 --report " + svg) ==
        "hsr: " + other + ": 8 lines, 1 fragment\nhsr: " + picture + ": 64 x 48 pixels\nhsr: " + svg + ": report\n");
  CHECK(json::parse(contents(other))["lines"].size() == 8);
  CHECK(said("draw " + model + " --view front --page A6 -o " + picture) == "hsr: " + picture + ": 620 x 874 pixels\n");
  CHECK(said("order " + model + " --view front --scale 5:1 -o " + svg + " -o " + other + " -o " + picture + " --size 64x48") ==
        "hsr: " + svg + ": 210 x 297 mm, scale 5:1 (5 mm per unit), 2 pieces\nhsr: " + other + ": 2 pieces\nhsr: " + picture +
            ": 64 x 48 pixels\n");
}

TEST_CASE("what was written is told on standard error, and with -q not at all", "[cli]") {
  const Directory d;
  const std::string model = write(d / "cube.obj", cube), order = d / "o.json";
  REQUIRE(run("order " + model + " -q -o " + order).text.empty());
  const auto streams = [&](const std::string& arguments) {
    const std::string out = d / "out", error = d / "error";
    CHECK(WEXITSTATUS(std::system((HSR_COMMAND + (" " + arguments) + " > " + out + " 2> " + error).c_str())) == 0);
    return std::pair(contents(out), contents(error));
  };
  for (const std::string& verb : {"draw " + model + " -o " + (d / "a.svg") + " -o " + (d / "a.png"),
                                  "order " + model + " -o " + (d / "a.json") + " -o " + (d / "a.svg"),
                                  "info " + model + " --mesh " + (d / "m.json"), "verify " + order + " -o " + (d / "v.svg")}) {
    const auto [out, error] = streams(verb + " --report -");
    INFO(verb << "\n" << error);
    CHECK(out.find("\"format\": \"hsr-report/1\"") != std::string::npos);
    CHECK(out.find("hsr: ") == std::string::npos);
    CHECK(count(error, "\n") == 1 + count(verb, " -o ") + count(verb, " --mesh "));
    CHECK(error.find("hsr: standard output: report\n") != std::string::npos);
    CHECK(streams(verb + " --report - -q").second.empty());
  }
  CHECK(streams("info " + model + " --mesh " + (d / "m.json")).second ==
        "hsr: " + (d / "m.json") + ": 6 faces, 12 triangles\n");
  CHECK(streams("verify " + order + " -o " + (d / "v.svg")).second == "hsr: " + (d / "v.svg") + ": no violations\n");
  CHECK(run("compare " + model + " -q --size 16 --runs 1 -o " + (d / "quiet")).text.empty());
}

TEST_CASE("help of each verb has examples, and says what is written", "[cli]") {
  const std::string all = run("--help").text;
  for (const std::string verb : {"draw", "info", "order", "verify", "compare", "stability", "explain"}) {
    INFO(verb);
    CHECK(count(all, "\n  " + verb + " ") == 1);
    const Outcome help = run(verb + " --help");
    CHECK(help.status == 0);
    CHECK(count(help.text, "\n  hsr " + verb + " ") >= 3);
    CHECK(count(help.text, "\nWrites ") == 1);
    CHECK(count(help.text, "-q,--quiet") == 1);
    CHECK(help.text.find("xit status") != std::string::npos);
  }
}

TEST_CASE("a box seen face-on is four lines, hidden ones asked for or not", "[cli]") {
  const Directory d;
  const std::string model = write(d / "cube.obj", cube);
  for (const std::string hidden : {"none", "dashed", "solid"}) {
    REQUIRE(run("draw " + model + " -o " + (d / "a.svg") + " --view front --report " + (d / "r.json") + " --hidden " + hidden)
                .status == 0);
    CHECK(json::parse(contents(d / "r.json"))["drawing"]["polylines"] == 1);  // the four, joined
    CHECK(count(contents(d / "a.svg"), "<path") == 1);
  }
}

TEST_CASE("exact numbers are strings", "[cli]") {
  const Directory d;
  const std::string model = write(d / "cube.obj", cube);
  REQUIRE(run("draw " + model + " -o " + (d / "a.json") + " --exact --why --view iso").status == 0);
  const json lines = json::parse(contents(d / "a.json"));
  CHECK(lines["view"]["eye"] == json({"1", "-1", "1", "0"}));
  CHECK(lines["view"]["near"].is_null());
  for (const json& line : lines["lines"]) {
    CHECK(line["visible"].size() + line["hidden"].size() == 1);
    if (!line["hidden"].empty()) {
      CHECK(line["hidden"][0] == json({"0", "1"}));
      CHECK_FALSE(line["by"].empty());
    }
  }
}

TEST_CASE("the same bytes for any number of threads", "[cli][M5]") {
  const Directory d;
  std::string scene;
  for (int i = 0; i < 60; ++i) {
    const int x = i * 37 % 101, y = i * 53 % 97, z = i * 71 % 89;
    scene += "v " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
  }
  for (int i = 1; i <= 58; ++i)
    scene += "f " + std::to_string(i) + " " + std::to_string(i % 60 + 1) + " " + std::to_string((i * 7 + 3) % 60 + 1) + "\n";
  const std::string model = write(d / "soup.obj", scene);
  for (const std::string n : {"1", "2", "5"}) {
    REQUIRE(run("draw " + model + " -q --edges all --hidden dashed -o " + (d / (n + ".json")) + " -o " + (d / (n + ".svg")) +
                " --threads " + n)
                .status == 0);
    CHECK(contents(d / (n + ".json")) == contents(d / "1.json"));
    CHECK(contents(d / (n + ".svg")) == contents(d / "1.svg"));
  }
}

TEST_CASE("bad usage is one line that says what was expected", "[cli][M4]") {
  const Directory d;
  const std::string model = write(d / "cube.obj", cube), out = " -o " + (d / "a.svg");
  check_refused(run("draw " + (d / "none.obj") + out), {"none.obj"});
  check_refused(run("draw " + model), {"--output"});
  check_refused(run("draw " + model + " -o " + (d / "a.bmp")), {".bmp", ".pdf", ".dxf", ".tex", ".hpgl"});
  check_refused(run("draw " + model + " --scale 6000:1 -o " + (d / "a.pdf") + " --page fit"), {"pdf", "5080"});
  check_refused(run("draw " + model + " -o " + (d / "a.bmp")), {"svg", "png", "json"});
  check_refused(run("draw " + model + out + " --view aslant"), {"aslant", "iso"});
  check_refused(run("draw " + model + out + " --view iso --eye 1,2,3"), {"--view", "--eye"});
  check_refused(run("draw " + model + out + " --eye 1,2"), {"1,2", "X,Y,Z"});
  check_refused(run("draw " + model + out + " --eye nan,2,3"), {"nan", "X,Y,Z"});
  check_refused(run("draw " + model + out + " --eye 0.5,0.5,0.5"), {"--target"});
  check_refused(run("draw " + model + out + " --direction 0,0,0"), {"direction"});
  check_refused(run("draw " + model + out + " --direction 0,0,1 --up 0,0,2"), {"up"});
  check_refused(run("draw " + model + out + " --near 1"), {"--eye"});
  check_refused(run("draw " + model + out + " --eye 5,5,5 --near 0"), {"--near: found 0,"});
  check_refused(run("draw " + model + out + " --eye 5,5,5 --fov 180"), {"180"});
  check_refused(run("draw " + model + out + " --edges outline,blunt"), {"blunt", "sharp"});
  check_refused(run("draw " + model + out + " --page A9"), {"A9"});
  check_refused(run("draw " + model + out + " --scale big"), {"big"});
  check_refused(run("draw " + model + out + " --method appel --why"), {"appel", "roberts"});
  check_refused(run("draw " + model + out + " --threads 0"), {"threads"});
  check_refused(run("draw " + model + out + " --size 0x5"), {"0x5"});
  check_refused(run("draw " + model + " -o " + (d / "no/such/a.svg")), {"no/such"});
  check_refused(run("stability"), {"--output"});
  check_refused(run("stability -o " + model), {"cube.obj", "directory"});
  check_refused(run("stability" + out + " --family gap,gaps"), {"--family", "found \"gaps\"", "gap, ulp"});
  check_refused(run("stability" + out + " --size 8"), {"--size", "found 8"});
  check_refused(run("compare " + model + " -o " + model), {"cube.obj", "directory"});
  check_refused(run("compare " + model + out + " --size 8"), {"--size", "found 8"});
  check_refused(run("compare " + model + out + " --runs 0"), {"--runs", "found 0"});
  check_refused(run("order " + model + out + " --method best"), {"best", "depth-sort"});
  check_refused(run("order " + model + out + " --opacity 0"), {"--opacity", "found 0"});
  check_refused(run("verify " + (d / "no.json")), {"no.json"});
  check_refused(run("drow " + model + out), {"drow", "draw"});
  check_refused(run("draw " + model + out + " --crease 181"), {"--crease", "181"});
  check_refused(run(""), {"--help"});
  CHECK(d.files() == 1);  // nothing half written
}

TEST_CASE("compare writes a page that needs nothing else, a table, a report, pictures and plots", "[cli][compare]") {
  const Directory d;
  const std::string model = write(d / "cube.obj", cube);
  const Outcome outcome = run("compare " + model + " -o " + (d / "out/cube") + " --size 64 --runs 2");
  INFO(outcome.text);
  REQUIRE(outcome.status == 0);
  const std::string page = contents(d / "out/cube/index.html");
  CHECK(page.find("<!DOCTYPE html>") == 0);
  CHECK(page.find("src=\"http") == std::string::npos);
  CHECK(page.find("href=\"http") == std::string::npos);
  CHECK(page.size() < 5'000'000);
  // What names of methods lead to is there.
  std::size_t links = 0;
  for (std::size_t at = page.find("href=\""); at != std::string::npos; at = page.find("href=\"", at + 1), ++links) {
    const std::size_t from = at + 6;
    CHECK(fs::exists(d / ("out/cube/" + page.substr(from, page.find('"', from) - from))));
  }
  CHECK(links > 10);
  const auto report = nlohmann::json::parse(contents(d / "out/cube/report.json"));
  std::size_t exact = 0;
  for (const auto& m : report["methods"]) {
    CHECK(m["edge"].get<int>() + m["tie"].get<int>() + m["order"].get<int>() == m["wrong"].get<int>());
    if (m["space"] != "object" || m["numbers"] == "doubles only") continue;
    CHECK(m["wrong"] == 0);
    CHECK(m["wrong_area_share"] == 0);
    ++exact;
  }
  CHECK(exact >= 4);
  CHECK(report["growth"].size() == 4);
  std::vector<std::string> culling, coherence;
  for (const auto& s : report["stages"]) {
    if (s["kind"] == "culling") culling.push_back(s["stage"]);
    if (s["kind"] == "coherence")
      coherence.push_back(s["stage"].get<std::string>().substr(0, s["stage"].get<std::string>().find(':')));
    // Of a closed cube nothing that is culled is seen, and the twelve triangles are larger than two samples.
    if (s["kind"] == "culling") CHECK(s["result"].get<std::string>().find("changes nothing") != std::string::npos);
  }
  CHECK(culling.size() == 7);
  CHECK(coherence == std::vector<std::string>{"object", "face", "edge", "scanline", "area", "span", "depth", "frame"});
  REQUIRE(report["supersampling"].size() == 12);
  // By the exact order: the more samples, the closer.
  for (const int k : {9, 10, 11})
    CHECK(report["supersampling"][k]["mean_difference"] < report["supersampling"][k - 1]["mean_difference"]);
  CHECK(report["supersampling"][11]["mean_difference"].get<double>() < 1);
  REQUIRE(report["transparency"].size() == 6);
  for (const auto& t : report["transparency"]) CHECK(t["mean_difference"].get<double>() < 10);
  // More samples come closer.
  CHECK(report["transparency"][4]["mean_difference"] < report["transparency"][2]["mean_difference"]);
  CHECK(contents(d / "out/cube/table.csv").find("\"z-buffer\",\"float\"") != std::string::npos);
  CHECK(fs::exists(d / "out/cube/pictures/exact.png"));
  CHECK(fs::exists(d / "out/cube/plots/area-against-time.svg"));
}

TEST_CASE("stability writes a page that needs nothing else, a table, a report and plots", "[cli][stability]") {
  const Directory d;
  const Outcome outcome = run("stability --quick --size 32 --family gap --family sliver,ulp -o " + (d / "out/stiff"));
  INFO(outcome.text);
  REQUIRE(outcome.status == 0);
  CHECK(outcome.text == "hsr: " + (d / "out/stiff") + ": 6 files, open " + (d / "out/stiff/index.html") + "\n");
  const std::string page = contents(d / "out/stiff/index.html");
  CHECK(page.find("<!DOCTYPE html>") == 0);
  CHECK(page.find("src=\"http") == std::string::npos);
  CHECK(page.find("href=") == std::string::npos);
  const json report = json::parse(contents(d / "out/stiff/report.json"));
  CHECK(report["defects"].empty());
  REQUIRE(report["families"].size() == 3);
  for (const json& f : report["families"]) {
    CHECK(fs::exists(d / ("out/stiff/plots/" + f["family"].get<std::string>() + ".svg")));
    for (const json& m : f["methods"]) {
      CHECK(m["outcomes"].size() == f["values"].size());
      if (m["exact"]) CHECK(m["breakdown"].is_null());
      if (f["family"] == "gap" && m["numbers"] == "fixed 24") CHECK(m["breakdown"].get<double>() < 1e-4);
    }
  }
  CHECK(contents(d / "out/stiff/table.csv").find("gap,\"gap\",1,") != std::string::npos);
  CHECK(run("stability -q --quick --size 16 --family ulp -o " + (d / "quiet")).text.empty());
}

TEST_CASE("bad models are one line with file and line", "[cli]") {
  const Directory d;
  check_refused(run("info " + write(d / "a.obj", "v 0 0 0\nv 1 0 zero\nf 1 2 1\n")), {"a.obj", "line 2", "zero"});
  check_refused(run("info " + write(d / "b.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 4\n")), {"b.obj", "line 4", "4"});
  check_refused(run("info " + write(d / "c.obj", "")), {"c.obj", "empty"});
  check_refused(run("info " + write(d / "d.step", "ISO-10303-21;")), {"d.step"});
  check_refused(run("info " + (d / "")), {});
}

TEST_CASE("a model of faces without area gives an empty drawing and says so", "[cli]") {
  const Directory d;
  const std::string model = write(d / "line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
  const Outcome o = run("draw " + model + " -o " + (d / "a.svg"));
  CHECK(o.status == 0);
  CHECK(o.text.find("no area") != std::string::npos);
  CHECK(contents(d / "a.svg").find("</svg>") != std::string::npos);
}

TEST_CASE("an empty drawing says why", "[cli]") {
  const Directory d;
  const std::string model = write(d / "cube.obj", cube), out = " -o " + (d / "a.svg");
  for (const std::string options :
       {"--eye 3,3,3 --near 100", "--eye 3,3,3 --target 9,9,9", "--edges wire", "--scale 1:1000000"}) {
    const Outcome o = run("draw " + model + out + " " + options);
    CHECK(o.status == 0);
    CHECK(o.text.find("the drawing is empty: ") != std::string::npos);
    CHECK((o.text.find("0.01 mm at scale 1:1000000") != std::string::npos) == options.starts_with("--scale"));
  }
}

TEST_CASE("a report on standard output is nothing but JSON", "[cli]") {
  const Directory d;
  const std::string model = write(d / "cube.obj", cube);
  CHECK(json::parse(run("info " + model + " -q --report -").text)["triangles"] == 12);
  CHECK(json::parse(run("draw " + model + " -q -o " + (d / "a.svg") + " --report -").text)["method"] == "none");
}

TEST_CASE("an eye inside the model frames 90 degrees and says so", "[cli][V11]") {
  const Directory d;
  const std::string model = write(d / "cube.obj", cube);
  CHECK(run("draw " + model + " -o " + (d / "a.svg") + " --eye 0.25,0.5,0.75").text.find("90") != std::string::npos);
  CHECK(run("draw " + model + " -o " + (d / "a.svg") + " --eye 0.25,0.5,0.75 -q").text.empty());
}

TEST_CASE("info says what a model is", "[cli]") {
  const Directory d;
  const std::string model = write(d / "cube.obj", cube);
  const Outcome o = run("info " + model + " --mesh " + (d / "m.json") + " --report " + (d / "r.json"));
  CHECK(o.status == 0);
  for (const char* word : {"6 quads", "closed      yes", "manifold    yes", "components  1", "defects     none"})
    CHECK(o.text.find(word) != std::string::npos);
  const json mesh = json::parse(contents(d / "m.json"));
  CHECK(mesh["format"] == "hsr-mesh/1");
  CHECK(mesh["faces"].size() == 6);
  CHECK(json::parse(contents(d / "r.json"))["bits"] == 1);
}

namespace {

/// n x n towers of different heights.
std::string towers(int n) {
  std::string text;
  for (int i = 0; i < n * n; ++i) {
    const int x = i % n * 3, y = i / n * 3, height = 1 + i * 7 % 5;
    for (int k = 0; k < 8; ++k)
      text +=
          "v " + std::to_string(x + k % 2) + " " + std::to_string(y + k / 2 % 2) + " " + std::to_string(k / 4 * height) + "\n";
    const auto corner = [&](int k) { return " " + std::to_string(8 * i + k); };
    for (const std::array<int, 4>& f :
         std::vector<std::array<int, 4>>{{1, 3, 4, 2}, {5, 6, 8, 7}, {1, 2, 6, 5}, {3, 7, 8, 4}, {1, 5, 7, 3}, {2, 4, 8, 6}})
      text += "f" + corner(f[0]) + corner(f[1]) + corner(f[2]) + corner(f[3]) + "\n";
  }
  return text;
}

std::string why_left_out(const std::string& report, const std::string& stage) {
  const json all = json::parse(contents(report));
  for (const json& entry : all["left_out"])
    if (entry["stage"] == stage) return entry["why"];
  return "";
}

}  // namespace

TEST_CASE("a drawing is the same with and without each stage", "[cli][M2]") {
  const Directory d;
  const std::string model = write(d / "towers.obj", towers(6));
  const std::string views[] = {"", " --view front", " --eye 9.5,9.25,1.5 --target 14,15,1", " --eye 9.5,9.25,1.5 --fov 20",
                               " --eye 30,-20,15 --fov 12 --page fit --scale 1:1"};
  for (const std::string& view : views) {
    const auto drawn = [&](const std::string& stages) {
      const Outcome o = run("draw " + model + view + " -q --hidden dashed --edges all -o " + (d / "a.svg") + " --report " +
                            (d / "r.json") + " --stages " + stages);
      INFO(o.text);
      CHECK(o.status == 0);
      return contents(d / "a.svg");
    };
    const std::string without = drawn("all=never");
    CHECK(count(without, "<path") > 5);
    for (const char* stages : {"all=auto", "all=always", "all=never,frame=always", "all=never,back-faces=always",
                               "all=never,hidden-tiles=always", "all=never,far-faces=always", "all=never,convex-body=always"})
      CHECK(drawn(stages) == without);
    drawn("all=always");
    const bool has_frame = view.find("--eye") != std::string::npos;
    CHECK((why_left_out(d / "r.json", "edges").find("outside the picture") != std::string::npos) == has_frame);
    CHECK(why_left_out(d / "r.json", "back faces").find("closed bodies") != std::string::npos);
  }
}

const char* const window =
    "v 0 0 0\nv 6 0 0\nv 6 6 0\nv 0 6 0\nv 2 2 1\nv 4 2 1\nv 4 4 1\nv 2 4 1\no wall\nf 1 2 3 4\no pane\nf 5 6 7 8\n";

TEST_CASE("fill draws the visible faces, and JSON has them as rings", "[cli][D8][J3]") {
  const Directory at;
  const std::string model = write(at / "window.obj", window);
  const Outcome o = run("draw " + model + " -o " + (at / "w.svg") + " -o " + (at / "w.json") + " -o " + (at / "w.png") +
                        " --view top --fill --exact --report " + (at / "r.json"));
  CHECK(o.status == 0);
  CHECK(contents(at / "w.svg").find("id=\"fills\"") != std::string::npos);
  const json fragments = json::parse(contents(at / "w.json"))["fragments"];
  REQUIRE(fragments.size() == 2);
  CHECK(fragments[0] ==
        json::parse(R"({"face": 0, "object": 0, "rings": [[["0", "0", "0"], ["6", "0", "0"], ["6", "6", "0"], ["0", "6", "0"]],
                                        [["2", "2", "0"], ["2", "4", "0"], ["4", "4", "0"], ["4", "2", "0"]]]})"));
  CHECK(fragments[1]["rings"].size() == 1);
  const json report = json::parse(contents(at / "r.json"))["fragments"];
  CHECK(report["visible_area"] == "36");
  CHECK(report["visible_area_of_faces"] == json::parse(R"([[0, "32"], [1, "4"]])"));
  CHECK(report["visible_area_of_objects"] == json::parse(R"([["wall", "32"], ["pane", "4"]])"));
  CHECK_FALSE(json::parse(contents(at / "r.json")).contains("check"));
}

TEST_CASE("check says that the fragments are right", "[cli]") {
  const Directory at;
  const std::string model = write(at / "window.obj", window);
  for (const std::string view : {"--view top", "--direction 1,2,3", "--eye 9,9,9"}) {
    const Outcome o = run("draw " + model + " -o " + (at / "w.svg") + " --check --size 60x50 " + view);
    CHECK(o.status == 0);
    CHECK(o.text.find("nearest face at each of 3000 samples") != std::string::npos);
    CHECK(o.text.find("a z-buffer of floats shows another face at ") != std::string::npos);
    CHECK(o.text.find("unexplained") == std::string::npos);
  }
  CHECK(run("draw " + model + " -o " + (at / "w.svg") + " --merge all").status == 2);
}

TEST_CASE("a csv has error against time up to the size asked for", "[cli][K2]") {
  const Directory at;
  const std::string model = write(at / "window.obj", window);
  const Outcome o = run("draw " + model + " -o " + (at / "w.csv") + " --size 512x300 --report " + (at / "r.json"));
  CHECK(o.status == 0);
  const std::string csv = contents(at / "w.csv");
  CHECK(count(csv, "\n") == 6);
  CHECK(count(csv, "z-buffer,float") == 2);
  CHECK(count(csv, "\nz-buffer,double,1,512,512,3,") == 1);
  CHECK(count(csv, "\nfragments,exact,") == 1);
  CHECK(json::parse(contents(at / "r.json"))["seconds"].contains("error against time"));
  REQUIRE(run("draw " + model + " -q -o " + (at / "small.csv") + " --size 100x90").status == 0);
  CHECK(count(contents(at / "small.csv"), "\nz-buffer,float,1,100,100,") == 1);
  check_refused(run("order " + model + " -o " + (at / "w.csv")), {".csv", ".svg, .pdf, .eps, .tex, .png or .json"});
}

TEST_CASE("a picture that has no exact samples is refused", "[cli]") {
  const Directory at;
  const std::string model = write(at / "far.obj", "v 1e16 0 0\nv 10000000000000002 0 0\nv 1e16 1 0\nf 1 2 3\n");
  const std::string view = " --eye 10000000000000004,3,5 --size 64x64 -o ";
  const std::vector<std::string> words = {"far from the origin", "expected a model nearer"};
  check_refused(run("draw " + model + view + (at / "a.csv")), words);
  check_refused(run("draw " + model + " --check" + view + (at / "a.svg")), words);
  check_refused(run("order " + model + " --check" + view + (at / "a.json")), words);
  CHECK(run("order " + model + view + (at / "a.json") + " -o " + (at / "a.png")).status == 0);
}

TEST_CASE("JSON has the edges outside the frame, too", "[cli][V10]") {
  const Directory d;
  const std::string model = write(d / "towers.obj", towers(4));
  const std::string view = " --eye 30,-20,15 --edges all -q -o " + (d / "a.json") + " -o " + (d / "a.svg");
  REQUIRE(run("draw " + model + view).status == 0);
  const std::string all = contents(d / "a.json");
  CHECK(json::parse(all)["lines"].size() == 16 * 12);
  REQUIRE(run("draw " + model + view + " --fov 5").status == 0);
  CHECK(contents(d / "a.json") == all);
  const Outcome beside = run("draw " + model + " --eye 30,-20,15 --target 60,-20,15 --fov 5 -o " + (d / "b.svg"));
  CHECK(beside.status == 0);
  CHECK(beside.text.find("is in the picture: see --target, --fov") != std::string::npos);
}

TEST_CASE("info says what a drawing can do without", "[cli]") {
  const Directory d;
  const Outcome one = run("info " + write(d / "cube.obj", cube));
  CHECK(one.text.find("no edge needs a test") != std::string::npos);
  CHECK(one.text.find("convex body: all of it") != std::string::npos);
  const std::string model = write(d / "towers.obj", towers(6));
  const Outcome many = run("info " + model + " --edges all --view top --report " + (d / "r.json"));
  CHECK(many.status == 0);
  CHECK(many.text.find("view top, edges all: method ") != std::string::npos);
  CHECK(why_left_out(d / "r.json", "back faces") == "72 of 432 triangles and 0 of 432 edges are far sides of 36 closed bodies");
  check_refused(run("info " + model + " --stages back-faces"), {"--stages", "back-faces", "always"});
  check_refused(run("info " + model + " --stages fog=never"), {"--stages", "fog", "far-faces"});
}

#ifndef __SANITIZE_ADDRESS__  // which needs more memory than any limit
TEST_CASE("what does not fit into memory is refused with the bound", "[cli]") {
  const Directory d;
  const std::string model = write(d / "towers.obj", towers(150));
  // The shell sets a limit for what it runs.
  const auto limited = [&](int megabytes) {
    return run("draw " + model + " -q --edges all -o " + (d / "a.svg") + " -o " + (d / "a.json") + " < /dev/null",
               "ulimit -d " + std::to_string(megabytes * 1024) + "; ");
  };
  check_refused(limited(60), {"out of memory", "limit 0.1 GB", "expected fewer faces"});
  CHECK(d.files() == 1);
  CHECK(limited(4000).status == 0);
}
#endif

TEST_CASE("glTF says which axis is up, what the unit is, and through which cameras to look", "[cli][R7][R15]") {
  const Directory d;
  // One triangle, (0,0,0) (2,0,0) (0,1,0), and two cameras: one looks along -z, one has no field of view.
  const std::string points = "AAAAAAAAAAAAAAAAAAAAQAAAAAAAAAAAAAAAAAAAgD8AAAAA";
  const std::string gltf = write(
      d / "a.gltf",
      R"({"asset": {"version": "2.0"}, "nodes": [{"mesh": 0}, {"name": "Street", "camera": 0, "translation": [1, 0.5, 5]}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
"cameras": [{"type": "perspective", "perspective": {"yfov": 1, "znear": 0.5}}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
"bufferViews": [{"buffer": 0, "byteLength": 36}],
"buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,)" +
          points + "\"}]}");
  const std::string up = "hsr: note: glTF has y up by its specification: --up-axis y is the default\n";
  const std::string metres = "hsr: note: glTF has a unit of m by its specification: --unit m is the default\n";
  const std::string svg = d / "a.svg", start = "draw " + gltf + " -o " + svg;
  CHECK(run(start + " --view front --scale 1:100").text ==
        up + metres + "hsr: " + svg + ": 297 x 210 mm, scale 1:100 (10 mm per unit), 3 lines\n");
  CHECK(run(start + " --view front --scale 1:1 --unit mm --up-axis y").text.find("note") == std::string::npos);
  CHECK(run(start + " --view front --up-axis z").text.find("1 line") != std::string::npos);  // seen edge-on
  const Outcome street = run(start + " --view camera:Street -o " + (d / "a.json"));
  CHECK(street.status == 0);
  CHECK(street.text.find("note") == std::string::npos);
  const json view = json::parse(contents(d / "a.json"))["view"];
  CHECK(view["eye"] == json::array({1.0, 0.5, 5.0, 1.0}));
  CHECK(view["near"] == 0.1);  // half a unit, of the 5 to the middle of the model
  check_refused(run(start + " --view camera:Roof"), {"\"camera:Roof\"", "\"camera:Street\""});
  check_refused(run(start + " --view camera:Street --target 1,2,3"), {"--target"});
  const std::string model = write(d / "cube.obj", cube);
  check_refused(run("draw " + model + " -o " + svg + " --view camera:Street"), {"the model has no cameras"});
}
