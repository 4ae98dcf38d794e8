#pragma once

#include <array>
#include <string>
#include <vector>

#include "hsr/coordinates/rounded_coordinates.h"
#include "hsr/drawing/projection.h"
#include "hsr/io/write/json.h"

namespace hsr::internal {

/// Writes where the intervals of lines are, beside their parameters, so that no mesh is needed to draw them. One object per thread.
class IntervalPlaces {
 public:
  IntervalPlaces(const Mesh& mesh, const View& view, Numbers numbers)
      : mesh_(mesh), view_(view), numbers_(numbers), rounded_(mesh, view), frame_(mesh, view, view.frame.origin) {}

  /// `, "visible_points": [[[x, y, z], [x, y, z]], ...], "visible_image": [[[x, y], [x, y]], ...]` and the same of hidden ones.
  void append(std::string& out, const VisibleLines& lines, const Line& line, const SupportingLine& support);

 private:
  void place(const SupportingLine& support, const Cut& cut, std::string& space, std::string& image) const;

  const Mesh& mesh_;
  const View& view_;
  Numbers numbers_;
  RoundedCoordinates rounded_;
  Projection frame_;
  std::array<std::vector<std::string>, 2> places_;  // in space and in the image, of the cuts of the line at hand
};

}  // namespace hsr::internal
