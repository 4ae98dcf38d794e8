#pragma once

#include <vector>

#include "hsr/coordinates/placed_point.h"
#include "hsr/painter/painters_order.h"
#include "hsr/scene/scene.h"
#include "hsr/surfaces/fragments.h"

namespace hsr {

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
