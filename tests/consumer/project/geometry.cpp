// The exact kernel: on which side of a face a point lies that is off its plane by the smallest double.
#include <cstdio>
#include <limits>

#include "cube.h"
#include "geometry/predicates.h"

int main() {
  const double least = std::numeric_limits<double>::denorm_min();
  const hsr::Point3 a{0, 0, 0}, b{0.1, 0, 0}, c{0, 0.1, 0}, above{0, 0, least}, below{0, 0, -least};
  const std::vector<hsr::Point3> points = {a, b, c, above, below};
  const hsr::Plane face = hsr::Plane::of_face(a, b, c);
  hsr::Predicates exact(hsr::bit_range(points));
  const hsr::Sign side = exact.side(face, above);
  const hsr::Mesh mesh = cube();
  std::printf("%zu triangles, %zu edges\n", mesh.triangles.size(), mesh.edges.size());
  return side != hsr::Sign::zero && exact.side(face, below) == -side && mesh.triangles.size() == 12 ? 0 : 1;
}
