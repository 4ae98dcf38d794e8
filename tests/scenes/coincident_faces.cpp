#include "tests/scenes/coincident_faces.h"

#include <algorithm>
#include <random>
#include <utility>

namespace hsr::scenes {

namespace {

using Corners = std::vector<std::uint32_t>;

std::vector<Corners> faces_of(const TestScene& scene) {
  std::vector<Corners> faces;
  for (std::size_t f = 0; f < scene.polygons.size(); ++f)
    faces.emplace_back(scene.polygons[f].begin(), scene.polygons[f].end());
  return faces;
}

TestScene with_faces(TestScene scene, const std::vector<Corners>& faces) {
  const auto wires = std::move(scene.polygons.segments);
  scene.polygons = {};
  scene.polygons.segments = wires;
  for (const Corners& corners : faces) scene.add_face(corners);
  return scene;
}

/// Twice as large, seen from its first corner.
Corners enlarged(TestScene& scene, const Corners& face) {
  const Point3 from = scene.points[face.front()];
  Corners large;
  for (const std::uint32_t c : face) {
    const Point3& p = scene.points[c];
    large.push_back(static_cast<std::uint32_t>(scene.points.size()));
    scene.points.push_back({p.x + (p.x - from.x), p.y + (p.y - from.y), p.z + (p.z - from.z)});
  }
  return large;
}

/// By numbers that are the same everywhere, which std::shuffle's are not.
void shuffle(std::vector<Corners>& faces, std::mt19937_64& random) {
  for (std::size_t k = faces.size(); k > 1; --k) std::swap(faces[k - 1], faces[random() % k]);
}

}  // namespace

TestScene with_coincident_faces(TestScene scene, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Corners> faces = faces_of(scene);
  const std::size_t n = faces.size();
  for (std::size_t f = 0; f < n; ++f) {
    Corners more = faces[f];
    switch (random() % 6) {
      case 0:
        break;
      case 1:
        std::reverse(more.begin(), more.end());
        break;
      case 2:
        more.resize(std::min<std::size_t>(more.size(), 3));
        break;
      case 3:
        more = enlarged(scene, more);
        break;
      default:
        continue;
    }
    faces.push_back(std::move(more));
  }
  shuffle(faces, random);
  return with_faces(std::move(scene), faces);
}

TestScene sheets(std::uint64_t seed, int size) {
  std::mt19937_64 random(seed);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<std::uint64_t>(n)); };
  TestScene scene;
  std::vector<std::vector<Point3>> faces;
  const auto add = [&](int x0, int y0, int x1, int y1, int z) {
    const auto at = [&](int x, int y) {
      return Point3{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
    };
    faces.push_back({at(x0, y0), at(x1, y0), at(x1, y1), at(x0, y1)});
  };
  add(0, 0, size, size, 0);
  for (int k = 0; k < 14; ++k) {
    const int x = below(size - 1), y = below(size - 1);
    add(x, y, x + 1 + below(size - x), y + 1 + below(size - y), below(3));
  }
  for (std::size_t k = faces.size(); k > 1; --k) std::swap(faces[k - 1], faces[random() % k]);
  for (const std::vector<Point3>& face : faces) scene.add_face(face);
  scene.view = parallel_view({0, 0, 1}, {0, 1, 0});
  return scene;
}

TestScene backwards(const TestScene& scene) {
  std::vector<Corners> faces = faces_of(scene);
  std::reverse(faces.begin(), faces.end());
  return with_faces(scene, faces);
}

}  // namespace hsr::scenes
