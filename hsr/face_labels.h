#pragma once

#include <cstdint>
#include <vector>

namespace hsr {

/// What the faces of a scene belong to. By face; an empty list: all faces are alike.
///
/// Where a surface goes on flat and only its material changes there is an edge of class `material`, where only its object does,
/// one of class `joint`. Labels decide nothing about what hides what.
struct FaceLabels {
  std::vector<std::uint32_t> object;
  std::vector<std::uint32_t> material;
};

}  // namespace hsr
