#pragma once

#include <array>
#include <cstdint>
#include <stop_token>
#include <vector>

#include "hsr/scene/occluders.h"
#include "hsr/scene/projected_mesh.h"
#include "hsr/symbols/cut.h"

namespace hsr::internal {

class OcclusionPyramid;

/// Where two triangles of different facets pierce each other: a piece of an Intersection.
struct TriangleIntersection {
  TriangleId s, t;  ///< s < t
  Cut from, to;
};

/// Where the faces meet other than in common edges.
struct Intersections {
  std::vector<TriangleIntersection> segments;  ///< ascending by (s, t)
  std::vector<std::uint8_t> has_contact;       ///< by EdgeId: it may lie, in part, in a face that it is not an edge of
  DecisionCounts decisions;
};

/// Finds all of them beyond the near plane among the triangles of `occluders`.
///
/// Piercing is to cross: each face has points strictly on both sides of the other's plane, at a segment of positive length that
/// lies along no side of them. Touching is a contact, if it is along a line.
/// @param pyramid segments that it hides are left out; nullptr: nothing is known to be hidden
/// @throws CancelledError if asked to stop
/// Exact: yes; contacts are marked generously. Cost: O(n log n + k) for k pairs whose boxes touch, parallel.
/// Source: Guigue & Devillers 2003 (signs of degree 3 first).
Intersections find_intersections(const ProjectedMesh& projected, const Occluders& occluders,
                                 const OcclusionPyramid* pyramid = nullptr, const std::stop_token& stop = {});

/// Which faces meet other than in common edges; no view changes it.
struct MeetingFaces {
  std::vector<std::array<TriangleId, 2>> pairs;  ///< triangles that pierce each other, ascending
  std::vector<std::uint8_t> has_contact;         ///< by EdgeId, as Intersections has it
};
/// @pre `all` is complete: found without tiles, and among triangles none of which is cut by the near plane
MeetingFaces meeting_faces(const Intersections& all);

/// What find_intersections() finds where it is known which faces meet, and perhaps more contacts.
/// @param left_out triangles whose intersections are not wanted; empty: none
/// @throws CancelledError if asked to stop
/// Exact: yes. Cost: O(pairs), parallel.
Intersections intersections_of(const ProjectedMesh& projected, const MeetingFaces& known,
                               const std::vector<std::uint8_t>& left_out, const std::stop_token& stop = {});

/// The pieces of one line in which two facets meet as one where they abut, each
/// from the lexicographically smaller end to the other. Ascending by (s, t), then by place.
std::vector<Intersection> merge_segments(const ProjectedMesh& projected, const std::vector<TriangleIntersection>& pieces);

/// A box of the image in which an intersection lies.
ImageBox box_of(const ProjectedMesh& projected, const Intersection& meet);

}  // namespace hsr::internal
