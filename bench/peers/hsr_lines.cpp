#include <algorithm>

#include "bench/peers/peer.h"
#include "hsr/lines/visible_lines.h"

namespace hsr::bench {

namespace {

Answer answer(const Mesh& mesh, const View& view, const VisibleLines& lines, const Probe& probe) {
  const auto line = std::lower_bound(lines.lines.begin(), lines.lines.end(), probe.edge,
                                     [](const Line& l, EdgeId edge) { return l.edge < edge; });
  if (line == lines.lines.end() || line->edge != probe.edge) return Answer::none;
  const auto cuts = lines.cuts_of(*line);
  for (std::uint32_t k = 0; k < line->intervals(); ++k)
    if (Rational(probe.t) < exact_parameter(mesh, view, supporting_line_of(mesh, lines, *line), cuts[k + 1]))
      return line->hidden(k) ? Answer::hidden : Answer::visible;
  return Answer::none;
}

Result hsr_lines(const Task& task, const LineOptions& options) {
  Result result;
  Mesh mesh;
  VisibleLines lines;
  result.prepare = elapsed([&] { mesh = make_mesh(task.model.points, task.model.polygons); });
  result.compute = elapsed([&] { lines = visible_lines(mesh, task.view, options); });
  for (const Line& line : lines.lines)
    for (std::uint32_t k = 0; k < line.intervals(); ++k) ++(line.hidden(k) ? result.hidden : result.visible);
  for (const Probe& probe : task.probes) result.answers.push_back(answer(mesh, task.view, lines, probe));
  return result;
}

}  // namespace

Result hsr_all_edges(const Task& task) {
  LineOptions options;
  options.classes.fill(true);
  return hsr_lines(task, options);
}

Result hsr_outlines(const Task& task) { return hsr_lines(task, {}); }

}  // namespace hsr::bench
