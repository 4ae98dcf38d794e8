// Every public header compiles alone in this order, and the library links: a cube seen from the front shows four lines.
#include <cstdio>

#include "geometry/constructed_point.h"
#include "geometry/plane_filter.h"
#include "geometry/predicates.h"
#include "hsr/drawing/drawing.h"
#include "hsr/io/read/read.h"
#include "hsr/io/write/svg.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/scene/box_tree.h"
#include "hsr/scene/scene_facts.h"
#include "hsr/view/view.h"

#ifdef CGAL_VERSION
#error "a public header includes CGAL"
#endif

int main() {
  std::vector<hsr::Point3> points;
  for (int i = 0; i < 8; ++i) points.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2 & 1)});
  hsr::Polygons cube;
  for (const auto& face : {std::array{0u, 2u, 3u, 1u}, std::array{4u, 5u, 7u, 6u}, std::array{0u, 1u, 5u, 4u},
                           std::array{2u, 6u, 7u, 3u}, std::array{0u, 4u, 6u, 2u}, std::array{1u, 3u, 7u, 5u}}) {
    cube.corners.insert(cube.corners.end(), face.begin(), face.end());
    cube.first.push_back(static_cast<std::uint32_t>(cube.corners.size()));
  }
  const hsr::Mesh mesh = hsr::make_mesh(points, cube);
  const hsr::View view = hsr::named_view("front", hsr::centre(mesh));
  const hsr::VisibleLines lines = hsr::visible_lines(mesh, view);
  int visible = 0;
  for (const auto& line : lines.lines)
    for (std::uint32_t k = 0; k < line.intervals(); ++k) visible += line.hidden(k) ? 0 : 1;
  const std::string text = hsr::svg(hsr::draw(mesh, view, lines));
  std::printf("%d visible lines, %zu bytes of SVG\n", visible, text.size());
  return visible == 4 && !text.empty() ? 0 : 1;
}
