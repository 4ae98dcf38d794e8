#include "hsr/raster/sample_signs.h"

#include <algorithm>
#include <cmath>

#include "geometry/error.h"
#include "geometry/rational_vector.h"
#include "geometry/slope.h"

namespace hsr::internal {

namespace {

/// For c = O + k V and U along the row of c: det(c - e, U, p - e); seen in a direction D, det(U, D, p - O) - k det(U, D, V).
SampleCoordinate coordinate(const ProjectedMesh& projected, const Point3& origin, const Point3& along, const Point3& step) {
  SampleCoordinate c;
  Plane plane;
  plane.u_is = plane.v_is = Plane::Support::direction;
  if (projected.is_perspective()) {
    plane.o = projected.eye().at;
    plane.u = step;
    plane.v = along;
    c.next = projected.filter(plane);
    plane.u = origin;
    plane.u_is = Plane::Support::point;
    c.first = projected.filter(plane);
  } else {
    plane.o = origin;
    plane.u = along;
    plane.v = projected.eye().at;
    c.first = projected.filter(plane);
    const ErrorBounded change = c.first.change(step);
    c.next.offset = -change.value;
    c.next.least = change.error;
  }
  return c;
}

}  // namespace

SampleSigns::SampleSigns(const ProjectedMesh& projected, const SampleGrid& grid)
    : projected_(&projected),
      grid_{projected.scaled(grid.origin), projected.scaled(grid.right), projected.scaled(grid.down), grid.width, grid.height},
      row_(coordinate(projected, grid_.origin, grid_.right, grid_.down)),
      column_(coordinate(projected, grid_.origin, grid_.down, grid_.right)) {
  Predicates exact = projected.predicates();
  turn_ = exact.side(row_plane(0), at(0, 1));
  require(turn_ != Sign::zero, "SampleSigns: the viewpoint is in the plane of the samples");
}

Sign SampleSigns::side(const ViewPlane& plane, int i, int j, Predicates& exact) const {
  for (const Point3& p : {at(i, j), at(i + 1, j), at(i, j + 1)})
    if (const Sign s = exact.side(projected_->camera(), plane, p); s != Sign::zero) return s;
  return Sign::zero;
}

SampleFunction SampleSigns::function(const ViewPlane& plane) const {
  const PlaneFilter x = projected_->filter(plane.x);
  if (!plane.is_meet) return {x, grid_};
  // x(E) y(p) - y(E) x(p)
  const PlaneFilter y = projected_->filter(plane.y);
  const Point3& e = projected_->eye().at;
  const auto at_eye = [&](const PlaneFilter& f) { return projected_->is_perspective() ? f(e) : f.change(e); };
  const ErrorBounded xe = at_eye(x), ye = at_eye(y);
  const auto change = [&](const Point3& d) { return xe * y.change(d) - ye * x.change(d); };
  return {xe * y(grid_.origin) - ye * x(grid_.origin), change(grid_.right), change(grid_.down), grid_};
}

Plane SampleSigns::row_plane(int j) const {
  return turn_ == Sign::positive ? Plane::of_sight(projected_->eye(), at(0, j), at(1, j))
                                 : Plane::of_sight(projected_->eye(), at(1, j), at(0, j));
}

bool SampleSigns::is_in_front(VertexId v, Predicates& exact) const {
  if (!projected_->is_perspective()) return true;
  // det(V, U, p - e) = O of two samples of row 0, at row 1, if p is beyond the eye as they are.
  const ErrorBounded x = row_.next(projected_->point(v));
  if (x.is_certain()) return sign_of(x.value) == turn_;
  const Plane paper = Plane::of_face(at(0, 0), at(1, 0), at(0, 1));
  return slope(paper, projected_->eye().at, projected_->point(v)) == -exact.side(paper, projected_->eye().at);
}

bool SampleSigns::is_in_front(const std::array<Rational, 3>& p) const {
  const RationalVector n = cross(rational(grid_.down), rational(grid_.right));
  return dot(n, minus(p, rational(projected_->eye().at))).sign() == turn_;
}

Sign SampleSigns::certain_front(const BoundedPoint3& p) const {
  if (!projected_->is_perspective()) return Sign::positive;
  const ErrorBounded x = row_.next(p);
  return x.is_certain() ? sign_of(x.value) * turn_ : Sign::zero;
}

int SampleSigns::rows_above(VertexId v, const ErrorBounded& row, Predicates& exact) const {
  const int rows = certain_count(row, grid_.height);
  if (rows < 0) return rows_above(std::ceil(row.value), [&](int j) { return exact.side(row_plane(j), projected_->point(v)); });
  ++exact.counts().filter;
  return rows;
}

RowCut SampleSigns::exact_cut(const SampleFunction& f, double row, int j, int begin, int end, const ViewPlane& plane,
                              Predicates& exact) const {
  const auto sign_at = [&](int i) {
    const Sign certain = f.certain(row, i);
    return certain != Sign::zero ? certain : side(plane, i, j, exact);
  };
  const Sign first = sign_at(begin);
  if (end - begin == 1 || sign_at(end - 1) == first) return {first, end};
  // Signs change once: at low they are the first, at high the last.
  int low = begin, high = end - 1;
  const int k = guess(f, row, begin, end);
  for (const int i : {k, k - 1})
    if (i > low && i < high) (sign_at(i) == first ? low : high) = i;
  while (high - low > 1) {
    const int i = low + (high - low) / 2;
    (sign_at(i) == first ? low : high) = i;
  }
  return {first, high};
}

}  // namespace hsr::internal
