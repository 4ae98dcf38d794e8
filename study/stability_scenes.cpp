#include "study/stability_scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <random>

#include "geometry/bit_range.h"
#include "hsr/image.h"
#include "hsr/raster/caster.h"
#include "hsr/raster/sample_projection.h"

namespace hsr::internal {

namespace {

constexpr double smallest = std::numeric_limits<double>::denorm_min();

void add(StiffScene& scene, std::initializer_list<Point3> corners) {
  for (const Point3& p : corners) {
    scene.polygons.corners.push_back(static_cast<std::uint32_t>(scene.points.size()));
    scene.points.push_back(p);
  }
  scene.polygons.first.push_back(static_cast<std::uint32_t>(scene.polygons.corners.size()));
}

/// A square around (0, 0, z).
void add_square(StiffScene& scene, double half, double z) {
  add(scene, {{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}});
}

/// A triangle at a height, where no line of sight of the picture is: see StiffScene::only_for_range.
void add_outside(StiffScene& scene, double z) {
  add(scene, {{9, 0, z}, {10, 0, z}, {9, 1, z}});
  ++scene.only_for_range;
}

/// The width of a pixel: a power of two, so that all samples are exact and lie half a pixel beside the middle.
double pixel(int size, double half_width) { return std::exp2(std::floor(std::log2(2 * half_width / size))); }

/// Samples around the origin. @param right, down a pixel each
SampleGrid around_origin(const Point3& right, const Point3& down, int size) {
  const double h = -(size - 1) / 2.0;
  return {{h * (right.x + down.x), h * (right.y + down.y), h * (right.z + down.z)}, right, down, size, size};
}

/// Samples (x, y, -y) with x and y in [-half, half]: the plane that they lie in is neither that of the faces z = const nor a
/// line of sight along (0, 1, 2) or (1, 2, 3), so that depths vary and have to be rounded.
SampleGrid aslant(int size, double half) {
  const double p = pixel(size, half);
  return around_origin({p, 0, 0}, {0, -p, p}, size);
}

SampleGrid from_above(int size, double half) {
  const double p = pixel(size, half);
  return around_origin({p, 0, 0}, {0, -p, 0}, size);
}

std::vector<double> powers(double base, int first, int last, int step) {
  std::vector<double> all;
  for (int k = first; step > 0 ? k <= last : k >= last; k += step) all.push_back(std::pow(base, k));
  return all;
}

/// Every second one, and the last.
std::vector<double> thinned(const std::vector<double>& all, bool quick) {
  if (!quick) return all;
  std::vector<double> some;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (k % 2 == 0 || k + 1 == all.size()) some.push_back(all[k]);
  return some;
}

/// 1 ... 1e-17 in steps of ten, and then to the smallest double.
std::vector<double> to_the_smallest(bool quick) {
  std::vector<double> all = powers(10, 0, -17, -1);
  for (const double x : {1e-20, 1e-30, 1e-38, 1e-45, 1e-75, 1e-100, 1e-154, 1e-162, 1e-200, 1e-300, 1e-308, smallest})
    all.push_back(x);
  return thinned(all, quick);
}

/// How the nearness changes where z does by 1, along a line of sight of a parallel view; and at a sample, of the plane z = 0.
double nearness_of_height(const StiffScene& scene) {
  const SampleProjection<double> project(scene.view, scene.grid);
  const Point3& d = scene.view.viewpoint.at;
  return project(Point3{d.x / d.z, d.y / d.z, 1}).nearness - project(Point3{}).nearness;
}
ClosestDepths around_floor(const StiffScene& scene, double gap) {
  const SampleGrid& g = scene.grid;
  const double height = nearness_of_height(scene);
  const double a = -height * g.origin.z, b = -height * g.at(g.width - 1, g.height - 1).z;
  return {std::max(a, b), std::min(a, b), gap * height};
}

std::optional<FaceId> face(std::size_t f) { return FaceId(f); }

// Two parallel faces. The lower comes first: of equal depths it is shown, and that is wrong.

StiffScene gap(double g, int size) {
  StiffScene scene;
  add_square(scene, 8, 0);
  add_square(scene, 8, g);
  scene.view = parallel_view({1, 2, 3}, {0, 0, 1});
  scene.grid = aslant(size, 1);
  scene.known = [](int, int) { return face(1); };
  scene.closest = around_floor(scene, g);
  return scene;
}

std::vector<double> ulp_values(bool quick) { return thinned(powers(2, 0, -52, -2), quick); }
/// Sloping, so that depths have all roundings that there are; heights from 1.25 to 1.75 have steps of 2^-52.
StiffScene ulp(double g, int size) {
  StiffScene scene;
  for (const double z : {1.5, 1.5 + g})
    add(scene, {{-8, -8, z - 0.25}, {8, -8, z + 0.25}, {8, 8, z + 0.25}, {-8, 8, z - 0.25}});
  add_outside(scene, 0);
  scene.view = parallel_view({0, 0, 1}, {0, 1, 0});
  scene.grid = from_above(size, 1);
  scene.known = [](int, int) { return face(1); };
  const double height = nearness_of_height(scene);
  scene.closest = ClosestDepths{height * (1.53125 + g), height * 1.46875, height * g};
  return scene;
}

/// An eye at the origin that looks along -z onto two sloping walls, samples at distance 1.
/// @param z, next along the middle of the picture @param gap what is added to a distance @param times what multiplies it
StiffScene two_walls(int size, double near, double z, double gap, double times, std::initializer_list<double> range) {
  StiffScene scene;
  for (const bool is_farther : {true, false}) {
    const double by = is_farther ? times : 1, add_z = is_farther ? gap : 0, w = 2 * z * by;
    const double left = -(z / 2 * by + add_z), right = -(z / 2 * 3 * by + add_z);
    add(scene, {{-w, -w, left}, {w, -w, right}, {w, w, right}, {-w, w, left}});
  }
  for (const double d : range) add(scene, {{2 * d, 0, -d}, {3 * d, 0, -d}, {2 * d, d, -d}});
  scene.only_for_range = range.size();
  scene.view = perspective_view({0, 0, 0}, {0, 0, -1}, {0, 1, 0}, near);
  scene.grid = from_above(size, 1);
  scene.grid.origin.z = -1;
  scene.known = [](int, int) { return face(1); };
  // At u = -1 ... 1 of the picture the nearer wall is at distance z / (1 - u / 4).
  const double low = z / 1.25, high = z / 0.75, next = (z * times + gap) / 0.75;
  scene.closest = ClosestDepths{1 / low - 1, 1 / high - 1, (next - high) / high / next};
  return scene;
}

std::vector<double> distance_values(bool quick) { return thinned(powers(2, 6, -45, -3), quick); }
StiffScene distance(double g, int size) { return two_walls(size, 0x1p-3, 128, g, 1, {0x1p-3, 0x1p13}); }

std::vector<double> ratio_values(bool quick) {
  std::vector<double> all = powers(10, 0, 16, 1);
  for (const double x : {1e20, 1e30, 1e38, 1e50, 1e100, 1e150, 1e200, 1e250, 1e300}) all.push_back(x);
  return thinned(all, quick);
}
StiffScene ratio(double r, int size) { return two_walls(size, 0.125, r, 0, 1.015625, {0.5, 2 * r}); }

// Two faces that cross where x = 0: the line of sight keeps x, and beyond it the sloping one is in front of the other.

StiffScene slope(double s, int size) {
  StiffScene scene;
  add_square(scene, 8, 0);
  add(scene, {{-8, -8, -8 * s}, {8, -8, 8 * s}, {8, 8, 8 * s}, {-8, 8, -8 * s}});
  scene.view = parallel_view({0, 1, 2}, {0, 0, 1});
  scene.grid = aslant(size, 1);
  scene.known = [grid = scene.grid](int i, int j) -> std::optional<FaceId> {
    const double x = grid.at(i, j).x;
    return x == 0 ? std::nullopt : face(x > 0 ? 1 : 0);
  };
  scene.closest = around_floor(scene, s * scene.grid.right.x / 2);
  return scene;
}

// Three triangles in a cycle, and two that pierce each other, over a floor: integers up to 16.

StiffScene integers() {
  StiffScene scene;
  add(scene, {{-8, -3, 0}, {8, -3, 16}, {8, -4, 16}});
  add(scene, {{6, -7, 0}, {-2, 9, 16}, {-1, 9, 16}});
  add(scene, {{2, 9, 0}, {-6, -7, 16}, {-7, -7, 16}});
  add(scene, {{2, 2, 2}, {6, 2, 6}, {4, 7, 4}});
  add(scene, {{2, 2, 6}, {6, 2, 2}, {4, 7, 4}});
  add_square(scene, 12, -1);
  add(scene, {{0, 0, -8}, {1, 0, -8}, {0, 1, -8}});
  scene.only_for_range = 1;
  return scene;
}

std::function<std::optional<FaceId>(int, int)> as_seen_in(const StiffScene& other) {
  const Mesh mesh = make_mesh(other.points, other.polygons);
  const auto faces = std::make_shared<Image<FaceId>>(other.grid.width, other.grid.height);
  const CastImage image = cast(mesh, other.view, other.grid);
  for (int j = 0; j < other.grid.height; ++j)
    for (int i = 0; i < other.grid.width; ++i) faces->at(i, j) = image.face(mesh, i, j);
  return [faces](int i, int j) -> std::optional<FaceId> { return faces->at(i, j); };
}

std::vector<double> large_values(bool quick) {
  std::vector<double> all;
  for (const int k : {0, 10, 30, 60, 100, 120, 127, 128, 150, 200, 255, 300, 340, 400, 500, 511, 512, 600, 700, 900, 1000})
    all.push_back(std::ldexp(1.0, k));
  return thinned(all, quick);
}
std::vector<double> small_values(bool quick) {
  std::vector<double> all = large_values(quick);
  for (double& x : all) x = 1 / x;
  return all;
}
/// @param factor a power of two
StiffScene scaled(double factor, int size) {
  const Point3 eye = {3, -20, 30}, target = {0, 0, 2}, up = {0, 0, 1};
  StiffScene scene = integers();
  scene.view = perspective_view(eye, target, up);
  scene.grid = sample_grid(scene.view, PaperRectangle{-10, 10, -10, 10}, size, size);
  const auto known = as_seen_in(scene);
  const auto by = [factor](const Point3& p) { return Point3{p.x * factor, p.y * factor, p.z * factor}; };
  for (Point3& p : scene.points) p = by(p);
  scene.view = perspective_view(by(eye), by(target), up);
  scene.grid = {by(scene.grid.origin), by(scene.grid.right), by(scene.grid.down), size, size};
  scene.known = known;
  return scene;
}

std::vector<double> offset_values(bool quick) {
  std::vector<double> all;
  for (const int k : {0, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40, 42, 44, 46, 48, 50, 52, 53, 55})
    all.push_back(std::ldexp(1.0, k));
  for (const double x : {1e20, 1e50, 1e100, 1e200, 1e300}) all.push_back(x);
  return thinned(all, quick);
}
/// Corners rounded to doubles, as any file would have them.
StiffScene moved(double by, int size) {
  StiffScene scene = integers();
  const Point3 toward = {1, 2, 3}, up = {0, 0, 1}, offset = {by, -by / 2, by / 4};
  scene.view = parallel_view(toward, up);
  scene.grid = aslant(size, 8);
  // Beside the middles of pixels, where edges and crossings of integers would meet samples.
  const Point3 &right = scene.grid.right, &down = scene.grid.down;
  scene.grid.origin.x += 13.0 / 64 * right.x;
  scene.grid.origin.y += 29.0 / 64 * down.y;
  scene.grid.origin.z += 29.0 / 64 * down.z;
  const auto known = as_seen_in(scene);
  bool is_exact = true;
  const auto move = [&](const Point3& p) {
    const Point3 q = {p.x + offset.x, p.y + offset.y, p.z + offset.z};
    is_exact = is_exact && Point3{q.x - offset.x, q.y - offset.y, q.z - offset.z} == p;
    return q;
  };
  for (Point3& p : scene.points) p = move(p);
  if (is_exact) scene.known = known;
  scene.view = parallel_view(toward, up, offset);
  SampleGrid grid = scene.grid;
  grid.origin = move(grid.origin);
  BitRange needed;
  for (const Point3& p : {grid.origin, grid.right, grid.down, grid.at(size, size)}) needed.add(p);
  if (is_exact && needed.bits() <= 50) {
    scene.grid = grid;
    return scene;
  }
  // Samples of the size that doubles have there.
  scene.grid = sample_grid(scene.view, PaperRectangle{-8, 8, -8, 8}, size, size);
  scene.known = {};
  return scene;
}

// A strip around y = x, on which a diagonal of samples lies exactly.

/// 16 over the width, the strip being 16 in each coordinate.
std::vector<double> sliver_values(bool quick) {
  std::vector<double> all = powers(2, 3, 49, 2);
  all.insert(all.end(), {0x1p50, 0x1p51, 0x1p52, 0x1p53});
  return thinned(all, quick);
}
StiffScene sliver(double aspect, int size) {
  // At first a little more, so that no sample is on its border.
  const double w = 8 / aspect * (aspect < 0x1p16 ? 1 + 0x1p-10 : 1);
  StiffScene scene;
  add_square(scene, 8, 0);
  add(scene, {{-8, -8 - w, 1}, {8, 8 - w, 1}, {8, 8 + w, 1}, {-8, -8 + w, 1}});
  scene.view = parallel_view({0, 0, 1}, {0, 1, 0});
  scene.grid = from_above(size, 1);
  add_outside(scene, -1);
  scene.known = [grid = scene.grid, w](int i, int j) {
    const Point3 p = grid.at(i, j);
    return face(std::fabs(p.y - p.x) < w ? 1 : 0);
  };
  return scene;
}

// A floor z = 0 before a wall, seen along (1, 0, s): from (0, y, z) the line of sight is on the floor at x = -z / s.

StiffScene grazing(double s, int size) {
  constexpr double wall = 1 - 0x1p-10;  // so that no sample meets both
  StiffScene scene;
  add(scene, {{-wall, -8, -8}, {-wall, 8, -8}, {-wall, 8, 8}, {-wall, -8, 8}});
  add_square(scene, 8, 0);
  add(scene, {{-9, 0, -8}, {-9, 1, -8}, {-9, 0, -7}});
  scene.only_for_range = 1;
  scene.view = parallel_view({1, 0, s}, {0, 0, 1});
  const double p = pixel(size, 1);
  scene.grid = around_origin({0, p, 0}, {0, 0, -p}, size);
  const int above = size / 2;
  scene.grid.origin.z = above * p;  // one row of samples at z = 0
  scene.known = [grid = scene.grid, s](int i, int j) -> std::optional<FaceId> {
    const double z = grid.at(i, j).z;
    if (std::fabs(z) == 8 * s) return std::nullopt;
    return face(std::fabs(z) < 8 * s && z < wall * s ? 1 : 0);
  };
  return scene;
}

// Many faces.

std::vector<double> layer_values(bool quick) { return powers(2, 1, quick ? 8 : 10, 1); }
/// Layer k at height k / n begins where x = -1 + (2 k + 1/3) / n; the file has them in another order.
StiffScene layers(double n, int size) {
  StiffScene scene;
  const auto count = static_cast<std::size_t>(n);
  const auto begin = [n](std::size_t k) { return -1 + (2 * static_cast<double>(k) + 1 / 3.0) / n; };
  for (std::size_t f = 0; f < count; ++f) {
    const std::size_t k = f * 37 % count;  // each once: n is a power of two
    const double x = k == 0 ? -8 : begin(k), z = static_cast<double>(k) / n;
    add(scene, {{x, -8, z}, {8, -8, z}, {8, 8, z}, {x, 8, z}});
  }
  add_outside(scene, -0.25);
  scene.view = parallel_view({0, 0, 1}, {0, 1, 0});
  scene.grid = from_above(size, 1);
  scene.known = [grid = scene.grid, count, begin](int i, int j) {
    const double x = grid.at(i, j).x;
    std::size_t k = 0;
    while (k + 1 < count && begin(k + 1) < x) ++k;
    std::size_t f = 0;
    while (f * 37 % count != k) ++f;
    return face(f);
  };
  const double height = nearness_of_height(scene);
  scene.closest = ClosestDepths{height, 0, height / n};
  return scene;
}

/// A sample moved by (e, -e^2), and what is linear in it: a value and what e and e^2 add to it.
struct NearSample {
  std::int64_t value = 0, e = 0, e2 = 0;
  int sign() const {
    for (const std::int64_t x : {value, e, e2})
      if (x != 0) return x > 0 ? 1 : -1;
    return 0;
  }
  friend NearSample operator*(std::int64_t s, const NearSample& a) { return {s * a.value, s * a.e, s * a.e2}; }
  friend NearSample operator+(const NearSample& a, const NearSample& b) { return {a.value + b.value, a.e + b.e, a.e2 + b.e2}; }
};

using IntegerTriangle = std::array<std::array<std::int64_t, 3>, 3>;

/// The triangle above the others at (x, y), in integers: every triangle, without any of the caster's means.
FaceId highest_at(const std::vector<IntegerTriangle>& triangles, std::int64_t x, std::int64_t y) {
  FaceId found;
  NearSample height;
  std::int64_t over = 1;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    const auto edge = [&](const std::array<std::int64_t, 3>& p, const std::array<std::int64_t, 3>& q) {
      const std::int64_t dx = q[0] - p[0], dy = q[1] - p[1];
      return NearSample{dx * (y - p[1]) - dy * (x - p[0]), -dy, -dx};
    };
    // Twice the areas of the parts opposite to a, b and c: weights of their heights.
    const NearSample of_a = edge(b, c), of_b = edge(c, a), of_c = edge(a, b);
    const std::int64_t area = of_a.value + of_b.value + of_c.value;
    const int turn = area > 0 ? 1 : area < 0 ? -1 : 0;
    if (turn == 0 || of_a.sign() != turn || of_b.sign() != turn || of_c.sign() != turn) continue;
    const NearSample z = turn * (a[2] * of_a + b[2] * of_b + c[2] * of_c);
    const std::int64_t whole = turn * area;
    if (!found.is_valid() || (over * z + -whole * height).sign() > 0) found = FaceId(t), height = z, over = whole;
  }
  return found;
}

std::vector<double> cycle_values(bool quick) {
  std::vector<double> all = {3, 4, 5, 8, 16, 32, 64};
  if (!quick) all.insert(all.end(), {128, 256, 512});
  return all;
}
/// The sides of a regular polygon, each longer than it is and rising from 0 to 1; corners are whole multiples of 2^-13.
StiffScene cycle(double n, int size) {
  constexpr double radius = 0.8, beyond = 0.2, half_width = 0.11, unit = 0x1p-13;
  StiffScene scene;
  std::vector<IntegerTriangle> triangles;  // two a slat
  const int count = static_cast<int>(n);
  for (int k = 0; k < count; ++k) {
    const double a = 2 * std::numbers::pi * k / n + 0.1, b = a + 2 * std::numbers::pi / n;
    const double dx = radius * (std::cos(b) - std::cos(a)), dy = radius * (std::sin(b) - std::sin(a));
    const auto corner = [&](double along, double across) {
      const double l = along == 0 ? -beyond : 1 + beyond, w = across * half_width;
      const auto whole = [](double x) { return static_cast<std::int64_t>(std::llround(x / unit)); };
      return std::array{whole(radius * std::cos(a) + l * dx - w * dy), whole(radius * std::sin(a) + l * dy + w * dx),
                        whole(along * unit)};
    };
    const std::array c = {corner(0, -1), corner(1, -1), corner(1, 1), corner(0, 1)};
    const auto point = [](const std::array<std::int64_t, 3>& p) {
      return Point3{static_cast<double>(p[0]) * unit, static_cast<double>(p[1]) * unit, static_cast<double>(p[2])};
    };
    add(scene, {point(c[0]), point(c[1]), point(c[2]), point(c[3])});
    triangles.push_back({c[0], c[1], c[2]});
    triangles.push_back({c[0], c[2], c[3]});
  }
  add_outside(scene, -1);
  scene.view = parallel_view({0, 0, 1}, {0, 1, 0});
  scene.grid = from_above(size, 1);
  scene.known = [grid = scene.grid, triangles](int i, int j) {
    const Point3 p = grid.at(i, j);
    const FaceId t = highest_at(triangles, static_cast<std::int64_t>(p.x / unit), static_cast<std::int64_t>(p.y / unit));
    return std::optional(t.is_valid() ? FaceId(t.value / 2) : t);
  };
  return scene;
}

std::vector<double> soup_values(bool quick) { return powers(2, 1, quick ? 6 : 8, 1); }

StiffScene soup(double n, int size) {
  std::mt19937_64 random(static_cast<std::uint64_t>(n));
  const auto corner = [&random] {
    const auto number = [&random] { return static_cast<int>(random() % 5) - 2; };
    const int x = number(), y = number(), z = number();
    return Point3{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
  };
  StiffScene scene;
  std::vector<IntegerTriangle> triangles;
  const double p = pixel(size, 2);
  for (int k = 0; k < static_cast<int>(n); ++k) {
    const Point3 a = corner(), b = corner(), c = corner();
    add(scene, {a, b, c});
    const auto in_pixels = [p](const Point3& q) {
      const auto whole = [p](double x) { return static_cast<std::int64_t>(std::llround(x / p)); };
      return std::array{whole(q.x), whole(q.y), whole(q.z)};
    };
    triangles.push_back({in_pixels(a), in_pixels(b), in_pixels(c)});
  }
  add_outside(scene, -4);
  scene.view = parallel_view({0, 0, 1}, {0, 1, 0});
  // Samples on corners and edges.
  const std::int64_t half = size / 2;
  scene.grid = {{-static_cast<double>(half) * p, static_cast<double>(half) * p, 0}, {p, 0, 0}, {0, -p, 0}, size, size};
  scene.known = [triangles, half](int i, int j) { return std::optional(highest_at(triangles, i - half, half - j)); };
  return scene;
}

}  // namespace

std::span<const StabilityFamily> stability_families() {
  static const StabilityFamily all[] = {
      {"gap", "A gap between parallel faces", "gap",
       "Two squares, 16 wide, the second a gap above the first; a parallel view along (1, 2, 3).",
       "the upper square is the nearer everywhere", to_the_smallest, gap},
      {"ulp", "A gap down to one unit in the last place", "gap",
       "Two sloping squares at height 1.5, from straight above; the gap of 2^-52 is the smallest that doubles have there.",
       "the upper square is the nearer everywhere", ulp_values, ulp},
      {"distance",
       "A gap in perspective",
       "gap",
       "Two sloping walls at distance 128; other faces, outside the picture, at 1/8 and at 8192 give buffers their depth "
       "range.",
       "the nearer wall hides the other everywhere",
       distance_values,
       distance,
       {3, 1, 1.5},
       64},
      {"slope",
       "A crossing slope",
       "slope",
       "Two squares that cross along a line in the middle, at a slope; a parallel view along (0, 1, 2).",
       "each is before the other on its side of the line x = 0",
       to_the_smallest,
       slope,
       {2, -5, 3},
       0.5},
      {"ratio",
       "Near and far",
       "distance",
       "Two sloping walls, a 64th of their distance apart, that far away; other faces at 1/2 and at twice that distance.",
       "the nearer wall hides the other everywhere",
       ratio_values,
       ratio,
       {3, 1, 1.5},
       4},
      {"large",
       "Large coordinates",
       "factor",
       "Three triangles in a cycle and two that pierce each other, in perspective; everything times a power of two.",
       "the same picture as at factor 1",
       large_values,
       scaled,
       {3, -20, 30}},
      {"small",
       "Small coordinates",
       "factor",
       "The same, made smaller.",
       "the same picture as at factor 1",
       small_values,
       scaled,
       {3, -20, 30}},
      {"offset",
       "Far from the origin",
       "offset",
       "The same scene, about 16 wide, moved by (1, -1/2, 1/4) times the offset, its corners rounded to doubles; a parallel "
       "view along (1, 2, 3). Up to 2^52 that rounding changes nothing. But from 2^42 on doubles are too coarse for samples of "
       "this size: these come to lie on edges and crossings, and then pixels grow. From 2^55 on half of the scene is left, in "
       "the end nothing: then nothing is wrong either.",
       "the same picture as near the origin, while corners and samples are moved exactly",
       offset_values,
       moved,
       {1, 2, 3}},
      {"sliver",
       "Slivers",
       "length / width",
       "A strip over a floor, so many times as long as it is wide, along a diagonal of samples.",
       "the strip where |y - x| is less than half its width, as on the diagonal; the floor elsewhere",
       sliver_values,
       sliver,
       {2, -5, 3},
       16},
      {"grazing",
       "Grazing angles",
       "slope of the line of sight",
       "A floor, 16 deep, before a wall, seen along (1, 0, slope): in the end only one row of samples meets the floor.",
       "a line of sight from height z meets the floor at x = -z / slope, the wall at x = -1 + 2^-10",
       to_the_smallest,
       grazing,
       {4, -2, 2}},
      {"layers",
       "Many layers",
       "layers",
       "n squares as a stair from height 0 to 1, in no order.",
       "the last step that begins before the sample",
       layer_values,
       layers,
       {-2, -5, 4},
       8},
      {"cycle",
       "Cyclic overlap",
       "slats",
       "n slats in a ring, each over the next, so that no order of them is right.",
       "every slat looked at in integers",
       cycle_values,
       cycle,
       {1, -3, 4},
       8},
      {"soup",
       "Integer soups",
       "triangles",
       "n random triangles with integer corners from -2 to 2: shared corners and edges, coinciding and piercing faces, faces "
       "seen edge-on, and samples on all of these: what rounds cannot know which face a sample on an edge belongs to.",
       "every triangle looked at in integers",
       soup_values,
       soup,
       {2, -3, 4},
       16},
  };
  return all;
}

}  // namespace hsr::internal
