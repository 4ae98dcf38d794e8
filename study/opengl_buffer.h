#pragma once

#include <array>
#include <memory>
#include <string>

#include "geometry/mesh.h"
#include "hsr/image.h"
#include "hsr/raster/depth_format.h"
#include "hsr/raster/samples.h"
#include "hsr/scene/tie_rule.h"
#include "hsr/view/view.h"

namespace hsr::internal {

/// The formats that a driver has.
constexpr std::array<DepthFormat, 4> opengl_formats = {DepthFormat::fixed16, DepthFormat::fixed24, DepthFormat::float32,
                                                       DepthFormat::reversed_float32};

struct OpenGlOptions {
  DepthFormat format = DepthFormat::fixed24;  ///< fixed16, fixed24, float32 or reversed_float32
  TieRule ties = {};                          ///< what is on top is drawn first
  /// glPolygonOffset, for the triangles from number `offset_from` on.
  float offset_factor = 0, offset_units = 0;
  std::size_t offset_from = 0;
};

/// OpenGL as it is on this machine, without a window: a context of EGL, for the thread that draws.
class OpenGl {
 public:
  /// Null: hsr was built without it, or there is no driver with OpenGL 4.5; why() says so.
  static std::unique_ptr<OpenGl> make();
  static const std::string& why();
  ~OpenGl();
  OpenGl(const OpenGl&) = delete;
  OpenGl& operator=(const OpenGl&) = delete;

  /// What the driver calls itself: "llvmpipe".
  const std::string& driver() const;
  /// How many bits of a sample it tells corners apart by.
  int subpixel_bits() const;

  /// The picture by its depth buffer, with GL_LESS: corners are given as floats, each sample is in the middle of its pixel.
  ///
  /// Exact: no, and what it does on edges and with depths is the driver's. Corners farther than 2^60 samples away, or in the plane of the
  /// eye, are not drawn. Cost: the driver's.
  /// @throws InputError for a format that it has not, or a picture that is too large for it
  Image<TriangleId> draw(const Mesh& mesh, const View& view, const SampleGrid& samples, const DepthRange& range,
                         const OpenGlOptions& options = {});

 private:
  struct Context;
  explicit OpenGl(std::unique_ptr<Context> context);

  std::unique_ptr<Context> context_;
};

/// The driver of this machine: to ask for one takes longer than most pictures, and is done once. Null: none.
inline OpenGl* opengl_driver() {
  static const std::unique_ptr<OpenGl> driver = OpenGl::make();
  return driver.get();
}

}  // namespace hsr::internal
