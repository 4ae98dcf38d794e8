#include "hsr/joined_models.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>

#include "geometry/error.h"
#include "hsr/object_selection.h"

namespace hsr {

using namespace internal;

namespace {

/// One triangle per object, at x = 0, 1, 2 ...
Model model(const std::string& name, const std::vector<std::string>& objects, double size = 1) {
  Model m;
  m.name = name;
  m.format = "OBJ";
  m.objects = objects;
  const std::size_t faces = std::max<std::size_t>(1, objects.size());
  for (std::uint32_t f = 0; f < faces; ++f) {
    const double x = f;
    for (const Point3& p : {Point3{x, 0, 0}, {x, size, 0}, {x, 0, size}}) m.points.push_back(p);
    m.polygons.corners.insert(m.polygons.corners.end(), {3 * f, 3 * f + 1, 3 * f + 2});
    m.polygons.first.push_back(3 * f + 3);
    if (!objects.empty()) m.face_object.push_back(f);
  }
  return m;
}

std::string refusal(const std::function<void()>& work) {
  try {
    work();
  } catch (const InputError& e) {
    return e.what();
  }
  return "nothing was refused";
}

TEST_CASE("surfaces, marks and circles of several models keep apart, and go into the common unit", "[scene][joined][O1]") {
  Model a = model("a.step", {"plate", "bolt"}), b = model("b.step", {}), plain = model("c.obj", {});
  a.face_surface = {0, 0xffffffffU};
  a.surfaces = {{SurfaceKind::plane, {1, 0, 0}, {0, 0, 1}, 0}};
  a.marks = {{{1, 2}, EdgeMark::smooth, 0}, {{3, 4}, EdgeMark::sharp, 1}};
  b.face_surface = {4};
  b.marks = {{{0, 1}, EdgeMark::inner, 0, 0}};
  b.circles = {{{1, 2, 3}, {0, 0, 1}, 2}};
  const Model m = joined({{a}, {plain}, {b, "cm", true}}).model;
  CHECK(m.face_surface == std::vector<std::uint32_t>{0, 0xffffffffU, 0xffffffffU, 5});
  CHECK(m.surfaces.size() == 1);
  CHECK(m.marks ==
        std::vector<MarkedEdge>{{{1, 2}, EdgeMark::smooth, 0}, {{3, 4}, EdgeMark::sharp, 1}, {{9, 10}, EdgeMark::inner, 3, 0}});
  REQUIRE(m.circles.size() == 1);
  CHECK(m.circles[0].centre == Point3{10, -30, 20});
  CHECK(m.circles[0].axis == Point3{0, -1, 0});
  CHECK(m.circles[0].radius == 20);
}

TEST_CASE("several models become one, their faces, wires and colours one after the other", "[scene][joined][O1]") {
  Model a = model("here/a.obj", {"plate", "bolt"}), b = model("there/b.stl", {});
  a.palette = {{255, 0, 0, 255}};
  a.face_colour = {0, 0xffffffffU};
  a.polygons.segments = {{0, 4}};
  a.segment_object = {1};
  b.palette = {{0, 255, 0, 255}};
  b.face_colour = {0};
  b.polygons.segments = {{1, 2}};
  b.materials = {"steel"};
  b.face_material = {0};
  b.notes = {"something"};
  const JoinedModels all = joined({{a}, {b}});
  const Model& m = all.model;
  CHECK(m.points.size() == 9);
  CHECK(m.polygons.first == std::vector<std::uint32_t>{0, 3, 6, 9});
  CHECK(m.polygons.corners == std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6, 7, 8});
  CHECK(m.polygons.segments == std::vector<std::array<std::uint32_t, 2>>{{0, 4}, {7, 8}});
  CHECK(m.palette.size() == 2);
  CHECK(m.face_colour == std::vector<std::uint32_t>{0, 0xffffffffU, 1});
  CHECK(m.face_material == std::vector<std::uint32_t>{0xffffffffU, 0xffffffffU, 0});
  CHECK(m.objects == std::vector<std::string>{"plate", "bolt", "b.stl"});  // b names none: the file's name
  CHECK(m.face_object == std::vector<std::uint32_t>{0, 1, 2});
  CHECK(m.segment_object == std::vector<std::uint32_t>{1, 2});
  CHECK(m.notes == std::vector<std::string>{"b.stl: something"});
  CHECK(m.name == "a.obj + b.stl");
  CHECK((all.unit == "mm" && !all.is_y_up));
}

TEST_CASE("a single model stays as it is", "[scene][joined][O1]") {
  const JoinedModels all = joined({{model("here/a.obj", {}), "m", true}});
  CHECK(all.model.name == "here/a.obj");
  CHECK(all.model.objects.empty());
  CHECK((all.unit == "m" && all.is_y_up));
}

TEST_CASE("names that two models have get the file's name in front", "[scene][joined][O1]") {
  const auto names = [](std::vector<ModelToJoin> models) { return joined(std::move(models)).model.objects; };
  CHECK(names({{model("a.obj", {"plate", "bolt"})}, {model("b.obj", {"bolt", "nut"})}}) ==
        std::vector<std::string>{"plate", "a.obj:bolt", "b.obj:bolt", "nut"});
  CHECK(names({{model("x/a.stl", {})}, {model("y/a.stl", {})}}) == std::vector<std::string>{"a.stl:a.stl", "a.stl:a.stl#2"});
  CHECK(names({{model("a.obj", {"", "bolt"})}, {model("b.obj", {})}}) == std::vector<std::string>{"a.obj", "bolt", "b.obj"});
}

TEST_CASE("units and up axes are converted where no coordinate is rounded", "[scene][joined][O2]") {
  const auto all = joined({{model("a.obj", {}, 8), "mm", false}, {model("b.glb", {}, 0.5), "m", true}});
  CHECK((all.unit == "mm" && !all.is_y_up));
  CHECK((all.model.points[2] == Point3{0, 0, 8}));
  CHECK((all.model.points[4] == Point3{0, 0, 500}));   // 0.5 m up along y
  CHECK((all.model.points[5] == Point3{0, -500, 0}));  // 0.5 m along z, toward the viewer of the front
  const auto turned = joined({{model("b.glb", {}), "m", true}, {model("a.obj", {}, 3), "m", false}});
  CHECK(turned.is_y_up);
  CHECK((turned.model.points[5] == Point3{0, 3, 0}));
  CHECK((turned.model.points[4] == Point3{0, 0, -3}));
  // 0.1 m, as the double that it is, is no double in millimetres; 1000 mm are one in metres.
  CHECK(joined({{model("a.obj", {}, 1000), "mm"}, {model("b.obj", {}, 0.1), "m"}}).unit == "m");
  CHECK(joined({{model("a.obj", {}, 5), "in"}, {model("b.obj", {}, 2), "mm"}}).unit == "mm");
}

TEST_CASE("units that would round a coordinate are refused with the coordinate", "[scene][joined][O2]") {
  const std::string said = refusal([] { joined({{model("a.obj", {}, 8), "mm"}, {model("there/b.obj", {}, 0.1), "m"}}); });
  INFO(said);
  for (const char* words : {"there/b.obj: point 1: found 0.1", " m, which is no double in mm", "a.obj", "--unit"})
    CHECK(said.find(words) != std::string::npos);
  CHECK(refusal([] { joined({{model("a.obj", {}), "ft"}}); }) == "unit: found \"ft\", expected mm, cm, m or in");
}

TEST_CASE("objects that are not wanted have faces without corners, and all others keep their numbers", "[scene][objects][O3]") {
  Model m = model("a.obj", {"plate", "bolt", "nut"});
  m.polygons.segments = {{0, 1}};
  select(m, {.only = {"bolt"}, .ghost = {"nut"}});
  REQUIRE(m.polygons.size() == 3);
  CHECK(m.polygons[0].empty());
  CHECK(m.polygons[1].size() == 3);
  CHECK(m.polygons[1].front() == 3);
  CHECK(m.polygons[2].size() == 3);
  CHECK(m.polygons.is_ghost == std::vector<std::uint8_t>{0, 0, 1});
  CHECK(m.polygons.segments.empty());
  Model n = model("a.obj", {"plate", "bolt", "nut"});
  n.polygons.segments = {{0, 1}};
  select(n, {.hide = {"plate", "nut"}});
  CHECK((n.polygons[0].empty() && n.polygons[1].size() == 3 && n.polygons[2].empty()));
  CHECK(n.polygons.segments.size() == 1);
  Model whole = model("here/a.stl", {});
  select(whole, {.ghost = {"a.stl"}});
  CHECK(whole.polygons.is_ghost == std::vector<std::uint8_t>{1});
}

TEST_CASE("an object that is not there is answered by the names that are", "[scene][objects][O3]") {
  Model m = model("a.obj", {"plate", "bolt\n2"});
  CHECK(refusal([&] { select(m, {.hide = {"nut"}}); }) ==
        "hide: found no object \"nut\", expected one of \"plate\", \"bolt?2\"");
  CHECK(refusal([&] { select(m, {.only = {"plate"}, .hide = {"plate"}}); }).find("\"plate\"") != std::string::npos);
}

}  // namespace
}  // namespace hsr
