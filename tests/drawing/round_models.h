#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/mesh.h"

namespace hsr {

/// Points and faces as they are added.
class ModelMaker {
 public:
  std::uint32_t add(double x, double y, double z) {
    points_.push_back({x, y, z});
    return static_cast<std::uint32_t>(points_.size() - 1);
  }
  void add_face(const std::vector<std::uint32_t>& corners) {
    polygons_.corners.insert(polygons_.corners.end(), corners.begin(), corners.end());
    polygons_.first.push_back(static_cast<std::uint32_t>(polygons_.corners.size()));
  }
  Mesh mesh() const { return make_mesh(points_, polygons_); }

 private:
  std::vector<Point3> points_;
  Polygons polygons_;
};

/// Standing on the floor, over a closed line of so many corners. @param at from the number of a corner to a Point2
template <class At>
Mesh prism(int corners, double height, const At& at) {
  ModelMaker maker;
  std::vector<std::uint32_t> floor, roof;
  for (int k = 0; k < corners; ++k) {
    const Point2 p = at(k);
    floor.push_back(maker.add(p.x, p.y, 0));
    roof.push_back(maker.add(p.x, p.y, height));
  }
  maker.add_face({floor.rbegin(), floor.rend()});
  maker.add_face(roof);
  for (int k = 0; k < corners; ++k) {
    const auto i = static_cast<std::size_t>(k), j = static_cast<std::size_t>((k + 1) % corners);
    maker.add_face({floor[i], floor[j], roof[j], roof[i]});
  }
  return maker.mesh();
}

/// Standing, its axis that of z, a vertex of each ring on the x axis.
inline Mesh cylinder(int sides, double radius, double height) {
  return prism(sides, height, [&](int k) {
    const double t = 2 * std::numbers::pi * k / sides;
    return Point2{radius * std::cos(t), radius * std::sin(t)};
  });
}

struct Hole {
  double x, z, radius;
};
inline const std::vector<Hole> plate_holes = {{20, 20, 8},   {60, 20, 15}, {100, 20, 8},
                                              {20, 60, 3.5}, {60, 60, 12}, {100, 60, 5}};

/// Upright, 120 by 80 by 10, facing the front: each hole in a square of its own, cut open from its lower left corner to the hole.
inline Mesh plate_with_holes(int sides) {
  ModelMaker maker;
  const auto square = [&](const Hole& hole, double y) {
    std::vector<std::uint32_t> corners;
    for (const auto& [x, z] : {std::pair{-20, -20}, {20, -20}, {20, 20}, {-20, 20}})
      corners.push_back(maker.add(hole.x + x, y, hole.z + z));
    return corners;
  };
  for (const Hole& hole : plate_holes) {
    std::vector<std::uint32_t> rims[2];
    for (const int back : {0, 1}) {
      const double y = 10 * back;
      const auto corners = square(hole, y);
      for (int k = 0; k < sides; ++k) {
        const double t = 2 * std::numbers::pi * (sides * 5 / 8 - k) / sides;
        rims[back].push_back(maker.add(hole.x + hole.radius * std::cos(t), y, hole.z + hole.radius * std::sin(t)));
      }
      std::vector<std::uint32_t> face = {corners[0]};
      face.insert(face.end(), rims[back].begin(), rims[back].end());
      face.push_back(rims[back][0]);
      face.insert(face.end(), corners.begin(), corners.end());
      maker.add_face(back == 1 ? std::vector<std::uint32_t>(face.rbegin(), face.rend()) : face);
    }
    for (std::size_t k = 0; k < rims[0].size(); ++k) {
      const std::size_t next = (k + 1) % rims[0].size();
      maker.add_face({rims[1][k], rims[1][next], rims[0][next], rims[0][k]});
    }
  }
  const std::pair<int, int> border[] = {{0, 0},    {40, 0},  {80, 0},  {120, 0}, {120, 40},
                                        {120, 80}, {80, 80}, {40, 80}, {0, 80},  {0, 40}};
  for (std::size_t k = 0; k < std::size(border); ++k) {
    const auto& [x, z] = border[k];
    const auto& [u, w] = border[(k + 1) % std::size(border)];
    maker.add_face({maker.add(x, 0, z), maker.add(x, 10, z), maker.add(u, 10, w), maker.add(u, 0, w)});
  }
  return maker.mesh();
}

}  // namespace hsr
