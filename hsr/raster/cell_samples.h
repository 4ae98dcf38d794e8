#pragma once

#include <cstdint>

#include "hsr/image.h"
#include "hsr/raster/samples.h"
#include "hsr/scene/scene.h"

namespace hsr::internal {

constexpr std::uint8_t no_cell = 0xff;

/// By sample, the number of the cell (ViewParts::cells) that it is in; no_cell: in none, as all is taken away there. Samples on the side of
/// a cell are decided as if moved (samples.h). Exact. @pre scene.view().has_cells()
Image<std::uint8_t> cell_samples(const SceneView& scene, const SampleGrid& samples);

/// Makes a triangle that is seen beyond the far plane, if the view has one, an invalid one. Exact, with the rule for samples on edges.
void leave_out_beyond_far(const SceneView& scene, const SampleGrid& samples, Image<TriangleId>& seen);

}  // namespace hsr::internal
