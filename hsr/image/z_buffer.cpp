#include "hsr/image/z_buffer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace hsr {

namespace {

Point3 minus(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double dot(const Point3& a, const Point3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Point3 cross(const Point3& a, const Point3& b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
/// s a + t b
Point3 sum(double s, const Point3& a, double t, const Point3& b) {
  return {s * a.x + t * b.x, s * a.y + t * b.y, s * a.z + t * b.z};
}

/// In units of samples: sample (i, j) is at (i, j).
template <class Real>
struct Seen {
  Real x = 0, y = 0, nearness = 0;
};

/// From space to samples, in doubles.
class Projection {
 public:
  Projection(const View& view, const SampleGrid& grid) : is_perspective_(view.is_perspective()) {
    const Point3 n = cross(grid.right, grid.down);
    const Point3& e = view.viewpoint.at;
    // x and y of the plane of the samples: across . right = 1, across . down = 0, and so on.
    across_ = sum(1 / dot(n, n), cross(grid.down, n), 0, n);
    down_ = sum(1 / dot(n, n), cross(n, grid.right), 0, n);
    if (is_perspective_) {
      from_ = e;
      const Point3 to_samples = minus(grid.origin, e);
      depth_ = sum(1 / dot(to_samples, n), n, 0, n);
      x_ = dot(across_, to_samples);
      y_ = dot(down_, to_samples);
    } else {
      from_ = grid.origin;
      depth_ = sum(1 / dot(e, n), n, 0, n);
      across_ = sum(1, across_, -dot(across_, e), depth_);
      down_ = sum(1, down_, -dot(down_, e), depth_);
    }
  }

  template <class Real>
  Seen<Real> operator()(const Point3& p) const {
    const Point3 q = minus(p, from_);
    const double depth = dot(depth_, q), scale = is_perspective_ ? 1 / depth : 1;
    return {static_cast<Real>(dot(across_, q) * scale - x_), static_cast<Real>(dot(down_, q) * scale - y_),
            static_cast<Real>(is_perspective_ ? (1 - depth) * scale : depth)};
  }

 private:
  bool is_perspective_;
  Point3 from_, across_, down_, depth_;
  double x_ = 0, y_ = 0;
};

/// The first sample at or after x, within 0 ... end.
template <class Real>
int first_sample(Real x, int end) {
  if (!(x > 0)) return 0;
  if (!(x < static_cast<Real>(end))) return end;
  const int whole = static_cast<int>(x);
  return whole + (static_cast<Real>(whole) < x ? 1 : 0);
}

template <class Real>
struct Triangle {
  TriangleId id;
  Seen<Real> corner;
  Real step_x, step_y;
};

template <class Real>
void draw_rows(DepthImage<Real>& image, const Triangle<Real>& t, const Seen<Real>& from, const Seen<Real>& to, Real slope_from,
               Real slope_to, int first, int last) {
  for (int j = first; j < last; ++j) {
    const Real y = static_cast<Real>(j);
    const int begin = first_sample(from.x + (y - from.y) * slope_from, image.width);
    const int end = first_sample(to.x + (y - to.y) * slope_to, image.width);
    DepthPixel<Real>* const row = image.row(j);
    Real nearness = t.corner.nearness + (static_cast<Real>(begin) - t.corner.x) * t.step_x + (y - t.corner.y) * t.step_y;
    for (int i = begin; i < end; ++i, nearness += t.step_x)
      if (nearness > row[i].nearness) row[i] = {nearness, t.id};
  }
}

template <class Real>
void draw_triangle(DepthImage<Real>& image, TriangleId id, Seen<Real> a, Seen<Real> b, Seen<Real> c) {
  // Most triangles of a large mesh lie between the samples: leave early.
  const auto [low, high] = std::minmax({a.x, b.x, c.x});
  if (first_sample(low, image.width) == first_sample(high, image.width)) return;
  if (b.y < a.y) std::swap(a, b);
  if (c.y < a.y) std::swap(a, c);
  if (c.y < b.y) std::swap(b, c);
  const int top = first_sample(a.y, image.height), bottom = first_sample(c.y, image.height);
  if (top == bottom) return;
  const Real bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
  const Real area = bx * cy - by * cx;
  if (area == 0) return;
  const Real bz = b.nearness - a.nearness, cz = c.nearness - a.nearness;
  const Triangle<Real> t = {id, a, (bz * cy - cz * by) / area, (cz * bx - bz * cx) / area};
  const int middle = first_sample(b.y, image.height);
  const Real long_side = cx / cy;
  // The long side ac is on the left where b is on the right of it.
  const bool b_on_right = area > 0;
  const auto draw = [&](const Seen<Real>& from, Real side, int first, int last) {
    if (b_on_right)
      draw_rows(image, t, a, from, long_side, side, first, last);
    else
      draw_rows(image, t, from, a, side, long_side, first, last);
  };
  if (top < middle) draw(a, bx / by, top, middle);
  if (middle < bottom) draw(b, (c.x - b.x) / (c.y - b.y), middle, bottom);
}

/// How far beyond the near plane, times a positive number.
double beyond_near(const View& view, const Point3& p) {
  const Point3 to_target = minus(view.target, view.viewpoint.at);
  return dot(minus(p, view.viewpoint.at), to_target) - view.near * dot(to_target, to_target);
}

}  // namespace

template <class Real>
DepthImage<Real> z_buffer(const Mesh& mesh, const View& view, const SampleGrid& samples) {
  DepthImage<Real> image(samples.width, samples.height);
  const Projection project(view, samples);
  std::vector<Seen<Real>> points(mesh.points.size());
  for (std::size_t v = 0; v < points.size(); ++v) points[v] = project.operator()<Real>(mesh.points[VertexId(v)]);
  std::vector<std::uint8_t> is_cut_away;  // by vertex; empty: none is
  if (view.is_perspective())
    for (std::size_t v = 0; v < points.size(); ++v)
      if (beyond_near(view, mesh.points[VertexId(v)]) < 0) {
        is_cut_away.resize(points.size(), 0);
        is_cut_away[v] = 1;
      }

  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& corners = mesh.triangles[TriangleId(t)];
    const auto& [a, b, c] = corners;
    if (is_cut_away.empty() || (is_cut_away[a.value] | is_cut_away[b.value] | is_cut_away[c.value]) == 0) {
      draw_triangle(image, TriangleId(t), points[a.value], points[b.value], points[c.value]);
      continue;
    }
    // What is left of it is a convex polygon of at most four corners.
    std::vector<Seen<Real>> left;
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexId from = corners[k], to = corners[(k + 1) % 3];
      if (is_cut_away[from.value] == 0) left.push_back(points[from.value]);
      if (is_cut_away[from.value] == is_cut_away[to.value]) continue;
      // From the lower index, so that two faces cut their edge at the same point.
      const Point3 &p = mesh.points[std::min(from, to)], &q = mesh.points[std::max(from, to)];
      const double at_p = beyond_near(view, p), at_q = beyond_near(view, q);
      left.push_back(project.operator()<Real>(sum(1, p, at_p / (at_p - at_q), minus(q, p))));
    }
    for (std::size_t k = 2; k < left.size(); ++k) draw_triangle(image, TriangleId(t), left[0], left[k - 1], left[k]);
  }
  return image;
}

template DepthImage<float> z_buffer(const Mesh&, const View&, const SampleGrid&);
template DepthImage<double> z_buffer(const Mesh&, const View&, const SampleGrid&);

}  // namespace hsr
