#include "examples/part.h"

#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace hsr::examples {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double degrees = pi / 180;

struct Point2 {
  double x, y;
};

/// Multiples of 2^-16 mm: every coordinate is exact in decimals, too.
double on_grid(double x) { return std::nearbyint(x * 0x1p16) * 0x1p-16; }
Point2 polar(double radius, double angle) { return {on_grid(radius * std::cos(angle)), on_grid(radius * std::sin(angle))}; }

/// A closed curve, counter-clockwise seen from above.
using Outline = std::vector<Point2>;

/// Circles of whole half-millimetres are exact multiples of one circle, so that a cone between two has planar facets.
Outline circle(int half_millimetres, int corners) {
  Outline outline;
  for (int k = 0; k < corners; ++k) {
    const auto [x, y] = polar(0.5, 2 * pi * k / corners);
    outline.push_back({half_millimetres * x, half_millimetres * y});
  }
  return outline;
}

/// A hole with its first corner away from the axis.
Outline hole(double distance, double angle, double radius, int corners) {
  Outline outline;
  const Point2 centre = polar(distance, angle);
  for (int k = 0; k < corners; ++k) {
    const Point2 p = polar(radius, angle + 2 * pi * k / corners);
    outline.push_back({centre.x + p.x, centre.y + p.y});
  }
  return outline;
}

/// The bore and its keyway, which lies at +x. The two corners of the circle within the keyway give way to its own four.
Outline bore_with_keyway(int half_millimetres, int corners, double half_width, double depth) {
  const Outline round = circle(half_millimetres, corners);
  const double foot = on_grid(std::sqrt(0.25 * half_millimetres * half_millimetres - half_width * half_width));
  Outline outline = {{foot, -half_width}, {depth, -half_width}, {depth, half_width}, {foot, half_width}};
  for (const Point2& p : round)
    if (p.x < foot) outline.push_back(p);
  return outline;
}

Outline rounded_square(double half_side, double radius, int corners_per_turn) {
  Outline outline;
  const double c = half_side - radius;
  const int quarter = corners_per_turn / 4;
  const Point2 centres[] = {{c, c}, {-c, c}, {-c, -c}, {c, -c}};
  for (int side = 0; side < 4; ++side)
    for (int k = 0; k <= quarter; ++k) {
      const Point2 p = polar(radius, pi / 2 * (side + static_cast<double>(k) / quarter));
      outline.push_back({centres[side].x + p.x, centres[side].y + p.y});
    }
  return outline;
}

constexpr int corners_per_tooth = 13;

/// The outline of a spur gear with involute flanks; the first corner of each tooth is the middle of the gap before it.
Outline gear(int teeth, double module, double pressure_angle) {
  const double pitch_radius = module * teeth / 2, base_radius = pitch_radius * std::cos(pressure_angle);
  const double tip_radius = pitch_radius + module, root_radius = pitch_radius - 1.25 * module;
  const auto involute = [](double a) { return std::tan(a) - a; };
  const auto half_thickness = [&](double radius) {
    const double roll = radius > base_radius ? std::acos(base_radius / radius) : 0;
    return pi / (2 * teeth) + involute(pressure_angle) - involute(roll);
  };
  const double flank[] = {root_radius, base_radius, base_radius + 0.25 * (tip_radius - base_radius),
                          base_radius + 0.6 * (tip_radius - base_radius), tip_radius};
  Outline outline;
  for (int tooth = 0; tooth < teeth; ++tooth) {
    const double gap = 2 * pi * tooth / teeth, middle = gap + pi / teeth;
    outline.push_back(polar(root_radius, gap));
    for (const double radius : flank) outline.push_back(polar(radius, middle - half_thickness(radius)));
    outline.push_back(polar(tip_radius, middle - half_thickness(tip_radius) / 3));
    outline.push_back(polar(tip_radius, middle + half_thickness(tip_radius) / 3));
    for (int k = 4; k >= 0; --k) outline.push_back(polar(flank[k], middle + half_thickness(flank[k])));
  }
  return outline;
}

/// An outline at a height: indices of its points.
using Loop = std::vector<std::uint32_t>;

/// Where a cap between two loops is cut: from a corner of the inner loop to one of the outer, through a hole or straight.
struct Spoke {
  std::size_t inner, outer;
  Loop hole = {};  ///< its first corner looks outward, the one half a turn on inward
};

/// The corners of `loop` from one index to another, both included, going round upward.
Loop part_of(const Loop& loop, std::size_t from, std::size_t to) {
  Loop part = {loop[from % loop.size()]};
  for (std::size_t k = from % loop.size(); k != to % loop.size();) {
    k = (k + 1) % loop.size();
    part.push_back(loop[k]);
  }
  return part;
}
Loop reversed(const Loop& loop) { return {loop.rbegin(), loop.rend()}; }

class Solid {
 public:
  Loop loop(const Outline& outline, double z) {
    Loop loop(outline.size());
    std::iota(loop.begin(), loop.end(), static_cast<std::uint32_t>(model.points.size()));
    for (const auto& [x, y] : outline) model.points.push_back({x, y, z});
    return loop;
  }

  void face(const Loop& corners) {
    model.polygons.corners.insert(model.polygons.corners.end(), corners.begin(), corners.end());
    model.polygons.first.push_back(static_cast<std::uint32_t>(model.polygons.corners.size()));
  }

  /// Quads between two loops of as many corners. Material is inside the loops if `low` lies below `high`, else outside.
  void wall(const Loop& low, const Loop& high) {
    for (std::size_t k = 0; k < low.size(); ++k) {
      const std::size_t next = (k + 1) % low.size();
      face({low[k], low[next], high[next], high[k]});
    }
  }

  /// The flat ring between two loops, one polygon from each spoke to the next.
  void cap(const Loop& inner, const Loop& outer, std::span<const Spoke> spokes, bool looks_up) {
    for (std::size_t s = 0; s < spokes.size(); ++s) {
      const Spoke &here = spokes[s], &next = spokes[(s + 1) % spokes.size()];
      Loop ring = part_of(outer, here.outer, next.outer);
      const auto append = [&](const Loop& more) { ring.insert(ring.end(), more.begin(), more.end()); };
      if (!next.hole.empty()) append(reversed(part_of(next.hole, next.hole.size() / 2, 0)));
      append(reversed(part_of(inner, here.inner, next.inner)));
      if (!here.hole.empty()) append(reversed(part_of(here.hole, 0, here.hole.size() / 2)));
      face(looks_up ? ring : reversed(ring));
    }
  }

  Model model;
};

constexpr int turn = 48;  // facets of 7.5 degrees
constexpr int teeth = 24;

}  // namespace

Model part() {
  Solid solid;
  solid.model.name = "part";
  solid.model.format = "generated";

  // Heights, from the underside of the flange up to the end of the boss.
  constexpr double bottom = -26, flange_top = -16, gear_bottom = 0, web_top = 10, gear_top = 18, boss_top = 34, bevel = 1.5;
  const Outline square = rounded_square(58, 12, 2 * 20), teeth_outline = gear(teeth, 4, 20 * degrees);
  const Outline boss = circle(34, turn), boss_end = circle(31, turn), neck = circle(44, turn), rim = circle(74, turn);
  const Outline bore = bore_with_keyway(20, turn, 3, 13.25);

  const Loop bore_bottom = solid.loop(bore, bottom), bore_top = solid.loop(bore, boss_top);
  const Loop square_bottom = solid.loop(square, bottom), square_top = solid.loop(square, flange_top);
  const Loop neck_bottom = solid.loop(neck, flange_top), neck_top = solid.loop(neck, gear_bottom);
  const Loop teeth_bottom = solid.loop(teeth_outline, gear_bottom), teeth_top = solid.loop(teeth_outline, gear_top);
  const Loop rim_bottom = solid.loop(rim, web_top), rim_top = solid.loop(rim, gear_top);
  const Loop boss_bottom = solid.loop(boss, web_top), boss_shoulder = solid.loop(boss, boss_top - bevel);
  const Loop boss_edge = solid.loop(boss_end, boss_top);

  solid.wall(bore_top, bore_bottom);
  solid.wall(square_bottom, square_top);
  solid.wall(neck_bottom, neck_top);
  solid.wall(teeth_bottom, teeth_top);
  solid.wall(rim_top, rim_bottom);
  solid.wall(boss_bottom, boss_shoulder);
  solid.wall(boss_shoulder, boss_edge);

  // The flange: a bolt hole in each corner. Corner k of the square is round at 45 + 90 k degrees.
  std::vector<Spoke> under, above;
  for (std::size_t k = 0; k < 4; ++k) {
    const Outline bolt = hole(46 * std::sqrt(2.0), (45 + 90 * static_cast<double>(k)) * degrees, 5.5, 24);
    const Loop low = solid.loop(bolt, bottom), high = solid.loop(bolt, flange_top);
    solid.wall(high, low);
    // Of the bore, corners 4 ... are those of the circle from 22.5 degrees on.
    under.push_back({4 + 3 + k * turn / 4, k * 11 + 5, low});
    above.push_back({turn / 8 + k * turn / 4, k * 11 + 5, high});
  }
  solid.cap(bore_bottom, square_bottom, under, false);
  solid.cap(neck_bottom, square_top, above, true);

  // The gear: six lightening holes through the web.
  std::vector<Spoke> gear_under, web, gear_above, boss_above;
  for (std::size_t k = 0; k < 6; ++k) {
    const Outline light = hole(29.5, 60 * static_cast<double>(k) * degrees, 5.5, 24);
    const Loop low = solid.loop(light, gear_bottom), high = solid.loop(light, web_top);
    solid.wall(high, low);
    gear_under.push_back({k * turn / 6, k * teeth / 6 * corners_per_tooth, low});
    web.push_back({k * turn / 6, k * turn / 6, high});
    gear_above.push_back({k * turn / 6, k * teeth / 6 * corners_per_tooth});
  }
  for (std::size_t k = 0; k < 4; ++k) boss_above.push_back({4 + 3 + k * turn / 4, turn / 8 + k * turn / 4});
  solid.cap(neck_top, teeth_bottom, gear_under, false);
  solid.cap(boss_bottom, rim_bottom, web, true);
  solid.cap(rim_top, teeth_top, gear_above, true);
  solid.cap(bore_top, boss_edge, boss_above, true);
  return solid.model;
}

}  // namespace hsr::examples
