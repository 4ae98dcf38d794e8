#include "hsr/lines/lines_in_cells.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "geometry/plane_intersection.h"
#include "hsr/lines/hidden_intervals.h"
#include "hsr/scene/view_parts.h"
#include "hsr/symbols/cut_plane.h"

namespace hsr::internal {

namespace {

/// What runs along one edge, or where two facets meet: the order of lines in a result.
struct LineOfCell {
  std::tuple<int, std::uint32_t, std::uint32_t> along;
  std::uint32_t cell, line;
};

/// Lays the lines of all cells along one edge, or one meeting of facets, over one another. One object for each block of them.
class LineUniter {
 public:
  LineUniter(const ProjectedMesh& projected, const std::vector<LinesOfCell>& cells, const LineOptions& options)
      : projected_(projected), cells_(cells), intervals_(projected, options) {}

  void add(std::span<const LineOfCell> group) {
    runs_.clear();
    const bool is_turned = turn_to(group);
    if (is_turned)
      for (const LineOfCell& one : group) add_parts(one);
    const Line& first = line_of(group.front());
    if (runs_.empty() && !first.is_intersection()) {
      intervals_.add_nothing(LineTask(first, {Cut::Kind::start}, {Cut::Kind::end}));
      is_ghost_.push_back(first.is_ghost ? 1 : 0);
    }
    join_runs();
    for (Run& run : runs_) {
      intervals_.occlusion().look_at(run.from, run.to);
      LineTask task(line_of(run.of), run.from.cut, run.to.cut);
      if (first.is_intersection()) {
        task.intersection = static_cast<std::uint32_t>(intersections_.size());
        intersections_.push_back({meet_.s, meet_.t, run.from.cut, run.to.cut});
      }
      intervals_.add(task, run.hidden);
      is_ghost_.push_back(first.is_ghost ? 1 : 0);
    }
  }
  /// The lines that were added, their ghosts marked, with intersections of their own.
  VisibleLines take() {
    VisibleLines lines = intervals_.take();
    for (std::size_t i = 0; i < lines.lines.size(); ++i) lines.lines[i].is_ghost = is_ghost_[i] != 0;
    lines.intersections = std::move(intersections_);
    return lines;
  }

 private:
  /// A part of one class, and what of it is hidden.
  struct Run {
    LineOfCell of;
    Breakpoint from, to;
    std::vector<HiddenInterval> hidden;
  };

  const Line& line_of(const LineOfCell& one) const { return cells_[one.cell].lines.lines[one.line]; }
  Cut cut_of(const LineOfCell& one, const Cut& cut) const { return cut.by_plane(cells_[one.cell].plane); }

  /// False: it is seen as a point, or in no cell.
  bool turn_to(std::span<const LineOfCell> group) {
    const auto has_parts = [&](const LineOfCell& one) { return line_of(one).intervals() > 0; };
    if (std::none_of(group.begin(), group.end(), has_parts)) return false;
    if (!line_of(group.front()).is_intersection()) return intervals_.occlusion().start(line_of(group.front()).edge);
    find_ends(group);
    return intervals_.occlusion().start(meet_);
  }
  /// The outermost of all ends of where two facets meet.
  void find_ends(std::span<const LineOfCell> group) {
    const auto meet_of = [&](const LineOfCell& one) { return cells_[one.cell].lines.intersections[line_of(one).intersection]; };
    meet_ = meet_of(group.front());
    meet_.from = cut_of(group.front(), meet_.from);
    meet_.to = cut_of(group.front(), meet_.to);
    const PlaneIntersection line(projected_.face_plane(meet_.s), projected_.face_plane(meet_.t), intervals_.exact());
    const auto place = [&](const Cut& cut) { return line.place(cut_plane(projected_, cut)); };
    if (line.order(place(meet_.from), place(meet_.to)) == Sign::positive) std::swap(meet_.from, meet_.to);
    for (const LineOfCell& one : group)
      for (const Cut& end : {cut_of(one, meet_of(one).from), cut_of(one, meet_of(one).to)}) {
        if (line.order(place(end), place(meet_.from)) == Sign::negative) meet_.from = end;
        if (line.order(place(meet_.to), place(end)) == Sign::negative) meet_.to = end;
      }
  }

  Breakpoint place(const Cut& cut) {
    if (cut.kind == Cut::Kind::start) return {cut, 0, 0, Sign::positive};
    if (cut.kind == Cut::Kind::end) return {cut, 1, 0, Sign::positive};
    return intervals_.occlusion().place(cut);
  }

  void add_parts(const LineOfCell& one) {
    const Line& line = line_of(one);
    if (line.intervals() == 0) return;
    TriangleOcclusion& occlusion = intervals_.occlusion();
    const auto cuts = cells_[one.cell].lines.cuts_of(line);
    std::vector<Breakpoint> places;
    for (const Cut& cut : cuts) places.push_back(place(cut_of(one, cut)));
    bool is_reversed = false;  // where facets meet, cells may begin at either end
    if (occlusion.order(places.front(), places.back()) == Sign::positive) {
      std::reverse(places.begin(), places.end());
      is_reversed = true;
    }
    Run run{one, places.front(), places.back(), {}};
    for (const CutSide& side : cells_[one.cell].sides)
      if (!occlusion.keep(side.cut, side.kept, run.from, run.to)) return;
    for (std::uint32_t k = 0; k < line.intervals(); ++k) {
      if (!line.hidden(is_reversed ? line.intervals() - 1 - k : k)) continue;
      HiddenInterval hidden{places[k], places[k + 1], {}};
      if (occlusion.order(hidden.from, run.from) == Sign::negative) hidden.from = run.from;
      if (occlusion.order(run.to, hidden.to) == Sign::negative) hidden.to = run.to;
      if (occlusion.order(hidden.from, hidden.to) == Sign::negative) run.hidden.push_back(hidden);
    }
    runs_.push_back(std::move(run));
  }

  /// Of one class, what overlaps or touches is one.
  void join_runs() {
    TriangleOcclusion& occlusion = intervals_.occlusion();
    const auto kind = [&](const Run& run) { return std::pair(line_of(run.of).is_behind, line_of(run.of).edge_class); };
    std::stable_sort(runs_.begin(), runs_.end(), [&](const Run& x, const Run& y) {
      if (kind(x) != kind(y)) return kind(x) < kind(y);
      return occlusion.order(x.from, y.from) == Sign::negative;
    });
    std::vector<Run> joined;
    for (Run& run : runs_) {
      if (joined.empty() || kind(joined.back()) != kind(run) || occlusion.order(joined.back().to, run.from) == Sign::negative) {
        joined.push_back(std::move(run));
        continue;
      }
      Run& last = joined.back();
      if (occlusion.order(last.to, run.to) == Sign::negative) last.to = run.to;
      last.hidden.insert(last.hidden.end(), run.hidden.begin(), run.hidden.end());
    }
    std::stable_sort(joined.begin(), joined.end(),
                     [&](const Run& x, const Run& y) { return occlusion.order(x.from, y.from) == Sign::negative; });
    runs_ = std::move(joined);
  }

  const ProjectedMesh& projected_;
  const std::vector<LinesOfCell>& cells_;
  HiddenIntervals intervals_;
  Intersection meet_;
  std::vector<Run> runs_;
  std::vector<Intersection> intersections_;
  std::vector<char> is_ghost_;  // by line
};

std::vector<LineOfCell> sorted_lines(const std::vector<LinesOfCell>& cells) {
  std::vector<LineOfCell> all;
  for (std::uint32_t c = 0; c < cells.size(); ++c)
    for (std::uint32_t i = 0; i < cells[c].lines.lines.size(); ++i) {
      const Line& line = cells[c].lines.lines[i];
      LineOfCell one{{line.is_ghost ? 1 : 0, line.edge.value, 0}, c, i};
      if (line.is_intersection()) {
        const Intersection& meet = cells[c].lines.intersections[line.intersection];
        one.along = {2, meet.s.value, meet.t.value};
      }
      all.push_back(one);
    }
  std::stable_sort(all.begin(), all.end(), [](const LineOfCell& x, const LineOfCell& y) { return x.along < y.along; });
  return all;
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
  all.decisions += more.decisions;
}

}  // namespace

std::vector<CutSide> sides_of(const SectionCell& cell) {
  std::vector<CutSide> sides;
  for (const CellSide& side : cell.sides) {
    const bool is_fold = side.u != side.v;
    sides.push_back({is_fold ? Cut{Cut::Kind::fold, 0, side.u, side.v} : Cut{Cut::Kind::near}.by_plane(side.u), side.kept});
  }
  return sides;
}

VisibleLines lines_in_cells(const SceneView& scene, const LineOptions& options) {
  std::vector<LinesOfCell> cells;
  for (const ViewParts::Cell& cell : scene.parts().cells()) {
    cells.push_back({visible_lines(cell.scene, options), cell.cell.plane, sides_of(cell.cell)});
    if (scene.view().far) cells.back().sides.push_back({Cut{Cut::Kind::near}.by_plane(View::far_number), Sign::negative});
  }
  return united_lines(scene, cells, options);
}

VisibleLines united_lines(const SceneView& scene, const std::vector<LinesOfCell>& cells, const LineOptions& options) {
  const std::vector<LineOfCell> sorted = sorted_lines(cells);
  std::vector<std::size_t> groups;  // where each begins
  for (std::size_t i = 0; i < sorted.size(); ++i)
    if (i == 0 || sorted[i].along != sorted[i - 1].along) groups.push_back(i);
  groups.push_back(sorted.size());
  constexpr std::size_t block = 256;
  const std::size_t count = groups.size() - 1;
  std::vector<VisibleLines> parts((count + block - 1) / block);
  const ProjectedMesh& projected = scene.parts().projected(options.stop);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, parts.size(), 1), [&](const auto& range) {
    for (std::size_t part = range.begin(); part != range.end(); ++part) {
      LineUniter uniter(projected, cells, options);
      for (std::size_t g = part * block; g < std::min(count, (part + 1) * block); ++g)
        uniter.add(std::span(sorted).subspan(groups[g], groups[g + 1] - groups[g]));
      parts[part] = uniter.take();
    }
  });
  VisibleLines all;
  all.plan = cells.front().lines.plan;
  for (const LinesOfCell& cell : cells) {
    all.pairs += cell.lines.pairs;
    all.decisions += cell.lines.decisions;
  }
  for (VisibleLines& part : parts) append(all, std::move(part));
  return all;
}

}  // namespace hsr::internal
