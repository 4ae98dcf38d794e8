#pragma once

#include <cmath>
#include <vector>

#include "geometry/mesh.h"
#include "hsr/coordinates/coordinates.h"
#include "hsr/drawing/drawing.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/surfaces/regions.h"
#include "hsr/surfaces/visible_fragments.h"

namespace hsr {

/// A scene of our own with what a picture can get wrong: a plate with a hole through which the paper shows, a box that stands on it
/// and hides a part of its rim, a bar under it that is dashed but where the hole shows it, and an edge that is nearly flat.
struct DrawnScene {
  Mesh mesh = make();
  View view = parallel_view({1, -2, 3}, {0, 0, 1}, {0, 0, 0});
  SceneView scene{mesh, view};
  VisibleLines lines = visible_lines(scene, all_classes());
  VisibleFragments fragments = visible_fragments(scene);
  std::vector<Colour> colours;

  DrawnScene() {
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)  // no two alike, all light
      colours.push_back({static_cast<std::uint8_t>(120 + 37 * f % 110), static_cast<std::uint8_t>(120 + 53 * f % 110),
                         static_cast<std::uint8_t>(120 + 71 * f % 110), 255});
  }

  static constexpr double width = 76.2, height = 50.8, scale = 5;  // mm: whole points of PDF

  DrawingOptions page() const {
    DrawingOptions options;
    options.page = parse_page("76.2x50.8mm");
    options.scale = scale;
    options.hidden = HiddenLines::dashed;
    return options;
  }
  Drawing draw(bool filled = true) const {
    if (!filled) return hsr::draw(mesh, view, lines, page());
    const Regions regions = regions_of(scene, fragments, colours, Merge::none);
    return hsr::draw(mesh, view, lines, page(), &regions);
  }
  Drawing draw_in_frame_units() const {
    DrawingOptions options = page();
    options.in_frame_units = true;
    return hsr::draw(mesh, view, lines, options);
  }

 private:
  static LineOptions all_classes() {
    LineOptions options;
    options.classes.fill(true);
    return options;
  }
  static void add_box(std::vector<Point3>& points, Polygons& polygons, const Point3& low, const Point3& high) {
    const auto first = static_cast<std::uint32_t>(points.size());
    for (unsigned k = 0; k < 8; ++k)
      points.push_back({(k & 1U) != 0 ? high.x : low.x, (k & 2U) != 0 ? high.y : low.y, (k & 4U) != 0 ? high.z : low.z});
    for (const auto& face : {std::array{0U, 2U, 3U, 1U}, std::array{4U, 5U, 7U, 6U}, std::array{0U, 1U, 5U, 4U},
                             std::array{2U, 6U, 7U, 3U}, std::array{0U, 4U, 6U, 2U}, std::array{1U, 3U, 7U, 5U}}) {
      for (const std::uint32_t v : face) polygons.corners.push_back(first + v);
      polygons.first.push_back(static_cast<std::uint32_t>(polygons.corners.size()));
    }
  }
  static Mesh make() {
    // The plate, with a bridge from its rim to its hole.
    std::vector<Point3> points = {{-5, -3, 0}, {5, -3, 0},  {5, 3, 0},  {-5, 3, 0},
                                  {-3, -2, 0}, {-1, -2, 0}, {-1, 1, 0}, {-3, 1, 0}};
    Polygons polygons;
    polygons.corners = {0, 1, 2, 3, 0, 4, 7, 6, 5, 4};
    polygons.first = {0, 10};
    add_box(points, polygons, {1, -2, 0.25}, {3.5, 1.5, 2.25});
    add_box(points, polygons, {-4.5, -1, -2}, {4, 0.25, -1.5});
    // A roof of two faces, 5 degrees from flat.
    const auto first = static_cast<std::uint32_t>(points.size());
    for (const Point3& p :
         {Point3{-4, 2, 3}, Point3{0, 2, 3}, Point3{0, 3, 3.09375}, Point3{-4, 3, 3.09375}, Point3{0, 4, 3}, Point3{-4, 4, 3}})
      points.push_back(p);
    for (const std::uint32_t v : {0U, 1U, 2U, 3U, 3U, 2U, 4U, 5U}) polygons.corners.push_back(first + v);
    polygons.first.push_back(polygons.first.back() + 4);
    polygons.first.push_back(polygons.first.back() + 4);
    return make_mesh(points, polygons);
  }
};

}  // namespace hsr
