#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "geometry/error.h"
#include "geometry/mesh.h"
#include "hsr/coordinates/coordinates.h"

// Meshes from matrices and results as matrices. Header only: whoever includes it brings Eigen 3; the library does not need it.

namespace hsr {

/// @param vertices n x 3: a point in each row
/// @throws InputError unless there are three columns
template <class Derived>
std::vector<Point3> points_from(const Eigen::MatrixBase<Derived>& vertices) {
  if (vertices.cols() != 3)
    throw InputError("vertices: found " + std::to_string(vertices.cols()) + " columns, expected x, y and z");
  std::vector<Point3> points;
  points.reserve(static_cast<std::size_t>(vertices.rows()));
  for (Eigen::Index i = 0; i < vertices.rows(); ++i)
    points.push_back(
        {static_cast<double>(vertices(i, 0)), static_cast<double>(vertices(i, 1)), static_cast<double>(vertices(i, 2))});
  return points;
}

/// @throws InputError if a number is negative or beyond 32 bits, naming where it stands
template <class Derived>
std::vector<std::uint32_t> indices_from(const Eigen::MatrixBase<Derived>& numbers, const char* name) {
  std::vector<std::uint32_t> all;
  all.reserve(static_cast<std::size_t>(numbers.size()));
  for (Eigen::Index i = 0; i < numbers.rows(); ++i)
    for (Eigen::Index k = 0; k < numbers.cols(); ++k) {
      const auto number = static_cast<std::int64_t>(numbers(i, k));
      if (number < 0 || number > std::numeric_limits<std::uint32_t>::max())
        throw InputError(std::string(name) + ", row " + std::to_string(i) + ": found " + std::to_string(number) +
                         ", expected a number from 0 on");
      all.push_back(static_cast<std::uint32_t>(number));
    }
  return all;
}

/// @param vertices n x 3 @param faces m x k, of integers: a polygon of k corners in each row
/// @throws InputError as make_mesh() of arrays does, and unless the matrices have these shapes
template <class DerivedV, class DerivedF>
Mesh mesh_from(const Eigen::MatrixBase<DerivedV>& vertices, const Eigen::MatrixBase<DerivedF>& faces) {
  const std::vector<std::uint32_t> corners = indices_from(faces, "faces");
  std::vector<std::uint32_t> first = {0};
  check_countable(corners.size(), "corners");
  for (Eigen::Index i = 0; i < faces.rows(); ++i) first.push_back(first.back() + static_cast<std::uint32_t>(faces.cols()));
  return make_mesh(points_from(vertices), corners, first);
}

/// @param vertices n x 3 @param corners of all faces, in a row or a column
/// @param first face f has the corners first(f) ... first(f + 1) - 1: one more than faces
/// @throws InputError as make_mesh() of arrays does, and unless there are three columns
/// @throws PreconditionError unless `first` ascends from 0 to the number of corners
template <class DerivedV, class DerivedC, class DerivedS>
Mesh mesh_from(const Eigen::MatrixBase<DerivedV>& vertices, const Eigen::MatrixBase<DerivedC>& corners,
               const Eigen::MatrixBase<DerivedS>& first) {
  return make_mesh(points_from(vertices), indices_from(corners, "corners"), indices_from(first, "first"));
}

/// Segments as matrices: row i of each is of segment i.
struct SegmentMatrices {
  Eigen::Matrix<double, Eigen::Dynamic, 3> from, to;              ///< ends in space
  Eigen::Matrix<double, Eigen::Dynamic, 2> paper_from, paper_to;  ///< ends in the view's frame
  Eigen::Matrix<std::uint8_t, Eigen::Dynamic, 1> edge_class;      ///< EdgeClass as a number
  Eigen::Matrix<bool, Eigen::Dynamic, 1> is_hidden;
  Eigen::Matrix<std::int64_t, Eigen::Dynamic, 2> vertices;  ///< of the edge; -1, -1: an intersection
};

inline SegmentMatrices matrices_of(const std::vector<Segment>& segments) {
  const auto n = static_cast<Eigen::Index>(segments.size());
  SegmentMatrices m;
  for (auto* ends : {&m.from, &m.to}) ends->resize(n, 3);
  for (auto* ends : {&m.paper_from, &m.paper_to}) ends->resize(n, 2);
  m.edge_class.resize(n);
  m.is_hidden.resize(n);
  m.vertices.resize(n, 2);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Segment& s = segments[static_cast<std::size_t>(i)];
    m.from.row(i) << s.from.space.x, s.from.space.y, s.from.space.z;
    m.to.row(i) << s.to.space.x, s.to.space.y, s.to.space.z;
    m.paper_from.row(i) << s.from.paper.x, s.from.paper.y;
    m.paper_to.row(i) << s.to.paper.x, s.to.paper.y;
    m.edge_class(i) = static_cast<std::uint8_t>(s.edge_class);
    m.is_hidden(i) = s.is_hidden;
    const auto number = [](VertexId v) { return v.is_valid() ? std::int64_t{v.value} : std::int64_t{-1}; };
    m.vertices.row(i) << number(s.a), number(s.b);
  }
  return m;
}

}  // namespace hsr
