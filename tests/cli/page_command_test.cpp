// What is said of the page: pens, standard scales, the order for a plotter, the outline alone, ids.
#include <catch2/catch.hpp>
#include <cmath>
#include <regex>
#include <string>

#include "tests/cli/run_command.h"

using namespace hsr::cli_tests;

namespace {

/// Two boxes of an object each, the second one behind and above the first.
const char* const boxes =
    "o near\nv 0 0 0\nv 40 0 0\nv 0 20 0\nv 40 20 0\nv 0 0 30\nv 40 0 30\nv 0 20 30\nv 40 20 30\n"
    "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n"
    "o far\nv 50 30 5\nv 80 30 5\nv 50 50 5\nv 80 50 5\nv 50 30 60\nv 80 30 60\nv 50 50 60\nv 80 50 60\n"
    "f 9 11 12 10\nf 13 14 16 15\nf 9 10 14 13\nf 11 15 16 12\nf 9 13 15 11\nf 10 12 16 14\n";

}  // namespace

TEST_CASE("pens are asked for by name, on the command line or in a file", "[cli][D15]") {
  const Directory d;
  const std::string model = write(d / "boxes.obj", boxes), pens = write(d / "my.pens", "visible=0.7\nhidden=:#888\n");
  const auto drawn = [&](const std::string& arguments, const std::string& format = "svg") {
    const Outcome outcome = run("draw " + model + " --hidden dashed -q -o " + (d / ("a." + format)) + " " + arguments);
    INFO(outcome.text);
    REQUIRE(outcome.status == 0);
    return contents(d / ("a." + format));
  };
  const std::string plain = drawn("");
  CHECK(drawn("--pen visible=0.5,hidden=0.25::dashed") == plain);
  CHECK(drawn("--page A6") != drawn("--page A6 --pen visible=0.5"));
  const std::string pened = drawn("--pens " + pens + " --pen outline=1:red --pen hidden-sharp=0.18");
  const auto layer = [&](const std::string& id) {
    const std::size_t at = pened.find("id=\"" + id + '"');
    REQUIRE(at != std::string::npos);
    return pened.substr(at, pened.find('>', at) - at);
  };
  CHECK(layer("visible-outline").find("stroke=\"#ff0000\"") != std::string::npos);
  CHECK(layer("visible-outline").find("stroke-width=\"1\"") != std::string::npos);
  CHECK(layer("visible-sharp").find("stroke=\"#000\"") != std::string::npos);
  CHECK(layer("visible-sharp").find("stroke-width=\"0.7\"") != std::string::npos);
  CHECK(layer("hidden-sharp").find("stroke=\"#888888\"") != std::string::npos);
  CHECK(layer("hidden-sharp").find("stroke-width=\"0.18\"") != std::string::npos);
  CHECK(layer("hidden-sharp").find("stroke-dasharray=\"2.16 0.54\"") != std::string::npos);
  CHECK(drawn("--pen visible=0.33:#f00 --dxf 2000", "dxf").find("VISIBLE_SHARP\n70\n0\n62\n1\n6\nCONTINUOUS\n370\n35\n") !=
        std::string::npos);
  CHECK(drawn("--pen visible=0.35:#102030", "tex").find("draw={rgb,255:red,16;green,32;blue,48}") != std::string::npos);

  const std::string ask = "draw " + model + " -o " + (d / "b.svg");
  check_refused(run(ask + " --pen edges=1"), {"found \"edges\"", "visible, hidden, outline, sharp"});
  check_refused(run(ask + " --pens " + (d / "none")), {"--pens", "none", "cannot be read"});
  check_refused(run(ask + " --pens /"), {"--pens", "cannot be read"});
  check_refused(run(ask + " --pens " + write(d / "bad.pens", "visible=1\nsharp=x\n")), {"bad.pens:2", "found \"x\""});
}

TEST_CASE("the standard scale is the largest of the series that fits, and is told", "[cli][D17]") {
  const Directory d;
  const std::string model = write(d / "boxes.obj", boxes);
  const auto drawn = [&](const std::string& arguments) {
    const Outcome outcome = run("draw " + model + " --view front -o " + (d / "a.svg") + " " + arguments);
    INFO(outcome.text);
    REQUIRE(outcome.status == 0);
    return std::pair(outcome.text, contents(d / "a.svg"));
  };
  // 80 by 60 mm; the page less its margins is 277 by 190.
  for (const auto& [page, scale] :
       {std::pair{"A4", "2:1"}, {"A6", "1:1"}, {"A1", "5:1"}, {"100x80mm", "1:1"}, {"99x80mm", "1:2"}, {"30x30mm", "1:10"}}) {
    const std::string on = std::string("--page ") + page;
    const auto [said, standard] = drawn(on + " --scale standard");
    CHECK(said.find(std::string("scale ") + scale + " (") != std::string::npos);
    CHECK(standard == drawn(on + " --scale " + scale).second);
    CHECK(standard.find(std::string("<desc>view: front, scale ") + scale + "</desc>") != std::string::npos);
  }
  CHECK(drawn("--unit m --scale standard").second == drawn("--unit m --scale 1:500").second);
  CHECK(drawn("").second.find("scale") == std::string::npos);
}

TEST_CASE("a drawing for a plotter tells its ways, and has the same bytes for any number of threads", "[cli][D18]") {
  const Directory d;
  const std::string model = write(d / "boxes.obj", boxes);
  const auto drawn = [&](const std::string& arguments) {
    const Outcome outcome = run("draw " + model + " -o " + (d / "a.hpgl") + " " + arguments);
    REQUIRE(outcome.status == 0);
    return std::pair(outcome.text, contents(d / "a.hpgl"));
  };
  CHECK(drawn("").first.find("pen ") == std::string::npos);
  const auto [said, bytes] = drawn("--sort pen --threads 1");
  CHECK(std::regex_search(said, std::regex("pen down [0-9.]+ m, up [0-9.]+ m\n")));
  CHECK(drawn("--sort pen --threads 3").second == bytes);
  CHECK(run("draw " + model + " --sort up -o " + (d / "a.hpgl")).status == 2);
}

TEST_CASE("circles of the model are told, and written as such where the format has them", "[cli][D22]") {
  const Directory d;
  std::string disc, face = "f";
  for (int k = 0; k < 96; ++k) {
    const double t = k * 3.14159265358979 / 48;
    disc += "v " + std::to_string(30 * std::cos(t)) + " " + std::to_string(30 * std::sin(t)) + " 0\n";
    face += " " + std::to_string(k + 1);
  }
  const std::string model = write(d / "disc.obj", disc + face + "\n");
  const std::string ask = "draw " + model + " --view top --scale 1:1 --margin 0 --page 60x60mm -o " + (d / "a.svg") + " -o " +
                          (d / "a.dxf") + " --report " + (d / "r.json");
  CHECK(run(ask).text.find(" 96 lines\n") != std::string::npos);
  const Outcome outcome = run(ask + " --fit-arcs 0.05");
  INFO(outcome.text);
  CHECK(count(outcome.text, ", no lines, 1 arc\n") == 2);
  CHECK(count(contents(d / "a.svg"), "A30 30 0 0 ") == 3);
  CHECK(count(contents(d / "a.dxf"), "\nCIRCLE\n") == 1);
  CHECK(contents(d / "r.json").find("\"arcs\": 1") != std::string::npos);
  CHECK(run(ask + " --fit-arcs 0.01").text.find(" 96 lines\n") != std::string::npos);  // the middle of an edge is 0.016 mm off
  REQUIRE(run("order " + model + " --view top --scale 1:1 --fit-arcs 0.05 -q -o " + (d / "o.svg")).status == 0);
  CHECK(count(contents(d / "o.svg"), "A30 30 0 0 ") == 3);
  for (const char* const wrong : {"0", "-1", "x", "nan", "inf"})
    check_refused(run("draw " + model + " -o " + (d / "b.svg") + " --fit-arcs=" + wrong), {"--fit-arcs", wrong, "more than 0"});
}

TEST_CASE("the outline alone is closed rings in each format, without fills", "[cli][D19]") {
  const Directory d;
  const std::string model = write(d / "boxes.obj", boxes);
  const Outcome outcome = run("draw " + model + " --view front --outline-only --scale 1:1 -q -o " + (d / "a.svg") + " -o " +
                              (d / "a.dxf") + " -o " + (d / "a.hpgl") + " -o " + (d / "a.tex"));
  INFO(outcome.text);
  REQUIRE(outcome.status == 0);
  const std::string svg = contents(d / "a.svg");
  CHECK(count(svg, "<path") == 2);
  CHECK(count(svg, "Z\"/>") == 2);
  CHECK(count(contents(d / "a.dxf"), "\nPOLYLINE\n") == 2);
  CHECK(count(contents(d / "a.hpgl"), "PU") == 3);
  CHECK(count(contents(d / "a.tex"), "--cycle") == 2);
  check_refused(run("draw " + model + " --outline-only -o " + (d / "a.json")), {"--outline-only", "json"});
}

TEST_CASE("a painting order has the pages and the pens of a drawing", "[cli][order][D15][D20][D21]") {
  const Directory d;
  const std::string model = write(d / "boxes.obj", boxes);
  const std::string pens = " --pen visible=0.35:red --scale 1:1 --page A5 --id-prefix left_ -q -o ";
  REQUIRE(run("order " + model + pens + (d / "o.svg")).status == 0);
  REQUIRE(run("draw " + model + pens + (d / "d.svg")).status == 0);
  const std::string order = contents(d / "o.svg"), drawing = contents(d / "d.svg");
  // The same lines on the same page, over the pieces.
  const std::string lines = drawing.substr(drawing.find("<g id=\"left_visible"));
  CHECK(count(lines, "stroke=\"#ff0000\"") > 0);
  CHECK(order.find(lines) != std::string::npos);
  CHECK(order.substr(0, order.find(">")) == drawing.substr(0, drawing.find(">")));
  CHECK(count(order, "Z\" fill=\"#") > 0);
  // A rod over a plate is a piece of its own, drawn on top.
  const std::string rod = write(d / "rod.obj", "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 1 1 2\nv 3 3 2\nf 1 2 3 4\nl 5 6\n");
  const Outcome wires = run("order " + rod + " --view top --edges wire -o " + (d / "w.svg") + " -o " + (d / "w.json"));
  CHECK(wires.status == 0);
  CHECK(count(contents(d / "w.svg"), "visible wire") > 0);
  CHECK(count(wires.text, "1 piece, 1 part of wires\n") == 2);
  CHECK(contents(d / "w.json").find("{\"wire\": [4, 5], \"points\": [[1, 1, 2], [3, 3, 2]]}\n]}") != std::string::npos);
  const Outcome right = run("verify " + (d / "w.json"));
  CHECK(right.status == 0);
  CHECK(right.text.find("correct: 1 piece and 1 part of wires, each of 1 overlapping pairs") != std::string::npos);
  const Outcome wrong = run("verify " + (d / "w.json") + " --view bottom");
  CHECK(wrong.status == 1);
  CHECK(wrong.text.find("piece 0 (face 0) is painted before piece 1 (of a wire), but is the nearer") != std::string::npos);
  // Under a pane it is painted first, and seen through it.
  REQUIRE(run("order " + rod + " --view bottom --opacity 0.5 --edges wire -q -o " + (d / "w.svg")).status == 0);
  const std::string pane = contents(d / "w.svg");
  CHECK(pane.find("fill=\"none\" stroke=\"#000000\"") < pane.find("fill-opacity"));
}

TEST_CASE("ids of an SVG begin as asked for, and all that refers to them", "[cli][D20]") {
  const Directory d;
  const std::string model = write(d / "boxes.obj", boxes);
  REQUIRE(run("draw " + model + " --hidden dashed --fill -q --id-prefix left_ -o " + (d / "a.svg")).status == 0);
  const std::string svg = contents(d / "a.svg");
  CHECK(count(svg, " id=\"") > 3);
  CHECK(count(svg, " id=\"") == count(svg, " id=\"left_"));
  for (const char* const refers : {"url(#", "href="}) CHECK(count(svg, refers) == 0);
  check_refused(run("draw " + model + " --id-prefix \"a b\" -o " + (d / "b.svg")), {"--id-prefix", "a b"});
  check_refused(run("draw " + model + " --id-prefix 1 -o " + (d / "b.svg")), {"--id-prefix"});
}
