#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hsr/scene/box_tree.h"

namespace hsr::internal {

/// A grid of marks over the image: which places some boxes touch. What touches no marked place is far from all of them.
/// Conservative. Cost: O(n + places), a query O(1).
class ImageMask {
 public:
  /// @param queries about how many boxes will be asked about: for few, few places are enough
  ImageMask(std::span<const ImageBox> boxes, std::size_t queries);

  /// False: `box` certainly overlaps none of the boxes.
  bool touches(const ImageBox& box) const;

 private:
  std::size_t at(std::int32_t i, std::int32_t j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(places_ + 1) + static_cast<std::size_t>(i);
  }

  /// First and last column, first and last row; monotonic, so that overlapping boxes share a place whatever is rounded.
  std::array<std::int32_t, 4> range(const ImageBox& box) const;

  std::int32_t places_;  // along each coordinate
  std::array<float, 2> low_ = {0, 0}, scale_ = {0, 0};
  std::vector<std::uint32_t> marked_;  // at (i, j): of the places before column i and row j
};

}  // namespace hsr::internal
