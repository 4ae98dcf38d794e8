#include "hsr/view/frustum.h"

#include <algorithm>
#include <cmath>

#include "geometry/error_bounded.h"
#include "geometry/vector3.h"

namespace hsr::internal {

namespace {

constexpr double wider = 1.0 + 1.0 / 64;

}  // namespace

/// With f = (origin - eye) / d of length 1 and p - eye = m (d f + x right + y up): x > w iff (p - eye) . (right - (w / d) f) >
/// 0, for m > 0.
ViewFrustum::ViewFrustum(const Mesh& mesh, const View& view, const FrameSize& size) : mesh_(mesh), eye_(view.viewpoint.at) {
  const Frame& frame = view.frame;
  const Point3 f = sum(frame.origin, -1, eye_);
  const double d = std::hypot(f.x, f.y, f.z);
  // Far within these bounds a 64th is more than what rounding moves anything by; planes without a normal leave nothing out.
  if (!(d > 1e-280 && d < 1e280)) return;
  const Point3 ahead = over(f, d);
  const double x = size.half_width * wider / d, y = size.half_height * wider / d;
  if (!(std::min(x, y) > 1e-10 && std::max(x, y) < 1e10)) return;
  normals_ = {sum(frame.right, -x, ahead), sum({-frame.right.x, -frame.right.y, -frame.right.z}, -x, ahead),
              sum(frame.up, -y, ahead), sum({-frame.up.x, -frame.up.y, -frame.up.z}, -y, ahead)};
}

bool ViewFrustum::contains(const Edge& e) const {
  const auto is_beyond = [&](const Point3& n, const Point3& p) {
    const auto term = [](double c, double a, double b) { return ErrorBounded{c} * (ErrorBounded{a} - ErrorBounded{b}); };
    const ErrorBounded side = term(n.x, p.x, eye_.x) + term(n.y, p.y, eye_.y) + term(n.z, p.z, eye_.z);
    return side.value > side.error;
  };
  const Point3 &a = mesh_.points[e.a], &b = mesh_.points[e.b];
  return std::any_of(normals_.begin(), normals_.end(), [&](const Point3& n) { return is_beyond(n, a) && is_beyond(n, b); });
}

}  // namespace hsr::internal
