#include "bench/peers/image.h"

#include <cmath>

namespace hsr::bench {

Image::Image(const View& view) : frame_(view.frame) {
  const Point3 &r = frame_.right, &u = frame_.up, &e = view.viewpoint.at, &o = frame_.origin;
  toward_ = {r.y * u.z - r.z * u.y, r.z * u.x - r.x * u.z, r.x * u.y - r.y * u.x};
  if (view.is_perspective()) nearer_ = 1 / std::hypot(e.x - o.x, e.y - o.y, e.z - o.z);
}

double Image::distance(const Point3& p) const {
  const Point3& o = frame_.origin;
  return 1 - ((p.x - o.x) * toward_.x + (p.y - o.y) * toward_.y + (p.z - o.z) * toward_.z) * nearer_;
}

double Image::parameter_in_space(const Point3& p, const Point3& q, double s) const {
  const double at_p = distance(p), at_q = distance(q);
  return s * at_p / (s * at_p + (1 - s) * at_q);
}

}  // namespace hsr::bench
