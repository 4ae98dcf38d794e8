#include <catch2/catch.hpp>

#include "hsr/io/write/image_png.h"
#include "tests/io/read/refused.h"
#include "tests/io/read/small_files.h"

using namespace hsr;
using namespace hsr::internal;
using namespace hsr::test;

namespace {

using Names = std::vector<std::string>;
using Colours = std::vector<Colour>;

/// What a test puts into a GLB of one triangle (0,0,0) (1,0,0) (0,1,0), which is accessor 0.
struct Parts {
  std::string nodes = R"({"mesh": 0})";
  std::string attributes = {};  // more of them
  std::string materials = {};   // the primitive has the first one
  std::string more = {};        // of the file
  std::string binary = {};      // behind the 36 bytes of the triangle
  std::string views = {};       // of it, the first is bufferView 1
  std::string accessors = {};   // the first is 1
};

std::string file_of(const Parts& p) {
  std::string binary;
  for (const float x : {0, 0, 0, 1, 0, 0, 0, 1, 0}) binary += little_float(x);
  binary += p.binary;
  const std::string size = std::to_string(binary.size());
  const std::string material = p.materials.empty() ? "" : R"(, "material": 0)";
  return glb(R"({"asset": {"version": "2.0"}, "nodes": [)" + p.nodes +
                 R"(], "meshes": [{"primitives": [{"attributes": {"POSITION": 0)" + p.attributes + "}" + material +
                 "}]}], \"materials\": [" + p.materials +
                 R"(], "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"})" + p.accessors +
                 R"(], "bufferViews": [{"buffer": 0, "byteLength": 36})" + p.views + R"(], "buffers": [{"byteLength": )" +
                 size + "}]" + p.more + "}",
             binary);
}

Model read(const Parts& p) { return read_model("a.glb", file_of(p)); }

std::string floats(const std::vector<float>& xs) {
  std::string s;
  for (const float x : xs) s += little_float(x);
  return s;
}

std::string material(const std::string& factor, const std::string& more = "") {
  return R"({"pbrMetallicRoughness": {"baseColorFactor": )" + factor + "}" + more + "}";
}

}  // namespace

TEST_CASE("glTF: y is up, and a unit is a metre", "[read][gltf][R7]") {
  const Model m = read({});
  CHECK(m.up_axis == 'y');
  CHECK(m.unit == 1000);
  const Model obj = read_model("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  CHECK_FALSE(obj.up_axis);
  CHECK_FALSE(obj.unit);
}

TEST_CASE("glTF: colours are light, opacity is not", "[read][gltf][colour][R9][R10]") {
  const std::string half = "[0.5, 0.1, 0.1, 0.4]";
  CHECK(read({.materials = material(half)}).palette == Colours{{0xbc, 0x59, 0x59, 255}});
  CHECK(read({.materials = material(half, R"(, "alphaMode": "BLEND")")}).palette == Colours{{0xbc, 0x59, 0x59, 102}});
  CHECK(read({.materials = material(half, R"(, "alphaMode": "MASK", "alphaCutoff": 0.4)")}).palette ==
        Colours{{0xbc, 0x59, 0x59, 255}});
  const Model masked = read({.materials = material(half, R"(, "alphaMode": "MASK")")});
  CHECK(masked.polygons.size() == 0);
  CHECK(masked.notes == Names{"1 faces and lines of alphaMode MASK are below their alphaCutoff: they are not there"});
  const std::string older = R"({"extensions": {"KHR_materials_pbrSpecularGlossiness": {"diffuseFactor": [0.1, 0.5, 1, 1]}}})";
  CHECK(read({.materials = older}).palette == Colours{{0x59, 0xbc, 255, 255}});
  CHECK(read({}).palette.empty());
}

TEST_CASE("glTF: a face has the mean of COLOR_0 times its material", "[read][gltf][colour][R9]") {
  Parts p{.attributes = R"(, "COLOR_0": 1)",
          .binary = floats({1, 0, 0, 0.3F, 0.5F, 0, 0, 0.6F, 0, 0, 1, 0.9F}),
          .views = R"(, {"buffer": 0, "byteOffset": 36, "byteLength": 48})",
          .accessors = R"(, {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC4"})"};
  CHECK(read(p).palette == Colours{{188, 0, 156, 255}});  // light of 1/2 and 1/3
  p.materials = material("[0.2, 1, 1, 0.5]", R"(, "alphaMode": "BLEND")");
  CHECK(read(p).palette == Colours{{0x59, 0, 156, 77}});  // 0.1; 0.3 of 255 is 76.5
  p.accessors = R"(, {"bufferView": 1, "componentType": 5121, "normalized": true, "count": 3, "type": "VEC3"})";
  p.binary = std::string("\xff\0\0\0\0\0\0\0\0", 9) + std::string(39, '\0');
  CHECK(read(p).palette == Colours{{73, 0, 0, 128}});  // 1/15
  p.accessors = R"(, {"bufferView": 1, "componentType": 5126, "count": 2, "type": "VEC4"})";
  CHECK(refusal("a.glb", file_of(p)) ==
        "a.glb: mesh 0, primitive 0, COLOR_0: found 2 colours, expected one for each of 3 points");
}

TEST_CASE("glTF: a face has the mean colour of its texture", "[read][gltf][colour][R9]") {
  Image<Colour> image(2, 2);
  image.at(0, 0) = {255, 0, 0, 255};
  image.at(1, 0) = {0, 255, 0, 255};
  image.at(0, 1) = {0, 0, 255, 0};
  image.at(1, 1) = {255, 255, 255, 255};
  std::string png = image_png(image);
  const std::string size = std::to_string(png.size());
  const auto textured = [&](const std::vector<float>& places, const std::string& more, const std::string& sampler = "{}") {
    return read(
        {.attributes = R"(, "TEXCOORD_0": 1)",
         .materials = R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}})" + more + "}",
         .more = R"(, "textures": [{"source": 0, "sampler": 0}], "samplers": [)" + sampler +
                 R"(], "images": [{"bufferView": 2, "mimeType": "image/png"}])",
         .binary = floats(places) + png,
         .views = R"(, {"buffer": 0, "byteOffset": 36, "byteLength": 24}, {"buffer": 0, "byteOffset": 60, "byteLength": )" +
                  size + "}",
         .accessors = R"(, {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"})"});
  };
  const std::vector<float> first = {0.1F, 0.1F, 0.4F, 0.1F, 0.1F, 0.4F}, last = {0.1F, 0.9F, 0.4F, 0.9F, 0.1F, 0.6F};
  CHECK(textured(first, "").palette == Colours{{255, 0, 0, 255}});
  CHECK(textured({1.1F, 3.1F, 1.4F, 3.1F, 1.1F, 3.4F}, "").palette == Colours{{255, 0, 0, 255}});
  CHECK(textured({1.1F, 0.1F, 1.4F, 0.1F, 1.1F, 0.4F}, "", R"({"wrapS": 33071})").palette == Colours{{0, 255, 0, 255}});
  CHECK(textured({1.6F, 0.1F, 1.9F, 0.1F, 1.6F, 0.4F}, "", R"({"wrapS": 33648})").palette == Colours{{255, 0, 0, 255}});
  CHECK(textured(last, "").palette == Colours{{0, 0, 255, 255}});
  CHECK(textured(last, R"(, "alphaMode": "MASK")").polygons.size() == 0);
  CHECK(textured(last, R"(, "alphaMode": "BLEND")").palette[0][3] == 0);
  // The left texel has 12 of 16 samples, and three quarters of the triangle.
  CHECK(textured({0, 0.1F, 1, 0.1F, 0, 0.4F}, "").palette == Colours{{225, 137, 0, 255}});
  png.replace(20, 4, "\xff\xff\xff\xff");
  const Model broken = textured(first, "");
  CHECK(broken.palette == Colours{{255, 255, 255, 255}});
  CHECK(broken.notes ==
        Names{"1 texture cannot be read (missing, or neither PNG nor JPEG): faces have the colour of their material"});
}

TEST_CASE("glTF: elements of sparse accessors are replaced", "[read][gltf][sparse]") {
  Parts p{.binary = std::string("\2\0\0\0", 4) + floats({7, 8, 9}),
          .views = R"(, {"buffer": 0, "byteOffset": 36, "byteLength": 4}, {"buffer": 0, "byteOffset": 40, "byteLength": 12})"};
  std::string file = file_of(p);
  const auto with = [&](const std::string& accessor) {
    std::string text = file;
    const std::string old = R"({"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"})";
    const std::size_t at = text.find(old);
    const std::size_t json = text.find('{');
    std::string all = text.substr(json, text.find("BIN") - 4 - json);
    all.replace(at - json, old.size(), accessor);
    return glb(all, text.substr(text.find("BIN") + 4));
  };
  const std::string head = R"({"componentType": 5126, "count": 3, "type": "VEC3", )";
  const std::string sparse =
      R"("sparse": {"count": 1, "indices": {"bufferView": 1, "componentType": 5121}, "values": {"bufferView": 2}}})";
  const Model m = read_model("a.glb", with(head + R"("bufferView": 0, )" + sparse));
  CHECK(m.points == std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {7, 8, 9}});
  const Model zeros = read_model("a.glb", with(head + sparse));
  CHECK(zeros.points == std::vector<Point3>{{0, 0, 0}, {0, 0, 0}, {7, 8, 9}});
  std::string two = sparse;
  two.replace(two.find("\"count\": 1"), 10, "\"count\": 4");
  CHECK(refusal("a.glb", with(head + two)) ==
        "a.glb: mesh 0, primitive 0: found the sparse part of accessor 0 with 4 elements, expected 0 to 3");
  file[file.size() - 16] = 3;
  CHECK(refusal("a.glb", with(head + sparse)) ==
        "a.glb: mesh 0, primitive 0: found the sparse part of accessor 0 with index 3, expected less than 3");
}

TEST_CASE("glTF: instances are objects of their own", "[read][gltf][names][R12]") {
  Parts p{.nodes = R"({"name": "tree", "mesh": 0, "translation": [0, 0, 5], "extensions": {"EXT_mesh_gpu_instancing":
{"attributes": {"TRANSLATION": 1, "SCALE": 2}}}}, {"name": "tree", "mesh": 0}, {"mesh": 0})",
          .more = R"(, "extensionsRequired": ["EXT_mesh_gpu_instancing"])",
          .binary = floats({10, 0, 0, 20, 0, 0, 1, 1, 1, 2, 4, 8}),
          .views = R"(, {"buffer": 0, "byteOffset": 36, "byteLength": 48})",
          .accessors = R"(, {"bufferView": 1, "componentType": 5126, "count": 2, "type": "VEC3"},
{"bufferView": 1, "byteOffset": 24, "componentType": 5126, "count": 2, "type": "VEC3"})"};
  const Model m = read(p);
  CHECK(m.objects == Names{"tree", "tree [2]", "tree [3]", "node 2"});
  CHECK(m.points == std::vector<Point3>{{10, 0, 5},
                                        {11, 0, 5},
                                        {10, 1, 5},
                                        {20, 0, 5},
                                        {22, 0, 5},
                                        {20, 4, 5},
                                        {0, 0, 0},
                                        {1, 0, 0},
                                        {0, 1, 0},
                                        {0, 0, 0},
                                        {1, 0, 0},
                                        {0, 1, 0}});
  CHECK(m.notes.empty());
  p.nodes.replace(p.nodes.find("\"SCALE\": 2"), 10, "\"SCALE\": 0");
  CHECK(refusal("a.glb", file_of(p)) ==
        "a.glb: node 0, EXT_mesh_gpu_instancing, SCALE: found 3 elements, expected 2 as others have");
}

TEST_CASE("glTF: materials are named, or numbered", "[read][gltf][names][R13]") {
  const Model named = read({.materials = R"({"name": "brick"}, {"name": "brick"})"});
  CHECK(named.materials == Names{"brick"});
  CHECK(named.face_material == std::vector<std::uint32_t>{0});
  CHECK(read({.materials = "{}"}).materials == Names{"material 0"});
  CHECK(read({}).materials.empty());
}

TEST_CASE("glTF: cameras are where their nodes are", "[read][gltf][R15]") {
  const Model m =
      read({.nodes = R"({"mesh": 0}, {"name": "street", "camera": 0, "translation": [1, 2, 3]},
{"name": "street", "camera": 0, "matrix": [0,1,0,0, 0,0,1,0, 1,0,0,0, 0,0,0,1]}, {"camera": 1}, {"camera": 2}, {"camera": 7})",
            .more = R"(, "cameras": [{"type": "perspective", "perspective": {"yfov": 1.5707963267948966, "znear": 0.25,
"aspectRatio": 2}}, {"type": "orthographic", "name": "plan"}, {"type": "perspective"}])"});
  REQUIRE(m.cameras.size() == 3);
  CHECK(m.cameras[0].name == "street");
  CHECK(m.cameras[0].position == Point3{1, 2, 3});
  CHECK(m.cameras[0].direction == Point3{0, 0, -1});
  CHECK(m.cameras[0].up == Point3{0, 1, 0});
  CHECK(m.cameras[0].field_of_view.value() == Approx(90));
  CHECK(m.cameras[0].aspect_ratio == 2);
  CHECK(m.cameras[0].near == 0.25);
  CHECK(m.cameras[1].name == "street [2]");
  CHECK(m.cameras[1].direction == Point3{-1, 0, 0});
  CHECK(m.cameras[1].up == Point3{0, 0, 1});
  CHECK(m.cameras[2].name == "plan");
  CHECK_FALSE(m.cameras[2].field_of_view);
}
