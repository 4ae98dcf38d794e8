#include "hsr/lines/near_half_planes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/vector3.h"

namespace hsr::internal {

namespace {

/// The same turn between -pi and pi.
double turned(double angle) { return std::remainder(angle, 2 * std::numbers::pi); }

}  // namespace

NearHalfPlanes::NearHalfPlanes(const Mesh& mesh, const View& view, const Point3& a, const Point3& b, const Point3& middle,
                               double tolerance, TieRule ties)
    : HalfPlanes(ties), mesh_(mesh), tolerance_(tolerance), middle_(middle), along_(unit(minus(b, a))) {
  const Point3& eye = view.viewpoint.at;
  const Point3 sight = unit(view.viewpoint.is_direction ? eye : minus(eye, middle));
  const double d = dot(sight, along_);
  to_eye_ = unit(sum(sight, -d, along_));
  left_ = cross(along_, to_eye_);
}

double NearHalfPlanes::slack(double reach) const {
  constexpr double most = 0.1, rounding = 1e-12;
  return std::clamp(2 * tolerance_ / reach, rounding, most);
}

void NearHalfPlanes::add(TriangleId triangle) {
  const auto& c = mesh_.triangles[triangle];
  const Point3 &p = mesh_.points[c[0]], &q = mesh_.points[c[1]], &r = mesh_.points[c[2]];
  const Point3 into = unit(cross(cross(unit(minus(q, p)), unit(minus(r, p))), along_));
  double low = 0, high = 0;
  for (const VertexId v : c) {
    const double s = dot(minus(mesh_.points[v], middle_), into);
    low = std::min(low, s);
    high = std::max(high, s);
  }
  if (high > tolerance_) add(triangle, into, high);
  if (-low > tolerance_) add(triangle, {-into.x, -into.y, -into.z}, -low);
}

void NearHalfPlanes::add(TriangleId triangle, const Point3& into, double reach) {
  const double turn = std::atan2(dot(into, left_), dot(into, to_eye_));
  const FaceId face = mesh_.face_of[triangle];
  for (std::size_t k = 0; k < all_.size(); ++k) {
    Angle& known = angles_[k];
    if (std::fabs(turned(turn - known.turn)) > slack(std::min(reach, known.reach))) continue;
    // Noise makes triangles of a face: near a diagonal two of them are one half-plane.
    if (!known.has(face)) {
      known.faces.push_back(face);
      share(all_[k], face);
    }
    // The one that reaches farther tells its direction better.
    if (reach > known.reach) {
      known.turn = turn;
      known.reach = reach;
    }
    return;
  }
  angles_.push_back({turn, reach, {face}});
  all_.push_back({triangle, {}, Sign::zero, false, face});
  const double across = std::sin(turn);
  if (std::fabs(across) > slack(reach)) all_.back().side = sign_of(across);
  all_.back().is_front = all_.back().side == Sign::zero && std::cos(turn) > 0;
}

void NearHalfPlanes::add_marks(TriangleId triangle, const EdgeMarkTable& marks) {
  const auto& c = mesh_.triangles[triangle];
  for (std::size_t k = 0; k < 3; ++k) {
    const Point3 &p = mesh_.points[c[k]], &q = mesh_.points[c[(k + 1) % 3]];
    const Point3 side = minus(q, p);
    const double length = std::sqrt(dot(side, side));
    const Point3 across = cross(unit(side), along_);
    if (std::sqrt(dot(across, across)) > slack(length)) continue;
    const double at = std::clamp(dot(minus(middle_, p), side) / (length * length), 0.0, 1.0);
    const Point3 away = minus(middle_, sum(p, at, side));
    if (std::sqrt(dot(away, away)) <= tolerance_) HalfPlanes::add_marks(marks.of(c[k], c[(k + 1) % 3]));
  }
}

Sign NearHalfPlanes::side(const HalfPlane& plane, const HalfPlane& other) const {
  const double s = std::sin(angle(other).turn - angle(plane).turn);
  return std::fabs(s) > slack(std::min(angle(plane).reach, angle(other).reach)) ? sign_of(s) : Sign::zero;
}

bool NearHalfPlanes::is_nearer(const HalfPlane& x, const HalfPlane& y) const {
  return std::fabs(angle(x).turn) < std::fabs(angle(y).turn);
}

double NearHalfPlanes::deviation_from_flat(const HalfPlane& x, const HalfPlane& y) const {
  const double between = std::fabs(turned(angle(x).turn - angle(y).turn));
  // Noise within the tolerance turns each by this much.
  const double noise = slack(angle(x).reach) + slack(angle(y).reach);
  return std::max(0.0, std::numbers::pi - between - noise) * 180 / std::numbers::pi;
}

}  // namespace hsr::internal
