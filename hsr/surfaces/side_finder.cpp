#include "hsr/surfaces/side_finder.h"

#include <algorithm>
#include <cmath>

#include "geometry/error.h"
#include "hsr/scene/facet.h"
#include "hsr/scene/segment_filter.h"
#include "hsr/surfaces/fragment_observer.h"
#include "hsr/symbols/constructions.h"
#include "hsr/symbols/cut_plane.h"

namespace hsr::internal {

TriangleId SideFinder::only_triangle(EdgeId e, Sign side) const {
  if (intersections_.has_contact[e.value] != 0) return {};
  const Edge& edge = mesh_.edges[e];
  // In the near plane: the triangle may be on the side that is cut away.
  if (projected_.beyond_near(edge.a) == Sign::zero && projected_.beyond_near(edge.b) == Sign::zero) return {};
  TriangleId only;
  for (const TriangleId t : mesh_.triangles_at(e)) {
    if (projected_.side_of_edge(t, edge) != side) continue;
    if (only.is_valid()) return {};
    only = t;
  }
  return only;
}

MapPoint SideFinder::point_at(const Edge& edge, TriangleId beside, const Cut& cut) const {
  const MapLine line = MapLine::edge(edge.a, edge.b);
  switch (cut.kind) {
    case Cut::Kind::start:
      return MapPoint::of_vertex(edge.a);
    case Cut::Kind::end:
      return MapPoint::of_vertex(edge.b);
    case Cut::Kind::sight:
      return MapPoint::crossing(line, MapLine::edge(VertexId(cut.u), VertexId(cut.v)));
    case Cut::Kind::face:
      return MapPoint::crossing(line, MapLine::meet(TriangleId(cut.u), beside));
    case Cut::Kind::near:
      return MapPoint::crossing(line, MapLine::near(beside));
    case Cut::Kind::near_line:
      return MapPoint::crossing(line, MapLine::near(TriangleId(cut.u)));
    case Cut::Kind::line:
    case Cut::Kind::across:
    case Cut::Kind::sight_of_vertex:
    case Cut::Kind::near_line_end:
    case Cut::Kind::fold:
      break;
  }
  throw InvariantError("visible_fragments: an edge cut within an edge-on plane, where no edge-on face was looked at");
}

void SideFinder::add_edge(const VisibleLines& lines, const Line& line) {
  const Edge& edge = mesh_.edges[line.edge];
  const TriangleId left = only_triangle(line.edge, Sign::positive), right = only_triangle(line.edge, Sign::negative);
  if (left.is_valid() && right.is_valid() && facet_of(mesh_, left) == facet_of(mesh_, right)) return;
  TriangleId beside;
  for (const TriangleId t : mesh_.triangles_at(line.edge))
    if (!beside.is_valid() && projected_.facing(t) != Sign::zero) beside = t;
  const auto cuts = lines.cuts_of(line);
  MapStretch stretch;
  stretch.line = MapLine::edge(edge.a, edge.b);
  stretch.is_visible = true;
  for (std::uint32_t k = 0; k < line.intervals(); ++k) {
    if (line.hidden(k)) continue;
    const Cut &from = cuts[k], &to = cuts[k + 1];
    stretch.from = point_at(edge, beside, from);
    stretch.to = point_at(edge, beside, to);
    stretch.at_a = from.kind == Cut::Kind::start ? edge.a : VertexId();
    stretch.at_b = to.kind == Cut::Kind::end ? edge.b : VertexId();
    stretch.a = place_of(edge, from);
    stretch.b = place_of(edge, to);
    add(stretch, left, right);
  }
}

void SideFinder::add_intersection(const TriangleIntersection& crossing) {
  const MapLine line = MapLine::meet(crossing.s, crossing.t);
  const auto point = [&](const Cut& cut) {
    const bool is_near = cut.kind == Cut::Kind::near;
    return MapPoint::crossing(line, is_near ? MapLine::near(crossing.s) : MapLine::edge(VertexId(cut.u), VertexId(cut.v)));
  };
  const MapPoint from = point(crossing.from), to = point(crossing.to);
  MapStretch stretch{line, from, to, end_of(crossing, crossing.from, from), end_of(crossing, crossing.to, to)};
  if (runs_along(crossing, stretch) == Sign::negative) {
    std::swap(stretch.from, stretch.to);
    std::swap(stretch.a, stretch.b);
  }
  if (caps_ != nullptr) {
    for (const MapStretch& part : outside_caps(stretch, crossing.s)) add(part, {}, {});
    return;
  }
  if (!occluders_.is_prepared()) {
    add(stretch, {}, {});
    return;
  }
  stretch.first = {&occluders_.faces()[place_[crossing.s.value]], &occluders_.faces()[place_[crossing.t.value]]};
  const LineEnvelope::EnvelopePair meeting = left_.both_sides(stretch);
  if (meeting.is_for_both)
    add_meeting(stretch, meeting.left);
  else
    add(stretch, {}, {});
}

/// Whether the ends of an intersection are in the order of its line, along its image. Where a corner of s is before the plane
/// of t, MapPredicates::nearer(s, t) tells on which side of the line it is seen: to the left iff facing(s) t(corner) > 0.
Sign SideFinder::runs_along(const TriangleIntersection& crossing, const MapStretch& stretch) {
  const BoundedPoint2 a = projected_.image(stretch.a.p, 3 * stretch.a.error),
                      b = projected_.image(stretch.b.p, 3 * stretch.b.error);
  const SegmentFilter image(a.p, b.p, std::max({a.error, b.error, projected_.image_error()}));
  const PlaneFilter plane = projected_.filter(projected_.face_plane(crossing.t));
  for (const VertexId v : mesh_.triangles[crossing.s]) {
    const ErrorBounded at_v = plane(projected_.point(v));
    if (!at_v.is_certain() || !(projected_.image_error() < HUGE_VAL)) continue;
    const ErrorBounded turn = image.turn(projected_.image(v));
    if (turn.is_certain()) return sign_of(at_v.value) * sign_of(turn.value) * projected_.facing(crossing.s);
  }
  return -map_.order(stretch.line, stretch.from, stretch.to);
}

/// Of the two faces that meet, what is seen to the left ends where the other one begins.
void SideFinder::add_meeting(const MapStretch& stretch, std::span<const SeenPart> left) {
  if (observer_ != nullptr) observer_->looked_beside(stretch, left, {});
  const TriangleId s = stretch.first[0]->triangle, t = stretch.first[1]->triangle;
  double from_t = 0, from_error = 0;
  for (const SeenPart& part : left) {
    if (part.seen == s || part.seen == t) {
      const MapPlace from = place(stretch, part.from, from_t, from_error),
                     to = place(stretch, part.to, part.to_t, part.to_error);
      const FacetId l = facet_of(mesh_, part.seen), r = facet_of(mesh_, part.seen == s ? t : s);
      add_side(l, {{stretch.line, false, part.from, part.to}, from, to});
      add_side(r, {{stretch.line, true, part.to, part.from}, to, from});
    }
    from_t = part.to_t;
    from_error = part.to_error;
  }
}

/// Where an intersection ends in space: where an edge of one triangle meets the plane of the other. @param seen where
BoundedPoint3 SideFinder::end_of(const TriangleIntersection& crossing, const Cut& cut, const MapPoint& seen) const {
  if (cut.kind == Cut::Kind::sight) {
    const VertexId u(cut.u), v(cut.v);
    const TriangleId other = mesh_.has_corner(crossing.s, u) && mesh_.has_corner(crossing.s, v) ? crossing.t : crossing.s;
    const PlaneFilter plane = projected_.filter(projected_.face_plane(other));
    const auto value = [&](VertexId x) { return mesh_.has_corner(other, x) ? ErrorBounded{} : plane(projected_.point(x)); };
    const ErrorBounded at_u = value(u);
    const BoundedPoint3 end = between(projected_.point(u), projected_.point(v), quotient(at_u, at_u - value(v)));
    if (end.error < norm_max(end.p) * 0x1p-20) return end;
  }
  return map_.point(seen, crossing.s);
}

/// The part of a triangle in the near plane, where it has been cut; or its side there, which may be a diagonal of its face.
void SideFinder::add_near_cut(TriangleId t) {
  const auto& c = mesh_.triangles[t];
  if (std::none_of(c.begin(), c.end(), [&](VertexId v) { return projected_.beyond_near(v) == Sign::positive; })) return;
  const MapLine line = MapLine::near(t);
  std::vector<MapPoint> ends;
  for (std::size_t k = 0; k < 3; ++k) {
    const VertexId u = c[k], v = c[(k + 1) % 3];
    if (projected_.beyond_near(u) == Sign::zero) ends.push_back(MapPoint::of_vertex(u));
    if (projected_.beyond_near(u) * projected_.beyond_near(v) == Sign::negative)
      ends.push_back(MapPoint::crossing(line, MapLine::edge(u, v)));
  }
  if (ends.size() != 2) return;
  if (map_.order(line, ends[0], ends[1]) == Sign::positive) std::swap(ends[0], ends[1]);
  const MapStretch stretch = {line, ends[0], ends[1], map_.point(ends[0], t), map_.point(ends[1], t)};
  if (caps_ == nullptr) {
    add(stretch, {}, {});
  } else {
    for (const MapStretch& part : outside_caps(stretch, t)) add(part, {}, {});
  }
}

BoundedPoint3 SideFinder::scaled_point(const RationalVector& given) const {
  const Point3 p = projected_.scaled({given[0].to_double(), given[1].to_double(), given[2].to_double()});
  return {p, 2 * ErrorBounded::u * norm_max(p) + 0x1p-1000};
}

/// What of a stretch no cap covers. @param beside a triangle that has the stretch, and is not seen edge-on
std::vector<MapStretch> SideFinder::outside_caps(const MapStretch& stretch, TriangleId beside) {
  const FacetId facet = facet_of(mesh_, beside);
  const auto seen_at = [&](const MapPoint& p) { return caps_->seen_at(exact_point(mesh_, caps_->view(), facet, p)); };
  const auto bounded = [](const SectionCaps::ExactPlace& at) {
    const auto number = [](const Rational& x) {
      const double d = x.to_double();
      return ErrorBounded{d, ErrorBounded::u * std::fabs(d) + 0x1p-1074};
    };
    return SectionCaps::Place{number(at[0]), number(at[1])};
  };
  std::vector<MapPoint> cuts = {stretch.from, stretch.to};
  caps_->visit_sides(bounded(seen_at(stretch.from)), bounded(seen_at(stretch.to)), [&](std::uint32_t k) {
    const MapLine side = MapLine::near(caps_->sides()[k].triangle);
    if (side != stretch.line && map_.turn(stretch.line, side) != Sign::zero)
      cuts.push_back(MapPoint::crossing(stretch.line, side));
    // Along the stretch itself a side ends where another begins.
    for (const std::uint32_t corner : {caps_->sides()[k].from, caps_->sides()[k].to}) {
      const auto& [a, b] = caps_->corners()[corner];
      if (a == b && map_.side(stretch.line, a) == Sign::zero) cuts.push_back(MapPoint::of_vertex(a));
      if (a != b && stretch.line != MapLine::edge(a, b) && map_.turn(stretch.line, MapLine::edge(a, b)) != Sign::zero)
        cuts.push_back(MapPoint::crossing(stretch.line, MapLine::edge(a, b)));
    }
  });
  std::erase_if(cuts, [&](const MapPoint& p) {
    return map_.order(stretch.line, p, stretch.from) == Sign::negative ||
           map_.order(stretch.line, stretch.to, p) == Sign::negative;
  });
  std::stable_sort(cuts.begin(), cuts.end(),
                   [&](const MapPoint& p, const MapPoint& q) { return map_.order(stretch.line, p, q) == Sign::negative; });
  std::vector<MapStretch> parts;
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    if (map_.order(stretch.line, cuts[k], cuts[k + 1]) != Sign::negative) continue;
    const SectionCaps::ExactPlace from = seen_at(cuts[k]), to = seen_at(cuts[k + 1]);
    if (caps_->covers(SectionCaps::ExactPlace{(from[0] + to[0]) * Rational(0.5), (from[1] + to[1]) * Rational(0.5)})) continue;
    MapStretch part;
    part.line = stretch.line;
    part.from = cuts[k];
    part.to = cuts[k + 1];
    part.a = scaled_point(exact_point(mesh_, caps_->view(), facet, part.from));
    part.b = scaled_point(exact_point(mesh_, caps_->view(), facet, part.to));
    parts.push_back(part);
  }
  return parts;
}

/// The border of all caps together: what is seen outside ends there.
void SideFinder::add_cap_border(const CapArrangement& caps, const CapRun& run) {
  const auto near = [&](std::uint32_t side) { return MapLine::near(caps_->sides()[side].triangle); };
  const auto from = caps.side_across(run.first.from(), run.first), to = caps.side_across(run.last.to(), run.last);
  if (!from || !to) throw InvariantError("visible_fragments: a border of a cap that ends in itself");
  const std::uint32_t side = run.first.part->side;
  MapStretch stretch;
  stretch.line = near(side);
  stretch.from = MapPoint::crossing(stretch.line, near(*from));
  stretch.to = MapPoint::crossing(stretch.line, near(*to));
  stretch.a = scaled_point(caps.point(side, run.first.from()));
  stretch.b = scaled_point(caps.point(run.last.part->side, run.last.to()));
  Sign outside = run.first.left().empty() ? Sign::positive : Sign::negative;
  if (caps_->is_mirrored()) outside = -outside;
  if (map_.order(stretch.line, stretch.from, stretch.to) == Sign::positive) {
    std::swap(stretch.from, stretch.to);
    std::swap(stretch.a, stretch.b);
    outside = -outside;
  }
  const SeenPart nothing{stretch.from, stretch.to, {}, 1, 0};
  if (outside == Sign::positive)
    add_different(stretch, left_.find(stretch, Sign::positive), std::span(&nothing, 1));
  else
    add_different(stretch, std::span(&nothing, 1), right_.find(stretch, Sign::negative));
}

/// Where an edge is cut, in space.
BoundedPoint3 SideFinder::place_of(const Edge& edge, const Cut& cut) const {
  const Point3 &p = projected_.point(edge.a), &q = projected_.point(edge.b);
  if (cut.kind == Cut::Kind::start) return {p, 0};
  if (cut.kind == Cut::Kind::end) return {q, 0};
  const PlaneFilter filter = projected_.filter(cut_plane(projected_, cut));
  const ErrorBounded at_p = filter(p), at_q = filter(q);
  return between(p, q, quotient(at_p, at_p - at_q));
}

/// @param left what is seen to the left, if it is known
void SideFinder::add(MapStretch stretch, TriangleId left, TriangleId right) {
  const SeenPart whole_left{stretch.from, stretch.to, left, 1, 0}, whole_right{stretch.from, stretch.to, right, 1, 0};
  stretch.elsewhere = left.is_valid() ? left : right;
  const std::span<const SeenPart> l = left.is_valid() ? std::span(&whole_left, 1) : left_.find(stretch, Sign::positive);
  const std::span<const SeenPart> r = right.is_valid() ? std::span(&whole_right, 1) : right_.find(stretch, Sign::negative);
  add_different(stretch, l, r);
}

/// Where a point of the stretch is seen.
MapPlace SideFinder::place(const MapStretch& stretch, const MapPoint& p, double t, double error) const {
  constexpr MapPlace unknown = {0, 0, HUGE_VAL, HUGE_VAL};
  if (!(projected_.image_error() < HUGE_VAL)) return unknown;
  if (p.is_vertex) {
    const ImagePoint& at = projected_.image(p.vertex);
    return {at.x, at.y, projected_.image_error(), projected_.image_error()};
  }
  const BoundedPoint3 at = stretch.at(t, error);
  const BoundedPoint2 image = projected_.image(at.p, 3 * at.error);
  return image.error < HUGE_VAL ? MapPlace{image.p.x, image.p.y, image.error, image.error} : unknown;
}

void SideFinder::add_side(FacetId facet, const PlacedSide& side) {
  if (observer_ != nullptr) observer_->added_side(facet, side.side);
  sides_.add(facet, side);
}

/// Where what is seen to the left and to the right differs, both end. What goes on beside several others ends in one side.
void SideFinder::add_different(const MapStretch& stretch, std::span<const SeenPart> left, std::span<const SeenPart> right) {
  if (observer_ != nullptr) observer_->looked_beside(stretch, left, right);
  const auto facet = [&](TriangleId t) { return t.is_valid() ? facet_of(mesh_, t) : FacetId(); };
  MapPoint at = left.front().from;
  MapPlace place_of_at = place(stretch, at, 0, 0);
  // What ends on each side since where; none: nothing does.
  struct Ending {
    FacetId facet;
    MapPoint from;
    MapPlace place;
  };
  Ending l, r;
  const auto go_on = [&](Ending& ending, FacetId next, bool is_left) {
    if (ending.facet == next) return;
    if (ending.facet.is_valid())
      add_side(ending.facet, is_left ? PlacedSide{{stretch.line, false, ending.from, at}, ending.place, place_of_at}
                                     : PlacedSide{{stretch.line, true, at, ending.from}, place_of_at, ending.place});
    ending = {next, at, place_of_at};
  };
  std::size_t i = 0, j = 0;
  while (i < left.size() && j < right.size()) {
    const FacetId seen_left = facet(left[i].seen), seen_right = facet(right[j].seen);
    const bool is_border = seen_left != seen_right;
    go_on(l, is_border ? seen_left : FacetId(), true);
    go_on(r, is_border ? seen_right : FacetId(), false);
    const double gap = left[i].to_t - right[j].to_t;
    const bool is_certain = std::fabs(gap) > (left[i].to_error + right[j].to_error) * 1.01;
    const Sign first = is_certain ? sign_of(gap) : map_.order(stretch.line, left[i].to, right[j].to);
    const SeenPart& ends = first == Sign::positive ? right[j] : left[i];
    at = ends.to;
    place_of_at = place(stretch, at, ends.to_t, ends.to_error);
    if (first != Sign::positive) ++i;
    if (first != Sign::negative) ++j;
  }
  go_on(l, {}, true);
  go_on(r, {}, false);
}

}  // namespace hsr::internal
