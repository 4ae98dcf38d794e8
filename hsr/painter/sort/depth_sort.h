#pragma once

#include <array>
#include <cstdint>
#include <stop_token>
#include <vector>

#include "hsr/painter/painters_order.h"
#include "hsr/scene/scene.h"
#include "hsr/symbols/map_point.h"

namespace hsr {

/// Faces each of which hides a part of its predecessor, and the first a part of the last: no order of whole faces is right.
struct PaintersCycle {
  std::vector<FacetId> facets;
  /// By face, the corners of a convex part of the image in which the next face is in front of it.
  std::vector<std::vector<MapPoint>> common;
};

/// A point on each face of the cycle at which the next face is in front of it, exactly.
/// @throws PreconditionError if the cycle is of another mesh or view
std::vector<std::array<Rational, 3>> witnesses(const Mesh& mesh, const View& view, const PaintersCycle& cycle);

struct DepthSortCounts {
  std::uint64_t clusters = 0;    ///< groups that planes part: pieces are compared only within a group
  std::uint64_t candidates = 0;  ///< pairs of pieces that are compared
  std::uint64_t apart = 0, by_depth = 0, by_plane = 0, coplanar = 0, by_overlap = 0;  ///< of them, by the test that decided
  std::uint64_t overlapping = 0, piercing = 0;
  std::uint64_t cuts_at_intersections = 0, cuts_in_cycles = 0;
  std::uint64_t cyclic_components = 0, largest_component = 0;
};

struct DepthSort {
  PaintersOrder order;
  DepthSortCounts counts;
  std::vector<PaintersCycle> cycles;  ///< those that were found, and cut
};

struct DepthSortOptions {
  bool classic = false;         ///< cut every pair that the planes of the two do not separate, as the paper does
  std::size_t most_pieces = 0;  ///< beyond it the scene is refused; 0: 250 000, or 64 a face
  std::stop_token stop = {};    ///< once it is asked to stop, the work ends in a CancelledError
};

/// Depth sort: the faces from far to near, with as few cuts as needed.
///
/// The relation of every two faces whose images overlap is found by the tests of Newell, Newell & Sancha. Faces that pierce
/// each other are cut along their intersection; then, where the relations have cycles, only faces in these are cut: at a side
/// of a neighbour that parts what is painted earlier from what is painted later, and where that leads nowhere at planes. Faces
/// that hold one another in cycles, of which each pierces more than eight on average, are cut at planes from the start.
///
///   (1) along every line of sight through the interiors of two pieces the farther comes first; of coplanar ones the one
///       on top (TieRule)
///   (2) the pieces of a face cover it exactly once, beyond the near plane; faces seen edge-on have none
///   (3) a face that is in no cycle and pierces none is one piece, if it is convex
///   (4) the result does not depend on the number of threads
///
/// @throws InputError beyond the most pieces or 2^32 - 1 corners, CancelledError if asked to stop by `options.stop`
/// Exact: yes. Cost: O(n log n + k) for k pairs whose boxes overlap in the image, and the cuts.
/// Source: Newell, Newell & Sancha 1972; the graph: de Berg, van Kreveld & Schwarzkopf 1992.
DepthSort depth_sort(const SceneView& scene, const DepthSortOptions& options = {});
/// Of a scene that nothing else looks at.
inline DepthSort depth_sort(const Mesh& mesh, const View& view, const DepthSortOptions& options = {}) {
  return depth_sort(SceneView(mesh, view), options);
}

}  // namespace hsr
