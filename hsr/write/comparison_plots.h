#pragma once

#include <string>
#include <vector>

#include "hsr/check/comparison.h"
#include "hsr/write/plot_svg.h"

namespace hsr {

/// Error against run time and the like, as diagrams; each has a name for its file.
struct NamedPlot {
  std::string name;
  Plot plot;
};
std::vector<NamedPlot> comparison_plots(const Comparison& comparison);

}  // namespace hsr
