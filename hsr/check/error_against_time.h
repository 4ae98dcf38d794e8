#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "hsr/check/area_check.h"
#include "hsr/check/z_buffer_check.h"
#include "hsr/raster/samples.h"
#include "hsr/scene/scene.h"
#include "hsr/surfaces/visible_fragments.h"
#include "hsr/view/view.h"

namespace hsr::internal {

/// What a method takes, and how wrong it is: one point of a work-precision diagram.
struct ErrorAgainstTime {
  std::string method, numbers;
  int threads = 1;
  int width = 0, height = 0;    ///< 0: not a picture of samples
  std::vector<double> seconds;  ///< of each run, ascending
  ZBufferCheck samples;         ///< those wrong, and why; of the exact method, those of all sizes
  AreaCheck area;               ///< in pixels of this size; of the exact method, of the largest
};

struct ErrorAgainstTimeOptions {
  std::vector<int> sizes = {256, 512, 1024, 2048, 4096, 8192};
  int runs = 3;
  std::function<void(double done)> progress;  ///< called now and then with the share done, 0 ... 1; may throw to cancel
};

/// Error against run time on one scene: the z-buffer in floats and doubles at each size, and last visible_fragments(), which is
/// the line at error zero: areas are measured with its fragments, and these are compared with the caster at each sample of each
/// size.
///
/// @param grid gives the samples of a size
/// @throws PreconditionError as paint() does
/// Cost: each method `runs` times, and a cast() for each size. The largest picture takes 20 bytes a sample and more.
std::vector<ErrorAgainstTime> error_against_time(const SceneView& scene, const VisibleFragments& fragments,
                                                 const std::function<SampleGrid(int size)>& grid,
                                                 const ErrorAgainstTimeOptions& options = {});

}  // namespace hsr::internal
