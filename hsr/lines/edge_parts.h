#pragma once

#include <vector>

#include "hsr/lines/edge_classifier.h"
#include "hsr/lines/triangle_occlusion.h"
#include "hsr/scene/occluders.h"

namespace hsr::internal {

/// A part of an edge that has one class all along.
struct EdgePart {
  PartClass found;
  Cut from, to;
};

/// The parts of an edge that lies, in part, in other faces or along their borders: where it does, these count for its class.
///
/// The parts tile the edge beyond the near plane; neighbours differ. An edge of which nothing is beyond it, or that is seen as
/// a point, has one part from start to end, and its class by its own faces; nothing is behind it.
/// @param occluders all triangles that may contain it
/// @param log takes what coincides along the parts; nullptr: hidden parts are not wanted
/// Exact: yes. Cost: O(k log k) for k triangles that overlap the edge in the image.
std::vector<EdgePart> edge_parts(const EdgeClassifier& classifier, TriangleOcclusion& occlusion, EdgeId edge,
                                 const Occluders& occluders, std::vector<CoincidentFaces>* log);

/// The same for an edge that no other faces touch.
EdgePart whole_edge(const EdgeClassifier& classifier, TriangleOcclusion& occlusion, EdgeId edge,
                    std::vector<CoincidentFaces>* log);

}  // namespace hsr::internal
