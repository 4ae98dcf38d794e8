#pragma once

#include <string>

#include "geometry/mesh.h"
#include "hsr/cli/report.h"
#include "hsr/drawing/drawing.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/model.h"
#include "hsr/surfaces/visible_fragments.h"
#include "hsr/view/view.h"

namespace hsr::cli {

using namespace internal;

/// What --report says of the lines of a model.
void describe(Report& report, const Model& model, const Mesh& mesh, const VisibleLines& lines);
void describe(Report& report, const Drawing& drawing);

/// The visible area of each face and each object that has one, in squares of the view's frame.
Report::Json areas_json(const Model& model, const Mesh& mesh, const View& view, const VisibleFragments& fragments, bool exact);

/// "12 lines, 3 arcs": the straight ones, of which those that were joined end to end count each, and the arcs.
std::string counted_lines(const Drawing& drawing);

}  // namespace hsr::cli
