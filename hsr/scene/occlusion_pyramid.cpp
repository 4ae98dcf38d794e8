// The grid of hidden tiles, and what is asked of it; occlusion_pyramid_cover.cpp covers it.
#include "hsr/scene/occlusion_pyramid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/error_bounded.h"
#include "geometry/parallel.h"
#include "hsr/scene/affine_depth.h"

namespace hsr::internal {

namespace {

constexpr double u = ErrorBounded::u;
constexpr std::size_t coarse = 1;  // the level of hidden_from

bool is_convertible(double x) { return std::fabs(x) < 0x1p30; }

}  // namespace

/// Estimated first, then settled by the borders themselves: no rounding of the quotient matters.
std::int32_t OcclusionPyramid::Axis::last_border_up_to(double x) const {
  const double estimate = (x - first) * per_width;
  if (!is_convertible(estimate)) return x < first ? -1 : tiles;
  std::int32_t i = std::clamp(static_cast<std::int32_t>(estimate), -1, tiles);
  while (i >= 0 && border(i) > x) --i;
  while (i < tiles && border(i + 1) <= x) ++i;
  return i;
}

std::int32_t OcclusionPyramid::Axis::first_border_from(double x) const {
  const double estimate = (x - first) * per_width;
  if (!is_convertible(estimate)) return x > first ? tiles + 1 : 0;
  std::int32_t i = std::clamp(static_cast<std::int32_t>(estimate), 0, tiles + 1);
  while (i <= tiles && border(i) < x) ++i;
  while (i > 0 && border(i - 1) >= x) --i;
  return i;
}

OcclusionPyramid::OcclusionPyramid(const ProjectedMesh& projected, bool always) : projected_(projected) {
  if (!(projected.image_error() < HUGE_VAL)) return;  // another arithmetic is asked for, or doubles do not reach
  choose_grid(always);
  if (levels_.empty()) return;
  cover_all();
  build_levels();
}

OcclusionPyramid::Rectangle OcclusionPyramid::rectangle(std::span<const VertexId> vertices) const {
  Rectangle r = {{HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL}};
  for (const VertexId v : vertices) {
    const ImagePoint p = on_grid(projected_.image(v));
    r.low = {std::min(r.low[0], p.x), std::min(r.low[1], p.y)};
    r.high = {std::max(r.high[0], p.x), std::max(r.high[1], p.y)};
  }
  return grown(r, projected_.image_error());
}

/// Around a triangle, and another one if there is.
OcclusionPyramid::Rectangle OcclusionPyramid::rectangle(TriangleId t, TriangleId s) const {
  Rectangle r = rectangle(projected_.mesh().triangles[t]);
  if (!s.is_valid()) return r;
  const Rectangle other = rectangle(projected_.mesh().triangles[s]);
  for (std::size_t k = 0; k < 2; ++k) {
    r.low[k] = std::min(r.low[k], other.low[k]);
    r.high[k] = std::max(r.high[k], other.high[k]);
  }
  return r;
}

OcclusionPyramid::Rectangle OcclusionPyramid::grown(Rectangle r, double error) const {
  if (error == 0) return r;
  for (std::size_t k = 0; k < 2; ++k) {
    r.low[k] -= error * 1.01 + 2 * u * std::fabs(r.low[k]);
    r.high[k] += error * 1.01 + 2 * u * std::fabs(r.high[k]);
  }
  return r;
}

/// Off by a rounding, and -infinity where it is not known.
double OcclusionPyramid::affine(float nearness) const {
  if (!projected_.is_perspective()) return nearness;
  return nearness < 0 ? -1 / static_cast<double>(nearness) : HUGE_VAL;
}

AffineDepth OcclusionPyramid::plane_nearness(TriangleId t, const Rectangle& around) const {
  const auto& c = projected_.mesh().triangles[t];
  DepthCorners corners;
  corners.image_error = projected_.image_error();
  for (std::size_t k = 0; k < 3; ++k) {
    const ImageBox& box = projected_.box(c[k]);
    corners.image[k] = on_grid(projected_.image(c[k]));
    corners.low[k] = affine(box.farthest);
    corners.high[k] = affine(box.nearest);
    if (projected_.is_perspective()) {  // reciprocals, which are positive
      corners.low[k] *= 1 - 4 * u;
      corners.high[k] *= 1 + 4 * u;
    }
  }
  // Tiles reach beyond the triangle by less than a tile.
  const double width = around.high[0] - around.low[0] + axes_[0].width,
               height = around.high[1] - around.low[1] + axes_[1].width;
  const auto reach = [&](std::size_t k, double size) {
    return size + std::fabs(around.low[k]) + std::fabs(around.high[k]) + std::fabs(axes_[k].first) +
           axes_[k].tiles * axes_[k].width;
  };
  return affine_depth(corners, reach(0, width), reach(1, height));
}

/// At most 24 tiles to a triangle, over the middle of the image: in perspective a few triangles may lie far out.
void OcclusionPyramid::choose_grid(bool always) {
  const Mesh& mesh = projected_.mesh();
  std::array<std::vector<double>, 2> low, high;
  double area = 0;
  const std::size_t step = std::max<std::size_t>(1, mesh.triangles.size() / 8192);
  for (std::size_t i = 0; i < mesh.triangles.size(); i += step) {
    if (projected_.reaches_before_near(TriangleId(i))) continue;
    const Rectangle r = rectangle(mesh.triangles[TriangleId(i)]);
    for (std::size_t k = 0; k < 2; ++k) {
      low[k].push_back(r.low[k]);
      high[k].push_back(r.high[k]);
    }
    if (projected_.facing(TriangleId(i)) != Sign::zero) area += (r.high[0] - r.low[0]) * (r.high[1] - r.low[1]) / 2;
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
  // So many that to cover them, as often as there are layers, takes some 192 steps for each triangle.
  const double tiles = std::clamp(std::min(24 * n, 192 * n / layers), 1024.0, 0x1p23);
  const double columns = std::clamp(std::sqrt(tiles * extent[0] / extent[1]), 1.0, std::min(tiles, 0x1p20));
  axes_[0].tiles = static_cast<std::int32_t>(columns);
  axes_[1].tiles = static_cast<std::int32_t>(std::max(1.0, tiles / columns));
  for (std::size_t k = 0; k < 2; ++k) {
    axes_[k].width = extent[k] / axes_[k].tiles;
    axes_[k].per_width = 1 / axes_[k].width;
    axes_[k].slack = 8 * u * (std::fabs(axes_[k].first) + extent[k]) * axes_[k].per_width;
    // Borders ascend, each a tile apart but for rounding.
    if (!(axes_[k].width > 64 * u * (std::fabs(axes_[k].first) + extent[k]))) return;
  }
  Level level{axes_[0].tiles, axes_[1].tiles, {}};
  level.nearness.assign(static_cast<std::size_t>(level.columns) * static_cast<std::size_t>(level.rows), no_occluder);
  levels_.push_back(std::move(level));
}

/// Each level says for four tiles of the one below what it can say of all of them.
void OcclusionPyramid::build_levels() {
  constexpr float infinity = -no_occluder;
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

/// The tiles that a rectangle touches, but where it only touches a border, those on one side of it: each will do. False: it
/// reaches beyond the grid.
bool OcclusionPyramid::is_inside(const Rectangle& r, std::array<Tiles, 2>& range) const {
  for (std::size_t k = 0; k < 2; ++k) {
    if (projected_.image_error() > 0) {
      // As in between().
      const double first = (r.low[k] - axes_[k].first) * axes_[k].per_width - axes_[k].slack,
                   last = (r.high[k] - axes_[k].first) * axes_[k].per_width + axes_[k].slack;
      if (!(first >= 0 && last < axes_[k].tiles)) return false;
      range[k] = {static_cast<std::int32_t>(first), static_cast<std::int32_t>(last)};
      continue;
    }
    const std::int32_t low = axes_[k].last_border_up_to(r.low[k]), high = axes_[k].first_border_from(r.high[k]);
    if (low < 0 || high > axes_[k].tiles) return false;
    range[k].first = std::min(low, axes_[k].tiles - 1);
    range[k].last = std::max(range[k].first, high - 1);
  }
  return true;
}

/// Those of `within` that have something between two values.
OcclusionPyramid::Tiles OcclusionPyramid::between(std::size_t k, double low, double high, const Tiles& within) const {
  const Axis& axis = axes_[k];
  if (projected_.image_error() == 0) {
    const std::int32_t first = std::clamp(axis.last_border_up_to(low), within.first, within.last);
    return {first, std::clamp(axis.first_border_from(high) - 1, first, within.last)};
  }
  // One more on a side, now and then, does no harm where nothing lies on a border exactly.
  const double first = within.first, last = within.last;
  const auto tile = [&](double x) { return static_cast<std::int32_t>(x > first ? x < last ? x : last : first); };
  return {tile((low - axis.first) * axis.per_width - axis.slack), tile((high - axis.first) * axis.per_width + axis.slack)};
}

bool OcclusionPyramid::hides(const std::array<Tiles, 2>& range, float nearest) const {
  // Start where it meets at most two tiles in each direction.
  std::size_t top = 0;
  const auto spans_more_than_two = [&](const Tiles& r) { return (r.last >> top) - (r.first >> top) > 1; };
  while (top + 1 < levels_.size() && (spans_more_than_two(range[0]) || spans_more_than_two(range[1]))) ++top;
  for (std::int32_t j = range[1].first >> top; j <= range[1].last >> top; ++j)
    for (std::int32_t i = range[0].first >> top; i <= range[0].last >> top; ++i)
      if (!hides(top, i, j, range, nearest)) return false;
  return true;
}

bool OcclusionPyramid::hides(std::size_t k, std::int32_t i, std::int32_t j, const std::array<Tiles, 2>& range,
                             float nearest) const {
  if (levels_[k].at(i, j) > nearest) return true;
  if (k == 0) return false;
  for (std::int32_t y = std::max(2 * j, range[1].first >> (k - 1)); y <= std::min(2 * j + 1, range[1].last >> (k - 1)); ++y)
    for (std::int32_t x = std::max(2 * i, range[0].first >> (k - 1)); x <= std::min(2 * i + 1, range[0].last >> (k - 1)); ++x)
      if (!hides(k - 1, x, y, range, nearest)) return false;
  return true;
}

/// Whether a look at one tile tells that something is not hidden: where it is in the middle. @param nearness affine
bool OcclusionPyramid::is_before(const ImagePoint& p, double nearness) const {
  const auto at = [&](std::size_t k, double x) {
    const double i = (x - axes_[k].first) * axes_[k].per_width;
    return i >= 0 && i < axes_[k].tiles ? static_cast<std::int32_t>(i) : -1;
  };
  const std::int32_t i = at(0, p.x), j = at(1, p.y);
  return i < 0 || j < 0 || !(levels_[0].at(i, j) > nearness);
}

/// Calls visit(column, row, nearness) for the tiles that a triangle touches, with how near it is there at most. Row by row, what of the
/// triangle lies in each tile: it is widest along its sides. Stops where a visit returns false. @param around @param range @param n of t
template <class F>
bool OcclusionPyramid::visit_tiles(TriangleId t, const Rectangle& around, const std::array<Tiles, 2>& range,
                                   const AffineDepth& n, const F& visit) const {
  const auto& c = projected_.mesh().triangles[t];
  const double error = 2 * projected_.image_error();
  struct Side {
    ImagePoint p;
    double left, right, low, high, slope, slack;
  };
  std::array<Side, 3> sides;
  for (std::size_t k = 0; k < 3; ++k) {
    const ImagePoint p = on_grid(projected_.image(c[k])), q = on_grid(projected_.image(c[(k + 1) % 3]));
    const double slope = (q.x - p.x) / (q.y - p.y);
    sides[k] = {p,
                std::min(p.x, q.x) - error,
                std::max(p.x, q.x) + error,
                std::min(p.y, q.y) - error,
                std::max(p.y, q.y) + error,
                slope,
                error * (2 + 2 * std::fabs(slope)) +
                    16 * u *
                        (std::fabs(p.x) + std::fabs(q.x) +
                         std::fabs(slope) * (std::fabs(p.y) + std::fabs(around.low[1]) + std::fabs(around.high[1])))};
  }
  for (std::int32_t j = range[1].first; j <= range[1].last; ++j) {
    const double low = std::max(axes_[1].border(j), around.low[1]), high = std::min(axes_[1].border(j + 1), around.high[1]);
    double from = around.high[0], to = around.low[0];
    for (const Side& side : sides) {
      if (side.low > high || side.high < low) continue;
      const double at_low = side.p.x + side.slope * (low - side.p.y), at_high = side.p.x + side.slope * (high - side.p.y);
      const double left = std::min(at_low, at_high) - side.slack, right = std::max(at_low, at_high) + side.slack;
      // Not where the slope is no number.
      from = std::min(from, left > side.left ? left : side.left);
      to = std::max(to, right < side.right ? right : side.right);
    }
    const Tiles row = between(0, from, to, range[0]);
    const double y = axes_[1].border(n.dy > 0 ? j + 1 : j), at_row = n.value + n.dy * (y - n.p.y) - n.dx * n.p.x;
    for (std::int32_t i = row.first; i <= row.last; ++i) {
      const double x = axes_[0].border(n.dx > 0 ? i + 1 : i);
      if (!visit(i, j, float_above(n.at_most(at_row + n.dx * x)))) return false;
    }
  }
  return true;
}

bool OcclusionPyramid::hides(TriangleId t) const {
  if (levels_.empty() || projected_.reaches_before_near(t)) return false;
  const auto& c = projected_.mesh().triangles[t];
  const ImagePoint a = on_grid(projected_.image(c[0])), b = on_grid(projected_.image(c[1])),
                   d = on_grid(projected_.image(c[2]));
  const auto farthest = [&](VertexId v) { return affine(projected_.box(v).farthest); };
  if (is_before({(a.x + b.x + d.x) / 3, (a.y + b.y + d.y) / 3}, (farthest(c[0]) + farthest(c[1]) + farthest(c[2])) / 3))
    return false;
  const Rectangle around = rectangle(c);
  std::array<Tiles, 2> range;
  if (!is_inside(around, range)) return false;
  const AffineDepth n = plane_nearness(t, around);
  if (hides(range, float_above(n.nearest))) return true;
  return visit_tiles(t, around, range, n,
                     [&](std::int32_t i, std::int32_t j, float nearest) { return levels_[0].at(i, j) > nearest; });
}

OcclusionPyramid::Grid OcclusionPyramid::grid() const {
  Grid grid;
  if (levels_.empty()) return grid;
  grid.corner = {-axes_[0].first, axes_[1].first};
  grid.column = -axes_[0].width;
  grid.row = axes_[1].width;
  grid.columns = levels_[0].columns;
  grid.rows = levels_[0].rows;
  grid.nearness = levels_[0].nearness;
  if (projected_.is_perspective())
    for (float& x : grid.nearness) x = x > 0 ? float_below(-1 / static_cast<double>(x)) : no_occluder;
  return grid;
}

std::vector<OcclusionPyramid::TouchedTile> OcclusionPyramid::touched(TriangleId t) const {
  std::vector<TouchedTile> tiles;
  if (levels_.empty() || projected_.reaches_before_near(t)) return tiles;
  const Rectangle around = rectangle(projected_.mesh().triangles[t]);
  std::array<Tiles, 2> range;
  if (!is_inside(around, range)) return tiles;
  visit_tiles(t, around, range, plane_nearness(t, around), [&](std::int32_t i, std::int32_t j, float nearest) {
    tiles.push_back({i, j, levels_[0].at(i, j) > nearest});
    return true;
  });
  return tiles;
}

/// Walks along pq on one level, column by column, or row by row where it is steep: start(shares) of the column, and then
/// visit(nearness, shares) for its tiles along pq; shares() are those of the way from p to q between which pq is in the column.
/// Stops where a visit returns false. False: it did, or pq reaches beyond the grid.
template <class S, class F>
bool OcclusionPyramid::walk_along(std::size_t level, const ImagePoint& p, const ImagePoint& q, double error, const S& start,
                                  const F& visit) const {
  if (!(error < HUGE_VAL)) return false;
  const Rectangle around = grown({{std::min(p.x, q.x), std::min(p.y, q.y)}, {std::max(p.x, q.x), std::max(p.y, q.y)}}, error);
  std::array<Tiles, 2> range;
  if (!is_inside(around, range)) return false;
  const std::size_t main = range[0].last - range[0].first >= range[1].last - range[1].first ? 0 : 1, other = 1 - main;
  const std::array<double, 2> a = {p.x, p.y}, d = {q.x - p.x, q.y - p.y};
  const double per_length = 1 / d[main], slope = d[other] * per_length, length = std::fabs(d[main]);
  const double slack = error * (2.1 + 2.1 * std::fabs(slope)) +
                       16 * u * (std::fabs(a[other]) + std::fabs(d[other]) + std::fabs(slope * a[main]));
  // Where the ends are off by the error, a share of the way is by a little more than three times that.
  const double share_slack = length > 8 * error ? (4 * error + 16 * u * (std::fabs(a[main]) + length)) / length
                                                : std::numeric_limits<double>::infinity();
  const std::array<std::size_t, 2> stride = {1, static_cast<std::size_t>(levels_[level].columns)};
  const std::int32_t tiles = axes_[main].tiles;
  for (std::int32_t k = range[main].first >> level; k <= range[main].last >> level; ++k) {
    const double low = std::max(axes_[main].border(k << level), around.low[main]) - a[main],
                 high = std::min(axes_[main].border(std::min((k + 1) << level, tiles)), around.high[main]) - a[main];
    const double at_low = slope * low, at_high = slope * high;
    const double least = a[other] + std::min(at_low, at_high) - slack, most = a[other] + std::max(at_low, at_high) + slack;
    // Not where the slope is no number.
    const Tiles across = between(other, least > around.low[other] ? least : around.low[other],
                                 most < around.high[other] ? most : around.high[other], range[other]);
    const auto shares = [&] {
      const double low_share = low * per_length, high_share = high * per_length;
      return Shares{std::min(low_share, high_share), std::max(low_share, high_share), share_slack};
    };
    start(shares);
    const float* tile = levels_[level].nearness.data() + static_cast<std::size_t>(k) * stride[main];
    for (std::int32_t m = across.first >> level; m <= across.last >> level; ++m)
      if (!visit(tile[static_cast<std::size_t>(m) * stride[other]], shares)) return false;
  }
  return true;
}

/// How near a segment is along the way from its one end to the other: between them that changes evenly.
class OcclusionPyramid::AlongSegment {
 public:
  /// @param a @param b at most, affine
  AlongSegment(double a, double b) : a_(a), b_(b), nearest_(std::max(a, b)), slack_(16 * u * (std::fabs(a) + std::fabs(b))) {}

  float at_most() const { return float_above(nearest_ + slack_); }
  /// Between two shares of the way, which may be a little beyond its ends.
  float at_most(const Shares& shares) const {
    const double low = shares.low - shares.error, high = shares.high + shares.error;
    const double at_low = a_ + low * (b_ - a_), at_high = a_ + high * (b_ - a_), most = std::max(at_low, at_high);
    // Not where the shares are no numbers: then the nearer end bounds all.
    return float_above((std::isfinite(at_low) && std::isfinite(at_high) && most < nearest_ ? most : nearest_) + slack_);
  }
  double middle() const { return (a_ + b_) / 2; }

 private:
  double a_, b_, nearest_, slack_;
};

bool OcclusionPyramid::hides(const Edge& e) const {
  if (levels_.empty() || projected_.beyond_near(e.a) == Sign::negative || projected_.beyond_near(e.b) == Sign::negative)
    return false;
  return hides(on_grid(projected_.image(e.a)), projected_.box(e.a).nearest, on_grid(projected_.image(e.b)),
               projected_.box(e.b).nearest, projected_.image_error());
}

bool OcclusionPyramid::hides(const BoundedPoint3& a, const BoundedPoint3& b) const {
  const BoundedPoint2 p = projected_.image(a.p, 3 * a.error), q = projected_.image(b.p, 3 * b.error);
  const double error = std::max(p.error, q.error);
  return error < HUGE_VAL && hides(on_grid(p.p), projected_.box(a.p, 3 * a.error).nearest, on_grid(q.p),
                                   projected_.box(b.p, 3 * b.error).nearest, error);
}

/// @param error of each coordinate @param nearness_of_p at most, as boxes have it
bool OcclusionPyramid::hides(const ImagePoint& p, float nearness_of_p, const ImagePoint& q, float nearness_of_q,
                             double error) const {
  const AlongSegment nearness(affine(nearness_of_p), affine(nearness_of_q));
  if (levels_.empty() || is_before({(p.x + q.x) / 2, (p.y + q.y) / 2}, nearness.middle())) return false;
  const float nearest = nearness.at_most();
  return walk_along(
      0, p, q, error, [](const auto&) {},
      [&](float tile, const auto& shares) { return tile > nearest || tile > nearness.at_most(shares()); });
}

bool OcclusionPyramid::unhidden(const Edge& e, std::vector<UnhiddenInterval>& parts) const {
  constexpr std::int32_t fewest = 3;  // columns of tiles that are worth leaving out
  parts.clear();
  if (levels_.empty() || projected_.beyond_near(e.a) == Sign::negative || projected_.beyond_near(e.b) == Sign::negative)
    return false;
  const AlongSegment nearness(affine(projected_.box(e.a).nearest), affine(projected_.box(e.b).nearest));
  const float nearest = nearness.at_most();
  struct Column {
    double low, high;
    float least = -no_occluder;  // of what hides
    bool is_hidden = true;
  };
  std::optional<Column> column;
  float before = -no_occluder;           // least of the column before
  std::int32_t hidden_columns = fewest;  // since the last part
  float hidden_least = -no_occluder;     // of these
  const auto end_column = [&] {
    if (!column) return;
    const float least = column->least;
    if (column->is_hidden) {
      if (hidden_columns++ == 0) parts.back().hidden_from = std::min(parts.back().hidden_from, least);
      hidden_least = std::min(hidden_least, least);
    } else {
      if (hidden_columns >= fewest)
        parts.push_back({column->low, column->high, 0, 0, std::min(before, least)});
      else
        parts.back().hidden_from = std::min({parts.back().hidden_from, hidden_least, least});
      UnhiddenInterval& part = parts.back();
      part.from = std::min(part.from, column->low);
      part.to = std::max(part.to, column->high);
      hidden_columns = 0;
      hidden_least = -no_occluder;
    }
    before = least;
  };
  double widest = 0, error = 0;
  const bool is_known = walk_along(
      std::min<std::size_t>(coarse, levels_.size() - 1), on_grid(projected_.image(e.a)), on_grid(projected_.image(e.b)),
      projected_.image_error(),
      [&](const auto& shares) {
        end_column();
        const Shares here = shares();
        column = {here.low - here.error, here.high + here.error};
        widest = std::max(widest, here.high - here.low);
        error = here.error;
      },
      [&](float tile, const auto& shares) {
        column->least = std::min(column->least, tile);
        column->is_hidden = column->is_hidden && (tile > nearest || tile > nearness.at_most(shares()));
        return std::isfinite(column->low) && std::isfinite(column->high);
      });
  // A margin lies within the next column, whatever was rounded.
  if (!is_known || !(error < widest / 16)) {
    parts.clear();
    return false;
  }
  end_column();
  if (!parts.empty() && parts.front().from > parts.back().from) std::reverse(parts.begin(), parts.end());
  for (UnhiddenInterval& part : parts) {
    // Never beyond an end: in perspective the edge may have its horizon there.
    const auto share = [](double x) { return x <= 0 ? -HUGE_VAL : x >= 1 ? HUGE_VAL : x; };
    part.low = share(part.from - widest / 4);
    part.high = share(part.to + widest / 4);
    part.from = share(part.from);
    part.to = share(part.to);
    if (!projected_.is_perspective()) continue;
    part.hidden_from = part.hidden_from > 0 ? float_below(-1 / static_cast<double>(part.hidden_from)) : no_occluder;
  }
  return true;
}

float OcclusionPyramid::hidden_from(const ImagePoint& p, const ImagePoint& q, double error) const {
  if (levels_.empty()) return no_occluder;
  float least = -no_occluder;
  // Beside a segment on a border are the tiles on both sides of it.
  // Larger tiles say nearly as much, and there are fewer.
  const bool is_known = walk_along(
      std::min<std::size_t>(coarse, levels_.size() - 1), on_grid(p), on_grid(q),
      error + 0x1p-20 * (axes_[0].width + axes_[1].width), [](const auto&) {},
      [&](float tile, const auto&) {
        least = std::min(least, tile);
        return least > no_occluder;
      });
  if (!is_known) return no_occluder;
  if (!projected_.is_perspective()) return least;
  return least > 0 ? float_below(-1 / static_cast<double>(least)) : no_occluder;
}

void OcclusionPyramid::mark_hidden(std::vector<std::uint8_t>& hidden) const {
  const Mesh& mesh = projected_.mesh();
  hidden.resize(mesh.triangles.size(), 0);
  parallel_for_each(mesh.faces.size(), [&](std::size_t f) {
    const std::uint32_t first = mesh.first_triangle[FaceId(f)], end = mesh.first_triangle[FaceId(f + 1)];
    for (std::uint32_t t = first; t < end; ++t)
      if (!hides(TriangleId(t))) return;
    std::fill(hidden.begin() + first, hidden.begin() + end, std::uint8_t{1});
  });
}

}  // namespace hsr::internal
