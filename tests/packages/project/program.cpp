// Prints how many segments of a cube are visible from a corner: nine.
#include <hsr/hsr.h>
#include <hsr/io.h>

#include <algorithm>
#include <iostream>

int main() {
  const std::vector<hsr::Point3> points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                           {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  const std::vector<std::uint32_t> corners = {0, 3, 2, 1, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7};
  const std::vector<std::uint32_t> first = {0, 4, 8, 12, 16, 20, 24};
  const hsr::Mesh mesh = hsr::make_mesh(points, corners, first);
  const hsr::SceneView scene(mesh, hsr::named_view("iso", hsr::centre(mesh)));
  const auto segments = hsr::segments(scene, hsr::visible_lines(scene));
  std::cout << std::count_if(segments.begin(), segments.end(), [](const hsr::Segment& s) { return !s.is_hidden; }) << '\n';
}
