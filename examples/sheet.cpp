// sheet MODEL [DIRECTORY]: a drawing sheet of a model with a section across its middle, as sheet.pdf, and where its views are.
#include <hsr/hsr.h>
#include <hsr/io.h>

#include <cstdio>
#include <exception>
#include <fstream>
#include <string>

int main(int argc, char** argv) try {
  const hsr::Model model = hsr::read_model(argc > 1 ? argv[1] : "part.obj");
  const std::string directory = argc > 2 ? argv[2] : ".";
  const hsr::Scene scene(hsr::make_mesh(model.points, model.polygons), hsr::labels_of(model));

  hsr::SheetOptions options;
  options.format = hsr::sheet_format("A4");
  options.title.title = "Example";
  options.sections = {{hsr::centre(scene.mesh()), {1, 0, 0}}};  // a point of the plane, and a direction square to it
  const hsr::Sheet sheet = hsr::draw_sheet(scene, options);
  std::ofstream(directory + "/sheet.pdf", std::ios::binary) << hsr::written(sheet.drawing, "pdf");
  std::printf("scale %g\n", sheet.scale);
  for (const hsr::PlacedView& view : sheet.views)
    std::printf("%s: %.1f x %.1f mm at %.1f, %.1f\n", view.name.c_str(), view.box.right - view.box.left,
                view.box.bottom - view.box.top, view.box.left, view.box.top);
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
