#pragma once

#include <cstdint>
#include <vector>

#include "hsr/model.h"

namespace hsr::internal {

/// By face of the model: the number of the first surface that is a part of the same plane, cylinder or sphere in space, to 1e-7 of the
/// largest coordinate, and of any other surface its own number; FaceLabels::none: of no surface. Empty: no surface is known.
/// Cost: O(n log n).
std::vector<std::uint32_t> shapes_of(const Model& model);

}  // namespace hsr::internal
