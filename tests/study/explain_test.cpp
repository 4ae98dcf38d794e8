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
#include "study/explain/lessons.h"
#include "study/explain/picture_result.h"
#include "tests/scenes/random_scenes.h"

namespace hsr::internal {
namespace {

using Json = nlohmann::json;

/// The state after all steps of a run, as the page makes it.
struct Ended {
  std::vector<int> painted;                                          // faces
  std::map<std::pair<int, int>, std::pair<std::string, int>> cells;  // by column and row: text, face
  std::map<int, std::vector<std::pair<double, double>>> visible;     // by edge
  std::set<int> nodes;
  std::vector<Json> drawn;                             // lines of the picture
  std::map<std::pair<int, int>, std::string> colours;  // of cells that have their own
  std::vector<int> kept;                               // faces of the list of this name
};

Ended ended(const Json& run) {
  Ended end;
  std::map<int, int> face_of;
  for (const Json& step : run["steps"]) {
    for (const Json& change : step.value("changes", Json::array())) {
      const std::string what = change["do"];
      if (what == "piece") face_of[change["piece"]] = change["face"];
      if (what == "paint") end.painted.push_back(face_of.at(change["piece"]));
      if (what == "unpaint") end.painted.clear();
      if (what == "node") end.nodes.insert(change["node"].get<int>());
      if (what == "add" && change["name"] == "kept") end.kept.push_back(change["item"][1]);
      if (what == "undraw") end.drawn.clear();
      if (what == "draw")
        for (const Json& line : change["lines"]) end.drawn.push_back(line);
      if (what == "cells")
        for (const Json& c : change["cells"]) {
          end.cells[{c[0], c[1]}] = {c[2], c[3]};
          end.colours[{c[0], c[1]}] = c.size() > 4 ? c[4] : "";
        }
      if (what == "bars" && change["name"] == "visible" && step["kind"] == "result")
        for (const Json& bar : change["bars"]) end.visible[step["edges"][0]].emplace_back(bar[0], bar[1]);
    }
  }
  return end;
}

/// What holds for every trace.
void check_form(const Json& trace) {
  CHECK(trace["format"] == "hsr-trace/1");
  std::set<std::string> lines;
  for (const Json& line : trace["pseudocode"]) CHECK(lines.insert(line[0]).second);
  for (const Json& run : trace["runs"]) {
    const Json& scene = run.contains("scene") ? run["scene"] : trace["scene"];
    for (const Json& step : run["steps"]) {
      CHECK(lines.count(step["line"]) == 1);
      CHECK(!step["says"].get<std::string>().empty());
      for (const Json& face : step.value("faces", Json::array())) CHECK(face < scene["faces"].size());
      for (const Json& edge : step.value("edges", Json::array())) CHECK(edge < scene["edges"].size());
      if (step.contains("choices")) {
        CHECK(step["right"] < step["choices"].size());
        CHECK(step["choices"].size() > 1);
      }
    }
  }
}

/// The end of each run, and its result.
void check_end(const Json& trace) {
  for (const Json& run : trace["runs"]) {
    const Ended end = ended(run);
    const Json& result = run["result"];
    if (result.contains("painted")) CHECK(Json(end.painted) == result["painted"]);
    if (result.contains("kept")) CHECK(Json(end.kept) == result["kept"]);
    if (result.contains("nodes")) CHECK(end.nodes.size() == result["nodes"]);
    if (result.contains("faces"))
      for (std::size_t j = 0; j < result["faces"].size(); ++j)
        for (std::size_t i = 0; i < result["faces"][j].size(); ++i) {
          const auto cell = end.cells.find({static_cast<int>(i), static_cast<int>(j)});
          CHECK((cell == end.cells.end() ? -1 : cell->second.second) == result["faces"][j][i]);
          if (cell != end.cells.end() && run["name"] == "float, less, from the plane")
            CHECK(std::stod(cell->second.first) == Approx(result["depths"][j][i].get<double>()).epsilon(6e-4));
        }
    if (result.contains("colours")) {
      std::size_t fragments = 0, most = 0;
      for (std::size_t j = 0; j < result["colours"].size(); ++j)
        for (std::size_t i = 0; i < result["colours"][j].size(); ++i) {
          const std::pair<int, int> at{static_cast<int>(i), static_cast<int>(j)};
          CHECK(end.colours.at(at) == result["colours"][j][i]);
          const std::size_t count = std::stoul(end.cells.at(at).first);
          fragments += count;
          most = std::max(most, count);
        }
      CHECK(fragments == result["fragments"]);
      CHECK(most == result["most_fragments"]);
    }
    if (result.contains("lines")) {
      std::map<int, std::vector<std::pair<double, double>>> visible;
      for (const Json& line : result["lines"])
        for (const Json& part : line["visible"]) visible[line["edge"]].emplace_back(part[0], part[1]);
      std::size_t count = 0;
      for (auto& [edge, parts] : visible) {
        // Told are also the parts that are of no class that is drawn.
        const auto& told = end.visible.at(edge);
        for (const auto& part : parts) CHECK(std::count(told.begin(), told.end(), part) == 1);
        count += parts.size();
      }
      CHECK(std::count_if(end.drawn.begin(), end.drawn.end(), [](const Json& line) { return line.size() == 2; }) ==
            static_cast<std::ptrdiff_t>(count));
    }
  }
}

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
    Trace trace = m.explain(example_scene(m.scene), 16);
    trace.method = m.name;
    const Json json = Json::parse(trace_json(trace));
    check_form(json);
    check_end(json);
    std::size_t questions = 0;
    for (const Json& run : json["runs"])
      for (const Json& step : run["steps"]) questions += step.contains("choices") ? 1U : 0U;
    CHECK(questions > 0);
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

TEST_CASE("the lessons have the numbers of the lectures", "[study][explain]") {
  const std::vector<Lesson> lessons = all_lessons("");
  REQUIRE(lessons.size() == 3);
  const std::string& image = lessons[0].page;
  // Each trace of the page.
  std::vector<Json> traces;
  const std::string begin = "<script class=\"trace\" type=\"application/json\">";
  for (std::size_t at = image.find(begin); at != std::string::npos; at = image.find(begin, at + 1)) {
    const std::size_t from = at + begin.size();
    traces.push_back(Json::parse(image.substr(from, image.find("</script>", from) - from)));
  }
  REQUIRE(traces.size() == 7);
  for (const Json& trace : traces) {
    check_form(trace);
    check_end(trace);
  }
  const auto texts = [](const Json& run) {
    std::vector<std::string> rows;
    for (const auto& [at, cell] : ended(run).cells) {
      rows.resize(std::max<std::size_t>(rows.size(), static_cast<std::size_t>(at.second) + 1));
      rows[static_cast<std::size_t>(at.second)] += (at.first == 0 ? "" : " ") + cell.first;
    }
    return rows;
  };
  CHECK(texts(traces[0]["runs"][0]) == std::vector<std::string>{"0.25"});
  CHECK(texts(traces[1]["runs"][0]) == std::vector<std::string>{"-1 -0.5 -0.125 -0.25 -0.375 -0.5 -0.625 -0.75"});
  CHECK(texts(traces[2]["runs"][0])[7] == "255 64 64 64 64 64 64 127");
  CHECK(texts(traces[3]["runs"][0]) ==
        std::vector<std::string>{"64 64 64 64 64 64 64 64", "5 5 5 5 5 5 64 64", "5 5 5 5 5 64 64 64", "5 5 5 5 64 64 64 64",
                                 "5 5 5 5 64 64 64 64", "4 5 6 7 64 64 64 64", "3 4 5 6 7 64 64 64", "2 3 4 5 6 7 64 64"});
  CHECK(image.find("<td>-0.5</td><td>-0.8889</td><td>227</td>") != std::string::npos);
}

}  // namespace
}  // namespace hsr::internal
