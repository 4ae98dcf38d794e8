#pragma once

#include <string>

#include "geometry/error.h"
#include "hsr/view/view.h"

namespace hsr::internal {

/// @throws InputError if the view has several sections, one that is seen edge-on, or a far plane. @param who knows none of these
inline void expect_one_section(const View& view, const std::string& who) {
  if (view.has_cells()) throw InputError("section: " + who + " one plane, not seen edge-on, and no depth, expected no more");
}

}  // namespace hsr::internal
