#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "geometry/index.h"
#include "hsr/edge_marks.h"
#include "hsr/known_shapes.h"

namespace hsr {

/// What the faces of a scene belong to. By face; an empty list: all faces are alike.
///
/// Where a surface goes on flat and only its material changes there is an edge of class `material`, where only its object does,
/// one of class `joint`. Within one surface there is no edge but an outline, whatever the crease. Labels and marks decide nothing about
/// what hides what.
struct FaceLabels {
  static constexpr std::uint32_t none = 0xffffffffU;

  std::vector<std::uint32_t> object;
  std::vector<std::uint32_t> material;
  std::vector<std::uint32_t> surface =
      {};  ///< such as the face of a B-rep that a triangle is of; `none`: of no such; empty: all
  /// The shape in space that the surface is a part of, such as the cylinder of a shaft and of the hole that it fills; as `surface`.
  /// Where faces of one shape pierce each other, only how they were cut into faces differs, and no line is drawn.
  std::vector<std::uint32_t> shape = {};
  std::vector<MarkedEdge> marks = {};     ///< of edges; what is no edge of the mesh is passed over
  std::vector<KnownCircle> circles = {};  ///< those that marks name; a number without one here is passed over
};

/// Which object each face and each wire of a scene is of, where two or more are told apart; for what is written.
struct SceneObjects {
  static constexpr std::uint32_t none = 0xffffffffU;

  struct Wire {
    EdgeId edge;
    std::uint32_t object = none;  ///< none: wires of several objects run along this edge, or of none
  };

  std::vector<std::string> names;      ///< in the file's words
  std::vector<std::uint32_t> of_face;  ///< index of a name, or none; empty like names
  std::vector<Wire> wires;             ///< ascending by edge, each edge once

  bool are_told_apart() const { return names.size() > 1; }
  /// The object that all of these faces are of; none: they are of several, or of none.
  std::uint32_t object_of(std::span<const FaceId> faces) const;
  /// The object that the wires along an edge are of; none: they are of several, or of none, or there is no wire.
  /// Cost: O(log n) in wires.
  std::uint32_t object_of_wire(EdgeId edge) const;
};

}  // namespace hsr
