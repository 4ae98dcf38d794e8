#include "hsr/lines/classified_edges.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>

#include "geometry/disjoint_sets.h"
#include "geometry/parallel.h"
#include "hsr/lines/edge_parts.h"
#include "hsr/lines/inside_bodies.h"
#include "hsr/lines/near_parts.h"
#include "hsr/view/frustum.h"

namespace hsr::internal {

namespace {

struct FoundInBlock {
  std::vector<RequestedPart> parts;  // of edges that have several, or whose class depends on more
  std::vector<EdgeId> may_go_on;     // whole edges
  std::vector<CoincidentFaces> log;
  std::vector<std::pair<EdgeId, std::vector<EdgePart>>> undecided;  // until the log is complete
  DecisionCounts decisions;
};

std::vector<std::span<const CoincidentFaces>> logs_of(const std::vector<FoundInBlock>& blocks) {
  std::vector<std::span<const CoincidentFaces>> logs;
  for (const FoundInBlock& b : blocks) logs.emplace_back(b.log);
  return logs;
}

/// A part of an edge in pieces: each is inside of bodies, or outside, all along.
std::vector<EdgePart> cut_where_bodies_begin(TriangleOcclusion& occlusion, EdgeId id, const EdgePart& part,
                                             const std::vector<TriangleId>& passed_through) {
  const auto is_before = [&](const Breakpoint& x, const Breakpoint& y) { return occlusion.order(x, y) == Sign::negative; };
  std::vector<EdgePart> all = {part};
  if (passed_through.empty() || !occlusion.start(id, part.from, part.to)) return all;
  std::vector<Breakpoint> places;
  for (const TriangleId t : passed_through) places.push_back(occlusion.place({Cut::Kind::face, 0, t.value, 0}));
  std::sort(places.begin(), places.end(), is_before);
  Breakpoint last = occlusion.first();
  for (const Breakpoint& place : places) {
    if (!is_before(last, place) || !is_before(place, occlusion.last())) continue;
    all.back().to = place.cut;
    all.push_back({part.found, place.cut, part.to});
    last = place;
  }
  return all;
}

/// Whether bodies touch all around a part of an edge whose faces lead to where they do: it must lie inside of bodies, since two that
/// overlap have faces that coincide on the outside, too.
TouchingRegions::Verdict verdict(const ProjectedMesh& projected, EdgeId id, const EdgePart& part, const CoincidentFaces& around,
                                 const InsideBodies& inside, InsideBodies::Place& place) {
  using Verdict = TouchingRegions::Verdict;
  const Edge& edge = projected.mesh().edges[id];
  const auto point = [&](const Cut& cut) {
    const auto p = exact_point(projected.mesh(), inside.view(), SupportingLine{edge.a, edge.b, {}}, cut);
    return Point3{p[0].to_double(), p[1].to_double(), p[2].to_double()};
  };
  const std::size_t faces = around.sets.front().size();
  place.from = point(part.from);
  place.to = point(part.to);
  const bool is_inside = faces % 2 == 0 && inside.contain_middle(place, faces / 2);
  return is_inside ? Verdict::touch : Verdict::in_doubt;
}

/// A part by what is all around it.
EdgePart decided(const ProjectedMesh& projected, EdgeId id, EdgePart p, TouchingRegions::Verdict around) {
  using Verdict = TouchingRegions::Verdict;
  const std::optional<EdgeClass> in_doubt = std::exchange(p.found.in_doubt, std::nullopt);
  p.found.alike = 0;
  if (around == Verdict::apart) return p;
  p.found.behind.reset();
  if (around == Verdict::in_doubt) p.found.seen = in_doubt;
  if (around == Verdict::touch && p.found.seen) p.found.hidden = EdgeClass::smooth;
  p.found = with_wire(projected.mesh().edges[id], p.found);
  return p;
}

/// Parts whose classes wait for the log, now that it is complete; neighbours that are alike become one.
void decide_parts(const ProjectedMesh& projected, TriangleOcclusion& occlusion, EdgeId id, std::vector<EdgePart>& parts,
                  const std::vector<CoincidentFaces>& log, const TouchingRegions& regions, const InsideBodies& inside) {
  using Verdict = TouchingRegions::Verdict;
  std::vector<EdgePart> all;
  const auto add = [&](const EdgePart& p) {
    if (!all.empty() && all.back().found == p.found)
      all.back().to = p.to;
    else
      all.push_back(p);
  };
  const auto decided = [&](const EdgePart& p, Verdict around) { return hsr::internal::decided(projected, id, p, around); };
  std::optional<std::vector<TriangleId>> passed_through;
  const Edge& edge = projected.mesh().edges[id];
  InsideBodies::Place place{projected.mesh().points[edge.a], projected.mesh().points[edge.b], {}, {}};
  for (const EdgePart& p : parts) {
    if (!p.found.is_undecided()) {
      add(decided(p, Verdict::apart));
      continue;
    }
    const CoincidentFaces& around = log[p.found.alike - 1];
    const Verdict by_faces = regions.verdict(around);
    if (by_faces != Verdict::touch) {
      add(decided(p, by_faces));
      continue;
    }
    if (!passed_through) passed_through = inside.passed_through(edge);
    for (const EdgePart& piece : cut_where_bodies_begin(occlusion, id, p, *passed_through))
      add(decided(piece, verdict(projected, id, piece, around, inside, place)));
  }
  parts = std::move(all);
}

}  // namespace

/// Finds the classes of edges in a row. One object for each block of edges.
struct ClassifiedEdges::Finder {
  const EdgeClassifier& classifier;
  const LineOptions& options;
  const Occluders* occluders;
  bool with_behind;
  const NearParts* near;
  FoundInBlock& block;
  TriangleOcclusion occlusion{classifier.projected()};

  bool is_requested(const std::optional<EdgeClass>& c) const { return c && options.classes[static_cast<std::size_t>(*c)]; }

  /// The class of a whole edge, or nothing: none that is wanted, or it has parts, or it is undecided.
  std::optional<EdgeClass> find(EdgeId id, bool has_contact) {
    if (near == nullptr && !has_contact)
      if (const EdgePart whole = whole_edge(classifier, occlusion, id, log()); !whole.found.depends_on_more())
        return take_whole(id, whole.found);
    std::vector<EdgePart> parts = parts_of(id, has_contact);
    if (std::none_of(parts.begin(), parts.end(), [](const EdgePart& p) { return p.found.is_undecided(); }))
      return take(id, parts);
    block.undecided.emplace_back(id, std::move(parts));
    return std::nullopt;
  }
  std::optional<EdgeClass> decide(EdgeId id, std::vector<EdgePart>& parts, const TouchingRegions& regions,
                                  const InsideBodies& inside) {
    decide_parts(classifier.projected(), occlusion, id, parts, block.log, regions, inside);
    return take(id, parts);
  }
  /// Whether what is elsewhere makes a difference to what is listed of an edge.
  bool depends_on_far_faces(EdgeId id, const std::vector<EdgePart>& parts) const {
    using Verdict = TouchingRegions::Verdict;
    const auto listed = [&](const EdgePart& p) {
      PartClass c = p.found;
      const auto seen = wanted(c.seen);
      if (!seen && !is_requested(c.hidden) && !is_requested(c.behind_seen)) c = {{}, c.behind};
      if (!is_requested(c.behind)) c.behind.reset();
      return c;
    };
    return std::any_of(parts.begin(), parts.end(), [&](const EdgePart& p) {
      if (!p.found.is_undecided()) return false;
      const auto by = [&](Verdict v) { return listed(decided(classifier.projected(), id, p, v)); };
      return !(by(Verdict::apart) == by(Verdict::in_doubt) && by(Verdict::apart) == by(Verdict::touch));
    });
  }
  /// Logs what coincides along an edge, and no more.
  std::optional<EdgeClass> only_log(EdgeId id, bool has_contact) {
    parts_of(id, has_contact);
    return std::nullopt;
  }

 private:
  std::vector<CoincidentFaces>* log() { return with_behind ? &block.log : nullptr; }
  std::vector<EdgePart> parts_of(EdgeId id, bool has_contact) {
    if (near != nullptr && !classifier.projected().mesh().triangles_at(id).empty()) return near->of_edge(occlusion, id, log());
    if (has_contact) return edge_parts(classifier, occlusion, id, *occluders, log());
    return {whole_edge(classifier, occlusion, id, log())};
  }
  std::optional<EdgeClass> take_whole(EdgeId id, const PartClass& found) {
    if (found.may_go_on) block.may_go_on.push_back(id);
    return wanted(found.seen);
  }
  std::optional<EdgeClass> take(EdgeId id, const std::vector<EdgePart>& found) {
    const PartClass& first = found.front().found;
    const bool is_whole = found.size() == 1;
    if (is_whole && !first.depends_on_more()) return take_whole(id, first);
    for (const EdgePart& p : found) {
      const auto seen = wanted(p.found.seen);
      if (!seen && !is_requested(p.found.hidden) && !is_requested(p.found.behind_seen)) continue;
      // What is not wanted of it is left out when it is known what is hidden.
      block.parts.push_back({id, seen ? *seen : *p.found.seen, false, p.found.hidden, p.found.behind_seen});
      if (is_whole) continue;
      block.parts.back().from = p.from;
      block.parts.back().to = p.to;
    }
    if (with_behind) add_behind(id, found);
    return std::nullopt;
  }
  std::optional<EdgeClass> wanted(std::optional<EdgeClass> c) const {
    if (!c && options.diagonals) c = EdgeClass::smooth;
    return is_requested(c) ? c : std::nullopt;
  }
  void add_behind(EdgeId id, const std::vector<EdgePart>& found) {
    const EdgePart* last = nullptr;
    for (const EdgePart& p : found) {
      const bool goes_on = last != nullptr && last->found.behind == p.found.behind;
      last = &p;
      if (!is_requested(p.found.behind)) continue;
      if (goes_on)
        block.parts.back().to = p.to;
      else
        block.parts.push_back({id, *p.found.behind, true, {}, {}, p.from, p.to});
    }
  }
};

namespace {

/// Edges that lead to a sharp one over others of their kind are sharp, too.
void go_on(const Mesh& mesh, const std::vector<FoundInBlock>& blocks, std::vector<std::uint8_t>& edge_classes) {
  DisjointSets chains(mesh.points.size());
  for (const FoundInBlock& block : blocks)
    for (const EdgeId e : block.may_go_on) chains.join(mesh.edges[e].a.value, mesh.edges[e].b.value);
  std::vector<std::uint8_t> is_sharp(mesh.points.size(), 0);  // by root
  const auto mark = [&](EdgeId e) {
    for (const VertexId v : {mesh.edges[e].a, mesh.edges[e].b}) is_sharp[chains.find(v.value)] = 1;
  };
  constexpr auto sharp = static_cast<std::uint8_t>(EdgeClass::sharp);
  for (std::size_t e = 0; e < edge_classes.size(); ++e)
    if (edge_classes[e] == sharp) mark(EdgeId(e));
  for (const FoundInBlock& block : blocks)
    for (const RequestedPart& p : block.parts)
      if (p.edge_class == EdgeClass::sharp && !p.is_behind) mark(p.edge);
  for (const FoundInBlock& block : blocks)
    for (const EdgeId e : block.may_go_on)
      if (is_sharp[chains.find(mesh.edges[e].a.value)] != 0) edge_classes[e.value] = sharp;
}

}  // namespace

ClassifiedEdges::ClassifiedEdges(const EdgeClassifier& classifier, const LineOptions& options, const ViewFrustum* outside,
                                 const Occluders* occluders, const std::vector<std::uint8_t>& has_contact, bool with_behind,
                                 const NearParts* near, const InsideBodies* inside) {
  using Range = tbb::blocked_range<std::size_t>;
  const Mesh& mesh = classifier.projected().mesh();
  constexpr std::uint8_t none = 0xff;
  std::vector<std::uint8_t> edge_classes(mesh.edges.size(), none);
  std::vector<FoundInBlock> blocks((mesh.edges.size() + edges_of_block - 1) / edges_of_block);
  const auto visit = [&](bool is_outside, std::optional<EdgeClass> (Finder::*find)(EdgeId, bool)) {
    tbb::parallel_for(Range(0, blocks.size(), 1), [&](const Range& range) {
      for (std::size_t block = range.begin(); block < range.end(); ++block) {
        Finder finder{classifier, options, occluders, with_behind, near, blocks[block]};
        const std::size_t end = std::min((block + 1) * edges_of_block, mesh.edges.size());
        for (std::size_t e = block * edges_of_block; e < end; ++e) {
          const EdgeId id(e);
          if (mesh.edges[id].is_only_of_ghosts()) continue;
          if ((outside != nullptr && outside->contains(mesh.edges[id])) != is_outside) continue;
          if (const auto c = (finder.*find)(id, !has_contact.empty() && has_contact[e] != 0))
            edge_classes[e] = static_cast<std::uint8_t>(*c);
        }
        blocks[block].decisions += finder.occlusion.exact().counts();
      }
    });
  };
  visit(false, &Finder::find);
  if (std::any_of(blocks.begin(), blocks.end(), [](const FoundInBlock& b) { return !b.undecided.empty(); })) {
    // What is outside the picture may be where a body ends in the open.
    if (outside != nullptr) visit(true, &Finder::only_log);
    for (FoundInBlock& b : blocks) {
      const Finder finder{classifier, options, occluders, with_behind, near, b};
      for (const auto& [id, parts] : b.undecided)
        if (finder.depends_on_far_faces(id, parts)) in_doubt.push_back(id);
    }
    const TouchingRegions regions(logs_of(blocks));
    tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t k) {
      FoundInBlock& b = blocks[k];
      Finder finder{classifier, options, occluders, with_behind, near, b};
      for (auto& [id, parts] : b.undecided)
        if (const auto c = finder.decide(id, parts, regions, *inside)) edge_classes[id.value] = static_cast<std::uint8_t>(*c);
      std::stable_sort(b.parts.begin(), b.parts.end(),
                       [](const RequestedPart& x, const RequestedPart& y) { return x.edge < y.edge; });
    });
  }
  for (const FoundInBlock& b : blocks) decisions += b.decisions;
  if (options.crease_goes_on && options.classes[static_cast<std::size_t>(EdgeClass::sharp)]) go_on(mesh, blocks, edge_classes);
  edges = parallel_collect<EdgeId>(edge_classes.size(), [&](std::size_t begin, std::size_t end, std::vector<EdgeId>& part) {
    for (std::size_t e = begin; e < end; ++e)
      if (edge_classes[e] != none) part.emplace_back(e);
  });
  classes.resize(edges.size());
  parallel_for_each(edges.size(), [&](std::size_t i) { classes[i] = static_cast<EdgeClass>(edge_classes[edges[i].value]); });
  std::vector<RequestedPart> several;
  for (const FoundInBlock& b : blocks) several.insert(several.end(), b.parts.begin(), b.parts.end());
  has_hidden_classes =
      std::any_of(several.begin(), several.end(), [](const RequestedPart& p) { return p.hidden || p.behind_seen; });
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
  const ClassifiedEdges ghosts(among_ghosts, without_diagonals, outside, nullptr, {}, false, nullptr, nullptr);
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
