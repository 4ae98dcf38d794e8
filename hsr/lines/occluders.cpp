#include "hsr/lines/occluders.h"

#include <tbb/parallel_for.h>

namespace hsr {

Occluders::Occluders(const Sight& sight) {
  const Mesh& mesh = sight.mesh();
  triangles.reserve(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    if (sight.reaches_beyond_near(TriangleId(i))) triangles.emplace_back(i);
  std::vector<ImageBox> boxes(triangles.size());
  using Range = tbb::blocked_range<std::size_t>;
  tbb::parallel_for(Range(0, boxes.size(), 1024), [&](const Range& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) boxes[i] = sight.box(triangles[i]);
  });
  tree = BoxTree(boxes);
}

}  // namespace hsr
