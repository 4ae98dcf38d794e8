#include "hsr/cli/sheet_arguments.h"

namespace hsr::cli {

void SheetArguments::add_to(Options& options) {
  options.begin_group("Sheet");
  options.add("--page", page, "SHEET", "A0 ... A4, ANSI-A or ANSI-B")
      .with_default_shown()
      .such_as({"A0", "A1", "A2", "A3", "A4", "ANSI-A", "ANSI-B"});
  options.add("--angle", angle, "KIND", "first or third: where views stand [ANSI: third, else first]")
      .one_of({"first", "third"});
  options
      .add("--scale", scale, "RATIO",
           "Of all views but details, such as 1:5, or standard: the largest of 1:1, 1:2, 1:5, 1:10, ..., "
           "2:1, 5:1, ... that fits")
      .with_default_shown()
      .such_as({"standard"});
  options.add("--unit", unit, "UNIT", "The model's unit: mm, cm, m or in [glTF: m, else mm]").one_of({"mm", "cm", "m", "in"});
  options.add("--views", views, "LIST", "Some of front, top, side, iso, with commas between")
      .with_default_shown()
      .list_of({"front", "top", "side", "iso"});
  options.add_one_each(
      "--section", sections, "PLANE",
      "Also the section by this plane, such as x=12.5 or NX,NY,NZ@X,Y,Z, as A-A with its cutting line; may be repeated");
  options.add_one_each("--detail", details, "VIEW:X,Y,Z:RADIUS:SCALE",
                       "Also what is within RADIUS of a point of a view, larger: front:10,0,5:4:5:1; may be repeated");
  options.add("--dimensions", dimensions, "WHICH", "overall: width, height and depth; or none")
      .with_default_shown()
      .one_of({"overall", "none"});
  options.add("--centre-lines", centre_lines, "WHICH", "Centre lines of circles, and axes: on or off")
      .with_default_shown()
      .one_of({"on", "off"});
  options.add_one_each(
      "--title", titles, "NAME=TEXT",
      "A field of the title block: owner, title, subtitle, number, creator, approver, type, material, date, revision, language "
      "or sheet; may be repeated");
  options.add("--title-block", title_file, "FILE",
              "Fields of the title block as JSON, such as {\"title\": \"Bracket\"}; --title counts more");
  options.add("--size", size, "WxH", "PNG: pixels [150 to the inch]");
  formats.add_dxf_to(options);
  options.add_one_each("--pen", pens, "NAME=MM[:COLOUR[:DASH]]", "Pens of the views' lines, as hsr draw has them");
  options.add("--fit-arcs", fit_arcs, "MM",
              "Draw lines that lie on one circle, within this on paper, as arcs, as hsr draw does");
  options.begin_group("Scene");
  options.add("--up-axis", up_axis, "AXIS", "What is up in the model: y or z [glTF: y, else z]").one_of({"y", "z"});
  scene.add_to(options);
  options.begin_group("Lines");
  options.add("--hidden", hidden, "STYLE", "Hidden lines of front, top and side: none, dashed or solid")
      .with_default_shown()
      .one_of({"none", "dashed", "solid"});
  lines.add_to(options);
}

}  // namespace hsr::cli
