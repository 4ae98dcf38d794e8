#include "hsr/scene/near_contact.h"

#include <cmath>

#include "geometry/vector3.h"

namespace hsr::internal {

std::optional<NearContact> near_contact(const Mesh& mesh, TriangleId triangle, const Point3& a, const Point3& b,
                                        double tolerance) {
  NearContact contact;
  const auto& c = mesh.triangles[triangle];
  const Point3 p[3] = {mesh.points[c[0]], mesh.points[c[1]], mesh.points[c[2]]};
  const Point3 normal = unit(cross(unit(minus(p[1], p[0])), unit(minus(p[2], p[0]))));
  for (std::size_t k = 0; k < 3; ++k) {
    const Point3 inward = unit(cross(normal, minus(p[(k + 1) % 3], p[k])));
    const double at_a = dot(minus(a, p[k]), inward) + tolerance, at_b = dot(minus(b, p[k]), inward) + tolerance;
    if (at_a < 0 && at_b < 0) return std::nullopt;
    if (at_a >= 0 && at_b >= 0) continue;
    const double t = at_a / (at_a - at_b);
    if (at_a < 0 && t > contact.from) {
      contact.from = t;
      contact.side_from = k;
      contact.rise_from = at_b - at_a;
    }
    if (at_b < 0 && t < contact.to) {
      contact.to = t;
      contact.side_to = k;
      contact.rise_to = at_a - at_b;
    }
  }
  const Point3 along = minus(b, a);
  if (!((contact.to - contact.from) * std::sqrt(dot(along, along)) > 2 * tolerance)) return std::nullopt;
  const double off_a = dot(minus(a, p[0]), normal), off_b = dot(minus(b, p[0]), normal);
  const auto off = [&](double t) { return std::fabs(off_a + t * (off_b - off_a)); };
  if (!(off(contact.from) <= tolerance && off(contact.to) <= tolerance)) return std::nullopt;
  return contact;
}

}  // namespace hsr::internal
