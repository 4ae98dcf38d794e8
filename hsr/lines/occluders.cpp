#include "hsr/lines/occluders.h"

namespace hsr {

Occluders::Occluders(const Sight& sight, const std::vector<ImageBox>& boxes, const std::vector<std::uint8_t>& left_out) {
  std::vector<ImageBox> kept;
  triangles.reserve(boxes.size());
  kept.reserve(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (!sight.reaches_beyond_near(TriangleId(i)) || (!left_out.empty() && left_out[i] != 0)) continue;
    triangles.emplace_back(i);
    kept.push_back(boxes[i]);
  }
  tree = BoxTree(kept);
}

}  // namespace hsr
