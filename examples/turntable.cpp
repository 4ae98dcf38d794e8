// turntable MODEL: a turn around a model in four views that share one Scene. Prints of each view its visible segments and, by a
// tree of planes that is built once, the nearest of the pieces to paint.
#include <hsr/hsr.h>
#include <hsr/io.h>

#include <algorithm>
#include <cstdio>
#include <exception>

int main(int argc, char** argv) try {
  const hsr::Model model = hsr::read_model(argc > 1 ? argv[1] : "part.obj");
  const hsr::Scene scene(hsr::make_mesh(model.points, model.polygons));
  const hsr::BspTree tree(scene.mesh());
  for (const hsr::Point3& direction : {hsr::Point3{4, 0, 3}, {3, 3, 3}, {0, 4, 3}, {-3, 3, 3}}) {
    const hsr::SceneView view(scene, hsr::parallel_view(direction, {0, 0, 1}, hsr::centre(scene.mesh())));
    const std::vector<hsr::Segment> all = hsr::segments(view, hsr::visible_lines(view));
    const auto visible = std::count_if(all.begin(), all.end(), [](const hsr::Segment& s) { return !s.is_hidden; });
    const hsr::PaintersOrder order = tree.order(view);
    std::printf("from %g,%g,%g: %td visible segments; of %zu pieces the last is of face %u\n", direction.x, direction.y,
                direction.z, visible, order.pieces.size(),
                scene.mesh().face_of[first_triangle(order.pieces.back().facet)].value);
  }
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
