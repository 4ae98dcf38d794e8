#pragma once

#include <optional>

#include "hsr/lines/visible_lines.h"

namespace hsr::internal {

/// The lines for a drawing of what is visible: of an edge, or where two facets meet, one line for each class, whatever lines its visible
/// parts are of. How what is hidden between them was divided, or whether it is known, then makes no difference to a drawing.
///
/// Nothing: they are so already. Lines without a visible part may be missing, and those of class `overhead` stay as they are.
/// Exact: yes. Cost: O(n), and an exact parameter where two parts meet that have different names there.
std::optional<VisibleLines> visible_by_class(const Mesh& mesh, const View& view, const VisibleLines& lines);

}  // namespace hsr::internal
