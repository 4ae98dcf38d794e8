#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hsr/drawing/projection.h"

namespace hsr::internal {

/// The images of the ends of edges that are drawn; of other vertices nothing is kept but a number.
class EndImages {
 public:
  EndImages() = default;
  /// @param drawn numbers of lines
  EndImages(const Projection& projection, const VisibleLines& lines, std::span<const std::uint32_t> drawn);

  const HomogeneousPoint& operator[](VertexId v) const { return at_[place_[v.value]]; }

 private:
  std::vector<std::uint32_t> place_;  // by vertex
  std::vector<HomogeneousPoint> at_;
};

}  // namespace hsr::internal
