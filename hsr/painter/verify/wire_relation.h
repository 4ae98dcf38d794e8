#pragma once

#include <optional>

#include "hsr/painter/verify/painted_parts.h"
#include "hsr/painter/verify/verify.h"

namespace hsr::internal {

/// Where the image of a painted wire runs inside that of a polygon's part, in rationals: for whether it is in front there. Its own
/// code, by places of the image: it judges what wires.cpp has found along the wire.
class WireRelation {
 public:
  /// @pre wire.is_wire() and not part.is_wire()
  WireRelation(const PaintedParts& all, const View& view, const PaintedPart& wire, const PaintedPart& part);

  bool overlaps() const { return low_ < high_; }
  /// The wire is in front somewhere, or lies on the part. @pre overlaps()
  bool is_in_front() const { return wire_stretch(true).first < wire_stretch(true).second; }
  bool is_behind() const { return wire_stretch(false).first < wire_stretch(false).second; }
  /// The middle of where it is; with what is seen of the wire as of_earlier, and of the part as of_later. @pre it is somewhere
  Witness witness(bool is_in_front) const;

 private:
  std::pair<Rational, Rational> wire_stretch(bool in_front) const;
  RationalVector point_of_wire(const Rational& at) const;

  const ImageRows& rows_;
  const View& view_;
  std::array<RationalVector, 2> ends_;
  RationalVector normal_, on_;
  std::array<ImagePlace, 2> places_;
  Rational low_ = 0.0, high_ = 1.0;        // along the image of the wire
  std::array<Sign, 2> sides_;              // of the ends: positive, in front of the part's plane
  std::optional<Rational> through_plane_;  // where the wire passes through it, if it does within
};

}  // namespace hsr::internal
