#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <span>

#include "geometry/predicates.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/scene/projected_mesh.h"

namespace hsr::internal {

/// The angle by which the faces of a sharp edge deviate from flat, at least.
struct Crease {
  double degrees, cosine;

  explicit Crease(double deg) : degrees(deg), cosine(std::cos(deg * std::numbers::pi / 180)) {}
};

/// A triangle that contains a part of an edge, and is not at it.
struct EdgeContact {
  TriangleId triangle;
  std::size_t along = 3;  ///< the side along which the edge runs, a diagonal within a planar face; 3: through the inside
};

/// The class of an edge in a view, where it has these contacts; nothing for a diagonal that is no outline: it is never drawn.
///
/// On each side of the edge's view plane, of the faces at this edge, the one nearest to the eye counts (faces seen edge-on are
/// on neither side; coinciding half-planes count once). A face with the edge inside counts on both sides. First match wins:
///   boundary      one half-plane in all
///   outline       faces on one side only
///   intersection  on both sides, not in one plane, and one of them belongs to a face with the edge inside, on both sides of
///                 which there are others
///   sharp         on both sides, and the two deviate from flat by more than `crease` degrees (in doubles; exactly flat never)
///   smooth        else; also where two or more half-planes are all seen edge-on
/// A wire is `wire`, unless faces alone make it more than smooth.
/// Exact: yes, but for the angle. Cost: O(m^2) degree-3 signs for m faces at the edge, nearly always m = 2.
std::optional<EdgeClass> edge_class(const ProjectedMesh& projected, Predicates& exact, EdgeId edge, const Crease& crease,
                                    std::span<const EdgeContact> contacts = {});

}  // namespace hsr::internal
