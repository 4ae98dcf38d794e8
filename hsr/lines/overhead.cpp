#include "hsr/lines/overhead.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

#include "geometry/error.h"
#include "hsr/lines/lines_in_cells.h"
#include "hsr/scene/view_parts.h"

namespace hsr {

using namespace internal;

namespace {

/// The view the other way, whose section leaves what the other takes away.
View other_way(View view) {
  const auto opposite = [](const Point3& p) { return Point3{-p.x + 0.0, -p.y + 0.0, -p.z + 0.0}; };
  view.viewpoint.at = opposite(view.viewpoint.at);
  view.section->normal = opposite(view.section->normal);
  return view;
}

/// What is seen of the part that one plane takes away.
VisibleLines taken_away(const SceneView& scene, const View& view, const LineOptions& options) {
  SceneOptions without_hidden = scene.options();
  without_hidden.hidden_lines = false;
  const SceneView below(Scene::of(scene.mesh(), scene.labels()), other_way(view), without_hidden);
  LineOptions wanted = options;
  wanted.why = wanted.diagonals = false;
  wanted.frame = {};
  wanted.classes = {};
  for (const EdgeClass c : {EdgeClass::outline, EdgeClass::sharp, EdgeClass::boundary, EdgeClass::intersection})
    wanted.classes[static_cast<std::size_t>(c)] = true;
  VisibleLines lines = visible_lines(below, wanted);
  const ProjectedMesh& projected = below.parts().projected();
  std::erase_if(lines.lines, [&](const Line& line) {
    if (line.is_intersection()) return false;
    const Edge& e = scene.mesh().edges[line.edge];
    return projected.beyond_near(e.a) == Sign::zero && projected.beyond_near(e.b) == Sign::zero;
  });
  return lines;
}

/// What lies in a plane that is seen edge-on is left, too.
void leave_out_in(const SceneView& scene, std::uint8_t plane, VisibleLines& lines) {
  const ProjectedMesh& projected = scene.parts().projected();
  const Plane edge_on = projected.cutting_plane(plane);
  Predicates exact = projected.predicates();
  std::erase_if(lines.lines, [&](const Line& line) {
    if (line.is_intersection()) return false;
    const Edge& e = scene.mesh().edges[line.edge];
    return projected.side(edge_on, e.a, exact) == Sign::zero && projected.side(edge_on, e.b, exact) == Sign::zero;
  });
}

VisibleLines taken_away(const SceneView& scene, const LineOptions& options) {
  const View& view = scene.view();
  const char* const expected = "overhead: found no section that faces the viewer, expected one that takes something away";
  if (!view.has_section()) throw InputError(expected);
  if (view.is_perspective())
    throw InputError(
        "overhead: found a perspective, expected a parallel view: only there is a line in the same place from both sides");
  if (!view.has_cells()) return taken_away(scene, view, options);
  std::vector<LinesOfCell> cells;
  for (const ViewParts::Cell& cell : scene.parts().cells()) {
    if (!cell.cell.view.section) continue;
    cells.push_back({taken_away(scene, cell.cell.view, options), cell.cell.plane, sides_of(cell.cell)});
    for (const CellSide& side : cell.cell.sides)
      if (side.u == side.v) leave_out_in(scene, side.u, cells.back().lines);
  }
  if (cells.empty()) throw InputError(expected);
  return united_lines(scene, cells, options);
}

/// In the order of visible lines.
void sort(VisibleLines& all) {
  std::vector<std::uint32_t> order(all.intersections.size()), place(order.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    const Intersection &x = all.intersections[i], &y = all.intersections[j];
    return std::pair(x.s, x.t) < std::pair(y.s, y.t);
  });
  std::vector<Intersection> sorted;
  for (const std::uint32_t i : order) {
    place[i] = static_cast<std::uint32_t>(sorted.size());
    sorted.push_back(all.intersections[i]);
  }
  all.intersections = std::move(sorted);
  for (Line& line : all.lines)
    if (line.is_intersection()) line.intersection = place[line.intersection];
  const auto key = [](const Line& line) {
    return std::tuple(line.is_intersection() ? 2
                      : line.is_ghost        ? 1
                                             : 0,
                      line.is_intersection() ? line.intersection : line.edge.value);
  };
  std::stable_sort(all.lines.begin(), all.lines.end(), [&](const Line& x, const Line& y) { return key(x) < key(y); });
}

}  // namespace

VisibleLines with_overhead(const SceneView& scene, const LineOptions& options, VisibleLines all) {
  const VisibleLines more = taken_away(scene, options);
  const auto intersections = static_cast<std::uint32_t>(all.intersections.size());
  all.intersections.insert(all.intersections.end(), more.intersections.begin(), more.intersections.end());
  for (const Line& line : more.lines) {
    const auto cuts = more.cuts_of(line);
    for (std::uint32_t k = 0; k < line.intervals(); ++k) {
      if (line.hidden(k)) continue;
      Line part = line;
      part.edge_class = EdgeClass::overhead;
      part.starts_hidden = part.is_behind = false;
      if (part.is_intersection()) part.intersection += intersections;
      part.first_occluder = part.end_occluder = static_cast<std::uint32_t>(all.occluders.size());
      part.first_cut = static_cast<std::uint32_t>(all.cuts.size());
      all.cuts.push_back(cuts[k]);
      all.cuts.push_back(cuts[k + 1]);
      part.end_cut = static_cast<std::uint32_t>(all.cuts.size());
      all.lines.push_back(part);
    }
  }
  check_countable(all.cuts.size(), "interval ends");
  all.pairs += more.pairs;
  all.decisions += more.decisions;
  sort(all);
  return all;
}

}  // namespace hsr
