#pragma once

#include <string>
#include <vector>

#include "hsr/model.h"
#include "study/comparison.h"

namespace hsr::internal {

/// A picture of a method in PNG files. What equals the truth is transparent in `changes` and `mistakes`, so these are small
/// where a method is nearly right.
struct ComparisonImages {
  std::string shown;     ///< each sample in the colour of its face
  std::string changes;   ///< the same, where it is wrong
  std::string mistakes;  ///< the colour of mistake_colour()
  std::string depth;     ///< grey, near is bright; empty: the method has none
};

/// edge: blue, tie: orange, order: red
Colour mistake_colour(Mistake mistake);

/// @param colours by face
ComparisonImages comparison_images(const Mesh& mesh, const ComparedPicture& picture, const std::vector<Colour>& colours);

}  // namespace hsr::internal
