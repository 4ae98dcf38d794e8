#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/bit_range.h"
#include "geometry/exact_meet.h"
#include "geometry/plane_filter.h"
#include "hsr/painter/bsp/bsp_bounds.h"
#include "hsr/scene/projected_mesh.h"
#include "hsr/symbols/cut.h"

namespace hsr::internal {

/// Convex parts of facets while a BspTree is built: on which side of a plane they lie, and what it cuts them into.
///
/// Every corner has a place in doubles with a bound; where these leave a side open, symbols and predicates decide. A corner on
/// an edge that the plane's triangle has too lies in the plane: no sign is asked. Exact: yes.
class BspParts {
 public:
  /// A corner and about where it is; an infinite error where doubles tell nothing.
  struct Corner {
    BoundedPoint3 at;
    BspBounds::Corner bounds;
  };
  struct Part {
    FacetId facet;
    std::uint32_t first = 0, end = 0;    // corners, as the facet runs
    std::array<float, 3> low{}, high{};  // of its box, where it has been asked for: no corner is beyond, as floats round
  };
  struct Divider {
    Cut cut;
    BspBounds::Id id = BspBounds::none;  // across: once it divides
    PlaneFilter filter;
    std::array<VertexId, 3> vertices;  // of a facet
    double at = 0;                     // across: the coordinate

    bool is_across() const { return cut.kind == Cut::Kind::across; }
  };
  /// What of a part is certain to be there.
  struct Sides {
    bool behind = false, before = false;
  };

  /// @param sides those of all facets, of the whole tree @param acrosses planes that bound parts
  BspParts(const ProjectedMesh& projected, const std::vector<BspBounds::Side>& sides, const std::vector<Cut>& acrosses)
      : projected_(projected), sides_(sides), acrosses_(acrosses), exact_(projected.predicates()) {}

  std::size_t size() const { return parts_.size(); }
  const Part& operator[](std::uint32_t part) const { return parts_[part]; }
  std::span<const Corner> corners(const Part& part) const { return {corners_.data() + part.first, corners_.data() + part.end}; }

  void reserve(std::size_t parts, std::size_t corners) {
    parts_.reserve(parts);
    corners_.reserve(corners);
  }
  std::uint32_t add(FacetId facet, std::span<const BspBounds::Corner> ring);
  std::uint32_t add(const BspParts& from, const Part& part);
  void find_box(std::uint32_t part);

  Divider divider(FacetId facet) const;
  Divider divider(VertexId v, int axis) const;
  Sides sides(const Divider& d, const Part& part);
  /// The parts behind and before the plane. @pre it has something of the part on both sides
  std::array<std::uint32_t, 2> split(std::uint32_t part, const Divider& d);

  Predicates& exact() { return exact_; }

 private:
  ErrorBounded value(const Divider& d, const Corner& corner) const;
  Sign side_beyond_filter(const Divider& d, const Corner& corner, FacetId facet);
  const ExactMeet& exact_meet(FacetId facet, const BspBounds::Corner& corner);
  Corner crossing(const Divider& d, const Part& part, std::size_t k);
  Plane plane(BspBounds::Id id) const;

  const ProjectedMesh& projected_;
  const std::vector<BspBounds::Side>& sides_;
  const std::vector<Cut>& acrosses_;
  Predicates exact_;
  std::vector<Part> parts_;
  std::vector<Corner> corners_;
  /// Where a corner is, exactly; it is asked about many planes in a row, in all parts that have it.
  struct KnownMeet {
    FacetId facet;
    BspBounds::Id a = BspBounds::none, b = BspBounds::none;
    std::optional<ExactMeet> meet;
  };
  std::vector<KnownMeet> meets_;       // each in a place by its name, where it stays until another comes there
  std::optional<BitRange> bit_range_;  // of the ends of all edges, once it is needed
  std::vector<Sign> signs_;            // of the corners of a part, and the values
  std::vector<ErrorBounded> values_;
  std::vector<Corner> crossings_;
};

}  // namespace hsr::internal
