#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "geometry/ragged.h"
#include "hsr/visibility_map/map_predicates.h"

namespace hsr::internal {

class FragmentObserver;

/// Closed rings of corners in the map, and which of them bound one connected region.
struct Rings {
  Ragged<MapCorner> rings;
  std::vector<std::uint32_t> first_ring = {0};  ///< region k has the rings first_ring[k] ... ; one more than regions
  std::vector<std::uint32_t> owner_of_region;   ///< the least of those whose sides bound it, or lie within
  std::vector<std::uint32_t> region_owner;      ///< by owner: owner_of_region of the region that it is part of
};

/// A side and the places of its ends in some coordinates of the image, in which turns are as they are seen.
struct PlacedSide {
  MapSide side;
  MapPlace from, to;
  std::uint32_t owner = 0;  ///< the polygon that it belongs to: those that end up in one region are told
};

/// Links the sides of a part of the plane into the rings that bound it. One object per thread, for many parts.
///
///   (1) the regions are the connected interiors; the first ring of each is its outer one, counter-clockwise as seen, the
///       others are holes, clockwise
///   (2) rings are simple: none passes through a point twice; rings of one region may share points, not sides
///   (3) only true corners: no point of a ring is in line with its neighbours
///   (4) sides may come in any order and in any pieces; what lies on another side the other way round cancels, and what comes
///       twice counts once
///   (5) a ring begins at its leftmost corner, of several the lowest; regions, and holes of one, ascend by where they begin, and
///       of those that begin at one corner, by the next
///
/// @pre the sides, cancelled, bound a part of the plane that lies to their left
/// @throws InvariantError if they do not
/// Exact: yes. Cost: O(m log m) for m sides, and a look for each side at the points that share its range of x, about the root
/// of m in a mesh of even triangles; O(m^2) where doubles do not tell points apart.
class RingLinker {
 public:
  /// @param observer is told how; null: nobody is
  explicit RingLinker(MapPredicates& map, FragmentObserver* observer = nullptr);
  ~RingLinker();

  /// The answer holds until the next call.
  const Rings& link(std::span<const PlacedSide> sides);

 private:
  class Linker;
  std::unique_ptr<Linker> linker_;
};

/// Links the sides of one part of the plane: a RingLinker that is used once.
/// @param owners by side; empty: not told apart
Rings link_rings(MapPredicates& map, std::span<const MapSide> sides, std::span<const std::uint32_t> owners = {});

}  // namespace hsr::internal
