#include "hsr/cli/page_arguments.h"

#include <fmt/format.h>

#include "geometry/error.h"

namespace hsr::cli {

void PageArguments::add_to(CLI::App& app) {
  const std::string group = "Page";
  app.add_option("--page", page, "A0 ... A6 or letter, turned to suit the drawing, WIDTHxHEIGHTmm, or fit (cut to the drawing)")
      ->capture_default_str()
      ->type_name("PAGE")
      ->group(group);
  app.add_option("--scale", scale, "Paper to model, such as 1:5 or 2:1 (perspective: at the target), or fit")
      ->capture_default_str()
      ->type_name("RATIO")
      ->group(group);
  app.add_option("--unit", unit, "The model's unit: mm, cm, m or in")
      ->capture_default_str()
      ->type_name("UNIT")
      ->check(CLI::IsMember({"mm", "cm", "m", "in"}))
      ->group(group);
  app.add_option("--margin", margin, "Around the drawing, mm")->capture_default_str()->type_name("MM")->group(group);
  app.add_option("--size", size, "PNG: pixels [150 to the inch]")->type_name("WxH")->group(group);
}

DrawingOptions PageArguments::options() const {
  if (!(margin >= 0)) throw InputError(fmt::format("--margin: found {}, expected millimetres, 0 or more", margin));
  DrawingOptions options;
  options.page = parse_page(page);
  options.page.margin = margin;
  options.scale = parse_scale(scale);
  options.unit = parse_unit(unit);
  return options;
}

SampleGrid samples_for(const View& view, const Mesh& mesh, const DrawingOptions& options, int width, int height) {
  if (const auto frame = frame_size(view, options)) return sample_grid(view, *frame, width, height);
  return sample_grid(view, paper_rectangle(mesh, view), width, height);
}

}  // namespace hsr::cli
