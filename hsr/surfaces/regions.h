#pragma once

#include <cstdint>
#include <vector>

#include "hsr/model.h"
#include "hsr/surfaces/fragments.h"

namespace hsr {

/// Which neighbouring fragments are united into one region.
enum class Merge : std::uint8_t {
  none,
  coplanar,  ///< of faces in one plane and of one colour that share an edge of the mesh
  colour,    ///< of one colour
};

/// A connected part of the picture in one colour.
struct Region {
  Colour colour = {};
  TriangleId facet;  ///< one that it belongs to
  std::vector<std::uint32_t> faces;
  std::uint32_t first_ring = 0, end_ring = 0;
};

struct Regions {
  std::vector<Region> regions;
  std::uint32_t first_outline_ring = 0;           ///< from here on: the rings around all that is filled
  std::vector<std::uint32_t> first_corner = {0};  ///< ring r has corners[first_corner[r]] ... ; one more than rings
  std::vector<MapCorner> corners;
};

/// The fragments as regions of colour, united with their neighbours as asked for, and the outline of all of them together.
///
/// @param colours by FaceId
/// Exact: yes. Cost: O(m log m) for m corners, but O(m) without merging.
Regions regions_of(const Mesh& mesh, const View& view, const VisibleFragments& fragments, const std::vector<Colour>& colours,
                   Merge merge);

/// The colour of each face: the file's, or where it has none a grey that is lighter the more the face is turned to a light at
/// the upper left of the viewer. For the eye: computed in doubles.
std::vector<Colour> face_colours(const Model& model, const Mesh& mesh, const View& view);

}  // namespace hsr
