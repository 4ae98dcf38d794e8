#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/mesh.h"
#include "geometry/number.h"
#include "hsr/painter/painters_order.h"
#include "hsr/scene/scene.h"
#include "hsr/view/view.h"

namespace hsr {

/// A polygon of a painting order by anyone: corners in space, exactly. With two corners, a part of a wire.
struct PaintedPolygon {
  std::optional<std::uint32_t> face;  ///< of coplanar ones that overlap the one on top comes last (TieRule)
  std::vector<std::array<Rational, 3>> corners;
};

/// A point of the image strictly inside the common part of two polygons, and what of each is seen there: exact, and proven
/// there.
struct Witness {
  std::array<Rational, 2> place;                 ///< in coordinates of the view's frame
  std::array<Rational, 3> of_earlier, of_later;  ///< in space; in a cycle of the farther and of the nearer
};

/// What is wrong with two polygons.
enum class Fault : std::uint8_t {
  order,          ///< the one that is painted later is nowhere nearer
  piercing,       ///< each is nearer somewhere: no order of the two is right
  coplanar,       ///< where they are in one plane, the one of the face on top is painted earlier
  covered_twice,  ///< two pieces of one face, in one plane
};

/// Two polygons and a place where the one that is painted later is the farther, or where both are in one plane.
struct Violation {
  std::uint32_t earlier = 0, later = 0;  ///< numbers of polygons
  Fault fault = Fault::order;
  Witness witness;
};

struct Verdict {
  std::uint64_t polygons = 0;       ///< that have an area in the image, beyond the near plane
  std::uint64_t wires = 0;          ///< parts of wires that have a length there
  std::uint64_t triangulated = 0;   ///< polygons that are not planar or not convex, and are judged by their triangles
  std::uint64_t overlapping = 0;    ///< pairs whose images overlap
  std::uint64_t wrong = 0;          ///< of them, painted the wrong way round or piercing each other
  std::uint64_t piercing = 0;       ///< of these, piercing
  std::uint64_t covered_twice = 0;  ///< pairs of pieces of one face that overlap in its plane; they are not `wrong`
  std::vector<Violation> first;     ///< ascending, up to the limit

  /// Some order of these polygons is right (but for what is covered twice). If not, `cycle` is a shortest cycle: at
  /// cycle_witnesses[k] polygon cycle[k] is behind the next one, and the last behind the first, so each would have to be
  /// painted earlier than the next. Two polygons that pierce each other are such a cycle.
  bool order_exists = true;
  std::vector<std::uint32_t> cycle;
  std::vector<Witness> cycle_witnesses;
  /// So many cuts, each straight across a polygon, suffice (0 where an order exists): in each set of polygons that are in
  /// cycles with one another, one for each polygon and each plane of another that passes through it, and those that make
  /// triangles of what is not planar or not convex. Then each plane has each piece on one side, so that a tree of these planes
  /// orders them. Nothing: the set is too large to count.
  std::optional<std::uint64_t> cuts_that_suffice;

  bool is_correct() const { return wrong == 0 && covered_twice == 0; }
};

/// The pieces and wires of an order, to be verified as anyone's. Exact: yes.
/// @throws PreconditionError if the order is not of this scene
std::vector<PaintedPolygon> painted_polygons(const SceneView& scene, const PaintersOrder& order);

struct VerifyOptions {
  std::size_t limit = 10;  ///< violations to describe
  TieRule ties = {};       ///< of coplanar faces
};

/// Whether painting the polygons in this order shows, along every line of sight through the interiors of two images, the nearer
/// last.
///
/// A wire has to come after the polygons that it is in front of, or lies on, and before those that it is behind, where its image runs
/// inside theirs; two wires have no order that is wrong.
///
/// By every pair whose images overlap, exactly; it shares no code with what sorts. Touching is no overlap. A polygon that is
/// not planar, or not convex, is judged by its triangles (docs/conventions.md, "Faces as used").
///
///   (1) the last of coplanar polygons that overlap has the face on top; polygons without a face have no order that is wrong
///   (2) what the near plane and sections take away is removed first; a polygon that is seen edge-on is passed over
///   (3) the same verdict for any number of threads
///
/// @throws InputError for a polygon that has to be cut into triangles and has corners that are no doubles
/// Exact: yes. Cost: O(n log n + k) for k pairs whose boxes overlap in the image, parallel; orientations of four points, in
/// stages; rationals where corners are no doubles.
Verdict verify(const std::vector<PaintedPolygon>& far_to_near, const View& view, const VerifyOptions& options = {});

}  // namespace hsr
