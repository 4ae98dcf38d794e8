// Matrices in, matrices out: a cube seen from the front shows four visible segments.
#include "hsr/eigen.h"

#include <cstdio>

#include "hsr/hsr.h"

int main() {
  Eigen::MatrixXd v(8, 3);
  for (int i = 0; i < 8; ++i) v.row(i) << (i & 1), (i >> 1 & 1), (i >> 2 & 1);
  Eigen::MatrixXi f(12, 3);
  f << 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5;
  const hsr::Mesh mesh = hsr::mesh_from(v, f);
  const hsr::SceneView scene(mesh, hsr::named_view("front", hsr::centre(mesh)));
  int visible = 0;
  for (const hsr::Segment& s : hsr::segments(scene, hsr::visible_lines(scene))) visible += s.is_hidden ? 0 : 1;
  std::printf("%d visible segments\n", visible);
  return visible == 4 ? 0 : 1;
}
