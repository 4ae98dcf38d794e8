#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tests/lines/ink.h"
#include "tests/scenes/test_scene.h"

namespace hsr {

using Ring = std::vector<std::uint32_t>;

/// A scene whose faces are of objects and materials.
struct Labelled {
  scenes::TestScene scene;
  FaceLabels labels;

  std::string ink() const { return ink_of(SceneView(Scene(scene.mesh(), labels), scene.view)); }
  void add_face(const Ring& ring, std::uint32_t object = 0, std::uint32_t material = 0) {
    scene.add_face(ring);
    labels.object.push_back(object);
    labels.material.push_back(material);
  }
  /// With points of its own.
  void add_face(const std::vector<Point3>& corners, std::uint32_t object = 0, std::uint32_t material = 0) {
    Ring ring;
    for (const Point3& p : corners) {
      ring.push_back(static_cast<std::uint32_t>(scene.points.size()));
      scene.points.push_back(p);
    }
    add_face(ring, object, material);
  }
  /// A box between two corners, with points of its own.
  void add_box(const Point3& a, const Point3& b, std::uint32_t object = 0, std::uint32_t material = 0) {
    const auto n = static_cast<std::uint32_t>(scene.points.size());
    for (int k = 0; k < 8; ++k)
      scene.points.push_back({(k & 1) != 0 ? b.x : a.x, (k & 2) != 0 ? b.y : a.y, (k & 4) != 0 ? b.z : a.z});
    for (const Ring& f :
         {Ring{0, 2, 3, 1}, Ring{4, 5, 7, 6}, Ring{0, 1, 5, 4}, Ring{2, 6, 7, 3}, Ring{0, 4, 6, 2}, Ring{1, 3, 7, 5}})
      add_face({n + f[0], n + f[1], n + f[2], n + f[3]}, object, material);
  }
};

Labelled without_faces(const Labelled& x);

/// What a face becomes: rings over the points of `to`, to which it may add some.
using Recut = std::function<std::vector<Ring>(const Mesh& mesh, FaceId face, const Ring& ring, Labelled& to)>;

Labelled recut(const Labelled& x, const Recut& cut);
/// Its sides cut in three: its neighbours' are not.
std::vector<Ring> with_cut_sides(const Mesh&, FaceId, const Ring& ring, Labelled& to);
std::vector<Ring> as_triangles(const Mesh& mesh, FaceId face, const Ring&, Labelled&);
/// Each of its triangles cut in two, from a corner to the middle of a side: the sides overlap those of the neighbours.
std::vector<Ring> in_halves(const Mesh& mesh, FaceId face, const Ring& ring, Labelled& to);
std::vector<Ring> turned_over(const Mesh&, FaceId face, const Ring& ring, Labelled&);

Labelled labelled(const scenes::TestScene& scene, bool with_labels);

/// The lines of one text that the other has not.
std::string difference(const std::string& x, const std::string& y);
/// How many parts of lines an ink has in a style: "visible joint".
int lines_of(const Labelled& x, const char* style);
/// The ink whatever its class.
std::string by_visibility(std::string ink);

}  // namespace hsr
