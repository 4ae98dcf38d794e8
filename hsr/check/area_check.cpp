#include "hsr/check/area_check.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "hsr/raster/sample_signs.h"
#include "hsr/scene/facet.h"
#include "hsr/scene/projected_mesh.h"
#include "hsr/scene/view_parts.h"
#include "hsr/visibility_map/map_predicates.h"

namespace hsr::internal {

namespace {

/// In pixels: pixel (i, j) is [i, i + 1] x [j, j + 1].
struct PixelPoint {
  double x, y;
};

/// What the sides of one fragment leave in a pixel: `cover`, how much they descend in it, and so cover of each pixel to its
/// right; `area`, the part of that which lies within it.
struct Cell {
  int row, column;
  double cover, area;
};

/// Measures fragments. One object per block of them.
class Coverage {
 public:
  Coverage(const Mesh& mesh, const Image<TriangleId>& shown) : mesh_(mesh), shown_(shown) {}

  void begin() { cells_.clear(); }

  /// A side of the fragment, which is on its left or on its right all around.
  void add(PixelPoint p, PixelPoint q) {
    const double sign = p.y < q.y ? 1 : -1;
    if (q.y < p.y) std::swap(p, q);
    if (!(p.y < q.y)) return;
    const double top = std::max(p.y, 0.0), bottom = std::min(q.y, static_cast<double>(shown_.height));
    if (!(top < bottom)) return;
    const double slope = (q.x - p.x) / (q.y - p.y);
    const auto x_at = [&](double y) {
      const double x = p.x + (y - p.y) * slope;
      return std::clamp(x, std::min(p.x, q.x), std::max(p.x, q.x));
    };
    const int last = std::min(static_cast<int>(bottom), shown_.height - 1);
    for (int j = static_cast<int>(top); j <= last; ++j) {
      const double from = std::max(top, static_cast<double>(j)), to = std::min(bottom, j + 1.0);
      if (from < to) add_in_row(j, x_at(from), x_at(to), to - from, sign);
    }
  }

  /// All sides are added: measures against what is shown.
  void finish(FacetId facet, AreaCheck& sum) {
    std::sort(cells_.begin(), cells_.end(),
              [](const Cell& a, const Cell& b) { return a.row != b.row ? a.row < b.row : a.column < b.column; });
    // Clockwise or not: the sign of the whole.
    double whole = 0;
    for (const Cell& c : cells_) whole += c.area + c.cover * (shown_.width - 1 - c.column);
    const double sign = whole < 0 ? -1 : 1;
    double cover = 0;
    for (std::size_t k = 0; k < cells_.size();) {
      const int j = cells_[k].row, i = cells_[k].column;
      double area = cover;
      for (; k < cells_.size() && cells_[k].row == j && cells_[k].column == i; ++k) {
        area += cells_[k].area;
        cover += cells_[k].cover;
      }
      if (i < shown_.width) measure(facet, i, i + 1, j, sign * area, sum);
      const bool ends_row = k == cells_.size() || cells_[k].row != j;
      const int end = ends_row ? shown_.width : cells_[k].column;
      // At its end the sides have ascended as much as they have descended, but for rounding and for what is right of the
      // picture: not to walk along the whole row for a rounding.
      if (!ends_row || std::fabs(cover) > 0x1p-44) measure(facet, i + 1, end, j, sign * cover, sum);
      if (ends_row) cover = 0;
    }
  }

 private:
  /// A piece of a side within a row, `height` tall.
  void add_in_row(int j, double x0, double x1, double height, double sign) {
    const double width = shown_.width;
    double left = std::min(x0, x1);
    const double right = std::max(x0, x1);
    if (left >= width) return;
    const double per_x = right > left ? height / (right - left) : 0;
    if (left < 0) {
      // What lies to the left of the picture covers all of the row.
      const double part = right <= 0 ? height : -left * per_x;
      cells_.push_back({j, 0, sign * part, sign * part});
      if (right <= 0) return;
      height -= part;
      left = 0;
    }
    for (int i = static_cast<int>(left); i < shown_.width; ++i) {
      const double to = std::min(right, i + 1.0), part = to < right ? (to - left) * per_x : height;
      cells_.push_back({j, i, sign * part, sign * part * (i + 1 - (left + to) / 2)});
      height -= part;
      left = to;
      if (to >= right) break;
    }
  }

  void measure(FacetId facet, int begin, int end, int j, double area, AreaCheck& sum) const {
    const TriangleId* row = shown_.row(j);
    for (int i = begin; i < end; ++i) {
      sum.visible += area;
      // A pixel that shows nothing is right where no fragment is: what is there is wrong.
      if (!row[i].is_valid())
        sum.wrong += area;
      else if (facet_of(mesh_, row[i]) == facet)
        sum.wrong -= area;
    }
  }

  const Mesh& mesh_;
  const Image<TriangleId>& shown_;
  std::vector<Cell> cells_;
};

}  // namespace

AreaCheck check_area(const SceneView& scene, const VisibleFragments& fragments, const SampleGrid& samples,
                     const Image<TriangleId>& shown) {
  const Mesh& mesh = scene.mesh();
  AreaCheck all;
  // A pixel that shows a face is wrong but for what is visible of that face in it.
  for (const TriangleId t : shown.pixels) all.wrong += t.is_valid() ? 1 : 0;
  const std::size_t n = fragments.fragments.size();
  if (n == 0) return all;
  const ProjectedMesh& projected = scene.parts().with(samples.bit_range()).projected();
  const SampleSigns signs(projected, samples);
  constexpr std::size_t block = 256;
  std::vector<AreaCheck> parts((n + block - 1) / block);
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t p) {
    const MapPredicates map(projected);
    Coverage coverage(mesh, shown);
    std::vector<PixelPoint> ring;
    for (std::size_t k = p * block; k < std::min((p + 1) * block, n); ++k) {
      const Fragment& fragment = fragments.fragments[k];
      coverage.begin();
      for (std::uint32_t r = fragment.first_ring; r < fragment.end_ring; ++r) {
        ring.clear();
        for (const MapCorner& c : fragments.rings[r]) {
          const Point3 q = c.at.is_vertex ? projected.point(c.at.vertex) : map.point(c.at, fragment.facet).p;
          ring.push_back({signs.column_of(q).value + 0.5, signs.row_of(q).value + 0.5});
        }
        for (std::size_t m = 0; m < ring.size(); ++m) {
          const PixelPoint &from = ring[m], &to = ring[(m + 1) % ring.size()];
          coverage.add(from, to);
          parts[p].boundary += std::hypot(to.x - from.x, to.y - from.y) / 2;
        }
      }
      coverage.finish(fragment.facet, parts[p]);
    }
  });
  for (const AreaCheck& part : parts) {
    all.visible += part.visible;
    all.wrong += part.wrong;
    all.boundary += part.boundary;
  }
  return all;
}

}  // namespace hsr::internal
