#include "hsr/drawing/paper_polygons.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geometry/parallel.h"
#include "hsr/scene/box_tree.h"

namespace hsr::internal {

namespace {

constexpr double highest = 5000;  // thousandths of a millimetre
constexpr std::size_t few_sides = 16, many_sides = 32;

struct Vector {
  double x, y;
};

Vector minus(const PaperPoint& p, const PaperPoint& q) {
  return {static_cast<double>(p.x - q.x), static_cast<double>(p.y - q.y)};
}
double length(const Vector& v) { return std::hypot(v.x, v.y); }
Vector unit(const Vector& v) { return {v.x / length(v), v.y / length(v)}; }
Vector unit_along(const PaperSide& s) { return unit(minus(s.to, s.from)); }
PaperPoint moved(const PaperPoint& p, const Vector& v, double distance) {
  return {p.x + std::llround(v.x * distance), p.y + std::llround(v.y * distance)};
}

double distance_to(const PaperPoint& p, const PaperSide& s) {
  const Vector along = minus(s.to, s.from), to = minus(p, s.from);
  const double t = std::clamp((to.x * along.x + to.y * along.y) / (along.x * along.x + along.y * along.y), 0.0, 1.0);
  return std::hypot(to.x - t * along.x, to.y - t * along.y);
}

ImageBox box_around(const PaperPoint& p, double distance) {
  ImageBox box = ImageBox::nothing();
  box.add({static_cast<double>(p.x), static_cast<double>(p.y), 0}, {distance, distance, 0});
  return box;
}

ImageBox box_around(const PaperSide& s, double distance) {
  ImageBox box = box_around(s.from, distance);
  box.add(box_around(s.to, distance));
  return box;
}

}  // namespace

/// A tree over the sides of each polygon that has many, by owner: what lies near may be of many others.
struct PaperPolygons::Trees {
  std::vector<std::uint32_t> number;  // by owner, where it has many
  std::vector<BoxTree> trees;
};

PaperPolygons::PaperPolygons(std::vector<PaperSide> sides)
    : sides_(std::move(sides)), before_(sides_.size()), after_(sides_.size()), trees_(std::make_unique<Trees>()) {
  const std::uint32_t owners = sides_.empty() ? 0 : sides_.back().owner + 1;
  first_side_.assign(owners + 1, 0);
  turn_.assign(owners, 0);
  for (std::uint32_t k = 0, first = 0; k < sides_.size(); ++k) {
    const PaperSide& s = sides_[k];
    ++first_side_[s.owner + 1];
    const bool is_last = k + 1 == sides_.size() || sides_[k + 1].owner != s.owner || sides_[k + 1].ring != s.ring;
    after_[k] = is_last ? first : k + 1;
    before_[after_[k]] = k;
    // Twice the area, about the first corner of the ring.
    const Vector p = minus(s.from, sides_[first].from), q = minus(s.to, sides_[first].from);
    turn_[s.owner] += p.x * q.y - p.y * q.x;
    if (is_last) first = k + 1;
  }
  for (double& t : turn_) t = t < 0 ? -1 : 1;
  for (std::size_t k = 0; k < owners; ++k) first_side_[k + 1] += first_side_[k];
  is_plain_.assign(owners, 1);
  for (std::uint32_t k = 0; k < sides_.size(); ++k) {
    const PaperSide &s = sides_[k], &next = sides_[after_[k]];
    const Vector in = minus(s.to, s.from), out = minus(next.to, next.from);
    const double rounding = 2 * std::max(length(in), length(out));  // a corner that was put on a side may be beside it
    const bool turns = turn_[s.owner] * (in.x * out.y - in.y * out.x) >= -rounding;
    const std::size_t count = first_side_[s.owner + 1] - first_side_[s.owner];
    if (!turns || count > few_sides || s.ring != sides_[first_side_[s.owner]].ring) is_plain_[s.owner] = 0;
  }
  std::vector<std::uint32_t> with_many;
  trees_->number.resize(owners);
  for (std::uint32_t o = 0; o < owners; ++o) {
    trees_->number[o] = static_cast<std::uint32_t>(with_many.size());
    if (sides_of(o).size() > many_sides) with_many.push_back(o);
  }
  trees_->trees.resize(with_many.size());
  parallel_for_each(with_many.size(), [&](std::size_t i) {
    std::vector<ImageBox> boxes;
    for (const PaperSide& s : sides_of(with_many[i])) boxes.push_back(box_around(s, 0));
    trees_->trees[i] = BoxTree(boxes);
  });
}

PaperPolygons::~PaperPolygons() = default;

template <class F>
void PaperPolygons::visit_sides(std::uint32_t owner, const ImageBox& near, const F& visit) const {
  const auto begin = static_cast<std::uint32_t>(first_side_[owner]), end = static_cast<std::uint32_t>(first_side_[owner + 1]);
  if (end - begin <= many_sides) {
    for (std::uint32_t k = begin; k < end; ++k) visit(k);
    return;
  }
  trees_->trees[trees_->number[owner]].visit_touching(near, [&](std::uint32_t i) {
    visit(begin + i);
    return true;
  });
}

double PaperPolygons::angle_at_start(std::uint32_t side) const {
  const Vector out = unit_along(sides_[side]), in = unit_along(sides_[before_[side]]);
  const double turn = turn_[sides_[side].owner] * (in.x * out.y - in.y * out.x);
  return std::numbers::pi - std::atan2(turn, in.x * out.x + in.y * out.y);
}

std::vector<PaperPoint> PaperPolygons::tent(std::uint32_t side) const {
  return is_plain_[sides_[side].owner] != 0 ? squeezed(side) : below_others(side);
}

/// The polygon itself, each corner halfway towards the middle half of the side: what lies between two points of a convex polygon
/// belongs to it.
std::vector<PaperPoint> PaperPolygons::squeezed(std::uint32_t side) const {
  const PaperSide& s = sides_[side];
  const Vector along = unit_along(s), inside = {-turn_[s.owner] * along.y, turn_[s.owner] * along.x};
  const double whole = length(minus(s.to, s.from));
  std::vector<PaperPoint> top;
  for (std::uint32_t k = before_[side]; k != after_[side]; k = before_[k]) {
    const Vector to = minus(sides_[k].from, s.from);
    if (to.x * inside.x + to.y * inside.y < 2) continue;
    const double foot = std::clamp(to.x * along.x + to.y * along.y, whole / 4, 3 * whole / 4);
    top.push_back({s.from.x + std::llround((to.x + foot * along.x) / 2), s.from.y + std::llround((to.y + foot * along.y) / 2)});
  }
  return top;
}

bool PaperPolygons::has_few_sides(std::uint32_t owner) const { return sides_of(owner).size() <= few_sides; }

double PaperPolygons::height(std::uint32_t side) const {
  const PaperSide& s = sides_[side];
  const Vector along = unit_along(s);
  double highest_corner = 0;
  for (const PaperSide& other : sides_of(s.owner)) {
    const Vector to = minus(other.from, s.from);
    highest_corner = std::max(highest_corner, std::fabs(to.x * along.y - to.y * along.x));
  }
  return highest_corner;
}

/// A roof in a few steps, each below half of what is above it and beside it, and no steeper than 45 degrees at its ends.
std::vector<PaperPoint> PaperPolygons::below_others(std::uint32_t side) const {
  const PaperSide& s = sides_[side];
  const Vector along = unit_along(s), inside = {-turn_[s.owner] * along.y, turn_[s.owner] * along.x};
  const double whole = length(minus(s.to, s.from));
  constexpr std::array<double, 7> steps = {0, 0.1, 0.3, 0.5, 0.7, 0.9, 1};
  std::array<double, steps.size()> height = {};
  for (std::size_t k = 0; k < steps.size(); ++k) height[k] = std::min({highest, steps[k] * whole, (1 - steps[k]) * whole});
  // What is farther than twice the greatest height lowers none.
  visit_sides(s.owner, box_around(s, std::min(2 * highest, whole)), [&](std::uint32_t k) {
    if (k == side) return;
    Vector a = minus(sides_[k].from, s.from), b = minus(sides_[k].to, s.from);
    a = {a.x * along.x + a.y * along.y, a.x * inside.x + a.y * inside.y};
    b = {b.x * along.x + b.y * along.y, b.x * inside.x + b.y * inside.y};
    if (a.x > b.x) std::swap(a, b);
    const auto at = [&](double x) { return b.x > a.x ? a.y + (x - a.x) / (b.x - a.x) * (b.y - a.y) : std::min(a.y, b.y); };
    for (std::size_t i = 1; i + 1 < steps.size(); ++i) {
      // A side that begins or ends at this one bounds the step where it stands, others from the step before to the one after.
      const bool is_next = k == before_[side] || k == after_[side];
      const double low = std::max(a.x, steps[is_next ? i : i - 1] * whole),
                   high = std::min(b.x, steps[is_next ? i : i + 1] * whole);
      if (low > high) continue;
      const double lower = std::min(at(low), at(high));
      if (lower > 0) height[i] = std::min(height[i], lower / 2);
    }
  });
  std::vector<PaperPoint> top;
  for (std::size_t i = steps.size() - 1; i-- > 1;)
    if (height[i] >= 1)
      top.push_back({s.from.x + std::llround(steps[i] * whole * along.x + height[i] * inside.x),
                     s.from.y + std::llround(steps[i] * whole * along.y + height[i] * inside.y)});
  std::reverse(top.begin(), top.end());
  return top;
}

double PaperPolygons::room(std::uint32_t side) const {
  const PaperSide& s = sides_[side];
  const std::uint32_t in = before_[side];
  double room = std::min({highest, length(minus(s.to, s.from)) / 2, length(minus(s.from, sides_[in].from)) / 2});
  visit_sides(s.owner, box_around(s.from, 2 * room), [&](std::uint32_t k) {
    if (k != side && k != in && sides_[k].from != s.from && sides_[k].to != s.from)
      room = std::min(room, distance_to(s.from, sides_[k]) / 2);
  });
  return room;
}

PaperPoint PaperPolygons::from_start(std::uint32_t side, double distance) const {
  return moved(sides_[side].from, unit_along(sides_[side]), distance);
}
PaperPoint PaperPolygons::from_end(std::uint32_t side, double distance) const {
  return moved(sides_[side].to, unit_along(sides_[side]), -distance);
}

PaperPoint PaperPolygons::inward(std::uint32_t side, double distance) const {
  const Vector out = unit_along(sides_[side]);
  const double half = angle_at_start(side) / 2, turn = turn_[sides_[side].owner];
  const Vector middle = {out.x * std::cos(half) - turn * out.y * std::sin(half),
                         out.y * std::cos(half) + turn * out.x * std::sin(half)};
  return moved(sides_[side].from, middle, distance);
}

bool PaperPolygons::is_wide(std::uint32_t side) const { return angle_at_start(side) > 2.0; }

}  // namespace hsr::internal
