#include "hsr/face_labels.h"

namespace hsr {

std::uint32_t SceneObjects::object_of(std::span<const FaceId> faces) const {
  if (!are_told_apart() || faces.empty()) return none;
  const std::uint32_t first = of_face[faces.front().value];
  for (const FaceId f : faces)
    if (of_face[f.value] != first) return none;
  return first;
}

}  // namespace hsr
