#pragma once

#include <string>
#include <vector>

#include "study/comparison.h"
#include "study/comparison_pictures.h"
#include "study/html_page.h"

namespace hsr::internal {

/// One page with all of it: two methods beside each other under a slider, diagrams, tables.
/// @param images of Comparison::pictures, in this order
std::string comparison_page(const Comparison& comparison, const std::vector<ComparisonImages>& images, const PageText& text);

}  // namespace hsr::internal
