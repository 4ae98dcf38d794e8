#include "hsr/surfaces/cap_arrangement.h"

#include <algorithm>
#include <utility>

#include "geometry/bounded_rational.h"
#include "geometry/parallel.h"
#include "hsr/surfaces/place_numbers.h"

namespace hsr::internal {

namespace {

using Place = SectionCaps::ExactPlace;

Place difference(const Place& a, const Place& b) { return {a[0] - b[0], a[1] - b[1]}; }

/// Ascending from 0 to 1, each once.
void tidy(std::vector<Rational>& cuts) {
  const Rational zero = 0.0, one = 1.0;
  std::erase_if(cuts, [&](const Rational& x) { return x < zero || x > one; });
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
}

SectionCaps::Place bounded(const Place& p) { return {internal::bounded(p[0]), internal::bounded(p[1])}; }

}  // namespace

bool DirectedPart::is_parallel_to(const DirectedPart& other) const {
  const SectionCaps::Place a = about_along(), b = other.about_along();
  if ((a[0] * b[1] - a[1] * b[0]).is_certain()) return false;
  return cross(along(), other.along()).sign() == Sign::zero;
}

CapArrangement::CapArrangement(const SectionCaps& caps) : caps_(caps) {
  std::vector<std::vector<CapPart>> of_side(caps.sides().size());
  parallel_for_each(of_side.size(), [&](std::size_t k) { of_side[k] = parts_of(static_cast<std::uint32_t>(k)); });
  for (std::vector<CapPart>& parts : of_side)
    for (CapPart& part : parts) parts_.push_back(std::move(part));
  number_ends();
}

void CapArrangement::number_ends() {
  std::vector<NumberedPlace> ends;
  ends.reserve(2 * parts_.size());
  for (const CapPart& part : parts_) {
    ends.push_back({&part.from, {part.about_from[0].value, part.about_from[1].value}});
    ends.push_back({&part.to, {part.about_to[0].value, part.about_to[1].value}});
  }
  const std::vector<std::uint32_t> numbers = place_numbers(ends);
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    parts_[k].from_number = numbers[2 * k];
    parts_[k].to_number = numbers[2 * k + 1];
  }
}

/// Where the side `other` cuts a side or ends on it, as shares of the way along that.
void CapArrangement::add_cuts(const CapSide& own, std::uint32_t other, std::vector<Rational>& cuts) const {
  const CapSide& crossing = caps_.sides()[other];
  const Place &a = caps_.exact_place(own.from), &p = caps_.exact_place(crossing.from), &q = caps_.exact_place(crossing.to);
  const Place along = difference(caps_.exact_place(own.to), a), to_p = difference(p, a), to_q = difference(q, a);
  const Rational at_p = cross(along, to_p), at_q = cross(along, to_q);
  if (at_p.sign() * at_q.sign() == Sign::positive) return;
  const auto share = [&](const Place& d) { return along[0].sign() != Sign::zero ? d[0] / along[0] : d[1] / along[1]; };
  if (at_p.sign() == Sign::zero) cuts.push_back(share(to_p));
  if (at_q.sign() == Sign::zero) cuts.push_back(share(to_q));
  if (at_p.sign() * at_q.sign() != Sign::negative) return;
  const Rational s = at_p / (at_p - at_q);
  cuts.push_back(share({to_p[0] + s * (to_q[0] - to_p[0]), to_p[1] + s * (to_q[1] - to_p[1])}));
}

/// Whether doubles tell that the two sides have no place in common but a corner that they share. Most that are close are neighbours.
bool CapArrangement::certainly_apart(std::uint32_t k, std::uint32_t other) const {
  const CapSide &own = caps_.sides()[k], &o = caps_.sides()[other];
  const SectionCaps::Place &a = caps_.place(own.from), &b = caps_.place(own.to);
  const auto side_of = [&](std::uint32_t corner) {
    if (corner == own.from || corner == own.to) return Sign::zero;
    const SectionCaps::Place& p = caps_.place(corner);
    const ErrorBounded turn = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
    return turn.is_certain() ? sign_of(turn.value) : Sign::zero;
  };
  const Sign from = side_of(o.from), to = side_of(o.to);
  const auto is_shared = [&](std::uint32_t corner) { return corner == own.from || corner == own.to; };
  if (is_shared(o.from) && is_shared(o.to)) return false;
  // Where a wall that is cut has a diagonal, the one goes straight on from the other.
  const auto leads_away = [&](std::uint32_t shared, std::uint32_t end) {
    const SectionCaps::Place &at = caps_.place(shared), &p = caps_.place(end),
                             &q = caps_.place(shared == own.from ? own.to : own.from);
    const ErrorBounded product = (p[0] - at[0]) * (q[0] - at[0]) + (p[1] - at[1]) * (q[1] - at[1]);
    return product.is_certain() && product.value < 0;
  };
  if (is_shared(o.from)) return to != Sign::zero || leads_away(o.from, o.to);
  if (is_shared(o.to)) return from != Sign::zero || leads_away(o.to, o.from);
  return from * to == Sign::positive;
}

std::vector<CapPart> CapArrangement::parts_of(std::uint32_t k) const {
  std::vector<CapPart> parts;
  std::vector<Rational> cuts;
  const CapSide& side = caps_.sides()[k];
  const Place &a = caps_.exact_place(side.from), &b = caps_.exact_place(side.to);
  bool is_alone = true;
  caps_.visit_sides(caps_.place(side.from), caps_.place(side.to), [&](std::uint32_t other) {
    if (other == k || certainly_apart(k, other)) return;
    is_alone = false;
    add_cuts(side, other, cuts);
  });
  if (is_alone)
    if (auto hands = caps_.certain_hands(k)) {
      if (hands->left != hands->right)
        parts.push_back(
            {k, a, b, caps_.place(side.from), caps_.place(side.to), std::move(hands->left), std::move(hands->right)});
      return parts;
    }
  cuts.insert(cuts.end(), {0.0, 1.0});
  tidy(cuts);
  const Place along = difference(b, a), across = {-along[1], along[0]};
  const auto at = [&](const Rational& share) { return Place{a[0] + share * along[0], a[1] + share * along[1]}; };
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    CapPart part{k, at(cuts[i]), at(cuts[i + 1]), {}, {}, {}, {}};
    part.about_from = bounded(part.from);
    part.about_to = bounded(part.to);
    const Place middle = at((cuts[i] + cuts[i + 1]) * Rational(0.5));
    std::optional<std::uint32_t> least;
    part.left = caps_.objects_beside(middle, across, least);
    if (least && *least < k) continue;  // it stands there already
    part.right = caps_.objects_beside(middle, {-across[0], -across[1]}, least);
    if (part.left != part.right) parts.push_back(std::move(part));
  }
  return parts;
}

std::vector<std::array<Rational, 2>> CapArrangement::uncovered(const CapSide& open) const {
  std::vector<Rational> cuts = {0.0, 1.0};
  caps_.visit_sides(caps_.place(open.from), caps_.place(open.to), [&](std::uint32_t other) { add_cuts(open, other, cuts); });
  tidy(cuts);
  const Place &a = caps_.exact_place(open.from), along = difference(caps_.exact_place(open.to), a);
  std::vector<std::array<Rational, 2>> parts;
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    const Rational middle = (cuts[k] + cuts[k + 1]) * Rational(0.5);
    if (!caps_.covers(SectionCaps::ExactPlace{a[0] + middle * along[0], a[1] + middle * along[1]}))
      parts.push_back({cuts[k], cuts[k + 1]});
  }
  return parts;
}

std::vector<CapRun> CapArrangement::runs(const std::function<bool(const CapPart&)>& is_chosen,
                                         const std::function<bool(const DirectedPart&, const DirectedPart&)>& agree) const {
  struct PartsAt {
    std::uint32_t count = 0;
    std::array<std::uint32_t, 2> first = {};
    void add(std::uint32_t part) {
      if (count < 2) first[count] = part;
      ++count;
    }
  };
  std::vector<PartsAt> ends(2 * parts_.size());  // by number of a place
  std::vector<char> is_used(parts_.size(), 1);
  for (std::uint32_t k = 0; k < parts_.size(); ++k) {
    if (!is_chosen(parts_[k])) continue;
    is_used[k] = 0;
    ends[parts_[k].from_number].add(k);
    ends[parts_[k].to_number].add(k);
  }
  const auto next = [&](const DirectedPart& end) -> std::optional<DirectedPart> {
    const PartsAt& there = ends[end.to_number()];
    if (there.count != 2) return {};
    const std::uint32_t k = &parts_[there.first[0]] == end.part ? there.first[1] : there.first[0];
    const DirectedPart on{&parts_[k], parts_[k].to_number == end.to_number()};
    if (is_used[k] != 0 || !end.is_parallel_to(on) || !agree(end, on)) return {};
    is_used[k] = 1;
    return on;
  };
  const auto last_from = [&](DirectedPart end) {
    while (const auto on = next(end)) end = *on;
    return end;
  };
  std::vector<CapRun> runs;
  for (std::uint32_t k = 0; k < parts_.size(); ++k) {
    if (std::exchange(is_used[k], char{1}) != 0) continue;
    const DirectedPart last = last_from({&parts_[k], false}), first = last_from({&parts_[k], true});
    runs.push_back({{first.part, !first.reversed}, last});
  }
  return runs;
}

std::optional<std::uint32_t> CapArrangement::side_across(const Place& at, const DirectedPart& part) const {
  const SectionCaps::Place about = bounded(at);
  const Place along = part.along();
  std::optional<std::uint32_t> found;
  caps_.visit_sides(about, about, [&](std::uint32_t k) {
    const Place &a = caps_.exact_place(caps_.sides()[k].from), &b = caps_.exact_place(caps_.sides()[k].to);
    const Place d = difference(b, a), to_a = difference(a, at), to_b = difference(b, at);
    if (cross(d, along).sign() == Sign::zero || cross(to_a, to_b).sign() != Sign::zero) return;
    if ((to_a[0] * to_b[0] + to_a[1] * to_b[1]).sign() == Sign::positive) return;
    found = std::min(k, found.value_or(k));
  });
  return found;
}

RationalVector CapArrangement::point(std::uint32_t side, const Place& at) const {
  const CapSide& s = caps_.sides()[side];
  const Place &a = caps_.exact_place(s.from), &b = caps_.exact_place(s.to);
  RationalVector p = caps_.point(s.from);
  if (at == a) return p;
  if (at == b) return caps_.point(s.to);
  const RationalVector along = minus(caps_.point(s.to), p);
  const Place d = difference(b, a), to = difference(at, a);
  const Rational share = d[0].sign() != Sign::zero ? to[0] / d[0] : to[1] / d[1];
  for (std::size_t k = 0; k < 3; ++k) p[k] = p[k] + share * along[k];
  return p;
}

}  // namespace hsr::internal
