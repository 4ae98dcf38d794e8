#include "hsr/lines/hidden_classes.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "hsr/lines/clear_shadows.h"
#include "hsr/lines/hidden_intervals.h"

namespace hsr::internal {

namespace {

/// A part of a line that is of one class.
struct Piece {
  bool is_hidden;
  EdgeClass edge_class;
  Cut from, to;
  std::vector<Occluder> occluders = {};
  bool is_behind = false;
};

class LinesInPieces {
 public:
  LinesInPieces(const ProjectedMesh& projected, const View& view, const ClassifiedEdges& edges, const LineOptions& options,
                const NearOccluders* near, const ClassesByVisibility& classes, const VisibleLines& lines)
      : projected_(projected), view_(view), edges_(edges), options_(options), near_(near), classes_(classes), lines_(lines) {}

  /// By line; nothing of lines of one class.
  std::vector<std::vector<Piece>> pieces() const {
    std::vector<std::vector<Piece>> all(lines_.lines.size());
    using Range = tbb::blocked_range<std::size_t>;
    tbb::parallel_for(Range(0, all.size(), edges_of_block), [&](const Range& range) {
      std::optional<ClearShadows> shadows;
      for (std::size_t i = range.begin(); i < range.end(); ++i) {
        const Line& line = lines_.lines[i];
        if ((!classes_[i].hidden && !classes_[i].behind_seen) || line.intervals() == 0) continue;
        const bool is_hidden = line.starts_hidden || line.intervals() > 1;
        const bool may_be_noise = near_ != nullptr && is_hidden && !line.is_intersection();
        if (may_be_noise) {
          if (!shadows) shadows.emplace(projected_, view_, near_->stretches, near_->all);
          shadows->turn_to(edges_[i]);
        }
        all[i] = pieces_of(i, may_be_noise ? &*shadows : nullptr);
      }
    });
    return all;
  }

 private:
  std::vector<Piece> pieces_of(std::size_t i, ClearShadows* shadows) const;
  std::vector<Occluder> occluders_of(const Line& line, std::uint32_t k, std::uint32_t& first) const;
  std::vector<Occluder> occluders_of(const RequestedPart& part) const;

  const ProjectedMesh& projected_;
  const View& view_;
  const ClassifiedEdges& edges_;
  const LineOptions& options_;
  const NearOccluders* near_;
  const ClassesByVisibility& classes_;
  const VisibleLines& lines_;
};

/// The occluders of a line that are of its interval k. @param first where to begin among them; moved on to the next interval
std::vector<Occluder> LinesInPieces::occluders_of(const Line& line, std::uint32_t k, std::uint32_t& first) const {
  const Mesh& mesh = projected_.mesh();
  const SupportingLine support = supporting_line_of(mesh, lines_, line);
  std::vector<Occluder> all;
  if (!line.hidden(k) || first == line.end_occluder) return all;
  const Rational end = exact_parameter(mesh, view_, support, lines_.cuts_of(line)[k + 1]);
  bool is_done = false;
  while (first < line.end_occluder && !is_done) {
    all.push_back(lines_.occluders[first++]);
    is_done = !(exact_parameter(mesh, view_, support, all.back().to) < end);
  }
  return all;
}

/// Of a part that is hidden all along.
std::vector<Occluder> LinesInPieces::occluders_of(const RequestedPart& part) const {
  const Edge& edge = projected_.mesh().edges[part.edge];
  HiddenIntervals intervals(projected_, options_);
  intervals.add_by_casting(part, projected_.box(edge.a, edge.b), near_->all);
  return intervals.take().occluders;
}

std::vector<Piece> LinesInPieces::pieces_of(std::size_t i, ClearShadows* shadows) const {
  const Line& line = lines_.lines[i];
  const std::span<const Cut> cuts = lines_.cuts_of(line);
  const EdgeClass hidden = classes_[i].hidden.value_or(line.edge_class);
  std::vector<Piece> pieces;
  const auto add_behind = [&](const Cut& from, const Cut& to) {
    if (const auto behind = classes_[i].behind_seen) pieces.push_back({true, *behind, from, to, {}, true});
  };
  std::uint32_t occluder = line.first_occluder;
  for (std::uint32_t k = 0; k < line.intervals(); ++k) {
    const std::vector<Occluder> by = occluders_of(line, k, occluder);
    if (!line.hidden(k)) {
      pieces.push_back({false, line.edge_class, cuts[k], cuts[k + 1]});
      add_behind(cuts[k], cuts[k + 1]);
      continue;
    }
    const auto parts =
        shadows != nullptr ? shadows->divided(cuts[k], cuts[k + 1]) : ClearShadows::Divided{true, {cuts[k], cuts[k + 1]}};
    bool is_clear = parts.starts_clear;
    for (std::size_t j = 0; j + 1 < parts.cuts.size(); ++j, is_clear = !is_clear) {
      pieces.push_back({true, is_clear ? hidden : line.edge_class, parts.cuts[j], parts.cuts[j + 1]});
      // Of a whole interval they are known.
      if (options_.why)
        pieces.back().occluders =
            parts.cuts.size() == 2 ? by : occluders_of({line.edge, hidden, false, {}, {}, parts.cuts[j], parts.cuts[j + 1]});
      if (!is_clear) add_behind(parts.cuts[j], parts.cuts[j + 1]);
    }
  }
  return pieces;
}

/// Appends lines to those that are done, and what is behind an edge after all else of it, along it; neighbours that are alike are one.
class LinesByEdge {
 public:
  LinesByEdge(const Mesh& mesh, const View& view, VisibleLines& lines) : mesh_(mesh), view_(view), lines_(lines) {}

  void add(const Line& line) {
    if (line.edge != edge_ || line.is_ghost || line.is_intersection()) add_behind();
    if (behind_.empty() || !line.is_behind)
      lines_.lines.push_back(line);
    else
      behind_.push_back(behind(line, lines_.cuts[line.first_cut], lines_.cuts[line.first_cut + 1]));
  }
  /// The part of a line in a class of its own. @pre of the edge of the line that was added last, if any was of it
  void add(const Line& whole, const Piece& piece) {
    if (whole.edge != edge_) add_behind();
    edge_ = whole.edge;
    Line part = whole;
    part.edge_class = piece.edge_class;
    part.starts_hidden = piece.is_hidden;
    part.is_behind = piece.is_behind;
    if (piece.is_behind)
      behind_.push_back(behind(part, piece.from, piece.to));
    else
      append(part, piece.from, piece.to, piece.occluders);
  }
  /// What is behind the last edge.
  void add_behind() {
    std::sort(behind_.begin(), behind_.end(), [](const Behind& x, const Behind& y) { return x.from < y.from; });
    for (std::size_t k = 0, next = 0; k < behind_.size(); k = next) {
      for (next = k + 1; next < behind_.size() && goes_on(behind_[next - 1], behind_[next]);) ++next;
      append(behind_[k].line, behind_[k].cuts[0], behind_[next - 1].cuts[1], {});
    }
    behind_.clear();
    edge_ = EdgeId();
  }

 private:
  struct Behind {
    Line line;
    std::array<Cut, 2> cuts;
    Rational from, to;
  };
  Behind behind(const Line& line, const Cut& from, const Cut& to) const {
    const Edge& edge = mesh_.edges[line.edge];
    const SupportingLine support{edge.a, edge.b, {}};
    return {line, {from, to}, exact_parameter(mesh_, view_, support, from), exact_parameter(mesh_, view_, support, to)};
  }
  static bool goes_on(const Behind& x, const Behind& y) { return x.line.edge_class == y.line.edge_class && x.to == y.from; }
  void append(Line part, const Cut& from, const Cut& to, const std::vector<Occluder>& occluders) {
    part.first_cut = static_cast<std::uint32_t>(lines_.cuts.size());
    part.first_occluder = static_cast<std::uint32_t>(lines_.occluders.size());
    lines_.cuts.push_back(from);
    lines_.cuts.push_back(to);
    lines_.occluders.insert(lines_.occluders.end(), occluders.begin(), occluders.end());
    part.end_cut = static_cast<std::uint32_t>(lines_.cuts.size());
    part.end_occluder = static_cast<std::uint32_t>(lines_.occluders.size());
    check_countable(std::max(lines_.cuts.size(), lines_.occluders.size()), "interval ends");
    lines_.lines.push_back(part);
  }

  const Mesh& mesh_;
  const View& view_;
  VisibleLines& lines_;
  EdgeId edge_;  // of what is behind
  std::vector<Behind> behind_;
};

}  // namespace

VisibleLines with_hidden_classes(const ProjectedMesh& projected, const View& view, const ClassifiedEdges& edges,
                                 const LineOptions& options, const NearOccluders* near, const ClassesByVisibility& classes,
                                 VisibleLines lines) {
  if (classes.empty()) return lines;
  const std::vector<std::vector<Piece>> pieces = LinesInPieces(projected, view, edges, options, near, classes, lines).pieces();
  const Mesh& mesh = projected.mesh();
  const std::vector<Line> whole = std::exchange(lines.lines, {});
  LinesByEdge all(mesh, view, lines);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    if (pieces[i].empty()) {
      all.add(whole[i]);
      continue;
    }
    const Edge* const edge = whole[i].is_intersection() ? nullptr : &mesh.edges[whole[i].edge];
    const bool is_diagonal = edge != nullptr && edge->diagonal && !edge->of_face && !options.diagonals;
    for (const Piece& piece : pieces[i]) {
      const bool is_wanted = options.classes[static_cast<std::size_t>(piece.edge_class)];
      if (!is_wanted || (is_diagonal && piece.edge_class == EdgeClass::smooth)) continue;
      all.add(whole[i], piece);
    }
  }
  all.add_behind();
  return lines;
}

}  // namespace hsr::internal
