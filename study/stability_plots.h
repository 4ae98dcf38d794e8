#pragma once

#include <vector>

#include "study/plot_svg.h"
#include "study/stability.h"

namespace hsr::internal {

/// For each family the error of some methods along the knob, from easy to hard; dashed, where the depths of a buffer are
/// predicted to be one step apart. All other methods are in the tables.
std::vector<NamedPlot> stability_plots(const Stability& stability);

}  // namespace hsr::internal
