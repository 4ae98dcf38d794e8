#pragma once

#include <cstdint>
#include <span>

#include "hsr/lines/invisibility_events.h"
#include "hsr/lines/shadow_observer.h"

namespace hsr::internal {

/// How many triangles are in front of a point that is moved a little to the left of an edge, and to the right.
struct Layers {
  std::int32_t left = 0, right = 0;
};

/// From what the count at the first point of an edge is known.
enum class CountStart : std::uint8_t {
  first_vertex,  ///< from the count at the vertex where the walk begins
  last_vertex,   ///< from that where it ends, back along the edge
  own_ray,       ///< something passes in front of both vertices: a ray of its own
};

/// Is told how appel() counts, in the order in which it does. Of edges for which a count cannot decide it is told the shadows.
class CountObserver : public ShadowObserver {
 public:
  /// The edges at whose images the count changes.
  virtual void occluding(std::span<const OccludingEdge> edges) = 0;
  /// What happens along an edge, before any count is known. @param changes in no order
  virtual void looked_along(EdgeId edge, const EdgeWalk& walk, std::span<const InvisibilityChange> changes) = 0;
  /// A ray, the only one of a connected part of the drawing: so many triangles are in front of v, without those at it.
  virtual void rayed(VertexId v, std::int32_t count) = 0;
  /// The count at the other end of an edge, from that at a vertex where it is known; both without the triangles at the vertex.
  virtual void carried(EdgeId edge, VertexId from, VertexId to, std::int32_t count) = 0;
  /// An edge is followed with its count. @param layers just inside its first vertex
  virtual void walk_began(const LineTask& line, CountStart start, const Layers& layers) = 0;
  /// The walk comes to a place where the count changes. @param layers beyond it
  virtual void changed(const Breakpoint& at, const InvisibilityChange& change, const Layers& layers) = 0;
};

/// visible_lines() by Appel, watched, in one thread: it does the same and gives the same.
/// @pre options.method is appel; the view has no cells
VisibleLines visible_lines(const SceneView& scene, const LineOptions& options, CountObserver& observer);

}  // namespace hsr::internal
