#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hsr/model.h"

namespace hsr::internal {

/// Some faces and wires of a model with the points that they take, and the numbers that all of these have in the whole.
struct ModelPart {
  Model model;                          ///< its names of objects, materials and colours are those of the whole
  std::vector<std::uint32_t> points;    ///< by point, ascending
  std::vector<std::uint32_t> faces;     ///< by face, ascending
  std::vector<std::uint32_t> segments;  ///< by wire, ascending
};

/// What a part is to have, each ascending.
struct PartChoice {
  std::span<const std::uint32_t> faces, segments;
  std::span<const std::uint32_t> more_points = {};  ///< that no face of the part need have
};

/// @param stands_for by point, the one that stands for it; empty: each for itself
ModelPart part_of(const Model& whole, std::span<const std::uint32_t> stands_for, const PartChoice& choice);
/// A part of a part, with the numbers in the whole.
ModelPart part_of(const ModelPart& part, const PartChoice& choice);

/// Parts of one model as one part. What several have is there once. Consumes them.
/// @throws InputError where two parts say different things of one face or point: they are not of one model
ModelPart united(std::vector<ModelPart> parts);

}  // namespace hsr::internal
