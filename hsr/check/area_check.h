#pragma once

#include "geometry/mesh.h"
#include "hsr/image.h"
#include "hsr/raster/samples.h"
#include "hsr/scene/scene.h"
#include "hsr/surfaces/visible_fragments.h"
#include "hsr/view/view.h"

namespace hsr::internal {

/// How well a picture of samples shows the visible areas, in pixels.
struct AreaCheck {
  double visible = 0;  ///< of all fragments, within the picture
  double wrong = 0;    ///< where the pixel shows another face than is visible, or nothing, or something where nothing is
  /// Half the length of all sides of fragments: what two share counts once.
  double boundary = 0;

  /// How far the picture has an edge from where it is, in pixels, on average.
  double edge_error() const { return boundary > 0 ? wrong / boundary : 0; }
};

/// Takes each sample of `shown` for the square of its pixel, and measures the part of it in which the facet of the triangle
/// that it shows is not the visible one. Not a matter of samples: the fragments are clipped to each pixel.
///
/// @pre paint() takes the fragments
/// Exact: no; it is a measure, in doubles, and decides nothing. Cost: O(pixels covered + pixels that
/// sides of fragments pass, sorted), parallel.
/// Source: coverage by areas under edges, as FreeType's smooth rasterizer has it.
AreaCheck check_area(const SceneView& scene, const VisibleFragments& fragments, const SampleGrid& samples,
                     const Image<TriangleId>& shown);
/// Of a scene that nothing else looks at.
inline AreaCheck check_area(const Mesh& mesh, const View& view, const VisibleFragments& fragments, const SampleGrid& samples,
                            const Image<TriangleId>& shown) {
  return check_area(SceneView(mesh, view), fragments, samples, shown);
}

}  // namespace hsr::internal
