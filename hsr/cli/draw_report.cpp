#include "hsr/cli/draw_report.h"

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "geometry/rounded_sum.h"
#include "hsr/cli/output_summary.h"

namespace hsr::cli {

void describe(Report& report, const Model& model, const Mesh& mesh, const VisibleLines& lines) {
  report.set("model", {{"name", model.name},
                       {"format", model.format},
                       {"points", mesh.points.size()},
                       {"faces", mesh.faces.size()},
                       {"triangles", mesh.triangles.size()},
                       {"edges", mesh.edges.size()}});
  std::uint64_t visible = 0, hidden = 0;
  for (const Line& line : lines.lines)
    for (std::uint32_t k = 0; k < line.intervals(); ++k) ++(line.hidden(k) ? hidden : visible);
  report.set("lines", {{"edges", lines.lines.size()}, {"visible_intervals", visible}, {"hidden_intervals", hidden}});
  report.set("method", lines.plan.method);
  report.set("pairs", lines.pairs);
  for (const LeftOut& stage : lines.plan.left_out) report.leave_out(stage.stage, stage.why);
}

void describe(Report& report, const Drawing& drawing) {
  report.set("drawing", {{"polylines", drawing.polylines.size()},
                         {"visible_under_visible", drawing.visible_under_visible},
                         {"hidden_under_visible", drawing.hidden_under_visible},
                         {"hidden_under_hidden", drawing.hidden_under_hidden},
                         {"near_coincident", drawing.near_coincident},
                         {"merged", drawing.merged},
                         {"short_dropped", drawing.short_dropped},
                         {"groups_dropped", drawing.groups_dropped},
                         {"arcs", drawing.arcs.size()},
                         {"scale_mm_per_unit", drawing.scale}});
}

Report::Json areas_json(const Model& model, const Mesh& mesh, const View& view, const VisibleFragments& fragments, bool exact) {
  const std::vector<Rational> of_fragment = visible_areas(mesh, view, fragments);
  using Areas = std::vector<const Rational*>;
  std::map<std::uint32_t, Areas> of_face, of_object;
  Areas all;
  for (std::size_t k = 0; k < of_fragment.size(); ++k) {
    const std::uint32_t face = mesh.face_of[first_triangle(fragments.fragments[k].facet)].value;
    of_face[face].push_back(&of_fragment[k]);
    all.push_back(&of_fragment[k]);
    if (model.face_object.empty() || model.face_object[face] == 0xffffffffU) continue;
    of_object[model.face_object[face]].push_back(&of_fragment[k]);
  }
  const auto number = [&](const Areas& areas) -> Report::Json {
    if (!exact) return rounded_sum(areas);
    Rational sum;
    for (const Rational* x : areas) sum = sum + *x;
    return sum.to_string();
  };
  Report::Json faces = Report::Json::array(), objects = Report::Json::array();
  for (const auto& [face, areas] : of_face) faces.push_back(Report::Json::array({face, number(areas)}));
  for (const auto& [object, areas] : of_object) objects.push_back(Report::Json::array({model.objects[object], number(areas)}));
  return {{"fragments", fragments.fragments.size()},
          {"rings", fragments.rings.size()},
          {"visible_area", number(all)},
          {"visible_area_of_faces", std::move(faces)},
          {"visible_area_of_objects", std::move(objects)}};
}

std::string counted_lines(const Drawing& drawing) {
  std::uint64_t count = 0;
  for (const Polyline& p : drawing.polylines) count += p.end_point - p.first_point - (p.closed ? 0 : 1);
  for (const DrawnArc& arc : drawing.arcs) count -= arc.end_line - arc.first_line;
  const std::string lines = counted(count, "line");
  return drawing.arcs.empty() ? lines : lines + ", " + counted(drawing.arcs.size(), "arc");
}

}  // namespace hsr::cli
