#include "hsr/painter/sort/image_triangle.h"

#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <limits>

#include "geometry/parallel.h"

namespace hsr::internal {

namespace {

struct Extent {
  double low_x = HUGE_VAL, low_y = HUGE_VAL, high_x = -HUGE_VAL, high_y = -HUGE_VAL;

  void add(const ImagePoint& p) {
    low_x = std::min(low_x, p.x);
    low_y = std::min(low_y, p.y);
    high_x = std::max(high_x, p.x);
    high_y = std::max(high_y, p.y);
  }
  Extent joined(const Extent& o) const {
    return {std::min(low_x, o.low_x), std::min(low_y, o.low_y), std::max(high_x, o.high_x), std::max(high_y, o.high_y)};
  }
};

}  // namespace

/// The move rounds twice, by no more than 2 u of the largest numbers that take part; the last rounding to floats by no more
/// than 2^-24, as all is at most 1 and a little. Powers of two round nothing.
ImageTriangles image_triangles(const ProjectedMesh& projected, const FacePieces& pieces) {
  ImageTriangles images;
  const std::vector<VertexId>& corners = pieces.rings.values();
  if (!(projected.image_error() < HUGE_VAL) || corners.empty()) return images;
  using Range = tbb::blocked_range<std::size_t>;
  const Extent all = tbb::parallel_reduce(
      Range(0, corners.size(), 4096), Extent(),
      [&](const Range& range, Extent extent) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) extent.add(projected.image(corners[i]));
        return extent;
      },
      [](const Extent& x, const Extent& y) { return x.joined(y); });
  const double x = all.low_x / 2 + all.high_x / 2, y = all.low_y / 2 + all.high_y / 2;
  const double half = std::max(all.high_x / 2 - all.low_x / 2, all.high_y / 2 - all.low_y / 2);
  const double most = std::max({std::fabs(all.low_x), std::fabs(all.high_x), std::fabs(all.low_y), std::fabs(all.high_y)});
  if (!(half > 0x1p-500) || !(most < 0x1p500)) return images;  // no floats for these
  int power = 0;
  std::frexp(half, &power);
  const double scale = std::ldexp(1.0, -power);
  const double error = 1.01 * (scale * (projected.image_error() + 4 * ErrorBounded::u * most) + 0x1p-24);
  if (!(error < 0x1p-10)) return images;  // then none exceeds 1.01
  images.error = static_cast<float>(1.01 * error);
  images.triangles.resize(pieces.size());
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  parallel_for_each(images.triangles.size(), [&](std::size_t i) {
    ImageTriangle& t = images.triangles[i];
    const std::span<const VertexId> ring = pieces.rings[i];
    if (ring.size() != 3) {
      t.x.fill(nan);
      return;
    }
    const bool forward = projected.facing(pieces.facet[i]) == Sign::positive;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t corner = std::min<std::size_t>(k, 2);
      const VertexId v = ring[forward ? corner : 2 - corner];
      const ImagePoint& p = projected.image(v);
      t.x[k] = static_cast<float>((p.x - x) * scale);
      t.y[k] = static_cast<float>((p.y - y) * scale);
      t.vertex[k] = v.value;
    }
    const auto [low_x, high_x] = std::minmax({t.x[0], t.x[1], t.x[2]});
    const auto [low_y, high_y] = std::minmax({t.y[0], t.y[1], t.y[2]});
    t.size = (high_x - low_x) + (high_y - low_y);
    ImageBox depths = ImageBox::nothing();
    for (const VertexId v : ring) depths.add(projected.box(v, v));
    t.farthest = depths.farthest;
    t.nearest = depths.nearest;
  });
  return images;
}

}  // namespace hsr::internal
