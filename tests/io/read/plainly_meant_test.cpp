#include <catch2/catch.hpp>

#include "tests/io/read/refused.h"
#include "tests/io/read/small_files.h"

using namespace hsr;
using namespace hsr::test;

namespace {

std::string with_cr_lf(std::string text) {
  for (std::size_t i = text.find('\n'); i != std::string::npos; i = text.find('\n', i + 2)) text.replace(i, 1, "\r\n");
  return text;
}

std::string with_tabs(std::string text) {
  for (char& c : text)
    if (c == ' ') c = '\t';
  return text;
}

/// As it is, with other line ends, and with tabs for blanks: one triangle each time.
void check_read(const std::string& name, const std::string& text) {
  for (const std::string& form : {text, with_cr_lf(text), with_tabs(text)}) {
    INFO(form);
    CHECK(refusal(name, form) == "");
    if (!refusal(name, form).empty()) continue;
    const Model m = read_model(name, form);
    REQUIRE(m.polygons.size() == 1);
    CHECK(corners(m, 0) == std::vector<std::uint32_t>{0, 1, 2});
    CHECK(m.points == std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    CHECK(m.notes.empty());
  }
}

}  // namespace

TEST_CASE("What is plainly meant is read", "[read][R14]") {
  const std::string loop = "outer loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n";
  SECTION("STL without its end, in words that are glued or parted, with comments, in one line") {
    check_read("a.stl", "solid a\nfacet normal 0 0 1\n" + loop + "endloop\nendfacet\n");
    check_read("a.stl", "solid a\nfacet normal 0 0 1\n" + loop + "endloop\nendfacet");
    check_read("a.stl", "solid a\nfacet normal 0 0 1\n" + loop + "endloopendfacet\nendsolid a\n");
    check_read("a.stl", "Solid a\nFacet Normal 0 0 1\n" + loop + "end loop\nend facet\nend solid a\n");
    check_read("a.stl",
               "# by hand\nsolid a\nfacet # no normal\nouterloop # c\nvertex 0 0 0 # c\nvertex 1 0 0\nvertex 0 1 0\nendloop\n# "
               "c\nendfacet\nendsolid\n");
    check_read("a.stl",
               "solid\nfacet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet endsolid");
  }
  SECTION("OFF in small letters") {
    for (const std::string keyword : {"off", "Off", "oFF"})
      check_read("a.off", keyword + "\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    check_read("a", "off  # c\n\n3 1\n0 0 0 # c\n1 0 0\n# c\n0 1 0\n3 0 1 2\n");
    check_read("a.off", "noff\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n");
  }
  SECTION("OBJ: a backslash with blanks behind it, capital letters") {
    check_read("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 \\  \n0\nf 1 \\\t \n2 3\n");
    check_read("a.obj", "V 0 0 0\nV 1 0 0\nv 0 1 0\nF 1 2 3 \\");
    check_read("a.obj", "v 0 0 0 # c\n\nv 1 0 0\n# c \\\nv 0 1 0\nusemtl a\\\nf 1 2 3\n");
  }
  SECTION("PLY with blanks at the ends of lines, and comments anywhere") {
    check_read(
        "a.ply",
        "ply  \nformat ascii 1.0  \ncomment c\nelement vertex 3 \nproperty float x \nproperty float y\nproperty float z\n"
        "obj_info c\nelement face 1\nproperty list uchar int vertex_indices  \nend_header  \n0 0 0 \n1 0 0\ncomment "
        "c\n\n0 1 0\n3 0 1 2  \n");
  }
}

TEST_CASE("What is not plain is refused in one line", "[read][R14]") {
  const std::string loop = "outer loop\nvertex 0 0 0\nvertex 1 0 0\n";
  CHECK(refusal("a.stl", "solid a\nfacet\n" + loop + "vertex 0 1 0\nendloop\n") ==
        "a.stl: line 8: found the end of the file, expected endfacet");
  CHECK(refusal("a.stl", "solid a\nfacet\n" + loop + "vertex 0 1 0\nvertex 1 1 0\nendloop\nendfacet\n") ==
        "a.stl: line 7: found \"vertex\", expected endloop");
  CHECK(refusal("a.off", "of\n3 1 0\n") == "a.off: line 1: found \"of\", expected OFF, COFF, NOFF, ...");
  CHECK(refusal("a.obj", "v 0 0 0\nv 1 0 0 \\ 0\n").empty() == false);
  CHECK(refusal("a.ply",
                "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\nc "
                "0 0\n") == "a.ply: line 8: found \"c\", expected a number, or a comment");
}
