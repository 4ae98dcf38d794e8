#include "hsr/view/view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/error.h"
#include "geometry/parallel_fold.h"
#include "geometry/rational_vector.h"

namespace hsr {

using namespace internal;

namespace {

bool is_zero(const RationalVector& a) { return a[0] == Rational() && a[1] == Rational() && a[2] == Rational(); }

/// The vector scaled to length 1 in doubles; exact first, so that no size overflows.
Point3 unit(const RationalVector& a) {
  Rational most;
  for (const Rational& x : a) most = std::max(most, x.sign() == Sign::negative ? -x : x);
  const double x = (a[0] / most).to_double(), y = (a[1] / most).to_double(), z = (a[2] / most).to_double();
  const double length = std::sqrt(x * x + y * y + z * z);
  return {x / length + 0.0, y / length + 0.0, z / length + 0.0};
}

bool is_finite(const Point3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

void expect_finite(const Point3& p, const char* what) {
  if (!is_finite(p))
    throw InputError(std::string(what) + ": found a coordinate that is not finite, expected three finite numbers");
}

/// Right, up and toward the viewer make a right-handed frame.
Frame frame_toward(const RationalVector& toward, const Point3& up, const Point3& origin) {
  const RationalVector right = cross(rational(up), toward);
  if (is_zero(right))
    throw InputError("up: found a direction along the line of sight (or zero), expected one that is not parallel to it");
  return {origin, unit(right), unit(cross(toward, right))};
}

/// The sine, and exactly that where it is 0, 1/2 or 1.
double sine(double degrees) {
  const double turn = std::fmod(std::fmod(degrees, 360) + 360, 360);
  const double first = turn < 180 ? turn : turn - 180;  // the half turn after it is the same, downward
  const double quarter = first <= 90 ? first : 180 - first;
  const double size = quarter == 0 ? 0 : quarter == 30 ? 0.5 : quarter == 90 ? 1 : std::sin(quarter * (std::numbers::pi / 180));
  return turn < 180 ? size : -size;
}

Point3 without_minus_zero(const Point3& p) { return {p.x + 0.0, p.y + 0.0, p.z + 0.0}; }

}  // namespace

View parallel_view(const Point3& direction, const Point3& up, const Point3& target) {
  expect_finite(direction, "direction");
  expect_finite(up, "up");
  expect_finite(target, "target");
  if (direction == Point3{}) throw InputError("direction: found 0,0,0, expected a direction from the scene toward the viewer");
  View view;
  view.viewpoint = {without_minus_zero(direction), true};
  view.target = without_minus_zero(target);
  view.up = without_minus_zero(up);
  view.frame = frame_toward(rational(direction), up, view.target);
  return view;
}

View perspective_view(const Point3& eye, const Point3& target, const Point3& up, std::optional<double> near_distance) {
  expect_finite(eye, "eye");
  expect_finite(target, "target");
  expect_finite(up, "up");
  if (eye == target) throw InputError("eye: found the target itself, expected another point");
  View view;
  view.viewpoint = {without_minus_zero(eye), false};
  view.target = without_minus_zero(target);
  view.up = without_minus_zero(up);
  view.frame = frame_toward(minus(rational(eye), rational(target)), up, view.target);
  view.near = 0.001;
  if (near_distance) {
    if (!std::isfinite(*near_distance) || *near_distance <= 0)
      throw InputError("near: found " + std::to_string(*near_distance) + ", expected a distance above 0");
    using Wide = long double;
    const Wide x = Wide(target.x) - eye.x, y = Wide(target.y) - eye.y, z = Wide(target.z) - eye.z;
    view.near = static_cast<double>(*near_distance / std::sqrt(x * x + y * y + z * z));
    if (!(view.near > 0) || !std::isfinite(view.near))
      throw InputError(
          "near: found a distance that is no number beside the distance of eye and target, expected one nearer to it");
  }
  return view;
}

View with_section(const View& view, const Point3& point, const Point3& normal) {
  expect_finite(point, "section");
  expect_finite(normal, "section");
  if (normal == Point3{}) throw InputError("section: found the normal 0,0,0, expected a direction square to the plane");
  const Sign side = viewer_side(view, {point, normal});
  if (side == Sign::zero)
    throw InputError(
        "section: found a plane that is seen edge-on, which has no viewer's side, expected one at an angle to the line of "
        "sight");
  View cut = view;
  const double away = side == Sign::positive ? -1 : 1;
  cut.planes.clear();
  cut.section = {without_minus_zero(point), {away * normal.x + 0.0, away * normal.y + 0.0, away * normal.z + 0.0}};
  return cut;
}

Sign viewer_side(const View& view, const SectionPlane& plane) {
  const RationalVector n = rational(plane.normal), e = rational(view.viewpoint.at);
  return dot(n, view.is_perspective() ? minus(e, rational(plane.point)) : e).sign();
}

namespace {

bool are_parallel(const SectionPlane& a, const SectionPlane& b) {
  const RationalVector c = cross(rational(a.normal), rational(b.normal));
  return std::all_of(c.begin(), c.end(), [](const Rational& x) { return x.sign() == Sign::zero; });
}

/// Whether what is in front of `a` is in front of `b`, too. @pre they are parallel, and seen from one side
bool takes_less(const SectionPlane& a, const SectionPlane& b) {
  return dot(rational(b.normal), minus(rational(a.point), rational(b.point))).sign() != Sign::positive;
}

}  // namespace

View with_sections(const View& view, const std::vector<SectionPlane>& planes) {
  if (planes.empty() || planes.size() > 60)
    throw InputError("section: found " + std::to_string(planes.size()) + " planes, expected 1 to 60");
  View cut = view;
  cut.section.reset();
  cut.planes.clear();
  std::size_t facing = 0;
  for (const SectionPlane& given : planes) {
    expect_finite(given.point, "section");
    expect_finite(given.normal, "section");
    if (given.normal == Point3{}) throw InputError("section: found the normal 0,0,0, expected a direction square to the plane");
    const Sign side = viewer_side(view, given);
    const double away = side == Sign::positive ? -1 : 1;
    const SectionPlane plane = {without_minus_zero(given.point),
                                {away * given.normal.x + 0.0, away * given.normal.y + 0.0, away * given.normal.z + 0.0}};
    // Of parallel ones the one that takes least away does alone.
    const auto same = std::find_if(cut.planes.begin(), cut.planes.end(), [&](const SectionPlane& other) {
      return (viewer_side(view, other) == Sign::zero) == (side == Sign::zero) && are_parallel(plane, other) &&
             dot(rational(plane.normal), rational(other.normal)).sign() == Sign::positive;
    });
    if (same == cut.planes.end()) {
      cut.planes.push_back(plane);
      facing += side == Sign::zero ? 0U : 1U;
    } else if (takes_less(plane, *same)) {
      *same = plane;
    }
  }
  if (facing == 1 && cut.planes.size() == 1) {
    cut.section = cut.planes.front();
    cut.planes.clear();
  }
  return cut;
}

View with_depth(const View& view, double depth) {
  if (!std::isfinite(depth) || !(depth > 0))
    throw InputError("depth: found " + std::to_string(depth) + ", expected a distance above 0 behind a section");
  std::optional<SectionPlane> first = view.section;
  for (const SectionPlane& plane : view.planes)
    if (!first && viewer_side(view, plane) != Sign::zero) first = plane;
  if (!first) throw InputError("depth: found no section that faces the viewer, expected one from which to measure");
  const Point3 along = unit(rational(first->normal)), &from = first->point;
  View cut = view;
  cut.far = {{from.x + depth * along.x, from.y + depth * along.y, from.z + depth * along.z}, first->normal};
  expect_finite(cut.far->point, "depth");
  return cut;
}

Plane View::cutting_plane(std::uint8_t k) const {
  if (k == 0) return near_plane();
  const SectionPlane& plane = k == far_number ? *far : planes[k - 1U];
  return Plane::section(viewpoint, plane.point, plane.normal);
}

Plane View::fold_plane(std::uint8_t u, std::uint8_t v) const {
  return u == v ? cutting_plane(u) : cutting_plane(u).line_with(cutting_plane(v));
}

View oblique_view(const View& base, double degrees, double ratio) {
  if (base.is_perspective()) throw InputError("oblique: found a perspective, expected a parallel view");
  if (!std::isfinite(degrees)) throw InputError("oblique: found an angle that is not finite, expected degrees");
  if (!std::isfinite(ratio) || !(ratio > 0))
    throw InputError("oblique: found the ratio " + std::to_string(ratio) + ", expected a finite one above 0");
  const Point3 toward = unit(rational(base.viewpoint.at)), &right = base.frame.right, &up = base.frame.up;
  const double across = ratio * sine(degrees + 90), upward = ratio * sine(degrees);
  View view = base;
  view.viewpoint.at =
      without_minus_zero({toward.x + across * right.x + upward * up.x, toward.y + across * right.y + upward * up.y,
                          toward.z + across * right.z + upward * up.z});
  if (!is_finite(view.viewpoint.at)) throw InputError("oblique: found a ratio beyond the doubles, expected a smaller one");
  return view;
}

View named_view(const std::string& name, const Point3& target, bool y_up) {
  struct Named {
    const char* name;
    Point3 direction, up;
  };
  static constexpr Named views[] = {
      {"front", {0, -1, 0}, {0, 0, 1}}, {"back", {0, 1, 0}, {0, 0, 1}}, {"left", {-1, 0, 0}, {0, 0, 1}},
      {"right", {1, 0, 0}, {0, 0, 1}},  {"top", {0, 0, 1}, {0, 1, 0}},  {"bottom", {0, 0, -1}, {0, -1, 0}},
      {"iso", {1, -1, 1}, {0, 0, 1}},
  };
  const auto turned = [&](const Point3& p) { return y_up ? Point3{p.x, p.z, -p.y} : p; };
  for (const Named& v : views)
    if (name == v.name) return parallel_view(turned(v.direction), turned(v.up), target);
  throw InputError("view: found \"" + name + "\", expected front, back, left, right, top, bottom or iso");
}

Point3 centre(const Mesh& mesh) {
  if (mesh.edges.empty()) return {};
  struct Box {
    Point3 low, high;
  };
  const auto add = [](Box& all, const Point3& low, const Point3& high) {
    all.low = {std::min(all.low.x, low.x), std::min(all.low.y, low.y), std::min(all.low.z, low.z)};
    all.high = {std::max(all.high.x, high.x), std::max(all.high.y, high.y), std::max(all.high.z, high.z)};
  };
  const Point3& first = mesh.points[mesh.edges[EdgeId(0)].a];
  const auto [low, high] = parallel_fold(
      mesh.edges.size(), Box{first, first},
      [&](Box& all, std::size_t i) {
        const Edge& e = mesh.edges[EdgeId(i)];
        for (const VertexId v : {e.a, e.b}) add(all, mesh.points[v], mesh.points[v]);
      },
      [&](Box& all, const Box& more) { add(all, more.low, more.high); });
  const auto middle = [](double a, double b) { return std::isfinite(a + b) ? (a + b) / 2 : a / 2 + b / 2; };
  return {middle(low.x, high.x), middle(low.y, high.y), middle(low.z, high.z)};
}

// The line of sight of p meets the paper at o + w, w = x u + y v: with n = u x v, x = w . (v x n) / n.n and y = w . (n x u) /
// n.n. Parallel, w = d + s D for d = p - o, s = -n.d / n.D; perspective, w = e - o + s (p - e), s = n.(o - e) / n.(p - e).
PaperImage::PaperImage(const View& view) : is_parallel_(view.viewpoint.is_direction) {
  const RationalVector o = rational(view.frame.origin), u = rational(view.frame.right), v = rational(view.frame.up);
  const RationalVector n = cross(u, v), e = rational(view.viewpoint.at);
  const Rational nn = dot(n, n), slope = dot(n, is_parallel_ ? e : minus(o, e));
  require(slope.sign() != Sign::zero, "image: the line of sight is parallel to the paper");
  base_ = is_parallel_ ? o : e;
  rows_ = {cross(v, n), cross(n, u)};
  for (std::size_t k = 0; k < 2; ++k) {
    const Rational along = is_parallel_ ? dot(rows_[k], e) / slope : Rational();
    for (std::size_t i = 0; i < 3; ++i) rows_[k][i] = (is_parallel_ ? rows_[k][i] - along * n[i] : rows_[k][i]) / nn;
    if (!is_parallel_) at_base_[k] = dot(rows_[k], minus(e, o));
  }
  for (std::size_t i = 0; i < 3; ++i) depth_[i] = n[i] / slope;
}

std::array<Rational, 2> PaperImage::operator()(const std::array<Rational, 3>& p) const {
  const RationalVector d = minus(p, base_);
  const Rational x = dot(rows_[0], d), y = dot(rows_[1], d);
  if (is_parallel_) return {x, y};
  const Rational w = dot(depth_, d);
  require(w.sign() != Sign::zero, "image: the line of sight is parallel to the paper");
  return {at_base_[0] + x / w, at_base_[1] + y / w};
}

std::array<Rational, 2> image(const View& view, const std::array<Rational, 3>& p) { return PaperImage(view)(p); }

}  // namespace hsr
