#include "hsr/cli/model_section.h"

#include <fmt/core.h>

#include "hsr/drawing/shading.h"

namespace hsr::cli {

std::string find_section(const Model& model, const SceneView& scene, const EdgeClasses& classes, DrawingOptions& drawing,
                         std::optional<Section>& found) {
  if (!scene.view().has_section()) return "";
  found = section(scene);
  drawing.section = &*found;
  drawing.section_classes = classes;
  const std::vector<Colour> colours = internal::face_colours(model, scene.mesh(), scene.view(), internal::Shading::none);
  for (const SectionCap& cap : found->caps) drawing.cap_colours.push_back(colours[cap.face.value]);
  if (found->open_outlines > 0)
    return fmt::format("{} outline{} of the cut {} not close, so nothing is hatched there: the surface is open",
                       found->open_outlines, found->open_outlines == 1 ? "" : "s", found->open_outlines == 1 ? "does" : "do");
  return found->caps.empty() && found->lines.empty() ? "the section cuts no closed body" : "";
}

}  // namespace hsr::cli
