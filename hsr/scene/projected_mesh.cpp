#include "hsr/scene/projected_mesh.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "geometry/error.h"
#include "geometry/vector3.h"
#include "hsr/scene/line_filter.h"
#include "hsr/scene/scaled_mesh.h"

namespace hsr::internal {

namespace {

using Range = tbb::blocked_range<std::size_t>;
constexpr double u = ErrorBounded::u;

}  // namespace

ProjectedMesh::ProjectedMesh(const Mesh& mesh, const View& view, Arithmetic arithmetic, const BitRange& others, TieRule ties)
    : mesh_(&mesh), arithmetic_(arithmetic), ties_(ties) {
  // Only of the points that are used: a stray one far away must not cost the others the fast arithmetic.
  std::vector<char> is_used(mesh.points.size(), 0);
  tbb::parallel_for(Range(0, mesh.edges.size(), 4096), [&](const Range& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const Edge& e = mesh.edges[EdgeId(i)];
      for (const VertexId v : {e.a, e.b}) std::atomic_ref<char>(is_used[v.value]).store(1, std::memory_order_relaxed);
    }
  });
  BitRange direction;
  BitRange points = tbb::parallel_reduce(
      Range(0, is_used.size(), 4096), BitRange{},
      [&](const Range& range, BitRange c) {
        for (std::size_t i = range.begin(); i < range.end(); ++i)
          if (is_used[i] != 0) c.add(mesh.points[VertexId(i)]);
        return c;
      },
      [](BitRange a, const BitRange& b) {
        a.add(b);
        return a;
      });
  if (view.is_perspective()) {
    points.add(view.viewpoint.at);
    points.add(view.target);
  } else {
    direction.add(view.viewpoint.at);
  }
  BitRange normal;
  const auto add = [&](const SectionPlane& plane) {
    points.add(plane.point);
    normal.add(plane.normal);
  };
  if (view.section) add(*view.section);
  if (view.far) add(*view.far);
  for (const SectionPlane& plane : view.planes) add(plane);
  points.add(others);
  const int power = scale_of(points), direction_power = scale_of(direction), normal_power = scale_of(normal);
  power_ = power;
  given_bit_range_ = points;
  points_bit_range_ = internal::scaled(points, power);
  direction_bit_range_ = internal::scaled(direction, direction_power);
  direction_bit_range_.add(internal::scaled(normal, normal_power));
  points_.resize(mesh.points.size());
  tbb::parallel_for(Range(0, points_.size(), 4096), [&](const Range& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i)
      if (is_used[i] != 0) points_[VertexId(i)] = scaled(mesh.points[VertexId(i)]);
  });
  eye_ = {internal::scaled(view.viewpoint.at, view.is_perspective() ? power : direction_power), view.viewpoint.is_direction};
  target_ = view.is_perspective() ? scaled(view.target) : Point3{};
  near_ = view.near;
  const auto scaled_plane = [&](const SectionPlane& plane) {
    return SectionPlane{scaled(plane.point), internal::scaled(plane.normal, normal_power)};
  };
  if (view.section) section_ = scaled_plane(*view.section);
  if (view.far) far_ = scaled_plane(*view.far);
  for (const SectionPlane& plane : view.planes) planes_.push_back(scaled_plane(plane));
  // Outside the window of the filter's proof its bound is made infinite, and the predicates decide.
  filter_arithmetic_ = arithmetic == Arithmetic::staged && !predicates().filter_is_proven() ? Arithmetic::interval : arithmetic;

  if (has_near()) find_near_sides(is_used);
  choose_rows(view);
  compute_images(is_used);
  vertex_boxes_.resize(points_.size(), ImageBox::nothing());
  tbb::parallel_for(Range(0, points_.size(), 4096), [&](const Range& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i)
      if (is_used[i] != 0 && beyond_near(VertexId(i)) != Sign::negative)
        add_to(vertex_boxes_[VertexId(i)], points_[VertexId(i)], 0);
  });
  facing_.resize(mesh.triangles.size(), Sign::zero);
  tbb::parallel_for(Range(0, mesh.triangles.size(), 1024), [&](const Range& range) {
    Predicates exact = predicates();
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const auto& t = mesh.triangles[TriangleId(i)];
      facing_[TriangleId(i)] = LineFilter(*this, t[0], t[1]).side(t[2], exact);
    }
  });
}

/// A section takes the place of the near plane, and so must not leave anything that this would cut away.
void ProjectedMesh::find_near_sides(const std::vector<char>& is_used) {
  near_side_.resize(points_.size(), Sign::positive);
  const auto find = [&](const Plane& near) {
    near_filter_ = filter(near);
    tbb::parallel_for(Range(0, points_.size(), 1024), [&](const Range& range) {
      Predicates exact = predicates();
      for (std::size_t i = range.begin(); i < range.end(); ++i) {
        if (is_used[i] == 0) continue;
        const ErrorBounded x = near_filter_(points_[VertexId(i)]);
        near_side_[VertexId(i)] = x.is_certain() ? sign_of(x.value) : exact.side(near, points_[VertexId(i)]);
      }
    });
  };
  if (section_ && is_perspective()) {
    const Plane near = Plane::near(eye_.at, target_, near_);
    find(near);
    if (std::find(near_side_.begin(), near_side_.end(), Sign::negative) != near_side_.end()) expect_only_removed(near);
  }
  find(near_plane());
}

/// What is before the near plane is the hull of vertices there, and of where edges meet that plane: all of these have to be in front of
/// the section. With near(p) < 0 <= near(q) the latter are where near(p) q - near(q) p is.
void ProjectedMesh::expect_only_removed(const Plane& near) const {
  const Plane section = near_plane();
  const auto is_removed = [&](const Edge& e, Predicates& exact) {
    const Sign at_a = near_side_[e.a], at_b = near_side_[e.b];
    for (const VertexId v : {e.a, e.b})
      if (near_side_[v] == Sign::negative && side(section, v, exact) == Sign::positive) return false;
    if (at_a == at_b || (at_a != Sign::negative && at_b != Sign::negative)) return true;
    const auto [before, beyond] = at_a == Sign::negative ? std::pair{e.a, e.b} : std::pair{e.b, e.a};
    return exact.cross(near, section, points_[before], points_[beyond]) != Sign::negative;
  };
  tbb::parallel_for(Range(0, mesh_->edges.size(), 1024), [&](const Range& range) {
    Predicates exact = predicates();
    for (std::size_t i = range.begin(); i < range.end(); ++i)
      if (!is_removed(mesh_->edges[EdgeId(i)], exact))
        throw InputError(
            "section: found a part of the model that it leaves before the near plane, expected none: see --eye and --near");
  });
}

bool ProjectedMesh::covers(const BitRange& others) const {
  BitRange both = given_bit_range_;
  both.add(others);
  return both == given_bit_range_;
}

Point3 ProjectedMesh::scaled(const Point3& p) const { return internal::scaled(p, power_); }

void ProjectedMesh::choose_rows(const View& view) {
  // Any map that is constant along lines of sight serves, so rounded rows are as good as others.
  if (is_perspective()) {
    depth_ = minus(target_, eye_.at);
    depth_ = over(depth_, norm_max(depth_));
    for (std::size_t r = 0; r < 2; ++r) {
      const Point3& row = r == 0 ? view.frame.right : view.frame.up;
      row_[r] = over(row, std::max(norm_max(row), 1.0));  // the bounds below want entries <= 1
    }
  } else {
    const Point3& d = eye_.at;
    const int k = std::fabs(d.x) >= std::fabs(d.y) && std::fabs(d.x) >= std::fabs(d.z) ? 0
                  : std::fabs(d.y) >= std::fabs(d.z)                                   ? 1
                                                                                       : 2;
    depth_ = {k == 0 ? std::copysign(1.0, d.x) : 0, k == 1 ? std::copysign(1.0, d.y) : 0, k == 2 ? std::copysign(1.0, d.z) : 0};
    for (std::size_t r = 0; r < 2; ++r) {
      std::array<double, 3> row = {0, 0, 0};
      const std::size_t i = (static_cast<std::size_t>(k) + 1 + r) % 3;
      row[i] = 1;
      row[static_cast<std::size_t>(k)] = -d[static_cast<int>(i)] / d[k];
      is_whole_ratio_[r] = d[static_cast<int>(i)] == 0 || std::fabs(d[static_cast<int>(i)]) == std::fabs(d[k]);
      row_[r] = {row[0], row[1], row[2]};
    }
    if (!mesh_->edges.empty()) {
      const Point3& p = points_[mesh_->edges.front().a];
      middle_ = {dot(row_[0], p), dot(row_[1], p), dot(depth_, p)};
    }
  }
}

/// The images of all vertices in use that are beyond the near plane; of what a section cuts away, too, as far as it has some.
///
/// Parallel, with D toward the viewer and k the axis of its largest entry: rows u', v' of det(D, u, v) = O without the share of
/// D leave D_k (u'_i v'_j - u'_j v'_i), so the rows are mirrored where D_k < 0.
/// Perspective, with M the matrix of the rows and the depth: -det(M) O = m_c m_d m_p times the turn of the images, and the
/// depths m are positive; so they are mirrored where det(M) > 0. The rows are orthogonal but for rounding: |det| is far from zero,
/// or the images are given up.
void ProjectedMesh::compute_images(const std::vector<char>& is_used) {
  image_error_ = HUGE_VAL;
  if (arithmetic_ != Arithmetic::staged || filter_arithmetic_ != Arithmetic::staged) return;
  if (is_perspective()) {
    const Point3 &r = row_[0], &s = row_[1], &t = depth_;
    const double det = r.x * (s.y * t.z - s.z * t.y) + r.y * (s.z * t.x - s.x * t.z) + r.z * (s.x * t.y - s.y * t.x);
    if (!(std::fabs(det) > 0x1p-20)) return;
    image_mirror_ = det > 0 ? -1 : 1;
  } else {
    image_mirror_ = dot(depth_, eye_.at) * dot(depth_, {1, 1, 1}) > 0 ? 1 : -1;
  }
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  image_.resize(points_.size(), {nan, nan});
  image_error_ = tbb::parallel_reduce(
      Range(0, points_.size(), 4096), 0.0,
      [&](const Range& range, double error) {
        for (std::size_t i = range.begin(); i < range.end(); ++i)
          if (const bool is_left = beyond_near(VertexId(i)) != Sign::negative; is_used[i] != 0 && (section_ || is_left)) {
            const double bound = compute_image(VertexId(i));
            if (is_left || bound < HUGE_VAL) error = std::max(error, bound);
          }
        return error;
      },
      [](double x, double y) { return std::max(x, y); });
}

/// Returns a bound of the error of both coordinates.
///
/// Parallel: see add_to; where the ratio is 0, 1 or -1 the product is exact, and Knuth's two-sum tells whether the sum is.
double ProjectedMesh::compute_image(VertexId v) {
  const Point3& p = points_[v];
  if (is_perspective()) {
    const Point3 q = minus(p, eye_.at);
    const double e = 6 * u * norm_one(q) + 0x1p-1000, m = dot(depth_, q);
    if (!(m > 2 * e)) return HUGE_VAL;
    const double x = dot(row_[0], q) / m, y = dot(row_[1], q) / m;
    image_[v] = {image_mirror_ * x, y};
    const double most = std::max(std::fabs(x), std::fabs(y));
    return (e + most * e) / (m - e) * 1.01 + 4 * u * most;
  }
  const int k = depth_.x != 0 ? 0 : depth_.y != 0 ? 1 : 2;
  std::array<double, 2> c;
  double error = 0;
  for (std::size_t r = 0; r < 2; ++r) {
    const double own = p[(k + 1 + static_cast<int>(r)) % 3], ratio = row_[r][k], share = ratio * p[k];
    const double sum = own + share, back = sum - own;
    c[r] = sum;
    const bool is_exact = is_whole_ratio_[r] && (own - (sum - back)) + (share - back) == 0;
    // The ratio is at most 1; an underflow costs it less than u.
    if (!is_exact) error = std::max(error, 5 * u * (std::fabs(own) + 2 * std::fabs(p[k])) + 0x1p-1000);
  }
  image_[v] = {image_mirror_ * c[0], c[1]};
  return error;
}

/// The bounds of compute_image, and of add_to for what the point itself is off by.
BoundedPoint2 ProjectedMesh::image(const Point3& p, double error) const {
  if (is_perspective()) {
    const Point3 q = minus(p, eye_.at);
    const double e = 6 * u * norm_one(q) + error * 1.01 + 0x1p-1000, m = dot(depth_, q);
    if (!(m > 2 * e)) return {{0, 0}, HUGE_VAL};
    const double x = dot(row_[0], q) / m, y = dot(row_[1], q) / m, most = std::max(std::fabs(x), std::fabs(y));
    return {{image_mirror_ * x, y}, (e + most * e) / (m - e) * 1.01 + 4 * u * most};
  }
  return {{image_mirror_ * dot(row_[0], p), dot(row_[1], p)}, (5 * u * norm_one(p) + error) * 1.01 + 0x1p-1000};
}

Sign ProjectedMesh::side(const Plane& plane, VertexId p, Predicates& exact) const {
  const ErrorBounded x = filter(plane)(points_[p]);
  if (!x.is_certain()) return exact.side_beyond_filter(plane, points_[p]);
  ++exact.counts().filter;
  return sign_of(x.value);
}

bool ProjectedMesh::reaches_before_near(TriangleId t) const {
  const auto& c = mesh_->triangles[t];
  return std::any_of(c.begin(), c.end(), [&](VertexId v) { return beyond_near(v) == Sign::negative; });
}

bool ProjectedMesh::reaches_beyond_near(TriangleId t) const {
  const auto& c = mesh_->triangles[t];
  return std::any_of(c.begin(), c.end(), [&](VertexId v) { return beyond_near(v) != Sign::negative; });
}

Plane ProjectedMesh::face_plane(TriangleId t) const {
  const auto& corners = mesh_->triangles[t];
  return Plane::of_face(points_[corners[0]], points_[corners[1]], points_[corners[2]]);
}

/// Adds the image of a point that lies within `error` (in the sum of its coordinates' errors) of p.
///
/// Parallel: u = p_i - ratio p_k, where the ratio carries one rounding, the product and the difference one each: at most 3.1 u
/// |p|. Perspective: each coordinate of p - eye carries one rounding, the dot products three more; the quotient of n and m with
/// errors e_n and e_m differs from the exact one by at most (e_n + |n/m| e_m) / (|m| - e_m), and by u |n/m| for its own
/// rounding.
void ProjectedMesh::add_to(ImageBox& box, const Point3& p, double error) const {
  if (!is_perspective()) {
    const std::array<double, 3> value = {dot(row_[0], p) - middle_[0], dot(row_[1], p) - middle_[1],
                                         dot(depth_, p) - middle_[2]};
    const auto bound = [&](std::size_t k) { return 5 * u * (norm_one(p) + std::fabs(middle_[k])) + error + 0x1p-1000; };
    box.add(value, {bound(0), bound(1), bound(2)});
    return;
  }
  const Point3 v = minus(p, eye_.at);
  const double e = 6 * u * norm_one(v) + error * 1.01 + 0x1p-1000;
  const double m = dot(depth_, v);
  if (!(m > 2 * e)) {
    box = ImageBox::everything();
    return;
  }
  const double x = dot(row_[0], v) / m, y = dot(row_[1], v) / m;
  const auto spread = [&](double q) { return (e + std::fabs(q) * e) / (m - e) * 1.01 + 4 * u * std::fabs(q); };
  box.add({x, y, -m}, {spread(x), spread(y), e});
}

/// The bounds of add_to().
ErrorBounded ProjectedMesh::nearness(const Point3& p, double error) const {
  if (!is_perspective())
    return {dot(depth_, p) - middle_[2], (5 * u * (norm_one(p) + std::fabs(middle_[2])) + error) * 1.01 + 0x1p-1000};
  const Point3 v = minus(p, eye_.at);
  return {-dot(depth_, v), 6 * u * norm_one(v) + error * 1.01 + 0x1p-1000};
}

/// Adds the point where ab crosses the near plane: a + t (b - a), t = near(a) / (near(a) - near(b)).
void ProjectedMesh::add_near_cut_to(ImageBox& box, VertexId a, VertexId b) const {
  const Point3 &p = points_[a], &q = points_[b];
  const ErrorBounded at_p = near_filter_(p), at_q = near_filter_(q);
  const double fall = at_p.value - at_q.value, loss = at_p.error + at_q.error + u * std::fabs(fall);
  if (!(std::fabs(fall) > 4 * loss)) {
    box = ImageBox::everything();
    return;
  }
  const double t = at_p.value / fall;
  const double t_error = 2 * (at_p.error + std::fabs(t) * loss) / std::fabs(fall) + 4 * u;
  const Point3 d = minus(q, p);
  add_to(box, sum(p, t, d), norm_one(d) * (t_error + 4 * u) + 4 * u * (norm_one(p) + norm_one(q)));
}

ImageBox ProjectedMesh::box(VertexId a, VertexId b) const {
  ImageBox box = vertex_boxes_[a];
  box.add(vertex_boxes_[b]);
  if (beyond_near(a) * beyond_near(b) == Sign::negative) add_near_cut_to(box, a, b);
  return box;
}

ImageBox ProjectedMesh::box(TriangleId t) const {
  const auto& c = mesh_->triangles[t];
  ImageBox box = vertex_boxes_[c[0]];
  box.add(vertex_boxes_[c[1]]);
  box.add(vertex_boxes_[c[2]]);
  if (!has_near()) return box;
  for (std::size_t k = 0; k < 3; ++k) {
    const VertexId a = c[k], b = c[(k + 1) % 3];
    if (beyond_near(a) * beyond_near(b) == Sign::negative) add_near_cut_to(box, a, b);
  }
  return box;
}

}  // namespace hsr::internal
