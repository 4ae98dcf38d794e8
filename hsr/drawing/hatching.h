#pragma once

#include <array>
#include <vector>

#include "hsr/drawing/page.h"

namespace hsr::internal {

/// How a cap is hatched.
struct Hatch {
  double degrees = 45;  ///< of its lines, counter-clockwise from the right
  double spacing = 2;   ///< mm
  double phase = 0;     ///< in spacings
};

/// How thick a cap is: twice its area over the length around it, which of a strip is its width, and of a square half its side.
/// @return in units of 1000 of the rings
double thickness_of(const std::vector<std::vector<PaperPoint>>& rings);

/// The hatching for a cap: of the style that its number names, at a spacing that suits its object (ISO 128-50), from 0.7 mm to 4 mm. What is
/// thinner than 0.7 mm is filled: its lines are as wide as they are apart.
/// @param of_object the thickness of the thickest cap of its object, so that all of them are hatched alike
/// @param pen width of the lines, mm
/// @param unit all of this in other units: how many are a millimetre
Hatch hatch_for(double thickness, double of_object, std::uint32_t style, double pen, double unit = 1);

/// The lines within the rings, which do not cross; inside is where an odd number of them is around. Ends are rounded to the borders'
/// thousandths of a millimetre. Cost: O(n k) at most, for n sides and k lines.
std::vector<std::array<PaperPoint, 2>> hatch_lines(const std::vector<std::vector<PaperPoint>>& rings, const Hatch& hatch);

}  // namespace hsr::internal
