// How a BspTree is walked for a view.
#include "hsr/painter/bsp/bsp.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/error.h"
#include "geometry/parallel.h"
#include "hsr/painter/bsp/bsp_nodes.h"
#include "hsr/painter/bsp/bsp_observer.h"
#include "hsr/painter/order_in_cells.h"
#include "hsr/painter/self_overlaps.h"
#include "hsr/painter/wires.h"
#include "hsr/scene/projected_mesh.h"
#include "hsr/scene/view_parts.h"
#include "hsr/symbols/cut_plane.h"

namespace hsr {

using namespace internal;

void BspNodes::prepare_planes() {
  bit_range = hsr::bit_range(mesh->points);
  std::vector<std::uint32_t> filtered;
  for (std::uint32_t k = 0; k < nodes.size(); ++k) {
    if (nodes[k].is_leaf() || nodes[k].plane.kind != Cut::Kind::face) continue;
    nodes[k].filter = static_cast<std::uint32_t>(filtered.size());
    filtered.push_back(k);
  }
  filters.resize(filtered.size());
  parallel_for_each(filtered.size(), [&](std::size_t i) {
    const auto& c = mesh->triangles[TriangleId(nodes[filtered[i]].plane.u)];
    const Plane plane = Plane::of_face(mesh->points[c[0]], mesh->points[c[1]], mesh->points[c[2]]);
    filters[i] = PlaneFilter(plane, Arithmetic::staged);
  });
}

PieceCorner BspNodes::corner(const BspBounds::Corner& c) const {
  PieceCorner out;
  if (c.is_vertex()) {
    out.vertex = VertexId(c.a);
  } else {
    out.a = cut_of(c.a, bounds.sides, bounds.acrosses);
    out.b = cut_of(c.b, bounds.sides, bounds.acrosses);
  }
  out.side = cut_of(c.side, bounds.sides, bounds.acrosses);
  out.original = BspBounds::is_side(c.side) && bounds.sides[BspBounds::place(c.side)].original;
  return out;
}

namespace {

/// On which side of a plane of the tree the viewpoint lies.
class EyeSide {
 public:
  EyeSide(const Mesh& mesh, const View& view, const BitRange& points, std::span<const PlaneFilter> filters)
      : mesh_(mesh), eye_(view.viewpoint), filters_(filters), exact_(predicates(points, view.viewpoint)) {}

  /// @param filter of the plane, if it is that of a facet
  Sign operator()(const Cut& plane, std::uint32_t filter) {
    const Point3& e = eye_.at;
    if (plane.kind == Cut::Kind::across) {
      const double at = eye_.is_direction ? 0 : mesh_.points[VertexId(plane.u)][plane.axis];
      return e[plane.axis] > at ? Sign::positive : e[plane.axis] < at ? Sign::negative : Sign::zero;
    }
    const PlaneFilter& f = filters_[filter];
    const ErrorBounded x = eye_.is_direction ? f.change(e) : f(e);
    if (x.is_certain() && exact_.filter_is_proven()) return sign_of(x.value);
    // O(a, b, c) is positive where the eye lies on the positive side of the plane of a, b and c.
    const auto& c = mesh_.triangles[TriangleId(plane.u)];
    return exact_.side(Plane::of_sight(eye_, mesh_.points[c[0]], mesh_.points[c[1]]), mesh_.points[c[2]]);
  }

 private:
  static Predicates predicates(BitRange points, const Viewpoint& eye) {
    BitRange direction;
    (eye.is_direction ? direction : points).add(eye.at);
    return Predicates(points, direction);
  }

  const Mesh& mesh_;
  const Viewpoint& eye_;
  std::span<const PlaneFilter> filters_;
  Predicates exact_;
};

/// The pieces first ... end - 1 of a node are coplanar, their facets ascend: the one that comes k-th from the top, counted from
/// `first`.
std::uint32_t coplanar(std::uint32_t first, std::uint32_t end, std::uint32_t k, TieRule ties) {
  return first + static_cast<std::uint32_t>(ties.from_top(k - first, end - first));
}

/// Who walks unwatched.
struct Unwatched {
  void operator()(std::uint32_t /*node*/, bool /*is_leaf*/, bool /*viewer_is_before*/) const {}
};

/// Visits the pieces of nodes from far to near, those of one node as a range. The sides of all planes are asked first, in the
/// order of memory: on the way through the tree each would be waited for.
template <class Nodes, class Visit, class Watch = Unwatched>
void walk_far_to_near(const Nodes& nodes, EyeSide side_of, const Visit& visit, const Watch& watch = {}) {
  if (nodes.empty()) return;
  std::vector<std::uint8_t> eye_is_before(nodes.size(), 0);
  for (std::size_t k = 0; k < nodes.size(); ++k)
    if (!nodes[k].is_leaf()) eye_is_before[k] = side_of(nodes[k].plane, nodes[k].filter) == Sign::positive ? 1 : 0;
  // What is painted later: the pieces of a node on the way down, then what is in front of its plane.
  struct Step {
    std::uint32_t first_piece, end_piece, near;
  };
  std::vector<Step> waiting;
  std::uint32_t at = 0;
  while (true) {
    const auto& node = nodes[at];
    watch(at, node.is_leaf(), eye_is_before[at] != 0);
    if (node.is_leaf()) {
      visit(node.first_piece, node.end_piece);
      at = 0;
    } else {
      const bool is_before = eye_is_before[at] != 0;
      waiting.push_back({node.first_piece, node.end_piece, is_before ? node.before : node.behind});
      at = is_before ? node.behind : node.before;
    }
    while (at == 0) {
      if (waiting.empty()) return;
      const Step step = waiting.back();
      waiting.pop_back();
      visit(step.first_piece, step.end_piece);
      at = step.near;
    }
  }
}

}  // namespace

void BspTree::walk(const View& view, std::vector<std::uint32_t>& far_to_near, TieRule ties) const {
  far_to_near.clear();
  const BspNodes& tree = *nodes_;
  if (tree.nodes.empty()) return;
  far_to_near.reserve(tree.pieces.size());
  const EyeSide side_of(*tree.mesh, view, tree.bit_range, tree.filters);
  walk_far_to_near(tree.nodes, side_of, [&](std::uint32_t first, std::uint32_t end) {
    for (std::uint32_t k = end; k-- > first;) far_to_near.push_back(coplanar(first, end, k, ties));
  });
}

namespace {

/// A piece as seen: counter-clockwise, and cut by the near plane.
class PieceWriter {
 public:
  PieceWriter(const ProjectedMesh& projected, PaintersOrder& order)
      : projected_(projected), exact_(projected.predicates()), order_(order) {}

  /// @param ring its corners as the face runs
  void append(FacetId facet, std::vector<PieceCorner>& ring) {
    if (projected_.facing(facet) == Sign::zero) return;
    ring_.swap(ring);
    if (projected_.facing(facet) == Sign::negative) reverse();
    if (projected_.has_near() && !clip_near(facet)) return;
    const auto first = static_cast<std::uint32_t>(order_.corners.size());
    order_.corners.insert(order_.corners.end(), ring_.begin(), ring_.end());
    check_countable(order_.corners.size(), "corners of a painting order");
    order_.pieces.push_back({facet, first, static_cast<std::uint32_t>(order_.corners.size())});
  }
  const DecisionCounts& decisions() const { return exact_.counts(); }

 private:
  void reverse() {
    std::reverse(ring_.begin(), ring_.end());
    // The side that left a corner now arrives there.
    const PieceCorner first = ring_.front();
    for (std::size_t k = 0; k < ring_.size(); ++k) {
      const PieceCorner& next = k + 1 < ring_.size() ? ring_[k + 1] : first;
      ring_[k].side = next.side;
      ring_[k].original = next.original;
    }
  }

  Sign beyond(FacetId facet, const PieceCorner& c) {
    if (c.vertex.is_valid()) return projected_.beyond_near(c.vertex);
    return exact_.side(projected_.near_plane(), projected_.face_plane(facet), cut_plane(projected_, c.a),
                       cut_plane(projected_, c.b));
  }

  bool clip_near(FacetId facet) {
    signs_.clear();
    bool is_cut = false;
    for (const PieceCorner& c : ring_) {
      signs_.push_back(beyond(facet, c));
      is_cut = is_cut || signs_.back() == Sign::negative;
    }
    if (!is_cut) return true;
    const Cut near{Cut::Kind::near, 0, 0, 0};
    const std::vector<PieceCorner> all = ring_;
    ring_.clear();
    for (std::size_t k = 0; k < all.size(); ++k) {
      const Sign here = signs_[k], next = signs_[(k + 1) % all.size()];
      PieceCorner border = all[k];
      border.side = near;
      border.original = false;
      if (here == Sign::positive) {
        ring_.push_back(all[k]);
        if (next == Sign::negative) ring_.push_back({{}, all[k].side, near, near, false});
      } else if (here == Sign::zero) {
        ring_.push_back(next == Sign::positive ? all[k] : border);
      } else if (next == Sign::positive) {
        ring_.push_back({{}, all[k].side, near, all[k].side, all[k].original});
      }
    }
    return ring_.size() > 2 && std::any_of(signs_.begin(), signs_.end(), [](Sign s) { return s == Sign::positive; });
  }

  const ProjectedMesh& projected_;
  Predicates exact_;
  PaintersOrder& order_;
  std::vector<PieceCorner> ring_;
  std::vector<Sign> signs_;
};

}  // namespace

void internal::append_far_to_near(const BspNodes& tree, const ProjectedMesh& projected, const View& view, PaintersOrder& order,
                                  BspObserver* observer) {
  PieceWriter writer(projected, order);
  std::vector<PieceCorner> ring;
  const EyeSide side_of(*tree.mesh, view, tree.bit_range, tree.filters);
  const auto append = [&](std::uint32_t first, std::uint32_t end) {
    for (std::uint32_t k = end; k-- > first;) {
      const OrderedPiece& p = tree.pieces[coplanar(first, end, k, projected.ties())];
      ring.clear();
      for (std::uint32_t c = p.first_corner; c < p.end_corner; ++c) ring.push_back(tree.corner(tree.corners[c]));
      writer.append(p.facet, ring);
    }
  };
  if (observer == nullptr) {
    walk_far_to_near(tree.nodes, side_of, append);
  } else {
    const auto told = [&](std::uint32_t first, std::uint32_t end) {
      observer->visited(first, end);
      append(first, end);
    };
    walk_far_to_near(tree.nodes, side_of, told, [&](std::uint32_t node, bool is_leaf, bool viewer_is_before) {
      observer->walked(node, is_leaf, viewer_is_before);
    });
  }
  order.decisions += writer.decisions();
}

BspTree::BspTree(const Mesh& mesh, const BspOptions& options) {
  BspNodes tree = build_nodes(mesh, options);
  tree.prepare_planes();
  nodes_ = std::make_shared<const BspNodes>(std::move(tree));
}

std::size_t BspTree::nodes() const { return nodes_->nodes.size(); }
std::size_t BspTree::depth() const { return nodes_->depth; }
std::size_t BspTree::pieces() const { return nodes_->pieces.size(); }
std::uint64_t BspTree::splits() const { return nodes_->splits; }
const DecisionCounts& BspTree::decisions() const { return nodes_->decisions; }

PaintersOrder BspTree::order(const View& view) const { return order(SceneView(*nodes_->mesh, view)); }

PaintersOrder BspTree::order(const SceneView& scene) const {
  if (scene.view().has_cells()) return order_in_cells(scene, [&](const ViewParts::Cell& cell) { return order(cell.scene); });
  PaintersOrder order;
  if (!nodes_->nodes.empty()) append_far_to_near(*nodes_, scene.parts().projected(), scene.view(), order);
  cut_self_overlaps(scene, order);
  order.wires = ordered_wires(scene, order);
  return order;
}

}  // namespace hsr
