#pragma once

#include <array>
#include <vector>

#include "geometry/enclosure.h"
#include "hsr/drawing/page.h"

namespace hsr::internal {

/// What of a polygon lies in the frame; millimetres. The paper ends there: this decides nothing else.
/// Source: Sutherland & Hodgman 1974.
std::vector<PaperPoint> clipped(std::vector<std::array<Enclosure::Wide, 2>> ring, const PaperFrame& frame);

/// Corners that fall on the one before them are left out; nothing is left of what has fewer than three others.
void drop_repeated(std::vector<PaperPoint>& ring);

}  // namespace hsr::internal
