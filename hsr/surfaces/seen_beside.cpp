#include "hsr/surfaces/seen_beside.h"

#include <algorithm>
#include <limits>

#include "geometry/error.h"

namespace hsr {

std::span<const SeenPart> SeenBeside::find(const MapLine& line, const MapPoint& from, const MapPoint& to, const ImageBox& box,
                                           Sign side) {
  line_ = line;
  side_ = side;
  parts_.assign(1, {from, to, {}});
  // The tree visits what reaches nearer than the farthest of what is seen so far.
  ImageBox query = box;
  query.farthest = -std::numeric_limits<float>::infinity();
  occluders_.tree.visit(query, [&](std::uint32_t i) {
    insert(occluders_.triangles[i]);
    float farthest = std::numeric_limits<float>::infinity();
    for (const SeenPart& part : parts_)
      farthest = std::min(farthest, part.seen.is_valid() ? map_.sight().box(part.seen).farthest : query.farthest);
    query.farthest = std::max(query.farthest, farthest);
    return true;
  });
  return parts_;
}

void SeenBeside::add(const MapPoint& from, const MapPoint& to, TriangleId t) {
  if (!next_.empty() && next_.back().seen == t)
    next_.back().to = to;
  else
    next_.push_back({from, to, t});
}

/// Cuts the part of the line to what is within the half-plane just beside it. False: nothing.
bool SeenBeside::clip(const MapHalfPlane& h, MapPoint& from, MapPoint& to) {
  const Sign a = map_.side(h.line, from) * h.inner, b = map_.side(h.line, to) * h.inner;
  if (a == Sign::zero && b == Sign::zero) {
    if (h.line == line_) return h.inner == side_;
    // One line under two names: which way it runs, any point beside it tells.
    return map_.same_way(line_, h.line) * h.inner == side_;
  }
  if (a != Sign::negative && b != Sign::negative) return true;
  if (a != Sign::positive && b != Sign::positive) return false;
  (a == Sign::negative ? from : to) = MapPoint::crossing(line_, h.line);
  return true;
}

bool SeenBeside::clip(TriangleId t, MapPoint& from, MapPoint& to) {
  const Sight& sight = map_.sight();
  for (std::size_t k = 0; k < 3; ++k)
    if (!clip(side_of_triangle(sight, t, k), from, to)) return false;
  if (sight.reaches_before_near(t) && !clip(beyond_near(sight, t), from, to)) return false;
  return true;
}

/// Two planes that meet in the line itself: the sign of the meet's value beside it is that at any point off the line.
Sign SeenBeside::nearer_beside(TriangleId s, TriangleId t) {
  for (const TriangleId corners : {s, t})
    for (const VertexId v : map_.mesh().triangles[corners]) {
      const Sign at = map_.side(line_, v);
      if (at != Sign::zero) return map_.nearer(s, t, MapPoint::of_vertex(v)) * at * side_;
    }
  throw InvariantError("SeenBeside: two triangles on one line");
}

void SeenBeside::insert(TriangleId t) {
  MapPoint from = parts_.front().from, to = parts_.back().to;
  if (!clip(t, from, to)) return;
  next_.clear();
  const Mesh& mesh = map_.mesh();
  for (const SeenPart& part : parts_) {
    if (part.seen.is_valid() && facet_of(mesh, part.seen) == facet_of(mesh, t)) {
      add(part.from, part.to, part.seen);
      continue;
    }
    // The part before t, within it, and after it.
    const bool starts_later = map_.order(line_, part.from, from) == Sign::negative;
    const bool ends_earlier = map_.order(line_, to, part.to) == Sign::negative;
    const MapPoint low = starts_later ? from : part.from, high = ends_earlier ? to : part.to;
    if (map_.order(line_, low, high) != Sign::negative) {
      add(part.from, part.to, part.seen);
      continue;
    }
    if (starts_later) add(part.from, low, part.seen);
    if (!part.seen.is_valid()) {
      add(low, high, t);
    } else if (map_.coplanar(t, part.seen)) {
      add(low, high, std::min(t, part.seen));
    } else {
      const Sign at_low = map_.nearer(t, part.seen, low), at_high = map_.nearer(t, part.seen, high);
      if (at_low * at_high == Sign::negative) {
        const MapPoint middle = MapPoint::crossing(line_, MapLine::meet(t, part.seen));
        add(low, middle, at_low == Sign::positive ? t : part.seen);
        add(middle, high, at_high == Sign::positive ? t : part.seen);
      } else {
        Sign nearer = at_low != Sign::zero ? at_low : at_high;
        if (nearer == Sign::zero) nearer = nearer_beside(t, part.seen);
        add(low, high, nearer == Sign::positive ? t : part.seen);
      }
    }
    if (ends_earlier) add(high, part.to, part.seen);
  }
  std::swap(parts_, next_);
}

}  // namespace hsr
