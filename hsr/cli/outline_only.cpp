#include "hsr/cli/outline_only.h"

#include <vector>

namespace hsr::cli {

void ask_for_outline_only(LineOptions& lines, DrawingOptions& drawing) {
  lines.classes.fill(true);
  lines.classes[static_cast<std::size_t>(EdgeClass::wire)] = false;
  drawing.outline_only = true;
  drawing.hidden = HiddenLines::none;
}

Regions union_of_all(const SceneView& scene, const VisibleFragments& fragments) {
  const std::vector<Colour> one_colour(scene.mesh().faces.size(), Colour{0, 0, 0, 255});
  return regions_of(scene, fragments, one_colour, Merge::colour);
}

}  // namespace hsr::cli
