#include "hsr/lines/hidden_classes.h"

#include <tbb/parallel_for.h>

#include <algorithm>
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
};

class LinesInPieces {
 public:
  LinesInPieces(const ProjectedMesh& projected, const View& view, const ClassifiedEdges& edges, const LineOptions& options,
                const NearOccluders* near, const HiddenClasses& hidden, const VisibleLines& lines)
      : projected_(projected), view_(view), edges_(edges), options_(options), near_(near), hidden_(hidden), lines_(lines) {}

  /// By line; nothing of lines of one class.
  std::vector<std::vector<Piece>> pieces() const {
    std::vector<std::vector<Piece>> all(lines_.lines.size());
    using Range = tbb::blocked_range<std::size_t>;
    tbb::parallel_for(Range(0, all.size(), edges_of_block), [&](const Range& range) {
      std::optional<ClearShadows> shadows;
      for (std::size_t i = range.begin(); i < range.end(); ++i) {
        const Line& line = lines_.lines[i];
        if (!hidden_[i] || line.intervals() == 0) continue;
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
  const HiddenClasses& hidden_;
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
  const EdgeClass hidden = *hidden_[i];
  std::vector<Piece> pieces;
  std::uint32_t occluder = line.first_occluder;
  for (std::uint32_t k = 0; k < line.intervals(); ++k) {
    const std::vector<Occluder> by = occluders_of(line, k, occluder);
    if (!line.hidden(k)) {
      pieces.push_back({false, line.edge_class, cuts[k], cuts[k + 1]});
      continue;
    }
    const auto parts =
        shadows != nullptr ? shadows->divided(cuts[k], cuts[k + 1]) : ClearShadows::Divided{true, {cuts[k], cuts[k + 1]}};
    bool is_clear = parts.starts_clear;
    for (std::size_t j = 0; j + 1 < parts.cuts.size(); ++j, is_clear = !is_clear) {
      pieces.push_back({true, is_clear ? hidden : line.edge_class, parts.cuts[j], parts.cuts[j + 1]});
      if (!options_.why) continue;
      // Of a whole interval they are known.
      if (parts.cuts.size() == 2)
        pieces.back().occluders = by;
      else
        pieces.back().occluders = occluders_of({line.edge, hidden, false, {}, parts.cuts[j], parts.cuts[j + 1]});
    }
  }
  return pieces;
}

}  // namespace

VisibleLines with_hidden_classes(const ProjectedMesh& projected, const View& view, const ClassifiedEdges& edges,
                                 const LineOptions& options, const NearOccluders* near, const HiddenClasses& hidden,
                                 VisibleLines lines) {
  if (hidden.empty()) return lines;
  const std::vector<std::vector<Piece>> pieces = LinesInPieces(projected, view, edges, options, near, hidden, lines).pieces();
  const Mesh& mesh = projected.mesh();
  const std::vector<Line> whole = std::exchange(lines.lines, {});
  for (std::size_t i = 0; i < whole.size(); ++i) {
    if (pieces[i].empty()) {
      lines.lines.push_back(whole[i]);
      continue;
    }
    const Edge* const edge = whole[i].is_intersection() ? nullptr : &mesh.edges[whole[i].edge];
    const bool is_diagonal = edge != nullptr && edge->diagonal && !edge->of_face && !options.diagonals;
    for (const Piece& piece : pieces[i]) {
      const bool is_wanted = options.classes[static_cast<std::size_t>(piece.edge_class)];
      if (!is_wanted || (is_diagonal && piece.edge_class == EdgeClass::smooth)) continue;
      Line part = whole[i];
      part.edge_class = piece.edge_class;
      part.starts_hidden = piece.is_hidden;
      part.first_cut = static_cast<std::uint32_t>(lines.cuts.size());
      part.first_occluder = static_cast<std::uint32_t>(lines.occluders.size());
      lines.cuts.push_back(piece.from);
      lines.cuts.push_back(piece.to);
      lines.occluders.insert(lines.occluders.end(), piece.occluders.begin(), piece.occluders.end());
      part.end_cut = static_cast<std::uint32_t>(lines.cuts.size());
      part.end_occluder = static_cast<std::uint32_t>(lines.occluders.size());
      check_countable(std::max(lines.cuts.size(), lines.occluders.size()), "interval ends");
      lines.lines.push_back(part);
    }
  }
  return lines;
}

}  // namespace hsr::internal
