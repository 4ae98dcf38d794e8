#pragma once

#include <string>

#include "hsr/lines/visible_lines.h"
#include "hsr/scene/scene.h"

namespace hsr {

/// What is drawn of a scene, whatever lines it is made of: for each straight line of the image the parts that are inked, each with
/// its visibility and its class, in exact coordinates of the view's frame. Visible lies over hidden, and of coinciding lines the
/// first of outline, boundary, sharp, intersection, material, wire, joint is drawn; smooth edges are not.
///
/// Two scenes that are one set of points give the same text. Cost: rationals, so small scenes only.
/// @param tolerance LineOptions::tolerance
std::string ink_of(const SceneView& scene, double tolerance = 0);

}  // namespace hsr
