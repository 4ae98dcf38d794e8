#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

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
  Point3 normal;  ///< square to the plane, any length; away from the viewer, or where it is seen edge-on, to what is left
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
  /// Several planes, or one that is seen edge-on: see with_sections(). There is no `section` then.
  std::vector<SectionPlane> planes = {};
  /// What is beyond it is left out: see with_depth().
  std::optional<SectionPlane> far = {};

  static constexpr std::uint8_t far_number = 63;

  bool is_perspective() const { return !viewpoint.is_direction; }
  /// Whether something may be cut away: by the near plane of a perspective, or by a section.
  bool cuts() const { return is_perspective() || section.has_value(); }
  /// Whether something is cut away by other planes than a near plane: then there are cells, see section_cells().
  bool has_cells() const { return !planes.empty() || far.has_value(); }
  bool has_section() const { return section.has_value() || !planes.empty(); }
  Plane near_plane() const {
    return section ? Plane::section(viewpoint, section->point, section->normal) : Plane::near(viewpoint.at, target, near);
  }
  /// The plane that symbols call number k: 0 near_plane(), far_number `far`, else planes[k - 1].
  Plane cutting_plane(std::uint8_t k) const;
  /// The plane of the viewpoint and of the line in which planes u and v meet, or where these are one, the plane itself.
  Plane fold_plane(std::uint8_t u, std::uint8_t v) const;
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

/// On which side of a plane, as it is given, the viewpoint is. Zero: it is seen edge-on.
Sign viewer_side(const View& view, const SectionPlane& plane);

/// The view of what several planes leave: what is in front of all of them is taken away. A plane that is seen edge-on takes away
/// what its normal points away from; alone, all of that, and beside others what of it these take away, too: a half section.
/// @param planes the normals of those that are not seen edge-on may point either way
/// @throws InputError as with_section() does, and if there are none or more than 60
View with_sections(const View& view, const std::vector<SectionPlane>& planes);

/// The view of what a section leaves, without what is farther behind its plane, the first that is not seen edge-on, than `depth`. The far
/// plane is parallel to it, through a point that is computed in doubles once.
/// @throws InputError if the view has no such section, or depth is not above 0 and finite
View with_depth(const View& view, double depth);

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
