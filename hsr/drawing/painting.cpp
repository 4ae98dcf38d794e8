#include "hsr/drawing/painting.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <numeric>

#include "geometry/disjoint_sets.h"
#include "geometry/parallel.h"
#include "hsr/drawing/cut_seams.h"
#include "hsr/drawing/filled_drawing.h"
#include "hsr/drawing/join.h"
#include "hsr/drawing/paint_layers.h"
#include "hsr/drawing/paper_sides.h"
#include "hsr/drawing/placed_pieces.h"
#include "hsr/drawing/placement.h"
#include "hsr/drawing/reach.h"
#include "hsr/drawing/section_drawing.h"
#include "hsr/lines/edge_classifier.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/scene/view_parts.h"

namespace hsr {

using namespace internal;

namespace {

/// Every edge beyond the near plane, as if nothing hid anything: what the page has to hold.
VisibleLines all_edges(const SceneView& scene) {
  if (scene.view().has_cells()) {
    LineOptions every;
    every.classes.fill(true);
    VisibleLines left = visible_lines(scene, every);
    std::erase_if(left.lines, [](const Line& line) { return line.intervals() == 0; });
    return left;
  }
  const Mesh& mesh = scene.mesh();
  const ProjectedMesh& projected = scene.parts().projected();
  VisibleLines all;
  for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
    const EdgeId e(i);
    const Sign a = projected.beyond_near(mesh.edges[e].a), b = projected.beyond_near(mesh.edges[e].b);
    const bool is_in_plane = a == Sign::zero && b == Sign::zero;  // of a section: what lies in it stays
    if (a != Sign::positive && b != Sign::positive && !is_in_plane) continue;
    Line line;
    line.edge = e;
    line.first_cut = static_cast<std::uint32_t>(all.cuts.size());
    all.cuts.push_back({a == Sign::negative ? Cut::Kind::near : Cut::Kind::start, 0, 0, 0});
    all.cuts.push_back({b == Sign::negative ? Cut::Kind::near : Cut::Kind::end, 0, 0, 0});
    line.end_cut = static_cast<std::uint32_t>(all.cuts.size());
    all.lines.push_back(line);
  }
  return all;
}

/// By edge; nothing: not asked for.
std::vector<std::optional<EdgeClass>> asked_classes(const ViewParts& parts, const LineOptions& options) {
  const ProjectedMesh& projected = parts.projected();
  std::vector<std::optional<EdgeClass>> asked(parts.mesh().edges.size());
  const EdgeClassifier classifier(projected, parts.labels(), parts.marks(), options);
  using Range = tbb::blocked_range<std::size_t>;
  tbb::parallel_for(Range(0, asked.size(), 512), [&](const Range& range) {
    Predicates exact = projected.predicates();
    for (std::size_t e = range.begin(); e < range.end(); ++e) {
      const auto c = classifier(exact, EdgeId(e)).seen;
      if (c && options.classes[static_cast<std::size_t>(*c)]) asked[e] = c;
    }
  });
  return asked;
}

/// The pieces that are painted together, as one fill.
struct PaintedGroup {
  std::uint32_t layer = 0;
  double opacity = 1;
  std::vector<std::uint32_t> pieces;  // ascending
};

/// See-through neighbours of one colour and one layer together, all others alone; in the order in which they are painted.
class PaintedGroups {
 public:
  PaintedGroups(const std::vector<PlacedPiece>& pieces, const std::vector<Fill>& fills,
                const std::vector<std::uint32_t>& layers) {
    DisjointSets same(pieces.size());
    join_neighbours(pieces, fills, layers, same);
    std::vector<std::uint32_t> group_of(pieces.size());
    for (std::uint32_t i = 0; i < pieces.size(); ++i) {
      const std::uint32_t first = same.find(i);
      if (first == i) {
        group_of[i] = static_cast<std::uint32_t>(groups.size());
        groups.push_back({layers[i], fills[i].opacity, {}});
      }
      groups[group_of[first]].pieces.push_back(i);
    }
    std::stable_sort(groups.begin(), groups.end(), [](const auto& a, const auto& b) {
      return std::pair(a.layer, a.opacity) < std::pair(b.layer, b.opacity);
    });
  }

  std::vector<PaintedGroup> groups;

 private:
  static void join_neighbours(const std::vector<PlacedPiece>& pieces, const std::vector<Fill>& fills,
                              const std::vector<std::uint32_t>& layers, DisjointSets& same) {
    std::vector<PaperSide> sides;
    for (std::uint32_t i = 0; i < pieces.size(); ++i) {
      if (fills[i].opacity < 1) append_sides(pieces[i].ring, i, sides);
    }
    sides = conforming(sides);
    std::sort(sides.begin(), sides.end());
    const auto is_same = [&](std::uint32_t i, std::uint32_t k) {
      return layers[i] == layers[k] && fills[i].colour == fills[k].colour && fills[i].opacity == fills[k].opacity;
    };
    for (const PaperSide& side : sides)
      for (auto other = std::lower_bound(sides.begin(), sides.end(), PaperSide{side.to, side.from, 0});
           other != sides.end() && other->from == side.to && other->to == side.from; ++other)
        if (is_same(side.owner, other->owner)) same.join(side.owner, other->owner);
  }
};

/// A line that is painted with the fills.
struct PaintedLine {
  SideLine line;
  std::uint32_t fills_before = 0;
};

/// Of lines that run along one another, as where two pieces meet, the one that is painted last.
void add_lines(Fills& fills, const std::vector<PaintedLine>& all) {
  struct Found : PaintedLine {
    auto ends() const { return std::minmax(line.from, line.to); }
    auto key() const {
      return std::tuple(std::min(line.from, line.to), std::max(line.from, line.to), ~fills_before, line.edge_class);
    }
  };
  std::vector<Found> found;
  for (const PaintedLine& line : all)
    if (line.line.from != line.line.to) found.push_back({line});
  std::sort(found.begin(), found.end(), [](const Found& a, const Found& b) { return a.key() < b.key(); });
  std::vector<PaperLine> lines;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const SideLine& line = found[k].line;
    if (k == 0 || found[k].ends() != found[k - 1].ends())
      lines.push_back({line.from, line.to, static_cast<std::uint32_t>(line.edge_class), found[k].fills_before});
  }
  const Chains chains = join(lines);
  for (std::size_t c = 0; c < chains.passes.size(); ++c) {
    const PaperLine& first = lines[chains.passes[c].front() / 2];
    FillLine out;
    out.fills_before = first.object;
    out.closed = chains.closed[c] != 0;
    out.edge_class = static_cast<EdgeClass>(first.style);
    out.first_point = static_cast<std::uint32_t>(fills.line_points.size());
    for (const std::uint32_t pass : chains.passes[c])
      fills.line_points.push_back((pass & 1U) != 0 ? lines[pass / 2].to : lines[pass / 2].from);
    const std::uint32_t last = chains.passes[c].back();
    if (!out.closed) fills.line_points.push_back((last & 1U) != 0 ? lines[last / 2].from : lines[last / 2].to);
    out.end_point = static_cast<std::uint32_t>(fills.line_points.size());
    fills.lines.push_back(out);
  }
  std::stable_sort(fills.lines.begin(), fills.lines.end(),
                   [](const FillLine& a, const FillLine& b) { return a.fills_before < b.fills_before; });
}

/// Makes the fills of a painting, step by step.
class FillPainter {
 public:
  FillPainter(const SceneView& scene, const PaintersOrder& order, const std::vector<Colour>& colours, double opacity,
              const DrawingOptions& options)
      : scene_(scene), order_(order), colours_(colours), opacity_(opacity), options_(options) {}

  bool is_opaque() const {
    return opacity_ >= 1 && std::all_of(order_.pieces.begin(), order_.pieces.end(), [&](const OrderedPiece& p) {
             return colours_[scene_.mesh().face_of[first_triangle(p.facet)].value][3] == 255;
           });
  }

  /// @param asked by edge: those whose lines are painted with the pieces; nullptr: none
  Fills operator()(const Placement& place, const std::vector<std::optional<EdgeClass>>* asked) const {
    std::vector<PlacedPiece> pieces(order_.pieces.size());
    const PiecePlacer placer(scene_.mesh(), scene_.view(), place);
    parallel_for_each(pieces.size(),
                      [&](std::size_t i) { pieces[i] = placer(order_.pieces[i], order_.corners_of(order_.pieces[i]), asked); });
    std::vector<Fill> looks;  // colour and opacity by piece
    for (const OrderedPiece& piece : order_.pieces) {
      Fill& fill = looks.emplace_back();
      fill.colour = colours_[scene_.mesh().face_of[first_triangle(piece.facet)].value];
      fill.opacity = opacity_ * fill.colour[3] / 255;
    }
    std::vector<PlacedWire> wires = placed_wires(placer, asked);
    std::vector<std::uint32_t> layers(pieces.size());
    if (is_opaque()) {
      std::iota(layers.begin(), layers.end(), 0U);
      close_cuts_of(pieces);
    } else {
      layers = see_through_layers(pieces, wires);
    }
    Fills fills;
    for (const PaintedGroup& group : PaintedGroups(pieces, looks, layers).groups) {
      const bool has_area =
          std::any_of(group.pieces.begin(), group.pieces.end(), [&](auto i) { return !pieces[i].ring.empty(); });
      if (has_area) append(fills, group, pieces, looks[group.pieces.front()]);
    }
    if (asked != nullptr) add_lines(fills, painted_lines(fills, pieces, layers, wires));
    add_section_fills(fills, place, options_);
    reach_beneath(fills);
    return fills;
  }

 private:
  /// A part of a wire: its ends on the page, and the layer after which it comes; -1: before all.
  struct PlacedWire {
    std::vector<PaperPoint> ends;
    std::int64_t layer = -1;
  };

  /// Those whose class is asked for; a wire that faces make more of is drawn as their edge. In layers by number of piece.
  std::vector<PlacedWire> placed_wires(const PiecePlacer& placer, const std::vector<std::optional<EdgeClass>>* asked) const {
    std::vector<PlacedWire> wires(asked == nullptr ? 0 : order_.wires.size());
    parallel_for_each(wires.size(), [&](std::size_t w) {
      const OrderedWire& wire = order_.wires[w];
      if ((*asked)[wire.edge.value] == EdgeClass::wire) wires[w] = {placer(wire), std::int64_t{wire.before} - 1};
    });
    return wires;
  }

  /// Layers of what does not overlap, in the order of the pieces and the wires among them.
  std::vector<std::uint32_t> see_through_layers(const std::vector<PlacedPiece>& pieces, std::vector<PlacedWire>& wires) const {
    std::vector<std::vector<PaperPoint>> rings;
    rings.reserve(pieces.size() + wires.size());
    std::size_t w = 0;
    for (std::size_t i = 0; i <= pieces.size(); ++i) {
      for (; w < wires.size() && order_.wires[w].before == i; ++w) rings.push_back(wires[w].ends);
      if (i < pieces.size()) rings.push_back(pieces[i].ring);
    }
    const std::vector<std::uint32_t> all = paint_layers(rings);
    std::vector<std::uint32_t> layers;
    w = 0;
    for (std::size_t i = 0; i <= pieces.size(); ++i) {
      for (; w < wires.size() && order_.wires[w].before == i; ++w) wires[w].layer = all[i + w];
      if (i < pieces.size()) layers.push_back(all[i + w]);
    }
    return layers;
  }

  /// Lines of the sides of pieces, and wires, each on top of the fills of its layer.
  static std::vector<PaintedLine> painted_lines(const Fills& fills, const std::vector<PlacedPiece>& pieces,
                                                const std::vector<std::uint32_t>& layers,
                                                const std::vector<PlacedWire>& wires) {
    const auto fills_up_to = [&](std::int64_t layer) {
      const auto end = std::ranges::upper_bound(fills.fills, layer, {}, &Fill::layer);
      return static_cast<std::uint32_t>(end - fills.fills.begin());
    };
    std::vector<PaintedLine> lines;
    for (std::size_t i = 0; i < pieces.size(); ++i)
      for (const SideLine& line : pieces[i].lines) lines.push_back({line, fills_up_to(layers[i])});
    for (const PlacedWire& wire : wires)
      if (wire.ends.size() == 2) lines.push_back({{wire.ends[0], wire.ends[1], EdgeClass::wire}, fills_up_to(wire.layer)});
    return lines;
  }

  void append(Fills& fills, const PaintedGroup& group, const std::vector<PlacedPiece>& pieces, const Fill& look) const {
    Fill fill = look;
    fill.layer = group.layer;
    fill.first_ring = static_cast<std::uint32_t>(fills.rings.size());
    fill.first_face = static_cast<std::uint32_t>(fills.faces.size());
    std::vector<PaperSide> sides;
    for (const std::uint32_t i : group.pieces) {
      append_sides(pieces[i].ring, i, sides);
      fills.faces.push_back(scene_.mesh().face_of[first_triangle(order_.pieces[i].facet)].value);
    }
    if (group.pieces.size() == 1) {
      fills.rings.push_row(pieces[group.pieces.front()].ring);
    } else {
      for (const auto& ring : united_rings(conforming(sides))) fills.rings.push_row(ring);
    }
    const auto begin = fills.faces.begin() + fill.first_face;
    std::sort(begin, fills.faces.end());
    fills.faces.erase(std::unique(begin, fills.faces.end()), fills.faces.end());
    fill.end_ring = static_cast<std::uint32_t>(fills.rings.size());
    fill.end_face = static_cast<std::uint32_t>(fills.faces.size());
    fills.fills.push_back(fill);
  }

  void close_cuts_of(std::vector<PlacedPiece>& pieces) const {
    std::vector<std::vector<PaperPoint>> rings;
    std::vector<std::uint32_t> facets;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      rings.push_back(std::move(pieces[i].ring));
      facets.push_back(order_.pieces[i].facet.value);
    }
    close_cuts(rings, facets);
    for (std::size_t i = 0; i < pieces.size(); ++i) pieces[i].ring = std::move(rings[i]);
  }

  const SceneView& scene_;
  const PaintersOrder& order_;
  const std::vector<Colour>& colours_;
  double opacity_;
  const DrawingOptions& options_;
};

}  // namespace

Drawing paint_on_page(const SceneView& scene, const PaintersOrder& order, const std::vector<Colour>& colours,
                      const LineOptions& lines, const DrawingOptions& options, const PaintingOptions& painting) {
  const FillPainter painter(scene, order, colours, painting.opacity, options);
  const bool with_pieces = !order.pieces.empty() && (painting.paints_lines_with_pieces || !painter.is_opaque());
  std::vector<std::optional<EdgeClass>> asked;
  if (with_pieces) asked = asked_classes(scene.parts(), lines);
  const VisibleLines on_top = with_pieces ? VisibleLines() : visible_lines(scene, lines);
  const VisibleLines bounds = all_edges(scene);
  return draw_with_fills(scene.mesh(), scene.view(), on_top, &bounds, options,
                         [&](const Placement& place) { return painter(place, with_pieces ? &asked : nullptr); });
}

}  // namespace hsr
