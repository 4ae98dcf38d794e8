#pragma once

#include <cstdint>

#include "geometry/index.h"

namespace hsr {

/// A place on a line of the scene (an edge, or where two faces pierce each other), kept as the symbol of what cuts the line
/// there: never as a rounded number.
struct Cut {
  enum class Kind : std::uint8_t {
    start,            ///< the first vertex of an edge, t = 0
    end,              ///< the second vertex of an edge, t = 1
    sight,            ///< the view plane of the vertices u and v
    face,             ///< the plane of triangle u
    near,             ///< the near plane
    near_line,        ///< where triangle u is cut by the near plane, as seen from the eye
    line,             ///< within an edge-on plane: the line of the vertices u and v; drop coordinate `axis`
    sight_of_vertex,  ///< within an edge-on plane: the line of sight of vertex u; drop `axis`
    across,           ///< square to the coordinate axis `axis`, through vertex u
    near_line_end,    ///< within an edge-on plane: where the line of u and v is cut by the near plane; drop `axis`
    fold,             ///< where the planes u and v of the view (View::fold_plane) meet, as seen from the eye
  };
  Kind kind = Kind::start;
  std::uint8_t axis = 0;  ///< of the kinds that are made of the near plane, with its number above two bits: see plane()
  std::uint32_t u = 0, v = 0;

  /// Which plane of the view (View::cutting_plane) is meant by the near plane.
  std::uint8_t plane() const { return static_cast<std::uint8_t>(axis >> 2U); }
  int dropped() const { return axis & 3U; }
  /// A cut that the near plane of a view made, in a view whose plane number k that is.
  Cut by_plane(std::uint8_t k) const {
    if (kind != Kind::near && kind != Kind::near_line && kind != Kind::near_line_end) return *this;
    Cut cut = *this;
    cut.axis = static_cast<std::uint8_t>((axis & 3U) | static_cast<unsigned>(k) << 2U);
    return cut;
  }

  friend bool operator==(const Cut&, const Cut&) = default;
};

/// Where two facets pierce each other: a part of the line in which their planes meet, along that line.
struct Intersection {
  FacetId s, t;  ///< s < t
  Cut from, to;  ///< of that line: view planes of sides, lines of sides seen edge-on, or the near plane

  friend bool operator==(const Intersection&, const Intersection&) = default;
};

}  // namespace hsr
