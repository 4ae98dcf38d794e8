#include "hsr/lines/occluders.h"

namespace hsr {

Occluders::Occluders(const Sight& sight, const std::vector<ImageBox>& boxes, const std::vector<std::uint8_t>& left_out) {
  triangles.reserve(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (sight.reaches_beyond_near(TriangleId(i)) && (left_out.empty() || left_out[i] == 0)) triangles.emplace_back(i);
  if (triangles.size() == boxes.size()) {
    tree = BoxTree(boxes);
    return;
  }
  std::vector<ImageBox> kept;
  kept.reserve(triangles.size());
  for (const TriangleId t : triangles) kept.push_back(boxes[t.value]);
  tree = BoxTree(kept);
}

}  // namespace hsr
