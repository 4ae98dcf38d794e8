#include <algorithm>

#include "hsr/face_labels.h"

namespace hsr {

std::uint32_t SceneObjects::object_of(std::span<const FaceId> faces) const {
  if (!are_told_apart() || faces.empty()) return none;
  const std::uint32_t first = of_face[faces.front().value];
  for (const FaceId f : faces)
    if (of_face[f.value] != first) return none;
  return first;
}

std::uint32_t SceneObjects::object_of_wire(EdgeId edge) const {
  const auto at =
      std::lower_bound(wires.begin(), wires.end(), edge, [](const Wire& w, EdgeId wanted) { return w.edge < wanted; });
  return at != wires.end() && at->edge == edge ? at->object : none;
}

}  // namespace hsr
