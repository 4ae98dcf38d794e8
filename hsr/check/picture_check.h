#pragma once

#include <cstdint>
#include <optional>

#include "hsr/image.h"
#include "hsr/raster/depth_format.h"
#include "hsr/raster/samples.h"
#include "hsr/view/view.h"

namespace hsr::internal {

/// How a picture differs from the truth at a sample.
enum class Mistake : std::uint8_t {
  none,
  edge,   ///< the face that it shows does not cover the sample, or it shows none where one is, or the nearest may not have been
          ///< drawn there: an edge is misplaced
  tie,    ///< a face behind the nearest, by no more than the depth format tells
  order,  ///< a face behind the nearest, by more: the method painted it over
};

/// A picture by any method against the nearest faces.
struct PictureCheck {
  std::uint64_t samples = 0, covered = 0;  ///< all; with a face in truth
  std::uint64_t wrong = 0;                 ///< the sum of the following
  std::uint64_t edge = 0, tie = 0, order = 0;
  Image<Mistake> mistakes;
};

/// What a depth buffer can tell apart.
struct DepthResolution {
  DepthFormat format = DepthFormat::float64;
  DepthRange range;
  /// How far from where it is a corner may be drawn, in samples: on a slope that is a difference of depth, too.
  double coordinate_error = 0;
};

/// Compares a picture with what cast() sees, and says of each difference what kind it is: whether the shown face covers the
/// sample, and how far it is behind the nearest, are decided exactly.
///
/// A tie is a difference of at most two steps of the format there, since both depths were rounded, and of what the slopes of
/// the two change within the error of coordinates. Without a resolution only equal depths are ties. Where the nearest face is lost
/// to one behind it, and ends within the error of coordinates from the sample, an edge is misplaced, too.
/// @param shown, nearest triangles; those of one facet are the same
/// Exact: yes, but for the resolution, which is what it is said to be. Cost: O(samples), and some rationals for each triangle
/// at a differing sample; parallel.
PictureCheck check_picture(const Mesh& mesh, const View& view, const SampleGrid& samples, const Image<TriangleId>& shown,
                           const Image<TriangleId>& nearest, const std::optional<DepthResolution>& resolution = {});

}  // namespace hsr::internal
