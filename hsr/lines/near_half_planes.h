#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "hsr/lines/half_planes.h"
#include "hsr/view/view.h"

namespace hsr::internal {

/// The half-planes of the faces that lie within a tolerance of a part of a line, as angles about it in doubles. A face that
/// reaches less than the tolerance away from the line has none on that side; two that are nowhere farther apart than the
/// tolerance, as far as the shorter reaches, coincide; so does one with the view plane.
///
/// A tolerance says what is noise in the input. It decides classes of lines, never what hides what.
class NearHalfPlanes : public HalfPlanes {
 public:
  /// @param a, b the ends of the line, not one point of the image @param middle a point of the part
  NearHalfPlanes(const Mesh& mesh, const View& view, const Point3& a, const Point3& b, const Point3& middle, double tolerance,
                 TieRule ties);

  /// A triangle that contains the part, but for the tolerance.
  void add(TriangleId triangle);
  /// The marks of the sides of such a triangle that run along the part, but for the tolerance.
  void add_marks(TriangleId triangle, const EdgeMarkTable& marks);

  Sign side(const HalfPlane& plane, const HalfPlane& other) const override;
  bool is_nearer(const HalfPlane& x, const HalfPlane& y) const override;
  double deviation_from_flat(const HalfPlane& x, const HalfPlane& y) const override;

 private:
  struct Angle {
    double turn;   // from the eye to the left, radians
    double reach;  // how far from the line it goes
    std::vector<FaceId> faces;

    bool has(FaceId face) const { return std::find(faces.begin(), faces.end(), face) != faces.end(); }
  };
  void add(TriangleId triangle, const Point3& into, double reach);
  const Angle& angle(const HalfPlane& h) const { return angles_[static_cast<std::size_t>(&h - all_.data())]; }
  /// The angle between two that are taken as one, for the shorter reach.
  double slack(double reach) const;

  const Mesh& mesh_;
  double tolerance_;
  Point3 middle_, along_, to_eye_, left_;
  std::vector<Angle> angles_;  // like all_
};

}  // namespace hsr::internal
