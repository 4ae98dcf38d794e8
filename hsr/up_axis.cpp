#include "hsr/up_axis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "geometry/parallel_fold.h"

namespace hsr::internal {

namespace {

struct Box {
  std::array<double, 3> low, high;
};

/// Of the corners of all faces.
Box box_of(const Model& model) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const auto add = [](Box& all, std::size_t axis, double low, double high) {
    all.low[axis] = std::min(all.low[axis], low);
    all.high[axis] = std::max(all.high[axis], high);
  };
  return parallel_fold(
      model.polygons.corners.size(), Box{{infinite, infinite, infinite}, {-infinite, -infinite, -infinite}},
      [&](Box& all, std::size_t i) {
        const Point3& p = model.points[model.polygons.corners[i]];
        for (std::size_t axis = 0; axis < 3; ++axis) add(all, axis, p[static_cast<int>(axis)], p[static_cast<int>(axis)]);
      },
      [&](Box& all, const Box& more) {
        for (std::size_t axis = 0; axis < 3; ++axis) add(all, axis, more.low[axis], more.high[axis]);
      });
}

/// The area of a face as it is seen along an axis.
double area_along(const Model& model, std::span<const std::uint32_t> face, int axis) {
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  const Point3& o = model.points[face[0]];
  double twice = 0;
  for (std::size_t k = 2; k < face.size(); ++k) {
    const Point3 &a = model.points[face[k - 1]], &b = model.points[face[k]];
    twice += (a[i] - o[i]) * (b[j] - o[j]) - (a[j] - o[j]) * (b[i] - o[i]);
  }
  return std::abs(twice) / 2;
}

/// The foot at that coordinate of the axis, as a part of the side of the box.
double foot(const Model& model, const Box& box, int axis, double at) {
  const auto i = static_cast<std::size_t>((axis + 1) % 3), j = static_cast<std::size_t>((axis + 2) % 3);
  double area = 0;
  for (std::size_t f = 0; f < model.polygons.size(); ++f) {
    const std::uint32_t* const corners = model.polygons.corners.data();
    const std::span<const std::uint32_t> face(corners + model.polygons.first[f], corners + model.polygons.first[f + 1]);
    if (face.size() >= 3 && std::all_of(face.begin(), face.end(), [&](std::uint32_t c) { return model.points[c][axis] == at; }))
      area += area_along(model, face, axis);
  }
  return area / ((box.high[i] - box.low[i]) * (box.high[j] - box.low[j]));
}

}  // namespace

bool seems_y_up(const Model& model) {
  if (model.polygons.corners.empty()) return false;
  const Box box = box_of(model);
  for (std::size_t a = 0; a < 3; ++a)
    if (!(box.high[a] > box.low[a])) return false;
  const double floor = foot(model, box, 1, box.low[1]);
  if (!(floor >= 0.5) || !(foot(model, box, 1, box.high[1]) < floor / 8)) return false;
  return std::abs(foot(model, box, 2, box.low[2]) - foot(model, box, 2, box.high[2])) < 1.0 / 16;
}

}  // namespace hsr::internal
