#include <catch2/catch.hpp>

#include "tests/io/read/refused.h"
#include "tests/io/read/small_files.h"
#include "tests/io/read/temporary_directory.h"

using namespace hsr;
using namespace hsr::test;

namespace {

using Names = std::vector<std::string>;
using Numbers = std::vector<std::uint32_t>;
constexpr std::uint32_t none = 0xffffffffU;
const std::string four = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n", f = "f 1 2 3\n";

}  // namespace

TEST_CASE("OBJ: objects are named by o, in a file without any by g", "[read][obj][names][R12]") {
  const Model o = read_model("a.obj", four + f + "o house\ng roof\n" + f + "g wall\n" + f + "o shed\n" + f + "o house\n" + f);
  CHECK(o.objects == Names{"default", "house", "shed"});
  CHECK(o.face_object == Numbers{0, 1, 1, 2, 1});
  const Model g = read_model("a.obj", four + "g roof\n" + f + "g\n" + f + "g roof\n" + f + "o unused\n");
  CHECK(g.objects == Names{"roof", "default"});
  CHECK(g.face_object == Numbers{0, 1, 0});
}

TEST_CASE("OBJ: a wire is of the object or group that it stands in", "[read][obj][names][wires][R12]") {
  const std::string l = "l 1 2\n";
  const Model o = read_model("a.obj", four + l + f + "o house\ng roof\n" + l + f + "o rail\n" + l + "o house\nl 1 2 3\n");
  CHECK(o.objects == Names{"default", "house", "rail"});
  CHECK(o.face_object == Numbers{0, 1});
  CHECK(o.segment_object == Numbers{0, 1, 2, 1, 1});
  const Model g = read_model("a.obj", four + f + "g axis\n" + l + "g\n" + l);
  CHECK(g.objects == Names{"default", "axis"});
  CHECK(g.face_object == Numbers{0});
  CHECK(g.segment_object == Numbers{1, 0});
  const Model only_wires = read_model("a.obj", four + "o first\n" + l + "o second\n" + l);
  CHECK(only_wires.objects == Names{"first", "second"});
  CHECK(only_wires.face_object.empty());
  CHECK(only_wires.segment_object == Numbers{0, 1});
  CHECK(read_model("a.obj", four + f + l + "o unused\n").segment_object.empty());
}

TEST_CASE("OBJ: materials are those of usemtl, with or without a library", "[read][obj][names][R13]") {
  const Model m = read_model("a.obj", four + f + "usemtl lib\\wood\\\n" + f + "usemtl \"deep red\"\n" + f + "usemtl\n" + f +
                                          "usemtl lib\\wood\\\n" + f + "usemtl unused\n");
  CHECK(m.materials == Names{"lib\\wood\\", "deep red"});
  CHECK(m.face_material == Numbers{none, 0, 1, none, 0});
  CHECK(labels_of(m).material == m.face_material);
  CHECK(read_model("a.obj", four + f).face_material.empty());
}

TEST_CASE("STL: a second solid of one name is another object", "[read][stl][names][R12]") {
  const std::string t = "facet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
  const Model m =
      read_model("a.stl", "solid\n" + t + "endsolid\nsolid a\n" + t + "endsolid\nsolid a\n" + t + "endsolid\nsolid a\n" + t);
  CHECK(m.objects == Names{"solid 1", "a", "a [2]", "a [3]"});
  CHECK(m.face_object == Numbers{0, 1, 2, 3});
}

TEST_CASE("OBJ: a material library is found by what is plainly meant", "[read][obj][file][R14]") {
  const TemporaryDirectory directory;
  directory.write("deep red.mtl", "\xef\xbb\xbfnewmtl \"red one\"\nKd 1 0 0\n");
  directory.write("Blue.MTL", "newmtl blue\nKd 0 0 1\nmap_Kd sky.png\n");
  const std::string faces = four + "usemtl red one\n" + f + "usemtl blue\n" + f;
  for (const std::string line : {"\"deep red.mtl\" \"Blue.MTL\"", "deep red.mtl Blue.MTL # two of them",
                                 "Blue.MTL deep red.mtl", "C:\\parts\\deep red.mtl blue.mtl", "deep red.mtl \\\n  blue.mtl"}) {
    INFO(line);
    const Model m = read_model(directory.write("a.obj", "mtllib " + line + "\n" + faces));
    CHECK(m.palette == std::vector<Colour>{{255, 0, 0, 255}, {0, 0, 255, 255}});
    CHECK(m.notes == Names{"textures (map_Kd) are passed over: faces have the colour of their material"});
  }
}
