#include "hsr/occluders.h"

#include "hsr/parallel.h"

namespace hsr {

Occluders::Occluders(const Sight& sight, const std::vector<ImageBox>& boxes, const std::vector<std::uint8_t>& left_out) {
  triangles = collected<TriangleId>(boxes.size(), [&](std::size_t begin, std::size_t end, std::vector<TriangleId>& part) {
    for (std::size_t i = begin; i < end; ++i)
      if (sight.reaches_beyond_near(TriangleId(i)) && (left_out.empty() || left_out[i] == 0)) part.emplace_back(i);
  });
  if (triangles.size() == boxes.size()) {
    tree = BoxTree(boxes);
    return;
  }
  std::vector<ImageBox> kept(triangles.size());
  for_each(kept.size(), [&](std::size_t i) { kept[i] = boxes[triangles[i].value]; });
  tree = BoxTree(kept);
}

}  // namespace hsr
