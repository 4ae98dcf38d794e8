#pragma once

#include <array>
#include <vector>

#include "geometry/error_bounded.h"
#include "geometry/number.h"
#include "hsr/raster/sample_projection.h"
#include "hsr/raster/samples.h"
#include "hsr/view/view.h"

// What the checks of pictures hold against them: triangles in the coordinates of the samples, in rationals.

namespace hsr::internal {

using ExactPoint = Seen<Rational>;

/// An affine function of the sample, exactly, and rounded with a bound.
class ImageFunction {
 public:
  ImageFunction() = default;
  ImageFunction(Rational origin, Rational right, Rational down);

  ErrorBounded near(int i, int j) const {
    return rounded_[0] + rounded_[1] * ErrorBounded{static_cast<double>(i)} +
           rounded_[2] * ErrorBounded{static_cast<double>(j)};
  }
  Rational at(int i, int j) const { return exact_[0] + Rational(i) * exact_[1] + Rational(j) * exact_[2]; }
  /// Between samples.
  Rational at(const Rational& x, const Rational& y) const { return exact_[0] + x * exact_[1] + y * exact_[2]; }
  /// With the rule for samples on edges (samples.h).
  Sign sign(int i, int j) const;
  /// How much it changes at most within a box around a sample.
  Rational change(double half_width, double half_height) const {
    return magnitude(exact_[1]) * Rational(half_width) + magnitude(exact_[2]) * Rational(half_height);
  }
  static Rational magnitude(const Rational& x) { return x.sign() == Sign::negative ? -x : x; }

 private:
  std::array<Rational, 3> exact_;
  std::array<ErrorBounded, 3> rounded_;
};

/// The line through two points; positive at c where p, q, c turn as the x-axis does to the y-axis.
ImageFunction line(const ExactPoint& p, const ExactPoint& q);

/// A triangle as it is seen.
struct ExactTriangle {
  std::vector<ExactPoint> corners;  ///< of what is beyond the near plane; convex
  bool has_area = false;
  // With an area:
  std::vector<ImageFunction> sides;  ///< not negative inside
  ImageFunction nearness;

  bool covers(int i, int j) const;
};

/// How much nearer a is than b at a sample, compared with a bound: positive, more than the bound; negative, less than -bound.
Sign compared(const ImageFunction& a, const ImageFunction& b, int i, int j, double bound);

/// Makes them.
class ExactTriangles {
 public:
  ExactTriangles(const Mesh& mesh, const View& view, const SampleGrid& grid) : mesh_(mesh), view_(view), project_(view, grid) {}

  bool is_cut_away(VertexId v) const { return view_.cuts() && is_before_near(view_, mesh_.points[v]); }
  ExactTriangle operator()(TriangleId t) const;

 private:
  const Mesh& mesh_;
  const View& view_;
  SampleProjection<Rational> project_;
};

}  // namespace hsr::internal
