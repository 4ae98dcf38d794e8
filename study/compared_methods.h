#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "geometry/mesh.h"
#include "hsr/check/picture_check.h"
#include "hsr/image.h"
#include "hsr/raster/samples.h"
#include "hsr/scene/tie_rule.h"
#include "hsr/view/view.h"

namespace hsr::internal {

/// What a method shows at each sample, and the depths it has there.
struct ShownPicture {
  Image<TriangleId> triangles;
  Image<std::uint8_t> depth;  ///< 0 near ... 255 far; may be empty
};

/// A method that compare() can run: `solve` is what is timed, `show` gives its picture, `note` says more of its result.
struct RunnableMethod {
  std::string method, numbers;
  bool is_object_space = false;
  bool is_exact = false;
  bool is_variant = false;  ///< see ComparedMethod
  double cost = 1;          ///< more than 1: how many times as long as visible fragments it may take, as we have seen
  std::optional<DepthResolution> resolution;
  std::function<void()> solve;
  std::function<ShownPicture()> show;
  std::function<std::string()> note;
  std::function<void()> forget;  ///< frees the result
};

/// All methods that make pictures of samples, on one grid. They hold references: mesh and view must live on.
std::vector<RunnableMethod> image_space_methods(const Mesh& mesh, const View& view, const SampleGrid& grid,
                                                Coplanar coplanar = Coplanar::first);
/// All methods in object space, their pictures on the grid.
std::vector<RunnableMethod> object_space_methods(const Mesh& mesh, const View& view, const SampleGrid& grid,
                                                 Coplanar coplanar = Coplanar::first);

/// The z-buffers of the driver's OpenGL, by format; none where there is no driver.
/// @param why is told why there are none; may be null
std::vector<RunnableMethod> opengl_methods(const Mesh& mesh, const View& view, const SampleGrid& grid,
                                           Coplanar coplanar = Coplanar::first, std::string* why = nullptr);

}  // namespace hsr::internal
