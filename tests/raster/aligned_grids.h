#pragma once

#include <vector>

#include "hsr/raster/samples.h"

namespace hsr {

/// Small grids whose samples meet vertices and edges: along the axes for views along one, through vertices, and the usual one.
/// Only those that are exact.
std::vector<SampleGrid> aligned_grids(const Mesh& mesh, const View& view);

}  // namespace hsr
