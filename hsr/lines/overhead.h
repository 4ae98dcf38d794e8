#pragma once

#include "hsr/lines/line_options.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/scene/scene.h"

namespace hsr {

/// The lines, and among them those of what the section takes away, of class `overhead`: a plan shows so what is above it.
///
/// Who stands in the plane and looks the other way, toward the viewer, sees these: outlines, boundaries, sharp edges and intersections of
/// what is in front of the plane, where nothing there hides them, caps neither. What lies in the plane is not taken away.
///
/// @param lines of this scene, without any of these
/// @throws InputError if the view is a perspective, or has no section that faces the viewer
/// Exact: yes. Cost: that of visible_lines() of the view the other way.
VisibleLines with_overhead(const SceneView& scene, const LineOptions& options, VisibleLines lines);

}  // namespace hsr
