// Prints the pieces of two triangles that pierce each other from far to near, each with its corners on paper: one of the two is cut,
// for no order of the whole triangles is right.
#include <hsr/hsr.h>

#include <cstdio>

int main() {
  const std::vector<hsr::Point3> points = {{-2, -1, 0}, {2, -1, 0}, {0, 3, 0}, {-2, 1, -1}, {2, 1, -1}, {0, -2, 2}};
  const std::vector<std::array<std::uint32_t, 3>> triangles = {{0, 1, 2}, {3, 4, 5}};
  const hsr::Mesh mesh = hsr::make_mesh(points, triangles);
  const hsr::SceneView scene(mesh, hsr::named_view("top"));
  for (const hsr::PlacedPolygon& piece : hsr::polygons(scene, hsr::depth_sort(scene).order)) {
    std::printf("face %u:", piece.face.value);
    for (const hsr::PlacedPoint& p : piece.rings[0]) std::printf("  %g,%g", p.paper.x, p.paper.y);
    std::printf("\n");
  }
}
