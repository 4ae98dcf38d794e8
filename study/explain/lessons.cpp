#include "study/explain/lessons.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "hsr/io/write/json_text.h"
#include "hsr/raster/depth_format.h"
#include "study/explain/example_scenes.h"
#include "study/explain/explain_pages.h"
#include "study/explain/explained_methods.h"
#include "study/explain/z_buffer_run.h"
#include "study/html_page.h"
#include "study/page_texts.h"

namespace hsr::internal {

namespace {

using Traces = std::vector<std::pair<std::string, std::string>>;

/// A face of a lecture: corners in columns and rows of samples, and how deep it is there.
struct LectureFace {
  std::vector<std::array<double, 2>> corners;
  std::function<double(double column, double row)> depth;
};

LectureFace flat(std::vector<std::array<double, 2>> corners, double depth) {
  return {std::move(corners), [depth](double, double) { return depth; }};
}

/// A grid of samples that looks down on faces: sample (i, j) is at x = i, y = -j, and depth grows with -z.
struct Lecture {
  ExplainedScene scene;
  SampleGrid samples;
};

Lecture lecture(const std::string& title, int width, int height, const std::vector<LectureFace>& faces) {
  Lecture made;
  made.scene.title = title;
  Model& model = made.scene.model;
  for (const LectureFace& face : faces) {
    for (const auto& [column, row] : face.corners) {
      model.polygons.corners.push_back(static_cast<std::uint32_t>(model.points.size()));
      model.points.push_back({column, -row, -face.depth(column, row)});
    }
    model.polygons.first.push_back(static_cast<std::uint32_t>(model.polygons.corners.size()));
  }
  made.scene.mesh = make_mesh(model.points, model.polygons);
  made.scene.view = parallel_view({0, 0, 1}, {0, 1, 0});
  made.samples = {{0, 0, 0}, {1, 0, 0}, {0, -1, 0}, width, height};
  return made;
}

/// The trace of a depth buffer with its near plane at depth 0 and its far one at `far`.
std::string buffer_trace(const Lecture& l, double far, const ShownDepth& shown,
                         const std::vector<std::pair<std::string, DepthBufferOptions>>& runs) {
  const ScenePicture picture(l.scene, l.samples);
  Trace trace;
  trace.method = "z-buffer";
  trace.title = "z-buffer";
  trace.view = l.scene.title;
  trace.scene = picture.traced(false);
  trace.pseudocode = page_text("z-buffer.txt");
  for (const auto& [name, options] : runs) add_z_buffer_run(trace, name, picture, {0, -far, false}, options, shown);
  return trace_json(trace);
}

/// @param runs the names of those that are shown; of none, all
std::string method_trace(Trace (*explain)(const ExplainedScene&, int), const std::string& method, const std::string& scene_name,
                         const std::vector<std::string>& runs) {
  const ExplainedScene scene = example_scene(scene_name);
  Trace trace = explain(scene, 12);
  trace.method = trace.title = method;
  trace.view = scene.title;
  if (!runs.empty())
    std::erase_if(trace.runs, [&](const TraceRun& run) { return std::find(runs.begin(), runs.end(), run.name) == runs.end(); });
  return trace_json(trace);
}

Traces image_space_traces() {
  const DepthBufferOptions exact{.format = DepthFormat::float64}, bits{.format = DepthFormat::fixed8};
  Traces traces;
  traces.emplace_back("sample", buffer_trace(lecture("one sample, three faces at depths 0.5, 0.75 and 0.25", 1, 1,
                                                     {flat({{-0.4, -0.4}, {0.4, -0.4}, {0.1, 0.4}}, 0.5),
                                                      flat({{-0.3, -0.4}, {0.4, -0.1}, {-0.2, 0.4}}, 0.75),
                                                      flat({{-0.4, 0.3}, {0.1, -0.4}, {0.3, 0.3}}, 0.25)}),
                                             1, {}, {{"less", exact}}));
  traces.emplace_back(
      "row", buffer_trace(
                 lecture("one row of eight samples", 8, 1,
                         {flat({{0.5, -0.4}, {5.5, -0.4}, {5.5, 0.4}, {0.5, 0.4}}, 0.5),
                          {{{1.5, -0.4}, {7.5, -0.4}, {7.5, 0.4}, {1.5, 0.4}}, [](double c, double) { return (c - 1) / 8; }}}),
                 1, {false, -1}, {{"less", exact}}));
  traces.emplace_back(
      "levels",
      buffer_trace(lecture("a triangle at depth 64 and one at 127, far 255", 8, 8,
                           {flat({{0.5, 7.5}, {0.5, 0.5}, {7.5, 7.5}}, 64), flat({{7.5, 0.4}, {7.5, 7.6}, {1.5, 4.3}}, 127)}),
                   255, {true, 0},
                   {{"less", bits}, {"greater", {.format = DepthFormat::fixed8, .function = DepthFunction::greater}}}));
  traces.emplace_back(
      "fives",
      buffer_trace(lecture("a triangle of 5s, then one from 7 to 2, far 64", 8, 8,
                           {flat({{-0.4, 0.6}, {6.4, 0.6}, {-0.4, 7.4}}, 5),
                            {{{-0.4, 1.2}, {6.3, 7.4}, {-0.4, 7.4}}, [](double c, double r) { return 7 - (r - 2) + c; }}}),
                   64, {false, 64}, {{"less", exact}}));
  traces.emplace_back(
      "steps",
      buffer_trace(lecture("the plane z = 10 + 2 column + 3 row", 10, 8,
                           {{{{0.5, 0.5}, {8.5, 2.5}, {2.5, 7.5}}, [](double c, double r) { return 10 + 2 * c + 3 * r; }}}),
                   64, {false, 64},
                   {{"−A/C along a row, from the plane", exact},
                    {"−A/C along a row, 1/m down the sides",
                     {.format = DepthFormat::float64, .interpolation = DepthInterpolation::incremental}}}));
  const Lecture near_faces =
      lecture("two faces, half a step of 8 bits apart in the middle", 8, 6,
              {{{{-0.4, 0.5}, {7.4, 0.5}, {7.4, 4.5}, {-0.4, 4.5}}, [](double c, double) { return 100 + c / 4; }},
               {{{0.6, -0.4}, {6.4, -0.4}, {6.4, 5.4}, {0.6, 5.4}}, [](double, double) { return 101; }}});
  traces.emplace_back("fighting",
                      buffer_trace(near_faces, 255, {true, 0},
                                   {{"8 bits, less", bits},
                                    {"8 bits, lequal", {.format = DepthFormat::fixed8, .function = DepthFunction::lequal}},
                                    {"16 bits, less", {.format = DepthFormat::fixed16}}}));
  traces.emplace_back("scanline", method_trace(explain_scanline, "scanline", "triangles", {}));
  traces.emplace_back("culling", method_trace(explain_culling, "culling", "yard", {"back faces, in the world", "occlusion"}));
  return traces;
}

Traces object_space_traces() {
  return {{"middle", method_trace(explain_painter, "painter", "middle", {"by the middle of the corners"})},
          {"plates", method_trace(explain_depth_sort, "depth-sort", "plates", {"few cuts"})},
          {"ring", method_trace(explain_depth_sort, "depth-sort", "ring", {"few cuts"})},
          {"pierced", method_trace(explain_depth_sort, "depth-sort", "pierced", {"few cuts"})},
          {"walls", method_trace(explain_bsp, "bsp", "walls",
                                 {"build the tree", "walk it: the view asked for", "walk it: from the other side"})},
          {"roberts", method_trace(explain_roberts, "roberts", "strip", {})},
          {"appel", method_trace(explain_appel, "appel", "strip", {})},
          {"fragments", method_trace(explain_fragments, "fragments", "strip", {})}};
}

/// The lecture's numbers: c = -n/f, z' = (c - z) / (z + z c), by the library.
std::string compression_table() {
  constexpr double near = 0.1, far = 1;
  std::string rows;
  for (int k = 1; k <= 10; ++k) {
    const double z = -k / 10.0, depth = transformed_depth(z, near, far);
    rows += "<tr><td>" + trace_text(z) + "</td><td>" + trace_text(depth) + "</td><td>" + trace_text(std::round(-depth * 255)) +
            "</td></tr>\n";
  }
  return rows;
}

/// For pairs of near and far plane, and distances between: the smallest gap that a format tells apart.
std::string gaps_data() {
  constexpr std::array<double, 8> nears = {0.001, 0.01, 0.1, 0.2, 0.5, 1, 2, 5};
  constexpr std::array<double, 4> fars = {10, 100, 1000, 10000};
  constexpr std::array<DepthFormat, 5> formats = {DepthFormat::fixed16, DepthFormat::fixed24, DepthFormat::float32,
                                                  DepthFormat::reversed_float32, DepthFormat::logarithmic_float32};
  std::string out = "<script class=\"gaps\" type=\"application/json\">{\"formats\":[";
  for (const DepthFormat f : formats) {
    if (out.back() != '[') out += ',';
    append_string(out, name(f));
  }
  out += "],\"rows\":[";
  for (const double near : nears)
    for (const double far : fars) {
      if (out.back() != '[') out += ',';
      out += "{\"near\":" + rounded_text(near, 6) + ",\"far\":" + rounded_text(far, 6) + ",\"at\":[";
      // Between near and far, each ten times the last.
      std::vector<double> places;
      for (double z = near; z < far * 0.9; z *= 10) places.push_back(z);
      places.push_back(far * 0.9);
      for (std::size_t k = 0; k < places.size(); ++k) {
        out += (k == 0 ? "[" : ",[") + rounded_text(places[k], 6);
        for (const DepthFormat f : formats) out += ',' + rounded_text(smallest_gap(f, places[k], near, far), 4);
        out += ']';
      }
      out += "]}";
    }
  return out + "]}</script>";
}

std::string filled(std::string text, const std::string& what, const std::string& with) {
  const std::size_t at = text.find(what);
  if (at != std::string::npos) text.replace(at, what.size(), with);
  return text;
}

/// A page with the lecture's table and the panel of gaps.
std::string with_gaps(std::string_view page) {
  std::string text = filled(std::string(page_text(page)), "{{compression}}", compression_table());
  text = filled(text, "{{panel}}", std::string(page_text("gaps.html")));
  return filled(text, "{{gaps}}", gaps_data());
}

}  // namespace

std::vector<Lesson> all_lessons(const std::string& made) {
  Lesson image{"lesson-image-space",
               "Lesson 1: image space",
               "depths at samples, from one to a grid; what a format holds; rows and their edges; what need not be drawn",
               {}};
  image.page = lesson_page(image.title, with_gaps("lesson-image-space.html"), image_space_traces(), made);
  Lesson object{"lesson-object-space",
                "Lesson 2: object space",
                "orders of faces, cycles, cuts and trees; visible lines two ways, and visible fragments, exactly",
                {}};
  object.page = lesson_page(object.title, page_text("lesson-object-space.html"), object_space_traces(), made);
  Lesson compression{"z-compression",
                     "Near and far planes",
                     "what a depth format holds in a perspective, and the gaps that it eats: sliders to try",
                     {}};
  compression.page = lesson_page(compression.title, with_gaps("z-compression.html"), {}, made);
  return {image, object, compression};
}

}  // namespace hsr::internal
