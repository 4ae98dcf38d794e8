#pragma once

#include <cmath>
#include <string>

#include "hsr/raster/depth_buffer.h"
#include "study/explain/trace.h"
#include "study/explain/traced_scene.h"
#include "study/html_page.h"

namespace hsr::internal {

/// How depths are written: as whole numbers of steps, as fractions, or in units of a lecture.
struct ShownDepth {
  bool is_fixed = false;  ///< as the stored number
  double units = 0;       ///< the far plane is at this depth, not at 1; 0: as stored
  double first = 0;       ///< and the near plane at this
  double steps = 0;       ///< of a fixed format; add_z_buffer_run() sets it

  std::string text(double depth, double stored) const;
  /// Of what is interpolated, before it is rounded to be stored.
  std::string text(double depth) const { return trace_text(first + depth * scale()); }
  std::string change(double x) const { return trace_text(x * scale()); }
  double scale() const { return units != 0 ? units - first : steps != 0 ? steps : 1; }
};

/// Adds a run of a depth buffer to a trace of this picture.
void add_z_buffer_run(Trace& trace, const std::string& name, const ScenePicture& picture, const DepthRange& range,
                      const DepthBufferOptions& options, const ShownDepth& shown);

}  // namespace hsr::internal
