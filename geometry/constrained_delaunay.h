#pragma once

#include <span>
#include <vector>

#include "geometry/flat_plane.h"
#include "geometry/triangulate.h"

namespace hsr::internal {

/// The constrained Delaunay triangles of a polygon that is the border of a disc: no corner of the polygon is inside the circle
/// through the corners of a triangle, in the polygon's own plane, and seen from the inside of the triangle, edges of the polygon
/// barring the sight. Where corners lie on one circle several sets of triangles are; which one it is depends on the polygon alone.
///
/// Nothing if the polygon is no border of a disc, or if a corner is in the midst of an edge: ears are cut then.
/// If the polygon has triangles here, every order of cutting off ears by the first rule of triangulate.h succeeds: no vertex is on
/// a side of these triangles except at its ends, so that each leaf of their tree is such an ear, and after any such ear the rest is
/// of the same kind.
///
///   (1) one fewer than two triangles for each corner, counter-clockwise, each beginning at the first corner that it is met at
///   (2) each edge of the polygon is a side of one triangle, the one to its left
///
/// @pre `polygon` is reduced and coplanar
/// Exact: yes. Cost: O(n log n) expected for insertion by rounds, and what the edges cross of the triangles of the points alone.
/// Source: Lawson 1977 (flips); Sloan 1993 (edges); Chew 1989 (constrained Delaunay).
std::vector<FaceTriangle> constrained_delaunay(const FlatPlane& plane, std::span<const VertexId> polygon);

/// Turns diagonals of triangles that cover a planar polygon until they are as above.
void flip_to_delaunay(const FlatPlane& plane, std::vector<FaceTriangle>& triangles);

}  // namespace hsr::internal
