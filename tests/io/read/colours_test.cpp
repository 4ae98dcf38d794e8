#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "hsr/io/read/linear_colour.h"
#include "tests/io/read/refused.h"
#include "tests/io/read/small_files.h"

using namespace hsr;
using namespace hsr::test;

namespace {

using Colours = std::vector<Colour>;
constexpr std::uint32_t none = 0xffffffffU;

const std::string ply = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n";

}  // namespace

TEST_CASE("A face has the mean of the colours of its corners, rounded once", "[read][colour][R8]") {
  SECTION("PLY, bytes") {
    const Model m = read_model("a.ply", ply +
                                            "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 2\n"
                                            "property list uchar int vertex_indices\nend_header\n"
                                            "0 0 0 1 0 255\n1 0 0 2 0 255\n1 1 0 2 1 255\n0 1 0 1 1 254\n3 0 1 2\n4 0 1 2 3\n");
    CHECK(m.palette == Colours{{2, 0, 255, 255}, {2, 1, 255, 255}});  // 5/3, 1/3; 6/4, 2/4, 1019/4: halves go up
    CHECK(m.face_colour == std::vector<std::uint32_t>{0, 1});
  }
  SECTION("PLY, floats, with opacity, and a face with a colour of its own") {
    const Model m = read_model(
        "a.ply", ply +
                     "property float red\nproperty float green\nproperty float blue\nproperty float alpha\nelement face 2\n"
                     "property list uchar int vertex_indices\nend_header\n"
                     "0 0 0 1 0 0 1\n1 0 0 0 0 0 0\n1 1 0 0 0 0 0.5\n0 1 0 1 1 1 1\n3 0 1 2\n3 0 2 3\n");
    CHECK(m.palette == Colours{{85, 0, 0, 128}, {170, 85, 85, 213}});
  }
  SECTION("PLY, 16 bits") {
    const Model m = read_model("a.ply", ply +
                                            "property ushort red\nproperty ushort green\nproperty ushort blue\nelement face 1\n"
                                            "property list uchar int vertex_indices\nend_header\n"
                                            "0 0 0 65535 0 257\n1 0 0 65535 0 257\n1 1 0 65535 0 257\n0 1 0 0 0 0\n3 0 1 2\n");
    CHECK(m.palette == Colours{{255, 0, 1, 255}});
  }
  SECTION("OBJ, before and behind the face; a material goes before") {
    const Model m = read_model("a.obj", "f 1 2 3\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nv 0 0 1\nf 1 2 4\nf 1 1 1\n");
    CHECK(m.palette == Colours{{85, 85, 85, 255}, {255, 0, 0, 255}});
    CHECK(m.face_colour == std::vector<std::uint32_t>{0, none, 1});
    CHECK(read_model("a.obj", "v 0 0 0 255 0 0\nv 1 0 0 255 0 1\nv 0 1 0 255 0 1\nf 1 2 3\n").palette ==
          Colours{{255, 0, 1, 255}});
  }
  SECTION("OFF, bytes for the whole file if one is above 1") {
    const std::string faces = "3 0 1 2\n3 0 2 3 0 0 255\n";
    const Model bytes =
        read_model("a.off", "COFF\n4 2 0\n0 0 0 0 1 0 255\n1 0 0 0 1 1 255\n1 1 0 3 1 1 255\n0 1 0 9 9 9 9\n" + faces);
    CHECK(bytes.palette == Colours{{0, 0, 255, 255}, {1, 1, 1, 255}});
    CHECK(bytes.face_colour == std::vector<std::uint32_t>{1, 0});
    const Model parts = read_model(
        "a.off", "NCOFF\n4 2 0\n0 0 0 9 9 9 0 1 0 1\n1 0 0 9 9 9 0 1 0 1\n1 1 0 9 9 9 0 1 0 1\n0 1 0 9 9 9 1 1 1\n" + faces);
    CHECK(parts.palette == Colours{{0, 0, 255, 255}, {0, 255, 0, 255}});
  }
}

TEST_CASE("STL: binary triangles have colours of 15 bits by two customs", "[read][stl][colour][R11]") {
  const auto coloured = [](const std::string& header, const std::vector<std::uint16_t>& bits) {
    std::string s = header;
    s.resize(80, ' ');
    s += little(bits.size(), 4);
    for (const std::uint16_t b : bits) {
      s += std::string(12, '\0');
      for (const float x : {0, 0, 0, 1, 0, 0, 0, 1, 0}) s += little_float(x);
      s += little(b, 2);
    }
    return read_model("a.stl", s);
  };
  const Model viscam = coloured("part", {0xfc00, 0x83e0, 0x801f, 0x7fff, 0x8000, 0x8000 | 16 << 10});
  CHECK(viscam.palette == Colours{{255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 255}, {0, 0, 0, 255}, {132, 0, 0, 255}});
  CHECK(viscam.face_colour == std::vector<std::uint32_t>{0, 1, 2, none, 3, 4});
  CHECK(coloured("part", {0x1234, 0, 0x7fff}).palette.empty());

  const std::string header = std::string("COLOR=\x10\x20\x30\x80", 10) + ",MATERIAL=";
  const Model magics = coloured(header, {0x801f, 0x001f, 0x03e0, 0x7c00});
  CHECK(magics.palette == Colours{{16, 32, 48, 128}, {255, 0, 0, 128}, {0, 255, 0, 128}, {0, 0, 255, 128}});
  CHECK(coloured(header, {0, 0}).palette == Colours{{16, 32, 48, 128}});  // nobody has set them
  CHECK(coloured(header, {0, 1}).palette[0] == Colour{0, 0, 0, 128});
}

TEST_CASE("STL: facets in text have colours", "[read][stl][colour][R11]") {
  const std::string loop = "outer loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n";
  const Model m = read_model(
      "a.stl", "solid a\nfacet normal 0 0 1\n" + loop + "endfacet color 31744\nfacet normal 0 0 1\ncolor 0 1 0.5\n" + loop +
                   "endfacet\nfacet normal 0 0 1 color 0 0 255\n" + loop + "endfacet\nfacet\n" + loop + "endfacet\nendsolid\n");
  CHECK(m.palette == Colours{{255, 0, 0, 255}, {0, 255, 128, 255}, {0, 0, 255, 255}});
  CHECK(m.face_colour == std::vector<std::uint32_t>{0, 1, 2, none});
  CHECK(refusal("a.stl", "solid a\nfacet normal 0 0 1\n" + loop + "endfacet color red\nendsolid\n") ==
        "a.stl: line 8: found \"red\", expected a colour: a number of 15 bits, or red, green and blue");
}

TEST_CASE("Light becomes the nearest byte of sRGB", "[read][gltf][colour][property][R9]") {
  CHECK(internal::read::srgb_byte(0.5) == 0xbc);
  CHECK(internal::read::srgb_byte(0.1) == 0x59);
  CHECK(internal::read::srgb_byte(-1) == 0);
  CHECK(internal::read::srgb_byte(7) == 255);
  for (int byte = 0; byte < 256; ++byte) {
    CAPTURE(byte);
    CHECK(internal::read::srgb_byte(internal::read::linear_of_srgb(static_cast<std::uint8_t>(byte))) == byte);
    // The border between two bytes is where the curve is half-way between them.
    const double s = (byte + 0.5) / 255, border = s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
    CHECK(internal::read::srgb_byte(border * (1 - 1e-12)) == byte);
    CHECK(internal::read::srgb_byte(border * (1 + 1e-12)) == std::min(byte + 1, 255));
  }
}
