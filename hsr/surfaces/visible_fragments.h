#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <stop_token>
#include <vector>

#include "geometry/mesh.h"
#include "geometry/number.h"
#include "geometry/predicates.h"
#include "geometry/ragged.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/symbols/map_point.h"
#include "hsr/view/view.h"

namespace hsr {

/// A connected part of a face that is visible, as seen: its rings in the image.
struct Fragment {
  FacetId facet;                               ///< the planar piece of the face that it lies in
  std::uint32_t first_ring = 0, end_ring = 0;  ///< the outer ring first, counter-clockwise as seen; holes clockwise
};

struct VisibleFragments {
  std::vector<Fragment> fragments;  ///< ascending by facet, hence by face
  Ragged<MapCorner> rings;
  DecisionCounts decisions;
};

struct FragmentOptions {
  /// The visible lines of all edges of all classes, with LineOptions::diagonals, of this very view, where the caller has them:
  /// they need not be found again.
  /// For visible_fragments() only; changes no ring.
  const VisibleLines* lines = nullptr;
  std::function<void(double done)> progress = {};  ///< called now and then with the share done, 0 ... 1; may throw to cancel
  std::stop_token stop = {};                       ///< once it is asked to stop, the work ends in a CancelledError
};

/// The area of each fragment's image, in coordinates of the frame (View::frame: right by up, which are unit lengths but for
/// rounding), exactly. Perspective: in the plane of the frame.
/// @throws PreconditionError if the fragments are not of this mesh and view, where their corners then are nowhere
/// Cost: some exact rationals for each corner, parallel.
std::vector<Rational> visible_areas(const Mesh& mesh, const View& view, const VisibleFragments& fragments);

/// The visible part of each face: the regularised closure of its points that no other face hides, as connected regions.
///
///   (1) fragments of different faces do not overlap, and together they cover the union of all images
///   (2) of two faces in one plane the one on top (TieRule) is visible; a face seen edge-on has no fragment
///   (3) a face that is cut into triangles has the fragments of its triangles
///   (4) the result does not depend on the number of threads; roberts_surfaces(), and other stages, give the same rings in the same
///       order (rings.h), but perhaps with corners by other names
///
/// @throws CancelledError if asked to stop by `options.stop`, InputError beyond 2^32 - 1 corners
///
/// Built from the visible lines: each visible part of an edge, of a line where two faces pierce and of a cut by the near plane
/// bounds what is seen just to its left and just to its right (LineEnvelope); where these differ it is a side of both fragments.
/// Exact: yes. Degenerate: docs/conventions.md, "Visible fragments". Cost: O((n + k) log n) on meshes, n edges, k overlaps of
/// visible outlines with the faces beside them.
/// Source: the completion of boundaries of Auzinger, Wimmer & Jeschke 2013, with exact signs.
VisibleFragments visible_fragments(const SceneView& scene, const FragmentOptions& options = {});
/// Whether visible_fragments() saves time with FragmentOptions::lines: not where faces are seen edge-on, since in lines these
/// hide what is behind them, and fragments are bounded by lines that ignore them.
bool fragments_use_lines(const SceneView& scene);
/// Of a scene that nothing else looks at.
inline VisibleFragments visible_fragments(const Mesh& mesh, const View& view, const FragmentOptions& options = {}) {
  return visible_fragments(SceneView(mesh, view), options);
}

}  // namespace hsr
