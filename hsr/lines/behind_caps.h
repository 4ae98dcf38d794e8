#pragma once

#include "hsr/lines/line_options.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/scene/projected_mesh.h"
#include "hsr/scene/section_caps.h"

namespace hsr::internal {

/// The lines with what the caps of a section hide, and their borders: these are nearer than all else that is left.
/// Exact: yes. Cost: O(m) signs for each line whose box in the plane m sides of caps touch, and a place in the plane for each part.
VisibleLines behind_caps(const ProjectedMesh& projected, const SectionCaps& caps, const LineOptions& options,
                         VisibleLines lines);

}  // namespace hsr::internal
