#include "hsr/painter/verify/verify.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <tuple>

#include "hsr/painter/verify/order_witness.h"
#include "hsr/painter/verify/painted_parts.h"
#include "hsr/painter/verify/wire_relation.h"
#include "hsr/scene/box_tree.h"

namespace hsr {

using namespace internal;

namespace {

constexpr std::uint32_t none = 0xffffffffU;

/// Two convex parts whose images overlap, the earlier painted first.
struct PartPair {
  std::uint32_t earlier, later;
  bool is_right, is_wrong;  // the later is the nearer, the farther, somewhere
  bool is_coplanar;         // in one plane: right or wrong by the faces, or neither
  bool is_twice;            // of one face, in one plane
};

/// Two painted polygons: the parts that show each thing said of them, or none.
struct PolygonPair {
  std::uint32_t right = none, wrong = none, twice = none;  // numbers of part pairs
};

/// Points of the parts, in rationals: for what is written.
class WitnessFinder {
 public:
  WitnessFinder(const PaintedParts& parts, const View& view) : parts_(parts), view_(view) {}

  /// Where `farther` is the farther, if it is somewhere, or else in the middle of their common part.
  Witness witness(std::uint32_t farther, std::uint32_t nearer, bool is_coplanar) const;

 private:
  struct Flat {
    RationalVector normal, on;
    std::vector<ImagePlace> ring;
  };
  Flat flat(std::uint32_t part) const;
  static std::vector<ImagePlace> common(const Flat& a, const Flat& b);
  Rational gap(const Flat& farther, const Flat& nearer, const ImagePlace& at) const {
    const ImageRows& rows = parts_.rows();
    return rows.depth(rows.point(farther.normal, farther.on, at)) - rows.depth(rows.point(nearer.normal, nearer.on, at));
  }

  const PaintedParts& parts_;
  const View& view_;
};

WitnessFinder::Flat WitnessFinder::flat(std::uint32_t number) const {
  const PaintedPart& part = parts_.parts()[number];
  const PaintedPoints& points = parts_.points();
  Flat out;
  out.on = points.exact(part.plane[0]);
  out.normal = cross(minus(points.exact(part.plane[1]), out.on), minus(points.exact(part.plane[2]), out.on));
  for (const std::uint32_t c : parts_.corners_of(part)) out.ring.push_back(parts_.rows().place(points.exact(c)));
  return out;
}

Rational orientation(const ImagePlace& a, const ImagePlace& b, const ImagePlace& p) {
  return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

Sign around(const std::vector<ImagePlace>& ring) {
  Rational area;
  for (std::size_t k = 1; k + 1 < ring.size(); ++k) area = area + orientation(ring[0], ring[k], ring[k + 1]);
  return area.sign();
}

std::vector<ImagePlace> WitnessFinder::common(const Flat& a, const Flat& b) {
  std::vector<ImagePlace> ring = a.ring;
  const Rational inward = around(b.ring) == Sign::negative ? -1.0 : 1.0;
  for (std::size_t k = 0; k < b.ring.size() && !ring.empty(); ++k) {
    const ImagePlace &from = b.ring[k], &to = b.ring[(k + 1) % b.ring.size()];
    std::vector<ImagePlace> out;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const ImagePlace &p = ring[i], &q = ring[(i + 1) % ring.size()];
      const Rational s = inward * orientation(from, to, p), t = inward * orientation(from, to, q);
      if (s.sign() != Sign::negative) out.push_back(p);
      if (s.sign() * t.sign() != Sign::negative) continue;
      const Rational u = s / (s - t);
      out.push_back({p[0] + u * (q[0] - p[0]), p[1] + u * (q[1] - p[1])});
    }
    out.erase(std::unique(out.begin(), out.end()), out.end());
    ring = std::move(out);
  }
  return ring;
}

Witness WitnessFinder::witness(std::uint32_t farther, std::uint32_t nearer, bool is_coplanar) const {
  for (const bool is_in_front : {false, true}) {
    const auto &wire = parts_.parts()[is_in_front ? nearer : farther], &other = parts_.parts()[is_in_front ? farther : nearer];
    if (!wire.is_wire()) continue;
    Witness w = WireRelation(parts_, view_, wire, other).witness(is_in_front);
    if (is_in_front) std::swap(w.of_earlier, w.of_later);
    return w;
  }
  const Flat far = flat(farther), near = flat(nearer);
  const std::vector<ImagePlace> part = common(far, near);
  ImagePlace middle;
  for (const ImagePlace& p : part)
    for (std::size_t k = 0; k < 2; ++k) middle[k] = middle[k] + p[k] / Rational(static_cast<double>(part.size()));
  const auto is_there = [&](const ImagePlace& p) { return is_coplanar || gap(far, near, p).sign() == Sign::positive; };
  // From the middle, which is strictly inside, halfway toward a corner where it is farther until it is there.
  for (const ImagePlace& corner : part) {
    if (is_there(middle)) break;
    if (!is_there(corner)) continue;
    while (!is_there(middle))
      for (std::size_t k = 0; k < 2; ++k) middle[k] = (middle[k] + corner[k]) / Rational(2.0);
  }
  Witness w;
  w.of_earlier = parts_.rows().point(far.normal, far.on, middle);
  w.of_later = parts_.rows().point(near.normal, near.on, middle);
  w.place = image(view_, w.of_earlier);
  return w;
}

class Verifier {
 public:
  Verifier(const std::vector<PaintedPolygon>& all, const View& view, const VerifyOptions& options)
      : all_(all), view_(view), options_(options), parts_(all, view), finder_(parts_, view) {}

  Verdict verdict() {
    verdict_.polygons = parts_.polygons_with_area();
    verdict_.triangulated = parts_.triangulated();
    verdict_.wires = parts_.wires();
    find_part_pairs();
    unite_pairs();
    count_and_describe();
    verdict_.cuts_that_suffice = 0;
    if (verdict_.wrong > 0) look_for_an_order();
    return std::move(verdict_);
  }

 private:
  std::uint32_t polygon_of(std::uint32_t part) const { return parts_.parts()[part].polygon; }
  std::optional<PartPair> relation(PaintedSides& sides, std::uint32_t i, std::uint32_t k) const;
  std::optional<PartPair> wire_relation(std::uint32_t i, std::uint32_t k) const;
  void find_part_pairs();
  void unite_pairs();
  Witness witness(std::uint32_t pair, bool is_right) const;
  void count_and_describe();
  void look_for_an_order();
  std::optional<std::uint64_t> cuts(const std::vector<std::uint32_t>& component) const;

  const std::vector<PaintedPolygon>& all_;
  const View& view_;
  const VerifyOptions& options_;
  PaintedParts parts_;
  WitnessFinder finder_;
  std::vector<PartPair> part_pairs_;
  std::vector<PolygonPair> pairs_;
  Verdict verdict_;
};

std::optional<PartPair> Verifier::wire_relation(std::uint32_t i, std::uint32_t k) const {
  const PaintedPart &earlier = parts_.parts()[i], &later = parts_.parts()[k];
  if (earlier.is_wire() && later.is_wire()) return {};
  const WireRelation found(parts_, view_, earlier.is_wire() ? earlier : later, earlier.is_wire() ? later : earlier);
  if (!found.overlaps()) return {};
  return PartPair{i,
                  k,
                  later.is_wire() ? found.is_in_front() : found.is_behind(),
                  later.is_wire() ? found.is_behind() : found.is_in_front(),
                  false,
                  false};
}

std::optional<PartPair> Verifier::relation(PaintedSides& sides, std::uint32_t i, std::uint32_t k) const {
  if (polygon_of(i) > polygon_of(k)) std::swap(i, k);
  if (parts_.parts()[i].is_wire() || parts_.parts()[k].is_wire()) return wire_relation(i, k);
  const auto found = nearer(parts_, sides, parts_.parts()[i], parts_.parts()[k]);
  if (!found) return {};
  PartPair pair{i, k, found->second, found->first, !found->first && !found->second, false};
  if (!pair.is_coplanar) return pair;
  const auto &f = all_[polygon_of(i)].face, &g = all_[polygon_of(k)].face;
  if (!f || !g) return pair;  // nothing says which comes first
  pair.is_right = options_.ties.is_above(*g, *f);
  pair.is_wrong = options_.ties.is_above(*f, *g);
  pair.is_twice = *f == *g;
  return pair;
}

void Verifier::find_part_pairs() {
  const std::vector<ImageBox> boxes = parts_.boxes();
  const BoxTree tree(boxes);
  constexpr std::size_t block = 32;
  std::vector<std::vector<PartPair>> found((tree.leaf_count() + block - 1) / block);
  tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t at) {
    PaintedSides sides(parts_.points(), parts_.rows(), view_);
    BoxTree::PairSearch search;
    const std::size_t end = std::min<std::size_t>((at + 1) * block, tree.leaf_count());
    for (std::size_t leaf = at * block; leaf < end; ++leaf)
      tree.visit_pairs<BoxTree::Depth::any>(static_cast<std::uint32_t>(leaf), search, [&](std::uint32_t i, std::uint32_t k) {
        if (polygon_of(i) == polygon_of(k)) return;
        if (const auto pair = relation(sides, i, k)) found[at].push_back(*pair);
      });
  });
  for (auto& some : found) {
    part_pairs_.insert(part_pairs_.end(), some.begin(), some.end());
    std::vector<PartPair>().swap(some);
  }
  tbb::parallel_sort(part_pairs_.begin(), part_pairs_.end(), [&](const PartPair& x, const PartPair& y) {
    return std::tuple(polygon_of(x.earlier), polygon_of(x.later), x.earlier, x.later) <
           std::tuple(polygon_of(y.earlier), polygon_of(y.later), y.earlier, y.later);
  });
}

/// Several parts of two polygons may overlap: each may show another thing.
void Verifier::unite_pairs() {
  std::array<std::uint32_t, 2> last = {none, none};
  for (std::uint32_t k = 0; k < part_pairs_.size(); ++k) {
    const PartPair& p = part_pairs_[k];
    const std::array<std::uint32_t, 2> who = {polygon_of(p.earlier), polygon_of(p.later)};
    if (who != last) {
      ++verdict_.overlapping;
      pairs_.emplace_back();
    }
    last = who;
    PolygonPair& pair = pairs_.back();
    const auto show = [&](bool does, std::uint32_t& by) {
      if (does && (by == none || (part_pairs_[by].is_coplanar && !p.is_coplanar))) by = k;
    };
    show(p.is_right, pair.right);
    show(p.is_wrong, pair.wrong);
    show(p.is_twice, pair.twice);
  }
}

Witness Verifier::witness(std::uint32_t pair, bool is_right) const {
  const PartPair& p = part_pairs_[pair];
  return is_right ? finder_.witness(p.earlier, p.later, p.is_coplanar) : finder_.witness(p.later, p.earlier, p.is_coplanar);
}

void Verifier::count_and_describe() {
  for (const PolygonPair& pair : pairs_) {
    const bool is_wrong = pair.wrong != none, is_twice = pair.twice != none, is_piercing = is_wrong && pair.right != none;
    if (!is_wrong && !is_twice) continue;
    verdict_.wrong += is_wrong ? 1 : 0;
    verdict_.piercing += is_piercing ? 1 : 0;
    verdict_.covered_twice += is_twice ? 1 : 0;
    if (verdict_.first.size() >= options_.limit) continue;
    const std::uint32_t by = is_wrong ? pair.wrong : pair.twice;
    Violation v;
    v.earlier = polygon_of(part_pairs_[by].earlier);
    v.later = polygon_of(part_pairs_[by].later);
    v.fault = !is_wrong                     ? Fault::covered_twice
              : is_piercing                 ? Fault::piercing
              : part_pairs_[by].is_coplanar ? Fault::coplanar
                                            : Fault::order;
    v.witness = witness(by, false);
    std::swap(v.witness.of_earlier, v.witness.of_later);
    verdict_.first.push_back(std::move(v));
  }
}

void Verifier::look_for_an_order() {
  std::vector<Precedence> all;
  std::vector<std::array<std::uint32_t, 2>> shown;  // by precedence: the pair of parts, and whether it is right
  for (const PolygonPair& pair : pairs_) {
    for (const bool is_right : {true, false}) {
      const std::uint32_t by = is_right ? pair.right : pair.wrong;
      if (by == none) continue;
      const std::uint32_t earlier = polygon_of(part_pairs_[by].earlier), later = polygon_of(part_pairs_[by].later);
      all.push_back(is_right ? Precedence{earlier, later} : Precedence{later, earlier});
      shown.push_back({by, is_right ? 1U : 0U});
    }
  }
  const OrderWitness found = order_witness(static_cast<std::uint32_t>(all_.size()), all);
  if (found.components.empty()) return;
  verdict_.order_exists = false;
  for (const std::uint32_t k : found.cycle) {
    verdict_.cycle.push_back(all[k].first);
    verdict_.cycle_witnesses.push_back(witness(shown[k][0], shown[k][1] == 1));
  }
  for (const auto& component : found.components) {
    const auto more = cuts(component);
    if (!more) verdict_.cuts_that_suffice.reset();
    if (verdict_.cuts_that_suffice) *verdict_.cuts_that_suffice += *more;
  }
}

std::optional<std::uint64_t> Verifier::cuts(const std::vector<std::uint32_t>& component) const {
  constexpr std::size_t most = 4000;
  std::vector<std::uint32_t> mine;
  for (const std::uint32_t polygon : component) {
    const auto [first, end] = parts_.parts_of(polygon);
    for (std::uint32_t k = first; k < end; ++k) mine.push_back(k);
  }
  if (mine.size() > most) return {};
  std::vector<std::uint64_t> counts(mine.size());
  tbb::parallel_for(std::size_t{0}, mine.size(), [&](std::size_t at) {
    PaintedSides sides(parts_.points(), parts_.rows(), view_);
    for (const std::uint32_t plane : mine) {
      if (parts_.parts()[plane].is_wire()) continue;
      bool before = false, behind = false;
      for (const std::uint32_t c : parts_.corners_of(parts_.parts()[mine[at]])) {
        const Sign s = before_plane(sides, parts_.parts()[plane], c);
        before = before || s == Sign::positive;
        behind = behind || s == Sign::negative;
      }
      counts[at] += before && behind ? 1 : 0;
    }
  });
  std::uint64_t count = mine.size() - component.size();  // into triangles
  for (const std::uint64_t c : counts) count += c;
  return count;
}

}  // namespace

std::vector<PaintedPolygon> painted_polygons(const SceneView& scene, const PaintersOrder& order) {
  // Piece k, and the wires that come before it.
  std::vector<std::vector<PaintedPolygon>> polygons(order.pieces.size() + 1);
  tbb::parallel_for(std::size_t{0}, polygons.size(), [&](std::size_t k) {
    auto wire = std::ranges::lower_bound(order.wires, k, {}, &OrderedWire::before);
    for (; wire != order.wires.end() && wire->before == k; ++wire) {
      const auto ends = exact_ends(scene.mesh(), *wire);
      polygons[k].push_back({{}, {ends.begin(), ends.end()}});
    }
    if (k == order.pieces.size()) return;
    const OrderedPiece& piece = order.pieces[k];
    PaintedPolygon& polygon = polygons[k].emplace_back();
    polygon.face = scene.mesh().face_of[first_triangle(piece.facet)].value;
    for (const PieceCorner& corner : order.corners_of(piece))
      polygon.corners.push_back(exact_point(scene.mesh(), scene.view(), piece.facet, corner));
  });
  std::vector<PaintedPolygon> all;
  for (auto& some : polygons) all.insert(all.end(), std::make_move_iterator(some.begin()), std::make_move_iterator(some.end()));
  return all;
}

Verdict verify(const std::vector<PaintedPolygon>& far_to_near, const View& view, const VerifyOptions& options) {
  return Verifier(far_to_near, view, options).verdict();
}

}  // namespace hsr
