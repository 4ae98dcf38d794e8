// Tells of points behind a triangle, and of one before it, which of them it hides: the one straight behind its middle, and the one
// straight behind a corner.
#include <hsr/hsr.h>

#include <cstdio>

int main() {
  const std::vector<hsr::Point3> corners = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
  const std::vector<std::array<std::uint32_t, 3>> triangle = {{0, 1, 2}};
  const hsr::Mesh mesh = hsr::make_mesh(corners, triangle);
  const hsr::SceneView scene(mesh, hsr::perspective_view({0, 0, 3}, {0, 0, 0}, {0, 1, 0}));

  const std::vector<hsr::Point3> points = {{-3, -1, -3}, {-2, -2, -3}, {0, 0, -3}, {0, 0, 1}, {3, -1, -3}};
  const std::vector<bool> hidden = hsr::hidden_points(scene, points);  // any number in one call, in parallel
  for (std::size_t k = 0; k < points.size(); ++k)
    std::printf("%g,%g,%g %s\n", points[k].x, points[k].y, points[k].z, hidden[k] ? "hidden" : "visible");
}
