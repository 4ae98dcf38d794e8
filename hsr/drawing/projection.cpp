#include "hsr/drawing/projection.h"

#include <optional>
#include <string>

#include "geometry/constructed_point.h"
#include "geometry/error.h"
#include "geometry/rational_vector.h"
#include "hsr/drawing/cut_parameter.h"
#include "hsr/symbols/constructions.h"

namespace hsr::internal {

namespace {

/// 1000 x / w rounded, halves away from zero; nothing where the enclosure leaves two answers.
std::optional<std::int64_t> thousandths(const Enclosure& x) {
  const Enclosure v = x * Enclosure(1000.0);
  if (const auto nearest = v.nearest_integer()) return nearest;
  const auto nearest = [](Enclosure::Wide y) { return std::round(y); };  // halves away from zero
  const auto low = nearest(v.low()), high = nearest(v.high());
  if (!(low == high) || !(std::fabs(low) < 0x1p62L)) return {};
  return static_cast<std::int64_t>(low);
}

std::int64_t thousandths(const Rational& x) {
  const std::string whole = (x * Rational(1000.0)).to_decimal(0);
  if (whole.size() > 18)
    throw InputError("drawing: a point lies more than 1e15 mm from the page; expected a scale that brings it to paper size");
  return std::stoll(whole);
}

}  // namespace

// With f the frame: p is seen at (x, y) where p + s D = o + x right + y up (D the direction), or e + s (p - e) = o + x right +
// y up. By Cramer's rule, parallel:  x = (p - o).(up x D) / d,  y = (p - o).(D x right) / d,  d = det(right, up, D);
// perspective, g = o - e:      x = (p - e).(up x g) / w,  y = (p - e).(g x right) / w,  w = (p - e).(right x up).
Projection::Projection(const Mesh& mesh, const View& view, const Point3& anchor) : mesh_(mesh), view_(view), anchor_(anchor) {
  const RationalVector right = rational(view.frame.right), up = rational(view.frame.up), e = rational(view.viewpoint.at);
  const bool parallel = view.viewpoint.is_direction;
  const RationalVector g = parallel ? e : minus(rational(view.frame.origin), e);
  const RationalVector n = cross(right, up);
  const RationalVector from_eye = parallel ? RationalVector{} : minus(rational(anchor), e);
  const Rational unit = parallel ? dot(n, g) : dot(n, from_eye);
  require(unit.sign() != Sign::zero, "Projection: the anchor is not in front of the eye");
  const RationalVector x = cross(up, g), y = cross(g, right);
  const Rational anchor_x = dot(x, from_eye) / unit, anchor_y = dot(y, from_eye) / unit;
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational w = parallel ? Rational() : n[k] / unit;
    rows_[0][k] = x[k] / unit - anchor_x * w;
    rows_[1][k] = y[k] / unit - anchor_y * w;
    rows_[2][k] = w;
  }
  rows_[2][3] = 1.0;
  enclose_rows();
}

std::array<Rational, 2> Projection::relative(const Point3& point) const {
  const auto h = homogeneous(rational(point));
  return {h[0] / h[2], h[1] / h[2]};
}

void Projection::place(const std::array<Rational, 2>& centre, const Rational& scale, double x, double y) {
  const Rational signed_scale[2] = {scale, -scale}, at[2] = {x, y};
  for (std::size_t axis = 0; axis < 2; ++axis)
    for (std::size_t k = 0; k < 4; ++k)
      rows_[axis][k] = at[axis] * rows_[2][k] + signed_scale[axis] * (rows_[axis][k] - centre[axis] * rows_[2][k]);
  enclose_rows();
}

void Projection::enclose_rows() {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 4; ++k) enclosed_[i][k] = enclose(rows_[i][k]);
}

std::array<std::array<double, 4>, 3> Projection::rounded_rows() const {
  std::array<std::array<double, 4>, 3> rounded;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 4; ++k) rounded[i][k] = rows_[i][k].to_double();
  return rounded;
}

// The middle is that of the products and sums one by one. Each term of it is rounded at most four times, so that all roundings are
// below 5 eps of the sum of the terms' sizes; the rest is what the factors are off by.
HomogeneousPoint Projection::at(const std::array<Enclosure, 3>& p) const {
  const auto row = [&](std::size_t i) {
    const auto& r = enclosed_[i];
    const Enclosure::Wide middle =
        r[0].middle * p[0].middle + r[1].middle * p[1].middle + r[2].middle * p[2].middle + r[3].middle;
    Enclosure::Wide size = std::fabs(r[3].middle), off = r[3].error;
    for (std::size_t k = 0; k < 3; ++k) {
      const Enclosure::Wide factor = std::fabs(r[k].middle), place = std::fabs(p[k].middle);
      size += factor * place;
      off += factor * p[k].error + r[k].error * (place + p[k].error);
    }
    return Enclosure(middle, (off + 8 * Enclosure::eps * size + 16 * Enclosure::least) * Enclosure::grow);
  };
  return {row(0), row(1), view_.viewpoint.is_direction ? Enclosure(1.0) : row(2)};
}

HomogeneousPoint Projection::at(VertexId v) const {
  const Point3& p = mesh_.points[v];
  return at(
      {Enclosure::difference(p.x, anchor_.x), Enclosure::difference(p.y, anchor_.y), Enclosure::difference(p.z, anchor_.z)});
}

HomogeneousPoint Projection::at(const Plane& s, const Plane& t, const Plane& u) const {
  return at(enclosed_meet(s, t, u, anchor_));
}

HomogeneousPoint Projection::at(const SupportingLine& support, const Cut& cut) const {
  if (cut.kind == Cut::Kind::start) return at(support.a);
  if (cut.kind == Cut::Kind::end) return at(support.b);
  if (!support.is_edge()) return at(enclosed_point(mesh_, view_, support, cut, anchor_));
  const HomogeneousPoint a = at(support.a), b = at(support.b);
  const Enclosure t = enclosed_parameter(mesh_, view_, support, cut);
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.w + t * (b.w - a.w)};
}

HomogeneousPoint Projection::bounded_at(const SupportingLine& edge, const Cut& cut, const HomogeneousPoint& a,
                                        const HomogeneousPoint& b) const {
  const ErrorBounded bounded =
      bounded_parameter_of_cut(plane_of(mesh_, view_, cut), mesh_.points[edge.a], mesh_.points[edge.b]);
  // Where the picture's frame cuts a line its middle is used without asking for the error.
  if (!(bounded.error < 0x1p-40)) return at(edge, cut);
  const Enclosure t(bounded.value, bounded.error);
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.w + t * (b.w - a.w)};
}

std::array<Rational, 3> Projection::homogeneous(const std::array<Rational, 3>& p) const {
  const RationalVector d = minus(p, rational(anchor_));
  RationalVector h;
  for (std::size_t i = 0; i < 3; ++i) h[i] = rows_[i][0] * d[0] + rows_[i][1] * d[1] + rows_[i][2] * d[2] + rows_[i][3];
  return h;
}

std::array<Rational, 3> Projection::exact(VertexId v) const { return homogeneous(rational(mesh_.points[v])); }

std::array<Rational, 2> Projection::exact(const SupportingLine& support, const Cut& cut) const {
  return exact(exact_point(mesh_, view_, support, cut));
}

PaperPoint Projection::rounded(const SupportingLine& support, const Cut& cut, const HomogeneousPoint& at) const {
  if (const auto known = rounded(at)) return *known;
  if (const auto known = rounded(this->at(support, cut))) return *known;
  return rounded(exact(support, cut));
}

std::optional<PaperPoint> Projection::rounded(const HomogeneousPoint& at) {
  const auto x = thousandths(at.x / at.w), y = thousandths(at.y / at.w);
  if (!x || !y) return {};
  return PaperPoint{*x, *y};
}

PaperPoint Projection::rounded(const std::array<Rational, 2>& p) { return {thousandths(p[0]), thousandths(p[1])}; }

PaperPoint Projection::rounded(const std::array<Rational, 3>& point) const {
  std::array<Enclosure, 3> from_anchor;
  for (std::size_t k = 0; k < 3; ++k) {
    const double nearest = point[k].to_double();
    from_anchor[k] = Enclosure(nearest, 0x1p-53 * std::fabs(nearest) + 0x1p-1074) - Enclosure(anchor_[static_cast<int>(k)]);
  }
  if (const auto known = rounded(at(from_anchor))) return *known;
  return rounded(exact(point));
}

std::array<Rational, 2> Projection::exact(const std::array<Rational, 3>& p) const {
  const auto h = homogeneous(p);
  return {h[0] / h[2], h[1] / h[2]};
}

}  // namespace hsr::internal
