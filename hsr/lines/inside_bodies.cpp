#include "hsr/lines/inside_bodies.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/predicates.h"
#include "geometry/vector3.h"
#include "geometry/view_plane.h"
#include "hsr/scene/near_contact.h"
#include "hsr/scene/space_tree.h"

namespace hsr::internal {

namespace {

auto& coordinate(auto& p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

/// Where the line from p to q passes a triangle: positive, through its inside; zero, through its border. @pre it crosses its plane
Sign place_in_triangle(Predicates& exact, const Point3& p, const Point3& q, const Point3& a, const Point3& b, const Point3& c) {
  const Sign ab = exact.side(Plane::of_face(p, q, a), b), bc = exact.side(Plane::of_face(p, q, b), c),
             ca = exact.side(Plane::of_face(p, q, c), a);
  const auto is_one_of_them = [&](Sign s) { return ab == s || bc == s || ca == s; };
  if (is_one_of_them(Sign::positive) && is_one_of_them(Sign::negative)) return Sign::negative;
  return is_one_of_them(Sign::zero) ? Sign::zero : Sign::positive;
}

/// Whether the segment from p to q, which is outside of all, crosses a triangle; nothing: it touches the border, or runs in the plane.
/// @param lies_in_plane whether p does, be it rounded out of it or not
std::optional<bool> crosses(Predicates& exact, const Point3& p, const Point3& q, bool lies_in_plane, const Point3& a,
                            const Point3& b, const Point3& c) {
  const Plane plane = Plane::of_face(a, b, c);
  const Sign at_p = lies_in_plane ? Sign::zero : exact.side(plane, p), at_q = exact.side(plane, q);
  if (at_p == Sign::zero) return at_q == Sign::zero ? std::nullopt : std::optional(false);
  if (at_p * at_q != Sign::negative) return false;
  const Sign place = place_in_triangle(exact, p, q, a, b, c);
  return place == Sign::zero ? std::nullopt : std::optional(place == Sign::positive);
}

/// Tells in doubles which triangles a straight way passes by: their boxes are certainly beside it. A box around a slanting way holds
/// many.
class Way {
 public:
  Way(const Point3& from, const Point3& to, int axis) : from_(from), axis_(axis) {
    const double length = coordinate(to, axis) - coordinate(from, axis);
    for (int k = 0; k < 2; ++k) {
      const int other = (axis + 1 + k) % 3;
      slope_[static_cast<std::size_t>(k)] = (coordinate(to, other) - coordinate(from, other)) / length;
    }
    // Far more than what is rounded below.
    margin_ = 0x1p-40 * (norm_max(from) + norm_max(to));
  }
  bool passes_by(const Point3& a, const Point3& b, const Point3& c) const {
    const auto range = [&](int axis) { return std::minmax({coordinate(a, axis), coordinate(b, axis), coordinate(c, axis)}); };
    const auto [near, far] = range(axis_);
    for (int k = 0; k < 2; ++k) {
      const int other = (axis_ + 1 + k) % 3;
      const double slope = slope_[static_cast<std::size_t>(k)];
      const double p = coordinate(from_, other) + slope * (near - coordinate(from_, axis_)),
                   q = coordinate(from_, other) + slope * (far - coordinate(from_, axis_));
      const auto [low, high] = range(other);
      if (low > std::max(p, q) + margin_ || high < std::min(p, q) - margin_) return true;
    }
    return false;
  }

 private:
  const Point3& from_;
  int axis_;
  std::array<double, 2> slope_;
  double margin_;
};

}  // namespace

InsideBodies::InsideBodies(const ViewParts& parts, double tolerance) : parts_(parts), tolerance_(tolerance) {
  const auto& points = parts.mesh().points;
  low_ = high_ = points.empty() ? Point3{} : points.front();
  for (const Point3& p : points) {
    bits_.add(p);
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y), std::min(low_.z, p.z)};
    high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y), std::max(high_.z, p.z)};
  }
}

bool InsideBodies::contain_middle(Place& place, std::size_t copies) const {
  const View& view = parts_.view();
  const auto& at_eye = at_eye_.get([&] {
    const Point3& eye = view.viewpoint.at;
    Place of_eye{eye, eye, eye, eye, {}};
    std::array<std::optional<std::size_t>, directions> all;
    for (std::size_t direction = 0; direction < directions; ++direction)
      all[direction] = view.is_perspective() ? crossed(of_eye, direction) : std::optional<std::size_t>(0);
    return all;
  });
  for (std::size_t direction = 0; direction < directions; ++direction) {
    if (!at_eye[direction]) return false;
    const auto here = crossed(place, direction);
    if (!here) return false;
    const std::size_t faces = *here + *at_eye[direction];
    if (faces % copies != 0 || faces / copies % 2 == 0) return false;
  }
  return true;
}

std::vector<TriangleId> InsideBodies::passed_through(const Edge& edge) const {
  const Mesh& mesh = parts_.mesh();
  const Point3 &from = mesh.points[edge.a], &to = mesh.points[edge.b];
  Predicates exact(bits_);
  const Way way(from, to, largest_axis(minus(to, from)));
  std::vector<TriangleId> all;
  parts_.space_tree().visit_near(from, to, 0, [&](TriangleId t) {
    const auto& c = mesh.triangles[t];
    const Point3 &p = mesh.points[c[0]], &q = mesh.points[c[1]], &r = mesh.points[c[2]];
    if (way.passes_by(p, q, r)) return;
    const Plane plane = Plane::of_face(p, q, r);
    if (exact.side(plane, from) * exact.side(plane, to) != Sign::negative) return;
    if (place_in_triangle(exact, from, to, p, q, r) != Sign::negative) all.push_back(t);
  });
  return all;
}

/// Nothing: each of some ways touches a border.
std::optional<std::size_t> InsideBodies::crossed(Place& place, std::size_t direction) const {
  for (std::size_t k = 0; k < slants.size(); ++k)
    if (const auto found = crossed(place, way(direction, k))) return found;
  return std::nullopt;
}

/// Of all directions the first slant is nearly always enough.
const WayOut& InsideBodies::way(std::size_t direction, std::size_t slant) const {
  return ways_[direction * slants.size() + slant].get(
      [&] { return WayOut(parts_.mesh(), static_cast<int>(direction / 2), direction % 2 != 0, slants[slant]); });
}

/// Whether a triangle is in one plane with the edge. Exact: yes.
bool InsideBodies::is_in_plane(Place& place, TriangleId t) const {
  for (const auto& [known, is_in] : place.in_plane)
    if (known == t) return is_in;
  const auto& c = parts_.mesh().triangles[t];
  const auto& points = parts_.mesh().points;
  const Plane plane = Plane::of_face(points[c[0]], points[c[1]], points[c[2]]);
  BitRange bits = bits_;
  bits.add(place.a);
  bits.add(place.b);
  Predicates exact(bits);
  const bool is_in = exact.side(plane, place.a) == Sign::zero && exact.side(plane, place.b) == Sign::zero;
  place.in_plane.emplace_back(t, is_in);
  return is_in;
}

std::optional<std::size_t> InsideBodies::crossed(Place& place, const WayOut& way) const {
  const Mesh& mesh = parts_.mesh();
  const Point3 start = sum(place.from, 0.5, minus(place.to, place.from));
  const Point3 outside = way.outside(start, low_, high_);
  if (!std::isfinite(norm_max(outside))) return std::nullopt;
  BitRange bits = bits_;
  bits.add(start);
  bits.add(outside);
  Predicates exact(bits);
  std::size_t count = 0;
  bool is_clear = true;
  way.visit(start, [&](TriangleId t, WayOut::Crossing known) {
    if (!is_clear) return;
    if (tolerance_ > 0) {
      const auto contact = near_contact(mesh, t, place.from, place.to, tolerance_);
      if (contact && contact->from <= 0.5 && 0.5 <= contact->to) return;
    }
    const auto& c = mesh.triangles[t];
    const auto found = known == WayOut::Crossing::yes ? std::optional(true)
                                                      : crosses(exact, start, outside, is_in_plane(place, t), mesh.points[c[0]],
                                                                mesh.points[c[1]], mesh.points[c[2]]);
    is_clear = found.has_value();
    if (found == true) ++count;
  });
  return is_clear ? std::optional(count) : std::nullopt;
}

}  // namespace hsr::internal
