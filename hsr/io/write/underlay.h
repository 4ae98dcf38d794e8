#pragma once

#include <array>

namespace hsr::internal {

/// The pens, mm, with which fills are underlaid in their own colours before they are painted: where two of them meet, a viewer
/// that smooths edges covers a pixel by neither wholly, and the paper would shine through. The broad one serves where a pixel
/// is large, the fine one, last, shows no colour but those of the two.
constexpr std::array<double, 3> underlay_widths = {4, 1, 0.25};

}  // namespace hsr::internal
