#pragma once

#include <cstdint>
#include <vector>

#include "geometry/point.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/painter/painters_order.h"
#include "hsr/scene/scene.h"
#include "hsr/surfaces/visible_fragments.h"

namespace hsr {

/// A point of a result in numbers. Each is the double nearest to the exact coordinate, ties to even, and never -0; beyond the
/// largest double, an infinity.
struct PlacedPoint {
  Point3 space;  ///< in the coordinates of the mesh
  Point2 paper;  ///< in the view's frame: x to the right, y up, in units of the frame

  friend bool operator==(const PlacedPoint&, const PlacedPoint&) = default;
};

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
/// @throws std::out_of_range if the segment is of none of the lines
/// Exact: yes. Cost: that of one edge of roberts().
std::vector<FaceId> occluders_of(const SceneView& scene, const VisibleLines& lines, const Segment& segment);

/// A part of a face in numbers.
struct PlacedPolygon {
  FaceId face;
  FacetId facet;  ///< the planar piece of the face that it lies in
  /// The outer ring first, counter-clockwise as seen; the others are holes, clockwise.
  std::vector<std::vector<PlacedPoint>> rings;
};

/// The fragments as polygons with coordinates, in their order.
/// @pre `fragments` are of this scene
/// @throws PreconditionError if the origin of the view's frame is not in front of the eye
/// Exact: rounded once, each coordinate correctly (PlacedPoint). Cost: O(n), parallel.
std::vector<PlacedPolygon> polygons(const SceneView& scene, const VisibleFragments& fragments);

/// The pieces of a painter's order as polygons with coordinates, from far to near: one convex ring each.
/// @pre `order` is of this scene
/// @throws PreconditionError if the origin of the view's frame is not in front of the eye
/// Exact: rounded once, each coordinate correctly (PlacedPoint). Cost: O(n), parallel.
std::vector<PlacedPolygon> polygons(const SceneView& scene, const PaintersOrder& order);

}  // namespace hsr
