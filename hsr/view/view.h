#pragma once

#include <array>
#include <optional>
#include <string>

#include "geometry/mesh.h"
#include "geometry/number.h"
#include "geometry/plane.h"
#include "geometry/point.h"

namespace hsr {

/// The plane of the paper: (x, y) is at origin + x right + y up. Computed once in doubles and exact from then on; it places
/// coordinates and never decides what hides what.
struct Frame {
  Point3 origin, right, up;
};

/// A picture around the middle of the view's frame, in units of the frame.
struct FrameSize {
  double half_width, half_height;
};

/// A plane, and what is on the viewer's side of it is cut away. Kept as given: never as coefficients that were computed.
struct SectionPlane {
  Point3 point;   ///< of the plane
  Point3 normal;  ///< square to the plane, any length, away from the viewer: it points to what is left
  friend bool operator==(const SectionPlane&, const SectionPlane&) = default;
};

/// From where the scene is looked at.
struct View {
  Viewpoint viewpoint;
  Point3 target;
  Point3 up;
  double near = 0;  ///< k: the near plane is (p - eye).(target - eye) = k |target - eye|^2. Parallel views have none: 0.
  Frame frame;
  /// It takes the place of the near plane, which then cuts nothing: see with_section().
  std::optional<SectionPlane> section = {};

  bool is_perspective() const { return !viewpoint.is_direction; }
  /// Whether something may be cut away: by the near plane of a perspective, or by a section.
  bool cuts() const { return is_perspective() || section.has_value(); }
  Plane near_plane() const {
    return section ? Plane::section(viewpoint, section->point, section->normal) : Plane::near(viewpoint.at, target, near);
  }
};

/// A parallel view; `direction` points from the scene toward the viewer.
/// @throws InputError if the direction is zero or not finite, or `up` is parallel to it
View parallel_view(const Point3& direction, const Point3& up, const Point3& target = {});

/// A perspective view. @param near_distance in model units; nothing: |target - eye| / 1000
/// @throws InputError if eye and target coincide or are not finite, `up` is parallel to the line of sight, or near <= 0
View perspective_view(const Point3& eye, const Point3& target, const Point3& up, std::optional<double> near_distance = {});

/// An oblique view: what is parallel to the paper of `base` keeps its image, and what recedes from the viewer at a right angle to
/// it is drawn at `degrees` from the horizontal, counter-clockwise, and `ratio` times as long. The frame is that of `base`.
///
/// The direction toward the viewer is base's, of length 1, plus ratio cos(degrees) right plus ratio sin(degrees) up; it is computed
/// in doubles, once, and exact from then on. Sines of multiples of 30 degrees that are doubles are these.
/// @throws InputError if `base` is a perspective, an argument is not finite, or the ratio is not above 0
View oblique_view(const View& base, double degrees, double ratio);

/// The view of what a section leaves: of all that is on the other side of the plane than the viewer.
/// @param normal either way
/// @throws InputError if a number is not finite, the normal is zero, or the plane is seen edge-on, as it then has no viewer's side
View with_section(const View& view, const Point3& point, const Point3& normal);

/// front, back, left, right, top, bottom, iso, for models with Z up; `y_up` turns the view (x, y, z -> x, z, -y), never the
/// model.
/// @throws InputError for another name
View named_view(const std::string& name, const Point3& target = {}, bool y_up = false);

/// The centre of the bounding box of all points that a face or a wire uses: the default target.
Point3 centre(const Mesh& mesh);

/// The images of points on the paper, in units of the frame. Exact: yes.
class PaperImage {
 public:
  explicit PaperImage(const View& view);
  /// @throws PreconditionError for a point of the eye's own plane parallel to the paper, as none beyond the near plane is
  std::array<Rational, 2> operator()(const std::array<Rational, 3>& p) const;

 private:
  bool is_parallel_;
  std::array<Rational, 3> base_;                 // an eye, or the frame's origin
  std::array<std::array<Rational, 3>, 2> rows_;  // x and y rise along these, from the base
  std::array<Rational, 2> at_base_;
  std::array<Rational, 3> depth_;  // perspective: along this, to 1 on the paper
};

/// The image of one point.
/// @throws PreconditionError as PaperImage does
std::array<Rational, 2> image(const View& view, const std::array<Rational, 3>& p);

}  // namespace hsr
