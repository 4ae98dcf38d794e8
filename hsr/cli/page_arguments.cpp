#include "hsr/cli/page_arguments.h"

namespace hsr::cli {

void PageArguments::add_to(Options& options, const std::string& size_help) {
  options.begin_group("Page");
  options
      .add("--page", page, "PAGE",
           "A0 ... A6 or letter, turned to suit the drawing, WIDTHxHEIGHTmm, or fit (cut to the drawing)")
      .with_default_shown()
      .such_as({"A0", "A1", "A2", "A3", "A4", "A5", "A6", "letter", "fit"});
  options
      .add("--scale", scale, "RATIO",
           "Paper to model, such as 1:5 or 2:1 (perspective: at the target), fit, or standard: the largest of 1:1, 1:2, 1:5, "
           "1:10, ..., 2:1, 5:1, ... that fits")
      .with_default_shown()
      .such_as({"fit", "standard"});
  options.add("--unit", unit, "UNIT", "The model's unit: mm, cm, m or in [glTF: m, else mm]").one_of({"mm", "cm", "m", "in"});
  options.add("--margin", margin, "MM", "Around the drawing, mm").with_default_shown();
  options.add(
      "--min-length", min_length, "MM",
      "Leave out lines that together with what they are joined to are shorter than this on paper, such as freckles on scans");
  options.add("--size", size, "WxH", size_help);
}

void PageArguments::add_pens_to(Options& options) {
  options.add_one_each(
      "--pen", pens, "NAME=MM[:COLOUR[:DASH]]",
      "Pens, one or more with commas between, such as visible=0.35,hidden-sharp=0.18:#555. NAME: visible, hidden, a class, or "
      "both as hidden-sharp, and what says most of a line counts; COLOUR: #rgb, #rrggbb or a name such as red; DASH: solid, "
      "dashed, dotted, chain, or mm such as 3-0.75; any may be missing. Else ISO 128 for the page: 0.5 and 0.25 mm on A4 to "
      "A2");
  options.add("--pens", pens_file, "FILE", "Pens, one NAME=MM:COLOUR:DASH to a line, # for comments; --pen counts more");
}

void PageArguments::add_fit_arcs_to(Options& options) {
  options.add(
      "--fit-arcs", fit_arcs, "MM",
      "Draw lines whose edges lie on one circle in space, within this on paper, as arcs of circles and ellipses: of 4 edges "
      "or more that turn by at most 35 degrees each, of any number where a B-rep or marks say so. DXF: as CIRCLE and ARC, and "
      "in release 2000 ELLIPSE. Fills keep their corners");
}

void PageArguments::add_sort_to(Options& options) {
  options
      .add("--sort", sort, "HOW",
           "pen: each layer's lines in an order for short ways with the pen up, joined where one begins at the end of "
           "another; or none")
      .with_default_shown()
      .one_of({"none", "pen"});
}

}  // namespace hsr::cli
