#include "hsr/tiles/image_tiles.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "geometry/error.h"
#include "geometry/vector3.h"

namespace hsr::internal {

namespace {

BitRange with_sides(BitRange points, const ImageTiles& tiles, const View& view) {
  if (!view.viewpoint.is_direction) points.add(view.viewpoint.at);
  for (const ImageTiles::Side& side : tiles.sides) {
    points.add(side.c);
    points.add(side.d);
  }
  return points;
}

BitRange direction_of(const View& view) {
  BitRange bits;
  if (view.viewpoint.is_direction) bits.add(view.viewpoint.at);
  return bits;
}

/// @throws InputError where the points do not span a view plane in doubles
void check(const View& view, const ImageTiles::Side& side) {
  const auto is_finite = [](const Point3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); };
  if (is_finite(side.c) && is_finite(side.d)) {
    const Point2 c = place_in_frame(view, side.c), d = place_in_frame(view, side.d);
    if (std::isfinite(c.x) && std::isfinite(d.x) && (c.x != d.x || c.y != d.y)) return;
  }
  throw InputError(
      "tiles: the picture is too large, too small or too far from the origin to be parted in doubles, expected it in one "
      "piece");
}

/// The multiple of a power of two that is nearest to x.
double rounded(double x, int power) { return std::ldexp(std::round(std::ldexp(x, -power)), power) + 0.0; }

}  // namespace

std::vector<TileBound> ImageTiles::bounds(std::uint32_t tile) const {
  std::vector<TileBound> path;
  const std::function<bool(std::int32_t)> finds = [&](std::int32_t at) {
    if (at < 0) return static_cast<std::uint32_t>(~at) == tile;
    const auto k = static_cast<std::uint32_t>(at);
    for (const Sign kept : {Sign::negative, Sign::positive}) {
      path.push_back({k, kept});
      if (finds(kept == Sign::negative ? splits[k].negative : splits[k].positive)) return true;
      path.pop_back();
    }
    return false;
  };
  if (!splits.empty()) finds(0);
  return path;
}

Point2 place_in_frame(const View& view, const Point3& p) {
  const Frame& f = view.frame;
  const Point3 normal = cross(f.right, f.up);
  Point3 at = minus(p, f.origin);  // from the origin of the frame to where the line of sight meets the paper
  if (view.viewpoint.is_direction) {
    const Point3& d = view.viewpoint.at;
    at = sum(at, -dot(at, normal) / dot(d, normal), d);
  } else {
    const Point3 &eye = view.viewpoint.at, sight = minus(p, eye);
    const double ahead = dot(minus(f.origin, eye), normal) / dot(sight, normal);
    if (!(ahead > 0)) return {HUGE_VAL, HUGE_VAL};
    at = sum(minus(eye, f.origin), ahead, sight);
  }
  return {dot(at, f.right), dot(at, f.up)};
}

ImageTiles::Side tile_side(const View& view, int axis, double at, double size) {
  constexpr int kept_bits = 20;
  const Frame& f = view.frame;
  int exponent = 0;
  std::frexp(size > 0 && std::isfinite(size) ? size : 1, &exponent);
  const Point3 &across = axis == 0 ? f.right : f.up, &along = axis == 0 ? f.up : f.right;
  const auto point = [&](double length) {
    const Point3 p = sum(sum(f.origin, at, across), length, along);
    const int power = exponent - kept_bits;
    return Point3{rounded(p.x, power), rounded(p.y, power), rounded(p.z, power)};
  };
  return {point(-std::ldexp(1, exponent)), point(std::ldexp(1, exponent))};
}

ImageTiles balanced_tiles(const View& view, std::vector<Point2> places, std::uint32_t count) {
  ImageTiles tiles;
  std::erase_if(places, [](const Point2& p) { return !std::isfinite(p.x) || !std::isfinite(p.y); });
  double size = 0;
  for (const Point2& p : places) size = std::max({size, std::fabs(p.x), std::fabs(p.y)});
  std::int32_t next = 0;
  using Range = std::span<Point2>;
  const std::function<std::int32_t(Range, std::uint32_t)> part = [&](Range some, std::uint32_t n) -> std::int32_t {
    if (n == 1) return ~(next++);
    const auto extent = [&](auto coordinate) {
      if (some.empty()) return 0.0;
      const auto [low, high] = std::ranges::minmax(some, {}, coordinate);
      return coordinate(high) - coordinate(low);
    };
    const auto x = [](const Point2& p) { return p.x; };
    const auto y = [](const Point2& p) { return p.y; };
    const int axis = extent(x) >= extent(y) ? 0 : 1;
    const std::uint32_t lower = n / 2;
    const auto middle = some.begin() + static_cast<std::ptrdiff_t>(some.size() * lower / n);
    if (axis == 0)
      std::ranges::nth_element(some, middle, {}, x);
    else
      std::ranges::nth_element(some, middle, {}, y);
    const double at = some.empty() ? 0 : axis == 0 ? middle->x : middle->y;
    const std::size_t split = tiles.splits.size();
    tiles.splits.emplace_back();
    tiles.sides.push_back(tile_side(view, axis, at, size));
    check(view, tiles.sides.back());
    const std::int32_t first = part({some.begin(), middle}, lower), second = part({middle, some.end()}, n - lower);
    tiles.splits[split] = {first, second};
    return static_cast<std::int32_t>(split);
  };
  part(places, count);
  // Which of the halves lies on which side of the plane is the plane's to say.
  for (std::size_t k = 0; k < tiles.splits.size(); ++k) {
    const ImageTiles::Side& s = tiles.sides[k];
    const Point2 c = place_in_frame(view, s.c), d = place_in_frame(view, s.d);
    const bool is_across_x = std::fabs(d.y - c.y) > std::fabs(d.x - c.x);
    // Left of c -> d is positive: of a side that runs upward the lower x, of one that runs to the right the higher y.
    if (is_across_x) std::swap(tiles.splits[k].negative, tiles.splits[k].positive);
  }
  return tiles;
}

TileFinder::TileFinder(const ImageTiles& tiles, const View& view, BitRange points)
    : tiles_(tiles), exact_(with_sides(points, tiles, view), direction_of(view), Arithmetic::staged) {
  for (const ImageTiles::Side& side : tiles.sides) planes_.push_back(Plane::of_sight(view.viewpoint, side.c, side.d));
}

void TileFinder::find(std::span<const Point3> corners, std::vector<std::uint32_t>& found) {
  if (tiles_.splits.empty()) {
    found.push_back(0);
    return;
  }
  open_.assign(1, 0);
  while (!open_.empty()) {
    const std::int32_t at = open_.back();
    open_.pop_back();
    if (at < 0) {
      found.push_back(static_cast<std::uint32_t>(~at));
      continue;
    }
    const auto k = static_cast<std::size_t>(at);
    bool reaches_negative = false, reaches_positive = false;
    for (const Point3& p : corners) {
      const Sign s = exact_.side(planes_[k], p);
      reaches_negative = reaches_negative || s != Sign::positive;
      reaches_positive = reaches_positive || s != Sign::negative;
    }
    if (reaches_positive) open_.push_back(tiles_.splits[k].positive);
    if (reaches_negative) open_.push_back(tiles_.splits[k].negative);
  }
}

}  // namespace hsr::internal
