#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/number.h"
#include "geometry/plane_filter.h"
#include "geometry/slope.h"
#include "geometry/view_plane.h"
#include "hsr/raster/samples.h"
#include "hsr/scene/projected_mesh.h"

namespace hsr::internal {

/// The value of a plane at every sample, in doubles: it is affine in i and j.
///
/// value = (at_origin + j down) + i right. With the exact value V and M = |at_origin| + width |right| + height |down|, the
/// filter's errors give |at_origin + i right + j down - V| <= e_o + width e_r + height e_d, and the two products and two sums
/// round by at most 3.1 u M; `error` has 4.2 u M, so that value -+ error may be rounded once more.
struct SampleFunction {
  double at_origin = 0, right = 0, down = 0;
  double error = HUGE_VAL;

  SampleFunction() = default;
  SampleFunction(ErrorBounded o, ErrorBounded r, ErrorBounded d, const SampleGrid& grid)
      : at_origin(o.value), right(r.value), down(d.value) {
    const double m = std::fabs(at_origin) + grid.width * std::fabs(right) + grid.height * std::fabs(down);
    error = (o.error + grid.width * r.error + grid.height * d.error + 4.2 * ErrorBounded::u * m) * ErrorBounded::grow;
  }
  SampleFunction(const PlaneFilter& plane, const SampleGrid& grid)
      : SampleFunction(plane(grid.origin), plane.change(grid.right), plane.change(grid.down), grid) {}

  double on_row(int j) const { return at_origin + j * down; }
  double value(double row, int i) const { return row + i * right; }
  /// Zero: doubles cannot tell.
  Sign certain(double x) const { return x > error ? Sign::positive : x < -error ? Sign::negative : Sign::zero; }
  Sign certain(double row, int i) const { return certain(value(row, i)); }
};

/// A row of samples, or a part of it, that a plane cuts in two: those before `change` have the sign `first`, the others the
/// opposite one. All alike: change is the end.
struct RowCut {
  Sign first;
  int change;
};

/// Where a point is seen, in rows or in columns of samples: the zero of first(p) + k next(p), the value at p of the plane of
/// row (or column) k. The quotient errs by at most (e_f + |f / n| e_n) / (|n| - e_n), and one rounding.
struct SampleCoordinate {
  PlaneFilter first, next;

  /// The error is infinite where doubles cannot tell. @pre p is in front
  ErrorBounded operator()(const Point3& p) const {
    const ErrorBounded f = first(p), n = next(p);
    const double at = -f.value / n.value;
    if (!(std::fabs(n.value) > 2 * n.error)) return {at, HUGE_VAL};
    return {at,
            (f.error + std::fabs(at) * n.error) / (std::fabs(n.value) - n.error) * 1.01 + 8 * ErrorBounded::u * std::fabs(at)};
  }
};

/// How many of the samples 0 ... end - 1 are before x, or -1 where that is not certain.
inline int certain_count(const ErrorBounded& x, int end) {
  const double low = std::ceil(x.value - x.error), high = std::ceil(x.value + x.error);
  return low == high || high <= 0 || low >= end ? static_cast<int>(std::clamp(low, 0.0, static_cast<double>(end))) : -1;
}

/// The signs of planes at samples, exactly, and with the rule for samples on edges (samples.h).
///
/// @pre the sight was made with the bit range of the grid; it outlives this. Planes are among its points and samples.
/// A sign is zero only for a plane that contains the paper, which no plane through the viewpoint does.
class SampleSigns {
 public:
  SampleSigns(const ProjectedMesh& projected, const SampleGrid& grid);

  const ProjectedMesh& projected() const { return *projected_; }
  /// As the sight scales it.
  const SampleGrid& grid() const { return grid_; }
  Point3 at(int i, int j) const { return grid_.at(i, j); }

  /// A value that is zero at p is at p + U what it changes by along U: so the sign there breaks the tie.
  Sign side(const ViewPlane& plane, int i, int j, Predicates& exact) const;
  /// The values of a plane, in doubles.
  SampleFunction function(const ViewPlane& plane) const;
  /// How a plane's value changes along row j. Exact.
  Sign slope_along_row(const ViewPlane& plane, int j) const { return slope(projected_->camera(), plane, at(0, j), at(1, j)); }
  /// Where a plane cuts the samples begin ... end - 1 of row j. @pre begin < end, `f` is of the plane, row is f.on_row(j)
  /// @param plane gives the plane; only asked for where doubles cannot tell
  template <class MakePlane>
  RowCut cut(const SampleFunction& f, double row, int j, int begin, int end, const MakePlane& plane, Predicates& exact) const {
    const Sign first = f.certain(row, begin), last = f.certain(row, end - 1);
    if (first == Sign::zero || last == Sign::zero) return exact_cut(f, row, j, begin, end, plane(), exact);
    if (first == last) return {first, end};
    const int k = guess(f, row, begin, end);
    if (f.certain(row, k - 1) == first && f.certain(row, k) == last) return {first, k};
    return exact_cut(f, row, j, begin, end, plane(), exact);
  }

  /// Whether a vertex is in front of the eye as the samples are: beyond the plane through the eye parallel to theirs. Always so
  /// in a parallel view, and for what is beyond the near plane and less than 89.9999 degrees off the middle of the picture.
  bool is_in_front(VertexId v, Predicates& exact) const;
  /// Whether any other point is in front of the eye as the samples are. @pre a perspective view
  bool is_in_front(const std::array<Rational, 3>& p) const;
  /// What doubles tell of a point that is known within an error: positive, it is in front; zero, nothing.
  Sign certain_front(const BoundedPoint3& p) const;
  /// The plane of the viewpoint and row j; positive below it.
  Plane row_plane(int j) const;
  /// How many rows are above what is seen at a vertex: a side from a to b crosses the rows rows_above(a) ... rows_above(b) - 1,
  /// or the other way round. @pre is_in_front(v)
  int rows_above(VertexId v, Predicates& exact) const { return rows_above(v, row_of(projected_->point(v)), exact); }
  /// @param row row_of(v)
  int rows_above(VertexId v, const ErrorBounded& row, Predicates& exact) const;
  /// Where a point in front is seen, in rows and columns of samples. The error is infinite where doubles cannot tell.
  ErrorBounded row_of(const Point3& p) const { return row_(p); }
  ErrorBounded column_of(const Point3& p) const { return column_(p); }
  /// The rows above any point, of which below(j) is the sign on the plane of row j; `guess` may be anything.
  template <class Below>
  int rows_above(double guess, const Below& below) const;

 private:
  /// Some k with begin < k < end, if there is one; the first after the zero of f as far as doubles tell.
  static int guess(const SampleFunction& f, double row, int begin, int end) {
    const double k = std::ceil(-row / f.right);
    return static_cast<int>(k > begin + 1 ? (k < end - 1 ? k : end - 1) : begin + 1);
  }
  RowCut exact_cut(const SampleFunction& f, double row, int j, int begin, int end, const ViewPlane& plane,
                   Predicates& exact) const;

  const ProjectedMesh* projected_;
  SampleGrid grid_;
  Sign turn_ = Sign::positive;  // of right and down as seen; negative: rows as given would be positive above
  SampleCoordinate row_, column_;
};

template <class Below>
int SampleSigns::rows_above(double guess, const Below& below) const {
  // Rows low ... high - 1 are open.
  int low = 0, high = grid_.height;
  int j = guess > 0 ? (guess < high ? static_cast<int>(guess) : high - 1) : 0;
  for (int step = 1; low < high; step *= 2) {
    // Outward from the guess in growing steps, then by halves.
    if (below(j) == Sign::positive) {
      low = j + 1;
      j = std::min(j + step, low + (high - low) / 2);
    } else {
      high = j;
      j = std::max(j - step, low + (high - low - 1) / 2);
    }
  }
  return low;
}

}  // namespace hsr::internal
