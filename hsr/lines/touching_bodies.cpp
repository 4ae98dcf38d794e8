#include "hsr/lines/touching_bodies.h"

#include <algorithm>

#include "geometry/disjoint_sets.h"

namespace hsr::internal {

namespace {

/// The half-planes in the order in which they follow one another around the edge.
std::vector<HalfPlane*> in_turn(HalfPlanes& half_planes) {
  std::vector<HalfPlane*> all;
  for (HalfPlane& h : half_planes.all()) all.push_back(&h);
  const auto quarter = [](const HalfPlane& h) {
    if (h.side == Sign::zero) return h.is_front ? 0 : 2;
    return h.side == Sign::positive ? 1 : 3;
  };
  std::sort(all.begin(), all.end(), [&](const HalfPlane* x, const HalfPlane* y) {
    if (quarter(*x) != quarter(*y)) return quarter(*x) < quarter(*y);
    return x != y && (x->side == Sign::positive ? half_planes.is_nearer(*x, *y) : half_planes.is_nearer(*y, *x));
  });
  return all;
}

}  // namespace

Touching mark_contacts(HalfPlanes& half_planes) {
  std::size_t least = half_planes.all().empty() ? 0 : half_planes.all().front().faces(), most = least, surfaces = 0;
  for (const HalfPlane& h : half_planes.all()) {
    least = std::min(least, h.faces());
    most = std::max(most, h.faces());
  }
  if (most < 2) return Touching::nothing;
  for (const HalfPlane& h : half_planes.all()) surfaces += h.faces() == least ? 1U : 0U;
  if (least == most) return surfaces > 1 ? Touching::alike : Touching::open;
  if (surfaces % 2 != 0) return Touching::open;
  bool is_behind_surface = false, touch[2] = {false, false};
  for (const HalfPlane* h : in_turn(half_planes)) {
    if (h->faces() == least)
      is_behind_surface = !is_behind_surface;
    else
      touch[is_behind_surface ? 1 : 0] = true;
  }
  if (touch[0] && touch[1]) return Touching::open;
  for (HalfPlane& h : half_planes.all()) h.is_contact = h.faces() > least;
  return Touching::bodies;
}

bool goes_on(const HalfPlanes& half_planes, const HalfPlane& h) {
  const auto& all = half_planes.all();
  return std::any_of(all.begin(), all.end(), [&](const HalfPlane& other) {
    return &other != &h && other.faces() >= h.faces() && half_planes.side(h, other) == Sign::zero;
  });
}

TouchingRegions::TouchingRegions(std::span<const std::span<const CoincidentFaces>> logs) {
  for (const auto& log : logs)
    for (const CoincidentFaces& part : log)
      for (const auto& set : part.sets) numbers_.try_emplace(set, static_cast<std::uint32_t>(numbers_.size()));
  DisjointSets regions(numbers_.size());
  for (const auto& log : logs)
    for (const CoincidentFaces& part : log)
      if (part.touching == Touching::alike)
        for (const auto& set : part.sets) regions.join(numbers_.at(part.sets.front()), numbers_.at(set));
  for (std::uint32_t k = 0; k < numbers_.size(); ++k) region_of_.push_back(regions.find(k));
  touches_.resize(numbers_.size(), 0);
  is_open_.resize(numbers_.size(), 0);
  for (const auto& log : logs)
    for (const CoincidentFaces& part : log)
      for (const auto& set : part.sets) {
        if (part.touching == Touching::bodies) touches_[region(set)] = 1;
        if (part.touching == Touching::open) is_open_[region(set)] = 1;
      }
}

TouchingRegions::Verdict TouchingRegions::verdict(const CoincidentFaces& part) const {
  const std::uint32_t at = region(part.sets.front());
  if (touches_[at] == 0) return Verdict::apart;
  return is_open_[at] == 0 ? Verdict::touch : Verdict::in_doubt;
}

}  // namespace hsr::internal
