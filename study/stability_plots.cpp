#include "study/stability_plots.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>

namespace hsr::internal {

namespace {

/// Where 16 bits suffice, 8 are shown in their place.
constexpr std::string_view coarse = "fixed 16", coarser = "fixed 8";

/// As many as there are colours that a reader tells apart, beside the exact ones together.
constexpr std::array<std::array<std::string_view, 2>, 7> plotted = {{{"depth buffer", coarse},
                                                                     {"depth buffer", "fixed 24"},
                                                                     {"depth buffer", "float 32"},
                                                                     {"depth buffer", "float 32 reversed"},
                                                                     {"depth buffer", "float 64"},
                                                                     {"painter, by the centroid", "double"},
                                                                     {"visible fragments", "doubles only"}}};

bool breaks(const FamilyResult& f, std::string_view method, std::string_view numbers) {
  return std::any_of(f.rows.begin(), f.rows.end(), [&](const StabilityRow& row) {
    return row.method == method && row.numbers == numbers && f.breakdown(row);
  });
}

Plot plot(const FamilyResult& f, double least_share) {
  Plot all{std::string(f.family.title) + ": wrong samples", f.family.knob, "share of the covered samples", {}, "0", {}};
  for (const StabilityValue& v : f.values) all.stops.push_back(v.value);
  const auto add = [&](const StabilityRow& row, PlotSeries& s) {
    for (std::size_t k = 0; k < row.points.size(); ++k)
      if (row.points[k].outcome != Outcome::refused && row.points[k].outcome != Outcome::left_out)
        s.points.push_back({f.values[k].value, row.points[k].wrong_share});
  };
  std::vector<PlotSeries> predictions;
  for (auto [method, numbers] : plotted) {
    if (numbers == coarse && !breaks(f, method, coarse)) numbers = coarser;
    PlotSeries s{std::string(method) + ", " + std::string(numbers), {}};
    for (const StabilityRow& row : f.rows) {
      if (row.method != method || row.numbers != numbers) continue;
      add(row, s);
      if (!row.predicted) continue;
      PlotSeries line{s.name + ", predicted", {{*row.predicted, least_share}, {*row.predicted, 1}}, true};
      line.like = static_cast<int>(all.series.size());
      predictions.push_back(std::move(line));
    }
    all.series.push_back(std::move(s));
  }
  // The worst of the exact ones at each value; last, so that it lies over the others.
  PlotSeries exact{"all exact methods", {}};
  for (std::size_t k = 0; k < f.values.size(); ++k) {
    double worst = 0;
    for (const StabilityRow& row : f.rows)
      if (row.is_exact) worst = std::max(worst, row.points[k].wrong_share);
    exact.points.push_back({f.values[k].value, worst});
  }
  all.series.push_back(std::move(exact));
  const bool is_predicted = !predictions.empty();
  std::move(predictions.begin(), predictions.end(), std::back_inserter(all.series));
  if (is_predicted) all.x_label += " (dashed: one step of the format)";
  return all;
}

}  // namespace

std::vector<NamedPlot> stability_plots(const Stability& stability) {
  const double least = 1 / (static_cast<double>(stability.size) * stability.size);
  std::vector<NamedPlot> plots;
  for (const FamilyResult& f : stability.families) plots.push_back({f.family.name, plot(f, least)});
  return plots;
}

}  // namespace hsr::internal
