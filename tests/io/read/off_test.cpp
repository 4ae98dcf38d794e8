#include <catch2/catch.hpp>
#include <limits>

#include "tests/io/read/refused.h"
#include "tests/io/read/small_files.h"

using namespace hsr;
using namespace hsr::test;

namespace {
const std::string four = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
}

TEST_CASE("OFF: comments, empty lines, counts on the first line, no number of edges, no keyword", "[read][off]") {
  for (const std::string start : {"OFF\n4 1 0\n", "# c\n\nOFF # c\n# c\n4 1 4 # c\n", "OFF 4 1 0\n", "OFF\n4 1\n", "4 1 0\n"}) {
    INFO(start);
    const Model m = read_model("a.off", start + four + "# c\n4 0 1 2 3\n");
    CHECK(m.points.size() == 4);
    CHECK(corners(m, 0) == std::vector<std::uint32_t>{0, 1, 2, 3});
    CHECK(m.palette.empty());
  }
}

TEST_CASE("OFF: a vertex may have a normal, a colour and a texture coordinate behind it", "[read][off]") {
  for (const std::string keyword : {"NOFF", "COFF", "CNOFF", "NCOFF", "STOFF", "STCNOFF"}) {
    const Model m = read_model("a", keyword + "\n3 1 0\n0 0 0 9 9 9 9\n1 0 0 9 9 9 9\n0 1 0 9 9 9 9\n3 0 1 2\n");
    CHECK(m.points[2] == Point3{0, 1, 0});
    CHECK(m.format == keyword);
  }
  CHECK(refusal("a.off", "OFF\n1 1 0\n0 0 0 9\n") ==
        "a.off: line 3: found \"9\", expected the end of the line after 3 coordinates (colours need COFF, normals NOFF)");
}

TEST_CASE("OFF: faces may have colours", "[read][off]") {
  const Model m =
      read_model("a.off", "OFF\n4 6 0\n" + four +
                              "3 0 1 2 255 0 0\n3 0 1 2 1.0 0 0\n3 0 1 2 0 0 1 0.5\n3 0 1 2\n3 0 1 2 7\n3 0 1 2 0 0 300\n");
  CHECK(m.palette == std::vector<Colour>{{255, 0, 0, 255}, {0, 0, 255, 128}, {0, 0, 255, 255}});
  CHECK(m.face_colour == std::vector<std::uint32_t>{0, 0, 1, 0xffffffffU, 0xffffffffU, 2});
  CHECK(refusal("a.off", "OFF\n4 1 0\n" + four + "3 0 1 2 red\n") == "a.off: line 7: found \"red\", expected a colour");
}

TEST_CASE("OFF: a face of two corners is a line, one of fewer is nothing, and both keep their number", "[read][off]") {
  const Model m = read_model("a.off", "OFF\n4 4 0\n" + four + "2 0 1\n1 3\n0\n3 0 1 2\n");
  REQUIRE(m.polygons.size() == 4);
  CHECK(m.polygons[0].size() == 2);
  CHECK(m.polygons[3].size() == 3);
  REQUIRE(m.polygons.segments.size() == 1);
  CHECK(m.polygons.segments[0] == std::array<std::uint32_t, 2>{0, 1});
  CHECK(m.notes == std::vector<std::string>{"2 faces with fewer than 2 corners have nothing to draw"});
}

TEST_CASE("OFF: what does not fit is refused with its line", "[read][off]") {
  CHECK(refusal("a.off", "4OFF\n") == "a.off: line 1: found \"4OFF\", expected a format with 3 coordinates (4OFF has 4)");
  CHECK(refusal("a.off", "nOFF\n3\n") ==
        "a.off: line 1: found \"nOFF\", expected a format with 3 coordinates (nOFF has a number of its own)");
  CHECK(refusal("a.off", "HOFF\n") == "a.off: line 1: found \"HOFF\", expected OFF, COFF, NOFF, ...");
  CHECK(refusal("a.off", "OFF\n4000000000 1 0\n0 0 0\n") ==
        "a.off: line 2: found 4000000000 vertices and 1 faces, expected no more than fit into the 7 bytes that follow");
  CHECK(refusal("a.off", "OFF\n-4 1 0\n") == "a.off: line 2: found \"-4\", expected the number of vertices");
  CHECK(refusal("a.off", "OFF\n4 1 0\n" + four + "3 0 1 4\n") == "a.off: line 7: found \"4\", expected an index from 0 to 3");
  CHECK(refusal("a.off", "OFF\n4 1 0\n" + four + "3 0 1 -1\n") == "a.off: line 7: found \"-1\", expected an index from 0 to 3");
  CHECK(refusal("a.off", "OFF\n4 1 0\n" + four + "3 0 1") ==
        "a.off: line 7: found the end of the file, expected corner 2 of 3");
  CHECK(refusal("a.off", "OFF\n4 1 0\n" + four) == "a.off: line 7: found the end of the file, expected face 0 of 1");
  CHECK(refusal("a.off", "OFF\n4 1 0\n0.000000 0 0\n1.0000000 0 0\n") ==
        "a.off: line 5: found the end of the file, expected coordinate of vertex 2 of 4");
  CHECK(refusal("a.off", "OFF\n1 1 0\n0 0 X0.4\n") == "a.off: line 3: found \"X0.4\", expected a coordinate");
  CHECK(refusal("a.off", "OFF\n4 1 0\n" + four + "999999999 0 1 2").find("a number of corners that fits into the file") !=
        std::string::npos);
}

TEST_CASE("OFF: the binary form is refused with its byte, vertex or face", "[read][off]") {
  const std::string head = "OFF BINARY\n";
  CHECK(refusal("a.off", head + big(1, 4)) ==
        "a.off: byte 11: found the end of the file, expected the numbers of vertices, faces and edges");
  CHECK(refusal("a.off", head + big(0xffffffff, 4) + big(1, 4) + big(0, 4)) ==
        "a.off: byte 11: found 4294967295 vertices and 1 faces, expected no more than fit into the 0 bytes that follow");
  std::string points;
  for (const float x : {0, 0, 0, 1, 0, 0, 0, 1, 0}) points += big_float(x);
  const std::string counts = big(3, 4) + big(1, 4) + big(0, 4);
  CHECK(refusal("a.off", head + counts + points + big(3, 4) + big(0, 4) + big(1, 4) + big(3, 4) + big(0, 4)) ==
        "a.off: face 0: found index 3, expected 0 to 2");
  CHECK(refusal("a.off", head + counts + big_float(std::numeric_limits<float>::quiet_NaN()) + points + big(0, 4)) ==
        "a.off: vertex 0: found NaN, expected a finite coordinate");
  CHECK(refusal("a.off", head + counts + points + big(1U << 30, 4) + big(0, 4)).find("face 0 with 1073741824 corners") !=
        std::string::npos);
}
