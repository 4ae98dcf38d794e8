#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "tests/io/read/refused.h"

using namespace hsr;
using namespace hsr::test;

using Corners = std::vector<std::uint32_t>;

namespace {
const std::string four = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
}

TEST_CASE("OBJ: corners may be v, v/vt, v//vn and v/vt/vn, counted from either end", "[read][obj]") {
  const Model m = read_model("a.obj", four + "f 1 2/1 3//1 4/1/1\nf -4 -3/-1 -2//-1\nv 0 0 1\nf -1 1 2\nfo 1 2 3\n");
  REQUIRE(m.polygons.size() == 4);
  CHECK(corners(m, 0) == Corners{0, 1, 2, 3});
  CHECK(corners(m, 1) == Corners{0, 1, 2});
  CHECK(corners(m, 2) == Corners{4, 0, 1});
  CHECK(m.notes.empty());
  CHECK(m.format == "OBJ");
}

TEST_CASE("OBJ: lines end with LF, CR LF or CR, and a backslash continues them", "[read][obj]") {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    const Model m = read_model("a.obj", "v 0 0 0" + end + "v 1 \\" + end + "0 0" + end + end + "v 0 1 0" + end + "f 1\\" + end +
                                            "2 \\" + end + " 3 # a comment \\" + end + "f 3 2 1");
    REQUIRE(m.points.size() == 3);
    REQUIRE(m.polygons.size() == 2);
    CHECK(corners(m, 0) == Corners{0, 1, 2});
    CHECK(corners(m, 1) == Corners{2, 1, 0});
    CHECK(refusal("a.obj", "v 0 0 0" + end + end + "v 1 \\" + end + "0 x" + end)
              .starts_with("a.obj: line 4: found \"x\", expected"));
  }
}

TEST_CASE("OBJ: a face may have very many corners", "[read][obj]") {
  std::string line = "f";
  for (int i = 0; i < 10000; ++i) line += " " + std::to_string(i % 4 + 1);
  CHECK(read_model("a.obj", four + line).polygons[0].size() == 10000);
}

TEST_CASE("OBJ: a vertex may have a weight or a colour", "[read][obj]") {
  const Model m = read_model("a.obj", "v 0 0 0 1\nv 1 0 0 0.5 0.5 0.5\nv 0 1 0 2\nf 1 2 3\n");
  CHECK(m.points[2] == Point3{0, 1, 0});
  REQUIRE(m.notes.size() == 1);
  CHECK(m.notes[0] == "1 vertices with a weight other than 1: the weights are passed over");
}

TEST_CASE("OBJ: polylines are segments, free-form surfaces a note", "[read][obj]") {
  const Model m = read_model("a.obj", four + "l 1 2/1 -1\np 1 2\ncstype bezier\ndeg 3\ncurv 0 1 1 2 3 4\nend\nnonsense 1\n");
  CHECK(m.polygons.size() == 0);
  REQUIRE(m.polygons.segments.size() == 2);
  CHECK(m.polygons.segments[1] == std::array<std::uint32_t, 2>{1, 3});
  REQUIRE(m.notes.size() == 2);
  CHECK(m.notes[0] == "curves and surfaces (cstype) are passed over");
  CHECK(m.notes[1] == "statements that OBJ does not have are passed over, the first: line 11, \"nonsense\"");
}

TEST_CASE("OBJ: groups and objects are objects by first use", "[read][obj]") {
  const Model m =
      read_model("a.obj", four + "f 1 2 3\no unused\ng roof  left \nf 1 2 4\ng wall\nf 2 3 4\ng roof  left\nf 1 3 4\n");
  CHECK(m.objects == std::vector<std::string>{"default", "unused"});
  CHECK(m.face_object == std::vector<std::uint32_t>{0, 1, 1, 1});
  CHECK(read_model("a.obj", four + "f 1 2 3\n").face_object.empty());
}

TEST_CASE("OBJ: a face may come before its vertices", "[read][obj]") {
  CHECK(read_model("a.obj", "f 1 2 3\n" + four).polygons.size() == 1);
  CHECK(refusal("a.obj", "f 1 2 3\nf 1 4 5\nf 1 6 2\n" + four) ==
        "a.obj: line 2: found \"5\", expected an index from 1 to 4, or from -1 to -4");
}

TEST_CASE("OBJ: what does not fit is refused with its line", "[read][obj]") {
  CHECK(refusal("a.obj", four + "f 1 2 9\n") == "a.obj: line 5: found \"9\", expected an index from 1 to 4, or from -1 to -4");
  CHECK(refusal("a.obj", four + "f 1 2 -5\n").find("line 5: found \"-5\"") != std::string::npos);
  CHECK(refusal("a.obj", four + "f 0 1 2\n").find("line 5: found \"0\"") != std::string::npos);
  CHECK(refusal("a.obj", four + "f 1 2 99999999999999999999\n").find("found \"99999999999999999999\"") != std::string::npos);
  CHECK(refusal("a.obj", four + "f 1 2 3.5\n").find("found \"3.5\", expected the index of a vertex") != std::string::npos);
  CHECK(refusal("a.obj", four + "f 1 2 3/x\n").find("found \"3/x\"") != std::string::npos);
  CHECK(refusal("a.obj", four + "f 1 2\n") == "a.obj: line 5: found a face of 2 corners, expected 3 or more");
  CHECK(refusal("a.obj", "f 1 2 3\n") == "a.obj: line 1: found \"1\", expected a vertex before the first face");
  CHECK(refusal("a.obj", "v 1 2\n") == "a.obj: line 1: found the end of the line, expected a coordinate");
  CHECK(refusal("a.obj", "v 1 2") == "a.obj: line 1: found the end of the file, expected a coordinate");
  CHECK(refusal("a.obj", "v 1 2 nan\n") == "a.obj: line 1: found \"nan\", expected a coordinate");
  CHECK(refusal("a.obj", "\nv 1 -inf 2\n") == "a.obj: line 2: found \"-inf\", expected a coordinate");
  CHECK(refusal("a.obj", "v 1 2 1e400\n") == "a.obj: line 1: found \"1e400\", expected a coordinate that a double can hold");
  CHECK(refusal("a.obj", "v 1 2 0x1p3\n").find("found \"0x1p3\"") != std::string::npos);
  CHECK(refusal("a.obj", "v 1 2 " + std::string(100, 'y')) ==
        "a.obj: line 1: found \"" + std::string(40, 'y') + "...\", expected a coordinate");
  CHECK(refusal("a.obj", "v 1 2 \x01\xff\n") == "a.obj: line 1: found \"??\", expected a coordinate");
}

TEST_CASE("OBJ: minus zero and subnormal numbers are kept", "[read][obj]") {
  const Model m = read_model("a.obj", "v -0 4.9e-324 1e-400\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  CHECK(std::signbit(m.points[0].x));
  CHECK(m.points[0].y == std::numeric_limits<double>::denorm_min());
  CHECK(m.points[0].z == 0);
}
