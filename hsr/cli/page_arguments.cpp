#include "hsr/cli/page_arguments.h"

#include <fmt/core.h>

#include "geometry/error.h"
#include "hsr/cli/model_defaults.h"

namespace hsr::cli {

void PageArguments::add_to(Options& options, const std::string& size_help) {
  options.begin_group("Page");
  options
      .add("--page", page, "PAGE",
           "A0 ... A6 or letter, turned to suit the drawing, WIDTHxHEIGHTmm, or fit (cut to the drawing)")
      .with_default_shown();
  options.add("--scale", scale, "RATIO", "Paper to model, such as 1:5 or 2:1 (perspective: at the target), or fit")
      .with_default_shown();
  options.add("--unit", unit, "UNIT", "The model's unit: mm, cm, m or in [glTF: m, else mm]").one_of({"mm", "cm", "m", "in"});
  options.add("--margin", margin, "MM", "Around the drawing, mm").with_default_shown();
  options.add(
      "--min-length", min_length, "MM",
      "Leave out lines that together with what they are joined to are shorter than this on paper, such as freckles on scans");
  options.add("--size", size, "WxH", size_help);
}

DrawingOptions PageArguments::options() const {
  if (!(margin >= 0)) throw InputError(fmt::format("--margin: found {}, expected millimetres, 0 or more", margin));
  DrawingOptions options;
  options.page = parse_page(page);
  options.page.margin = margin;
  if (!(min_length >= 0)) throw InputError(fmt::format("--min-length: found {}, expected millimetres, 0 or more", min_length));
  options.min_length = min_length;
  options.scale = parse_scale(scale);
  if (!unit.empty()) options.unit = parse_unit(unit);
  return options;
}

std::string PageArguments::adopt_unit(const Model& model, DrawingOptions& options) const {
  options.unit = unit_of(unit, model);
  return unit.empty() && options.scale ? unit_note(model) : std::string();
}

SampleGrid samples_for(const View& view, const Mesh& mesh, const DrawingOptions& options, int width, int height) {
  if (const auto frame = frame_size(view, options)) return sample_grid(view, *frame, width, height);
  return sample_grid(view, paper_rectangle(mesh, view), width, height);
}

}  // namespace hsr::cli
