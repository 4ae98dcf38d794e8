#pragma once

#include <string>

#include "study/html_page.h"
#include "study/stability.h"

namespace hsr::internal {

/// One page: where each method breaks in each family, what the families are, and the error along each knob.
std::string stability_page(const Stability& stability, const PageText& text);

}  // namespace hsr::internal
