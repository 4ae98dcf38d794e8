#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/mesh.h"
#include "geometry/predicates.h"

namespace hsr::internal {

/// A triangle of a face. Bit k of `ring_sides`: its side from corner k to corner k + 1 is an edge of the polygon, not a
/// diagonal.
struct FaceTriangle {
  std::array<VertexId, 3> corners;
  std::uint8_t ring_sides = 7;
};

/// Cuts a polygon into triangles, each with an area and its corners in the polygon's order, and says how the face is used.
///
/// 1. *Reduce.* A corner that repeats the one before it goes, and so does a spike: a corner where the polygon turns back
///    exactly on itself. Over and over, cyclically; straight corners stay. Fewer than three corners left: no_area.
/// 2. *Flatten.* Drop the axis of the largest |component| of the exact Newell normal, the lowest axis of equal ones. (If the
///    normal is zero, as in a symmetric bow tie: of the triangle at the lowest-index corner that has an area.) Convex and
///    inside below are exact in these two coordinates, the polygon running counter-clockwise. Index means vertex index; of
///    several corners at one vertex, the first in the polygon is the lowest.
/// 3. *Quads.* The diagonal at the lowest-index corner; the other one if only that leaves both its triangles strictly convex.
/// 4. *More corners.* Cut off the lowest-index corner that is an ear, until nothing is left: it is strictly convex, no corner
///    at another vertex is in its closed triangle, and no edge at another visit of its three vertices runs into its inside.
///    If there is no such corner, the lowest that is strictly convex, has no corner strictly inside, and no edge at a corner
///    on its border runs inside. If none, the lowest strictly convex corner. If none, the lowest with an area in 3D. If none,
///    the rest has no area. Spikes that a cut leaves go as in 1.
///    A planar face of more than 12 corners gets constrained Delaunay triangles instead (constrained_delaunay.h): they cover the
///    same, and do it without the slivers that ears leave. Which faces are planar is as rule 5 says of ears.
/// 5. *Use.* Corners not exactly coplanar: not_coplanar. Coplanar, all cut off by the first two rules and no two triangles
///    overlapping: planar. Else crosses_itself. A triangle that comes up again in one face is given once.
///
/// @param triangles appended to
/// @pre the bit range of `predicates` holds for all `points`
/// Exact: yes. Source: Meisters 1975 (ears).
/// Cost: that of constrained_delaunay, about O(m log m), for m corners of a planar face of which no corner is in the midst of an
/// edge; else O(m^2) exact signs, most of them a few flops; O(m^3) for tangles.
FaceUse triangulate(const IndexedVector<VertexId, Point3>& points, std::span<const VertexId> polygon, Predicates& predicates,
                    std::vector<FaceTriangle>& triangles);

}  // namespace hsr::internal
