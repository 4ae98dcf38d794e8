#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "hsr/drawing/paper_sides.h"

namespace hsr::internal {

struct ImageBox;

/// Polygons on the paper by their conforming sides, with what lies beside each side inside its polygon.
class PaperPolygons {
 public:
  /// @param sides conforming, those of a ring in a row, the owners ascending
  explicit PaperPolygons(std::vector<PaperSide> sides);
  ~PaperPolygons();

  const std::vector<PaperSide>& sides() const { return sides_; }
  /// The side before or after in the same ring.
  std::uint32_t before(std::uint32_t side) const { return before_[side]; }
  std::uint32_t after(std::uint32_t side) const { return after_[side]; }

  /// Corners of a tent that stands on the side, inside the polygon, from its start to its end: half as high as the polygon is there, so
  /// that it meets no other side. None: there is no room.
  std::vector<PaperPoint> tent(std::uint32_t side) const;
  bool has_few_sides(std::uint32_t owner) const;
  /// How far the polygon reaches from the line of the side; it has few.
  double height(std::uint32_t side) const;
  std::span<const PaperSide> sides_of(std::uint32_t owner) const {
    return std::span(sides_).subspan(first_side_[owner], first_side_[owner + 1] - first_side_[owner]);
  }
  /// How far from the start of the side there is room around it: at most half of the way to what else bounds the polygon.
  double room(std::uint32_t side) const;
  /// A point at that distance from an end of the side, along it.
  PaperPoint from_start(std::uint32_t side, double distance) const;
  PaperPoint from_end(std::uint32_t side, double distance) const;
  /// A point at that distance from the start of the side, between it and the side before; only needed where the corner is not sharp.
  PaperPoint inward(std::uint32_t side, double distance) const;
  /// The polygon's corner at the start of the side is so wide that a triangle there would leave it.
  bool is_wide(std::uint32_t side) const;

 private:
  struct Trees;
  /// Those of a polygon that may be near; all, if they are few.
  template <class F>
  void visit_sides(std::uint32_t owner, const ImageBox& near, const F& visit) const;
  std::vector<PaperPoint> squeezed(std::uint32_t side) const;
  std::vector<PaperPoint> below_others(std::uint32_t side) const;
  double angle_at_start(std::uint32_t side) const;  // between the side and the one before, inside the polygon

  std::vector<PaperSide> sides_;
  std::vector<std::uint32_t> before_, after_;
  std::vector<std::size_t> first_side_;  // by owner
  std::vector<double> turn_;             // by owner: 1 if it lies where x turns to y, -1 on the other side
  std::vector<std::uint8_t> is_plain_;   // by owner: convex, with few sides
  std::unique_ptr<Trees> trees_;
};

}  // namespace hsr::internal
