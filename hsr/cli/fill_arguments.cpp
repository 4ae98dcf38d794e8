#include "hsr/cli/fill_arguments.h"

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

}  // namespace hsr::cli
