#pragma once

#include <string>
#include <vector>

#include "study/comparison.h"
#include "study/plot_svg.h"

namespace hsr::internal {

/// Error against run time and the like, as diagrams.
std::vector<NamedPlot> comparison_plots(const Comparison& comparison);

}  // namespace hsr::internal
