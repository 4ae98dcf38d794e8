#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "geometry/number.h"
#include "hsr/io/read/gltf_transform.h"
#include "tests/io/read/refused.h"
#include "tests/io/read/small_files.h"

using namespace hsr;
using namespace hsr::internal;
using namespace hsr::test;

namespace {

/// A GLB whose buffer holds five points and the indices 0 1 2 3 4 as shorts.
std::string scene(const std::string& nodes, const std::string& primitives, const std::string& more = "") {
  std::string binary;
  for (const float x : {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0}) binary += little_float(x);
  for (const int i : {0, 1, 2, 3, 4}) binary += little(static_cast<std::uint64_t>(i), 2);
  return glb(R"({"asset": {"version": "2.0"}, "nodes": [)" + nodes + R"(], "meshes": [{"primitives": [)" + primitives + R"(]}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 5, "type": "VEC3"},
{"bufferView": 1, "componentType": 5123, "count": 5, "type": "SCALAR"},
{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
{"bufferView": 0, "componentType": 5126, "count": 6, "type": "VEC3"},
{"componentType": 5126, "count": 6, "type": "VEC3"}],
"bufferViews": [{"buffer": 0, "byteLength": 60}, {"buffer": 0, "byteOffset": 60, "byteLength": 10}],
"buffers": [{"byteLength": 72}])" +
                 more + "}",
             binary);
}

std::string primitive(int mode, bool indexed = true) {
  return R"({"attributes": {"POSITION": )" + std::string(indexed ? "0" : "2") + "}, " + (indexed ? R"("indices": 1, )" : "") +
         R"("mode": )" + std::to_string(mode) + "}";
}

using Corners = std::vector<std::uint32_t>;

}  // namespace

TEST_CASE("glTF: extras of a primitive have marks of its faces and edges", "[read][gltf][marks][J7]") {
  const auto with = [](const std::string& marks,
                       const std::string& node = R"({"mesh": 0}, {"mesh": 0, "translation": [5, 0, 0]})") {
    std::string strip = primitive(5);
    strip.insert(1, R"("extras": {"hsr_marks": )" + marks + "}, ");
    return scene(node, strip + ", " + primitive(6), R"(, "scenes": [{"nodes": [0, 1]}])");
  };
  const std::string marks =
      R"({"format": "hsr-marks/1", "surfaces": [4, 4, null], "edges": [{"points": [1, 2, 3], "mark": "smooth",
"circle": {"centre": [0, 0, 0], "axis": [0, 0, 1], "radius": 1}}]})";
  const Model model = read_model("a.glb", with(marks));
  REQUIRE(model.polygons.size() == 12);
  constexpr std::uint32_t none = 0xffffffffU;
  // Of a second instance they are other surfaces, and its circle has moved with it.
  CHECK(model.face_surface == std::vector<std::uint32_t>{0, 0, none, none, none, none, 1, 1, none, none, none, none});
  REQUIRE(model.marks.size() == 4);
  CHECK(model.marks[0] == MarkedEdge{{1, 2}, EdgeMark::smooth, 0, 0});
  CHECK(model.marks[1] == MarkedEdge{{2, 3}, EdgeMark::smooth, 0, 0});
  CHECK(model.marks[2] == MarkedEdge{{6, 7}, EdgeMark::smooth, 1, 1});
  REQUIRE(model.circles.size() == 2);
  CHECK(model.circles[0].centre == Point3{0, 0, 0});
  CHECK(model.circles[1].centre == Point3{5, 0, 0});
  CHECK(model.notes.empty());
  const auto refused = [&](const std::string& wrong) { return refusal("a.glb", with(wrong)); };
  CHECK(refused("[]") == "a.glb: mesh 0, primitive 0, extras: found no object, expected {\"format\": \"hsr-marks/1\", ...}");
  CHECK(refused(R"({"format": "hsr-marks/1", "surfaces": [1]})") ==
        "a.glb: mesh 0, primitive 0, extras, surfaces: found 1 numbers, expected one for each of the 3 faces of the primitive");
  CHECK(refused(R"({"format": "hsr-marks/1", "edges": [{"points": [0, 5], "mark": "sharp"}]})") ==
        "a.glb: mesh 0, primitive 0, extras, edge 0: points: found 5, expected the number of one of the 5 points of the "
        "primitive");
  CHECK(refused(R"({"format": "hsr-marks/1", "surfaces": [1, 2, 4294967295]})") ==
        "a.glb: mesh 0, primitive 0, extras, surfaces, face 2: found 4294967295, expected the number of a surface, or null");
  CHECK(refused(R"({"format": "hsr-marks/1", "edges": {}})") ==
        "a.glb: mesh 0, primitive 0, extras, edges: found {}, expected a list");
}

TEST_CASE("glTF: extras of a mesh have marks where it has one primitive", "[read][gltf][marks][J7]") {
  const auto with_extras = [](const std::string& primitives) {
    return scene(R"({"mesh": 0})",
                 primitives + R"(], "extras": {"hsr_marks": {"format": "hsr-marks/1", "surfaces": [1, 1, 2]}}, "weights": [)");
  };
  CHECK(read_model("a.glb", with_extras(primitive(5))).face_surface == std::vector<std::uint32_t>{0, 0, 1});
  CHECK(refusal("a.glb", with_extras(primitive(5) + ", " + primitive(6))) ==
        "a.glb: mesh 0, extras: found hsr_marks of 2 primitives, expected them in the extras of each primitive");
}

TEST_CASE("glTF: a circle of marks turns and grows with its node, and is none where that makes an ellipse of it",
          "[read][gltf][marks][J7]") {
  const auto circles_of = [](const std::string& motion) {
    std::string marked = primitive(5);
    marked.insert(1, R"("extras": {"hsr_marks": {"format": "hsr-marks/1", "edges": [{"points": [1, 2], "mark": "sharp",
"circle": {"centre": [1, 0, 0], "axis": [0, 0, 2], "radius": 3}}]}}, )");
    const Model model = read_model("a.glb", scene(R"({"mesh": 0, )" + motion + "}", marked));
    REQUIRE(model.marks.size() == 1);
    CHECK(model.marks[0].circle == (model.circles.empty() ? 0xffffffffU : 0U));
    return model.circles;
  };
  // A quarter of a turn about x, in single precision, as exporters write it.
  const auto turned = circles_of(R"("rotation": [0.70710677, 0, 0, 0.70710677], "scale": [2, 2, 2], "translation": [0, 1, 0])");
  REQUIRE(turned.size() == 1);
  CHECK(turned[0].centre.x == Approx(2));
  CHECK(turned[0].centre.y == Approx(1));
  CHECK(turned[0].axis.y == Approx(-1));
  CHECK(turned[0].radius == Approx(6));
  CHECK(circles_of(R"("scale": [-1, 1, 1])").size() == 1);
  CHECK(circles_of(R"("scale": [1, 1, 1.001])").empty());
  CHECK(circles_of(R"("matrix": [1, 0, 0, 0, 0.6, 0.8, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1])").empty());
}

TEST_CASE("glTF: marks count the triangles of MASK that are not there", "[read][gltf][marks][J7]") {
  // Vertices 0 and 1 are clear: of the three triangles of the strip the first has too little of its mean, and is left out.
  std::string marked = R"({"attributes": {"POSITION": 0, "COLOR_0": 5}, "indices": 1, "mode": 5, "material": 0, "extras":
{"hsr_marks": {"format": "hsr-marks/1", "surfaces": [7, 8, 9], "edges": [{"points": [0, 1], "mark": "smooth"},
{"points": [2, 4], "mark": "sharp"}]}}})";
  std::string binary;
  for (const float x : {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0}) binary += little_float(x);
  for (const float alpha : {0, 0, 1, 1, 1})
    for (const float x : {1.0F, 1.0F, 1.0F, alpha}) binary += little_float(x);
  for (const int i : {0, 1, 2, 3, 4}) binary += little(static_cast<std::uint64_t>(i), 2);
  const std::string file = glb(R"({"asset": {"version": "2.0"}, "nodes": [{"mesh": 0}], "meshes": [{"primitives": [)" + marked +
                                   R"(]}], "materials": [{"alphaMode": "MASK", "alphaCutoff": 0.5}], "accessors": [
{"bufferView": 0, "componentType": 5126, "count": 5, "type": "VEC3"},
{"bufferView": 2, "componentType": 5123, "count": 5, "type": "SCALAR"},
{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
{"bufferView": 1, "componentType": 5126, "count": 5, "type": "VEC4"}],
"bufferViews": [{"buffer": 0, "byteLength": 60}, {"buffer": 0, "byteOffset": 60, "byteLength": 80},
{"buffer": 0, "byteOffset": 140, "byteLength": 10}], "buffers": [{"byteLength": 152}]})",
                               binary);
  const Model model = read_model("a.glb", file);
  REQUIRE(model.polygons.size() == 2);
  CHECK(model.face_surface == std::vector<std::uint32_t>{0, 1});  // those of the second and the third triangle
  REQUIRE(model.marks.size() == 1);                               // the edge of the first one is of none that is there
  CHECK(model.marks[0] == MarkedEdge{{2, 4}, EdgeMark::sharp, 0, 0xffffffffU});
  CHECK(model.notes.size() == 2);
}

TEST_CASE("glTF: primitives of one mesh have marks of their own, and one of points needs none", "[read][gltf][marks][J7]") {
  const auto with = [](int mode, const std::string& surfaces) {
    std::string marked = primitive(mode);
    return marked.insert(1, R"("extras": {"hsr_marks": {"format": "hsr-marks/1", "surfaces": )" + surfaces + "}}, ");
  };
  const Model model = read_model("a.glb", scene(R"({"mesh": 0})", with(5, "[4, 4, null]") + ", " + primitive(6) + ", " +
                                                                      with(6, "[4, 5, 4]") + ", " + with(0, "[]")));
  constexpr std::uint32_t none = 0xffffffffU;
  CHECK(model.face_surface == std::vector<std::uint32_t>{0, 0, none, none, none, none, 1, 2, 1});
  CHECK(refusal("a.glb", scene(R"({"mesh": 0})", primitive(5) + ", " + with(6, "[4, 5]"))) ==
        "a.glb: mesh 0, primitive 1, extras, surfaces: found 2 numbers, expected one for each of the 3 faces of the primitive");
}

TEST_CASE("glTF: triangles, strips, fans, lines and loops", "[read][gltf]") {
  const std::string node = R"({"mesh": 0})";
  const Model strip = read_model("a.glb", scene(node, primitive(5)));
  REQUIRE(strip.polygons.size() == 3);
  CHECK(corners(strip, 0) == Corners{0, 1, 2});
  CHECK(corners(strip, 1) == Corners{2, 1, 3});
  CHECK(corners(strip, 2) == Corners{2, 3, 4});
  const Model fan = read_model("a.glb", scene(node, primitive(6)));
  CHECK(corners(fan, 2) == Corners{0, 3, 4});
  CHECK(read_model("a.glb", scene(node, primitive(3))).polygons.segments.size() == 4);
  const Model loop = read_model("a.glb", scene(node, primitive(2)));
  CHECK(loop.polygons.segments.back() == std::array<std::uint32_t, 2>{4, 0});
  const Model plain = read_model("a.glb", scene(node, primitive(4, false)));
  CHECK(corners(plain, 0) == Corners{0, 1, 2});
  CHECK(plain.notes.empty());
  CHECK(refusal("a.glb", scene(node, primitive(4))) == "a.glb: mesh 0, primitive 0: found 5 corners, expected a multiple of 3");
  CHECK(refusal("a.glb", scene(node, primitive(1))) == "a.glb: mesh 0, primitive 0: found 5 corners, expected a multiple of 2");
  CHECK(refusal("a.glb", scene(node, primitive(9))) == "a.glb: mesh 0, primitive 0: found mode 9, expected 0 to 6");
  CHECK(refusal("a.glb", scene(node, primitive(0))) == "a.glb: found no points, faces or lines, expected a model");
}

TEST_CASE("glTF: nodes place their meshes, parents before children, and give the names", "[read][gltf][R6]") {
  const Model m = read_model("a.glb", scene(R"({"name": "base", "children": [1, 2], "scale": [2, 2, 2]},
{"name": "left", "mesh": 0, "translation": [1, 0, 0]},
{"name": "right", "mesh": 0, "matrix": [0,1,0,0, -1,0,0,0, 0,0,1,0, 5,6,7,1]})",
                                            primitive(4, false)));
  REQUIRE(m.points.size() == 6);
  CHECK(m.points[1] == Point3{4, 0, 0});
  CHECK(m.points[4] == Point3{10, 14, 14});
  CHECK(m.objects == std::vector<std::string>{"left", "right"});
  CHECK(m.face_object == std::vector<std::uint32_t>{0, 1});
  CHECK(m.notes.empty());  // nothing had to be rounded
  const auto notes = [](const std::string& node) { return read_model("a.glb", scene(node, primitive(4, false))).notes; };
  const std::vector<std::string> rounded = {
      "points moved by nodes are rounded once, to the nearest double, by matrices composed in doubles"};
  CHECK(notes(R"({"mesh": 0, "translation": [0.1, 0, 0]})") == rounded);  // 1 + 0.1
  CHECK(notes(R"({"mesh": 0, "translation": [0.5, 0, 0]})").empty());
  CHECK(notes(R"({"mesh": 0, "rotation": [0, 0, 0.6, 0.8]})") == rounded);
  CHECK(notes(R"({"mesh": 0, "rotation": [0, 0, 1, 0], "scale": [0.1, 0.1, 0.1]})").empty());
  CHECK(notes(R"({"scale": [0.1, 0.1, 0.1], "children": [1]}, {"mesh": 0, "scale": [0.1, 1, 1]})") == rounded);
  CHECK(notes(R"({"mesh": 0}, {"camera": 0, "rotation": [0, 0, 0.6, 0.8]})").empty());
}

TEST_CASE("glTF: lines are of the object of their node", "[read][gltf][wires][R12]") {
  const Model m = read_model("a.glb", scene(R"({"name": "left", "mesh": 0}, {"name": "right", "mesh": 0})", primitive(3)));
  CHECK(m.polygons.segments.size() == 8);
  CHECK(m.objects == std::vector<std::string>{"left", "right"});
  CHECK(m.segment_object == std::vector<std::uint32_t>{0, 0, 0, 0, 1, 1, 1, 1});
}

TEST_CASE("glTF: only the default scene is read", "[read][gltf]") {
  const std::string nodes = R"({"mesh": 0}, {"mesh": 0, "translation": [9, 0, 0]})";
  CHECK(read_model("a.glb", scene(nodes, primitive(4, false), R"(, "scene": 1, "scenes": [{"nodes": [0]}, {"nodes": [1]}])"))
            .points[0]
            .x == 9);
  CHECK(read_model("a.glb", scene(nodes, primitive(4, false))).points.size() == 6);
}

TEST_CASE("glTF: what does not fit is refused in one line", "[read][gltf]") {
  const std::string node = R"({"mesh": 0})", triangles = primitive(4, false);
  const auto mesh = [&](const std::string& p) { return refusal("a.glb", scene(node, p)); };
  CHECK(mesh(R"({"attributes": {"POSITION": 77}})") == "a.glb: mesh 0, primitive 0: found accessor 77, expected one of 5");
  CHECK(mesh(R"({"attributes": {"POSITION": 3}})") ==
        "a.glb: mesh 0, primitive 0: found accessor 3 of 6 elements, expected no more than fit into the 60 bytes of its "
        "bufferView");
  CHECK(mesh(R"({"attributes": {"POSITION": 4}})") ==
        "a.glb: mesh 0, primitive 0: found accessor 4 without data, expected a bufferView (is the geometry compressed?)");
  CHECK(mesh(R"({"attributes": {"POSITION": 1}})").find("found accessor 1 of another type, expected VEC3") !=
        std::string::npos);
  CHECK(mesh(R"({"attributes": {"POSITION": 2}, "indices": 1, "mode": 6})") ==
        "a.glb: mesh 0, primitive 0, corner 3: found index 3, expected 0 to 2");
  CHECK(mesh(R"({"attributes": {"POSITION": 2}, "indices": 0})").find("expected an unsigned byte, short or int") !=
        std::string::npos);
  CHECK(mesh(R"({"attributes": {}})").find("found no attribute POSITION") != std::string::npos);
  CHECK(refusal("a.glb", scene(R"({"children": [1]}, {"children": [0]})", triangles, R"(, "scenes": [{"nodes": [0]}])")) ==
        "a.glb: node 0: found a second parent or a cycle, expected a tree of nodes");
  CHECK(refusal("a.glb", scene(R"({"mesh": 3})", triangles)) == "a.glb: node 0: found mesh 3, expected one of 1");
  CHECK(refusal("a.glb", scene(node, triangles, R"(, "extensionsRequired": ["KHR_draco_mesh_compression"])"))
            .find("compressed with KHR_draco_mesh_compression") != std::string::npos);
  CHECK(refusal("a.glb", scene(node, triangles, R"(, "extensionsRequired": ["X_y"])"))
            .find("found the required extension \"X_y\"") != std::string::npos);
  const std::string whole = scene(node, triangles);
  CHECK(refusal("a.glb", whole.substr(0, whole.size() - 4)).find("byte 8: found a file of") != std::string::npos);
  CHECK(refusal("a.glb", "glTF") == "a.glb: byte 0: found the end of the file, expected the 20 bytes of a GLB header");
  CHECK(refusal("a.gltf", "{\"asset\": {\"version\": \"2.0\"},\n\"nodes\": [}") ==
        "a.gltf: line 2 of the JSON: found \"}\", expected well-formed JSON");
  CHECK(refusal("a.gltf", "{\"asset\": " + std::string(100000, '[')).find("found more than 100 brackets") != std::string::npos);
  std::string nan = whole;
  nan.replace(nan.size() - 72, 4, little_float(std::numeric_limits<float>::quiet_NaN()));
  CHECK(refusal("a.glb", nan) == "a.glb: mesh 0, primitive 0, vertex 0: found NaN, expected a finite coordinate");
}

TEST_CASE("A moved point is the exact one, rounded once", "[read][gltf][property][R6]") {
  const auto seed = 7U;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  const auto number = [&](int spread) {
    const double m = static_cast<double>(static_cast<std::int64_t>(random() >> 11)) * (random() % 2 ? 1 : -1);
    switch (random() % 8) {
      case 0:
        return 0.0;
      case 1:
        return static_cast<double>(static_cast<int>(random() % 5) - 2);
      default:
        return std::ldexp(m, static_cast<int>(random() % static_cast<unsigned>(2 * spread)) - spread - 53);
    }
  };
  for (int k = 0; k < 20000; ++k) {
    const int spread = k % 3 == 0 ? 3 : k % 3 == 1 ? 60 : 500;
    read::Affine m;
    for (double& x : m) x = number(spread);
    const Point3 p = {number(spread), number(spread), number(spread)};
    if (k % 5 == 0) m[3] = -(m[0] * p.x);  // cancels nearly
    bool is_exact = true, still_exact = false;
    const Point3 q = read::transformed(m, p, is_exact);
    REQUIRE(read::transformed(m, p, still_exact) == q);
    bool all_exact = true;
    for (int i = 0; i < 3; ++i) {
      const std::size_t r = 4 * static_cast<std::size_t>(i);
      const Rational exact = Rational(m[r]) * Rational(p.x) + Rational(m[r + 1]) * Rational(p.y) +
                             Rational(m[r + 2]) * Rational(p.z) + Rational(m[r + 3]);
      REQUIRE(q[i] == exact.to_double());
      all_exact = all_exact && exact == Rational(q[i]);
    }
    REQUIRE(is_exact == all_exact);
  }
}
