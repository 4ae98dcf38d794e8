#include "hsr/tiles/united_lines.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <span>
#include <tuple>
#include <utility>

#include "geometry/error.h"
#include "geometry/plane_intersection.h"
#include "hsr/lines/triangle_occlusion.h"
#include "hsr/scene/facet.h"
#include "hsr/scene/projected_mesh.h"
#include "hsr/symbols/cut_plane.h"
#include "hsr/tiles/tile_lines.h"
#include "hsr/tiles/united_fragments.h"

namespace hsr::internal {

namespace {

/// A piece, and what it runs along: what is sorted by.
struct PieceOfLine {
  std::tuple<int, std::uint32_t, std::uint32_t> along;
  std::uint32_t part, piece;
};

/// Puts the pieces along one edge, or one meeting of facets, together. One object for each block of them.
class PieceUniter {
 public:
  PieceUniter(const std::vector<TilePart>& parts, const Names& names, const ProjectedMesh& projected, bool only_visible)
      : parts_(parts), names_(names), projected_(projected), only_visible_(only_visible), occlusion_(projected) {}

  void add(std::span<const PieceOfLine> group) {
    const LinePiece& first = piece_of(group.front());
    edge_ = EdgeId();
    if (first.is_intersection()) {
      add_intersections(group);
      return;
    }
    edge_ = projected_.mesh().find_edge(names_.vertex(first.a), names_.vertex(first.b));
    if (!edge_.is_valid())
      throw InputError("edge " + std::to_string(first.a) + " " + std::to_string(first.b) +
                       ": found no face of it, expected parts of one model");
    if (!occlusion_.start(edge_)) {
      add_nothing(first);
      return;
    }
    add_runs(group);
  }
  VisibleLines take() { return std::move(result_); }

 private:
  struct Run {
    PieceOfLine of;
    std::vector<Breakpoint> cuts;
    bool starts_hidden = false, goes_on_before = false, goes_on_after = false;
    PieceOfLine last;  // the piece at its end
    bool is_hidden_at_end() const { return ((cuts.size() & 1U) != 0) != starts_hidden; }
  };

  const LinePiece& piece_of(const PieceOfLine& p) const { return parts_[p.part].pieces[p.piece]; }
  Cut cut(const PieceOfLine& p, std::uint32_t k) const { return names_.cut(parts_[p.part].cuts[k]); }
  bool is_side(const Cut& c) const { return names_.name(c).is_side(); }
  bool is_before(const Breakpoint& x, const Breakpoint& y) { return occlusion_.order(x, y) == Sign::negative; }

  Breakpoint place(const Cut& cut) {
    if (cut.kind == Cut::Kind::start) return {cut, 0, 0, Sign::positive};
    if (cut.kind == Cut::Kind::end) return {cut, 1, 0, Sign::positive};
    return occlusion_.place(cut);
  }

  Intersection meet_of(const LinePiece& p) const {
    return {FacetId(names_.triangle(p.s).value), FacetId(names_.triangle(p.t).value), names_.cut(p.meet_from),
            names_.cut(p.meet_to)};
  }

  void add_intersections(std::span<const PieceOfLine> group) {
    meet_ = meet_of(piece_of(group.front()));
    const PlaneIntersection line(projected_.face_plane(meet_.s), projected_.face_plane(meet_.t), occlusion_.exact());
    const auto place = [&](const Cut& cut) { return line.place(cut_plane(projected_, cut)); };
    // All run the same way, and perhaps against the planes' line.
    const Sign way = line.order(place(meet_.from), place(meet_.to));
    for (const PieceOfLine& p : group) {
      const Intersection meet = meet_of(piece_of(p));
      if (line.order(place(meet.from), place(meet_.from)) == way) meet_.from = meet.from;
      if (line.order(place(meet_.to), place(meet.to)) == way) meet_.to = meet.to;
    }
    if (occlusion_.start(meet_)) {
      add_runs(group);
      return;
    }
    std::vector<Intersection> all;
    for (const PieceOfLine& p : group) all.push_back(meet_of(piece_of(p)));
    const auto is_before = [&](const Intersection& x, const Intersection& y) {
      return line.order(place(x.from), place(y.from)) == way;
    };
    std::stable_sort(all.begin(), all.end(), is_before);
    for (std::size_t k = 0; k < all.size(); ++k)
      if (k == 0 || is_before(all[k - 1], all[k])) {
        meet_ = all[k];
        add_nothing(piece_of(group.front()));
      }
  }

  void add_runs(std::span<const PieceOfLine> group) {
    std::vector<Run> runs, bounds;
    for (const PieceOfLine& p : group) {
      const LinePiece& piece = piece_of(p);
      if (piece.end_cut < piece.first_cut + 2)
        throw InputError("tiles: found a line without an image in one tile only, expected parts of one model");
      Run run{p, {}, piece.starts_hidden, piece.goes_on_before, piece.goes_on_after, p};
      for (std::uint32_t k = piece.first_cut; k < piece.end_cut; ++k) run.cuts.push_back(place(cut(p, k)));
      (piece.is_only_bound ? bounds : runs).push_back(std::move(run));
    }
    join(runs);
    // The first of them has the same first end as the line of which they are pieces: a drawing is placed by it.
    std::stable_sort(bounds.begin(), bounds.end(),
                     [&](const Run& x, const Run& y) { return is_before(x.cuts.front(), y.cuts.front()); });
    for (const Run& run : bounds) emit(run);
    for (const Run& run : runs) emit(run);
  }

  void join(std::vector<Run>& runs) {
    const auto kind = [&](const Run& run) { return std::pair(piece_of(run.of).is_behind, piece_of(run.of).edge_class); };
    std::stable_sort(runs.begin(), runs.end(), [&](const Run& x, const Run& y) {
      if (kind(x) != kind(y)) return kind(x) < kind(y);
      return is_before(x.cuts.front(), y.cuts.front());
    });
    std::vector<Run> joined;
    for (Run& run : runs) {
      if (joined.empty() || kind(joined.back()) != kind(run) || !goes_on(joined.back(), run))
        joined.push_back(std::move(run));
      else
        append(joined.back(), run);
    }
    for (const Run& run : joined) {
      check_end(run.of, run.cuts.front().cut, run.goes_on_before);
      check_end(run.last, run.cuts.back().cut, run.goes_on_after);
    }
    std::stable_sort(joined.begin(), joined.end(), [&](const Run& x, const Run& y) {
      if (kind(x).first != kind(y).first) return kind(x).first < kind(y).first;
      return is_before(x.cuts.front(), y.cuts.front());
    });
    runs = std::move(joined);
  }
  bool goes_on(const Run& x, const Run& y) {
    return x.goes_on_after && y.goes_on_before && occlusion_.order(x.cuts.back(), y.cuts.front()) == Sign::zero;
  }
  /// The cut between them goes, unless what is visible ends there.
  void append(Run& run, const Run& next) {
    const Breakpoint at = is_side(run.cuts.back().cut) ? next.cuts.front() : run.cuts.back();
    const bool is_change = run.is_hidden_at_end() != next.starts_hidden;
    if (is_change && is_side(at.cut)) refuse(next.of);
    run.cuts.pop_back();
    if (is_change) run.cuts.push_back(at);
    run.cuts.insert(run.cuts.end(), next.cuts.begin() + 1, next.cuts.end());
    run.goes_on_after = next.goes_on_after;
    run.last = next.last;
  }
  /// Where only what is visible is known, it may end just where the side is, by a name of its own.
  void check_end(const PieceOfLine& of, const Cut& cut, bool goes_on) const {
    if (goes_on && (!only_visible_ || is_side(cut))) refuse(of);
  }
  [[noreturn]] void refuse(const PieceOfLine& of) const { throw TileMismatch(parts_[of.part].tile, "line"); }

  Line begun(const LinePiece& of) {
    Line line;
    line.edge = edge_;
    line.edge_class = of.edge_class;
    line.is_behind = of.is_behind;
    line.is_ghost = of.is_ghost;
    if (!edge_.is_valid()) {
      line.intersection = static_cast<std::uint32_t>(result_.intersections.size());
      result_.intersections.push_back(meet_);
    }
    line.first_cut = line.end_cut = static_cast<std::uint32_t>(result_.cuts.size());
    return line;
  }
  void add_nothing(const LinePiece& of) { result_.lines.push_back(begun(of)); }
  void emit(const Run& run) {
    if (!edge_.is_valid()) {
      meet_.from = run.cuts.front().cut;
      meet_.to = run.cuts.back().cut;
    }
    Line line = begun(piece_of(run.of));
    line.starts_hidden = run.starts_hidden;
    for (const Breakpoint& b : run.cuts) result_.cuts.push_back(b.cut);
    line.end_cut = static_cast<std::uint32_t>(result_.cuts.size());
    result_.lines.push_back(line);
  }

  const std::vector<TilePart>& parts_;
  const Names& names_;
  const ProjectedMesh& projected_;
  bool only_visible_;
  TriangleOcclusion occlusion_;
  EdgeId edge_;  // of the group at hand; not valid: an intersection
  Intersection meet_;
  VisibleLines result_;
};

/// By edge, then those of ghosts, then intersections.
std::vector<PieceOfLine> sorted_pieces(const std::vector<TilePart>& parts) {
  std::vector<PieceOfLine> all;
  for (std::uint32_t p = 0; p < parts.size(); ++p)
    for (std::uint32_t i = 0; i < parts[p].pieces.size(); ++i) {
      const LinePiece& piece = parts[p].pieces[i];
      all.push_back({{piece.is_ghost ? 1 : 0, piece.a, piece.b}, p, i});
    }
  std::stable_sort(all.begin(), all.end(), [](const PieceOfLine& x, const PieceOfLine& y) { return x.along < y.along; });
  return all;
}

/// Intersections last, by their facets.
void sort_intersections(const std::vector<TilePart>& parts, const Names& names, std::vector<PieceOfLine>& all) {
  const auto piece = [&](const PieceOfLine& p) -> const LinePiece& { return parts[p.part].pieces[p.piece]; };
  for (PieceOfLine& p : all)
    if (piece(p).is_intersection()) p.along = {2, names.triangle(piece(p).s).value, names.triangle(piece(p).t).value};
  std::stable_sort(all.begin(), all.end(), [](const PieceOfLine& x, const PieceOfLine& y) { return x.along < y.along; });
}

void append(VisibleLines& all, VisibleLines&& more) {
  check_countable(all.cuts.size() + more.cuts.size(), "interval ends of lines");
  const auto cuts = static_cast<std::uint32_t>(all.cuts.size()), meets = static_cast<std::uint32_t>(all.intersections.size());
  for (Line& line : more.lines) {
    line.first_cut += cuts;
    line.end_cut += cuts;
    if (line.is_intersection()) line.intersection += meets;
    all.lines.push_back(line);
  }
  all.cuts.insert(all.cuts.end(), more.cuts.begin(), more.cuts.end());
  all.intersections.insert(all.intersections.end(), more.intersections.begin(), more.intersections.end());
}

}  // namespace

UnitedTiles united_tiles(std::vector<TilePart> parts, const View& view, const ImageTiles& tiles, bool only_visible) {
  UnitedTiles result;
  std::vector<ModelPart> models;
  for (TilePart& part : parts) models.push_back(std::exchange(part.model, {}));
  result.part = united(std::move(models));
  result.mesh = mesh_with_sides(result.part, tiles);
  const ProjectedMesh projected(result.mesh, view, Arithmetic::staged);
  const Names names(result.part, result.mesh);
  std::vector<PieceOfLine> pieces = sorted_pieces(parts);
  sort_intersections(parts, names, pieces);
  std::vector<std::size_t> groups;  // where each begins
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (i == 0 || pieces[i].along != pieces[i - 1].along) groups.push_back(i);
  groups.push_back(pieces.size());
  constexpr std::size_t block = 256;
  const std::size_t count = groups.size() - 1;
  std::vector<VisibleLines> lines((count + block - 1) / block);
  tbb::parallel_for(std::size_t{0}, lines.size(), [&](std::size_t k) {
    PieceUniter uniter(parts, names, projected, only_visible);
    for (std::size_t g = k * block; g < std::min(count, (k + 1) * block); ++g)
      uniter.add(std::span(pieces).subspan(groups[g], groups[g + 1] - groups[g]));
    lines[k] = uniter.take();
  });
  for (VisibleLines& some : lines) append(result.lines, std::move(some));
  for (const TilePart& part : parts) result.lines.pairs += part.pairs;
  result.fragments = united_fragments(parts, names, projected);
  return result;
}

}  // namespace hsr::internal
