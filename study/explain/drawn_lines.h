#pragma once

#include <string>
#include <vector>

#include "hsr/lines/visible_lines.h"
#include "study/explain/trace.h"
#include "study/explain/traced_scene.h"

namespace hsr::internal {

/// The lines that are left, as a drawing has them. Those in which faces pierce each other are left out: they have no name here.
std::vector<TraceLine> drawn_lines(const ScenePicture& picture, const VisibleLines& lines);

/// The visible intervals of each edge, as the result of a run: {"lines": [{"edge": 3, "visible": [[0, 0.5]]}, ...]}.
std::string lines_result(const ExplainedScene& scene, const VisibleLines& lines);

}  // namespace hsr::internal
