// Prints the ends of the nine segments of a cube that are visible from the corner that the view `iso` looks from.
#include <hsr/hsr.h>

#include <cstdio>

int main() {
  const std::vector<hsr::Point3> points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                           {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  const std::vector<std::uint32_t> corners = {0, 3, 2, 1, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7};
  const std::vector<std::uint32_t> first = {0, 4, 8, 12, 16, 20, 24};  // where each face begins among them, and the end
  const hsr::Mesh mesh = hsr::make_mesh(points, corners, first);
  const hsr::SceneView scene(mesh, hsr::named_view("iso", hsr::centre(mesh)));
  for (const hsr::Segment& s : hsr::segments(scene, hsr::visible_lines(scene)))
    if (!s.is_hidden)
      std::printf("%g,%g,%g - %g,%g,%g\n", s.from.space.x, s.from.space.y, s.from.space.z, s.to.space.x, s.to.space.y,
                  s.to.space.z);
}
