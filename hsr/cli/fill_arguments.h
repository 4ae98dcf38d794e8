#pragma once

#include <string>
#include <vector>

#include "hsr/cli/command_line.h"
#include "hsr/cli/outputs.h"
#include "hsr/drawing/shading.h"
#include "hsr/scene/scene.h"
#include "hsr/surfaces/regions.h"

namespace hsr::cli {

/// What fills look like.
struct FillArguments {
  std::string merge = "none", shade = "slope";

  void add_shade_to(Options& options);
  void add_merge_to(Options& options);
  bool are_default() const { return merge == "none" && shade == "slope"; }
  /// The fragments as regions in their colours. @param model of the scene
  Regions regions(const SceneView& scene, const Model& model, const VisibleFragments& fragments) const;
};

/// Whether files of a format show fills.
bool shows_fills(Format format);
/// What is missing in files of formats that have no fills, a note for each.
std::vector<std::string> notes_on_formats_without_fills(const std::vector<Output>& outputs);

}  // namespace hsr::cli
