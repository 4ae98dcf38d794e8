#include "hsr/scene/edge_mark_table.h"

#include <algorithm>
#include <string>
#include <tuple>

#include "geometry/error.h"

namespace hsr::internal {

EdgeMarkTable::EdgeMarkTable(const Mesh& mesh, const std::vector<MarkedEdge>& marks) {
  struct Row {
    Ends ends;
    MarkOfObject mark;
  };
  std::vector<Row> rows;
  rows.reserve(marks.size());
  for (std::size_t k = 0; k < marks.size(); ++k) {
    for (const std::uint32_t p : marks[k].points)
      if (p >= mesh.points.size())
        throw InputError("mark " + std::to_string(k) + ": found point " + std::to_string(p) + ", expected one of the " +
                         std::to_string(mesh.points.size()) + " of the model");
    const auto [a, b] = std::minmax(mesh.merged[VertexId(marks[k].points[0])], mesh.merged[VertexId(marks[k].points[1])]);
    rows.push_back({{a, b}, {marks[k].mark, marks[k].object}});
  }
  std::sort(rows.begin(), rows.end(), [](const Row& x, const Row& y) {
    return std::tuple(x.ends, x.mark.object, y.mark.mark) < std::tuple(y.ends, y.mark.object, x.mark.mark);
  });
  const auto same = [](const Row& x, const Row& y) { return x.ends == y.ends && x.mark.object == y.mark.object; };
  rows.erase(std::unique(rows.begin(), rows.end(), same), rows.end());
  for (const Row& row : rows) {
    ends_.push_back(row.ends);
    marks_.push_back(row.mark);
  }
}

std::span<const MarkOfObject> EdgeMarkTable::of(VertexId a, VertexId b) const {
  if (ends_.empty()) return {};
  if (b < a) std::swap(a, b);
  const auto [first, end] = std::equal_range(ends_.begin(), ends_.end(), Ends{a, b});
  return {marks_.data() + (first - ends_.begin()), static_cast<std::size_t>(end - first)};
}

}  // namespace hsr::internal
