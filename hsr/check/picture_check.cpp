#include "hsr/check/picture_check.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <memory>
#include <unordered_map>
#include <vector>

#include "hsr/check/exact_triangle.h"
#include "hsr/scene/facet.h"

namespace hsr::internal {

namespace {

/// One object per thread; makes each triangle when first asked for.
class Judge {
 public:
  Judge(const Mesh& mesh, const View& view, const SampleGrid& grid, const std::optional<DepthResolution>& resolution)
      : mesh_(mesh), make_(mesh, view, grid), resolution_(resolution) {}

  Mistake operator()(TriangleId shown, TriangleId nearest, int i, int j) {
    if (!shown.is_valid() || !nearest.is_valid()) return Mistake::edge;
    // A picture may show a facet by any of its triangles.
    const FacetId facet = facet_of(mesh_, shown);
    const TriangleId end = facet_end(mesh_, facet);
    TriangleId at = first_triangle(facet);
    while (at < end && !made(at).covers(i, j)) at = TriangleId(at.value + 1U);
    if (at == end) return Mistake::edge;
    const ExactTriangle &a = made(at), &b = made(nearest);
    double bound = 0;
    if (resolution_) {
      const double reach = resolution_->coordinate_error;
      bound = 2 * step(resolution_->format, resolution_->range, a.nearness.near(i, j).value) +
              (a.nearness.change(reach, reach) + b.nearness.change(reach, reach)).to_double();
    }
    if (compared(b.nearness, a.nearness, i, j, bound) != Sign::positive) return Mistake::tie;
    return resolution_ && ends_within(resolution_->coordinate_error, facet_of(mesh_, nearest), i, j) ? Mistake::edge
                                                                                                     : Mistake::order;
  }

 private:
  /// Whether a corner of a box around the sample is outside of a face: then an edge of it is in the box.
  bool ends_within(double reach, FacetId facet, int i, int j) {
    const Rational r(reach);
    for (const Rational& x : {Rational(i) - r, Rational(i) + r})
      for (const Rational& y : {Rational(j) - r, Rational(j) + r})
        if (!is_within(facet, x, y)) return true;
    return false;
  }
  bool is_within(FacetId facet, const Rational& x, const Rational& y) {
    for (TriangleId t = first_triangle(facet); t < facet_end(mesh_, facet); t = TriangleId(t.value + 1U)) {
      const ExactTriangle& triangle = made(t);
      if (triangle.has_area && std::all_of(triangle.sides.begin(), triangle.sides.end(),
                                           [&](const ImageFunction& side) { return side.at(x, y).sign() != Sign::negative; }))
        return true;
    }
    return false;
  }

  const ExactTriangle& made(TriangleId t) {
    std::unique_ptr<ExactTriangle>& triangle = made_[t.value];
    if (!triangle) triangle = std::make_unique<ExactTriangle>(make_(t));
    return *triangle;
  }

  const Mesh& mesh_;
  ExactTriangles make_;
  std::optional<DepthResolution> resolution_;
  std::unordered_map<std::uint32_t, std::unique_ptr<ExactTriangle>> made_;
};

}  // namespace

PictureCheck check_picture(const Mesh& mesh, const View& view, const SampleGrid& samples, const Image<TriangleId>& shown,
                           const Image<TriangleId>& nearest, const std::optional<DepthResolution>& resolution) {
  PictureCheck all;
  all.mistakes = Image<Mistake>(samples.width, samples.height, Mistake::none);
  tbb::enumerable_thread_specific<Judge> judges([&] { return Judge(mesh, view, samples, resolution); });
  tbb::parallel_for(0, samples.height, [&](int j) {
    for (int i = 0; i < samples.width; ++i) {
      const TriangleId s = shown.at(i, j), n = nearest.at(i, j);
      if (s == n || (s.is_valid() && n.is_valid() && facet_of(mesh, s) == facet_of(mesh, n))) continue;
      all.mistakes.at(i, j) = judges.local()(s, n, i, j);
    }
  });
  all.samples = shown.pixels.size();
  all.covered = static_cast<std::uint64_t>(
      std::count_if(nearest.pixels.begin(), nearest.pixels.end(), [](TriangleId t) { return t.is_valid(); }));
  for (const Mistake m : all.mistakes.pixels) {
    all.wrong += m != Mistake::none ? 1U : 0U;
    all.edge += m == Mistake::edge ? 1U : 0U;
    all.tie += m == Mistake::tie ? 1U : 0U;
    all.order += m == Mistake::order ? 1U : 0U;
  }
  return all;
}

}  // namespace hsr::internal
