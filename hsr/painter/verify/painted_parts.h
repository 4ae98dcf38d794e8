#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "hsr/painter/verify/image_rows.h"
#include "hsr/painter/verify/painted_points.h"
#include "hsr/painter/verify/verify.h"
#include "hsr/painter/verify/what_is_left.h"
#include "hsr/scene/box_tree.h"

namespace hsr::internal {

/// A planar convex part of a painted polygon, of what the near plane and sections leave, with an area in the image; or of a wire, with a
/// length there.
struct PaintedPart {
  std::uint32_t polygon = 0;
  std::uint32_t first = 0, end = 0;    ///< of its corners, around it so that `turn` is nowhere negative
  std::array<std::uint32_t, 3> plane;  ///< three of its corners, of positive turn; of a wire, none

  bool is_wire() const { return end - first == 2; }
};

/// Painted polygons as convex parts: a polygon that is planar and convex is one, any other is cut into triangles by the rule
/// for faces (docs/conventions.md, "Faces as used").
class PaintedParts {
 public:
  /// @throws InputError for a polygon that has to be cut into triangles and has corners that are no doubles
  PaintedParts(const std::vector<PaintedPolygon>& polygons, const View& view);

  std::span<const PaintedPart> parts() const { return parts_.values(); }
  std::span<const std::uint32_t> corners_of(const PaintedPart& part) const {
    return {corners_.data() + part.first, corners_.data() + part.end};
  }
  /// The numbers of the parts of a polygon: from the first to before the second.
  std::array<std::uint32_t, 2> parts_of(std::uint32_t polygon) const {
    return {parts_.begin(polygon), parts_.begin(polygon + 1)};
  }
  const PaintedPoints& points() const { return points_; }
  const ImageRows& rows() const { return rows_; }
  std::vector<ImageBox> boxes() const;

  std::uint64_t triangulated() const { return triangulated_; }
  std::uint64_t polygons_with_area() const { return polygons_with_area_; }
  std::uint64_t wires() const { return wires_; }

 private:
  bool is_whole(PaintedSides& sides, std::span<const std::uint32_t> ring) const;
  bool is_nothing(PaintedSides& sides, std::span<const std::uint32_t> ring) const;
  std::vector<RationalVector> exact(std::span<const std::uint32_t> corners) const;
  void add(PaintedSides& sides, std::uint32_t polygon);
  void add_wire(std::uint32_t polygon);
  void add_triangles(PaintedSides& sides, std::uint32_t polygon);
  void add_cut(PaintedSides& sides, std::uint32_t polygon, std::vector<std::uint32_t> ring);
  void add_convex(PaintedSides& sides, std::uint32_t polygon, std::vector<std::uint32_t> ring);

  PaintedPoints points_;
  ImageRows rows_;
  WhatIsLeft left_;
  Ragged<PaintedPart> parts_;  // by polygon
  std::vector<std::uint32_t> corners_;
  std::uint64_t triangulated_ = 0, polygons_with_area_ = 0, wires_ = 0;
};

/// Who is nearer in the common part of two images.
struct Nearer {
  bool first = false, second = false;  ///< somewhere; neither: they lie in one plane
};

/// Nothing: the interiors of the images have no point in common. Decided by orientations of corners only: a corner of the
/// common part is a corner of one of them, or two sides that cross, and there the orientation of their four ends tells which is
/// nearer. Exact: yes.
/// @pre neither is a wire
std::optional<Nearer> nearer(const PaintedParts& all, PaintedSides& sides, const PaintedPart& a, const PaintedPart& b);

/// On which side of a part's plane a point lies: positive, on that of the eye.
Sign before_plane(PaintedSides& sides, const PaintedPart& part, std::uint32_t p);

}  // namespace hsr::internal
