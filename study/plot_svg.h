#pragma once

#include <array>
#include <string>
#include <vector>

namespace hsr::internal {

struct PlotSeries {
  std::string name;
  std::vector<std::array<double, 2>> points;  ///< drawn in this order
  bool is_theory = false;                     ///< a dashed line without marks
  int like = -1;                              ///< in the colour of the series with this number, and not in the legend
};

/// A diagram with axes by powers of ten. What is 0 on the second axis stands on a line of its own below it: exact results are a
/// line at error zero. Points that are not above 0 on the first axis, or not finite, are left out.
struct Plot {
  std::string title, x_label, y_label;
  std::vector<PlotSeries> series;
  std::string zero_label = "0";
  /// If there are any: values of the first axis, ascending or descending, that stand at equal distances from left to right;
  /// what is between two of them is placed by its logarithm.
  std::vector<double> stops = {};
};

/// A diagram, and a name for its file.
struct NamedPlot {
  std::string name;
  Plot plot;
};

/// An <svg> element, 800 by 440, for a page whose custom properties --ink, --paper, --faint and --c0 ...
/// --c7 give it its colours.
std::string plot_svg(const Plot& plot);
/// The plot as a file of its own with plain colours, since few drawing programs know custom properties.
std::string plot_file(const Plot& plot);

}  // namespace hsr::internal
