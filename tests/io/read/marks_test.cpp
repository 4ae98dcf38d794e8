#include <catch2/catch.hpp>
#include <string>

#include "hsr/io/read/read.h"
#include "tests/io/read/refused.h"
#include "tests/io/read/temporary_directory.h"

namespace hsr {
namespace {

/// Two triangles of two objects, with points of their own.
const char* const two_objects = "v 0 0 0\nv 0 1 0\nv 1 0 0\nv 0 0 0\nv 0 1 0\nv -1 0 1\no left\nf 1 2 3\no right\nf 4 5 6\n";

Model marked(const std::string& json, const std::string& obj = two_objects) {
  const test::TemporaryDirectory directory;
  Model model = read_model("part.obj", obj);
  read_marks(directory.write("part.marks.json", json), model);
  return model;
}

std::string refusal(const std::string& json) {
  try {
    marked(json);
  } catch (const InputError& e) {
    const std::string text = e.what();
    return text.substr(text.find("json: ") + 6);
  }
  return "nothing was refused";
}

std::string edge(const std::string& json) { return R"({"format": "hsr-marks/1", "edges": [)" + json + "]}"; }

TEST_CASE("marks name surfaces of faces", "[read][marks][J7]") {
  const Model m = marked(R"({"format": "hsr-marks/1", "surfaces": [3, null]})");
  CHECK(m.face_surface == std::vector<std::uint32_t>{3, 0xffffffffU});
  CHECK(m.marks.empty());
}

TEST_CASE("what a file says of edges stands in the place of what the model had", "[read][marks][J7]") {
  const test::TemporaryDirectory directory;
  Model model = read_model("part.obj", two_objects);
  const auto add = [&](const std::string& json) { read_marks(directory.write("part.marks.json", json), model); };
  add(edge(R"({"points": [0, 1], "mark": "smooth", "circle": {"centre": [0, 0, 0], "axis": [0, 0, 1], "radius": 1}})"));
  REQUIRE(model.marks.size() == 2);
  REQUIRE(model.circles.size() == 1);
  add(R"({"format": "hsr-marks/1", "surfaces": [1, 2]})");
  CHECK(model.marks.size() == 2);
  add(edge(R"({"points": [1, 2], "mark": "sharp"})"));
  CHECK(model.marks == std::vector<MarkedEdge>{{{1, 2}, EdgeMark::sharp, 0, 0xffffffffU}});
  CHECK(model.circles.empty());
  CHECK(model.face_surface == std::vector<std::uint32_t>{1, 2});
}

TEST_CASE("a mark is of each object that has a face at the edge, whatever its points are numbered", "[read][marks][J7][C25]") {
  CHECK(marked(edge(R"({"points": [0, 1], "mark": "smooth"})")).marks ==
        std::vector<MarkedEdge>{{{0, 1}, EdgeMark::smooth, 0}, {{0, 1}, EdgeMark::smooth, 1}});
  CHECK(marked(edge(R"({"points": [1, 2], "mark": "sharp"})")).marks == std::vector<MarkedEdge>{{{1, 2}, EdgeMark::sharp, 0}});
  const auto chain = marked(edge(R"({"points": [5, 3, 4, 5], "mark": "seam"})")).marks;
  CHECK(chain == std::vector<MarkedEdge>{{{0, 1}, EdgeMark::inner, 0},
                                         {{0, 1}, EdgeMark::inner, 1},
                                         {{0, 5}, EdgeMark::inner, 1},
                                         {{1, 5}, EdgeMark::inner, 1}});
}

TEST_CASE("a mark may know the circle that its edges lie on", "[read][marks][J7]") {
  const Model m = marked(
      edge(R"({"points": [0, 1, 2], "mark": "sharp", "circle": {"centre": [1, 2, 3], "axis": [0, 0, 4], "radius": 0.5}})"));
  REQUIRE(m.circles.size() == 1);
  CHECK(m.circles[0].centre == Point3{1, 2, 3});
  CHECK(m.circles[0].axis == Point3{0, 0, 1});
  CHECK(m.circles[0].radius == 0.5);
  for (const MarkedEdge& mark : m.marks) CHECK(mark.circle == 0);
}

TEST_CASE("marks of edges that no face has are passed over with a note", "[read][marks][J7]") {
  const Model m = marked(edge(R"({"points": [2, 5], "mark": "sharp"})"));
  CHECK(m.marks.empty());
  REQUIRE(m.notes.size() == 1);
  CHECK(m.notes[0].ends_with("part.marks.json: marks of edges that no face has, passed over: 1"));
}

TEST_CASE("marks that say nothing are refused in one line", "[read][marks][J7]") {
  CHECK(refusal("[]") == R"(found no object, expected {"format": "hsr-marks/1", ...})");
  CHECK(refusal("{") == R"(byte 2: found no JSON there, expected "hsr-marks/1")");
  CHECK(refusal(R"({"format": "hsr-lines/1"})") == R"(format: found "hsr-lines/1", expected "hsr-marks/1")");
  CHECK(refusal(R"({"format": "hsr-marks/1", "surfaces": [1]})") ==
        "surfaces: found 1 numbers, expected one for each of the 2 faces of the model");
  CHECK(refusal(R"({"format": "hsr-marks/1", "surfaces": [1, -2]})") ==
        "surfaces, face 1: found -2, expected the number of a surface, or null");
  CHECK(refusal(edge(R"({"points": [0, 1], "mark": "round"})")) ==
        R"(edge 0: mark: found "round", expected "inner", "seam", "smooth" or "sharp")");
  CHECK(refusal(edge(R"({"points": [0, 1]})")) == R"(edge 0: mark: found null, expected "inner", "seam", "smooth" or "sharp")");
  CHECK(refusal(edge(R"({"points": [0], "mark": "sharp"})")) ==
        "edge 0: points: found [0], expected the numbers of two points or more");
  CHECK(refusal(edge(R"({"points": [0, 6], "mark": "sharp"})")) ==
        "edge 0: points: found 6, expected the number of one of the 6 points of the model");
  CHECK(refusal(edge(R"(7)")) == R"(edge 0: found 7, expected {"points": [i, j, ...], "mark": "smooth"})");
  CHECK(refusal(
            edge(R"({"points": [0, 1], "mark": "sharp", "circle": {"centre": [0, 0, 0], "axis": [0, 0, 0], "radius": 1}})")) ==
        "edge 0: circle: axis: found [0,0,0], expected a direction");
  CHECK(refusal(
            edge(R"({"points": [0, 1], "mark": "sharp", "circle": {"centre": [0, 0, 0], "axis": [0, 0, 1], "radius": 0}})")) ==
        "edge 0: circle: radius: found 0, expected more than 0");
}

}  // namespace
}  // namespace hsr
