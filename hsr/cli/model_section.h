#pragma once

#include <optional>
#include <string>

#include "hsr/drawing/drawing.h"
#include "hsr/model.h"
#include "hsr/surfaces/section.h"

namespace hsr::cli {

/// What the section of a view cuts closed bodies to, for a drawing; of a view without a section, nothing.
/// @param drawing is told of it @param found outlives the drawing
/// @return a note on what does not close, or empty
std::string find_section(const Model& model, const SceneView& scene, const EdgeClasses& classes, DrawingOptions& drawing,
                         std::optional<Section>& found);

}  // namespace hsr::cli
