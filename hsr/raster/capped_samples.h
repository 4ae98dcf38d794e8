#pragma once

#include <cstdint>

#include "hsr/image.h"
#include "hsr/raster/samples.h"
#include "hsr/scene/scene.h"

namespace hsr::internal {

/// At which samples a cap of the view's section is seen, which is nearer than every face: 1 there. An empty image: the view has none.
/// Samples on a border are decided as if moved (samples.h). Exact: yes. Parallel.
Image<std::uint8_t> capped_samples(const SceneView& scene, const SampleGrid& samples);

}  // namespace hsr::internal
