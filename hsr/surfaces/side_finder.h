#pragma once

#include <optional>
#include <span>
#include <vector>

#include "hsr/lines/visible_lines.h"
#include "hsr/scene/intersections.h"
#include "hsr/scene/occluders.h"
#include "hsr/scene/section_caps.h"
#include "hsr/surfaces/cap_arrangement.h"
#include "hsr/surfaces/line_envelope.h"
#include "hsr/surfaces/rings.h"

namespace hsr::internal {

class FragmentObserver;

/// Sides of fragments, and of which facet each is.
struct FacetSides {
  std::vector<FacetId> facets;
  std::vector<PlacedSide> sides;

  void add(FacetId facet, const PlacedSide& side) {
    facets.push_back(facet);
    sides.push_back(side);
  }
};

/// Collects the sides along the lines of the map. One object per block of lines.
class SideFinder {
 public:
  /// @param place of each triangle among the prepared ones @param pyramid what is known to be hidden, or nullptr
  /// @param caps of a section, or nullptr @param observer is told how; null: nobody is
  SideFinder(const ProjectedMesh& projected, const Occluders& occluders, const Intersections& intersections,
             const std::vector<std::uint32_t>& place, const OcclusionPyramid* pyramid, const SectionCaps* caps,
             FragmentObserver* observer = nullptr)
      : projected_(projected),
        caps_(caps),
        observer_(observer),
        mesh_(projected.mesh()),
        occluders_(occluders),
        intersections_(intersections),
        place_(place),
        map_(projected),
        left_(map_, occluders, pyramid),
        right_(map_, occluders, pyramid) {}

  void add_edge(const VisibleLines& lines, const Line& line);
  void add_intersection(const TriangleIntersection& crossing);
  void add_near_cut(TriangleId t);
  void add_cap_border(const CapArrangement& caps, const CapRun& run);

  FacetSides take() { return std::move(sides_); }
  const DecisionCounts& decisions() { return map_.exact().counts(); }

 private:
  /// The triangle that the edge has on a side, if it is the only one and nothing else touches the edge there; invalid
  /// otherwise.
  TriangleId only_triangle(EdgeId e, Sign side) const;
  std::vector<MapStretch> outside_caps(const MapStretch& stretch, TriangleId beside);
  BoundedPoint3 scaled_point(const RationalVector& given) const;
  MapPoint point_at(const Edge& edge, TriangleId beside, const Cut& cut) const;
  BoundedPoint3 place_of(const Edge& edge, const Cut& cut) const;
  BoundedPoint3 end_of(const TriangleIntersection& crossing, const Cut& cut, const MapPoint& seen) const;
  void add(MapStretch stretch, TriangleId left, TriangleId right);
  Sign runs_along(const TriangleIntersection& crossing, const MapStretch& stretch);
  void add_meeting(const MapStretch& stretch, std::span<const SeenPart> left);
  void add_side(FacetId facet, const PlacedSide& side);
  void add_different(const MapStretch& stretch, std::span<const SeenPart> left, std::span<const SeenPart> right);
  MapPlace place(const MapStretch& stretch, const MapPoint& p, double t, double error) const;

  const ProjectedMesh& projected_;
  const SectionCaps* caps_;
  FragmentObserver* observer_;
  const Mesh& mesh_;
  const Occluders& occluders_;
  const Intersections& intersections_;
  const std::vector<std::uint32_t>& place_;
  MapPredicates map_;
  LineEnvelope left_, right_;
  FacetSides sides_;
};

}  // namespace hsr::internal
