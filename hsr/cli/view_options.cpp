#include "hsr/cli/view_options.h"

namespace hsr::cli {

void ViewOptions::add_to(Options& options) {
  options.begin_group("View");
  options
      .add("--view", name, "NAME", "front, back, left, right, top, bottom or iso [iso]; camera:NAME: a camera of a glTF file")
      .such_as({"front", "back", "left", "right", "top", "bottom", "iso"});
  options.add("--eye", eye, "X,Y,Z", "Perspective from this point");
  options.add("--target", target, "X,Y,Z", "The point looked at [centre of the bounding box]");
  options.add("--direction", direction, "X,Y,Z", "Parallel view; the direction points toward the viewer");
  options.add("--up", up, "X,Y,Z", "What is up on the paper [the up axis, or what it can be]");
  options.add("--oblique", oblique, "DEG,RATIO",
              "Parallel view whose front stays true: what recedes is drawn at DEG from the horizontal and RATIO times as long. "
              "Cavalier: 45,1; cabinet: 45,0.5; with --view top planometric: 270,1. Of --view [front] or --direction");
  options.add("--fov", field_of_view, "DEG",
              "Perspective: frame this angle, across the shorter side, instead of all beyond the near plane");
  options.add_one_each(
      "--section", sections, "PLANE",
      "Take away what is on the viewer's side of a plane, such as x=12.5, or a normal and a point: NX,NY,NZ@X,Y,Z; closed "
      "bodies are cut to hatched faces. May be repeated: what is in front of all planes goes. Of a plane that is seen edge-on "
      "say "
      "what is left: x=..12.5 or x=12.5.., or by the normal");
  options.add("--depth", depth, "D", "Leave out what is farther than D behind the plane of the section, of several the first");
  options.add("--near", near, "D", "Perspective: distance of the near plane [a thousandth of eye to target]");
  options.add("--up-axis", up_axis, "AXIS", "The model's up axis, y or z: turns the views, never the model [glTF: y, else z]")
      .one_of({"y", "z"});
}

}  // namespace hsr::cli
