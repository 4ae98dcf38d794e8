#include <catch2/catch.hpp>
#include <limits>

#include "tests/io/read/refused.h"
#include "tests/io/read/small_files.h"

using namespace hsr;
using namespace hsr::test;

namespace {

std::string facet(const std::string& a, const std::string& b, const std::string& c) {
  return " facet normal -nan nan 1\n  outer loop\n   vertex " + a + "\n   vertex " + b + "\n   vertex " + c +
         "\n  endloop\n endfacet\n";
}

}  // namespace

TEST_CASE("STL: indices are by first occurrence, and -0 is 0", "[read][stl][R5]") {
  const Model m = read_model("a.stl", binary_stl({5, 0, 0, 1, 0, 0, 1, 1, 0, 1, 1, -0.0F, 5, -0.0F, 0, 2, 2, 2}));
  REQUIRE(m.points.size() == 4);
  CHECK(m.points[0] == Point3{5, 0, 0});
  CHECK(corners(m, 0) == std::vector<std::uint32_t>{0, 1, 2});
  CHECK(corners(m, 1) == std::vector<std::uint32_t>{2, 0, 3});
  CHECK(m.format == "STL binary");
}

TEST_CASE("STL: single precision widens exactly, decimals do not go through it", "[read][stl][R2]") {
  CHECK(read_model("a.stl", binary_stl({0.1F, 0, 0, 1, 0, 0, 1, 1, 0})).points[0].x == static_cast<double>(0.1F));
  CHECK(read_model("a.stl", "solid\n" + facet("0.1 0 0", "1 0 0", "0 1 0") + "endsolid\n").points[0].x == 0.1);
}

TEST_CASE("STL: many points are merged like few", "[read][stl]") {
  std::vector<float> c;
  for (int k = 0; k < 2; ++k)
    for (int i = 0; i < 3000; ++i)
      for (const int x : {i, i + 1, i + 2}) c.insert(c.end(), {static_cast<float>(x), static_cast<float>(x % 7), 0});
  const Model m = read_model("a.stl", binary_stl(c));
  CHECK(m.points.size() == 3002);
  CHECK(corners(m, 3000) == corners(m, 0));
}

TEST_CASE("STL: several solids are objects, in any case of letters", "[read][stl]") {
  const std::string t = facet("0 0 0", "1 0 0", "0 1 0");
  const Model m = read_model("a.stl", "SOLID left part\n" + t + "ENDSOLID\n\nsolid\n" + t + t +
                                          "endsolid\r\nsolid left part\n" + t + "endsolid left part");
  CHECK(m.objects == std::vector<std::string>{"left part", "solid 2", "left part [2]"});
  CHECK(m.face_object == std::vector<std::uint32_t>{0, 1, 1, 2});
  CHECK(m.points.size() == 3);
}

TEST_CASE("STL: a binary file that begins with solid is told by its size", "[read][stl]") {
  const std::string stl = binary_stl({0, 0, 0, 1, 0, 0, 1, 1, 0}, "solid facet normal");
  CHECK(read_model("a.stl", stl).format == "STL binary");
  CHECK(refusal("a.stl", stl.substr(0, 100)) == "a.stl: byte 80: found a file of 100 bytes, expected 134 for 1 triangles");
}

TEST_CASE("STL: bytes behind the triangles are a note", "[read][stl]") {
  const Model m = read_model("a.stl", binary_stl({0, 0, 0, 1, 0, 0, 1, 1, 0}) + "more");
  CHECK(m.polygons.size() == 1);
  CHECK(m.notes == std::vector<std::string>{"the last 4 bytes belong to no triangle"});
}

TEST_CASE("STL: what does not fit is refused", "[read][stl]") {
  const std::string t = facet("0 0 0", "1 0 0", "0 1 0");
  CHECK(refusal("a.stl", "x") == "a.stl: found 1 bytes, expected the 84 of a binary STL header, or \"solid\"");
  CHECK(refusal("a.stl", binary_stl({}) + "more") ==
        "a.stl: byte 80: found 0 triangles in a file of 88 bytes, expected their number");
  CHECK(refusal("a.stl", std::string(80, 'x') + little(0xffffffff, 4) + "more")
            .find("expected 214748364834 for 4294967295 triangles") != std::string::npos);
  CHECK(refusal("a.stl", binary_stl({0, 0, 0, 1, 0, 0, 1, 1, std::numeric_limits<float>::infinity()})) ==
        "a.stl: face 0: found infinity, expected a finite coordinate");
  CHECK(refusal("a.stl", "solid a\n" + t + "facets") == "a.stl: line 9: found the end of the file, expected outerloop");
  CHECK(refusal("a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 blah\n") ==
        "a.stl: line 4: found \"blah\", expected a coordinate");
  CHECK(refusal("a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\n") ==
        "a.stl: line 6: found \"endloop\", expected vertex");
  CHECK(refusal("a.stl", "solid a\nendsolid\n") == "a.stl: found no points, faces or lines, expected a model");
}
