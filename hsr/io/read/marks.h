#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hsr/io/read/gltf_transform.h"
#include "hsr/io/read/source.h"
#include "hsr/model.h"

namespace hsr::internal::read {

/// A part of a model that has marks of its own, such as a primitive of glTF, whose points and faces are counted from 0.
struct MarkedPart {
  std::string where;  ///< for messages
  std::uint32_t points = 0, faces = 0;
  std::vector<std::uint32_t> numbers;  ///< of the faces that are in the model, ascending
  /// The part may be in the model several times.
  struct Place {
    std::uint32_t first_point = 0, first_face = 0;
    Affine motion = identity;
  };
  std::vector<Place> places;
};

/// Adds what the JSON of "hsr-marks/1" says of a part, wherever it is in the model; its surfaces are numbered on from `surfaces`.
/// A circle moves with its part; where that makes no circle of it, it is not known.
/// @throws InputError as read_marks() does
void add_marks_of_part(const Source& source, const std::string& json, const MarkedPart& part, std::uint32_t& surfaces,
                       Model& model);

}  // namespace hsr::internal::read
