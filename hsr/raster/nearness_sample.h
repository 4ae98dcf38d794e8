#pragma once

namespace hsr::internal {

/// What a z-buffer of nearness did at a sample: larger is nearer, nothing held is minus infinity.
struct NearnessSample {
  int column = 0, row = 0;
  double nearness = 0;    ///< of the triangle there
  double held = 0;        ///< what the buffer had before
  bool is_shown = false;  ///< it is nearer: the buffer has it now
};

}  // namespace hsr::internal
