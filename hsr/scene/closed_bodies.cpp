#include "hsr/scene/closed_bodies.h"

#include <algorithm>
#include <atomic>

#include "geometry/parallel.h"

namespace hsr::internal {

ClosedBodies::ClosedBodies(const ProjectedMesh& projected, const StarShapedBodies& bodies)
    : projected_(projected), far_sides_(projected.mesh().triangles.size(), 0) {
  std::vector<std::uint8_t> is_cut(bodies.count(), 0);
  if (projected.has_near())
    parallel_for_each(far_sides_.size(), [&](std::size_t i) {
      const std::uint32_t body = bodies.body_of(TriangleId(i));
      if (body != StarShapedBodies::none && projected.reaches_before_near(TriangleId(i)))
        std::atomic_ref<std::uint8_t>(is_cut[body]).store(1, std::memory_order_relaxed);
    });
  count_ = static_cast<std::size_t>(std::count(is_cut.begin(), is_cut.end(), std::uint8_t{0}));
  is_one_convex_body_ = bodies.is_one_convex_body() && count_ == 1;
  if (count_ == 0) return;
  parallel_for_each(far_sides_.size(), [&](std::size_t i) {
    const std::uint32_t body = bodies.body_of(TriangleId(i));
    // The viewpoint is on the side facing() of the plane: the triangle is on the far side iff the inside is there, too.
    if (body != StarShapedBodies::none && is_cut[body] == 0 && projected.facing(TriangleId(i)) == bodies.inside(body))
      far_sides_[i] = 1;
  });
}

bool ClosedBodies::is_on_far_side(EdgeId e) const {
  const auto all = projected_.mesh().triangles_at(e);
  return !all.empty() && std::all_of(all.begin(), all.end(), [&](TriangleId t) { return far_sides_[t.value] != 0; });
}

}  // namespace hsr::internal
