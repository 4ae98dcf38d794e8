#pragma once

#include "hsr/drawing/drawing.h"
#include "hsr/tiles/model_part.h"

namespace hsr::internal {

/// Gives the points and faces that a drawing names the numbers that they have in the whole model.
inline void give_numbers(Drawing& drawing, const ModelPart& part) {
  for (auto& edge : drawing.edges)
    for (std::uint32_t& point : edge) point = part.points[point];
  for (std::uint32_t& face : drawing.faces) face = part.faces[face];
  for (std::uint32_t& face : drawing.fills.faces) face = part.faces[face];
}

}  // namespace hsr::internal
