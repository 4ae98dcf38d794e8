#include "hsr/drawing/drawing.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "geometry/bit_range.h"
#include "geometry/error.h"
#include "hsr/drawing/end_images.h"
#include "hsr/drawing/filled_drawing.h"
#include "hsr/drawing/fills.h"
#include "hsr/drawing/fit_arcs.h"
#include "hsr/drawing/image_lines.h"
#include "hsr/drawing/join.h"
#include "hsr/drawing/near_lines.h"
#include "hsr/drawing/overlay.h"
#include "hsr/drawing/pen_order.h"
#include "hsr/drawing/placement.h"
#include "hsr/drawing/reach.h"
#include "hsr/drawing/section_drawing.h"
#include "hsr/drawing/short_chains.h"
#include "hsr/drawing/short_dashes.h"
#include "hsr/drawing/visible_by_class.h"
#include "hsr/view/frustum.h"

namespace hsr {

using namespace internal;

namespace {

Predicates predicates_for(const Mesh& mesh, const View& view, Arithmetic arithmetic) {
  BitRange points = bit_range(mesh.points), direction;
  (view.viewpoint.is_direction ? direction : points).add(view.viewpoint.at);
  // Signs that may be wrong give no order to sort by: a drawing is exact also of lines that are not.
  return Predicates(points, direction, arithmetic == Arithmetic::double_only ? Arithmetic::staged : arithmetic);
}

/// In widths of a line: what is shorter has no room for the dashes of ISO 128 (D16).
constexpr double dashed_from = 9;

/// By line; empty: they are not told apart.
std::vector<std::uint32_t> objects_of_lines(const Mesh& mesh, const VisibleLines& lines, const SceneObjects* objects) {
  std::vector<std::uint32_t> of_line;
  if (objects == nullptr || !objects->are_told_apart()) return of_line;
  of_line.resize(lines.lines.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, of_line.size(), 1024), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i)
      of_line[i] = object_of(*objects, lines.lines[i], faces_at(mesh, lines, lines.lines[i]));
  });
  return of_line;
}

/// Those of one object together, as nothing of them overlaps.
void tell_apart(Fills& fills, const SceneObjects& objects) {
  for (Fill& fill : fills.fills) {
    std::vector<FaceId> faces;
    for (std::uint32_t k = fill.first_face; k < fill.end_face; ++k) faces.emplace_back(fills.faces[k]);
    fill.object = objects.object_of(faces);
  }
  std::stable_sort(fills.fills.begin(), fills.fills.end(), [](const Fill& a, const Fill& b) { return a.object < b.object; });
}

/// Lines whose image is not a point, and that neither the near plane nor the frame leaves out.
std::vector<std::uint32_t> seen_lines(const Mesh& mesh, const View& view, const VisibleLines& lines,
                                      const DrawingOptions& options) {
  std::vector<std::uint32_t> seen;
  for (std::uint32_t i = 0; i < lines.lines.size(); ++i)
    if (lines.lines[i].intervals() > 0) seen.push_back(i);
  if (const auto frame = frame_size(view, options)) {
    // Whether `lines` was told of the frame or not, the drawing is the same.
    const ViewFrustum outside(mesh, view, *frame);
    std::erase_if(seen, [&](std::uint32_t i) {
      return !lines.lines[i].is_intersection() && outside.contains(mesh.edges[lines.lines[i].edge]);
    });
  }
  return seen;
}

Overlay lay_over(const ImageLines& groups, const Projection& projection, const VisibleLines& lines,
                 const std::vector<std::uint32_t>& object_of_line, bool with_hidden,
                 tbb::enumerable_thread_specific<Predicates>& predicates) {
  constexpr std::size_t chunk = 512;
  std::vector<Overlay> parts((groups.members.size() + chunk - 1) / chunk);
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t c) {
    LineOverlay overlay(projection, lines, object_of_line, with_hidden, predicates.local());
    for (std::size_t g = c * chunk; g < std::min(groups.members.size(), (c + 1) * chunk); ++g) {
      if (groups.members[g].size() == 1)
        overlay.add_single(groups.members[g].front(), parts[c]);
      else
        overlay.add_group(groups.members[g], groups.steep[groups.members.begin(g)] != 0, parts[c]);
    }
  });
  Overlay all;
  for (const Overlay& part : parts) all.append(part);
  return all;
}

/// The stroke on the paper; nothing if it is outside the frame.
class Placer {
 public:
  Placer(const Placement& placement, const EndImages& at, const VisibleLines& lines)
      : projection_(placement.projection), frame_(placement.frame), at_(at), lines_(lines) {}

  std::optional<PaperLine> operator()(const Stroke& stroke) const {
    HomogeneousPoint from = image(stroke.from), to = image(stroke.to);
    bool from_is_cut = false, to_is_cut = false;
    if (frame_ && !clip(from, to, from_is_cut, to_is_cut)) return {};
    PaperLine line;
    line.from = from_is_cut ? on_frame(from) : rounded(stroke.from, from);
    line.to = to_is_cut ? on_frame(to) : rounded(stroke.to, to);
    line.style = (stroke.hidden ? 0U : 16U) + static_cast<std::uint32_t>(stroke.edge_class);
    line.object = stroke.object;
    return line;
  }

 private:
  using Wide = Enclosure::Wide;

  SupportingLine supporting_line_of(const PlaceOnEdge& p) const {
    return hsr::supporting_line_of(projection_.mesh(), lines_, lines_.lines[p.line]);
  }
  HomogeneousPoint image(const PlaceOnEdge& p) const {
    const Cut& cut = lines_.cuts[p.cut];
    const SupportingLine support = supporting_line_of(p);
    if (cut.kind == Cut::Kind::start) return at_[support.a];
    if (cut.kind == Cut::Kind::end) return at_[support.b];
    return support.is_edge() ? projection_.bounded_at(support, cut, at_[support.a], at_[support.b])
                             : projection_.at(support, cut);
  }
  PaperPoint rounded(const PlaceOnEdge& p, const HomogeneousPoint& at) const {
    return projection_.rounded(supporting_line_of(p), lines_.cuts[p.cut], at);
  }
  PaperPoint on_frame(const HomogeneousPoint& p) const {
    const Wide x = std::clamp<Wide>(p.x.middle / p.w.middle, frame_->left, frame_->right);
    const Wide y = std::clamp<Wide>(p.y.middle / p.w.middle, frame_->top, frame_->bottom);
    return {static_cast<std::int64_t>(std::round(x * 1000)), static_cast<std::int64_t>(std::round(y * 1000))};
  }
  /// Liang and Barsky's, on the homogeneous points. The paper ends here: this places an end on the frame, and decides nothing
  /// else.
  bool clip(HomogeneousPoint& from, HomogeneousPoint& to, bool& from_is_cut, bool& to_is_cut) const {
    const auto inside = [&](const HomogeneousPoint& p) {
      const Wide x = p.x.middle, y = p.y.middle, w = p.w.middle;
      return std::array<Wide, 4>{x - frame_->left * w, frame_->right * w - x, y - frame_->top * w, frame_->bottom * w - y};
    };
    const auto a = inside(from), b = inside(to);
    Wide low = 0, high = 1;
    for (std::size_t k = 0; k < 4; ++k) {
      if (a[k] < 0 && b[k] < 0) return false;
      if (a[k] < 0) low = std::max(low, a[k] / (a[k] - b[k]));
      if (b[k] < 0) high = std::min(high, a[k] / (a[k] - b[k]));
    }
    if (!(low < high)) return false;
    const auto between = [&](Wide t) {
      const auto mix = [&](const Enclosure& p, const Enclosure& q) {
        return Enclosure(p.middle + t * (q.middle - p.middle), 0);
      };
      return HomogeneousPoint{mix(from.x, to.x), mix(from.y, to.y), mix(from.w, to.w)};
    };
    from_is_cut = low > 0;
    to_is_cut = high < 1;
    const HomogeneousPoint p = from_is_cut ? between(low) : from, q = to_is_cut ? between(high) : to;
    from = p;
    to = q;
    return true;
  }

  const Projection& projection_;
  std::optional<PaperFrame> frame_;
  const EndImages& at_;
  const VisibleLines& lines_;
};

double length_of(std::span<const PaperPoint> points, bool closed) {
  double length = 0;
  for (std::size_t k = 0; k + 1 < points.size(); ++k)
    length +=
        std::hypot(static_cast<double>(points[k + 1].x - points[k].x), static_cast<double>(points[k + 1].y - points[k].y));
  if (closed && !points.empty())
    length += std::hypot(static_cast<double>(points.front().x - points.back().x),
                         static_cast<double>(points.front().y - points.back().y));
  return length;
}

/// Each ring as a closed outline of no edge and no face.
/// @param rings as fills has them; nullptr, or rings of which the frame cut something off: no edges for arcs
void add_outlines(Drawing& drawing, const Fills& fills, const Ragged<MapCorner>* rings, EdgesOfLines& edges) {
  for (const Fill& fill : fills.fills)
    for (std::uint32_t r = fill.first_ring; r < fill.end_ring; ++r) {
      const auto ring = fills.rings[r];
      if (ring.empty() || length_of(ring, true) < least_on_paper) {
        ++drawing.short_dropped;
        continue;
      }
      Polyline p;
      p.closed = true;
      p.first_point = static_cast<std::uint32_t>(drawing.points.size());
      drawing.points.insert(drawing.points.end(), ring.begin(), ring.end());
      p.end_point = static_cast<std::uint32_t>(drawing.points.size());
      drawing.polylines.push_back(p);
      const bool has_corners = rings != nullptr && (*rings)[r].size() == ring.size();
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const MapLine line = has_corners ? (*rings)[r][k].line : MapLine{MapLine::Kind::near, 0, 0};
        if (line.kind == MapLine::Kind::edge) edges.rows.push_back({VertexId(line.u), VertexId(line.v)});
        edges.end_line();
      }
    }
}

/// Fills in the polylines from the chains of strokes.
class Collector {
 public:
  /// @param edges_of_lines what arcs are found by; nullptr: nothing
  Collector(Drawing& drawing, const Mesh& mesh, const VisibleLines& lines, const Overlay& overlay, EdgesOfLines* edges_of_lines)
      : drawing_(drawing), mesh_(mesh), lines_(lines), overlay_(overlay), edges_of_lines_(edges_of_lines) {}

  /// @param of_line the stroke of each line of the paper before any was left out near another
  void add(std::span<const std::uint32_t> passes, bool closed, const DistinctLines& distinct,
           const std::vector<std::uint32_t>& of_line) {
    const std::vector<PaperLine>& paper = distinct.lines;
    std::vector<PaperPoint>& points = drawing_.points;
    Polyline p;
    p.closed = closed;
    p.first_point = static_cast<std::uint32_t>(points.size());
    for (const std::uint32_t pass : passes) points.push_back((pass & 1U) != 0 ? paper[pass / 2].to : paper[pass / 2].from);
    if (!closed) points.push_back((passes.back() & 1U) != 0 ? paper[passes.back() / 2].from : paper[passes.back() / 2].to);
    p.end_point = static_cast<std::uint32_t>(points.size());
    if (length_of(drawing_.points_of(p), closed) < least_on_paper) {
      ++drawing_.short_dropped;
      points.resize(p.first_point);
      return;
    }
    const Stroke& first = overlay_.strokes[of_line[distinct.part_of[passes.front() / 2]]];
    p.hidden = first.hidden;
    p.edge_class = first.edge_class;
    p.object = paper[passes.front() / 2].object;
    add_sources(p, passes, distinct, of_line);
    drawing_.polylines.push_back(p);
    if (edges_of_lines_ == nullptr) return;
    for (const std::uint32_t pass : passes) {
      add_edges_of(overlay_.strokes[of_line[distinct.part_of[pass / 2]]]);
      edges_of_lines_->end_line();
    }
    if (!closed) edges_of_lines_->end_line();  // no line begins at the last point
  }

 private:
  void add_edges_of(const Stroke& stroke) {
    for (std::uint32_t s = stroke.first_source; s < stroke.end_source; ++s) {
      const Line& source = lines_.lines[overlay_.sources[s]];
      if (!source.is_intersection()) edges_of_lines_->rows.push_back({mesh_.edges[source.edge].a, mesh_.edges[source.edge].b});
    }
  }
  void add_sources(Polyline& p, std::span<const std::uint32_t> passes, const DistinctLines& distinct,
                   const std::vector<std::uint32_t>& of_line) {
    edges_.clear();
    faces_.clear();
    const auto add_edges = [&](std::uint32_t line) {
      const Stroke& stroke = overlay_.strokes[of_line[line]];
      for (std::uint32_t s = stroke.first_source; s < stroke.end_source; ++s) {
        const Line& source = lines_.lines[overlay_.sources[s]];
        if (!source.is_intersection()) edges_.push_back(source.edge);
        for (const FaceId f : faces_at(mesh_, lines_, source)) faces_.push_back(f.value);
      }
    };
    for (const std::uint32_t pass : passes) {
      add_edges(distinct.part_of[pass / 2]);
      const auto& pairs = distinct.stands_for;
      auto pair = std::lower_bound(pairs.begin(), pairs.end(), std::array<std::uint32_t, 2>{pass / 2, 0});
      for (; pair != pairs.end() && (*pair)[0] == pass / 2; ++pair) add_edges((*pair)[1]);
    }
    sort_unique(edges_);
    p.first_edge = static_cast<std::uint32_t>(drawing_.edges.size());
    for (const EdgeId e : edges_) drawing_.edges.push_back({mesh_.edges[e].a.value, mesh_.edges[e].b.value});
    p.end_edge = static_cast<std::uint32_t>(drawing_.edges.size());
    sort_unique(faces_);
    p.first_face = static_cast<std::uint32_t>(drawing_.faces.size());
    drawing_.faces.insert(drawing_.faces.end(), faces_.begin(), faces_.end());
    check_countable(std::max({drawing_.points.size(), drawing_.edges.size(), drawing_.faces.size()}), "entries of a drawing");
    p.end_face = static_cast<std::uint32_t>(drawing_.faces.size());
  }

  template <class T>
  static void sort_unique(std::vector<T>& v) {
    std::sort(v.begin(), v.end());
    v.erase(std::unique(v.begin(), v.end()), v.end());
  }

  std::vector<EdgeId> edges_;
  std::vector<std::uint32_t> faces_;
  Drawing& drawing_;
  const Mesh& mesh_;
  const VisibleLines& lines_;
  const Overlay& overlay_;
  EdgesOfLines* edges_of_lines_;
};

/// The chains by style and object, without those in groups that are too short.
/// @param shortest thousandths of a millimetre
void collect(Drawing& drawing, Collector collector, const Chains& chains, const DistinctLines& distinct,
             const std::vector<std::uint32_t>& of_line, double shortest) {
  std::vector<std::uint32_t> order(chains.passes.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const PaperLine &x = distinct.lines[chains.passes[a].front() / 2], &y = distinct.lines[chains.passes[b].front() / 2];
    return std::pair(x.style, x.object) < std::pair(y.style, y.object);
  });
  std::vector<std::uint8_t> is_short(chains.passes.size(), 0);
  if (shortest > 0) is_short = in_short_groups(distinct.lines, chains, shortest);
  for (const std::uint32_t c : order) {
    if (is_short[c] != 0) {
      ++drawing.groups_dropped;
      continue;
    }
    collector.add(chains.passes[c], chains.closed[c] != 0, distinct, of_line);
  }
}

/// Puts the lines of a section with those of their class that are no border of a cap, so that each class is one layer.
void gather_by_class(Drawing& drawing) {
  std::stable_sort(drawing.polylines.begin(), drawing.polylines.end(), [](const Polyline& a, const Polyline& b) {
    return std::tuple(!a.hidden, a.edge_class, a.object) < std::tuple(!b.hidden, b.edge_class, b.object);
  });
}

/// What is done with the polylines once they are there.
/// @param unit millimetres in what the options are in
void finish(Drawing& drawing, const DrawingOptions& options, const Projection& projection, EdgesOfLines& edges, double unit) {
  const bool fits = options.fit_arcs > 0;
  while (fits && edges.row_of_line.size() < drawing.points.size()) edges.end_line();  // of a section: no edge
  if (options.sort_for_pen) {
    const std::vector<std::uint32_t> line_before = sort_for_pen(drawing);
    std::vector<std::uint32_t> rows;
    if (fits)
      for (const std::uint32_t line : line_before) rows.push_back(edges.row_of_line[line]);
    edges.row_of_line = std::move(rows);
  }
  if (!fits) return;
  const MarkedCircles known = options.labels == nullptr ? MarkedCircles() : MarkedCircles(projection.mesh(), *options.labels);
  fit_arcs(drawing, projection, known, edges, options.fit_arcs * unit, options.sort_for_pen);
}

}  // namespace

Drawing draw(const Mesh& mesh, const View& view, const VisibleLines& lines, const DrawingOptions& options,
             const Regions* regions) {
  std::function<Fills(const Placement&)> fills;
  if (regions != nullptr)
    fills = [&](const Placement& place) {
      Fills placed = placed_fills(place, *regions);
      if (options.outline_only) return placed;
      if (options.objects != nullptr && options.objects->are_told_apart()) tell_apart(placed, *options.objects);
      add_section_fills(placed, place, options);
      reach_beneath(placed);
      return placed;
    };
  return draw_with_fills(mesh, view, lines, nullptr, options, fills, regions == nullptr ? nullptr : &regions->rings);
}

namespace internal {

Drawing draw_with_fills(const Mesh& mesh, const View& view, const VisibleLines& given, const VisibleLines* bounds,
                        const DrawingOptions& options, const std::function<Fills(const Placement&)>& fills,
                        const Ragged<MapCorner>* rings) {
  std::vector<std::uint32_t> seen = seen_lines(mesh, view, given, options);

  std::vector<std::uint32_t> bounding(bounds == nullptr ? 0 : bounds->lines.size());
  std::iota(bounding.begin(), bounding.end(), 0U);
  const Placement place =
      bounds == nullptr ? placement(mesh, view, given, seen, options) : placement(mesh, view, *bounds, bounding, options);
  Drawing drawing;
  drawing.width = place.width;
  drawing.height = place.height;
  drawing.scale = place.scale;
  drawing.fits = place.fits;
  drawing.pens = Pens(line_group(options.page), options.hidden);
  drawing.pens.set(options.pens);

  EdgesOfLines edges;
  const double unit = options.in_frame_units ? drawing.scale : 1;
  if (options.outline_only) {
    if (fills) add_outlines(drawing, fills(place), rings, edges);
    finish(drawing, options, place.projection, edges, unit);
    return drawing;
  }
  const bool with_hidden = options.hidden != HiddenLines::none;
  const std::optional<VisibleLines> merged = with_hidden ? std::nullopt : visible_by_class(mesh, view, given);
  const VisibleLines& lines = merged ? *merged : given;
  if (merged) seen = seen_lines(mesh, view, lines, options);
  const std::vector<std::uint32_t> object_of_line = objects_of_lines(mesh, lines, options.objects);
  const bool tells_objects = options.objects != nullptr && options.objects->are_told_apart();
  if (tells_objects) drawing.objects = options.objects->names;
  if (fills) drawing.fills = fills(place);

  if (!with_hidden)
    std::erase_if(seen, [&](std::uint32_t i) { return lines.lines[i].starts_hidden && lines.lines[i].intervals() == 1; });

  const Projection& projection = place.projection;
  EndImages at(projection, lines, seen);
  tbb::enumerable_thread_specific<Predicates> predicates(predicates_for(mesh, view, options.arithmetic));
  const Overlay overlay = lay_over(image_lines(projection, at, lines, seen, predicates.local()), projection, lines,
                                   object_of_line, with_hidden, predicates);
  for (const Predicates& p : predicates) drawing.decisions += p.counts();
  drawing.visible_under_visible = overlay.visible_under_visible;
  drawing.hidden_under_visible = overlay.hidden_under_visible;
  drawing.hidden_under_hidden = overlay.hidden_under_hidden;
  drawing.merged = overlay.merged;

  constexpr std::size_t most_strokes = 0x7fffffff;  // their ends are numbered in 32 bits
  if (overlay.strokes.size() > most_strokes)
    throw InputError("the drawing has " + std::to_string(overlay.strokes.size()) + " strokes, expected fewer than 2^31");
  std::vector<std::optional<PaperLine>> placed(overlay.strokes.size());
  const Placer placer(place, at, lines);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, placed.size(), 256), [&](const auto& range) {
    for (std::size_t k = range.begin(); k != range.end(); ++k) placed[k] = placer(overlay.strokes[k]);
  });
  std::vector<PaperLine> paper;
  std::vector<std::uint32_t> of_line;
  for (std::uint32_t k = 0; k < placed.size(); ++k) {
    if (!placed[k]) continue;
    if (placed[k]->from == placed[k]->to) {  // nothing of it on the paper; its neighbours meet there all the same
      ++drawing.short_dropped;
      continue;
    }
    paper.push_back(*placed[k]);
    of_line.push_back(k);
  }
  // Large, and done with: what follows takes as much again.
  placed = {};
  at = {};

  Chains chains = join(paper);
  if (tells_objects && with_hidden) {
    const double millimetre = (options.in_frame_units ? drawing.scale / options.hatch_scale : 1) * 1000;
    const auto shortest = [&](std::uint32_t style) {
      const Pen& pen = drawing.pens.of(style < 16, static_cast<EdgeClass>(style % 16));
      return pen.is_dashed() ? dashed_from * pen.width * millimetre : 0.0;
    };
    if (share_short_dashes(paper, chains, shortest)) chains = join(paper);
  }
  DistinctLines distinct;
  if (options.leave_out_near) distinct = without_near(paper, chains);
  drawing.near_coincident = distinct.near_coincident;
  if (distinct.near_coincident > 0) {
    chains = join(distinct.lines);
  } else {
    distinct.lines = std::move(paper);
    distinct.part_of.resize(distinct.lines.size());
    std::iota(distinct.part_of.begin(), distinct.part_of.end(), 0U);
  }
  collect(drawing, Collector(drawing, mesh, lines, overlay, options.fit_arcs > 0 ? &edges : nullptr), chains, distinct, of_line,
          options.min_length * 1000 * unit);
  add_section_lines(drawing, place, options);
  if (options.section != nullptr) gather_by_class(drawing);
  finish(drawing, options, projection, edges, unit);
  return drawing;
}

}  // namespace internal

}  // namespace hsr
