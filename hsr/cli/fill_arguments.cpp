#include "hsr/cli/fill_arguments.h"

#include <algorithm>

namespace hsr::cli {

using namespace internal;

void FillArguments::add_shade_to(Options& options) {
  options.add("--shade", shade, "HOW", "Fills are darker by the slope of their faces, or not: slope or none")
      .with_default_shown()
      .one_of({"slope", "none"});
}

void FillArguments::add_merge_to(Options& options) {
  options
      .add("--merge", merge, "WHICH",
           "With --fill: unite neighbours of one colour: none, coplanar (only in one plane) or colour")
      .with_default_shown()
      .one_of({"none", "coplanar", "colour"});
}

Regions FillArguments::regions(const SceneView& scene, const Model& model, const VisibleFragments& fragments) const {
  const Shading shading = shade == "none" ? Shading::none : Shading::slope;
  const Merge which = merge == "none" ? Merge::none : merge == "coplanar" ? Merge::coplanar : Merge::colour;
  return regions_of(scene, fragments, face_colours(model, scene.mesh(), scene.view(), shading), which);
}

bool shows_fills(Format format) { return format != Format::dxf && format != Format::hpgl; }

std::vector<std::string> notes_on_formats_without_fills(const std::vector<Output>& outputs) {
  std::vector<std::string> notes;
  for (const Format format : {Format::dxf, Format::hpgl})
    if (std::any_of(outputs.begin(), outputs.end(), [&](const Output& o) { return o.format == format; }))
      notes.push_back(std::string(name_of(format)) + " has the lines only, no filled areas");
  return notes;
}

}  // namespace hsr::cli
