// How tiles are covered by triangles, and by two that share an edge.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "hsr/scene/affine_depth.h"
#include "hsr/scene/occlusion_pyramid.h"

namespace hsr::internal {

namespace {

using Range = tbb::blocked_range<std::size_t>;
constexpr double u = ErrorBounded::u;

std::optional<Edge> common_side(const std::array<VertexId, 3>& t, const std::array<VertexId, 3>& s) {
  std::array<VertexId, 2> common;
  std::size_t count = 0;
  for (const VertexId v : t)
    if (is_one_of(v, s)) {
      if (count == 2) return std::nullopt;
      common[count++] = v;
    }
  if (count != 2) return std::nullopt;
  return Edge{std::min(common[0], common[1]), std::max(common[0], common[1])};
}

}  // namespace

/// What lies to the left of some lines on the grid, each through two places there.
class OcclusionPyramid::Region {
 public:
  /// With images off by at most E, det(q - p, c - p) is off by at most 2.1 E (|q - p|_1 + |c - p|_1) + 9 E^2, and its roundings
  /// by 8 u |q - p|_1 |c - p|_1. @param reach bounds |c - p|_1
  void add(const ImagePoint& p, const ImagePoint& q, double error, double reach) {
    const double dx = q.x - p.x, dy = q.y - p.y, length = std::fabs(dx) + std::fabs(dy);
    // A line along an axis needs comparisons only.
    const double margin = dx == 0 || dy == 0 ? 2.2 * error * (length + reach) + 10 * error * error
                                             : 2.2 * error * (length + reach) + 10 * error * error + 16 * u * length * reach;
    if (dy == 0) {
      const double shift = margin / dx, slack = margin == 0 ? 0 : 4 * u * (std::fabs(p.y) + std::fabs(shift));
      if (dx > 0) low_ = std::max(low_, p.y + shift + slack);
      if (!(dx > 0)) high_ = dx < 0 ? std::min(high_, p.y + shift - slack) : -HUGE_VAL;
      return;
    }
    lines_[count_++] = {p.x, p.y, dx / dy, margin / dy, dx == 0 && margin == 0 ? 0 : 8 * u, dy > 0, dx / dy > 0};
  }

  /// Of a row of tiles from y = low to y = high, between which x lies what is certainly inside.
  void narrow(double low, double high, double& from, double& to) const {
    if (!(low >= low_ && high <= high_)) to = -HUGE_VAL;
    for (std::size_t k = 0; k < count_; ++k) {
      const Line& l = lines_[k];
      // dx (y - py) - dy (x - px) >= margin, at the corner of a tile where it is least.
      const double along = l.slope * ((l.rises == l.bounds_right ? low : high) - l.py);
      const double slack = l.roundings * (std::fabs(l.px) + std::fabs(along) + std::fabs(l.shift));
      // Where the slope overflows and this is no number, nothing is certainly inside.
      const double x = l.px + along - l.shift + (l.bounds_right ? -slack : slack);
      if (l.bounds_right)
        to = x < to ? x : x >= to ? to : -HUGE_VAL;
      else
        from = x > from ? x : x <= from ? from : HUGE_VAL;
    }
  }

 private:
  struct Line {
    double px, py, slope, shift, roundings;
    bool bounds_right, rises;
  };
  std::array<Line, 4> lines_;
  std::size_t count_ = 0;
  double low_ = -HUGE_VAL, high_ = HUGE_VAL;
};

/// Calls visit(t, s) for what may cover tiles: triangles, s being none, and two that may share a side. Those of the edges and
/// faces begin to end of the mesh, the faces counted on after the edges.
template <class F>
void OcclusionPyramid::for_each_cover(std::size_t begin, std::size_t end, const F& visit) const {
  const Mesh& mesh = projected_.mesh();
  for (std::size_t i = begin; i < end; ++i) {
    if (i < mesh.edges.size()) {
      const auto triangles = mesh.triangles_at(EdgeId(i));
      if (triangles.size() == 2) visit(triangles[0], triangles[1]);
      continue;
    }
    const FaceId f(i - mesh.edges.size());
    const std::uint32_t first = mesh.first_triangle[f], last = mesh.first_triangle[FaceId(f.value + 1)];
    for (std::uint32_t t = first; t < last; ++t) visit(TriangleId(t), TriangleId());
    // Inside a planar face the mesh has no edges: its triangles are paired here, as long as they are few.
    if (mesh.faces[f] != FaceUse::planar || last - first > 8) continue;
    for (std::uint32_t t = first; t < last; ++t)
      for (std::uint32_t s = t + 1; s < last; ++s) visit(TriangleId(t), TriangleId(s));
  }
}

/// Band by band of rows, so that no two threads are at one tile and the tiles stay in the cache.
void OcclusionPyramid::cover_all() {
  struct Cover {
    TriangleId t, s;
  };
  const Mesh& mesh = projected_.mesh();
  const std::int32_t rows = axes_[1].tiles, rows_of_band = std::max(16, (rows + 63) / 64);
  const auto bands = static_cast<std::size_t>((rows + rows_of_band - 1) / rows_of_band);
  constexpr std::size_t block = 4096;
  const std::size_t n = mesh.edges.size() + mesh.faces.size();
  std::vector<std::vector<std::vector<Cover>>> covers((n + block - 1) / block);  // of each block, of each band
  tbb::parallel_for(Range(0, covers.size(), 1), [&](const Range& range) {
    for (std::size_t part = range.begin(); part < range.end(); ++part) {
      covers[part].resize(bands);
      for_each_cover(part * block, std::min(n, (part + 1) * block), [&](TriangleId t, TriangleId s) {
        for (const TriangleId x : {t, s})
          if (x.is_valid() && (projected_.facing(x) == Sign::zero || projected_.reaches_before_near(x))) return;
        if (s.is_valid() && !common_side(mesh.triangles[t], mesh.triangles[s])) return;
        const Rectangle around = rectangle(t, s);
        const std::int32_t first = axes_[1].first_border_from(around.low[1]), end = axes_[1].last_border_up_to(around.high[1]);
        for (std::int32_t band = first / rows_of_band; band * rows_of_band < end; ++band)
          covers[part][static_cast<std::size_t>(band)].push_back({t, s});
      });
    }
  });
  tbb::parallel_for(Range(0, bands, 1), [&](const Range& range) {
    for (std::size_t band = range.begin(); band < range.end(); ++band) {
      const std::int32_t first = static_cast<std::int32_t>(band) * rows_of_band, end = std::min(rows, first + rows_of_band);
      for (const auto& part : covers)
        for (const Cover& c : part[band])
          if (c.s.is_valid())
            cover_by_pair(c.t, c.s, {first, end - 1});
          else
            cover_by_triangle(c.t, {first, end - 1});
    }
  });
}

void OcclusionPyramid::cover_by_triangle(TriangleId t, const Tiles& rows) {
  const auto& c = projected_.mesh().triangles[t];
  const Rectangle around = rectangle(c);
  const double reach = around.high[0] - around.low[0] + around.high[1] - around.low[1];
  // Seen clockwise, the inside lies to the left on the grid.
  const bool left = projected_.facing(t) == Sign::negative;
  Region region;
  for (std::size_t k = 0; k < 3; ++k)
    region.add(on_grid(projected_.image(c[left ? k : (k + 1) % 3])), on_grid(projected_.image(c[left ? (k + 1) % 3 : k])),
               projected_.image_error(), reach);
  cover(region, around, rows, std::array{plane_nearness(t, around)});
}

/// Two triangles on opposite sides of their common edge hide together what lies within their four other sides: to one side of
/// the edge it lies within the one, to the other within the other.
void OcclusionPyramid::cover_by_pair(TriangleId t, TriangleId s, const Tiles& rows) {
  const Mesh& mesh = projected_.mesh();
  const Edge edge = *common_side(mesh.triangles[t], mesh.triangles[s]);
  const Rectangle around = rectangle(t, s);
  const double reach = around.high[0] - around.low[0] + around.high[1] - around.low[1];
  Region region;
  std::array<bool, 2> is_left = {false, false};
  for (const std::size_t k : {0U, 1U}) {
    const TriangleId x = k == 0 ? t : s;
    const auto& c = mesh.triangles[x];
    const bool left = projected_.facing(x) == Sign::negative;
    for (std::size_t m = 0; m < 3; ++m) {
      const VertexId from = c[left ? m : (m + 1) % 3], to = c[left ? (m + 1) % 3 : m];
      if (from == edge.a && to == edge.b)
        is_left[k] = true;
      else if (!(from == edge.b && to == edge.a))
        region.add(on_grid(projected_.image(from)), on_grid(projected_.image(to)), projected_.image_error(), reach);
    }
  }
  // In each of them the tile's part of the triangle is no farther than the plane is in the tile.
  if (is_left[0] != is_left[1]) cover(region, around, rows, std::array{plane_nearness(t, around), plane_nearness(s, around)});
}

template <std::size_t n>
void OcclusionPyramid::cover(const Region& region, const Rectangle& around, const Tiles& rows,
                             const std::array<AffineDepth, n>& planes) {
  Level& level = levels_.front();
  const std::int32_t first_row = std::max(rows.first, axes_[1].first_border_from(around.low[1])),
                     end_row = std::min(rows.last + 1, axes_[1].last_border_up_to(around.high[1]));
  for (std::int32_t j = first_row; j < end_row; ++j) {
    double from = around.low[0], to = around.high[0];
    const double low = axes_[1].border(j), high = axes_[1].border(j + 1);
    region.narrow(low, high, from, to);
    if (!(to - from >= axes_[0].width / 2)) continue;
    const std::int32_t begin = axes_[0].first_border_from(from), count = axes_[0].last_border_up_to(to) - begin;
    if (count <= 0) continue;
    // Each plane at the corner of the tile where it is farthest; in floats, whose roundings are subtracted first.
    std::array<float, n> base, step, farthest;
    for (std::size_t k = 0; k < n; ++k) {
      const AffineDepth& p = planes[k];
      const double x = axes_[0].border(p.dx > 0 ? begin : begin + 1), y = p.dy > 0 ? low : high;
      const double value = p.value + p.dx * (x - p.p.x) + p.dy * (y - p.p.y) - p.error, each = p.dx * axes_[0].width;
      const bool is_steady = std::fabs(each) * count < largest_float;  // or only its farthest corner tells
      base[k] = is_steady ? float_below(value - 0x1p-20 * (std::fabs(value) + std::fabs(each) * count)) : no_occluder;
      step[k] = is_steady ? static_cast<float>(each) : 0;
      farthest[k] = float_below(p.farthest);
    }
    float* row = level.nearness.data() + static_cast<std::size_t>(j) * static_cast<std::size_t>(level.columns) + begin;
    for (std::int32_t i = 0; i < count; ++i) {
      float least = largest_float;
      for (std::size_t k = 0; k < n; ++k) {
        const float value = base[k] + static_cast<float>(i) * step[k], bound = value > farthest[k] ? value : farthest[k];
        least = bound < least ? bound : least;
      }
      row[i] = row[i] > least ? row[i] : least;
    }
  }
}

}  // namespace hsr::internal
