#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "geometry/mesh.h"
#include "hsr/view/view.h"

namespace hsr::scenes {

/// A small scene and where it is looked at from.
struct TestScene {
  std::string name;
  std::vector<Point3> points;
  Polygons polygons;
  View view;

  void add_face(std::initializer_list<std::uint32_t> corners) { add_face(std::vector<std::uint32_t>(corners)); }
  void add_face(const std::vector<std::uint32_t>& corners);
  /// A face with points of its own.
  void add_face(const std::vector<Point3>& corners);
  /// A box from its least to its greatest corner, faces outward.
  void add_box(const Point3& low, const Point3& high);
  Mesh mesh() const { return make_mesh(points, polygons); }
};

/// Views without an `up` to think about: some axis that is not along the line of sight.
View from_direction(const Point3& toward_viewer);
/// @param k the near plane is (p - eye).(target - eye) = k |target - eye|^2, exactly
View from_eye(const Point3& eye, const Point3& target, double k = 0.001);

/// The scene as an OBJ file that gives every number exactly, with the name and the view in comments.
std::string to_text(const TestScene& scene);
/// @throws InputError if `text` is not what to_text writes
TestScene scene_from_text(const std::string& text);

/// A scene with fewer faces and wires, and simpler corners, that still fails.
TestScene shrunk(TestScene scene, const std::function<bool(const TestScene&)>& fails);

}  // namespace hsr::scenes
