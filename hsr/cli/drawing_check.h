#pragma once

#include <string>
#include <vector>

#include "hsr/check/picture_check.h"
#include "hsr/check/sample_checks.h"
#include "hsr/check/z_buffer_check.h"
#include "hsr/cli/report.h"
#include "hsr/raster/samples.h"
#include "hsr/scene/scene.h"
#include "hsr/surfaces/visible_fragments.h"

namespace hsr::cli {

/// What a z-buffer of the driver's OpenGL shows, against the nearest face at each sample.
struct DriverCheck {
  std::string method, numbers;  ///< "OpenGL, llvmpipe", "fixed 24"
  internal::PictureCheck check;
};

/// The fragments of a drawing, and z-buffers of the same picture, against the nearest face at each sample.
struct DrawingCheck {
  FragmentCheck fragments;
  internal::ZBufferCheck single, twice;  ///< of floats, of doubles
  std::vector<DriverCheck> driver;       ///< none where there is no driver, or there is a section: these decide nothing

  bool is_right() const { return fragments.is_right() && single.is_explained() && twice.is_explained(); }
};

DrawingCheck check_drawing(const SceneView& scene, const VisibleFragments& fragments, const SampleGrid& samples);

/// For the report.
Report::Json json_of(const DrawingCheck& check);

/// Says on standard error what was found.
void say(const DrawingCheck& check);

}  // namespace hsr::cli
