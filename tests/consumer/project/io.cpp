// The readers and writers: a triangle read from text is written as SVG, PNG and JSON.
#include <cstdio>

#include "geometry/mesh.h"
#include "hsr/io/read/read.h"
#include "hsr/io/write/json.h"
#include "hsr/io/write/write.h"

int main() {
  const hsr::Model model = hsr::read_model("triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n");
  const hsr::Mesh mesh = hsr::make_mesh(model.points, model.polygons);
  const hsr::View view = hsr::named_view("front", hsr::centre(mesh));
  const hsr::VisibleLines lines = hsr::visible_lines(mesh, view);
  const hsr::Drawing drawing = hsr::draw(mesh, view, lines);
  const std::string svg = hsr::written(drawing, "svg"), png = hsr::written(drawing, "png", {.width = 40, .height = 30});
  const std::string json = hsr::lines_json(mesh, view, lines);
  std::printf("%zu bytes of SVG, %zu of PNG, %zu of JSON\n", svg.size(), png.size(), json.size());
  return svg.find("<svg") != std::string::npos && png.rfind("\x89PNG", 0) == 0 && json.find("hsr-lines/1") != std::string::npos
             ? 0
             : 1;
}
