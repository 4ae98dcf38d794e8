#include "hsr/painter/sort/tree_order.h"

#include "geometry/error.h"
#include "hsr/painter/bsp/bsp_nodes.h"

namespace hsr::internal {

std::vector<FacetId> whole_facets(const FacePieces& all, const std::vector<std::uint32_t>& pieces) {
  std::vector<FacetId> facets;
  const std::vector<FacetId>& of = all.facet;  // ascending
  for (std::size_t k = 0; k < pieces.size();) {
    const std::size_t first = pieces[k];
    if (first >= of.size() || (first > 0 && of[first - 1] == of[first])) return {};
    facets.push_back(of[first]);
    for (std::size_t piece = first; piece < of.size() && of[piece] == of[first]; ++piece, ++k)
      if (k == pieces.size() || pieces[k] != piece) return {};
  }
  return facets;
}

TreeOrder ordered_by_tree(const ProjectedMesh& projected, const View& view, const std::vector<FacetId>& facets,
                          std::size_t pieces_before, std::size_t most_pieces, const std::stop_token& stop) {
  const SomeFacets some{facets, pieces_before, "depth sort", stop};
  BspNodes tree = build_nodes(projected.mesh(), {.most_pieces = most_pieces}, &some);
  tree.prepare_planes();
  TreeOrder result;
  append_far_to_near(tree, projected, view, result.order);
  result.order.decisions += tree.decisions;
  result.splits = tree.splits;
  return result;
}

void append(const PaintersOrder& part, PaintersOrder& all) {
  const auto shift = static_cast<std::uint32_t>(all.corners.size());
  check_countable(all.corners.size() + part.corners.size(), "corners of a painting order");
  for (const OrderedPiece& p : part.pieces) all.pieces.push_back({p.facet, p.first_corner + shift, p.end_corner + shift});
  all.corners.insert(all.corners.end(), part.corners.begin(), part.corners.end());
}

}  // namespace hsr::internal
