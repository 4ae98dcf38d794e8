#include "hsr/io/write/json.h"

#include <tbb/global_control.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "hsr/coordinates/coordinates.h"
#include "hsr/io/write/json_text.h"
#include "hsr/io/write/mesh_json.h"
#include "hsr/lines/visible_lines.h"

using namespace hsr;
using namespace hsr::internal;

namespace {

/// A triangle above a wire, seen from above; its sides cross the wire at 1/3 and 5/9.
struct Example {
  std::vector<Point3> points = {{0, 0, 0}, {3, 0, 0}, {1, -1, 1}, {2, -1, 1}, {1, 2, 1}};
  Polygons polygons;
  Mesh mesh;
  View view = parallel_view({0, 0, 1}, {0, 1, 0});
  VisibleLines lines;

  Example() {
    polygons.corners = {2, 3, 4};
    polygons.first = {0, 3};
    polygons.segments = {{0, 1}};
    mesh = make_mesh(points, polygons);
    LineOptions options;
    options.method = LineMethod::roberts;
    options.why = true;
    lines = visible_lines(mesh, view, options);
  }
};

}  // namespace

TEST_CASE("Lines are written with their class, faces and intervals", "[write][json][R4][J2]") {
  const Example e;
  CHECK(
      lines_json(e.mesh, e.view, e.lines) ==
      R"({"format": "hsr-lines/1", "view": {"eye": [0, 0, 1, 0], "target": [0, 0, 0], "up": [0, 1, 0], )"
      R"("frame": {"origin": [0, 0, 0], "right": [1, 0, 0], "up": [0, 1, 0]}, "near": null}, "lines": [)"
      "\n"
      R"({"edge": [0, 1], "class": "wire", "faces": [], "visible": [[0, 0.3333333333333333], [0.5555555555555556, 1]], )"
      R"("hidden": [[0.3333333333333333, 0.5555555555555556]], )"
      R"("visible_points": [[[0, 0, 0], [1, 0, 0]], [[1.6666666666666667, 0, 0], [3, 0, 0]]], )"
      R"("visible_image": [[[0, 0], [1, 0]], [[1.6666666666666667, 0], [3, 0]]], )"
      R"("hidden_points": [[[1, 0, 0], [1.6666666666666667, 0, 0]]], "hidden_image": [[[1, 0], [1.6666666666666667, 0]]]},)"
      "\n"
      R"({"edge": [2, 3], "class": "boundary", "faces": [0], "visible": [[0, 1]], "hidden": [], )"
      R"("visible_points": [[[1, -1, 1], [2, -1, 1]]], "visible_image": [[[1, -1], [2, -1]]], "hidden_points": [], "hidden_image": []},)"
      "\n"
      R"({"edge": [2, 4], "class": "boundary", "faces": [0], "visible": [[0, 1]], "hidden": [], )"
      R"("visible_points": [[[1, -1, 1], [1, 2, 1]]], "visible_image": [[[1, -1], [1, 2]]], "hidden_points": [], "hidden_image": []},)"
      "\n"
      R"({"edge": [3, 4], "class": "boundary", "faces": [0], "visible": [[0, 1]], "hidden": [], )"
      R"("visible_points": [[[2, -1, 1], [1, 2, 1]]], "visible_image": [[[2, -1], [1, 2]]], "hidden_points": [], "hidden_image": []})"
      "\n]}\n");
}

TEST_CASE("Exact numbers are strings", "[write][json][J1]") {
  const Example e;
  const std::string text = lines_json(e.mesh, e.view, e.lines, {.numbers = Numbers::exact, .why = true});
  CHECK(text.find(R"("eye": ["0", "0", "1", "0"], "target": ["0", "0", "0"])") != std::string::npos);
  CHECK(text.find(R"("visible": [["0", "1/3"], ["5/9", "1"]], "hidden": [["1/3", "5/9"]], )") != std::string::npos);
  CHECK(text.find(R"("hidden_points": [[["1", "0", "0"], ["5/3", "0", "0"]]], "hidden_image": [[["1", "0"], ["5/3", "0"]]], )"
                  R"("by": [[0, "1/3", "5/9"]]})") != std::string::npos);
  CHECK(text.find(R"("visible": [["0", "1"]], "hidden": [], "visible_points")") != std::string::npos);
  CHECK(nlohmann::json::accept(text));
}

TEST_CASE("The ends of intervals are where segments() has them", "[write][json][J6]") {
  Example e;
  e.view = perspective_view({1.3, 0.2, 9}, {1, 0, 0.1}, {0, 1, 0});
  const SceneView scene(e.mesh, e.view);
  e.lines = visible_lines(scene);
  const auto json = nlohmann::json::parse(lines_json(e.mesh, e.view, e.lines));
  std::vector<std::array<std::size_t, 2>> next(e.lines.lines.size(), {0, 0});
  std::size_t compared = 0;
  for (const Segment& s : segments(scene, e.lines)) {
    const auto& line = json["lines"][s.line];
    const std::string visibility = s.is_hidden ? "hidden" : "visible";
    const std::size_t k = next[s.line][s.is_hidden ? 1 : 0]++;
    const auto& points = line[visibility + "_points"][k];
    const auto& image = line[visibility + "_image"][k];
    for (const auto& [end, p] : {std::pair{std::size_t{0}, s.from}, std::pair{std::size_t{1}, s.to}}) {
      CHECK(points[end] == nlohmann::json({p.space.x, p.space.y, p.space.z}));
      CHECK(image[end] == nlohmann::json({p.paper.x, p.paper.y}));
      ++compared;
    }
  }
  CHECK(compared >= 12);
}

TEST_CASE("A perspective view has its near plane", "[write][json][V7][J5]") {
  const View view = perspective_view({0, -10, 0}, {0, 0, 0}, {0, 0, 1}, 2.5);
  const auto json = nlohmann::json::parse(view_json(view));
  CHECK(json["eye"] == nlohmann::json({0, -10, 0, 1}));
  CHECK(json["near"] == 0.25);
  CHECK(nlohmann::json::parse(view_json(view, Numbers::exact))["near"] == "1/4");
}

TEST_CASE("Lines that are not seen at all are written all the same", "[write][json][H9][J2]") {
  Example e;
  e.view = parallel_view({1, 0, 0}, {0, 0, 1});
  e.lines = visible_lines(e.mesh, e.view, {.method = LineMethod::roberts});
  const auto json = nlohmann::json::parse(lines_json(e.mesh, e.view, e.lines));
  REQUIRE(json["lines"].size() == 4);
  CHECK(json["lines"][0]["edge"] == nlohmann::json({0, 1}));
  CHECK(json["lines"][0]["visible"].empty());
  CHECK(json["lines"][0]["hidden"].empty());
}

TEST_CASE("Numbers are the shortest that read back, and never minus zero", "[write][json]") {
  const auto text = [](double x) {
    std::string out;
    append_number(out, x, Numbers::rounded);
    return out;
  };
  CHECK(text(0) == "0");
  CHECK(text(-0.0) == "0");
  CHECK(text(1) == "1");
  CHECK(text(0.1) == "0.1");
  CHECK(text(-2.5) == "-2.5");
  for (const double x : {5e-324, 1.7976931348623157e308, 1.0 / 3, 1e22, 123456789012345678.0, -1e-7})
    CHECK(nlohmann::json::parse(text(x)).get<double>() == x);
}

TEST_CASE("Strings are escaped", "[write][json]") {
  std::string out;
  append_string(out, "a\"b\\c\n\x01 \xC3\xA9");
  CHECK(out == "\"a\\\"b\\\\c\\u000a\\u0001 \xC3\xA9\"");
}

TEST_CASE("The text is the same for any number of threads", "[write][json]") {
  std::vector<Point3> points;
  Polygons polygons;
  for (std::uint32_t k = 0; k < 9000; ++k) {
    points.push_back({std::cos(0.1 * k) * k, std::sin(0.1 * k) * k, 0.3 * k});
    if (k > 0) polygons.segments.push_back({k - 1, k});
  }
  const Mesh mesh = make_mesh(points, polygons);
  const View view = parallel_view({1, 2, 3}, {0, 0, 1});
  const VisibleLines lines = visible_lines(mesh, view, {.method = LineMethod::roberts});
  const auto with_threads = [&](std::size_t n) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, n);
    return lines_json(mesh, view, lines);
  };
  const std::string one = with_threads(1);
  CHECK(one == with_threads(3));
  CHECK(nlohmann::json::parse(one)["lines"].size() == 8999);
}

TEST_CASE("The faces as used are written with the diagonals that cut them and those that were dropped",
          "[write][json][R4][J5]") {
  const std::vector<Point3> points = {{0, 0, 0},    {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                      {1, 0, -0.0}, {1, 1, 1}, {2, 0, 0}, {0.5, 0, 0}};
  Polygons polygons;
  polygons.corners = {0, 1, 2, 3, 0, 4, 5, 3, 0, 7, 1, 0, 1, 2, 3};
  polygons.first = {0, 4, 8, 11, 15};
  const auto json = nlohmann::json::parse(mesh_json(make_mesh(points, polygons)));
  CHECK(json["format"] == "hsr-mesh/1");
  REQUIRE(json["points"].size() == 8);
  CHECK(json["points"][4] == nlohmann::json({1, 0, 0}));
  REQUIRE(json["faces"].size() == 3);
  CHECK(json["faces"][0]["face"] == 0);
  CHECK(json["faces"][0]["triangles"].size() == 2);
  CHECK(json["faces"][0]["diagonals"].empty());
  CHECK(json["faces"][1]["triangles"].size() == 2);
  CHECK(json["faces"][1]["diagonals"] == nlohmann::json({{0, 5}}));
  CHECK(json["faces"][2]["face"] == 3);
  CHECK(json["dropped"] == nlohmann::json::parse(R"([{"face": 2, "why": "no area"}])"));
}
