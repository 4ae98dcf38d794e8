#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "hsr/painter/painters_order.h"
#include "hsr/scene/tie_rule.h"
#include "study/image_stages.h"

namespace hsr::internal {

/// A picture in colours, against the exact one with many samples to a pixel.
struct ComparedColours {
  std::string method, samples;                      ///< samples to a pixel
  double seconds = 0;                               ///< of the order or the corners, too
  std::size_t bytes = 0;                            ///< working storage of a buffer; 0: not told
  double mean_difference = 0, most_difference = 0;  ///< in levels of 0 ... 255, over pixels and colours
  double changed_share = 0;                         ///< of the pixels: more than one level off
};

/// z-buffer, painter by centroids and exact order, each with 1 x 1 to 8 x 8 samples to a pixel, against 16 x 16 exact rays:
/// what supersampling costs and gains. Each face has a colour of its own.
std::vector<ComparedColours> compare_supersampling(const Mesh& mesh, const View& view, const PaintersOrder& order,
                                                   double order_seconds, const std::function<SampleGrid(int size)>& grid,
                                                   int size, const Timer& timed, Coplanar coplanar = Coplanar::first);

/// Painter's order, alpha-buffer and A-buffer, each face in a colour of its own and half transparent, against the painter's
/// order with 8 x 8 samples to a pixel.
///
/// @param order of the mesh in this view, and how long it took
/// @param grid gives the samples of a size
std::vector<ComparedColours> compare_transparency(const Mesh& mesh, const View& view, const PaintersOrder& order,
                                                  double order_seconds, const std::function<SampleGrid(int size)>& grid,
                                                  int size, const Timer& timed, Coplanar coplanar = Coplanar::first);

}  // namespace hsr::internal
