#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hsr/painter/verify/verify.h"
#include "hsr/scene/tie_rule.h"
#include "hsr/view/view.h"

namespace hsr {

/// A painting order by anyone.
struct PaintingFile {
  std::vector<PaintedPolygon> far_to_near;
  std::optional<View> view;
  std::optional<Coplanar> coplanar;  ///< which of coincident faces is painted last, if the file says so
};

/// Reads "hsr-order/1" (docs/conventions.md, "JSON"): `face`, `original`, `view` and `coplanar` may be missing. Coordinates are numbers,
/// rounded correctly, or strings "p/q".
/// @throws InputError in one line: the file, the piece and point, what was found and what was expected
PaintingFile read_order(const std::string& path);

}  // namespace hsr
