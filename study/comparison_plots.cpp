#include "study/comparison_plots.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "study/html_page.h"

namespace hsr::internal {

namespace {

/// One series for each method and its numbers, in the order of the table, with a point for each size.
template <class Point>
std::vector<PlotSeries> series(const Comparison& c, const Point& point) {
  std::vector<PlotSeries> all;
  for (const ComparedMethod& m : c.methods) {
    if (m.is_variant) continue;
    const std::string name = m.name();
    auto s = std::find_if(all.begin(), all.end(), [&](const PlotSeries& x) { return x.name == name; });
    if (s == all.end()) {
      all.push_back({name, {}, false});
      s = all.end() - 1;
    }
    s->points.push_back(point(m));
  }
  return all;
}

/// y = a x^power through the first point of a series.
PlotSeries guide(const std::string& name, const PlotSeries& along, double power) {
  PlotSeries g{name, {}, true};
  if (along.points.empty()) return g;
  const auto& first = along.points.front();
  for (const auto& p : along.points) g.points.push_back({p[0], first[1] * std::pow(p[0] / first[0], power)});
  return g;
}

}  // namespace

std::vector<NamedPlot> comparison_plots(const Comparison& c) {
  std::vector<NamedPlot> plots;
  plots.push_back({"area-against-time",
                   {"Wrong visible area against run time", "seconds (median)", "share of the visible area",
                    series(c,
                           [](const ComparedMethod& m) {
                             return std::array{m.median(), m.wrong_area_share};
                           }),
                    "exact: 0"}});
  plots.push_back({"samples-against-time",
                   {"Wrong samples against run time", "seconds (median)", "share of the covered samples",
                    series(c,
                           [](const ComparedMethod& m) {
                             return std::array{m.median(), m.wrong_share()};
                           }),
                    "0"}});
  plots.push_back({"area-against-memory",
                   {"Wrong visible area against memory", "bytes at most, beside the scene", "share of the visible area",
                    series(c,
                           [](const ComparedMethod& m) {
                             return std::array{static_cast<double>(m.peak_bytes), m.wrong_area_share};
                           }),
                    "exact: 0"}});
  const auto only_pictures = [](std::vector<PlotSeries> all) {
    all.erase(std::remove_if(all.begin(), all.end(), [](const PlotSeries& s) { return s.points.size() < 2; }), all.end());
    return all;
  };
  std::vector<PlotSeries> area = only_pictures(series(c, [](const ComparedMethod& m) {
    return std::array{static_cast<double>(m.size), m.wrong_area_share};
  }));
  if (!area.empty()) area.push_back(guide("1 / samples each way", area.front(), -1));
  plots.push_back({"area-against-size",
                   {"Wrong visible area against resolution", "samples each way", "share of the visible area", area, "0"}});
  plots.push_back({"edges-against-size",
                   {"Edge position error against resolution", "samples each way", "share of the picture's width",
                    only_pictures(series(c,
                                         [](const ComparedMethod& m) {
                                           return std::array{static_cast<double>(m.size), m.edge_error / m.size};
                                         })),
                    "0"}});
  std::vector<PlotSeries> time = only_pictures(series(c, [](const ComparedMethod& m) {
    return std::array{static_cast<double>(m.size), m.median()};
  }));
  if (!time.empty()) time.push_back(guide("samples", time.front(), 2));
  plots.push_back({"time-against-size", {"Run time against resolution", "samples each way", "seconds (median)", time, "0"}});
  std::vector<PlotSeries> growth, errors;
  for (const Growth& g : c.growth) {
    PlotSeries s{g.method + ": n^" + html_number(g.slope).text, {}, false}, e{g.method, {}, false};
    for (std::size_t k = 0; k < g.faces.size(); ++k) {
      s.points.push_back({g.faces[k], g.seconds[k]});
      if (k < g.wrong_share.size()) e.points.push_back({g.faces[k], g.wrong_share[k]});
    }
    growth.push_back(std::move(s));
    if (!e.points.empty()) errors.push_back(std::move(e));
  }
  if (growth.size() > 1) {
    growth.push_back(guide("n", growth[1], 1));
    growth.push_back(guide("n^2", growth[1], 2));
  }
  const std::string n = "against the number of triangles n (the first n, shuffled)";
  plots.push_back({"time-against-faces", {"Run time " + n, "triangles", "seconds", growth, "0"}});
  plots.push_back({"samples-against-faces", {"Wrong samples " + n, "triangles", "share of the covered samples", errors, "0"}});
  // A diagram of nothing, or of nothing but zeros, says nothing.
  std::erase_if(plots, [](const NamedPlot& p) {
    return std::none_of(p.plot.series.begin(), p.plot.series.end(), [](const PlotSeries& s) {
      return !s.is_theory && std::any_of(s.points.begin(), s.points.end(), [](const auto& at) { return at[1] > 0; });
    });
  });
  return plots;
}

}  // namespace hsr::internal
