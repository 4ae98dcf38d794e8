#pragma once

#include "hsr/raster/culled.h"
#include "hsr/raster/culling_observer.h"
#include "hsr/raster/samples.h"
#include "hsr/view/view.h"

namespace hsr::internal {

/// What is left without triangles that are seen small, and what went with them.
struct ImportanceCulled : Culled {
  double lost_area = 0;  ///< of the culled as they are seen, in pixels; hidden or not
};

/// The triangles that are seen at least `size` samples wide or high, and those that doubles cannot place.
///
/// Not conservative: what is small may be seen, and many small ones may be all there is. `lost_area` says how much it was.
/// @param observer is told each test; null: nobody is
/// Exact: no. Cost: O(n).
/// Source: Zhang, Manocha, Hudson & Hoff 1997 ("approximate culling"); Foley, van Dam, Feiner & Hughes 1990.
ImportanceCulled importance_culled(const Mesh& mesh, const View& view, const SampleGrid& samples, double size,
                                   CullingObserver* observer = nullptr);

}  // namespace hsr::internal
