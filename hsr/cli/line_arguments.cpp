#include "hsr/cli/line_arguments.h"

namespace hsr::cli {

std::vector<std::string> classes_to_choose() {
  std::vector<std::string> names = {"all"};
  names.insert(names.end(), edge_class_names.begin(), edge_class_names.end());
  return names;
}

void LineArguments::add_to(Options& options) {
  options.begin_group("Lines");
  options
      .add("--edges", edges, "LIST",
           "Classes to draw, or all: outline,sharp,boundary,intersection,wire,material,smooth,joint,section,hatching")
      .with_default_shown()
      .list_of(classes_to_choose());
  options
      .add("--crease", crease, "DEG",
           "An edge is sharp if its faces deviate from flat by more than this; exactly this angle is smooth")
      .with_default_shown();
  options.add(
      "--tolerance", tolerance, "D",
      "Noise of the model, in its units: vertices nearer to each other than D are one, and an edge nearer than D to a face "
      "or an edge lies in it, for its class. What hides what stays exact");
  options
      .add("--method", method, "NAME",
           "appel, roberts, or auto: whichever suits the model; the result is the same. With --fill roberts also finds the "
           "fragments, by subtracting shadows: slower")
      .with_default_shown()
      .one_of({"auto", "appel", "roberts"});
  options.add("--stages", stages, "LIST",
              "What is left out before any exact test, to compare times; the result is the same. Of frame, convex-body, "
              "back-faces, hidden-tiles, far-faces or all, each with =auto, =always or =never, the last counts: "
              "all=never,far-faces=always");
}

}  // namespace hsr::cli
