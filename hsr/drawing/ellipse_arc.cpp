#include "hsr/drawing/ellipse_arc.h"

#include <cmath>
#include <numbers>

namespace hsr {

Point2 EllipseArc::at(double t) const {
  const double c = std::cos(t), s = std::sin(t);
  return {centre.x + c * long_axis.x + s * short_axis.x, centre.y + c * long_axis.y + s * short_axis.y};
}

double EllipseArc::parameter_of(const Point2& p) const {
  const double x = p.x - centre.x, y = p.y - centre.y;
  const auto along = [&](const Point2& axis) { return (x * axis.x + y * axis.y) / (axis.x * axis.x + axis.y * axis.y); };
  return std::atan2(along(short_axis), along(long_axis));
}

double EllipseArc::long_radius() const { return std::hypot(long_axis.x, long_axis.y); }
double EllipseArc::short_radius() const { return std::hypot(short_axis.x, short_axis.y); }

bool EllipseArc::is_whole() const { return std::fabs(sweep()) > 2 * std::numbers::pi * (1 - 1e-12); }

}  // namespace hsr
