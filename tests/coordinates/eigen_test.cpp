// Matrices in, matrices out.
#include "hsr/eigen.h"

#include <catch2/catch.hpp>

#include "hsr/hsr.h"

namespace hsr {
namespace {

TEST_CASE("meshes come from matrices of any shape and number type", "[eigen]") {
  Eigen::MatrixXd v(4, 3);
  v << 0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0;
  Eigen::MatrixXi triangles(2, 3), quad(1, 4);
  triangles << 0, 1, 2, 0, 2, 3;
  quad << 0, 1, 2, 3;
  const Mesh of_triangles = mesh_from(v, triangles), of_quad = mesh_from(v, quad);
  CHECK(of_triangles.faces.size() == 2);
  CHECK(of_quad.faces.size() == 1);
  CHECK(of_quad.triangles.size() == 2);
  CHECK(of_quad.points[VertexId(2)] == Point3{2, 2, 0});

  const Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor> floats = v.cast<float>();
  const Eigen::Matrix<std::uint32_t, Eigen::Dynamic, 3, Eigen::RowMajor> numbers = triangles.cast<std::uint32_t>();
  CHECK(mesh_from(floats, numbers).triangles == of_triangles.triangles);

  const Eigen::Vector4i corners(0, 1, 2, 3);
  const Eigen::Vector2i first(0, 4);
  CHECK(mesh_from(v, corners, first).triangles == of_quad.triangles);
  CHECK(mesh_from(v, corners.transpose(), first).triangles == of_quad.triangles);

  quad(0, 2) = -1;
  CHECK_THROWS_AS(mesh_from(v, quad), InputError);
  quad(0, 2) = 4;
  CHECK_THROWS_AS(mesh_from(v, quad), InputError);
  CHECK_THROWS_AS(mesh_from(v.leftCols(2), triangles), InputError);
}

TEST_CASE("matrices of segments hold what the segments do", "[eigen]") {
  Eigen::MatrixXd v(6, 3);
  v << 0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, 1, 2, 1, -1, 1, 2, -1;
  Eigen::MatrixXi f(2, 3);
  f << 0, 1, 2, 3, 4, 5;
  const Mesh mesh = mesh_from(v, f);
  const SceneView scene(mesh, parallel_view({1, 2, 3}, {0, 0, 1}));
  const std::vector<Segment> all = segments(scene, visible_lines(scene));
  const SegmentMatrices m = matrices_of(all);
  REQUIRE(m.from.rows() == static_cast<Eigen::Index>(all.size()));
  bool any_intersection = false, any_hidden = false;
  for (Eigen::Index i = 0; i < m.from.rows(); ++i) {
    const Segment& s = all[static_cast<std::size_t>(i)];
    for (int axis = 0; axis < 3; ++axis) {
      CHECK(m.from(i, axis) == s.from.space[axis]);
      CHECK(m.to(i, axis) == s.to.space[axis]);
    }
    CHECK(m.paper_from.row(i) == Eigen::RowVector2d(s.from.paper.x, s.from.paper.y));
    CHECK(m.paper_to.row(i) == Eigen::RowVector2d(s.to.paper.x, s.to.paper.y));
    CHECK(m.edge_class(i) == static_cast<std::uint8_t>(s.edge_class));
    CHECK(m.is_hidden(i) == s.is_hidden);
    CHECK(m.vertices(i, 0) == (s.a.is_valid() ? std::int64_t{s.a.value} : -1));
    any_intersection = any_intersection || m.vertices(i, 1) == -1;
    any_hidden = any_hidden || s.is_hidden;
  }
  CHECK(any_intersection);
  CHECK(any_hidden);
}

}  // namespace
}  // namespace hsr
