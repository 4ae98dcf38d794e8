#pragma once

#include <cstdint>
#include <vector>

#include "hsr/coordinates/placed_point.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/scene/scene.h"

namespace hsr {

/// A visible or a hidden part of an edge, or of where two faces pierce each other, in numbers.
struct Segment {
  PlacedPoint from, to;
  EdgeClass edge_class = EdgeClass::smooth;
  bool is_hidden = false;
  bool is_behind = false;      ///< Line::is_behind: hidden by what it touches
  VertexId a, b;               ///< the edge runs from a to b; not valid: an intersection
  std::vector<FaceId> faces;   ///< at the edge, or the two of an intersection; ascending, each once
  std::uint32_t line = 0;      ///< it is a part of lines[line],
  std::uint32_t interval = 0;  ///< from its cut number `interval` to the next: exact_point() says where these are
};

/// The lines as segments with coordinates: each visible and each hidden interval.
///
///   (1) in the order of the lines, and along each
///   (2) coordinates are correctly rounded (PlacedPoint); neighbours along a line share an end to the bit
///   (3) the same for any number of threads
///
/// @pre `lines` are of this scene
/// @throws PreconditionError if the origin of the view's frame is not in front of the eye
/// Exact: rounded once. Cost: O(n), parallel; rationals only where enclosures leave two doubles open.
std::vector<Segment> segments(const SceneView& scene, const VisibleLines& lines);

/// The faces that hide a part of the segment, ascending, each once; of a visible segment none. What only touches a surface from
/// behind may have none, too.
/// Exact: yes. Cost: that of one edge of roberts().
std::vector<FaceId> occluders_of(const SceneView& scene, const VisibleLines& lines, const Segment& segment);

}  // namespace hsr
