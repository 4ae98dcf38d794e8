#include "hsr/sheet/sheet_layout.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "hsr/drawing/standard_scale.h"

namespace hsr::internal {

namespace {

using Row = ViewToPlace::Row;

constexpr double least_gap = 8;  // mm between what views show, dimensions and letters included
constexpr double most_gap = 45;  // beyond that views do not move apart
constexpr std::size_t most_free = 6;

/// How far a view reaches from its origin at a scale, mm, what is around it included.
struct Reach {
  double left, right, above, below;
  double width() const { return left + right; }
  double height() const { return above + below; }
};

Reach reach_of(const ViewToPlace& v, double scale) {
  const double s = v.is_on_paper ? 1 : scale;
  return {s * v.left + v.pad_left, s * v.right + v.pad_right, s * v.above + v.pad_above, s * v.below + v.pad_below};
}

/// The views of one row from left to right at a scale, as close as can be.
struct PlacedRow {
  std::vector<std::size_t> views;
  std::vector<Reach> reaches;
  double width = 0, above = 0, below = 0;  ///< from the height of the origins that line up

  bool is_empty() const { return views.empty(); }
  double height() const { return above + below; }
};

PlacedRow row_of(const std::vector<ViewToPlace>& views, Row row, double scale) {
  PlacedRow placed;
  for (std::size_t k = 0; k < views.size(); ++k) {
    if (views[k].row != row) continue;
    placed.views.push_back(k);
    placed.reaches.push_back(reach_of(views[k], scale));
    const Reach& r = placed.reaches.back();
    placed.width += r.width() + (placed.views.size() > 1 ? least_gap : 0);
    if (!views[k].lines_up) continue;
    placed.above = std::max(placed.above, r.above);
    placed.below = std::max(placed.below, r.below);
  }
  // The others are in the middle.
  for (std::size_t k = 0; k < placed.views.size(); ++k) {
    const double more = placed.reaches[k].height() - placed.height();
    if (views[placed.views[k]].lines_up || more <= 0) continue;
    placed.above += more / 2;
    placed.below += more / 2;
  }
  return placed;
}

/// Both rows, the first views one above the other.
class Rows {
 public:
  Rows(const std::vector<ViewToPlace>& views, double scale, ProjectionAngle angle) : views_(views) {
    rows_ = {row_of(views, Row::of_front, scale), row_of(views, Row::of_top, scale)};
    if (angle == ProjectionAngle::third) std::swap(rows_[0], rows_[1]);
    for (const PlacedRow& row : rows_)
      if (!row.is_empty()) {
        column_left_ = std::max(column_left_, row.reaches[0].left);
        column_right_ = std::max(column_right_, row.reaches[0].right);
      }
    for (PlacedRow& row : rows_)
      if (!row.is_empty()) row.width += column_left_ + column_right_ - row.reaches[0].width();
  }

  double height() const { return rows_[0].height() + rows_[1].height() + (has_two() ? least_gap : 0); }
  const PlacedRow& upper() const { return has_two() || rows_[1].is_empty() ? rows_[0] : none_; }
  const PlacedRow& lower() const { return rows_[1].is_empty() ? rows_[0] : rows_[1]; }

  /// Spread over the area, of which the lower row has the width `lower_width` only.
  std::vector<Point2> spread(const PaperFrame& area, double lower_width) const {
    const double width = area.right - area.left;
    double spare = HUGE_VAL, gap = HUGE_VAL;
    for (const PlacedRow& row : rows_) {
      if (row.is_empty()) continue;
      const double left_over = (&row == &lower() ? lower_width : width) - row.width;
      const double share = std::min(left_over / static_cast<double>(row.views.size() + 1), most_gap);
      gap = std::min(gap, share);
      spare = std::min(spare, left_over - share * static_cast<double>(row.views.size() - 1));
    }
    const double down = area.bottom - area.top - height();
    const double gap_down = std::min(down / (has_two() ? 3 : 2), most_gap);
    double y = area.top + (down - (has_two() ? gap_down : 0)) / 2;
    std::vector<Point2> origins(views_.size());
    for (const PlacedRow& row : rows_) {
      if (row.is_empty()) continue;
      double x = area.left + spare / 2;
      for (std::size_t k = 0; k < row.views.size(); ++k) {
        Reach r = row.reaches[k];
        if (k == 0) r.left = column_left_;
        if (k == 0) r.right = column_right_;
        const bool lines_up = views_[row.views[k]].lines_up;
        origins[row.views[k]] = {x + r.left, y + (lines_up ? row.above : (row.height() - r.height()) / 2 + r.above)};
        x += r.width() + least_gap + gap;
      }
      y += row.height() + least_gap + gap_down;
    }
    return origins;
  }

 private:
  bool has_two() const { return !rows_[0].is_empty() && !rows_[1].is_empty(); }

  const std::vector<ViewToPlace>& views_;
  std::array<PlacedRow, 2> rows_;  // the upper one first
  PlacedRow none_;
  double column_left_ = 0, column_right_ = 0;
};

/// At one scale, with the views in their rows: above the title block, or beside it.
std::optional<std::vector<Point2>> fit(const std::vector<ViewToPlace>& views, const PaperFrame& area,
                                       const PaperFrame& title_block, ProjectionAngle angle, double scale) {
  const Rows rows(views, scale, angle);
  const double width = area.right - area.left;
  if (rows.upper().width > width) return {};
  PaperFrame over = area;
  over.bottom = title_block.top - least_gap;
  if (rows.lower().width <= width && rows.height() <= over.bottom - over.top) return rows.spread(over, width);
  const double beside = title_block.left - least_gap - area.left;
  if (rows.lower().width <= beside && rows.height() <= area.bottom - area.top) return rows.spread(area, beside);
  return {};
}

/// The largest scale at which the largest view is no larger than the area.
double largest(const std::vector<ViewToPlace>& views, const PaperFrame& area) {
  double scale = HUGE_VAL;
  for (const ViewToPlace& v : views) {
    if (v.is_on_paper) continue;
    if (v.left + v.right > 0) scale = std::min(scale, (area.right - area.left) / (v.left + v.right));
    if (v.above + v.below > 0) scale = std::min(scale, (area.bottom - area.top) / (v.above + v.below));
  }
  return std::isfinite(scale) ? std::min(scale, 1e300) : 1;
}

}  // namespace

std::optional<SheetLayout> lay_out(std::vector<ViewToPlace> views, const PaperFrame& area, const PaperFrame& title_block,
                                   ProjectionAngle angle, std::optional<double> scale) {
  std::vector<std::size_t> free;
  for (std::size_t k = 0; k < views.size(); ++k)
    if (views[k].is_free && free.size() < most_free) free.push_back(k);
  const double first = scale ? *scale : standard_scale(largest(views, area));
  double before = HUGE_VAL;  // beyond 1e-300 there is no next one
  for (double s = first; s >= first * 1e-6 && s < before; before = s, s = standard_scale(s * 0.75)) {
    for (std::size_t rows = 0; rows < std::size_t{1} << free.size(); ++rows) {
      for (std::size_t k = 0; k < free.size(); ++k) views[free[k]].row = (rows >> k & 1U) != 0 ? Row::of_front : Row::of_top;
      if (auto origins = fit(views, area, title_block, angle, s)) return SheetLayout{s, std::move(*origins)};
    }
    if (scale) break;
  }
  return {};
}

}  // namespace hsr::internal
