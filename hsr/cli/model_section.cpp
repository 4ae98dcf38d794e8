#include "hsr/cli/model_section.h"

#include <fmt/core.h>

#include "hsr/cli/output_summary.h"
#include "hsr/drawing/shading.h"

namespace hsr::cli {

namespace {

/// What a section did not cut to caps; empty: nothing.
std::string note_on(const Section& section) {
  if (section.open_outlines > 0)
    return fmt::format("{} of the cut {} not close, so nothing is hatched there: their surface is open",
                       counted(section.open_outlines, "outline"), section.open_outlines == 1 ? "does" : "do");
  return section.lines.empty() ? "the section cuts no closed body" : "";
}

}  // namespace

void ModelSection::find(const ViewedModel& model, const SceneView& scene, const EdgeClasses& classes, DrawingOptions& drawing,
                        CommandContext& context) {
  if (!model.view().section) return;
  context.progress.stage("section");
  section_ = context.report.timed("section", [&] { return section(scene); });
  drawing.section = &*section_;
  drawing.section_classes = classes;
  const std::vector<Colour> colours = face_colours(model.model, model.mesh, model.view(), Shading::none);
  for (const SectionCap& cap : section_->caps) drawing.cap_colours.push_back(colours[cap.face.value]);
  context.report.set("section", {{"caps", section_->caps.size()},
                                 {"rings", section_->rings.size()},
                                 {"lines", section_->lines.size()},
                                 {"open_outlines", section_->open_outlines}});
  if (const std::string text = note_on(*section_); !text.empty()) context.note(text);
}

}  // namespace hsr::cli
