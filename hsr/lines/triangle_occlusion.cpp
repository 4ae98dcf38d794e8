#include "hsr/lines/triangle_occlusion.h"

#include <algorithm>
#include <cmath>

#include "geometry/constructed_point.h"
#include "hsr/lines/shadow_observer.h"
#include "hsr/scene/facet.h"
#include "hsr/scene/line_filter.h"
#include "hsr/symbols/cut_plane.h"

namespace hsr::internal {

namespace {

Cut cut_of(Cut::Kind kind, std::uint32_t u = 0, std::uint32_t v = 0, int axis = 0) {
  return {kind, static_cast<std::uint8_t>(axis), u, v};
}

/// Neighbours share the cut by their common side: its vertices in one order.
Cut sight_cut(VertexId u, VertexId v) { return cut_of(Cut::Kind::sight, std::min(u, v).value, std::max(u, v).value); }

const Breakpoint start_bound = {cut_of(Cut::Kind::start), 0, 0, Sign::positive};
const Breakpoint end_bound = {cut_of(Cut::Kind::end), 1, 0, Sign::positive};

}  // namespace

/// A value whose sign is known exactly. Where the double has the other sign, it is moved to zero and its error grows by as
/// much.
TriangleOcclusion::Value TriangleOcclusion::known(const ErrorBounded& x, Sign s) {
  if (s == Sign::zero) return {{0, 0}, s};
  if (sign_of(x.value) != s) return {{0, std::fabs(x.value) + x.error}, s};
  return {x, s};
}

TriangleOcclusion::Value TriangleOcclusion::at(const PlaneFilter& filter, const Plane& plane, const End& end, bool on_plane) {
  if (on_plane) return {{0, 0}, Sign::zero};
  const ErrorBounded x = filter(end.at);
  if (x.is_certain()) {
    ++exact_.counts().filter;
    return {x, sign_of(x.value)};
  }
  if (!is_edge()) return known(x, exact_.side(plane, s_plane_, t_plane_, end.cut));
  return known(x, exact_.side_beyond_filter(plane, end.at.p));
}

Breakpoint TriangleOcclusion::bound(const Cut& cut, const Value& at_a, const Value& at_b) const {
  // t = A / (A - B), where A and B, as computed and exactly, have opposite signs (or are zero): between the two |dt/dA| and
  // |dt/dB| are at most 1 / |A - B|. Difference and quotient round once each.
  const double fall = at_a.x.value - at_b.x.value, loss = at_a.x.error + at_b.x.error;
  const double least = std::fabs(at_a.x.value) + std::fabs(at_b.x.value) - loss;
  const double t = at_a.x.value / fall;
  const bool known = least > 0 && std::isfinite(t);
  const Sign fall_sign = at_a.sign != Sign::zero ? at_a.sign : -at_b.sign;  // at the very end it falls from there
  return {cut, known ? t : 0.5, known ? loss / least * 1.01 + 8 * ErrorBounded::u : HUGE_VAL, fall_sign};
}

Breakpoint TriangleOcclusion::place(const Cut& cut) {
  const Plane plane = cut_plane(projected_, cut);
  const PlaneFilter filter = projected_.filter(plane);
  return bound(cut, at(filter, plane, a_, false), at(filter, plane, b_, false));
}

std::optional<Breakpoint> TriangleOcclusion::crossing(const Cut& cut) {
  const Plane plane = cut_plane(projected_, cut);
  const PlaneFilter filter = projected_.filter(plane);
  const auto is_on = [&](const End& end, const Cut& its) {
    const bool is_by_vertices = cut.kind == Cut::Kind::sight || cut.kind == Cut::Kind::line;
    return is_edge() ? is_by_vertices && (end.vertex.value == cut.u || end.vertex.value == cut.v) : cut == its;
  };
  const Value at_a = at(filter, plane, a_, is_on(a_, first_.cut)), at_b = at(filter, plane, b_, is_on(b_, last_.cut));
  if (at_a.sign * at_b.sign != Sign::negative) return std::nullopt;
  const Breakpoint here = bound(cut, at_a, at_b);
  const bool is_within = order(first_, here) == Sign::negative && order(here, last_) == Sign::negative;
  return is_within ? std::optional(here) : std::nullopt;
}

Sign TriangleOcclusion::order(const Breakpoint& x, const Breakpoint& y) {
  const double gap = x.t - y.t;
  if (std::fabs(gap) > x.error + y.error) {
    ++exact_.counts().filter;
    return sign_of(gap);
  }
  if (x.cut == y.cut) return Sign::zero;
  using Kind = Cut::Kind;
  if (x.cut.kind == Kind::start || y.cut.kind == Kind::end) return Sign::negative;
  if (x.cut.kind == Kind::end || y.cut.kind == Kind::start) return Sign::positive;
  const Plane x_plane = cut_plane(projected_, x.cut), y_plane = cut_plane(projected_, y.cut);
  // Where y is, the value of x still has the sign that it falls from, if y comes first.
  if (!is_edge()) return x.fall * exact_.side(x_plane, s_plane_, t_plane_, y_plane);
  return -(x.fall * y.fall * exact_.cross(x_plane, y_plane, a_.at.p, b_.at.p));
}

bool TriangleOcclusion::start(EdgeId id) {
  const Edge& edge = projected_.mesh().edges[id];
  a_ = {edge.a, {projected_.point(edge.a), 0}, {}, {}};
  b_ = {edge.b, {projected_.point(edge.b), 0}, {}, {}};
  edge_sight_.reset();
  if (projected_.image_error() < HUGE_VAL)
    image_ = {projected_.image(edge.a), projected_.image(edge.b), projected_.image_error()};
  first_ = start_bound;
  last_ = end_bound;
  const Sign near_a = projected_.beyond_near(edge.a), near_b = projected_.beyond_near(edge.b);
  if (near_a != Sign::positive && near_b != Sign::positive && !(near_a == Sign::zero && near_b == Sign::zero)) return false;
  if (near_a * near_b == Sign::negative) {
    const Plane near = projected_.near_plane();
    const PlaneFilter filter = projected_.filter(near);
    (near_a == Sign::negative ? first_ : last_) =
        bound(cut_of(Cut::Kind::near), known(filter(a_.at.p), near_a), known(filter(b_.at.p), near_b));
  }
  return !LineFilter(projected_, edge.a, edge.b).is_point(exact_);
}

bool TriangleOcclusion::start(EdgeId id, const Cut& from, const Cut& to) {
  if (!start(id)) return false;
  if (from.kind != Cut::Kind::start) first_ = place(from);
  if (to.kind != Cut::Kind::end) last_ = place(to);
  return true;
}

bool TriangleOcclusion::start(const Intersection& meet) {
  s_ = meet.s;
  t_ = meet.t;
  s_plane_ = projected_.face_plane(s_);
  t_plane_ = projected_.face_plane(t_);
  const auto end = [&](const Cut& cut) {
    End e;
    e.cut = cut_plane(projected_, cut);
    e.cut_name = cut;
    e.at = bounded_point(near_meet(s_plane_, t_plane_, e.cut));
    e.at.error = std::max(e.at.error, 0x1p-1000);
    // Beyond this a coordinate would break the bound of a filter.
    if (!exact_.filter_is_proven() || !(norm_one(e.at.p) < 0x1p100)) e.at.error = HUGE_VAL;
    return e;
  };
  a_ = end(meet.from);
  b_ = end(meet.to);
  first_ = {meet.from, 0, 0, -exact_.turn(s_plane_, t_plane_, a_.cut)};
  last_ = {meet.to, 1, 0, -exact_.turn(s_plane_, t_plane_, b_.cut)};
  // Values fall from a to b; the line may run the other way.
  if (first_.fall * exact_.side(a_.cut, s_plane_, t_plane_, b_.cut) == Sign::positive) {
    first_.fall = -first_.fall;
    last_.fall = -last_.fall;
  }
  return projected_.facing(s_) != Sign::zero || projected_.facing(t_) != Sign::zero;
}

bool TriangleOcclusion::within(const std::array<HalfSpace, 3>& half_spaces, Breakpoint& from, Breakpoint& to,
                               std::size_t& along) {
  begin();
  along = 3;
  for (std::size_t k = 0; k < 3; ++k) {
    const HalfSpace& h = half_spaces[k];
    const PlaneFilter filter = projected_.filter(h.plane);
    const VertexId u(h.cut.u), v(h.cut.v);
    const Value at_a = at(filter, h.plane, a_, a_.vertex == u || a_.vertex == v);
    const Value at_b = at(filter, h.plane, b_, b_.vertex == u || b_.vertex == v);
    if (at_a.sign == Sign::zero && at_b.sign == Sign::zero) along = k;
    if (!clip(h.cut, at_a, at_b, h.inner, false)) return false;
  }
  from = from_;
  to = to_;
  return order(from_, to_) == Sign::negative;
}

bool TriangleOcclusion::keep(const Cut& cut, Sign kept, Breakpoint& from, Breakpoint& to) {
  const Plane plane = cut_plane(projected_, cut);
  const PlaneFilter filter = projected_.filter(plane);
  from_ = from;
  to_ = to;
  const bool a_on = !is_edge() && cut == a_.cut_name, b_on = !is_edge() && cut == b_.cut_name;
  if (!clip(cut, at(filter, plane, a_, a_on), at(filter, plane, b_, b_on), kept, false)) return false;
  from = from_;
  to = to_;
  return order(from, to) == Sign::negative;
}

/// True only if the corners that are not ends of the edge lie certainly on one side of its view plane: then the triangle's cone
/// meets that plane in no more than a line of sight through an end.
bool TriangleOcclusion::misses(const std::array<VertexId, 3>& corners) {
  if (!is_edge()) return false;
  if (!edge_sight_) edge_sight_ = projected_.filter(projected_.sight_plane(a_.vertex, b_.vertex));
  bool positive = false, negative = false;
  for (const VertexId c : corners) {
    if (is_end(c)) continue;
    const ErrorBounded x = (*edge_sight_)(projected_.point(c));
    if (!x.is_certain()) return false;
    (x.value > 0 ? positive : negative) = true;
  }
  return positive != negative;
}

bool TriangleOcclusion::clip(const Cut& cut, const Value& at_a, const Value& at_b, Sign wanted, bool open) {
  const Sign a = at_a.sign * wanted, b = at_b.sign * wanted;
  if (a == Sign::zero && b == Sign::zero) return !open;
  if (a != Sign::negative && b != Sign::negative) return true;
  if (a != Sign::positive && b != Sign::positive) return false;
  const Breakpoint here = bound(cut, at_a, at_b);
  if (a == Sign::negative) {
    if (order(from_, here) == Sign::negative) from_ = here;
  } else {
    if (order(here, to_) == Sign::negative) to_ = here;
  }
  return true;
}

bool TriangleOcclusion::clip(const Cut& cut, const Plane& plane, bool a_on, bool b_on, Sign wanted, bool open) {
  const PlaneFilter filter = projected_.filter(plane);
  if (!is_edge()) {
    a_on = cut == first_.cut;
    b_on = cut == last_.cut;
  }
  return clip(cut, at(filter, plane, a_, a_on), at(filter, plane, b_, b_on), wanted, open);
}

void TriangleOcclusion::cast(const TriangleFilter& face, std::vector<HiddenInterval>& occlusion) {
  if (!is_edge() || face.has(a_.vertex) || face.has(b_.vertex) || !(projected_.image_error() < HUGE_VAL)) {
    cast(face.triangle, {}, occlusion);
    return;
  }
  if (face.is_beside(image_)) return;
  const ErrorBounded at_a = face.plane(a_.at.p), at_b = face.plane(b_.at.p);
  const bool before_a = face.facing * at_a.value > at_a.error, before_b = face.facing * at_b.value > at_b.error;
  if (before_a && before_b) return;
  const TriangleFilter::Overlap overlap = face.overlap(image_);
  if (overlap.is_none) return;
  const bool is_behind = face.facing * at_a.value < -at_a.error && face.facing * at_b.value < -at_b.error;
  cast(face.triangle, {false, is_behind, &overlap}, occlusion);
}

void TriangleOcclusion::cast(TriangleId triangle, const Prefilter& prefilter, std::vector<HiddenInterval>& occlusion) {
  const auto& c = projected_.mesh().triangles[triangle];
  const Sign facing = projected_.facing(triangle);
  const bool a_on = is_one_of(a_.vertex, c), b_on = is_one_of(b_.vertex, c);
  // Nothing hides in its own plane, unless seen edge-on.
  if (facing != Sign::zero && (a_on && b_on)) return;
  if (facing != Sign::zero && !is_edge() && is_one(facet_of(projected_.mesh(), triangle))) return;
  if (prefilter.may_miss && misses(c)) return;
  if (facing == Sign::zero) {
    edge_on(triangle, occlusion);
    return;
  }
  begin();
  if (!prefilter.is_behind &&
      !clip(cut_of(Cut::Kind::face, triangle.value), projected_.face_plane(triangle), a_on, b_on, -facing, true))
    return;
  for (std::size_t k = 0; k < 3; ++k) {
    if (prefilter.image != nullptr && (prefilter.image->is_within >> k & 1U) != 0) continue;
    const VertexId u = c[k], v = c[(k + 1) % 3];
    // O(u, v, .) changes its sign with the order of u and v; the cut is named in one order.
    const Sign wanted = u < v ? facing : -facing;
    // Parallel: images are linear along the edge, and their determinants as good as those in space.
    if (prefilter.image != nullptr && !projected_.is_perspective()) {
      const auto value = [&](ErrorBounded x, const End& end) -> Value {
        if (u > v) x = -x;
        if (facing == Sign::negative) x = -x;
        if (!x.is_certain())
          return known(x, exact_.side_beyond_filter(projected_.sight_plane(std::min(u, v), std::max(u, v)), end.at.p));
        ++exact_.counts().filter;
        return {x, sign_of(x.value)};
      };
      if (!clip(sight_cut(u, v), value(prefilter.image->at_p(k), a_), value(prefilter.image->at_q(k), b_), wanted, false))
        return;
      continue;
    }
    if (!clip(sight_cut(u, v), projected_.sight_plane(std::min(u, v), std::max(u, v)), a_.vertex == u || a_.vertex == v,
              b_.vertex == u || b_.vertex == v, wanted, false))
      return;
  }
  if (projected_.reaches_before_near(triangle) &&
      !clip(cut_of(Cut::Kind::near_line, triangle.value), projected_.near_line(projected_.face_plane(triangle)), false, false,
            facing, false))
    return;
  if (order(from_, to_) == Sign::negative) occlusion.push_back({from_, to_, projected_.mesh().face_of[triangle]});
}

/// A triangle whose plane contains the eye hides only points of that plane. There, with the coordinate `axis` dropped, p is
/// hidden iff it is in the shadow of one of the three sides cd:
///   strictly beyond the line cd, within the closed angle of the eye and cd, met beyond the near plane;
/// or the way from p toward the eye starts inside the triangle: p in T, and where the edge runs along a side of T, the eye is
/// strictly on the inner side of it, and likewise for the near plane.
/// (The last point of T on the way to the eye is on a side of T, and differs from p unless the way leaves T at once.)
void TriangleOcclusion::edge_on(TriangleId triangle, std::vector<HiddenInterval>& occlusion) {
  const auto& c = projected_.mesh().triangles[triangle];
  const Plane plane = projected_.face_plane(triangle);
  const PlaneFilter filter = projected_.filter(plane);
  if (at(filter, plane, a_, is_one_of(a_.vertex, c)).sign != Sign::zero) return;
  if (at(filter, plane, b_, is_one_of(b_.vertex, c)).sign != Sign::zero) return;

  int axis = 0;
  Sign inner = Sign::zero;  // the side of the line c0 c1 on which c2 lies
  for (; axis < 3; ++axis) {
    inner = exact_.side(Plane::along_axis(projected_.point(c[0]), projected_.point(c[1]), axis), projected_.point(c[2]));
    if (inner != Sign::zero) break;
  }
  const FaceId face = projected_.mesh().face_of[triangle];
  const bool near_cuts = projected_.reaches_before_near(triangle);
  const auto add = [&] {
    if (order(from_, to_) == Sign::negative) occlusion.push_back({from_, to_, face});
  };
  const auto line_cut = [&](VertexId u, VertexId v) { return cut_of(Cut::Kind::line, u.value, v.value, axis); };

  std::array<Sign, 3> eye_side;  // of each side's line
  for (std::size_t k = 0; k < 3; ++k) {
    const VertexId u = c[k], v = c[(k + 1) % 3];
    const Plane of_u = Plane::of_sight_along_axis(projected_.eye(), projected_.point(u), axis);
    const Plane of_v = Plane::of_sight_along_axis(projected_.eye(), projected_.point(v), axis);
    const Plane line = Plane::along_axis(projected_.point(u), projected_.point(v), axis);
    const Sign eye = exact_.side(of_u, projected_.point(v));  // also the side of the line on which the eye lies
    eye_side[k] = eye;
    if (eye == Sign::zero) continue;
    begin();
    if (!clip(line_cut(u, v), line, a_.vertex == u || a_.vertex == v, b_.vertex == u || b_.vertex == v, -eye, true)) continue;
    if (!clip(cut_of(Cut::Kind::sight_of_vertex, u.value, 0, axis), of_u, a_.vertex == u, b_.vertex == u, eye, false)) continue;
    if (!clip(cut_of(Cut::Kind::sight_of_vertex, v.value, 0, axis), of_v, a_.vertex == v, b_.vertex == v,
              exact_.side(of_v, projected_.point(u)), false))
      continue;
    if (near_cuts &&
        !clip(cut_of(Cut::Kind::near_line_end, u.value, v.value, axis), projected_.near_line(line), false, false, eye, false))
      continue;
    add();
  }

  begin();
  for (std::size_t k = 0; k < 3; ++k) {
    const VertexId u = c[k], v = c[(k + 1) % 3];
    const Plane line = Plane::along_axis(projected_.point(u), projected_.point(v), axis);
    const bool runs_outside = eye_side[k] * inner != Sign::positive;
    if (!clip(line_cut(u, v), line, a_.vertex == u || a_.vertex == v, b_.vertex == u || b_.vertex == v, inner, runs_outside))
      return;
  }
  // Points of the line in the near plane itself have nothing of T in front of them.
  const auto is_in_near = [&](const End& end) {
    if (end.vertex.is_valid()) return projected_.beyond_near(end.vertex) == Sign::zero;
    return exact_.side(projected_.near_plane(), s_plane_, t_plane_, end.cut) == Sign::zero;
  };
  if (near_cuts && is_in_near(a_) && is_in_near(b_)) return;
  add();
}

namespace {

/// By where they begin.
void sort_shadows(TriangleOcclusion& occlusion, std::vector<HiddenInterval>& shadows) {
  const auto before = [&](const HiddenInterval& x, const HiddenInterval& y) {
    return occlusion.order(x.from, y.from) == Sign::negative;
  };
  // Both sorts are stable and stay within bounds even where --arithmetic double gives no order at all. The first takes no
  // memory, which for a few shadows, as most edges have, costs more than to sort them.
  if (shadows.size() <= 16) {
    for (auto i = shadows.begin() + 1; i != shadows.end(); ++i) {
      auto at = i;
      while (at != shadows.begin() && before(*i, *(at - 1))) --at;
      std::rotate(at, i, i + 1);
    }
  } else {
    std::stable_sort(shadows.begin(), shadows.end(), before);
  }
}

/// @param tell of each but the first: the shadow, how it joins, the last interval then
template <class Tell>
void unite_sorted(TriangleOcclusion& occlusion, std::vector<HiddenInterval>& shadows, const Tell& tell) {
  std::size_t last = 0;
  for (std::size_t i = 1; i < shadows.size(); ++i) {
    const HiddenInterval shadow = shadows[i];
    Uniting how = Uniting::within;
    if (occlusion.order(shadow.from, shadows[last].to) == Sign::positive) {
      shadows[++last] = shadow;
      how = Uniting::begins;
    } else if (occlusion.order(shadows[last].to, shadow.to) == Sign::negative) {
      shadows[last].to = shadow.to;
      how = Uniting::reaches;
    }
    tell(shadow, how, shadows[last]);
  }
  shadows.resize(last + 1);
}

}  // namespace

void unite(TriangleOcclusion& occlusion, std::vector<HiddenInterval>& shadows) {
  if (shadows.size() < 2) return;
  sort_shadows(occlusion, shadows);
  unite_sorted(occlusion, shadows, [](const HiddenInterval&, Uniting, const HiddenInterval&) {});
}

void unite(TriangleOcclusion& occlusion, std::vector<HiddenInterval>& shadows, ShadowObserver& observer) {
  if (shadows.empty()) return;
  sort_shadows(occlusion, shadows);
  observer.joined(shadows.front(), Uniting::begins, shadows.front());
  unite_sorted(occlusion, shadows, [&](const HiddenInterval& shadow, Uniting how, const HiddenInterval& last) {
    observer.joined(shadow, how, last);
  });
}

}  // namespace hsr::internal
