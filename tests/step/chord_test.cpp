#include "hsr/cli/chord.h"

#include <array>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/cli/run_command.h"
#include "tests/step/shapes.h"

// How fine a mesh of surfaces is made for a page.

namespace hsr {
namespace {

using namespace cli_tests;
using cli::chord_for;

/// A rectangle in the plane z = 0.
Mesh rectangle(double width, double height) {
  const std::array<Point3, 4> points = {{{0, 0, 0}, {width, 0, 0}, {width, height, 0}, {0, height, 0}}};
  const std::array<std::uint32_t, 4> corners = {0, 1, 2, 3};
  const std::array<std::uint32_t, 2> first = {0, 4};
  return make_mesh(points, corners, first);
}

TEST_CASE("chords are as long on paper as the scale makes them", "[step][chord]") {
  const View top = parallel_view({0, 0, 1}, {0, 1, 0});
  const Mesh wide = rectangle(554, 100);
  CHECK(chord_for(wide, top, {}, 0.02) == Approx(0.04));  // the page turns: 277 mm for 554
  DrawingOptions page;
  page.page = {100, 50, 5, false, false};
  CHECK(chord_for(wide, top, page, 0.02) == Approx(0.02 * 554 / 90));
  page.scale = 10;
  CHECK(chord_for(wide, top, page, 0.02) == Approx(0.002));
  page.unit = 25.4;
  CHECK(chord_for(wide, top, page, 0.02) == Approx(0.002 / 25.4));
  // Seen along its plane it is as wide as before.
  CHECK(chord_for(wide, parallel_view({0, -1, 0}, {0, 0, 1}), {}, 0.02) == Approx(0.04));
}

TEST_CASE("in a perspective what is nearest to the eye counts", "[step][chord]") {
  const Mesh mesh = rectangle(100, 100);
  DrawingOptions page;
  page.scale = 1;
  const auto from = [&](double height) { return perspective_view({0, 0, height}, {0, 0, 0}, {0, 1, 0}); };
  CHECK(chord_for(mesh, from(300), page, 0.02) == Approx(0.02));
  const View close = perspective_view({-10, 0, 0}, {90, 0, 0}, {0, 0, 1});
  CHECK(chord_for(mesh, close, page, 0.02) == Approx(0.002));
  const View among = perspective_view({50, 50, 0}, {150, 50, 0}, {0, 0, 1});
  CHECK(chord_for(mesh, among, page, 0.02) == Approx(0.001));
}

/// The triangles that a drawing was made of.
int triangles(const std::string& arguments, const Directory& d) {
  const Outcome outcome = run("draw " + arguments + " -q -o " + (d / "a.svg") + " --report " + (d / "r.json"));
  INFO(outcome.text);
  REQUIRE(outcome.status == 0);
  return nlohmann::json::parse(contents(d / "r.json"))["model"]["triangles"].get<int>();
}

TEST_CASE("a larger drawing, finer chords and finer arcs take more triangles", "[step][chord][cli]") {
  const Directory d;
  const std::string file = d / "cylinder.stp";
  shapes::write_step(shapes::cylinder(), file);
  const int fitted = triangles(file, d);
  CHECK(triangles(file + " --page A0", d) > 1.5 * fitted);
  CHECK(triangles(file + " --scale 1:10", d) < fitted / 2);
  CHECK(triangles(file + " --chord 0.001", d) > 2 * fitted);  // or as fine as it gets
  CHECK(triangles(file + " --fit-arcs 0.002", d) > 2 * fitted);
  CHECK(triangles(file + " --fit-arcs 0.5", d) == fitted);
}

TEST_CASE("every command takes STEP, also from standard input", "[step][cli]") {
  const Directory d;
  const std::string file = d / "cylinder.step";
  shapes::write_step(shapes::cylinder(), file);
  CHECK(run("info " + file).text.find("cylinder.step: STEP") != std::string::npos);
  const std::string inches = d / "inches.stp", at_scale = " --scale 1:1 -o " + (d / "u.svg");
  shapes::write_step(shapes::cylinder(), inches, "INCH");
  CHECK(run("draw " + inches + at_scale).text.find("note: the file has a unit of in: --unit in is the default") !=
        std::string::npos);
  CHECK(run("draw " + file + at_scale).text.find("note") == std::string::npos);
  CHECK(run("order " + file + " --scale 1:10 -o " + (d / "a.json")).status == 0);
  CHECK(run("draw - --from step -o " + (d / "b.svg"), "cat " + file + " | ").status == 0);
  CHECK(run("draw - -o " + (d / "c.svg"), "cat " + file + " | ").status == 0);
  CHECK(contents(d / "b.svg") == contents(d / "c.svg"));
  check_refused(run("draw " + write(d / "bad.step", "ISO-10303-21;\nHEADER;\n") + " -o " + (d / "x.svg")),
                {"bad.step: found STEP"});
}

}  // namespace
}  // namespace hsr
