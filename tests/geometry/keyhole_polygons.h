#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include "tests/geometry/polygon_cases.h"

/// Plates with holes as one polygon each, for tests.
namespace hsr::test {

/// A plate of rows x columns cells of 10 x 10 in the xy plane, a hole in each; bridges join the holes of a row, the first holes of
/// the rows, and a corner of the plate. Indices in random order.
class KeyholePlate {
 public:
  /// @param regular holes are octagons of one size, so that many corners are on one circle; else any star-shaped polygons
  KeyholePlate(std::mt19937& random, std::size_t rows, std::size_t columns, bool regular) : rows_(rows), columns_(columns) {
    for (std::size_t hole = 0; hole < rows * columns; ++hole) {
      const double x = static_cast<double>(hole % columns) * 10 + 5, y = static_cast<double>(hole / columns) * 10 + 5;
      std::vector<Point3> corners;
      if (regular) {
        constexpr std::array<std::array<int, 2>, 8> octagon = {
            {{3, 1}, {1, 3}, {-1, 3}, {-3, 1}, {-3, -1}, {-1, -3}, {1, -3}, {3, -1}}};
        for (const auto& [i, j] : octagon) corners.push_back({x + i, y + j, 0});
      } else {
        do {
          corners.clear();
          const auto [points, r] = star_polygon(random, 5 + static_cast<int>(random() % 10));
          for (const VertexId v : r) corners.push_back({points[v].x / 16, points[v].y / 16, 0});
        } while (!leaves_room(corners));
        for (Point3& p : corners) p = {x + p.x, y + p.y, 0};
      }
      holes_.push_back(corners);
    }
    const double width = static_cast<double>(columns) * 10, height = static_cast<double>(rows) * 10;
    polygon_.push_back({0, 0, 0});
    walk_around(0, extreme(0, 0, -1));
    for (const Point3& p : {Point3{0, 0, 0}, Point3{width, 0, 0}, Point3{width, height, 0}, Point3{0, height, 0}})
      polygon_.push_back(p);
  }

  std::pair<Points, Ring> numbered(std::mt19937& random) const {
    std::vector<Point3> distinct = polygon_;
    const auto less = [](const Point3& a, const Point3& b) { return std::pair(a.x, a.y) < std::pair(b.x, b.y); };
    std::sort(distinct.begin(), distinct.end(), less);
    distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
    std::shuffle(distinct.begin(), distinct.end(), random);
    Points points;
    points.assign(distinct.begin(), distinct.end());
    Ring ring;
    for (const Point3& p : polygon_)
      ring.emplace_back(static_cast<std::size_t>(std::find(distinct.begin(), distinct.end(), p) - distinct.begin()));
    return {points, ring};
  }

 private:
  // The corner that is furthest along an axis.
  static std::size_t extreme(const std::vector<Point3>& hole, int axis, int side) {
    std::size_t best = 0;
    for (std::size_t k = 1; k < hole.size(); ++k)
      if ((hole[k][axis] - hole[best][axis]) * side > 0) best = k;
    return best;
  }
  std::size_t extreme(std::size_t hole, int axis, int side) const { return extreme(holes_[hole], axis, side); }

  // Bridges to the next holes cross nothing then, and begin at four corners. A hole around the origin is simple.
  static bool leaves_room(const std::vector<Point3>& hole) {
    for (int axis = 0; axis < 2; ++axis)
      for (const int side : {-1, 1}) {
        const Point3& p = hole[extreme(hole, axis, side)];
        if (p[axis] * side < 1.5 || std::fabs(p[1 - axis]) > 1.4) return false;
      }
    return true;
  }

  void walk_around(std::size_t hole, std::size_t entry) {
    const std::size_t n = holes_[hole].size();
    const bool has_right = hole % columns_ + 1 < columns_, has_upper = hole % columns_ == 0 && hole / columns_ + 1 < rows_;
    for (std::size_t k = 0; k <= n; ++k) {
      const std::size_t at = (entry + n - k) % n;
      polygon_.push_back(holes_[hole][at]);
      if (k == n) return;
      if (has_right && at == extreme(hole, 0, 1)) {
        walk_around(hole + 1, extreme(hole + 1, 0, -1));
        polygon_.push_back(holes_[hole][at]);
      }
      if (has_upper && at == extreme(hole, 1, 1)) {
        walk_around(hole + columns_, extreme(hole + columns_, 1, -1));
        polygon_.push_back(holes_[hole][at]);
      }
    }
  }

  std::size_t rows_, columns_;
  std::vector<std::vector<Point3>> holes_;
  std::vector<Point3> polygon_;
};

}  // namespace hsr::test
