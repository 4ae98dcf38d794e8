#include "hsr/io/write/interval_places.h"

#include "hsr/io/write/json_text.h"
#include "hsr/symbols/constructions.h"

namespace hsr::internal {

void IntervalPlaces::place(const SupportingLine& support, const Cut& cut, std::string& space, std::string& image) const {
  space = image = "[";
  if (numbers_ == Numbers::exact) {
    const std::array<Rational, 3> exact = exact_point(mesh_, view_, support, cut);
    const std::array<Rational, 2> seen = frame_.exact(exact);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (axis > 0) space += ", ";
      append_rational(space, exact[axis], numbers_);
    }
    append_rational(image, seen[0], numbers_);
    image += ", ";
    append_rational(image, seen[1], numbers_);
  } else {
    const PlacedPoint at = rounded_.at(support, cut);
    for (int axis = 0; axis < 3; ++axis) {
      if (axis > 0) space += ", ";
      append_number(space, at.space[axis], numbers_);
    }
    append_number(image, at.paper.x, numbers_);
    image += ", ";
    append_number(image, at.paper.y, numbers_);
  }
  space += ']';
  image += ']';
}

void IntervalPlaces::append(std::string& out, const VisibleLines& lines, const Line& line, const SupportingLine& support) {
  const auto cuts = lines.cuts_of(line);
  for (auto& of_cuts : places_) of_cuts.resize(cuts.size());
  for (std::size_t k = 0; k < cuts.size(); ++k) place(support, cuts[k], places_[0][k], places_[1][k]);
  for (const bool hidden : {false, true}) {
    for (std::size_t kind = 0; kind < 2; ++kind) {
      out += hidden ? ", \"hidden_" : ", \"visible_";
      out += kind == 0 ? "points\": [" : "image\": [";
      const char* comma = "";
      for (std::uint32_t k = 0; k < line.intervals(); ++k) {
        if (line.hidden(k) != hidden) continue;
        out += comma;
        comma = ", ";
        out += '[' + places_[kind][k] + ", " + places_[kind][k + 1] + ']';
      }
      out += ']';
    }
  }
}

}  // namespace hsr::internal
