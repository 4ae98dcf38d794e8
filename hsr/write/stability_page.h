#pragma once

#include <string>

#include "hsr/check/stability.h"
#include "hsr/write/html_page.h"

namespace hsr {

/// One page: where each method breaks in each family, what the families are, and the error along each knob.
std::string stability_page(const Stability& stability, const PageText& text);

}  // namespace hsr
