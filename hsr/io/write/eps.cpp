#include "hsr/io/write/eps.h"

#include <cmath>

#include "geometry/error.h"
#include "hsr/io/write/layers.h"
#include "hsr/io/write/line_paths.h"
#include "hsr/io/write/painted_paths.h"
#include "hsr/io/write/svg_text.h"
#include "hsr/utf8.h"

namespace hsr::internal {

namespace {

/// PDF's operators in PostScript. One colour serves filling and drawing: each path sets its own.
const char* const prologue = R"(%%BeginProlog
/hsr 16 dict def hsr begin
/m {moveto} bind def /l {lineto} bind def /c {curveto} bind def /h {closepath} bind def /n {newpath} bind def
/S {stroke} bind def /f {fill} bind def
/w {setlinewidth} bind def /J {setlinecap} bind def /j {setlinejoin} bind def /d {setdash} bind def
/rg {setrgbcolor} bind def /RG {setrgbcolor} bind def
/q {gsave} bind def /Q {grestore} bind def /cm {6 array astore concat} bind def
end
%%EndProlog
)";

}  // namespace

std::string eps(const Drawing& drawing, const std::string& title) {
  for (const Fill& fill : drawing.fills.fills)
    if (fill.opacity < 1)
      throw InputError("eps: found faces that are seen through, expected opaque ones: pdf and svg have both");
  const double width = points_of(drawing.width), height = points_of(drawing.height);
  std::string out = "%!PS-Adobe-3.0 EPSF-3.0\n%%Creator: hsr\n%%Title: " + printable(title) + "\n%%BoundingBox: 0 0 ";
  append_length(out, std::ceil(width));
  out += ' ';
  append_length(out, std::ceil(height));
  out += "\n%%HiResBoundingBox: 0 0 ";
  append_length(out, width);
  out += ' ';
  append_length(out, height);
  out += "\n%%LanguageLevel: 2\n%%Pages: 1\n%%EndComments\n";
  out += prologue;
  out += "%%Page: 1 1\nhsr begin\nq\n";
  append_page_space(out, drawing.height);
  if (!drawing.fills.fills.empty()) {
    out += "% layer: fill\n";
    append_fills(out, drawing.fills, drawing.pens, {});
  }
  for (const Layer& layer : layers_of(drawing)) {
    out += "% layer: " + layer.name() + "\n";
    append_pen(out, layer.pen);
    ObjectComments objects(drawing.objects);
    for (const Polyline& p : layer.polylines) {
      objects.append(out, p.object);
      append_line(out, drawing, p, layer.pen);
    }
  }
  out += "Q\nend\n%%Trailer\n%%EOF\n";
  return out;
}

}  // namespace hsr::internal
