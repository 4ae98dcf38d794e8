// Takes a mesh from two matrices and prints the visible and hidden segments of a square over a triangle as a matrix of ends on
// paper.
#include <hsr/eigen.h>
#include <hsr/hsr.h>

#include <Eigen/Core>
#include <iostream>

int main() {
  Eigen::MatrixXd vertices(7, 3);
  vertices << 0, 0, 1, 2, 0, 1, 2, 2, 1, 0, 2, 1, 1, 1, 0, 4, 1, 0, 1, 4, 0;
  Eigen::MatrixXi faces(3, 3);
  faces << 0, 1, 2, 0, 2, 3, 4, 5, 6;
  const hsr::Mesh mesh = hsr::mesh_from(vertices, faces);
  const hsr::SceneView scene(mesh, hsr::named_view("top"));

  const hsr::SegmentMatrices segments = hsr::matrices_of(hsr::segments(scene, hsr::visible_lines(scene)));
  for (Eigen::Index i = 0; i < segments.from.rows(); ++i)
    std::cout << segments.paper_from.row(i) << " - " << segments.paper_to.row(i)
              << (segments.is_hidden(i) ? " hidden\n" : " visible\n");
}
