#pragma once

#include <cstdint>
#include <vector>

#include "hsr/lines/occluders.h"
#include "hsr/surfaces/map_sight.h"

namespace hsr {

/// Where two triangles pierce each other: a part of the line in which their planes meet, along that line.
struct Intersection {
  TriangleId s, t;  ///< s < t, of two facets
  MapPoint from, to;

  MapLine line() const { return MapLine::meet(s, t); }
};

/// Where the faces meet other than in common edges.
struct Intersections {
  std::vector<Intersection> segments;     ///< ascending by (s, t)
  std::vector<std::uint8_t> has_contact;  ///< by EdgeId: it may lie, in part, in a face that it is not an edge of
  DecisionCounts decisions;
};

/// Finds all of them beyond the near plane among the triangles of `occluders`, none of them seen edge-on.
///
/// Piercing is to cross: each triangle has points strictly on both sides of the other's plane, in a segment of positive length
/// that lies along no side of them. Touching is a contact, if it is along a line.
/// Exact: yes; contacts are marked generously. Cost: O(n log n + k) for k pairs whose boxes touch, parallel.
/// Source: Guigue & Devillers 2003 (signs of degree 3 first).
Intersections find_intersections(const Sight& sight, const Occluders& occluders);

}  // namespace hsr
