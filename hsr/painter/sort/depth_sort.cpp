#include "hsr/painter/sort/depth_sort.h"

#include <algorithm>
#include <deque>
#include <string>
#include <utility>

#include "geometry/cancel.h"
#include "geometry/error.h"
#include "geometry/ragged.h"
#include "hsr/painter/order_in_cells.h"
#include "hsr/painter/self_overlaps.h"
#include "hsr/painter/sort/components.h"
#include "hsr/painter/sort/depth_order.h"
#include "hsr/painter/sort/image_bsp.h"
#include "hsr/painter/sort/image_pieces.h"
#include "hsr/painter/sort/near_box.h"
#include "hsr/painter/sort/overlap_graph.h"
#include "hsr/painter/sort/sort_observer.h"
#include "hsr/painter/sort/tree_order.h"
#include "hsr/painter/wires.h"
#include "hsr/scene/view_parts.h"
#include "hsr/symbols/constructions.h"

namespace hsr {

using namespace internal;

namespace {

constexpr std::uint32_t none = 0xffffffffU;

/// A piece whose image overlaps that of another one. `before`: it is painted earlier, unless the two pierce each other.
struct Neighbour {
  std::uint32_t piece;
  bool before, piercing;
};

class Sorter {
 public:
  Sorter(const SceneView& scene, const DepthSortOptions& options, SortObserver* observer)
      : options_(options),
        observer_(observer),
        mesh_(scene.mesh()),
        view_(scene.view()),
        projected_(scene.parts().projected(options.stop)),
        overlaps_(projected_, options.classic) {}

  DepthSort sort();

 private:
  OverlapGraph relate_whole();
  void order_whole(const std::vector<std::uint32_t>& order);
  void begin_cutting(const OverlapGraph& found);
  void order_dense_components();
  void resolve_piercing();
  void resolve_cycles();
  void resolve(std::vector<std::uint32_t> nodes);
  PaintersCycle named(const std::vector<std::uint32_t>& cycle);
  bool cut_cycle(const std::vector<std::uint32_t>& cycle, std::vector<std::uint32_t>& nodes);
  std::optional<MapHalfPlane> parting_line(std::uint32_t piece, std::uint32_t before, std::uint32_t after);
  void order_by_planes(const std::vector<std::uint32_t>& component);
  bool split(std::uint32_t piece, const MapHalfPlane& line);
  void relate(std::uint32_t part, const Neighbour& of_whole);
  const PieceOfFacet& shaped(std::uint32_t piece);
  bool may_overlap(std::uint32_t p, std::uint32_t q);
  void count_pieces(std::size_t more);
  void count_component(std::size_t size);
  template <class F>
  void for_each_neighbour(std::uint32_t piece, const F& visit) const;
  Graph graph_of(const std::vector<std::uint32_t>& nodes) const;
  void emit();
  void tell_order(const std::vector<std::uint32_t>& nodes, const std::vector<std::uint32_t>& piece_of,
                  const std::vector<std::uint32_t>& block_at) const;

  const DepthSortOptions& options_;
  SortObserver* const observer_;  // or null
  const Mesh& mesh_;
  const View& view_;
  const ProjectedMesh& projected_;
  Overlaps overlaps_;
  FacePieces faces_;
  Clusters clusters_;
  std::vector<std::uint32_t> cluster_of_;  // by piece
  std::vector<PieceOfFacet> pieces_;       // first those of the faces, whose shapes are made where they are needed
  std::vector<NearBox> boxes_;             // of pieces that have their shape
  std::vector<std::uint8_t> is_cut_;       // its parts stand for it
  std::size_t cuts_ = 0;
  std::size_t cuts_by_planes_ = 0;  // each makes one piece more, in blocks_
  // The relations that were found first, by piece; those of parts of pieces.
  Ragged<Neighbour> neighbours_;
  std::vector<std::vector<Neighbour>> more_neighbours_;
  std::deque<std::array<std::uint32_t, 2>> piercing_;
  // Components that planes have ordered: they are painted as one.
  std::vector<std::uint32_t> block_of_;  // by piece, or none
  std::vector<PaintersOrder> blocks_;
  mutable std::vector<std::uint32_t> place_;  // of a piece among some nodes
  std::size_t most_ = 0;
  DepthSort result_;
};

/// The items sorted by cluster, in ascending order within each.
template <class F>
std::vector<std::uint32_t> by_cluster(const std::vector<std::uint32_t>& items, std::size_t clusters, const F& cluster_of) {
  if (clusters == 1) return items;
  Ragged<std::uint32_t> sorted;
  sorted.assign(clusters, [&](const auto& add) {
    for (const std::uint32_t i : items) add(cluster_of(i), i);
  });
  return sorted.values();
}

/// Most scenes have an order of whole pieces, which is written then: it takes no more than relations. Otherwise all of these,
/// and something must be cut.
OverlapGraph Sorter::relate_whole() {
  const ImageTriangles images = image_triangles(projected_, faces_);
  const ClusterBoxes boxes(projected_, faces_, clusters_, InDepth::touching);
  OverlapGraph found = overlap_graph(projected_, faces_, boxes, images, options_.classic, options_.stop, observer_);
  if (found.piercing.empty()) {
    if (const auto order = depth_order(projected_, faces_, boxes, images, found, observer_)) {
      order_whole(*order);
      return found;
    }
  }
  if (observer_ != nullptr) observer_->relates_all();
  found.add(overlap_graph(projected_, faces_, ClusterBoxes(projected_, faces_, clusters_, InDepth::apart), images,
                          options_.classic, options_.stop, observer_));
  if (!found.piercing.empty()) return found;
  const std::vector<std::uint32_t> order =
      topological_order(make_graph(faces_.size(), [&](const auto& visit) { found.for_each_pair(visit); }));
  if (order.size() == faces_.size()) order_whole(order);
  return found;
}

void Sorter::order_whole(const std::vector<std::uint32_t>& order) {
  result_.order.pieces.reserve(faces_.size());
  result_.order.corners.reserve(faces_.rings.values().size());
  const std::vector<std::uint32_t> pieces =
      by_cluster(order, clusters_.size(), [&](std::uint32_t p) { return cluster_of_[p]; });
  if (observer_ != nullptr) observer_->ordered(pieces, none);
  for (const std::uint32_t piece : pieces) append(projected_, faces_, piece, result_.order);
}

void Sorter::begin_cutting(const OverlapGraph& found) {
  most_ = options_.most_pieces > 0 ? options_.most_pieces : std::max<std::size_t>(250'000, faces_.size() * 64);
  pieces_.resize(faces_.size());
  for (std::size_t i = 0; i < pieces_.size(); ++i) pieces_[i].facet = faces_.facet[i];
  is_cut_.assign(pieces_.size(), 0);
  block_of_.assign(pieces_.size(), none);
  for (const Overlapping& pair : found.piercing)
    piercing_.push_back({std::min(pair.first, pair.second), std::max(pair.first, pair.second)});
  std::sort(piercing_.begin(), piercing_.end());
  neighbours_.assign(pieces_.size(), [&](const auto& add) {
    found.for_each_pair([&](std::uint32_t first, std::uint32_t second) {
      add(first, {second, false, false});
      add(second, {first, true, false});
    });
  });
  // In an order that does not depend on how pairs are found.
  for (std::size_t k = 0; k < neighbours_.size(); ++k)
    std::sort(neighbours_[k].begin(), neighbours_[k].end(),
              [](const Neighbour& x, const Neighbour& y) { return x.piece < y.piece; });
  const auto mark = [&](std::uint32_t piece, std::uint32_t other) {
    const std::span<Neighbour> all = neighbours_[piece];
    std::lower_bound(all.begin(), all.end(), other, [](const Neighbour& n, std::uint32_t p) { return n.piece < p; })->piercing =
        true;
  };
  for (const auto& [a, b] : piercing_) {
    mark(a, b);
    mark(b, a);
  }
}

template <class F>
void Sorter::for_each_neighbour(std::uint32_t piece, const F& visit) const {
  if (piece < neighbours_.size())
    for (const Neighbour& n : neighbours_[piece]) visit(n);
  if (piece < more_neighbours_.size())
    for (const Neighbour& n : more_neighbours_[piece]) visit(n);
}

const PieceOfFacet& Sorter::shaped(std::uint32_t p) {
  PieceOfFacet& piece = pieces_[p];
  if (piece.shape.points.empty()) piece.shape = faces_.shape(projected_, p);
  if (piece.near.empty()) {
    piece.near = overlaps_.near_corners(piece);
    if (boxes_.size() < pieces_.size()) boxes_.resize(pieces_.size());
    boxes_[p] = NearBox::of(piece.near);
  }
  return piece;
}

/// Whether the images may have more than a border in common.
bool Sorter::may_overlap(std::uint32_t p, std::uint32_t q) {
  for (const std::uint32_t piece : {p, q})
    if (piece >= boxes_.size() || !boxes_[piece].is_known()) shaped(piece);
  return boxes_[p].overlaps(boxes_[q]);
}

/// A piece in front of the whole is in front of each of its parts that it overlaps, and a piece behind the whole is behind
/// them.
void Sorter::relate(std::uint32_t part, const Neighbour& of_whole) {
  const std::uint32_t other = of_whole.piece;
  if (!may_overlap(part, other)) return;
  Neighbour now = of_whole;
  if (of_whole.piercing) {
    const Overlap how = overlaps_.relation(shaped(part), shaped(other));
    if (how == Overlap::none) return;
    now.before = how == Overlap::second_behind;
    now.piercing = how == Overlap::piercing;
  } else if (!overlaps_.have_common_part(shaped(part), shaped(other))) {
    return;
  }
  if (observer_ != nullptr)
    observer_->related(part, other,
                       now.piercing ? Overlap::piercing
                       : now.before ? Overlap::second_behind
                                    : Overlap::first_behind);
  if (now.piercing) piercing_.push_back({std::min(part, other), std::max(part, other)});
  more_neighbours_[part].push_back(now);
  more_neighbours_[other].push_back({part, !now.before, now.piercing});
}

void Sorter::count_pieces(std::size_t more) {
  if (pieces_.size() - cuts_ + cuts_by_planes_ + more > most_)
    throw InputError("depth sort: this scene takes more than " + std::to_string(most_) + " pieces, expected fewer");
}

/// Cuts a piece in two along a line. False: it does not pass through it.
bool Sorter::split(std::uint32_t piece, const MapHalfPlane& line) {
  PieceOfFacet inside = shaped(piece);
  auto outside = cut(overlaps_.map(), inside.shape, line);
  if (!outside || inside.shape.points.empty()) return false;
  throw_if_stopped(options_.stop);
  count_pieces(1);
  ++cuts_;
  const auto first = static_cast<std::uint32_t>(pieces_.size());
  pieces_.push_back(std::move(inside));
  pieces_.push_back({pieces_[piece].facet, std::move(*outside), {}});
  for (const std::uint32_t part : {first, first + 1}) pieces_[part].near.clear();  // of the whole
  if (observer_ != nullptr) observer_->cut(piece, first, pieces_[first], pieces_[first + 1], line.line);
  is_cut_[piece] = 1;
  is_cut_.resize(pieces_.size(), 0);
  block_of_.resize(pieces_.size(), none);
  more_neighbours_.resize(pieces_.size());
  cluster_of_.resize(pieces_.size(), cluster_of_[piece]);
  std::vector<Neighbour> around;
  for_each_neighbour(piece, [&](const Neighbour& n) {
    if (is_cut_[n.piece] == 0) around.push_back(n);
  });
  for (const Neighbour& n : around) {
    relate(first, n);
    relate(first + 1, n);
  }
  if (piece < more_neighbours_.size()) std::vector<Neighbour>().swap(more_neighbours_[piece]);
  return true;
}

/// Where each piece pierces many, all that are in cycles with them are ordered by planes at once: cut pair by pair, their parts
/// pierce most of the rest again.
void Sorter::order_dense_components() {
  constexpr std::size_t dense = 4;  // pairs to a piece
  if (options_.classic || piercing_.size() <= dense) return;
  // Of two that pierce each other each is in front of the other somewhere.
  const Graph graph = make_graph(pieces_.size(), [&](const auto& visit) {
    for (std::uint32_t i = 0; i < pieces_.size(); ++i)
      for (const Neighbour& n : neighbours_[i])
        if (!n.before || n.piercing) visit(i, n.piece);
  });
  for (const std::vector<std::uint32_t>& component : cyclic_components(graph)) {
    std::size_t pairs = 0;
    for (const std::uint32_t piece : component)
      for (const Neighbour& n : neighbours_[piece]) pairs += n.piercing && n.piece > piece ? 1U : 0U;
    if (pairs <= dense * component.size()) continue;
    count_component(component.size());
    order_by_planes(component);
  }
}

void Sorter::count_component(std::size_t size) {
  ++result_.counts.cyclic_components;
  result_.counts.largest_component = std::max<std::uint64_t>(result_.counts.largest_component, size);
}

void Sorter::resolve_piercing() {
  while (!piercing_.empty()) {
    const auto [a, b] = piercing_.front();
    piercing_.pop_front();
    if (is_cut_[a] != 0 || is_cut_[b] != 0) continue;  // their parts have been looked at
    if (block_of_[a] != none) continue;                // and so is b: what pierces it is in one component with it
    if (observer_ != nullptr) observer_->found_piercing(a, b);
    const MapHalfPlane line{MapLine::meet(pieces_[a].facet, pieces_[b].facet), Sign::positive};
    if (!split(a, line) && !split(b, line)) throw InvariantError("depth_sort: pieces that pierce each other are not cut");
    ++result_.counts.cuts_at_intersections;
  }
}

Graph Sorter::graph_of(const std::vector<std::uint32_t>& nodes) const {
  place_.resize(pieces_.size(), none);
  for (std::uint32_t k = 0; k < nodes.size(); ++k) place_[nodes[k]] = k;
  Graph graph;
  graph.reserve(nodes.size());
  for (const std::uint32_t node : nodes) {
    for_each_neighbour(node, [&](const Neighbour& n) {
      if (!n.before && place_[n.piece] != none) graph.push_back(place_[n.piece]);
    });
    check_countable(graph.values().size(), "overlaps");
    graph.end_row();
  }
  for (const std::uint32_t node : nodes) place_[node] = none;
  return graph;
}

void Sorter::resolve_cycles() {
  std::vector<std::uint32_t> alive;
  for (std::uint32_t i = 0; i < pieces_.size(); ++i)
    if (is_cut_[i] == 0 && block_of_[i] == none) alive.push_back(i);
  const Graph graph = graph_of(alive);
  if (topological_order(graph).size() == alive.size()) return;
  for (const std::vector<std::uint32_t>& component : cyclic_components(graph)) {
    count_component(component.size());
    std::vector<std::uint32_t> nodes;
    nodes.reserve(component.size());
    for (const std::uint32_t k : component) nodes.push_back(alive[k]);
    resolve(std::move(nodes));
  }
}

/// Cuts cycles, those that share no piece at once, in a strongly connected component and what becomes of it.
void Sorter::resolve(std::vector<std::uint32_t> nodes) {
  constexpr std::size_t largest = 4096;  // beyond that to look for cycles one by one takes too long
  std::vector<std::vector<std::uint32_t>> open = {std::move(nodes)};
  std::size_t cuts_left = 4 * open.front().size() + 16;
  while (!open.empty()) {
    const std::vector<std::uint32_t> some = std::move(open.back());
    open.pop_back();
    const Graph graph = graph_of(some);
    for (const std::vector<std::uint32_t>& component : cyclic_components(graph)) {
      std::vector<std::uint32_t> part;
      part.reserve(component.size());
      for (const std::uint32_t k : component) part.push_back(some[k]);
      std::size_t cuts = 0;
      if (component.size() <= largest)
        for (std::vector<std::uint32_t>& cycle : disjoint_cycles(graph, component)) {
          for (std::uint32_t& k : cycle) k = some[k];
          if (observer_ != nullptr) observer_->found_cycle(cycle);
          if (cuts < cuts_left && cut_cycle(cycle, part)) ++cuts;
        }
      if (cuts == 0) {
        order_by_planes(part);
        continue;
      }
      cuts_left -= cuts;
      open.push_back(std::move(part));
    }
  }
}

/// Cuts a piece of the cycle so that its predecessor and its successor overlap different parts of it.
bool Sorter::cut_cycle(const std::vector<std::uint32_t>& cycle, std::vector<std::uint32_t>& nodes) {
  for (std::size_t k = 0; k < cycle.size(); ++k) {
    const std::uint32_t piece = cycle[k], before = cycle[(k + cycle.size() - 1) % cycle.size()],
                        after = cycle[(k + 1) % cycle.size()];
    const auto line = parting_line(piece, before, after);
    if (!line || !split(piece, *line)) continue;
    result_.cycles.push_back(named(cycle));
    ++result_.counts.cuts_in_cycles;
    std::erase(nodes, piece);
    nodes.push_back(static_cast<std::uint32_t>(pieces_.size() - 2));
    nodes.push_back(static_cast<std::uint32_t>(pieces_.size() - 1));
    return true;
  }
  return false;
}

PaintersCycle Sorter::named(const std::vector<std::uint32_t>& cycle) {
  PaintersCycle found;
  for (std::size_t k = 0; k < cycle.size(); ++k) {
    const PieceOfFacet &here = shaped(cycle[k]), &next = shaped(cycle[(k + 1) % cycle.size()]);
    found.facets.push_back(here.facet);
    auto common = overlaps_.common_part(here, next);
    found.common.push_back(common ? std::move(common->points) : std::vector<MapPoint>());
  }
  return found;
}

std::optional<MapHalfPlane> Sorter::parting_line(std::uint32_t piece, std::uint32_t before, std::uint32_t after) {
  MapPredicates& map = overlaps_.map();
  const auto low = overlaps_.common_part(shaped(piece), shaped(before)),
             high = overlaps_.common_part(shaped(piece), shaped(after));
  if (!low || !high) return std::nullopt;
  const auto all_on = [&](const ConvexPiece& part, const MapLine& line, Sign side) {
    return std::all_of(part.points.begin(), part.points.end(),
                       [&](const MapPoint& p) { return map.side(line, p) * side != Sign::negative; });
  };
  std::vector<MapHalfPlane> lines;
  for (const std::uint32_t other : {before, after}) {
    for (const MapHalfPlane& h : shaped(other).shape.lines)
      if (h.line.kind == MapLine::Kind::edge) lines.push_back(h);
    const MapLine meet = MapLine::meet(pieces_[piece].facet, pieces_[other].facet);
    if (!map.coplanar(pieces_[piece].facet, pieces_[other].facet)) lines.push_back({meet, Sign::positive});
  }
  for (const MapHalfPlane& h : lines)
    for (const Sign side : {Sign::positive, Sign::negative})
      if (all_on(*low, h.line, side) && all_on(*high, h.line, -side)) return h;
  return std::nullopt;
}

void Sorter::order_by_planes(const std::vector<std::uint32_t>& component) {
  for (const std::uint32_t p : component) block_of_[p] = static_cast<std::uint32_t>(blocks_.size());
  std::vector<std::uint32_t> ascending = component;
  std::sort(ascending.begin(), ascending.end());
  const bool is_compared = projected_.arithmetic() != Arithmetic::staged;
  const std::vector<FacetId> facets = is_compared ? std::vector<FacetId>() : whole_facets(faces_, ascending);
  if (!facets.empty()) {
    const std::size_t before = pieces_.size() - cuts_ + cuts_by_planes_ - component.size();
    TreeOrder found = ordered_by_tree(projected_, view_, facets, before, most_, options_.stop);
    result_.order.decisions += found.order.decisions;
    cuts_by_planes_ += found.splits;
    result_.counts.cuts_in_cycles += found.splits;
    blocks_.push_back(std::move(found.order));
    if (observer_ != nullptr) observer_->ordered_by_planes(component, blocks_.back());
    return;
  }
  std::vector<PieceOfFacet> pieces;
  pieces.reserve(component.size());
  for (const std::uint32_t p : component) pieces.push_back(shaped(p));
  PaintersOrder order;
  for (const PieceOfFacet& piece : ordered_by_planes(overlaps_.map(), std::move(pieces), [&] {
         throw_if_stopped(options_.stop);
         count_pieces(1);
         ++cuts_by_planes_;
         ++result_.counts.cuts_in_cycles;
       }))
    append(mesh_, piece, order);
  blocks_.push_back(std::move(order));
  if (observer_ != nullptr) observer_->ordered_by_planes(component, blocks_.back());
}

void Sorter::tell_order(const std::vector<std::uint32_t>& nodes, const std::vector<std::uint32_t>& piece_of,
                        const std::vector<std::uint32_t>& block_at) const {
  const auto blocks_from = static_cast<std::uint32_t>(pieces_.size());
  std::vector<std::uint32_t> told;
  for (const std::uint32_t node : nodes) told.push_back(piece_of[node] != none ? piece_of[node] : blocks_from + block_at[node]);
  observer_->ordered(told, blocks_from);
}

void Sorter::emit() {
  // A node for each piece that is left, and for each block.
  std::vector<std::uint32_t> node_of(pieces_.size(), none), of_block(blocks_.size(), none);
  std::vector<std::uint32_t> piece_of;  // or none
  std::vector<std::uint32_t> block_at, cluster_at;
  for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
    if (is_cut_[i] != 0) continue;
    const std::uint32_t block = block_of_[i];
    if (block != none && of_block[block] != none) {
      node_of[i] = of_block[block];
      continue;
    }
    node_of[i] = static_cast<std::uint32_t>(piece_of.size());
    if (block != none) of_block[block] = node_of[i];
    piece_of.push_back(block == none ? i : none);
    block_at.push_back(block);
    cluster_at.push_back(cluster_of_[i]);
  }
  const auto for_each_edge = [&](const auto& visit) {
    for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
      if (node_of[i] == none) continue;
      for_each_neighbour(i, [&](const Neighbour& n) {
        if (!n.before && node_of[n.piece] != none && node_of[n.piece] != node_of[i]) visit(node_of[i], node_of[n.piece]);
      });
    }
  };
  const std::vector<std::uint32_t> order = topological_order(make_graph(piece_of.size(), for_each_edge));
  if (order.size() != piece_of.size() && projected_.arithmetic() != Arithmetic::double_only)
    throw InvariantError("depth_sort: a cycle is left");
  result_.order.pieces.reserve(pieces_.size());
  result_.order.corners.reserve(faces_.rings.values().size());
  const std::vector<std::uint32_t> nodes = by_cluster(order, clusters_.size(), [&](std::uint32_t k) { return cluster_at[k]; });
  if (observer_ != nullptr) tell_order(nodes, piece_of, block_at);
  for (const std::uint32_t node : nodes) {
    if (piece_of[node] != none) {
      const std::uint32_t piece = piece_of[node];
      if (piece < faces_.size())
        append(projected_, faces_, piece, result_.order);
      else
        append(mesh_, pieces_[piece], result_.order);
    } else {
      append(blocks_[block_at[node]], result_.order);
    }
  }
}

DepthSort Sorter::sort() {
  faces_ = face_pieces(projected_);
  clusters_ = options_.classic ? one_cluster(faces_) : clusters(projected_, faces_);
  cluster_of_ = cluster_of_pieces(clusters_);
  if (observer_ != nullptr) observer_->began(faces_, clusters_);
  const OverlapGraph found = relate_whole();
  DepthSortCounts& c = result_.counts;
  c.clusters = clusters_.size();
  c.candidates = found.candidates;
  c.apart = found.counts.image_sides;
  c.by_depth = found.counts.depths;
  c.by_plane = found.counts.first_planes + found.counts.second_planes;
  c.coplanar = found.counts.coplanar;
  c.by_overlap = found.counts.intersection;
  c.overlapping = found.overlapping;
  c.piercing = found.piercing.size();
  result_.order.decisions += found.decisions;
  if (result_.order.pieces.size() == faces_.size()) return std::move(result_);
  begin_cutting(found);
  order_dense_components();
  resolve_piercing();
  resolve_cycles();
  emit();
  result_.order.decisions += overlaps_.map().exact().counts();
  return std::move(result_);
}

}  // namespace

std::vector<std::array<Rational, 3>> witnesses(const Mesh& mesh, const View& view, const PaintersCycle& cycle) {
  std::vector<std::array<Rational, 3>> found(cycle.facets.size());
  // The middle of the corners of the common part, on this face: inside it, as it is convex.
  for (std::size_t k = 0; k < found.size(); ++k) {
    const Rational count(static_cast<double>(cycle.common[k].size()));
    for (const MapPoint& p : cycle.common[k]) {
      const auto at = exact_point(mesh, view, cycle.facets[k], p);
      for (std::size_t i = 0; i < 3; ++i) found[k][i] = found[k][i] + at[i] / count;
    }
  }
  return found;
}

namespace {

void add(DepthSortCounts& all, const DepthSortCounts& one) {
  for (const auto count :
       {&DepthSortCounts::clusters, &DepthSortCounts::candidates, &DepthSortCounts::apart, &DepthSortCounts::by_depth,
        &DepthSortCounts::by_plane, &DepthSortCounts::coplanar, &DepthSortCounts::by_overlap, &DepthSortCounts::overlapping,
        &DepthSortCounts::piercing, &DepthSortCounts::cuts_at_intersections, &DepthSortCounts::cuts_in_cycles,
        &DepthSortCounts::cyclic_components})
    all.*count += one.*count;
  all.largest_component = std::max(all.largest_component, one.largest_component);
}

/// The counts are those of all cells, and the cycles, too.
DepthSort sorted_in_cells(const SceneView& scene, const DepthSortOptions& options) {
  DepthSort all;
  all.order = order_in_cells(scene, [&](const ViewParts::Cell& cell) {
    DepthSort one = depth_sort(cell.scene, options);
    for (PaintersCycle& cycle : one.cycles)
      for (std::vector<MapPoint>& corners : cycle.common)
        for (MapPoint& p : corners) p = p.by_plane(cell.cell.plane);
    add(all.counts, one.counts);
    std::move(one.cycles.begin(), one.cycles.end(), std::back_inserter(all.cycles));
    return std::move(one.order);
  });
  return all;
}

}  // namespace

DepthSort internal::depth_sort(const SceneView& scene, const DepthSortOptions& options, SortObserver& observer) {
  DepthSort sorted = Sorter(scene, options, &observer).sort();
  cut_self_overlaps(scene, sorted.order);
  sorted.order.wires = ordered_wires(scene, sorted.order);
  return sorted;
}

DepthSort depth_sort(const SceneView& scene, const DepthSortOptions& options) {
  throw_if_stopped(options.stop);
  if (scene.view().has_cells()) return sorted_in_cells(scene, options);
  DepthSort sorted;
  if (!scene.mesh().triangles.empty()) sorted = Sorter(scene, options, nullptr).sort();
  cut_self_overlaps(scene, sorted.order);
  sorted.order.wires = ordered_wires(scene, sorted.order);
  return sorted;
}

}  // namespace hsr
