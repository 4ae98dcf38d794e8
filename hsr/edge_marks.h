#pragma once

#include <array>
#include <cstdint>

namespace hsr {

/// What an edge of a mesh is by the surfaces that the mesh stands for, whatever the angle between its faces.
enum class EdgeMark : std::uint8_t {
  inner,   ///< within one surface, seams too: drawn only where it is an outline
  smooth,  ///< two surfaces go on into each other with one tangent plane
  sharp,   ///< drawn as an edge
};

/// An edge between two points, as the segment that it is: it counts along each part of an edge that lies on it, whatever the faces
/// are cut at, between faces of its object (docs/conventions.md, C24).
struct MarkedEdge {
  std::array<std::uint32_t, 2> points = {};  ///< their numbers, in any order
  EdgeMark mark = EdgeMark::inner;
  std::uint32_t object = 0;            ///< as in FaceLabels::object; passed over where that is empty
  std::uint32_t circle = 0xffffffffU;  ///< on which it lies, an index into FaceLabels::circles; 0xffffffff: none is known

  friend bool operator==(const MarkedEdge&, const MarkedEdge&) = default;
};

}  // namespace hsr
