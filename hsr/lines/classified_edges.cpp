#include "hsr/lines/classified_edges.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>

#include "geometry/parallel.h"
#include "hsr/lines/edge_class.h"
#include "hsr/lines/edge_parts.h"
#include "hsr/view/frustum.h"

namespace hsr::internal {

ClassifiedEdges::ClassifiedEdges(const ProjectedMesh& projected, const LineOptions& options, const ViewFrustum* outside,
                                 const Occluders* occluders, const std::vector<std::uint8_t>& has_contact) {
  using Range = tbb::blocked_range<std::size_t>;
  const Mesh& mesh = projected.mesh();
  const Crease crease(options.crease);
  constexpr std::uint8_t none = 0xff;
  struct PartOfEdge {
    EdgeId edge;
    EdgePart part;
  };
  std::vector<std::uint8_t> edge_classes(mesh.edges.size(), none);
  std::vector<DecisionCounts> counts((mesh.edges.size() + edges_of_block - 1) / edges_of_block);
  std::vector<std::vector<PartOfEdge>> parts(counts.size());  // of edges that have several
  const auto is_requested = [&](const std::optional<EdgeClass>& c) {
    return c && options.classes[static_cast<std::size_t>(*c)];
  };
  const auto with_diagonals = [&](EdgeId e, std::optional<EdgeClass> c) {
    return !c && options.diagonals && mesh.edges[e].diagonal ? EdgeClass::smooth : c;
  };
  tbb::parallel_for(Range(0, counts.size(), 1), [&](const Range& range) {
    for (std::size_t block = range.begin(); block < range.end(); ++block) {
      TriangleOcclusion occlusion(projected);
      const std::size_t end = std::min((block + 1) * edges_of_block, mesh.edges.size());
      for (std::size_t e = block * edges_of_block; e < end; ++e) {
        const EdgeId id(e);
        if (mesh.edges[id].is_only_of_ghosts() || (outside != nullptr && outside->contains(mesh.edges[id]))) continue;
        std::optional<EdgeClass> found;
        if (has_contact.empty() || has_contact[e] == 0) {
          found = with_diagonals(id, edge_class(projected, occlusion.exact(), id, crease));
        } else {
          auto of_edge = edge_parts(projected, occlusion, id, crease, *occluders);
          for (EdgePart& p : of_edge) p.edge_class = with_diagonals(id, p.edge_class);
          if (of_edge.size() > 1) {
            for (const EdgePart& p : of_edge)
              if (is_requested(p.edge_class)) parts[block].push_back({id, p});
            continue;
          }
          found = of_edge.front().edge_class;
        }
        if (is_requested(found)) edge_classes[e] = static_cast<std::uint8_t>(*found);
      }
      counts[block] = occlusion.exact().counts();
    }
  });
  for (const DecisionCounts& c : counts) decisions += c;
  edges = parallel_collect<EdgeId>(edge_classes.size(), [&](std::size_t begin, std::size_t end, std::vector<EdgeId>& part) {
    for (std::size_t e = begin; e < end; ++e)
      if (edge_classes[e] != none) part.emplace_back(e);
  });
  classes.resize(edges.size());
  parallel_for_each(edges.size(), [&](std::size_t i) { classes[i] = static_cast<EdgeClass>(edge_classes[edges[i].value]); });
  std::vector<PartOfEdge> several;
  for (const auto& block : parts) several.insert(several.end(), block.begin(), block.end());
  if (!several.empty()) {
    std::vector<EdgeId> all_edges;
    std::vector<EdgeClass> all_classes;
    std::size_t next = 0;
    const auto add_parts_before = [&](EdgeId e) {
      for (; next < several.size() && several[next].edge < e; ++next) {
        const auto& [edge, part] = several[next];
        parts_.push_back({all_edges.size(), part.from, part.to});
        all_edges.push_back(edge);
        all_classes.push_back(*part.edge_class);
      }
    };
    for (std::size_t i = 0; i < edges.size(); ++i) {
      add_parts_before(edges[i]);
      all_edges.push_back(edges[i]);
      all_classes.push_back(classes[i]);
    }
    add_parts_before(EdgeId());
    edges = std::move(all_edges);
    classes = std::move(all_classes);
  }
  find_boxes(projected);
}

const ClassifiedEdges::Part* ClassifiedEdges::part(std::size_t i) const {
  const auto at = std::lower_bound(parts_.begin(), parts_.end(), i, [](const Part& p, std::size_t k) { return p.index < k; });
  return at != parts_.end() && at->index == i ? &*at : nullptr;
}

bool ClassifiedEdges::is_part(std::size_t i) const { return part(i) != nullptr; }

RequestedPart ClassifiedEdges::operator[](std::size_t i) const {
  RequestedPart r{edges[i], classes[i]};
  if (const Part* p = part(i)) {
    r.from = p->from;
    r.to = p->to;
  }
  return r;
}

ClassifiedEdges::ClassifiedEdges(const ProjectedMesh& projected, std::vector<EdgeId> ascending) : edges(std::move(ascending)) {
  classes.resize(edges.size(), EdgeClass::smooth);
  find_boxes(projected);
}

void ClassifiedEdges::add_ghosts(const ProjectedMesh& projected, const View& view, const LineOptions& options,
                                 const ViewFrustum* outside) {
  const Mesh& mesh = projected.mesh();
  if (mesh.ghosts == nullptr) return;
  first_ghost_ = edges.size();
  LineOptions without_diagonals = options;
  without_diagonals.diagonals = false;
  const ProjectedMesh among_ghosts(*mesh.ghosts, view, projected.arithmetic());
  const ClassifiedEdges ghosts(among_ghosts, without_diagonals, outside, nullptr, {});
  for (std::size_t i = 0; i < ghosts.edges.size(); ++i) {
    const Edge& e = mesh.ghosts->edges[ghosts.edges[i]];
    edges.push_back(mesh.find_edge(e.a, e.b));
    classes.push_back(ghosts.classes[i]);
  }
  decisions += ghosts.decisions;
  find_boxes(projected);
}

void ClassifiedEdges::find_boxes(const ProjectedMesh& projected) {
  const Mesh& mesh = projected.mesh();
  boxes.resize(edges.size());
  parallel_for_each(edges.size(),
                    [&](std::size_t i) { boxes[i] = projected.box(mesh.edges[edges[i]].a, mesh.edges[edges[i]].b); });
}

}  // namespace hsr::internal
