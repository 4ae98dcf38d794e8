#pragma once

#include "hsr/lines/visible_lines.h"
#include "study/explain/trace.h"
#include "study/explain/traced_scene.h"

namespace hsr::internal {

/// The last step of a method that finds lines: the drawing that they make, as lines without a name, in which faces pierce each other,
/// are left out; and the result of the run: {"lines": [{"edge": 3, "visible": [[0, 0.5]]}, ...]}, intervals of each edge.
void end_with_lines(TraceRun& run, const ScenePicture& picture, const VisibleLines& lines);

}  // namespace hsr::internal
