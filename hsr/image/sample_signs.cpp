#include "hsr/image/sample_signs.h"

#include "geometry/error.h"
#include "geometry/slope.h"

namespace hsr {

SampleSigns::SampleSigns(const Sight& sight, const SampleGrid& grid)
    : sight_(&sight),
      grid_{sight.scaled(grid.origin), sight.scaled(grid.right), sight.scaled(grid.down), grid.width, grid.height} {
  Predicates exact = sight.predicates();
  turn_ = exact.side(row_plane(0), at(0, 1));
  require(turn_ != Sign::zero, "SampleSigns: the viewpoint is in the plane of the samples");

  // det(c - e, U, p - e) with c = O + j V; seen in a direction D, det(U, D, p - O) - j det(U, D, V).
  Plane plane;
  plane.u_is = plane.v_is = Plane::Support::direction;
  plane.v = grid_.right;
  if (sight.is_perspective()) {
    plane.o = sight.eye().at;
    plane.u = grid_.down;
    next_row_ = sight.filter(plane);
    plane.u = grid_.origin;
    plane.u_is = Plane::Support::point;
    first_row_ = sight.filter(plane);
  } else {
    plane.o = grid_.origin;
    plane.u = grid_.right;
    plane.v = sight.eye().at;
    first_row_ = sight.filter(plane);
    const ErrorBounded step = SampleFunction::change(first_row_, grid_.down);
    next_row_.offset = -step.value;
    next_row_.least = step.error;
  }
}

Sign SampleSigns::side(const ViewPlane& plane, int i, int j, Predicates& exact) const {
  for (const Point3& p : {at(i, j), at(i + 1, j), at(i, j + 1)})
    if (const Sign s = exact.side(sight_->camera(), plane, p); s != Sign::zero) return s;
  return Sign::zero;
}

SampleFunction SampleSigns::function(const ViewPlane& plane) const {
  const PlaneFilter x = sight_->filter(plane.x);
  if (!plane.is_meet) return {x, grid_};
  // y(E) x(p) - x(E) y(p)
  const PlaneFilter y = sight_->filter(plane.y);
  const Point3& e = sight_->eye().at;
  const auto at_eye = [&](const PlaneFilter& f) { return sight_->is_perspective() ? f(e) : SampleFunction::change(f, e); };
  const ErrorBounded xe = at_eye(x), ye = at_eye(y);
  const auto change = [&](const Point3& d) {
    return ye * SampleFunction::change(x, d) - xe * SampleFunction::change(y, d);
  };
  return {ye * x(grid_.origin) - xe * y(grid_.origin), change(grid_.right), change(grid_.down), grid_};
}

Plane SampleSigns::row_plane(int j) const {
  return turn_ == Sign::positive ? Plane::of_sight(sight_->eye(), at(0, j), at(1, j))
                                 : Plane::of_sight(sight_->eye(), at(1, j), at(0, j));
}

bool SampleSigns::is_in_front(VertexId v, Predicates& exact) const {
  if (!sight_->is_perspective()) return true;
  // next_row_ is det(V, U, p - e), which turns as rows do.
  const ErrorBounded x = next_row_(sight_->point(v));
  if (x.is_certain()) return sign_of(x.value) == -turn_;
  const Plane paper = Plane::of_face(at(0, 0), at(1, 0), at(0, 1));
  return slope(paper, sight_->eye().at, sight_->point(v)) == -exact.side(paper, sight_->eye().at);
}

/// The zero of a + j b is at -a / b; the quotient errs by at most (e_a + |a / b| e_b) / (|b| - e_b) and one rounding.
int SampleSigns::rows_above(VertexId v, Predicates& exact) const {
  const Point3& p = sight_->point(v);
  const ErrorBounded a = first_row_(p), b = next_row_(p);
  const double y = -a.value / b.value;
  if (std::fabs(b.value) > 2 * b.error) {
    const double error = (a.error + std::fabs(y) * b.error) / (std::fabs(b.value) - b.error) * 1.01 + 4e-16 * std::fabs(y);
    const double low = std::ceil(y - error), high = std::ceil(y + error);
    if (low == high || high <= 0 || low >= grid_.height) {
      ++exact.counts().filter;
      return static_cast<int>(std::clamp(low, 0.0, static_cast<double>(grid_.height)));
    }
  }
  return rows_above(std::ceil(y), [&](int j) { return exact.side(row_plane(j), p); });
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

}  // namespace hsr
