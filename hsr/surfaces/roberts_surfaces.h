#pragma once

#include "hsr/surfaces/visible_fragments.h"

namespace hsr::internal {

/// The visible fragments of each face: the face minus the shadows of the faces in front of it, in convex pieces that are
/// bounded by lines of the scene.
///
/// The reference for visible_fragments(): slower, and it shares with it no more than the signs and how sides are linked to
/// rings. Exact: yes. Cost: for each face the number of shadows on it times the pieces that it falls into. Source: Roberts 1963 and
/// Weiler & Atherton 1977, with the shadow of one triangle as the body.
/// @throws CancelledError if asked to stop by `options.stop`, InputError beyond 2^32 - 1 corners
VisibleFragments roberts_surfaces(const SceneView& scene, const FragmentOptions& options = {});
/// Of a scene that nothing else looks at.
inline VisibleFragments roberts_surfaces(const Mesh& mesh, const View& view, const FragmentOptions& options = {}) {
  return roberts_surfaces(SceneView(mesh, view), options);
}

}  // namespace hsr::internal
