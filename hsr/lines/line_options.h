#pragma once

#include <array>
#include <functional>

#include "geometry/predicates.h"

namespace hsr {

struct LineOptions {
  /// Which classes to compute; by default all but smooth.
  std::array<bool, 6> classes = {true, true, true, true, true, false};
  double crease = 30;  ///< degrees; edges that deviate more from flat are sharp
  bool why = false;    ///< name the faces that hide each hidden interval
  Arithmetic arithmetic = Arithmetic::staged;
  std::function<void(double done)> progress;  ///< called now and then with the share done, 0 ... 1; may throw to cancel
};

}  // namespace hsr
