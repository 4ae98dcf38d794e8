#include "hsr/lines/hidden_classes.h"

#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace hsr::internal {

namespace {

/// The occluders of a line that are of its interval k. @param first where to begin among them; moved on to the next interval
std::pair<std::uint32_t, std::uint32_t> occluders_of(const Mesh& mesh, const View& view, const VisibleLines& lines,
                                                     const Line& line, std::uint32_t k, std::uint32_t& first) {
  const SupportingLine support = supporting_line_of(mesh, lines, line);
  const std::uint32_t begin = first;
  if (!line.hidden(k) || begin == line.end_occluder) return {begin, begin};
  const Rational end = exact_parameter(mesh, view, support, lines.cuts_of(line)[k + 1]);
  while (first < line.end_occluder && exact_parameter(mesh, view, support, lines.occluders[first++].to) < end) {
  }
  return {begin, first};
}

}  // namespace

VisibleLines with_hidden_classes(const Mesh& mesh, const View& view, const ClassifiedEdges& edges, const LineOptions& options,
                                 VisibleLines lines) {
  if (!edges.has_hidden_classes) return lines;
  const std::vector<Line> whole = std::exchange(lines.lines, {});
  for (std::size_t i = 0; i < whole.size(); ++i) {
    const Line& line = whole[i];
    const std::optional<EdgeClass> hidden = i < edges.edges.size() ? edges[i].hidden : std::nullopt;
    if (!hidden || line.intervals() == 0) {
      lines.lines.push_back(line);
      continue;
    }
    const Edge& edge = mesh.edges[line.edge];
    const bool is_diagonal = edge.diagonal && !edge.of_face && !options.diagonals;
    std::uint32_t occluder = line.first_occluder;
    for (std::uint32_t k = 0; k < line.intervals(); ++k) {
      Line part = line;
      if (line.hidden(k)) part.edge_class = *hidden;
      part.starts_hidden = line.hidden(k);
      part.first_cut = line.first_cut + k;
      part.end_cut = part.first_cut + 2;
      std::tie(part.first_occluder, part.end_occluder) = occluders_of(mesh, view, lines, line, k, occluder);
      const bool is_wanted = options.classes[static_cast<std::size_t>(part.edge_class)];
      if (is_wanted && !(is_diagonal && part.edge_class == EdgeClass::smooth)) lines.lines.push_back(part);
    }
  }
  return lines;
}

}  // namespace hsr::internal
