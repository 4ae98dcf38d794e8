#include <catch2/catch.hpp>
#include <limits>

#include "tests/io/read/refused.h"
#include "tests/io/read/small_files.h"

using namespace hsr;
using namespace hsr::test;

namespace {

const std::string ascii = "ply\nformat ascii 1.0\n";
const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string list = "property list uchar int vertex_indices\n";
const std::string three = "0 0 0\n1 0 0\n0 1 0\n";

}  // namespace

TEST_CASE("PLY: properties in any order and of any type, other elements passed over", "[read][ply]") {
  const Model m =
      read_model("a", ascii +
                          "obj_info x\nelement camera 2\nproperty list uchar float lens\nproperty int id\nelement vertex 3\n"
                          "property double z\nproperty uchar red\nproperty list uchar int tags\nproperty short x\n"
                          "property float y\nelement face 1\nproperty float quality\nproperty list uint uint vertex_index\n"
                          "end_header\n2 1.5 2.5 7\n0 8\n3 255 2 1 1 1 0.1\n3 255 0 4 0.1\n3 255 0 7 8\n0.5 3 0 1 2\n");
  CHECK(m.points == std::vector<Point3>{{1, 0.1, 3}, {4, 0.1, 3}, {7, 8, 3}});
  CHECK(corners(m, 0) == std::vector<std::uint32_t>{0, 1, 2});
  CHECK(m.notes.empty());
}

TEST_CASE("PLY: lines may end with CR LF", "[read][ply]") {
  std::string text = ascii + "element vertex 3\n" + xyz + "element face 1\n" + list + "end_header\n" + three + "3 0 1 2\n";
  for (std::size_t i = text.find('\n'); i != std::string::npos; i = text.find('\n', i + 2)) text.replace(i, 1, "\r\n");
  CHECK(read_model("a.ply", text).polygons.size() == 1);
}

TEST_CASE("PLY: faces have colours of whole numbers or fractions", "[read][ply]") {
  const std::string head = ascii + "element vertex 3\n" + xyz + "element face 3\n" + list;
  const Model bytes = read_model(
      "a.ply", head + "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\nend_header\n" +
                   three + "3 0 1 2 255 0 9 128\n3 0 1 2 1 2 3 4\n3 0 1 2 255 0 9 128\n");
  CHECK(bytes.palette == std::vector<Colour>{{255, 0, 9, 128}, {1, 2, 3, 4}});
  CHECK(bytes.face_colour == std::vector<std::uint32_t>{0, 1, 0});
  const Model fractions =
      read_model("a.ply", head + "property float red\nproperty float green\nproperty float blue\nend_header\n" + three +
                              "3 0 1 2 1 0.5 0\n3 0 1 2 1 0.5 0\n3 0 1 2 1 0.5 0\n");
  CHECK(fractions.palette == std::vector<Colour>{{255, 128, 0, 255}});
}

TEST_CASE("PLY: edges are segments", "[read][ply]") {
  const Model m = read_model("a.ply", ascii + "element edge 2\nproperty int vertex2\nproperty int vertex1\nelement vertex 3\n" +
                                          xyz + "end_header\n1 0\n2 1\n" + three);
  CHECK(m.polygons.segments == std::vector<std::array<std::uint32_t, 2>>{{0, 1}, {1, 2}});
}

TEST_CASE("PLY: strips turn with each triangle and begin anew at -1", "[read][ply]") {
  const Model m = read_model("a.ply", ascii + "element vertex 5\n" + xyz +
                                          "element tristrips 1\nproperty list int int vertex_indices\nend_header\n" + three +
                                          "1 1 0\n0 0 1\n9 0 1 2 3 3 4 -1 0 1\n");
  REQUIRE(m.polygons.size() == 2);
  CHECK(corners(m, 0) == std::vector<std::uint32_t>{0, 1, 2});
  CHECK(corners(m, 1) == std::vector<std::uint32_t>{2, 1, 3});
}

TEST_CASE("PLY: binary data may begin with a line feed", "[read][ply]") {
  std::string body = little(10, 1);
  for (const float x : {0, 0, 0, 1, 0, 0, 0, 1, 0}) body += little_float(x);
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::string head = "ply\nformat binary_little_endian 1.0\nelement flag 1\nproperty uchar f\nelement vertex 3\n" + xyz +
                       "element face 1\n" + list + "end_header\n";
    for (std::size_t i = head.find('\n'); i != std::string::npos; i = head.find('\n', i + end.size())) head.replace(i, 1, end);
    const Model m = read_model("a.ply", head + body + little(3, 1) + little(0, 4) + little(1, 4) + little(2, 4));
    CHECK(m.points[2] == Point3{0, 1, 0});
  }
}

TEST_CASE("PLY: what does not fit is refused", "[read][ply]") {
  const std::string head = ascii + "element vertex 3\n" + xyz + "element face 1\n" + list;
  CHECK(refusal("a.ply", "plx") == "a.ply: line 1: found \"plx\", expected ply");
  CHECK(refusal("a.ply", "ply\nformat binary 1.0\n") ==
        "a.ply: line 2: found \"binary\", expected ascii, binary_little_endian or binary_big_endian");
  CHECK(refusal("a.ply", "ply\nformat ascii 2.0\n") == "a.ply: line 2: found \"2.0\", expected version 1.0");
  CHECK(refusal("a.ply", ascii + "element vertex -3\n") ==
        "a.ply: line 3: found \"-3\", expected how many there are of an element");
  CHECK(refusal("a.ply", ascii + "property quad x\n").find("line 3: found \"property\"") != std::string::npos);
  CHECK(
      refusal("a.ply", ascii + "element vertex 3\nproperty quad x\n").find("line 4: found \"quad\", expected a type of PLY") !=
      std::string::npos);
  CHECK(refusal("a.ply", head) == "a.ply: line 9: found the end of the file, expected end_header");
  CHECK(
      refusal("a.ply", ascii + "element vertex 900000000000\n" + xyz + "end_header\n0 0 0\n") ==
      "a.ply: line 3: found 900000000000 of element \"vertex\", expected no more than fit into the 6 bytes behind the header");
  CHECK(refusal("a.ply", head + "end_header\n" + three + "3 0 1 3\n") ==
        "a.ply: line 13: found \"3\", expected an index from 0 to 2");
  CHECK(refusal("a.ply", head + "end_header\n" + three + "2 0 1\n") ==
        "a.ply: line 13: found a face of 2 corners, expected 3 or more");
  CHECK(refusal("a.ply", head + "end_header\n" + three + "3 0 1 2 2\n") ==
        "a.ply: line 13: found \"2\", expected the end of the line");
  CHECK(refusal("a.ply", head + "end_header\n0 0 nan\n" + three) == "a.ply: line 10: found \"nan\", expected a number");
  CHECK(refusal("a.ply", head + "end_header\n0.000 0 0\n1 0 0\n0 1 0\n") ==
        "a.ply: line 13: found the end of the file, expected face 0 of 1");
  CHECK(refusal("a.ply", ascii + "element vertex 1\nproperty float x\nproperty float y\nend_header\n0 0\n") ==
        "a.ply: found an element \"vertex\" without property \"z\", expected x, y and z");
  CHECK(refusal("a.ply", ascii + "element vertex 1\n" + xyz + "end_header\n0 0 0\n") ==
        "a.ply: has points but no faces or lines: nothing to draw");
}

TEST_CASE("PLY: binary data that does not fit is refused with its vertex or face", "[read][ply]") {
  const std::string head = "ply\nformat binary_big_endian 1.0\nelement vertex 3\n" + xyz + "element face 1\n";
  const std::string ints = "property list uint int vertex_indices\nend_header\n";
  std::string body;
  for (const float x : {0, 0, 0, 1, 0, 0, 0, 1, 0}) body += big_float(x);
  CHECK(refusal("a.ply", head + ints + body + big(3, 4) + big(0, 4) + big(1, 4) + big(7, 4)) ==
        "a.ply: face 0: found index 7, expected an index from 0 to 2");
  CHECK(refusal("a.ply", head + ints + body + big(3, 4) + big(0, 4) + big(1, 4))
            .find("found the end of the file, expected face 0 of 1") != std::string::npos);
  CHECK(refusal("a.ply", head + ints + body + big(0xffffffff, 4) + big(0, 4)).find("found the end of the file") !=
        std::string::npos);
  body.replace(12, 4, big_float(-std::numeric_limits<float>::infinity()));
  CHECK(refusal("a.ply", head + ints + body + big(3, 4) + big(0, 4) + big(1, 4) + big(2, 4)) ==
        "a.ply: vertex 1: found infinity, expected a finite coordinate");
}
