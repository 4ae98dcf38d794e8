#include "hsr/scene/closed_bodies.h"

#include <algorithm>
#include <atomic>

#include "geometry/parallel.h"

namespace hsr::internal {

namespace {

bool reaches_strictly_beyond(const ProjectedMesh& projected, TriangleId t) {
  return std::ranges::any_of(projected.mesh().triangles[t],
                             [&](VertexId v) { return projected.beyond_near(v) == Sign::positive; });
}

/// By body: a section cuts it, and its cut is in a cap.
std::vector<std::uint8_t> capped_bodies(const ProjectedMesh& projected, const StarShapedBodies& bodies,
                                        const FaceLabels& labels) {
  struct Cut {
    bool is_unsure = false;
    Sign inside = Sign::zero;  // of the bodies that are cut
  };
  constexpr std::uint32_t none = 0xffffffffU;
  const Mesh& mesh = projected.mesh();
  std::vector<Cut> of_object(1);
  std::vector<std::uint32_t> object_of(bodies.count(), none);
  std::vector<std::uint8_t> is_capped(bodies.count(), 0);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const TriangleId t(i);
    const std::uint32_t object = labels.object.empty() ? 0 : labels.object[mesh.face_of[t].value], body = bodies.body_of(t);
    if (object >= of_object.size()) of_object.resize(object + 1);
    if (body != StarShapedBodies::none) {
      if (object_of[body] != none && object_of[body] != object)
        of_object[object_of[body]].is_unsure = of_object[object].is_unsure = true;
      object_of[body] = object;
    }
    if (!projected.reaches_before_near(t) ||
        std::ranges::all_of(mesh.triangles[t], [&](VertexId v) { return projected.beyond_near(v) == Sign::negative; }))
      continue;
    Cut& cut = of_object[object];
    if (body == StarShapedBodies::none || cut.inside == -bodies.inside(body)) {
      cut.is_unsure = true;
    } else {
      cut.inside = bodies.inside(body);
      is_capped[body] = 1;
    }
  }
  for (std::size_t b = 0; b < is_capped.size(); ++b)
    if (is_capped[b] != 0 && of_object[object_of[b]].is_unsure) is_capped[b] = 0;
  return is_capped;
}

}  // namespace

ClosedBodies::ClosedBodies(const ProjectedMesh& projected, const StarShapedBodies& bodies)
    : ClosedBodies(projected, bodies, std::vector<std::uint8_t>(bodies.count(), 0)) {}

ClosedBodies ClosedBodies::with_caps(const ProjectedMesh& projected, const StarShapedBodies& bodies, const FaceLabels& labels) {
  return ClosedBodies(projected, bodies, capped_bodies(projected, bodies, labels));
}

ClosedBodies::ClosedBodies(const ProjectedMesh& projected, const StarShapedBodies& bodies,
                           const std::vector<std::uint8_t>& is_capped)
    : projected_(projected), far_sides_(projected.mesh().triangles.size(), 0) {
  std::vector<std::uint8_t> is_cut(bodies.count(), 0);
  if (projected.has_near())
    parallel_for_each(far_sides_.size(), [&](std::size_t i) {
      const std::uint32_t body = bodies.body_of(TriangleId(i));
      if (body != StarShapedBodies::none && projected.reaches_before_near(TriangleId(i)))
        std::atomic_ref<std::uint8_t>(is_cut[body]).store(1, std::memory_order_relaxed);
    });
  is_one_convex_body_ = bodies.is_one_convex_body() && std::ranges::count(is_cut, std::uint8_t{0}) == 1;
  for (std::size_t b = 0; b < is_cut.size(); ++b)
    if (is_capped[b] != 0) is_cut[b] = 0;
  count_ = static_cast<std::size_t>(std::ranges::count(is_cut, std::uint8_t{0}));
  if (count_ == 0) return;
  parallel_for_each(far_sides_.size(), [&](std::size_t i) {
    const std::uint32_t body = bodies.body_of(TriangleId(i));
    // The viewpoint is on the side facing() of the plane: the triangle is on the far side iff the inside is there, too. What lies in a
    // section stays, and has no cap in front of it where its body has nothing beyond.
    const TriangleId t(i);
    if (body != StarShapedBodies::none && is_cut[body] == 0 && projected.facing(t) == bodies.inside(body) &&
        (is_capped[body] == 0 || reaches_strictly_beyond(projected, t)))
      far_sides_[i] = 1;
  });
}

bool ClosedBodies::is_on_far_side(EdgeId e) const {
  const auto all = projected_.mesh().triangles_at(e);
  return !all.empty() && std::all_of(all.begin(), all.end(), [&](TriangleId t) { return far_sides_[t.value] != 0; });
}

}  // namespace hsr::internal
