#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/mesh.h"
#include "hsr/image.h"
#include "hsr/painter/painters_order.h"
#include "hsr/raster/samples.h"
#include "hsr/scene/scene.h"
#include "hsr/surfaces/visible_fragments.h"
#include "hsr/view/view.h"

namespace hsr {

/// A sample at which fragments and the caster differ.
struct WrongSample {
  int i = 0, j = 0;
  FaceId painted, cast;  ///< not valid: nothing
};

struct FragmentCheck {
  std::uint64_t samples = 0;
  std::uint64_t covered = 0;             ///< of them, with a face
  std::uint64_t wrong = 0;               ///< painted with another face than the caster finds
  std::uint64_t overlapping = 0;         ///< painted more than once
  std::vector<WrongSample> first_wrong;  ///< at most ten

  bool is_right() const { return wrong == 0 && overlapping == 0; }
};

/// The facet that the fragments show at each sample: its first triangle; not valid: none. @param overlapping gets how often a
/// sample was painted again
/// @throws PreconditionError as cast() does, and if a fragment is not in front of the eye as the samples are
Image<TriangleId> paint(const SceneView& scene, const VisibleFragments& fragments, const SampleGrid& samples,
                        std::uint64_t& overlapping);
/// Of a scene that nothing else looks at.
inline Image<TriangleId> paint(const Mesh& mesh, const View& view, const VisibleFragments& fragments, const SampleGrid& samples,
                               std::uint64_t& overlapping) {
  return paint(SceneView(mesh, view), fragments, samples, overlapping);
}

/// Paints the fragments and compares each sample with the nearest face along its line of sight, edges and ties included: object
/// space against image space.
///
/// @throws PreconditionError as paint() does
/// Exact: yes. Cost: that of cast() and of painting.
FragmentCheck check_fragments(const SceneView& scene, const VisibleFragments& fragments, const SampleGrid& samples);
/// Of a scene that nothing else looks at.
inline FragmentCheck check_fragments(const Mesh& mesh, const View& view, const VisibleFragments& fragments,
                                     const SampleGrid& samples) {
  return check_fragments(SceneView(mesh, view), fragments, samples);
}
/// Compares with a picture that cast() has already made. @param nearest what cast() gives for these samples
/// @throws PreconditionError as paint() does
FragmentCheck check_fragments(const SceneView& scene, const VisibleFragments& fragments, const SampleGrid& samples,
                              const Image<TriangleId>& nearest);
/// Of a scene that nothing else looks at.
inline FragmentCheck check_fragments(const Mesh& mesh, const View& view, const VisibleFragments& fragments,
                                     const SampleGrid& samples, const Image<TriangleId>& nearest) {
  return check_fragments(SceneView(mesh, view), fragments, samples, nearest);
}

struct OrderCheck {
  std::uint64_t samples = 0;
  std::uint64_t covered = 0;                ///< of them, with a face
  std::uint64_t wrong = 0;                  ///< where the painting shows another face than the nearest
  std::array<int, 2> first_wrong = {0, 0};  ///< column and row
};

/// Paints the order and compares each sample with the nearest face along its line of sight, edges and ties included.
///
/// @throws PreconditionError as cast() does
/// Exact: yes. Cost: that of cast() and of painting.
OrderCheck check_order(const SceneView& scene, const PaintersOrder& order, const SampleGrid& samples);
/// Of a scene that nothing else looks at.
inline OrderCheck check_order(const Mesh& mesh, const View& view, const PaintersOrder& order, const SampleGrid& samples) {
  return check_order(SceneView(mesh, view), order, samples);
}

}  // namespace hsr
