#pragma once

#include "geometry/point.h"
#include "hsr/view/view.h"

namespace hsr::bench {

/// A point as seen: where on the paper, and how near to the eye; larger is nearer. What is flat or straight in the scene is so
/// in (x, y, nearness), in a perspective view too.
struct ImagePoint {
  double x = 0, y = 0, nearness = 0;
};

/// Projects points, in doubles. @pre they are in front of the eye
class Image {
 public:
  explicit Image(const View& view);

  ImagePoint operator()(const Point3& p) const {
    const double dx = p.x - frame_.origin.x, dy = p.y - frame_.origin.y, dz = p.z - frame_.origin.z;
    const auto along = [&](const Point3& v) { return dx * v.x + dy * v.y + dz * v.z; };
    const double toward = along(toward_), scale = 1 / (1 - toward * nearer_);
    return {along(frame_.right) * scale, along(frame_.up) * scale, toward * scale};
  }

  /// The parameter in space of the point of the edge pq that is seen at s of the way from the image of p to that of q.
  double parameter_in_space(const Point3& p, const Point3& q, double s) const;

 private:
  double distance(const Point3& p) const;  // from the eye along the axis, the paper at 1; parallel: always 1

  Frame frame_;
  Point3 toward_;      // a unit vector toward the viewer
  double nearer_ = 0;  // 1 over the distance of the eye from the paper; 0: parallel
};

}  // namespace hsr::bench
