#include "hsr/lines/hidden_tiles.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/error_bounded.h"
#include "hsr/parallel.h"

namespace hsr {

namespace {

using Range = tbb::blocked_range<std::size_t>;
constexpr float nowhere = -std::numeric_limits<float>::infinity();
constexpr double u = ErrorBounded::u;

void raise(float& place, float value) {
  std::atomic_ref<float> shared(place);
  float now = shared.load(std::memory_order_relaxed);
  while (now < value && !shared.compare_exchange_weak(now, value, std::memory_order_relaxed)) {
  }
}

std::optional<Edge> common_side(const std::array<VertexId, 3>& t, const std::array<VertexId, 3>& s) {
  std::array<VertexId, 2> common;
  std::size_t count = 0;
  for (const VertexId v : t)
    if (v == s[0] || v == s[1] || v == s[2]) {
      if (count == 2) return std::nullopt;
      common[count++] = v;
    }
  if (count != 2) return std::nullopt;
  return Edge{std::min(common[0], common[1]), std::max(common[0], common[1])};
}

bool is_convertible(double x) { return std::fabs(x) < 0x1p30; }

}  // namespace

/// Estimated first, then settled by the borders themselves: no rounding of the quotient matters.
std::int32_t HiddenTiles::Axis::last_border_up_to(double x) const {
  const double estimate = (x - first) / width;
  if (!is_convertible(estimate)) return x < first ? -1 : tiles;
  std::int32_t i = std::clamp(static_cast<std::int32_t>(estimate), -1, tiles);
  while (i >= 0 && border(i) > x) --i;
  while (i < tiles && border(i + 1) <= x) ++i;
  return i;
}

std::int32_t HiddenTiles::Axis::first_border_from(double x) const {
  const double estimate = (x - first) / width;
  if (!is_convertible(estimate)) return x > first ? tiles + 1 : 0;
  std::int32_t i = std::clamp(static_cast<std::int32_t>(estimate), 0, tiles + 1);
  while (i <= tiles && border(i) < x) ++i;
  while (i > 0 && border(i - 1) >= x) --i;
  return i;
}

/// What lies to the left of some lines, each through two images.
class HiddenTiles::Region {
 public:
  /// With images off by at most E, det(q - p, c - p) is off by at most 2.1 E (|q - p|_1 + |c - p|_1) + 9 E^2, and its roundings
  /// by 8 u |q - p|_1 |c - p|_1. @param reach bounds |c - p|_1
  void add(const ImagePoint& p, const ImagePoint& q, double error, double reach) {
    const double dx = q.x - p.x, dy = q.y - p.y, length = std::fabs(dx) + std::fabs(dy);
    // A line along an axis needs comparisons only.
    const double margin = dx == 0 || dy == 0 ? 2.2 * error * (length + reach) + 10 * error * error
                                             : 2.2 * error * (length + reach) + 10 * error * error + 16 * u * length * reach;
    lines_[count_++] = {p.x, p.y, dx, dy, margin};
  }

  /// Of a row of tiles from y = low to y = high, between which x lies what is certainly inside.
  void narrow(double low, double high, double& from, double& to) const {
    for (std::size_t k = 0; k < count_; ++k) {
      const Line& l = lines_[k];
      if (l.dy == 0) {
        const double shift = l.margin / l.dx, slack = l.margin == 0 ? 0 : 4 * u * (std::fabs(l.py) + std::fabs(shift));
        const bool inside = l.dx > 0 ? low >= l.py + shift + slack : l.dx < 0 && high <= l.py + shift - slack;
        if (!inside) to = -HUGE_VAL;
        continue;
      }
      // dx (y - py) - dy (x - px) >= margin, at the corner of a tile where it is least.
      const double shift = (l.dx == 0 ? -l.margin : l.dx * ((l.dx > 0 ? low : high) - l.py) - l.margin) / l.dy;
      const double slack = l.dx == 0 && l.margin == 0 ? 0 : 4 * u * (std::fabs(l.px) + std::fabs(shift));
      if (l.dy > 0)
        to = std::min(to, l.px + shift - slack);
      else
        from = std::max(from, l.px + shift + slack);
    }
  }

 private:
  struct Line {
    double px, py, dx, dy, margin;
  };
  std::array<Line, 4> lines_;
  std::size_t count_ = 0;
};

HiddenTiles::HiddenTiles(const Sight& sight, std::span<const ImageBox> boxes, bool always) : sight_(sight) {
  if (!(sight.image_error() < HUGE_VAL)) return;  // another arithmetic is asked for, or doubles do not reach
  choose_grid(always);
  if (levels_.empty()) return;
  cover_triangles(boxes);
  cover_pairs(boxes);
  build_levels();
}

HiddenTiles::Rectangle HiddenTiles::rectangle(std::span<const VertexId> vertices) const {
  Rectangle r = {{HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL}};
  for (const VertexId v : vertices) {
    const ImagePoint& p = sight_.image(v);
    r.low = {std::min(r.low[0], p.x), std::min(r.low[1], p.y)};
    r.high = {std::max(r.high[0], p.x), std::max(r.high[1], p.y)};
  }
  const double error = sight_.image_error();
  if (error == 0) return r;
  for (std::size_t k = 0; k < 2; ++k) {
    r.low[k] -= error * 1.01 + 2 * u * std::fabs(r.low[k]);
    r.high[k] += error * 1.01 + 2 * u * std::fabs(r.high[k]);
  }
  return r;
}

/// At most eight tiles to a triangle, over the middle of the image: in perspective a few triangles may lie far out.
void HiddenTiles::choose_grid(bool always) {
  const Mesh& mesh = sight_.mesh();
  std::array<std::vector<double>, 2> low, high;
  double area = 0;
  const std::size_t step = std::max<std::size_t>(1, mesh.triangles.size() / 8192);
  for (std::size_t i = 0; i < mesh.triangles.size(); i += step) {
    if (sight_.reaches_before_near(TriangleId(i))) continue;
    const Rectangle r = rectangle(mesh.triangles[TriangleId(i)]);
    for (std::size_t k = 0; k < 2; ++k) {
      low[k].push_back(r.low[k]);
      high[k].push_back(r.high[k]);
    }
    if (sight_.facing(TriangleId(i)) != Sign::zero) area += (r.high[0] - r.low[0]) * (r.high[1] - r.low[1]) / 2;
  }
  if (low[0].empty()) return;
  const auto share = [](std::vector<double>& x, double at) {
    const auto k = x.begin() + static_cast<std::ptrdiff_t>(at * static_cast<double>(x.size() - 1));
    std::nth_element(x.begin(), k, x.end());
    return *k;
  };
  std::array<double, 2> extent;
  for (std::size_t k = 0; k < 2; ++k) {
    axes_[k].first = share(low[k], 0.001);
    extent[k] = share(high[k], 0.999) - axes_[k].first;
  }
  if (!(extent[0] > 0 && extent[1] > 0) || !std::isfinite(extent[0] * extent[1])) return;
  const double n = static_cast<double>(mesh.triangles.size());
  const double layers = n / static_cast<double>(low[0].size()) * area / (extent[0] * extent[1]);
  if (!always && layers < 3) return;  // little to hide
  // So many that to cover them, as often as there are layers, takes some 64 steps for each triangle.
  const double tiles = std::clamp(std::min(8 * n, 64 * n / layers), 1024.0, 0x1p23);
  const double columns = std::clamp(std::sqrt(tiles * extent[0] / extent[1]), 1.0, std::min(tiles, 0x1p20));
  axes_[0].tiles = static_cast<std::int32_t>(columns);
  axes_[1].tiles = static_cast<std::int32_t>(std::max(1.0, tiles / columns));
  for (std::size_t k = 0; k < 2; ++k) {
    axes_[k].width = extent[k] / axes_[k].tiles;
    // Borders ascend, each a tile apart but for rounding.
    if (!(axes_[k].width > 64 * u * (std::fabs(axes_[k].first) + extent[k]))) return;
  }
  Level level{axes_[0].tiles, axes_[1].tiles, {}};
  level.nearness.assign(static_cast<std::size_t>(level.columns) * static_cast<std::size_t>(level.rows), nowhere);
  levels_.push_back(std::move(level));
}

void HiddenTiles::cover_triangles(std::span<const ImageBox> boxes) {
  const Mesh& mesh = sight_.mesh();
  tbb::parallel_for(Range(0, mesh.triangles.size(), 1024), [&](const Range& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const TriangleId t(i);
      if (sight_.facing(t) == Sign::zero || sight_.reaches_before_near(t)) continue;
      const auto& c = mesh.triangles[t];
      const Rectangle around = rectangle(c);
      const double reach = around.high[0] - around.low[0] + around.high[1] - around.low[1];
      // The images turn as O says: with a positive sign the inside lies to the left.
      const bool left = sight_.facing(t) == Sign::positive;
      Region region;
      for (std::size_t k = 0; k < 3; ++k)
        region.add(sight_.image(c[left ? k : (k + 1) % 3]), sight_.image(c[left ? (k + 1) % 3 : k]), sight_.image_error(),
                   reach);
      cover(region, around, boxes[i].farthest);
    }
  });
}

/// Two triangles on opposite sides of their common edge hide together what lies within their four other sides: to one side of
/// the edge it lies within the one, to the other within the other.
void HiddenTiles::cover_pair(TriangleId t, TriangleId s, const Edge& edge, std::span<const ImageBox> boxes) {
  const Mesh& mesh = sight_.mesh();
  const std::array<VertexId, 4> corners = {edge.a, edge.b, mesh.apex(t, edge), mesh.apex(s, edge)};
  const Rectangle around = rectangle(corners);
  const double reach = around.high[0] - around.low[0] + around.high[1] - around.low[1];
  Region region;
  std::array<bool, 2> is_left = {false, false};
  for (const std::size_t k : {0U, 1U}) {
    const TriangleId x = k == 0 ? t : s;
    if (sight_.facing(x) == Sign::zero || sight_.reaches_before_near(x)) return;
    const auto& c = mesh.triangles[x];
    const bool left = sight_.facing(x) == Sign::positive;
    for (std::size_t m = 0; m < 3; ++m) {
      const VertexId from = c[left ? m : (m + 1) % 3], to = c[left ? (m + 1) % 3 : m];
      if (from == edge.a && to == edge.b)
        is_left[k] = true;
      else if (!(from == edge.b && to == edge.a))
        region.add(sight_.image(from), sight_.image(to), sight_.image_error(), reach);
    }
  }
  if (is_left[0] != is_left[1]) cover(region, around, std::min(boxes[t.value].farthest, boxes[s.value].farthest));
}

void HiddenTiles::cover_pairs(std::span<const ImageBox> boxes) {
  const Mesh& mesh = sight_.mesh();
  tbb::parallel_for(Range(0, mesh.edges.size(), 1024), [&](const Range& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const auto triangles = mesh.triangles_at(EdgeId(i));
      if (triangles.size() == 2) cover_pair(triangles[0], triangles[1], mesh.edges[EdgeId(i)], boxes);
    }
  });
  // Inside a planar face the mesh has no edges: its triangles are paired here, as long as they are few.
  tbb::parallel_for(Range(0, mesh.faces.size(), 1024), [&](const Range& range) {
    for (std::size_t f = range.begin(); f < range.end(); ++f) {
      const std::uint32_t first = mesh.first_triangle[FaceId(f)], end = mesh.first_triangle[FaceId(f + 1)];
      if (mesh.faces[FaceId(f)] != FaceUse::planar || end - first > 8) continue;
      for (std::uint32_t t = first; t < end; ++t)
        for (std::uint32_t s = t + 1; s < end; ++s)
          if (const auto edge = common_side(mesh.triangles[TriangleId(t)], mesh.triangles[TriangleId(s)]))
            cover_pair(TriangleId(t), TriangleId(s), *edge, boxes);
    }
  });
}

void HiddenTiles::cover(const Region& region, const Rectangle& around, float nearness) {
  Level& level = levels_.front();
  const std::int32_t first_row = axes_[1].first_border_from(around.low[1]),
                     end_row = axes_[1].last_border_up_to(around.high[1]);
  for (std::int32_t j = first_row; j < end_row; ++j) {
    double from = around.low[0], to = around.high[0];
    region.narrow(axes_[1].border(j), axes_[1].border(j + 1), from, to);
    if (!(to - from >= axes_[0].width / 2)) continue;
    const std::int32_t begin = axes_[0].first_border_from(from), end = axes_[0].last_border_up_to(to);
    float* row = level.nearness.data() + static_cast<std::size_t>(j) * static_cast<std::size_t>(level.columns);
    for (std::int32_t i = begin; i < end; ++i) raise(row[i], nearness);
  }
}

/// Each level says for four tiles of the one below what it can say of all of them.
void HiddenTiles::build_levels() {
  constexpr float infinity = -nowhere;
  while (levels_.back().columns > 1 || levels_.back().rows > 1) {
    const Level& below = levels_.back();
    Level level{(below.columns + 1) / 2, (below.rows + 1) / 2, {}};
    level.nearness.assign(static_cast<std::size_t>(level.columns) * static_cast<std::size_t>(level.rows), infinity);
    for (std::int32_t j = 0; j < below.rows; ++j) {
      float* all = level.nearness.data() + static_cast<std::size_t>(j / 2) * static_cast<std::size_t>(level.columns);
      const float* row = below.nearness.data() + static_cast<std::size_t>(j) * static_cast<std::size_t>(below.columns);
      for (std::int32_t i = 0; i < below.columns; ++i) all[i / 2] = std::min(all[i / 2], row[i]);
    }
    levels_.push_back(std::move(level));
  }
}

bool HiddenTiles::hides(std::span<const VertexId> vertices, float nearest) const {
  if (levels_.empty()) return false;
  const Rectangle r = rectangle(vertices);
  std::array<std::int32_t, 4> range;  // of columns, of rows: first and last
  for (std::size_t k = 0; k < 2; ++k) {
    const std::int32_t low = axes_[k].last_border_up_to(r.low[k]), high = axes_[k].first_border_from(r.high[k]);
    if (low < 0 || high > axes_[k].tiles) return false;  // it reaches beyond the grid
    // Between borders low and high; a point on a border lies in the tiles on both sides, and one of them will do.
    range[2 * k] = std::min(low, axes_[k].tiles - 1);
    range[2 * k + 1] = std::max(range[2 * k], high - 1);
  }
  // Start where it meets at most two tiles in each direction.
  std::size_t top = 0;
  while (top + 1 < levels_.size() && ((range[1] >> top) - (range[0] >> top) > 1 || (range[3] >> top) - (range[2] >> top) > 1))
    ++top;
  for (std::int32_t j = range[2] >> top; j <= range[3] >> top; ++j)
    for (std::int32_t i = range[0] >> top; i <= range[1] >> top; ++i)
      if (!hides(top, i, j, range, nearest)) return false;
  return true;
}

bool HiddenTiles::hides(std::size_t k, std::int32_t i, std::int32_t j, const std::array<std::int32_t, 4>& range,
                        float nearest) const {
  const Level& level = levels_[k];
  if (level.nearness[static_cast<std::size_t>(j) * static_cast<std::size_t>(level.columns) + static_cast<std::size_t>(i)] >
      nearest)
    return true;
  if (k == 0) return false;
  for (std::int32_t y = std::max(2 * j, range[2] >> (k - 1)); y <= std::min(2 * j + 1, range[3] >> (k - 1)); ++y)
    for (std::int32_t x = std::max(2 * i, range[0] >> (k - 1)); x <= std::min(2 * i + 1, range[1] >> (k - 1)); ++x)
      if (!hides(k - 1, x, y, range, nearest)) return false;
  return true;
}

void HiddenTiles::mark_hidden(std::span<const ImageBox> boxes, std::vector<std::uint8_t>& hidden) const {
  const Mesh& mesh = sight_.mesh();
  hidden.resize(mesh.triangles.size(), 0);
  for_each(mesh.faces.size(), [&](std::size_t f) {
    const std::uint32_t first = mesh.first_triangle[FaceId(f)], end = mesh.first_triangle[FaceId(f + 1)];
    for (std::uint32_t t = first; t < end; ++t)
      if (sight_.reaches_before_near(TriangleId(t)) || !hides(mesh.triangles[TriangleId(t)], boxes[t].nearest)) return;
    std::fill(hidden.begin() + first, hidden.begin() + end, std::uint8_t{1});
  });
}

}  // namespace hsr
