#pragma once

#include <functional>

#include "hsr/drawing/drawing.h"
#include "hsr/drawing/placement.h"

namespace hsr::internal {

/// draw(), with fills that are made when it is known where the drawing goes.
/// @param bounds what the page has to hold; nullptr: `lines`
/// @param fills none: an empty function @param rings with outline_only: those of the fills in the map, for arcs, or nullptr
Drawing draw_with_fills(const Mesh& mesh, const View& view, const VisibleLines& lines, const VisibleLines* bounds,
                        const DrawingOptions& options, const std::function<Fills(const Placement&)>& fills,
                        const Ragged<MapCorner>* rings = nullptr);

}  // namespace hsr::internal
