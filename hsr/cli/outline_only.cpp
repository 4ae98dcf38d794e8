#include "hsr/cli/outline_only.h"

#include <vector>

#include "geometry/error.h"

namespace hsr::cli {

void ask_for_outline_only(LineOptions& lines, DrawingOptions& drawing) {
  lines.classes.fill(true);
  lines.classes[static_cast<std::size_t>(EdgeClass::wire)] = false;
  drawing.outline_only = true;
  drawing.hidden = HiddenLines::none;
}

Regions union_of_all(const SceneView& scene, const VisibleFragments& fragments) {
  if (scene.view().has_section())
    throw InputError(
        "section: the outline of everything would lack the caps, expected a view without a section, or no outline only");
  const std::vector<Colour> one_colour(scene.mesh().faces.size(), Colour{0, 0, 0, 255});
  return regions_of(scene, fragments, one_colour, Merge::colour);
}

}  // namespace hsr::cli
