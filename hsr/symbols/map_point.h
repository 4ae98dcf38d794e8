#pragma once

#include <algorithm>
#include <cstdint>

#include "geometry/index.h"

namespace hsr {

/// A line of the visibility map, kept as what it is the image of. Its positive side is on its left.
struct MapLine {
  enum class Kind : std::uint8_t {
    edge,  ///< of the vertices u < v, running from u to v
    meet,  ///< of where the planes of the triangles u < v meet
    near,  ///< of where the near plane, or plane v of the view (View::cutting_plane), cuts the plane of triangle u
    fold,  ///< of where the planes u and v of the view meet (View::fold_plane)
  };
  Kind kind = Kind::edge;
  std::uint32_t u = 0, v = 0;

  static MapLine edge(VertexId a, VertexId b) { return {Kind::edge, std::min(a, b).value, std::max(a, b).value}; }
  static MapLine meet(TriangleId s, TriangleId t) { return {Kind::meet, std::min(s, t).value, std::max(s, t).value}; }
  static MapLine meet(FacetId s, FacetId t) { return meet(first_triangle(s), first_triangle(t)); }
  static MapLine near(TriangleId t, std::uint8_t plane = 0) { return {Kind::near, t.value, plane}; }
  static MapLine fold(std::uint8_t u, std::uint8_t v) { return {Kind::fold, u, v}; }
  /// A line that the near plane of a view made, in a view whose plane number k that is.
  MapLine by_plane(std::uint8_t k) const { return kind == Kind::near ? MapLine{kind, u, k} : *this; }

  friend auto operator<=>(const MapLine&, const MapLine&) = default;
};

/// A point of the visibility map: the image of a vertex, or where two lines cross. Never a rounded number.
struct MapPoint {
  bool is_vertex = true;
  VertexId vertex;
  MapLine l, m;  ///< l < m

  static MapPoint of_vertex(VertexId v) { return {true, v, {}, {}}; }
  static MapPoint crossing(const MapLine& a, const MapLine& b) { return {false, {}, std::min(a, b), std::max(a, b)}; }
  MapPoint by_plane(std::uint8_t k) const { return is_vertex ? *this : crossing(l.by_plane(k), m.by_plane(k)); }

  friend auto operator<=>(const MapPoint&, const MapPoint&) = default;
};

/// A straight piece of the border of a region in the map, the region on its left.
struct MapSide {
  MapLine line;
  bool reversed = false;  ///< it runs against its line
  MapPoint from, to;
};

/// A corner of a ring, and the side that leaves it.
struct MapCorner {
  MapPoint at;
  MapLine line;
  bool reversed = false;
};

}  // namespace hsr
