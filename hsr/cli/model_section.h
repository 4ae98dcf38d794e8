#pragma once

#include <optional>

#include "hsr/cli/command_context.h"
#include "hsr/drawing/drawing.h"
#include "hsr/surfaces/section.h"

namespace hsr::cli {

/// What the section of a view cuts closed bodies to, for a drawing.
class ModelSection {
 public:
  /// Finds it and tells the drawing, with a note on what does not close; of a view without a section, nothing.
  /// @pre this outlives the drawing
  void find(const ViewedModel& model, const SceneView& scene, const EdgeClasses& classes, DrawingOptions& drawing,
            CommandContext& context);

 private:
  std::optional<Section> section_;
};

}  // namespace hsr::cli
