#include "hsr/cli/page_arguments.h"

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

}  // namespace hsr::cli
