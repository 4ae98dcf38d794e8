#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/bit_range.h"
#include "geometry/mesh.h"
#include "geometry/plane_filter.h"
#include "geometry/predicates.h"
#include "hsr/scene/box_tree.h"
#include "hsr/scene/tie_rule.h"
#include "hsr/view/view.h"

namespace hsr::internal {

/// A point in the image that ProjectedMesh computes in: not the paper's, but constant along lines of sight like it.
using ImagePoint = Point2;

/// A mesh as one view sees it: what every method needs first.
///
/// Signs, here and wherever something is seen:
///   (1) left of a -> b, as seen, is positive: of a point that is seen there, O(a, b, p) > 0 (Plane::of_sight)
///   (2) a triangle whose corners are seen counter-clockwise is positive: it has its inside to the left of its sides, and the
///       viewpoint is on the positive side of its plane, from which the corners run counter-clockwise
///   (3) the image is as seen, up to a map that keeps every turn
///   (4) nearness grows toward the viewer, in parallel views and in perspectives
///   (5) beyond the near plane is positive
///
/// Points, eye and target are multiplied by one power of two, and the direction by another, so that the largest coordinate is
/// near 1: no predicate and no parameter along an edge changes by that, and scenes of any size pass the filters alike. Where
/// the scaling would round (numbers about 2^1000 apart), it is left out.
/// @pre mesh outlives it. Cost: O(n), parallel.
class ProjectedMesh {
 public:
  /// @param others bit range of what else predicates and filters will meet: the samples of an image
  /// @param ties which of coincident faces is seen
  ProjectedMesh(const Mesh& mesh, const View& view, Arithmetic arithmetic, const BitRange& others = {}, TieRule ties = {});

  const Mesh& mesh() const { return *mesh_; }
  const Viewpoint& eye() const { return eye_; }
  bool is_perspective() const { return !eye_.is_direction; }
  /// Whether there is a near plane, or a section in its place.
  bool has_near() const { return is_perspective() || section_.has_value(); }
  Arithmetic arithmetic() const { return arithmetic_; }
  TieRule ties() const { return ties_; }
  Camera camera() const { return {eye_, target_}; }
  /// The rows that image coordinates in perspective are taken along.
  const std::array<Point3, 2>& rows() const { return row_; }
  const Point3& point(VertexId v) const { return points_[v]; }
  /// Whether other numbers in this range need nothing more: neither another scale nor wider arithmetic.
  bool covers(const BitRange& others) const;
  /// Whether the points, and so all images and boxes, are the same numbers. @pre of one mesh and view
  bool is_scaled_like(const ProjectedMesh& other) const { return power_ == other.power_; }
  /// Another point as this sight scales all of them. @pre in the bit range of the others
  Point3 scaled(const Point3& p) const;

  /// Predicates for these points; one for each thread.
  Predicates predicates() const { return Predicates(points_bit_range_, direction_bit_range_, arithmetic_); }
  /// A plane prepared for many of these points.
  PlaneFilter filter(const Plane& plane) const { return {plane, filter_arithmetic_}; }

  Plane sight_plane(VertexId c, VertexId d) const { return Plane::of_sight(eye_, points_[c], points_[d]); }
  Plane face_plane(TriangleId t) const;
  Plane face_plane(FacetId facet) const { return face_plane(first_triangle(facet)); }
  Plane near_plane() const {
    return section_ ? Plane::section(eye_, section_->point, section_->normal) : Plane::near(eye_.at, target_, near_);
  }
  Plane near_line(const Plane& line) const { return near_plane().line_with(line); }
  /// As View has them.
  Plane cutting_plane(std::uint8_t k) const {
    if (k == 0) return near_plane();
    const SectionPlane& plane = k == View::far_number ? *far_ : planes_[k - 1U];
    return Plane::section(eye_, plane.point, plane.normal);
  }
  Plane fold_plane(std::uint8_t u, std::uint8_t v) const {
    return u == v ? cutting_plane(u) : cutting_plane(u).line_with(cutting_plane(v));
  }

  /// The image of a vertex beyond the near plane, rounded: within image_error() in each coordinate. The exact images turn as
  /// they are seen: O(c, d, p) > 0 iff c, d, p is a left turn.
  const ImagePoint& image(VertexId v) const { return image_[v]; }
  /// Zero: every image is exact. Infinite: images decide nothing.
  double image_error() const { return image_error_; }
  /// The image of another point, which is within `error` of p in the sum of its coordinates; p is already scaled. An infinite
  /// error where doubles do not tell.
  BoundedPoint2 image(const Point3& p, double error) const;

  /// The sign of O(t0, t1, t2): positive, the corners are seen counter-clockwise; zero, the triangle is seen edge-on. It is the
  /// side of the triangle's plane on which the viewpoint lies.
  Sign facing(TriangleId t) const { return facing_[t]; }
  Sign facing(FacetId facet) const { return facing(first_triangle(facet)); }
  /// On which side of the view plane of one of its edges a triangle lies: positive, to the left of a -> b.
  Sign side_of_edge(TriangleId t, const Edge& e) const { return mesh_->runs_along(t, e) ? facing_[t] : -facing_[t]; }
  /// On which side of `plane` a vertex lies: the filter first. Exact.
  Sign side(const Plane& plane, VertexId p, Predicates& exact) const;
  /// On which side of the near plane: positive, beyond it. Parallel views without a section have no near plane: positive.
  Sign beyond_near(VertexId v) const { return has_near() ? near_side_[v] : Sign::positive; }

  /// Some of the triangle is cut away; some of it is left.
  bool reaches_before_near(TriangleId t) const;
  bool reaches_beyond_near(TriangleId t) const;

  /// Conservative boxes of what is beyond the near plane, in an image of its own (not the paper's); of nothing,
  /// ImageBox::nothing().
  const ImageBox& box(VertexId v) const { return vertex_boxes_[v]; }
  ImageBox box(VertexId a, VertexId b) const;
  ImageBox box(TriangleId t) const;
  /// Of a point that is within `error` of p, in the sum of its coordinates, wherever the near plane is; p is already scaled.
  ImageBox box(const Point3& p, double error = 0) const {
    ImageBox box = ImageBox::nothing();
    add_to(box, p, error);
    return box;
  }
  /// The nearness of such a point, as boxes have it. Parallel: how far it is toward the viewer, along one axis and from some
  /// point of the mesh; perspective: minus its distance from the eye in the direction of view, over the largest entry of that.
  ErrorBounded nearness(const Point3& p, double error) const;

 private:
  void find_near_sides(const std::vector<char>& is_used);
  void expect_only_removed(const Plane& near) const;
  void choose_rows(const View& view);
  void compute_images(const std::vector<char>& is_used);
  double compute_image(VertexId v);
  void add_to(ImageBox& box, const Point3& p, double error) const;
  void add_near_cut_to(ImageBox& box, VertexId a, VertexId b) const;

  const Mesh* mesh_;
  Arithmetic arithmetic_, filter_arithmetic_;
  TieRule ties_;
  IndexedVector<VertexId, Point3> points_;
  int power_ = 0;  // points are multiplied by 2^power_
  Viewpoint eye_;
  Point3 target_;
  double near_ = 0;
  std::optional<SectionPlane> section_, far_;
  std::vector<SectionPlane> planes_;
  BitRange given_bit_range_, points_bit_range_, direction_bit_range_;  // the first: before scaling
  IndexedVector<TriangleId, Sign> facing_;
  IndexedVector<VertexId, Sign> near_side_;
  PlaneFilter near_filter_;
  IndexedVector<VertexId, ImagePoint> image_;
  IndexedVector<VertexId, ImageBox> vertex_boxes_;  // of nothing: before the near plane, or not used
  double image_error_ = 0;
  double image_mirror_ = 1;  // 1 or -1: the x of the images is that of the rows times this
  // The image: rows of a fixed map; parallel, u = p[i] - ratio p[k]; perspective, u = row . (p - eye) / (depth . (p - eye)).
  std::array<Point3, 2> row_;
  Point3 depth_;
  std::array<bool, 2> is_whole_ratio_ = {false, false};  // the ratio is 0, 1 or -1, exactly
  // Parallel: the image of some point of the mesh, subtracted to keep the digits of a float.
  std::array<double, 3> middle_ = {0, 0, 0};
};

}  // namespace hsr::internal
