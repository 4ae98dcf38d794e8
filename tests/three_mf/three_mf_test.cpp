#include "hsr/three_mf/three_mf.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "geometry/error.h"
#include "tests/cli/run_command.h"
#include "tests/io/read/temporary_directory.h"
#include "tests/three_mf/three_mf_package.h"

namespace hsr {
namespace {

using test::TemporaryDirectory;
using test::tetrahedron;
using test::three_mf_package;
using namespace cli_tests;

Model read(const std::string& model, const std::string& unit = "millimeter") {
  return read_three_mf("part.3mf", three_mf_package(model, unit));
}

std::string item(int object, const std::string& more = "") {
  return "<item objectid=\"" + std::to_string(object) + "\" " + more + "/>";
}

std::string refusal(const std::string& bytes) {
  try {
    read_three_mf("part.3mf", bytes);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST_CASE("an object of a 3MF file has its points, its faces and its name", "[3mf]") {
  const Model model =
      read("<resources>" + tetrahedron(1, 2.5, "name=\"corner\"") + "</resources><build>" + item(1) + "</build>");
  CHECK(model.format == "3MF");
  CHECK(model.points == std::vector<Point3>{{0, 0, 0}, {2.5, 0, 0}, {0, 2.5, 0}, {0, 0, 2.5}});
  CHECK(model.polygons.size() == 4);
  CHECK(model.objects == std::vector<std::string>{"corner"});
  CHECK(model.up_axis == 'z');
  CHECK(model.unit == 1);
  CHECK(model.palette.empty());
  CHECK(model.notes.empty());
}

TEST_CASE("items and components are turned and moved, each an object", "[3mf]") {
  // A quarter turn about z and a move by (10, 0, 0), within a move by (0, 0, 5).
  const Model model = read("<resources>" + tetrahedron(1, 1) + tetrahedron(2, 1, "name=\"tip\"") +
                           "<object id=\"3\" name=\"pair\"><components><component objectid=\"1\"/><component objectid=\"2\" "
                           "transform=\"0 1 0 -1 0 0 0 0 1 10 0 0\"/></components></object></resources><build>" +
                           item(3, "transform=\"1 0 0 0 1 0 0 0 1 0 0 5\"") + item(2) + item(2) + "</build>");
  REQUIRE(model.points.size() == 16);
  CHECK(model.points[1] == Point3{1, 0, 5});
  CHECK(model.points[4] == Point3{10, 0, 5});
  CHECK(model.points[5] == Point3{10, 1, 5});
  CHECK(model.points[6] == Point3{9, 0, 5});
  CHECK(model.points[7] == Point3{10, 0, 6});
  CHECK(model.points[9] == Point3{1, 0, 0});
  CHECK(model.objects == std::vector<std::string>{"pair/object 1", "pair/tip", "tip", "tip [2]"});
  CHECK(model.notes == std::vector<std::string>{"coordinates of placed parts are rounded to doubles"});
}

TEST_CASE("lengths stay in the unit of a 3MF file, or become millimetres", "[3mf]") {
  const std::string one = "<resources>" + tetrahedron(1, 3) + "</resources><build>" + item(1) + "</build>";
  CHECK(read(one, "inch").unit == 25.4);
  CHECK(read(one, "inch").points[1].x == 3);
  CHECK(read(one, "meter").unit == 1000);
  const Model feet = read(one, "foot"), microns = read(one, "micron");
  CHECK(feet.unit == 1);
  CHECK(feet.points[1].x == 3 * 304.8);
  CHECK(feet.notes == std::vector<std::string>{"lengths in the file's unit (foot) are converted to mm"});
  CHECK(microns.points[1].x == 3 * 0.001);
}

TEST_CASE("faces of a 3MF file have their colours and materials, or those of their object", "[3mf]") {
  const Model model = read(
      "<resources><basematerials id=\"5\"><base name=\"steel\" displaycolor=\"#8090A0\"/><base name=\"oak\" "
      "displaycolor=\"#FF8000\"/></basematerials><m:colorgroup id=\"6\"><m:color color=\"#0000FF\"/></m:colorgroup>" +
      tetrahedron(1, 1, "pid=\"5\" pindex=\"0\"", "pid=\"5\" p1=\"1\"") + tetrahedron(2, 1, "", "pid=\"6\" p1=\"0\"") +
      "</resources><build>" + item(1) + item(2) + "</build>");
  REQUIRE(model.face_colour.size() == 8);
  const auto colour = [&](std::size_t face) { return model.palette[model.face_colour[face]]; };
  CHECK(colour(0) == Colour{0x80, 0x90, 0xa0, 255});
  CHECK(colour(3) == Colour{255, 0x80, 0, 255});
  CHECK(colour(7) == Colour{0, 0, 255, 255});
  CHECK(model.face_colour[4] == 0xffffffffU);
  CHECK(model.materials == std::vector<std::string>{"steel", "oak"});
  CHECK(model.face_material == std::vector<std::uint32_t>{0, 0, 0, 1, 0xffffffffU, 0xffffffffU, 0xffffffffU, 0xffffffffU});
}

TEST_CASE("what supports others in a printer is left out of a 3MF file, with a note", "[3mf]") {
  const Model model = read("<resources>" + tetrahedron(1, 1) + tetrahedron(2, 9, "type=\"support\"") + "</resources><build>" +
                           item(1) + item(2) + "</build>");
  CHECK(model.polygons.size() == 4);
  CHECK(model.notes == std::vector<std::string>{"objects that support others in a printer are left out: 1"});
}

TEST_CASE("what is no 3MF file is refused in one line", "[3mf]") {
  const std::string good = three_mf_package("<resources>" + tetrahedron(1, 1) + "</resources><build>" + item(1) + "</build>");
  CHECK(refusal(good).empty());
  CHECK(refusal("") == "part.3mf: found an empty file, expected a model");
  const auto is_one_line = [](const std::string& text) {
    return text.starts_with("part.3mf: ") && text.find('\n') == std::string::npos;
  };
  CHECK(is_one_line(refusal("PK\x03\x04")));
  CHECK(is_one_line(refusal("solid ascii\nendsolid\n")));
  for (std::size_t size = 1; size < good.size(); size += 7) CHECK(is_one_line(refusal(good.substr(0, size))));
  for (std::size_t at = 0; at < good.size(); at += 5) {
    std::string damaged = good;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x15);
    const std::string message = refusal(damaged);
    INFO(at << ": " << message);
    CHECK((message.empty() || is_one_line(message)));
  }
  const auto of_model = [&](const std::string& model) { return refusal(three_mf_package(model)); };
  CHECK(of_model("<resources/><build/>") == "part.3mf: found no points, faces or lines, expected a model");
  CHECK(is_one_line(of_model("<resources>" + tetrahedron(1, 1) + "</resources><build>" + item(7) + "</build>")));
  CHECK(is_one_line(of_model("<resources>")));
  // Each names the one before it twice: a thousand million of them.
  std::string twice = tetrahedron(1, 1);
  for (int k = 2; k <= 31; ++k) {
    const std::string before = "<component objectid=\"" + std::to_string(k - 1) + "\"/>";
    twice += "<object id=\"" + std::to_string(k) + "\"><components>" + before + before + "</components></object>";
  }
  CHECK(of_model("<resources>" + twice + "</resources><build>" + item(31) + "</build>") ==
        "part.3mf: found more than a million instances of objects, expected fewer");
}

TEST_CASE("the command takes 3MF, and says what it knows of other formats", "[3mf][cli]") {
  const TemporaryDirectory directory;
  const std::string part = directory.write(
      "part.3mf", three_mf_package("<resources>" + tetrahedron(1, 1) + "</resources><build>" + item(1) + "</build>"));
  const std::string to = " -o " + directory.file("part.svg");
  CHECK(run("draw " + part + to).status == 0);
  CHECK(run("draw - --from 3mf" + to, "cat " + part + " | ").status == 0);
  CHECK(run("draw -" + to, "cat " + part + " | ").status == 0);
  check_refused(run("draw " + directory.write("bad.3mf", "PK\x03\x04 and no more") + to),
                {"bad.3mf: found a file that lib3mf"});
  check_refused(run("draw " + directory.write("part.xyz", "1 2 3") + to),
                {"found the ending \".xyz\", expected OBJ, OFF, PLY, STL, glTF or GLB, also gzipped", ", 3MF"});
}

}  // namespace
}  // namespace hsr
