// What the steps of a method come to is what the library returns, watched or not.
#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "geometry/error.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/painter/bsp/bsp.h"
#include "hsr/painter/sort/depth_sort.h"
#include "hsr/painter/sort/z_sort.h"
#include "hsr/raster/a_buffer.h"
#include "hsr/raster/alpha_buffer.h"
#include "hsr/raster/caster.h"
#include "hsr/raster/depth_buffer.h"
#include "hsr/raster/facing_culling.h"
#include "hsr/raster/occlusion_culling.h"
#include "hsr/raster/row_z_buffer.h"
#include "hsr/raster/scanline.h"
#include "hsr/raster/tiled_z_buffer.h"
#include "hsr/scene/facet.h"
#include "hsr/surfaces/visible_fragments.h"
#include "study/explain/example_scenes.h"
#include "study/explain/explained_methods.h"
#include "study/explain/picture_result.h"
#include "tests/scenes/random_scenes.h"
#include "tests/study/traces.h"

namespace hsr::internal {
namespace {

ExplainedScene explained(const scenes::TestScene& scene) {
  ExplainedScene made;
  made.title = scene.name;
  made.model.points = scene.points;
  made.model.polygons = scene.polygons;
  made.mesh = scene.mesh();
  made.view = scene.view;
  return made;
}

/// Random scenes that can be explained.
std::vector<ExplainedScene> some_scenes() {
  std::vector<ExplainedScene> some;
  for (const char* const name : {"triangles", "polygons", "edge_on", "boxes", "slopes"})
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      ExplainedScene scene = explained(scenes::family(name).make(seed));
      scene.title = std::string(name) + " " + std::to_string(seed);
      try {
        check_explainable(scene);
        some.push_back(std::move(scene));
      } catch (const InputError&) {
      }
    }
  return some;
}

TEST_CASE("the steps of every method come to what it returns", "[study][explain]") {
  for (const ExplainedMethod& m : explained_methods()) {
    INFO(m.name);
    const Json json = Json::parse(trace_json(example_trace(m, 16)));
    check_form(json);
    check_end(json);
    std::size_t questions = 0;
    for (const Json& run : json["runs"])
      for (const Json& step : run["steps"]) questions += step.contains("choices") ? 1U : 0U;
    CHECK(questions > 0);
  }
}

TEST_CASE("nodes of a tree with parts of one face are told apart", "[study][explain]") {
  const Json trace = Json::parse(trace_json(explain_bsp(example_scene("walls"), 0)));
  for (const Json& run : trace["runs"]) {
    std::set<std::string> names;
    std::size_t nodes = 0;
    for (const Json& step : run["steps"])
      for (const Json& change : step.value("changes", Json::array()))
        if (change["do"] == "node") {
          ++nodes;
          names.insert(change["text"]);
        }
    CHECK(names.size() == nodes);
    CHECK(names.count("E.1") == 1);
  }
}

TEST_CASE("the steps come to the result on random scenes, too", "[study][explain][property]") {
  const std::vector<ExplainedScene> some = some_scenes();
  CHECK(some.size() > 30);
  for (const ExplainedScene& scene : some)
    for (const ExplainedMethod& m : explained_methods()) {
      INFO(scene.title << ", " << m.name);
      const Json json = Json::parse(trace_json(m.explain(scene, 8)));
      check_form(json);
      check_end(json);
    }
}

TEST_CASE("a watched method returns what it returns unwatched", "[study][explain][property]") {
  for (const ExplainedScene& scene : some_scenes()) {
    INFO(scene.title);
    const auto result = [&](Trace (*explain)(const ExplainedScene&, int), std::size_t run) {
      return Json::parse(explain(scene, 8).runs[run].result);
    };
    const SceneView prepared(scene.mesh, scene.view);
    CHECK(result(explain_depth_sort, 0) == Json::parse(painted_result(scene, depth_sort(prepared).order)));
    CHECK(result(explain_depth_sort, 1) == Json::parse(painted_result(scene, depth_sort(prepared, {.classic = true}).order)));
    CHECK(result(explain_bsp, 1) == Json::parse(painted_result(scene, BspTree(scene.mesh).order(prepared))));
    CHECK(result(explain_painter, 0) == Json::parse(painted_result(scene, z_sort(prepared, DepthKey::centroid))));
    const ScenePicture picture(scene, 8);
    const auto faces = [&](const Image<TriangleId>& triangles) {
      Json rows = Json::array();
      for (int j = 0; j < triangles.height; ++j) {
        rows.push_back(Json::array());
        for (int i = 0; i < triangles.width; ++i) {
          const TriangleId t = triangles.row(j)[i];
          rows.back().push_back(t.is_valid() ? static_cast<int>(scene.mesh.face_of[t].value) : -1);
        }
      }
      return rows;
    };
    const DepthRange range = depth_range(scene.mesh, scene.view, picture.samples());
    CHECK(result(explain_z_buffer, 5)["faces"] ==
          faces(depth_buffer(scene.mesh, scene.view, picture.samples(), range, {.format = DepthFormat::fixed16}).triangles));
    const auto kept = [&](const Culled& culled) {
      Json list = Json::array();
      for (const TriangleId t : culled.kept) list.push_back(scene.mesh.face_of[t].value);
      return list;
    };
    for (const std::size_t run : {2, 3, 4})
      CHECK(result(explain_culling, run)["kept"] == kept(facing_culled(scene.mesh, scene.view)));
    CHECK(result(explain_culling, 5)["kept"] == kept(occlusion_culled(prepared)));
    Json fragments = Json::array();
    for (const Fragment& f : visible_fragments(prepared).fragments)
      fragments.push_back(scene.mesh.face_of[first_triangle(f.facet)].value);
    CHECK(result(explain_fragments, 0)["painted"] == fragments);
    CHECK(result(explain_scanline, 0)["faces"] == faces(scanline(scene.mesh, scene.view, picture.samples()).triangles));
    const auto faces_of_pixels = [&](const auto& image) {
      Image<TriangleId> triangles(image.width, image.height);
      std::transform(image.pixels.begin(), image.pixels.end(), triangles.pixels.begin(),
                     [](const auto& p) { return p.triangle; });
      return faces(triangles);
    };
    CHECK(result(explain_row_z_buffer, 0)["faces"] ==
          faces_of_pixels(row_z_buffer<double>(scene.mesh, scene.view, picture.samples()).image));
    CHECK(result(explain_tiled_z_buffer, 0)["faces"] ==
          faces_of_pixels(tiled_z_buffer<float>(scene.mesh, scene.view, picture.samples()).image));
    const Json cast_faces = faces(cast(prepared, picture.samples()).triangles);
    CHECK(result(explain_ray_casting, 0)["faces"] == cast_faces);
    CHECK(result(explain_ray_casting, 1)["faces"] == cast_faces);
    const std::vector<Colour> colours = colours_of(picture.traced(false));
    const auto colours_of_pixels = [](const Image<Colour>& image) { return Json::parse(colours_json(image)); };
    CHECK(result(explain_a_buffer, 1)["colours"] ==
          colours_of_pixels(a_buffer(scene.mesh, scene.view, picture.samples(), colours, 0.5).picture));
    CHECK(result(explain_alpha_buffer, 0)["colours"] ==
          colours_of_pixels(alpha_buffer(scene.mesh, scene.view, picture.samples(), colours, 0.5).picture));
  }
}

TEST_CASE("a watched drawing has the lines that it has unwatched", "[study][explain][property]") {
  const auto check = [](const ExplainedScene& scene, Trace (*explain)(const ExplainedScene&, int)) {
    LineOptions options;
    options.classes[static_cast<std::size_t>(EdgeClass::intersection)] = false;
    const VisibleLines lines = visible_lines(scene.mesh, scene.view, options);
    const Json told = Json::parse(explain(scene, 0).runs[0].result);
    std::size_t count = 0;
    for (const Line& line : lines.lines) {
      Json visible = Json::array();
      const SupportingLine support = supporting_line_of(scene.mesh, lines, line);
      const auto t = [&](std::uint32_t k) {
        return exact_parameter(scene.mesh, scene.view, support, lines.cuts_of(line)[k]).to_double();
      };
      for (std::uint32_t k = 0; k < line.intervals(); ++k)
        if (!line.hidden(k)) visible.push_back({t(k), t(k + 1)});
      CHECK(told["lines"][count]["edge"] == line.edge.value);
      CHECK(told["lines"][count]["visible"] == visible);
      ++count;
    }
    CHECK(told["lines"].size() == count);
  };
  for (const ExplainedScene& scene : some_scenes()) {
    INFO(scene.title);
    check(scene, explain_roberts);
    check(scene, explain_appel);
  }
}

TEST_CASE("a scene that cannot be followed is refused with the reason", "[study][explain]") {
  scenes::TestScene many;
  for (int k = 0; k < 201; ++k) many.add_face(std::vector<Point3>{{k * 2.0, 0, 0}, {k * 2.0 + 1, 0, 0}, {k * 2.0, 1, 0}});
  many.view = scenes::from_direction({0, 0, 1});
  CHECK_THROWS_WITH(check_explainable(explained(many)), Catch::Contains("found 201 faces, expected at most 200"));
  scenes::TestScene around;
  around.add_face(std::vector<Point3>{{-1, 0, -5}, {1, 0, -5}, {0, 1, 5}});
  around.view = scenes::from_eye({0, 0, 0}, {0, 0, -1});
  CHECK_THROWS_WITH(check_explainable(explained(around)), Catch::Contains("before the near plane"));
  scenes::TestScene nothing;
  nothing.view = scenes::from_direction({0, 0, 1});
  CHECK_THROWS_WITH(check_explainable(explained(nothing)), Catch::Contains("no face"));
}

}  // namespace
}  // namespace hsr::internal
