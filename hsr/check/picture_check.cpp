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
    return compared(b.nearness, a.nearness, i, j, bound) == Sign::positive ? Mistake::order : Mistake::tie;
  }

 private:
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
