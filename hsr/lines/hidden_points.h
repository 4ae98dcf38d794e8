#pragma once

#include <span>
#include <vector>

#include "geometry/point.h"
#include "hsr/scene/scene.h"

namespace hsr {

/// Of each point, whether a face hides it: whether what is between it and the viewer (the open segment to the eye, or the open
/// half-line toward the viewer) meets a face, borders included, as far as the face is beyond the near plane.
///
///   (1) the rule is that of lines (docs/conventions.md, "Hidden"): a face does not hide its own points, one seen edge-on hides
///       what is behind it in its own plane, and so does one that only touches the line of sight
///   (2) what is not beyond the near plane is hidden by nothing
///   (3) the same answers for any number of threads, and whatever else is asked for in the same call
///
/// @throws InputError if a coordinate is not finite
/// Exact: yes. Cost: O(n log n) once for the tree of the scene; O(log n + k) a point for k faces whose boxes are before it,
/// parallel. Ask for many points at once.
std::vector<bool> hidden_points(const SceneView& scene, std::span<const Point3> points);

/// Of one point.
inline bool is_hidden(const SceneView& scene, const Point3& point) { return hidden_points(scene, {&point, 1})[0]; }

}  // namespace hsr
