#pragma once

#include <cstdint>
#include <vector>

#include "hsr/model.h"
#include "hsr/surfaces/visible_fragments.h"

namespace hsr {

/// Which neighbouring fragments are united into one region.
enum class Merge : std::uint8_t {
  none,
  coplanar,  ///< of faces in one plane and of one colour that share a part of a side
  colour,    ///< of one colour that share a part of a side
};

/// A connected part of the picture in one colour.
struct Region {
  Colour colour = {};
  FacetId facet;  ///< one that it belongs to
  std::vector<std::uint32_t> faces;
  std::uint32_t first_ring = 0, end_ring = 0;
};

struct Regions {
  std::vector<Region> regions;
  Ragged<MapCorner> rings;
};

/// The fragments as regions of colour, united with their neighbours as asked for, each with the faces that it is made of.
///
///   (1) none, coplanar: in the order of the fragments, of those that a region is made of the first; colour: colour by colour
///
/// @param colours by FaceId
/// Exact: yes. Cost: none: O(n); else that of link_rings() for the sides of one colour or plane together; coplanar: and of the
/// pairs of facets whose boxes touch.
Regions regions_of(const SceneView& scene, const VisibleFragments& fragments, const std::vector<Colour>& colours, Merge merge);
/// Of a scene that nothing else looks at.
inline Regions regions_of(const Mesh& mesh, const View& view, const VisibleFragments& fragments,
                          const std::vector<Colour>& colours, Merge merge) {
  return regions_of(SceneView(mesh, view), fragments, colours, merge);
}

}  // namespace hsr
