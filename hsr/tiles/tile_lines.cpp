#include "hsr/tiles/tile_lines.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "geometry/error.h"
#include "hsr/drawing/placement.h"
#include "hsr/lines/plan.h"
#include "hsr/lines/triangle_occlusion.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/scene/view_parts.h"
#include "hsr/surfaces/visible_fragments.h"
#include "hsr/symbols/cut_plane.h"
#include "hsr/tiles/tile_fragments.h"
#include "hsr/tiles/used_parts.h"

namespace hsr::internal {

namespace {

class TileClipper {
 public:
  /// @param used is told what of the model the pieces name
  TileClipper(const Names& names, const SceneView& scene, const std::vector<TileBound>& bounds, bool only_visible,
              UsedParts& used)
      : mesh_(scene.mesh()),
        projected_(scene.parts().projected()),
        names_(names),
        bounds_(bounds),
        only_visible_(only_visible),
        occlusion_(projected_),
        used_(used) {
    for (const TileBound& b : bounds_) planes_.push_back(cut_plane(projected_, names_.side(b.side)));
  }

  void add(const VisibleLines& lines, const Line& line) {
    if (line.intervals() == 0) {
      if (!only_visible_ && (line.is_intersection() || may_be_in_tile(mesh_.edges[line.edge]))) begin(lines, line);
      return;
    }
    const bool is_seen =
        line.is_intersection() ? occlusion_.start(lines.intersections[line.intersection]) : occlusion_.start(line.edge);
    if (!is_seen) throw InvariantError("tiles: a line without an image has intervals");
    places_.clear();
    for (const Cut& cut : lines.cuts_of(line)) places_.push_back(place(cut));
    Breakpoint from = places_.front(), to = places_.back();
    for (std::size_t k = 0; k < bounds_.size(); ++k) {
      if (bounds_[k].kept == Sign::negative && runs_in(k, lines, line)) return;
      if (!occlusion_.keep(names_.side(bounds_[k].side), bounds_[k].kept, from, to)) return;
    }
    add_clipped(lines, line, from, to);
    if (only_visible_) add_bound(lines, line, from.cut, to.cut);
  }
  /// Whether an edge may reach into the tile.
  bool may_be_in_tile(const Edge& e) {
    for (std::size_t k = 0; k < bounds_.size(); ++k) {
      const Sign a = projected_.side(planes_[k], e.a, occlusion_.exact()),
                 b = projected_.side(planes_[k], e.b, occlusion_.exact());
      if (a == b && a == -bounds_[k].kept) return false;
    }
    return true;
  }
  /// Adds those that tell how large the drawing is. @param lines that were added
  void add_bounds(const View& view, const VisibleLines& lines) {
    std::vector<std::uint32_t> all(bounding_.lines.size());
    for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
    bounding_.intersections = lines.intersections;
    for (const std::uint32_t i : bounding_lines(mesh_, view, bounding_, all)) {
      const Line& line = bounding_.lines[i];
      LinePiece& piece = begin(bounding_, line);
      piece.is_only_bound = piece.starts_hidden = true;
      for (const Cut& cut : bounding_.cuts_of(line)) push(cut);
      piece.end_cut = static_cast<std::uint32_t>(part_.cuts.size());
    }
  }
  TilePart take() { return std::move(part_); }

 private:
  Breakpoint place(const Cut& cut) {
    if (cut.kind == Cut::Kind::start) return {cut, 0, 0, Sign::positive};
    if (cut.kind == Cut::Kind::end) return {cut, 1, 0, Sign::positive};
    return occlusion_.place(cut);
  }
  bool is_before(const Breakpoint& x, const Breakpoint& y) { return occlusion_.order(x, y) == Sign::negative; }
  bool is_side(const Cut& cut) const { return names_.name(cut).is_side(); }

  bool runs_in(std::size_t bound, const VisibleLines& lines, const Line& line) {
    if (!line.is_intersection()) {
      const Edge& e = mesh_.edges[line.edge];
      return projected_.side(planes_[bound], e.a, occlusion_.exact()) == Sign::zero &&
             projected_.side(planes_[bound], e.b, occlusion_.exact()) == Sign::zero;
    }
    const Intersection& meet = lines.intersections[line.intersection];
    const Plane s = projected_.face_plane(meet.s), t = projected_.face_plane(meet.t);
    return occlusion_.exact().side(planes_[bound], s, t, cut_plane(projected_, meet.from)) == Sign::zero &&
           occlusion_.exact().side(planes_[bound], s, t, cut_plane(projected_, meet.to)) == Sign::zero;
  }

  LinePiece& begin(const VisibleLines& lines, const Line& line) {
    LinePiece piece;
    piece.is_ghost = line.is_ghost;
    piece.is_behind = line.is_behind;
    piece.edge_class = line.edge_class;
    piece.first_cut = piece.end_cut = static_cast<std::uint32_t>(part_.cuts.size());
    if (line.is_intersection()) {
      const Intersection& meet = lines.intersections[line.intersection];
      piece.s = names_.name(first_triangle(meet.s));
      piece.t = names_.name(first_triangle(meet.t));
      used_.add(first_triangle(meet.s), mesh_);
      used_.add(first_triangle(meet.t), mesh_);
      piece.meet_from = named(meet.from);
      piece.meet_to = named(meet.to);
    } else {
      add_edge(piece, mesh_.edges[line.edge], line);
    }
    part_.pieces.push_back(piece);
    return part_.pieces.back();
  }
  void add_edge(LinePiece& piece, const Edge& e, const Line& line) {
    piece.a = names_.number(e.a);
    piece.b = names_.number(e.b);
    used_.add(e.a);
    used_.add(e.b);
    if (e.wire) used_.add_wires_along(e);
    for (const TriangleId t : mesh_.triangles_at(line.edge)) used_.add(t, mesh_);
    if (line.is_ghost)
      for (const TriangleId t : mesh_.ghosts->triangles_at(mesh_.ghosts->find_edge(e.a, e.b))) used_.add(t, *mesh_.ghosts);
  }
  NamedCut named(const Cut& cut) {
    const NamedCut name = names_.name(cut);
    if (name.is_side()) return name;
    switch (cut.kind) {
      case Cut::Kind::face:
      case Cut::Kind::near_line:
        used_.add(TriangleId(cut.u), mesh_);
        break;
      case Cut::Kind::sight:
      case Cut::Kind::line:
      case Cut::Kind::near_line_end:
        used_.add(VertexId(cut.v));
        [[fallthrough]];
      case Cut::Kind::sight_of_vertex:
      case Cut::Kind::across:
        used_.add(VertexId(cut.u));
        break;
      default:
        break;
    }
    return name;
  }
  void push(const Cut& cut) { part_.cuts.push_back(named(cut)); }

  /// The intervals between two places; where one ends at a side and the visibility changes just there, the cut has its own name.
  void add_clipped(const VisibleLines& lines, const Line& line, const Breakpoint& from, const Breakpoint& to) {
    LinePiece* open = nullptr;
    const auto close = [&](const Cut& cut, bool goes_on) {
      push(cut);
      open->end_cut = static_cast<std::uint32_t>(part_.cuts.size());
      open->goes_on_after = goes_on;
    };
    for (std::uint32_t k = 0; k + 1 < places_.size(); ++k) {
      const bool is_first = !is_before(from, places_[k]), is_last = !is_before(places_[k + 1], to);
      if (!is_before(from, places_[k + 1]) || !is_before(places_[k], to)) continue;
      if (only_visible_ && line.hidden(k)) continue;
      const bool begins_there = is_first && is_before(places_[k], from);  // within the interval
      const bool ends_there = is_last && is_before(to, places_[k + 1]);
      if (open == nullptr || only_visible_) {
        open = &begin(lines, line);
        open->starts_hidden = line.hidden(k);
        open->goes_on_before = is_first && is_side(from.cut);
        push(begins_there ? from.cut : places_[k].cut);
      }
      const Cut& end = ends_there ? to.cut : places_[k + 1].cut;
      if (only_visible_ || is_last)
        close(end, is_last && is_side(to.cut));
      else
        push(end);
    }
  }
  void add_bound(const VisibleLines& lines, const Line& line, const Cut& from, const Cut& to) {
    Line bound = line;
    bound.first_cut = static_cast<std::uint32_t>(bounding_.cuts.size());
    bounding_.cuts.push_back(from);
    bounding_.cuts.push_back(to);
    bound.end_cut = bound.first_cut + 2;
    static_cast<void>(lines);
    bounding_.lines.push_back(bound);
  }

  const Mesh& mesh_;
  const ProjectedMesh& projected_;
  const Names& names_;
  const std::vector<TileBound>& bounds_;
  std::vector<Plane> planes_;
  bool only_visible_;
  TriangleOcclusion occlusion_;
  UsedParts& used_;
  std::vector<Breakpoint> places_;
  TilePart part_;
  VisibleLines bounding_;
};

}  // namespace

namespace {

bool is_in_order(const Edge& x, const Edge& y) { return std::pair(x.a, x.b) < std::pair(y.a, y.b); }

/// @param more some without faces, ascending but for equal ones
void add_edges_of_nothing(Mesh& mesh, std::vector<Edge>& more) {
  std::stable_sort(more.begin(), more.end(), is_in_order);
  IndexedVector<EdgeId, Edge> edges;
  IndexedVector<EdgeId, std::uint32_t> first_side;
  edges.reserve(mesh.edges.size() + more.size());
  first_side.reserve(edges.capacity() + 1);
  std::size_t next = 0;
  const auto add_before = [&](const Edge* e, std::uint32_t side) {
    for (; next < more.size() && (e == nullptr || is_in_order(more[next], *e)); ++next) {
      if (!edges.empty() && edges.back().a == more[next].a && edges.back().b == more[next].b) continue;
      edges.push_back(more[next]);
      first_side.push_back(side);
    }
    if (e != nullptr && next < more.size() && !is_in_order(*e, more[next])) ++next;  // it is there
  };
  for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
    const EdgeId id(i);
    add_before(&mesh.edges[id], mesh.first_side[id]);
    edges.push_back(mesh.edges[id]);
    first_side.push_back(mesh.first_side[id]);
  }
  add_before(nullptr, mesh.first_side.back());
  first_side.push_back(mesh.first_side.back());
  mesh.edges = std::move(edges);
  mesh.first_side = std::move(first_side);
}

}  // namespace

namespace {

struct TileLines {
  VisibleLines lines;  // those that are asked for
  std::vector<EdgeId> in_doubt;
  std::optional<VisibleLines> every_line;  // where they bound the fragments
};

/// As hsr draw finds them: fragments are bounded by the lines of all edges, and where these serve, the drawing takes some of them.
TileLines found_lines(const SceneView& scene, const TileRequest& request) {
  TileLines found;
  if (request.fragments && request.lines.method != LineMethod::roberts && scene.labels().shape.empty() &&
      fragments_use_lines(scene)) {
    LineOptions every = request.lines;
    every.classes.fill(true);
    every.diagonals = true;
    found.every_line = visible_lines_and_doubts(scene, every, found.in_doubt);
    // Of an edge in doubt the class may be one that is not asked for.
    if (found.in_doubt.empty()) {
      found.lines = lines_of_classes(scene.mesh(), *found.every_line, request.lines.classes);
      return found;
    }
    found.every_line.reset();
  }
  found.lines = visible_lines_and_doubts(scene, request.lines, found.in_doubt);
  return found;
}

}  // namespace

void check_tile_request(const View& view, const TileRequest& request) {
  if (view.has_section() || view.has_cells())
    throw InputError("section: its caps are of whole bodies, expected a view without a section: hsr draw cuts in one piece");
  if (request.lines.tolerance > 0)
    throw InputError("tolerance: noise is told along whole edges, expected none: hsr draw takes it in one piece");
  if (request.lines.crease_goes_on)
    throw InputError("crease: a second angle follows edges through the whole model, expected one angle");
  if (request.lines.why) throw InputError("why: the faces that hide are named along whole edges, expected lines without them");
  if (request.scene.arithmetic != Arithmetic::staged)
    throw InputError("arithmetic: compared in one piece only, expected staged");
  const auto wants = [&](EdgeClass c) { return request.lines.classes[static_cast<std::size_t>(c)]; };
  if (request.only_visible && wants(EdgeClass::intersection) && !(wants(EdgeClass::outline) && wants(EdgeClass::boundary)))
    throw InputError("edges: found intersection without outline and boundary, which bound the drawing, expected these, too");
}

Mesh mesh_with_sides(const ModelPart& part, const ImageTiles& tiles) {
  std::vector<Point3> points = part.model.points;
  for (const ImageTiles::Side& side : tiles.sides) {
    points.push_back(side.c);
    points.push_back(side.d);
  }
  const auto first = static_cast<std::uint32_t>(part.model.points.size()), last = static_cast<std::uint32_t>(points.size());
  Mesh mesh = make_mesh(std::move(points), part.model.polygons);
  // Edges of nothing tell that their ends are in use: a cut may be named by them.
  std::vector<char> is_used(last, 0);
  for (const Edge& e : mesh.edges) is_used[e.a.value] = is_used[e.b.value] = 1;
  std::vector<Edge> more;
  for (std::uint32_t v = 0; v < first; ++v)
    if (is_used[v] == 0 && last > 1)
      more.push_back(v + 1 < last ? Edge{VertexId(v), VertexId(v + 1)} : Edge{VertexId(v - 1), VertexId(v)});
  for (std::uint32_t v = first; v < last; v += 2) more.push_back({VertexId(v), VertexId(v + 1)});
  add_edges_of_nothing(mesh, more);
  return mesh;
}

TilePart lines_of_tile(const ModelPart& part, const View& view, const ImageTiles& tiles, std::uint32_t tile,
                       const TileRequest& request) {
  check_tile_request(view, request);
  const Mesh mesh = mesh_with_sides(part, tiles);
  SceneOptions options = request.scene;
  options.hidden_lines = !request.only_visible;
  const SceneView scene(Scene::of(mesh, labels_of(part.model)), view, options);
  const TileLines found = found_lines(scene, request);
  const std::vector<TileBound> bounds = tiles.bounds(tile);
  const Names names(part, mesh);
  UsedParts used(part);
  TileClipper clipper(names, scene, bounds, request.only_visible, used);
  const auto is_nothing = [&](EdgeId e) {
    if (!e.is_valid()) return false;
    const Edge& edge = mesh.edges[e];
    return !edge.of_face && !edge.diagonal && !edge.wire && !edge.ghost;
  };
  for (const EdgeId e : found.in_doubt)
    if (const Edge& edge = mesh.edges[e]; !is_nothing(e) && clipper.may_be_in_tile(edge))
      throw InputError(
          "edge " + std::to_string(part.points[edge.a.value]) + " " + std::to_string(part.points[edge.b.value]) +
          ": as many faces coincide all around it, and only whole bodies tell whether these touch, expected a drawing "
          "without hidden lines, or hsr draw in one piece");
  for (const Line& line : found.lines.lines)
    if (!is_nothing(line.edge)) clipper.add(found.lines, line);
  if (request.only_visible) clipper.add_bounds(view, found.lines);
  TilePart result = clipper.take();
  if (request.fragments) {
    FragmentOptions of_fragments;
    if (found.every_line) of_fragments.lines = &*found.every_line;
    of_fragments.stop = request.lines.stop;
    result.fragments =
        bytes_of(fragments_in_tile(scene, visible_fragments(scene, of_fragments), bounds, names), mesh, names, used);
  }
  result.model = used.part(mesh);
  result.tile = tile;
  result.pairs = found.lines.pairs;
  return result;
}

}  // namespace hsr::internal
