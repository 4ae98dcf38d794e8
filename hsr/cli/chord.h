#pragma once

#include "geometry/mesh.h"
#include "hsr/drawing/drawing.h"
#include "hsr/view/view.h"

namespace hsr::cli {

/// How far the chords of curves and curved surfaces may be from them for a drawing: in units of the model, what is `on_paper` where the
/// drawing is largest, which in a perspective is in front, up to 20 times as large as at the target. More than 0.
/// @param coarse any mesh of the model: it has the right size
/// @param on_paper mm
double chord_for(const Mesh& coarse, const View& view, const DrawingOptions& page, double on_paper);

}  // namespace hsr::cli
