#include "hsr/lines/requested_edges.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>

#include "hsr/lines/edge_class.h"
#include "hsr/lines/parallel.h"
#include "hsr/outside_frame.h"

namespace hsr {

RequestedEdges::RequestedEdges(const Sight& sight, const LineOptions& options, const OutsideFrame* outside) {
  using Range = tbb::blocked_range<std::size_t>;
  const Mesh& mesh = sight.mesh();
  const Crease crease(options.crease);
  constexpr std::uint8_t none = 0xff;
  std::vector<std::uint8_t> edge_classes(mesh.edges.size(), none);
  std::vector<DecisionCounts> counts((mesh.edges.size() + edges_of_block - 1) / edges_of_block);
  tbb::parallel_for(Range(0, counts.size(), 1), [&](const Range& range) {
    for (std::size_t part = range.begin(); part < range.end(); ++part) {
      Predicates exact = sight.predicates();
      const std::size_t end = std::min((part + 1) * edges_of_block, mesh.edges.size());
      for (std::size_t e = part * edges_of_block; e < end; ++e) {
        if (outside != nullptr && outside->contains(mesh.edges[EdgeId(e)])) continue;
        const auto found = edge_class(sight, exact, EdgeId(e), crease);
        if (found && options.classes[static_cast<std::size_t>(*found)]) edge_classes[e] = static_cast<std::uint8_t>(*found);
      }
      counts[part] = exact.counts();
    }
  });
  for (const DecisionCounts& c : counts) decisions += c;
  edges = collected<EdgeId>(edge_classes.size(), [&](std::size_t begin, std::size_t end, std::vector<EdgeId>& part) {
    for (std::size_t e = begin; e < end; ++e)
      if (edge_classes[e] != none) part.emplace_back(e);
  });
  classes.resize(edges.size());
  for_each(edges.size(), [&](std::size_t i) { classes[i] = static_cast<EdgeClass>(edge_classes[edges[i].value]); });
  find_boxes(sight);
}

RequestedEdges::RequestedEdges(const Sight& sight, std::vector<EdgeId> ascending) : edges(std::move(ascending)) {
  classes.resize(edges.size(), EdgeClass::smooth);
  find_boxes(sight);
}

void RequestedEdges::find_boxes(const Sight& sight) {
  const Mesh& mesh = sight.mesh();
  boxes.resize(edges.size());
  for_each(edges.size(), [&](std::size_t i) { boxes[i] = sight.box(mesh.edges[edges[i]].a, mesh.edges[edges[i]].b); });
}

}  // namespace hsr
