#include "hsr/surfaces/line_envelope.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/error.h"
#include "hsr/scene/affine_depth.h"
#include "hsr/scene/facet.h"

namespace hsr::internal {

BoundedPoint3 MapStretch::at(double t, double t_error) const {
  BoundedPoint3 at = between(a.p, b.p, {t, t_error});
  at.error += (a.error + b.error) * (1 + std::fabs(t) + t_error) * 1.01;
  return at;
}

void LineEnvelope::start(const MapStretch& stretch, Sign side) {
  stretch_ = &stretch;
  side_ = side;
  is_meeting_ = depends_on_side_ = false;
  parts_.assign(1, {{stretch.from, 0, 0}, {stretch.to, 1, 0}, {}, {}});
  query_ = ImageBox::nothing();
  std::array<ImagePoint, 2> ends;
  double error = projected_.image_error();
  for (const std::size_t k : {0U, 1U}) {
    const BoundedPoint3& p = k == 0 ? stretch.a : stretch.b;
    const VertexId v = k == 0 ? stretch.at_a : stretch.at_b;
    query_.add(v.is_valid() ? projected_.box(v) : projected_.box(p.p, 3 * p.error));
    if (v.is_valid() && projected_.image_error() < HUGE_VAL) {
      ends[k] = projected_.image(v);
    } else {
      const BoundedPoint2 image = projected_.image(p.p, 3 * p.error);
      ends[k] = image.p;
      error += image.error;
    }
  }
  image_ = {ends[0], ends[1], error};
  own_nearness_ = {projected_.nearness(stretch.a.p, 3 * stretch.a.error),
                   projected_.nearness(stretch.b.p, 3 * stretch.b.error)};
  least_ = -HUGE_VAL;
  query_.farthest = pyramid_ != nullptr ? pyramid_->hidden_from(ends[0], ends[1], error) : -unknown;
}

/// False: no other face changes anything.
bool LineEnvelope::look_at(const TriangleFilter& face) {
  if (face.is_beside(image_) || face.triangle == stretch_->elsewhere) return true;
  const TriangleFilter::Overlap overlap = face.overlap(image_);
  if (overlap.is_none) return true;
  const Linear of_t = nearness(face);
  if (of_t.at_a.value + of_t.at_a.error < least_ && of_t.at_b.value + of_t.at_b.error < least_) return true;
  const std::size_t before = parts_.size();
  const TriangleId first = parts_.front().seen;
  insert(face, of_t, overlap);
  if (parts_.size() == before && parts_.front().seen == first) return true;
  if (std::any_of(parts_.begin(), parts_.end(), [](const Part& part) { return !part.seen.is_valid(); })) return true;
  float lowest = unknown;
  least_ = HUGE_VAL;
  for (Part& part : parts_) {
    if (is_settled(part)) continue;
    bound(part);
    lowest = std::min(lowest, part.farthest);
    least_ = std::min(least_, part.least);
  }
  // The tree visits what reaches nearer than the farthest of what is seen so far.
  query_.farthest = std::max(query_.farthest, lowest);
  return lowest < unknown;
}

/// The faces of the tree, but for those that are looked at first.
void LineEnvelope::look_around() {
  occluders_.tree.visit_boxes<BoxTree::Depth::touching>(query_, [&](std::uint32_t i, std::uint32_t at) {
    TriangleFilter own;
    const bool is_prepared = occluders_.is_prepared();
    if (!is_prepared) own = TriangleFilter(projected_, occluders_.triangles[i]);
    const TriangleFilter& face = is_prepared ? occluders_.faces()[at] : own;
    return &face == stretch_->first[0] || &face == stretch_->first[1] || look_at(face);
  });
}

std::span<const SeenPart> LineEnvelope::result() {
  result_.clear();
  for (const Part& part : parts_) result_.push_back({part.from.p, part.to.p, part.seen, part.to.t, part.to.error});
  return result_;
}

std::span<const SeenPart> LineEnvelope::find(const MapStretch& stretch, Sign side) {
  start(stretch, side);
  for (const TriangleFilter* face : stretch.first)
    if (face != nullptr) look_at(*face);
  // The images of visible stretches are closed: what is nearer and ends at one hides it.
  if (!stretch.is_visible) query_.nearest = unknown;
  look_around();
  return result();
}

LineEnvelope::EnvelopePair LineEnvelope::both_sides(const MapStretch& stretch) {
  start(stretch, Sign::positive);
  is_meeting_ = true;
  for (const TriangleFilter* face : stretch.first) look_at(*face);
  query_.nearest = unknown;
  if (parts_.size() == 1 && parts_.front().seen.is_valid()) look_around();
  // Both are seen all along, but for what hides them.
  const bool is_whole = std::all_of(parts_.begin(), parts_.end(), [](const Part& part) { return part.seen.is_valid(); });
  return {result(), is_whole && !depends_on_side_};
}

void LineEnvelope::bound(Part& part) const {
  if (part.farthest != unknown) return;
  double farthest = HUGE_VAL;
  for (const Place* end : {&part.from, &part.to}) {
    const ErrorBounded own = at(own_nearness_, *end), n = at(part.nearness, *end);
    part.least = std::min(part.least, n.error < HUGE_VAL ? n.value - n.error : -HUGE_VAL);
    // The hit is p + n D, or e + (p - e) / (1 + n).
    const Point3& e = projected_.eye().at;
    const ErrorBounded hit =
        projected_.is_perspective() ? quotient(own, ErrorBounded{1, 0} + n) : own + n * ErrorBounded{norm_max(e), 0};
    farthest = std::min(farthest, hit.error < HUGE_VAL ? hit.value - hit.error : -HUGE_VAL);
  }
  part.farthest = farthest > -HUGE_VAL ? float_below(farthest) : projected_.box(part.seen).farthest;
}

ErrorBounded LineEnvelope::at(const Linear& f, const Place& place) const {
  const ErrorBounded t{place.t, place.error};
  return f.at_a + t * (f.at_b - f.at_a);
}

LineEnvelope::Linear LineEnvelope::along(const PlaneFilter& filter, bool zero_at_a, bool zero_at_b) const {
  return {zero_at_a ? ErrorBounded{} : filter(stretch_->a), zero_at_b ? ErrorBounded{} : filter(stretch_->b)};
}

/// -t(p) / t(E): how far toward the viewer from the stretch the plane is; see bound().
LineEnvelope::Linear LineEnvelope::nearness(const TriangleFilter& face) const {
  const auto is_corner = [&](VertexId v) { return v.is_valid() && face.has(v); };
  const Linear value = along(face.plane, is_corner(stretch_->at_a), is_corner(stretch_->at_b));
  return {value.at_a * face.per_eye, value.at_b * face.per_eye};
}

LineEnvelope::Place LineEnvelope::crossing(const MapLine& other, const Linear& value) const {
  const ErrorBounded t = quotient(value.at_a, value.at_a - value.at_b);
  return {MapPoint::crossing(stretch_->line, other), t.value, t.error};
}

Sign LineEnvelope::order(const Place& x, const Place& y) {
  const double gap = x.t - y.t;
  if (std::fabs(gap) > (x.error + y.error) * 1.01) {
    ++map_.exact().counts().filter;
    return sign_of(gap);
  }
  return map_.order(stretch_->line, x.p, y.p);
}

void LineEnvelope::add(const Place& from, const Place& to, TriangleId t, const Linear& nearness) {
  if (!next_.empty() && next_.back().seen == t) {
    next_.back().to = to;
    next_.back().farthest = unknown;
    next_.back().least = HUGE_VAL;
  } else {
    next_.push_back({from, to, t, nearness});
  }
}

/// Cuts the part of the line to what is within the half-plane just beside it. False: nothing.
bool LineEnvelope::clip(const MapHalfPlane& h, const Linear& value, Place& from, Place& to) {
  if (h.line == stretch_->line) {
    depends_on_side_ = true;
    return h.inner == side_;
  }
  const auto sign = [&](const Place& place) {
    const ErrorBounded x = at(value, place);
    if (!x.is_certain()) return map_.side(h.line, place.p) * h.inner;
    ++map_.exact().counts().filter;
    return sign_of(x.value) * h.inner;
  };
  const Sign a = sign(from), b = sign(to);
  if (a == Sign::negative && b != Sign::positive) return false;
  if (a == Sign::zero && b == Sign::zero) {
    depends_on_side_ = true;
    // One line under two names: which way it runs, any point beside it tells.
    return map_.same_way(stretch_->line, h.line) * h.inner == side_;
  }
  if (a != Sign::negative && b != Sign::negative) return true;
  if (a != Sign::positive && b != Sign::positive) return false;
  (a == Sign::negative ? from : to) = crossing(h.line, value);
  return true;
}

/// O of a side of the face, its vertices in the order of the line's name. Parallel, images are linear along the stretch, and
/// their determinants as good as those in space.
LineEnvelope::Linear LineEnvelope::along_side(const TriangleFilter& face, const TriangleFilter::Overlap& overlap, std::size_t k,
                                              const MapHalfPlane& h) const {
  const VertexId v(h.line.u), w(h.line.v);
  const auto is_end = [&](VertexId x) { return x.is_valid() && (x == v || x == w); };
  const bool zero_at_a = is_end(stretch_->at_a), zero_at_b = is_end(stretch_->at_b);
  if (projected_.is_perspective()) return along(projected_.filter(projected_.sight_plane(v, w)), zero_at_a, zero_at_b);
  const bool is_reversed = (face.facing < 0) == (face.corners[k] == v);
  const auto value = [&](const ErrorBounded& x) { return is_reversed ? -x : x; };
  return {zero_at_a ? ErrorBounded{} : value(overlap.at_p(k)), zero_at_b ? ErrorBounded{} : value(overlap.at_q(k))};
}

bool LineEnvelope::clip(const TriangleFilter& face, const TriangleFilter::Overlap& overlap, Place& from, Place& to) {
  const TriangleId t = face.triangle;
  unsigned is_within = overlap.is_within;
  std::array<MapHalfPlane, 3> sides;
  for (std::size_t k = 0; k < 3; ++k) {
    sides[k] = side_of_triangle(projected_, t, k);
    if (sides[k].line != stretch_->line) continue;
    depends_on_side_ = true;
    if (sides[k].inner != side_) return false;
    is_within |= 1U << k;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    if ((is_within >> k & 1U) != 0) continue;
    const MapHalfPlane& h = sides[k];
    if (!clip(h, along_side(face, overlap, k, h), from, to)) return false;
  }
  if (!projected_.reaches_before_near(t)) return true;
  const PlaneFilter filter = projected_.filter(projected_.near_line(projected_.face_plane(t)));
  return clip(beyond_near(projected_, t), along(filter, false, false), from, to);
}

/// Whether the place is on an edge or at a vertex that both triangles have: most ties are, at outlines.
bool LineEnvelope::have_in_common(TriangleId s, TriangleId t, const MapPoint& p) const {
  const Mesh& mesh = map_.mesh();
  const auto is_common = [&](VertexId v) { return mesh.has_corner(s, v) && mesh.has_corner(t, v); };
  if (p.is_vertex) return is_common(p.vertex);
  const auto is_edge = [&](const MapLine& l) {
    return l.kind == MapLine::Kind::edge && is_common(VertexId(l.u)) && is_common(VertexId(l.v));
  };
  return is_edge(p.l) || is_edge(p.m);
}

/// Whether s is nearer than what is seen along the part, at a place of it.
Sign LineEnvelope::nearer(TriangleId s, const Linear& of_s, const Part& part, const Place& place) {
  const ErrorBounded gap = at(of_s, place) - at(part.nearness, place);
  if (!gap.is_certain()) return have_in_common(s, part.seen, place.p) ? Sign::zero : map_.nearer(s, part.seen, place.p);
  ++map_.exact().counts().filter;
  return sign_of(gap.value);
}

/// Two planes that meet in the line itself: the sign of the meet's value beside it is that at any point off the line.
Sign LineEnvelope::nearer_beside(TriangleId s, TriangleId t) {
  for (const TriangleId corners : {s, t})
    for (const VertexId v : map_.mesh().triangles[corners]) {
      const Sign at_v = map_.side(stretch_->line, v);
      if (at_v != Sign::zero) return map_.nearer(s, t, MapPoint::of_vertex(v)) * at_v * side_;
    }
  throw InvariantError("LineEnvelope: two triangles on one line");
}

void LineEnvelope::insert(const TriangleFilter& face, const Linear& of_t, const TriangleFilter::Overlap& overlap) {
  const TriangleId t = face.triangle;
  Place from = parts_.front().from, to = parts_.back().to;
  if (!clip(face, overlap, from, to)) return;
  next_.clear();
  const Mesh& mesh = map_.mesh();
  for (const Part& part : parts_) {
    const auto keep = [&](const Place& x, const Place& y) { add(x, y, part.seen, part.nearness); };
    const auto keep_whole = [&] {
      if (!next_.empty() && next_.back().seen == part.seen)
        keep(part.from, part.to);
      else
        next_.push_back(part);
    };
    if (is_settled(part) || (part.seen.is_valid() && facet_of(mesh, part.seen) == facet_of(mesh, t))) {
      keep_whole();
      continue;
    }
    // The part before t, within it, and after it.
    const bool starts_later = order(part.from, from) == Sign::negative;
    const bool ends_earlier = order(to, part.to) == Sign::negative;
    const Place &low = starts_later ? from : part.from, &high = ends_earlier ? to : part.to;
    if (order(low, high) != Sign::negative) {
      keep_whole();
      continue;
    }
    if (starts_later) keep(part.from, low);
    const auto choose = [&](const Place& x, const Place& y, bool is_t) {
      if (is_t)
        add(x, y, t, of_t);
      else
        keep(x, y);
    };
    if (!part.seen.is_valid()) {
      choose(low, high, true);
    } else {
      const Sign at_low = nearer(t, of_t, part, low), at_high = nearer(t, of_t, part, high);
      if (at_low * at_high == Sign::negative) {
        const Linear gap = {of_t.at_a - part.nearness.at_a, of_t.at_b - part.nearness.at_b};
        const Place middle = crossing(MapLine::meet(t, part.seen), gap);
        choose(low, middle, at_low == Sign::positive);
        choose(middle, high, at_high == Sign::positive);
      } else if (at_low != Sign::zero || at_high != Sign::zero) {
        choose(low, high, (at_low != Sign::zero ? at_low : at_high) == Sign::positive);
      } else if (map_.coplanar(t, part.seen)) {
        depends_on_side_ = true;
        choose(low, high, projected_.ties().is_above(t, part.seen));
      } else {
        depends_on_side_ |= !(is_meeting_ && meets_here(t) && meets_here(part.seen));
        choose(low, high, nearer_beside(t, part.seen) == Sign::positive);
      }
    }
    if (ends_earlier) keep(high, part.to);
  }
  std::swap(parts_, next_);
}

}  // namespace hsr::internal
