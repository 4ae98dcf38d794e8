#pragma once

#include <array>
#include <optional>

#include "geometry/enclosure.h"
#include "hsr/drawing/page.h"
#include "hsr/lines/visible_lines.h"

namespace hsr::internal {

/// A point of the image as x / w, y / w; w > 0 in front of the eye.
struct HomogeneousPoint {
  Enclosure x, y, w;
};

/// From model to paper: the image in the view's frame, then x = left + scale (x - centre), y = top - scale (y - centre).
/// Everything is exact; enclosures answer first.
class Projection {
 public:
  /// To the frame, relative to the image of `anchor`: what lies near it loses nothing to a far origin.
  /// @pre anchor is in front of the eye
  Projection(const Mesh& mesh, const View& view, const Point3& anchor);

  /// The image of `point` of the frame's plane relative to the anchor.
  std::array<Rational, 2> relative(const Point3& point) const;

  /// Puts `centre` (relative to the anchor) at (x, y) mm of the page, `scale` mm to a unit of the frame, y down.
  void place(const std::array<Rational, 2>& centre, const Rational& scale, double x, double y);

  HomogeneousPoint at(VertexId v) const;
  HomogeneousPoint at(const SupportingLine& support, const Cut& cut) const;

  /// The same of a cut between the ends of an edge, which are seen at a and b: by doubles, with a wider bound, in a fraction of the time.
  HomogeneousPoint bounded_at(const SupportingLine& edge, const Cut& cut, const HomogeneousPoint& a,
                              const HomogeneousPoint& b) const;

  /// Where three planes meet. @pre s is a span
  HomogeneousPoint at(const Plane& s, const Plane& t, const Plane& u) const;

  /// x / w and y / w of a cut, exactly.
  std::array<Rational, 2> exact(const SupportingLine& support, const Cut& cut) const;
  std::array<Rational, 3> exact(VertexId v) const;  ///< x, y, w

  /// The cut in thousandths of a unit, correctly rounded, halves away from zero. `at` is an enclosure of it; where that leaves two
  /// answers, a narrower one is made, then the exact place.
  PaperPoint rounded(const SupportingLine& support, const Cut& cut, const HomogeneousPoint& at) const;

  /// Any point in thousandths of a unit, correctly rounded; nothing where its enclosure leaves two answers.
  static std::optional<PaperPoint> rounded(const HomogeneousPoint& at);
  static PaperPoint rounded(const std::array<Rational, 2>& exact);
  PaperPoint rounded(const std::array<Rational, 3>& point) const;
  /// The image of a point in space.
  std::array<Rational, 2> exact(const std::array<Rational, 3>& p) const;

  /// Of what is drawn, never of what hides what: x, y and w of a point relative to the anchor are these rows times (point, 1), in
  /// the nearest doubles.
  std::array<std::array<double, 4>, 3> rounded_rows() const;
  const Point3& anchor() const { return anchor_; }

  const Mesh& mesh() const { return mesh_; }
  const View& view() const { return view_; }

 private:
  HomogeneousPoint at(const std::array<Enclosure, 3>& p) const;  // relative to the anchor
  using Row = std::array<Rational, 4>;                           // x, y, z of the point relative to the anchor, 1
  void enclose_rows();
  std::array<Rational, 3> homogeneous(const std::array<Rational, 3>& p) const;

  const Mesh& mesh_;
  const View& view_;
  Point3 anchor_;
  std::array<Row, 3> rows_;
  std::array<std::array<Enclosure, 4>, 3> enclosed_;
};

}  // namespace hsr::internal
