// visible_lines MODEL: how much of a model's lines can be seen from the corner that the view `iso` looks from.
#include "hsr/lines/visible_lines.h"

#include <exception>
#include <iostream>

#include "geometry/mesh.h"
#include "hsr/io/read/read.h"
#include "hsr/view/view.h"

int main(int argc, char** argv) try {
  const hsr::Model model = hsr::read_model(argc > 1 ? argv[1] : "part.obj");
  const hsr::Mesh mesh = hsr::make_mesh(model.points, model.polygons);
  const hsr::View view = hsr::named_view("iso", hsr::centre(mesh));
  const hsr::VisibleLines result = hsr::visible_lines(mesh, view);

  std::size_t visible = 0, hidden = 0;
  for (const hsr::Line& line : result.lines)
    for (std::uint32_t k = 0; k < line.intervals(); ++k) ++(line.hidden(k) ? hidden : visible);
  std::cout << visible << " visible and " << hidden << " hidden segments on " << result.lines.size() << " lines\n";
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
