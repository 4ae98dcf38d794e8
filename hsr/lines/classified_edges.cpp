#include "hsr/lines/classified_edges.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>

#include "geometry/disjoint_sets.h"
#include "geometry/parallel.h"
#include "hsr/lines/edge_parts.h"
#include "hsr/lines/near_parts.h"
#include "hsr/view/frustum.h"

namespace hsr::internal {

/// Finds the classes of edges in a row. One object for each block of edges.
struct ClassifiedEdges::Finder {
  const EdgeClassifier& classifier;
  const LineOptions& options;
  const Occluders* occluders;
  bool with_behind;
  const NearParts* near;
  TriangleOcclusion occlusion{classifier.projected()};
  std::vector<RequestedPart> parts = {};  // of edges that have several, or anything behind
  std::vector<EdgeId> may_go_on = {};     // whole edges

  bool is_requested(const std::optional<EdgeClass>& c) const { return c && options.classes[static_cast<std::size_t>(*c)]; }

  /// The class of a whole edge, or nothing: none that is wanted, or it has parts.
  std::optional<EdgeClass> find(EdgeId id, bool has_contact) {
    std::vector<EdgePart> found;
    if (near != nullptr && !classifier.projected().mesh().triangles_at(id).empty())
      found = near->of_edge(occlusion, id);
    else if (has_contact)
      found = edge_parts(classifier, occlusion, id, *occluders);
    else if (const EdgePart whole = whole_edge(classifier, occlusion, id); !whole.found.behind) {
      if (whole.found.may_go_on) may_go_on.push_back(id);
      return wanted(id, whole.found.seen);
    } else
      found.push_back(whole);
    const bool is_whole = found.size() == 1;
    if (!is_whole) {
      for (const EdgePart& p : found)
        if (const auto c = wanted(id, p.found.seen)) parts.push_back({id, *c, false, p.from, p.to});
    } else if (found.front().found.behind) {
      if (const auto c = wanted(id, found.front().found.seen)) parts.push_back({id, *c});
    }
    if (is_whole && found.front().found.may_go_on && !found.front().found.behind) may_go_on.push_back(id);
    if (with_behind) add_behind(id, found);
    return is_whole && !found.front().found.behind ? wanted(id, found.front().found.seen) : std::nullopt;
  }

 private:
  std::optional<EdgeClass> wanted(EdgeId id, std::optional<EdgeClass> c) const {
    if (!c && options.diagonals && classifier.projected().mesh().edges[id].diagonal) c = EdgeClass::smooth;
    return is_requested(c) ? c : std::nullopt;
  }
  void add_behind(EdgeId id, const std::vector<EdgePart>& found) {
    const EdgePart* last = nullptr;
    for (const EdgePart& p : found) {
      const bool goes_on = last != nullptr && last->found.behind == p.found.behind;
      last = &p;
      if (!is_requested(p.found.behind)) continue;
      if (goes_on)
        parts.back().to = p.to;
      else
        parts.push_back({id, *p.found.behind, true, p.from, p.to});
    }
  }
};

namespace {

/// Edges that lead to a sharp one over others of their kind are sharp, too.
void go_on(const Mesh& mesh, const std::vector<std::vector<EdgeId>>& may_go_on,
           const std::vector<std::vector<RequestedPart>>& parts, std::vector<std::uint8_t>& edge_classes) {
  DisjointSets chains(mesh.points.size());
  for (const auto& block : may_go_on)
    for (const EdgeId e : block) chains.join(mesh.edges[e].a.value, mesh.edges[e].b.value);
  std::vector<std::uint8_t> is_sharp(mesh.points.size(), 0);  // by root
  const auto mark = [&](EdgeId e) {
    for (const VertexId v : {mesh.edges[e].a, mesh.edges[e].b}) is_sharp[chains.find(v.value)] = 1;
  };
  constexpr auto sharp = static_cast<std::uint8_t>(EdgeClass::sharp);
  for (std::size_t e = 0; e < edge_classes.size(); ++e)
    if (edge_classes[e] == sharp) mark(EdgeId(e));
  for (const auto& block : parts)
    for (const RequestedPart& p : block)
      if (p.edge_class == EdgeClass::sharp && !p.is_behind) mark(p.edge);
  for (const auto& block : may_go_on)
    for (const EdgeId e : block)
      if (is_sharp[chains.find(mesh.edges[e].a.value)] != 0) edge_classes[e.value] = sharp;
}

}  // namespace

ClassifiedEdges::ClassifiedEdges(const EdgeClassifier& classifier, const LineOptions& options, const ViewFrustum* outside,
                                 const Occluders* occluders, const std::vector<std::uint8_t>& has_contact, bool with_behind,
                                 const NearParts* near) {
  using Range = tbb::blocked_range<std::size_t>;
  const Mesh& mesh = classifier.projected().mesh();
  constexpr std::uint8_t none = 0xff;
  std::vector<std::uint8_t> edge_classes(mesh.edges.size(), none);
  std::vector<DecisionCounts> counts((mesh.edges.size() + edges_of_block - 1) / edges_of_block);
  std::vector<std::vector<RequestedPart>> parts(counts.size());
  std::vector<std::vector<EdgeId>> may_go_on(counts.size());
  tbb::parallel_for(Range(0, counts.size(), 1), [&](const Range& range) {
    for (std::size_t block = range.begin(); block < range.end(); ++block) {
      Finder finder{classifier, options, occluders, with_behind, near};
      const std::size_t end = std::min((block + 1) * edges_of_block, mesh.edges.size());
      for (std::size_t e = block * edges_of_block; e < end; ++e) {
        const EdgeId id(e);
        if (mesh.edges[id].is_only_of_ghosts() || (outside != nullptr && outside->contains(mesh.edges[id]))) continue;
        if (const auto c = finder.find(id, !has_contact.empty() && has_contact[e] != 0))
          edge_classes[e] = static_cast<std::uint8_t>(*c);
      }
      parts[block] = std::move(finder.parts);
      may_go_on[block] = std::move(finder.may_go_on);
      counts[block] = finder.occlusion.exact().counts();
    }
  });
  for (const DecisionCounts& c : counts) decisions += c;
  if (options.crease_goes_on && options.classes[static_cast<std::size_t>(EdgeClass::sharp)])
    go_on(mesh, may_go_on, parts, edge_classes);
  edges = parallel_collect<EdgeId>(edge_classes.size(), [&](std::size_t begin, std::size_t end, std::vector<EdgeId>& part) {
    for (std::size_t e = begin; e < end; ++e)
      if (edge_classes[e] != none) part.emplace_back(e);
  });
  classes.resize(edges.size());
  parallel_for_each(edges.size(), [&](std::size_t i) { classes[i] = static_cast<EdgeClass>(edge_classes[edges[i].value]); });
  std::vector<RequestedPart> several;
  for (const auto& block : parts) several.insert(several.end(), block.begin(), block.end());
  if (!several.empty()) list_parts(several);
  find_boxes(classifier.projected());
}

/// Puts parts in their places among the edges that are listed whole.
void ClassifiedEdges::list_parts(const std::vector<RequestedPart>& ascending) {
  std::vector<EdgeId> all_edges;
  std::vector<EdgeClass> all_classes;
  std::vector<std::size_t> behind;
  std::size_t next = 0;
  const auto add_parts_before = [&](EdgeId e) {
    for (; next < ascending.size() && ascending[next].edge < e; ++next) {
      if (ascending[next].is_behind) behind.push_back(all_edges.size());
      parts_.push_back({all_edges.size(), ascending[next]});
      all_edges.push_back(ascending[next].edge);
      all_classes.push_back(ascending[next].edge_class);
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
  if (behind.empty()) return;
  hidden.resize(edges.size(), 0);
  for (const std::size_t i : behind) hidden[i] = 1;
}

const ClassifiedEdges::Part* ClassifiedEdges::part(std::size_t i) const {
  const auto at = std::lower_bound(parts_.begin(), parts_.end(), i, [](const Part& p, std::size_t k) { return p.index < k; });
  return at != parts_.end() && at->index == i ? &*at : nullptr;
}

bool ClassifiedEdges::is_part(std::size_t i) const {
  const Part* const p = part(i);
  return p != nullptr && (p->part.from.kind != Cut::Kind::start || p->part.to.kind != Cut::Kind::end);
}

RequestedPart ClassifiedEdges::operator[](std::size_t i) const {
  if (const Part* p = part(i)) return p->part;
  return {edges[i], classes[i]};
}

ClassifiedEdges::ClassifiedEdges(const ProjectedMesh& projected, std::vector<EdgeId> ascending) : edges(std::move(ascending)) {
  classes.resize(edges.size(), EdgeClass::smooth);
  find_boxes(projected);
}

void ClassifiedEdges::add_ghosts(const ProjectedMesh& projected, const EdgeClassifier& among_ghosts, const LineOptions& options,
                                 const ViewFrustum* outside) {
  const Mesh &mesh = projected.mesh(), &of_ghosts = among_ghosts.projected().mesh();
  first_ghost_ = edges.size();
  LineOptions without_diagonals = options;
  without_diagonals.diagonals = false;
  const ClassifiedEdges ghosts(among_ghosts, without_diagonals, outside, nullptr, {}, false, nullptr);
  for (std::size_t i = 0; i < ghosts.edges.size(); ++i) {
    const Edge& e = of_ghosts.edges[ghosts.edges[i]];
    edges.push_back(mesh.find_edge(e.a, e.b));
    classes.push_back(ghosts.classes[i]);
  }
  if (!hidden.empty()) hidden.resize(edges.size(), 0);
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
