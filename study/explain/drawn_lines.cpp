#include "study/explain/drawn_lines.h"

#include <string>
#include <vector>

#include "hsr/io/write/json_text.h"

namespace hsr::internal {

namespace {

std::vector<TraceLine> drawn_lines(const ScenePicture& picture, const VisibleLines& lines) {
  const ExplainedScene& scene = picture.scene();
  std::vector<TraceLine> drawn;
  for (const Line& line : lines.lines) {
    if (line.is_intersection()) continue;
    const SupportingLine support = supporting_line_of(scene.mesh, lines, line);
    const auto cuts = lines.cuts_of(line);
    const auto at = [&](std::uint32_t k) { return picture.at(exact_point(scene.mesh, scene.view, support, cuts[k])); };
    for (std::uint32_t k = 0; k < line.intervals(); ++k) drawn.push_back({at(k), at(k + 1), line.hidden(k)});
  }
  return drawn;
}

std::string lines_result(const ExplainedScene& scene, const VisibleLines& lines) {
  std::string out = "{\"lines\":[";
  for (const Line& line : lines.lines) {
    if (line.is_intersection()) continue;
    if (out.back() != '[') out += ',';
    out += "{\"edge\":" + std::to_string(line.edge.value) + ",\"visible\":[";
    const SupportingLine support = supporting_line_of(scene.mesh, lines, line);
    const auto cuts = lines.cuts_of(line);
    bool is_first = true;
    for (std::uint32_t k = 0; k < line.intervals(); ++k) {
      if (line.hidden(k)) continue;
      out += is_first ? "[" : ",[";
      is_first = false;
      append_number(out, exact_parameter(scene.mesh, scene.view, support, cuts[k]).to_double(), Numbers::rounded);
      out += ',';
      append_number(out, exact_parameter(scene.mesh, scene.view, support, cuts[k + 1]).to_double(), Numbers::rounded);
      out += ']';
    }
    out += "]}";
  }
  return out + "]}";
}

}  // namespace

void end_with_lines(TraceRun& run, const ScenePicture& picture, const VisibleLines& lines) {
  run.step("end", "end",
           "All edges of the classes that drawings have, outlines, borders and sharp ones: what is hidden is dashed.")
      .undraw()
      .draw(drawn_lines(picture, lines));
  run.result = lines_result(picture.scene(), lines);
}

}  // namespace hsr::internal
