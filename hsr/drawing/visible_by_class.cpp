#include "hsr/drawing/visible_by_class.h"

#include <span>
#include <vector>

namespace hsr::internal {

namespace {

bool has_visible(const Line& line) { return line.intervals() > (line.starts_hidden ? 1U : 0U); }

class Merger {
 public:
  Merger(const Mesh& mesh, const View& view, const VisibleLines& lines) : mesh_(mesh), view_(view), lines_(lines) {}

  std::optional<VisibleLines> merged() {
    bool is_any = false;
    for_each_group([&](std::span<const Line> group) { is_any = is_any || has_several(group); });
    if (!is_any) return std::nullopt;
    for_each_group([&](std::span<const Line> group) { add(group); });
    return std::move(result_);
  }

 private:
  /// Along one edge, or where two facets meet.
  bool are_alike(const Line& x, const Line& y) const {
    if (x.edge != y.edge || x.is_ghost != y.is_ghost) return false;
    if (!x.is_intersection()) return true;
    const Intersection &a = lines_.intersections[x.intersection], &b = lines_.intersections[y.intersection];
    return a.s == b.s && a.t == b.t;
  }
  template <class F>
  void for_each_group(const F& visit) const {
    const std::span<const Line> all = lines_.lines;
    for (std::size_t i = 0, end = 0; i < all.size(); i = end) {
      for (end = i + 1; end < all.size() && are_alike(all[i], all[end]);) ++end;
      visit(all.subspan(i, end - i));
    }
  }
  static bool is_to_merge(const Line& x, EdgeClass c) {
    return x.edge_class == c && c != EdgeClass::overhead && has_visible(x);
  }
  static bool has_several(std::span<const Line> group) {
    for (std::size_t i = 0; i < group.size(); ++i)
      for (std::size_t k = i + 1; k < group.size(); ++k)
        if (has_visible(group[i]) && is_to_merge(group[k], group[i].edge_class)) return true;
    return false;
  }

  void add(std::span<const Line> group) {
    std::vector<char> is_done(group.size(), 0);
    for (std::size_t i = 0; i < group.size(); ++i) {
      if (is_done[i] != 0 || !has_visible(group[i])) continue;
      std::size_t count = 0;
      for (std::size_t k = i; k < group.size(); ++k) count += is_to_merge(group[k], group[i].edge_class) ? 1U : 0U;
      Line line = begun(group[i]);
      if (count < 2) {
        line.starts_hidden = group[i].starts_hidden;
        const auto cuts = lines_.cuts_of(group[i]);
        result_.cuts.insert(result_.cuts.end(), cuts.begin(), cuts.end());
      } else {
        for (std::size_t k = i; k < group.size(); ++k) {
          if (!is_to_merge(group[k], group[i].edge_class)) continue;
          is_done[k] = 1;
          add_visible(line, group[k]);
        }
      }
      end(line);
    }
  }
  Line begun(const Line& of) const {
    Line line = of;
    line.starts_hidden = false;
    line.first_cut = static_cast<std::uint32_t>(result_.cuts.size());
    line.first_occluder = line.end_occluder = 0;
    return line;
  }
  void add_visible(const Line& to, const Line& from) {
    const auto cuts = lines_.cuts_of(from);
    for (std::uint32_t k = 0; k < from.intervals(); ++k) {
      if (from.hidden(k)) continue;
      if (result_.cuts.size() > to.first_cut && are_one_place(to, result_.cuts.back(), cuts[k]))
        result_.cuts.back() = cuts[k + 1];
      else
        result_.cuts.insert(result_.cuts.end(), {cuts[k], cuts[k + 1]});
    }
  }
  bool are_one_place(const Line& line, const Cut& x, const Cut& y) const {
    if (x == y) return true;
    const SupportingLine support = supporting_line_of(mesh_, lines_, line);
    return exact_point(mesh_, view_, support, x) == exact_point(mesh_, view_, support, y);
  }
  void end(Line line) {
    line.end_cut = static_cast<std::uint32_t>(result_.cuts.size());
    if (line.is_intersection()) {
      Intersection meet = lines_.intersections[line.intersection];
      meet.from = result_.cuts[line.first_cut];
      meet.to = result_.cuts.back();
      line.intersection = static_cast<std::uint32_t>(result_.intersections.size());
      result_.intersections.push_back(meet);
    }
    result_.lines.push_back(line);
  }

  const Mesh& mesh_;
  const View& view_;
  const VisibleLines& lines_;
  VisibleLines result_;
};

}  // namespace

std::optional<VisibleLines> visible_by_class(const Mesh& mesh, const View& view, const VisibleLines& lines) {
  return Merger(mesh, view, lines).merged();
}

}  // namespace hsr::internal
