#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/mesh.h"
#include "geometry/number.h"
#include "hsr/view.h"

namespace hsr {

/// A polygon of a painting order by anyone: corners in space, exactly.
struct PaintedPolygon {
  std::optional<std::uint32_t> face;  ///< of coplanar ones that overlap the higher comes first
  std::vector<std::array<Rational, 3>> corners;
};

/// A point of the image strictly inside the common part of two polygons, and what of each is seen there.
struct Witness {
  std::array<Rational, 2> place;                 ///< in coordinates of the view's frame
  std::array<Rational, 3> of_earlier, of_later;  ///< in space
};

/// Two polygons of which the one that is painted later is the farther somewhere.
struct Violation {
  std::uint32_t earlier = 0, later = 0;  ///< numbers of polygons
  bool piercing = false;                 ///< the earlier is the farther elsewhere: no order of the two is right
  bool coplanar = false;  ///< they lie in one plane, and the higher face is painted last; or one face covers a place twice
  Witness witness;
};

struct Verdict {
  std::uint64_t polygons = 0;      ///< that have an area in the image, beyond the near plane
  std::uint64_t triangulated = 0;  ///< polygons that are not planar or not convex, and are judged by their triangles
  std::uint64_t overlapping = 0;   ///< pairs whose images overlap
  std::uint64_t wrong = 0;         ///< of them, painted the wrong way round or piercing each other
  std::uint64_t piercing = 0;
  std::vector<Violation> first;  ///< ascending, up to the limit
  /// Some order of these polygons is right. If not: polygons of which each hides a part of the one before it, and the first of
  /// the last, with a witness for each; or the first piercing pair.
  bool order_exists = true;
  std::vector<std::uint32_t> cycle;
  std::vector<Witness> cycle_witnesses;
  /// So many cuts along planes of polygons suffice: of each that no order puts right by the planes of the others that pass
  /// through it. Nothing: too many to count.
  std::optional<std::uint64_t> cuts_that_suffice;

  bool is_correct() const { return wrong == 0; }
};

struct VerifyOptions {
  std::size_t limit = 10;  ///< violations to describe
};

/// Whether painting the polygons in this order shows, along every line of sight through the interiors of two images, the nearer
/// last.
///
/// By every pair whose images overlap, exactly; it shares no code with what sorts. Touching is no overlap. A polygon that is
/// not planar, or not convex, is judged by its triangles (docs/conventions.md, "Faces as used").
/// @throws InputError for a polygon that has to be cut into triangles and has corners that are no doubles
/// Exact: yes. Cost: O(n log n + k) for k pairs whose boxes overlap in the image, parallel; rationals where enclosures do not
/// tell.
Verdict verify(const std::vector<PaintedPolygon>& far_to_near, const View& view, const VerifyOptions& options = {});

}  // namespace hsr
