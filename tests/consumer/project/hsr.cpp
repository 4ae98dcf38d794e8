// The exact core: a cube seen from the front shows four lines, and they are drawn as one closed polyline.
#include <cstdio>

#include "cube.h"
#include "hsr/drawing/drawing.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/view/view.h"

#if defined(CGAL_VERSION) || defined(CGAL_CONFIG_H)
#error "a public header includes CGAL"
#endif

int main() {
  const hsr::Mesh mesh = cube();
  const hsr::View view = hsr::named_view("front", hsr::centre(mesh));
  const hsr::VisibleLines lines = hsr::visible_lines(mesh, view);
  int visible = 0;
  for (const auto& line : lines.lines)
    for (std::uint32_t k = 0; k < line.intervals(); ++k) visible += line.hidden(k) ? 0 : 1;
  const hsr::Drawing drawing = hsr::draw(mesh, view, lines);
  std::printf("%d visible lines, %zu polylines\n", visible, drawing.polylines.size());
  return visible == 4 && drawing.polylines.size() == 1 && drawing.polylines[0].closed ? 0 : 1;
}
