#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/mesh.h"

/// The unit cube.
inline hsr::Mesh cube() {
  std::vector<hsr::Point3> points;
  for (int i = 0; i < 8; ++i) points.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2 & 1)});
  hsr::Polygons faces;
  for (const auto& face : {std::array{0u, 2u, 3u, 1u}, std::array{4u, 5u, 7u, 6u}, std::array{0u, 1u, 5u, 4u},
                           std::array{2u, 6u, 7u, 3u}, std::array{0u, 4u, 6u, 2u}, std::array{1u, 3u, 7u, 5u}}) {
    faces.corners.insert(faces.corners.end(), face.begin(), face.end());
    faces.first.push_back(static_cast<std::uint32_t>(faces.corners.size()));
  }
  return hsr::make_mesh(points, faces);
}
