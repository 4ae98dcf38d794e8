#pragma once

#include <vector>

#include "geometry/mesh.h"
#include "hsr/image.h"
#include "hsr/raster/samples.h"
#include "hsr/scene/tie_rule.h"
#include "hsr/view/view.h"

namespace hsr::oracle {

/// What is seen at each sample, by trying every triangle in rationals: a function of the sample is kept with its changes along
/// right and down, and compared in that order.
Image<TriangleId> seen_at_samples(const Mesh& mesh, const View& view, const SampleGrid& grid,
                                  Coplanar coplanar = Coplanar::first);

/// All triangles that the line of sight of each sample meets, from near to far; of equal ones the lowest index first, or the
/// highest.
Image<std::vector<TriangleId>> layers_at_samples(const Mesh& mesh, const View& view, const SampleGrid& grid,
                                                 Coplanar coplanar = Coplanar::first);

}  // namespace hsr::oracle
