// draw MODEL [DIRECTORY]: draws a model on A4 with hidden lines dashed, as drawing.svg and drawing.png, and prints how many
// lines that took.
#include <hsr/hsr.h>
#include <hsr/io.h>

#include <cstdio>
#include <exception>
#include <fstream>
#include <string>

int main(int argc, char** argv) try {
  const hsr::Model model = hsr::read_model(argc > 1 ? argv[1] : "part.obj");
  const std::string directory = argc > 2 ? argv[2] : ".";
  const hsr::Mesh mesh = hsr::make_mesh(model.points, model.polygons);
  const hsr::View view = hsr::named_view("iso", hsr::centre(mesh));

  hsr::DrawingOptions options;
  options.hidden = hsr::HiddenLines::dashed;
  const hsr::Drawing drawing = hsr::draw(mesh, view, hsr::visible_lines(mesh, view), options);
  std::ofstream(directory + "/drawing.svg", std::ios::binary) << hsr::written(drawing, "svg");
  std::ofstream(directory + "/drawing.png", std::ios::binary) << hsr::written(drawing, "png");
  std::printf("%zu polylines on %g x %g mm\n", drawing.polylines.size(), drawing.width, drawing.height);
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
