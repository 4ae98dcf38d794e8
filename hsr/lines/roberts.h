#pragma once

#include <array>
#include <functional>

#include "hsr/lines/visible_lines.h"

namespace hsr {

struct LineOptions {
  /// Which classes to compute; by default all but smooth.
  std::array<bool, 6> classes = {true, true, true, true, true, false};
  double crease = 30;  ///< degrees; edges that deviate more from flat are sharp
  bool why = false;    ///< name the faces that hide each hidden interval
  Arithmetic arithmetic = Arithmetic::staged;
  std::function<void(double done)> progress;  ///< called now and then with the share done, 0 ... 1; may throw to cancel
};

/// The visible and the hidden parts of each edge: each edge against each face that overlaps it in the image.
///
///   (1) the intervals of one edge tile it beyond the near plane, and none is empty
///   (2) removing a face never removes a visible point
///   (3) the result does not depend on the order of the faces or on the number of threads
///
/// Exact: yes. Degenerate: docs/conventions.md. Cost: O(n log n + k log k), k = edge-triangle pairs that overlap in the image.
/// Source: Roberts 1963, the hidden interval of each edge; closed triangles as bodies.
VisibleLines roberts(const Mesh& mesh, const View& view, const LineOptions& options = {});

}  // namespace hsr
