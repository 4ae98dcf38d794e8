#pragma once

#include <pybind11/pybind11.h>

#include <vector>

#include "hsr/coordinates/coordinates.h"
#include "python/src/arrays.h"

namespace hsr::python {

/// Polygons as arrays: face (f,), ring_offsets (f + 1,), offsets (r + 1,), points (p, 3), image (p, 2).
inline py::dict arrays_of(const std::vector<PlacedPolygon>& polygons) {
  std::vector<std::int64_t> face, ring_offsets = {0}, offsets = {0};
  std::vector<double> points, image;
  for (const PlacedPolygon& polygon : polygons) {
    face.push_back(polygon.face.value);
    for (const auto& ring : polygon.rings) {
      for (const PlacedPoint& p : ring) {
        points.insert(points.end(), {p.space.x, p.space.y, p.space.z});
        image.insert(image.end(), {p.paper.x, p.paper.y});
      }
      offsets.push_back(static_cast<std::int64_t>(points.size() / 3));
    }
    ring_offsets.push_back(static_cast<std::int64_t>(offsets.size() - 1));
  }
  const auto n = static_cast<py::ssize_t>(points.size() / 3);
  py::dict all;
  all["face"] = array_of(std::move(face));
  all["ring_offsets"] = array_of(std::move(ring_offsets));
  all["offsets"] = array_of(std::move(offsets));
  all["points"] = array_of(std::move(points), {n, 3});
  all["image"] = array_of(std::move(image), {n, 2});
  return all;
}

}  // namespace hsr::python
