// Prints the visible parts of a square behind a smaller one, seen from above: a ring around a hole, and the smaller square.
#include <hsr/hsr.h>

#include <cstdio>

int main() {
  const std::vector<hsr::Point3> points = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0},
                                           {1, 1, 1}, {3, 1, 1}, {3, 3, 1}, {1, 3, 1}};
  const std::vector<std::uint32_t> corners = {0, 1, 2, 3, 4, 5, 6, 7}, first = {0, 4, 8};
  const hsr::Mesh mesh = hsr::make_mesh(points, corners, first);
  const hsr::SceneView scene(mesh, hsr::named_view("top"));
  for (const hsr::PlacedPolygon& polygon : hsr::polygons(scene, hsr::visible_fragments(scene))) {
    std::printf("face %u\n", polygon.face.value);
    for (const auto& ring : polygon.rings) {
      std::printf(&ring == &polygon.rings.front() ? "  outside" : "  hole");
      for (const hsr::PlacedPoint& p : ring)
        std::printf("  %g,%g,%g", p.space.x, p.space.y, p.space.z);  // p.paper is where it is seen
      std::printf("\n");
    }
  }
}
