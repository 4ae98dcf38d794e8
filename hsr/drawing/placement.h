#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hsr/drawing/drawing.h"
#include "hsr/drawing/projection.h"

namespace hsr::internal {

/// The sheet of a drawing, with the projection placed on it.
struct Placement {
  Projection projection;
  double width, height, scale;
  bool fits = true;
  std::optional<PaperFrame> frame;  ///< only with a field of view
};

/// Where the drawing goes: the page, turned if that suits it, and the scale. `drawn` are the lines with a part in the picture.
/// @throws InputError if the field of view is not within (0, 180), or the drawing is wider than 1e9 mm
Placement placement(const Mesh& mesh, const View& view, const VisibleLines& lines, std::span<const std::uint32_t> drawn,
                    const DrawingOptions& options);

/// A few of the lines that alone place a drawing as all of `drawn` do: those that reach farthest, and the first.
std::vector<std::uint32_t> bounding_lines(const Mesh& mesh, const View& view, const VisibleLines& lines,
                                          std::span<const std::uint32_t> drawn);

}  // namespace hsr::internal
