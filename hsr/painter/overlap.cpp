#include "hsr/painter/overlap.h"

#include <algorithm>

#include "hsr/image_line.h"

namespace hsr {

OverlapCounts& OverlapCounts::operator+=(const OverlapCounts& o) {
  image_sides += o.image_sides;
  planes += o.planes;
  coplanar += o.coplanar;
  intersection += o.intersection;
  return *this;
}

/// Whether a side of a has all of b beyond it. (Of two convex regions without a common inside, a side of one or the other has.)
bool Overlaps::separates(const PieceOfFacet& a, const PieceOfFacet& b) {
  for (const MapHalfPlane& h : a.shape.lines) {
    const auto is_outside = [&](const MapPoint& p) { return map_.side(h.line, p) * h.inner != Sign::positive; };
    if (std::all_of(b.shape.points.begin(), b.shape.points.end(), is_outside)) return true;
  }
  return false;
}

/// Whether a is nearer than b on the line of sight of p, a corner of a or of b: positive, a is.
Sign Overlaps::nearer(const PieceOfFacet& a, const PieceOfFacet& b, const MapPoint& p, bool is_of_a) {
  const auto has = [&](TriangleId t) {
    const auto& c = map_.mesh().triangles[t];
    return p.vertex == c[0] || p.vertex == c[1] || p.vertex == c[2];
  };
  if (!p.is_vertex) return map_.nearer(a.facet, b.facet, p);
  // The eye lies on the side -facing of a plane.
  const TriangleId plane = is_of_a ? b.facet : a.facet;
  if (has(plane)) return Sign::zero;
  const Sign behind = sight_.side(sight_.face_plane(plane), p.vertex, map_.exact()) * sight_.facing(plane);
  return is_of_a ? -behind : behind;
}

Overlaps::Sides Overlaps::sides(const PieceOfFacet& a, const PieceOfFacet& b, const std::vector<MapPoint>& points,
                                bool are_of_a) {
  Sides found;
  for (const MapPoint& p : points) {
    const Sign s = nearer(a, b, p, are_of_a);
    found.nearer = found.nearer || s == Sign::positive;
    found.farther = found.farther || s == Sign::negative;
    if (found.nearer && found.farther) break;
  }
  return found;
}

std::optional<ConvexPiece> Overlaps::common_part(const PieceOfFacet& a, const PieceOfFacet& b) {
  ConvexPiece common = a.shape;
  for (const MapHalfPlane& h : b.shape.lines) {
    cut(map_, common, h);
    if (common.points.empty()) return std::nullopt;
  }
  return common;
}

Overlap Overlaps::relation(const PieceOfFacet& a, const PieceOfFacet& b) {
  if (separates(a, b) || separates(b, a)) {
    ++counts_.image_sides;
    return Overlap::none;
  }
  const auto answer = [](const Sides& s) { return s.nearer ? Overlap::second_behind : Overlap::first_behind; };
  const Sides of_a = sides(a, b, a.shape.points, true);
  if (!of_a.nearer && !of_a.farther) {
    ++counts_.coplanar;
    return a.facet > b.facet ? Overlap::first_behind : Overlap::second_behind;
  }
  if (of_a.nearer != of_a.farther) {
    ++counts_.planes;
    return answer(of_a);
  }
  const Sides of_b = sides(a, b, b.shape.points, false);
  if (of_b.nearer != of_b.farther) {
    ++counts_.planes;
    return answer(of_b);
  }
  ++counts_.intersection;
  const auto common = common_part(a, b);
  if (!common) return Overlap::none;
  Sides there;
  for (const MapPoint& p : common->points) {
    const Sign s = map_.nearer(a.facet, b.facet, p);
    there.nearer = there.nearer || s == Sign::positive;
    there.farther = there.farther || s == Sign::negative;
  }
  return classic_ || (there.nearer && there.farther) ? Overlap::piercing : answer(there);
}

}  // namespace hsr
