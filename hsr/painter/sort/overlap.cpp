#include "hsr/painter/sort/overlap.h"

#include <algorithm>
#include <cmath>

#include "hsr/scene/facet.h"

namespace hsr::internal {

OverlapCounts& OverlapCounts::operator+=(const OverlapCounts& o) {
  image_sides += o.image_sides;
  depths += o.depths;
  first_planes += o.first_planes;
  second_planes += o.second_planes;
  coplanar += o.coplanar;
  intersection += o.intersection;
  return *this;
}

std::vector<NearCorner> Overlaps::near_corners(const PieceOfFacet& piece) const {
  const TriangleId end = facet_end(map_.mesh(), piece.facet);
  const auto is_own = [&](VertexId v) {
    for (TriangleId t = first_triangle(piece.facet); t < end; t = TriangleId(t.value + 1U))
      if (map_.mesh().has_corner(t, v)) return true;
    return false;
  };
  std::vector<NearCorner> near;
  near.reserve(piece.shape.points.size());
  for (const MapPoint& p : piece.shape.points) {
    const MapPlace at = map_.place(p);
    const BoundedPoint3 on_facet =
        p.is_vertex && is_own(p.vertex) ? BoundedPoint3{projected_.point(p.vertex), 0} : map_.point(p, piece.facet);
    near.push_back({{at.x, at.error_x}, {at.y, at.error_y}, on_facet});
  }
  return near;
}

/// Positive where p is on the inner side of side k, as far as doubles tell; in units of the image.
ErrorBounded Overlaps::side(const PieceOfFacet& piece, std::size_t k, const NearCorner& p) const {
  const NearCorner &a = piece.near[k], &b = piece.near[k + 1 == piece.near.size() ? 0 : k + 1];
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

/// The value of a facet's plane at a corner; positive if the facet is in front of the corner.
ErrorBounded Overlaps::beyond(FacetId facet, const NearCorner& p) const {
  ErrorBounded x = projected_.filter(projected_.face_plane(facet))(p.on_facet);
  // Only images with a bound come with a filter that is proven.
  if (!(p.x.error < HUGE_VAL)) x.error = HUGE_VAL;
  return projected_.facing(facet) == Sign::negative ? x : -x;
}

/// Whether a side of a has all of b beyond it. (Of two convex regions without a common inside, a side of one or the other has.)
bool Overlaps::separates(const PieceOfFacet& a, const PieceOfFacet& b) {
  const bool are_near = !a.near.empty() && !b.near.empty();
  for (std::size_t k = 0; k < a.shape.lines.size(); ++k) {
    const MapHalfPlane& h = a.shape.lines[k];
    bool are_outside = true;
    for (std::size_t i = 0; i < b.shape.points.size() && are_outside; ++i) {
      if (are_near) {
        const ErrorBounded s = side(a, k, b.near[i]);
        if (s.is_certain()) {
          ++map_.exact().counts().filter;
          are_outside = s.value < 0;
          continue;
        }
      }
      are_outside = map_.side(h.line, b.shape.points[i]) * h.inner != Sign::positive;
    }
    if (are_outside) return true;
  }
  return false;
}

/// Whether a is nearer than b on the line of sight of a corner of a or of b: positive, a is.
Sign Overlaps::nearer(const PieceOfFacet& a, const PieceOfFacet& b, std::size_t corner, bool is_of_a) {
  const PieceOfFacet& own = is_of_a ? a : b;
  const MapPoint& p = own.shape.points[corner];
  const FacetId plane = is_of_a ? b.facet : a.facet;
  if (!p.is_vertex) {
    if (!own.near.empty()) {
      const ErrorBounded x = beyond(plane, own.near[corner]);
      if (x.is_certain()) {
        ++map_.exact().counts().filter;
        return is_of_a ? -sign_of(x.value) : sign_of(x.value);
      }
    }
    return map_.nearer(a.facet, b.facet, p);
  }
  // The eye lies on the side `facing` of a plane.
  if (map_.mesh().has_corner(first_triangle(plane), p.vertex)) return Sign::zero;
  const Sign before = projected_.side(projected_.face_plane(plane), p.vertex, map_.exact()) * projected_.facing(plane);
  return is_of_a ? before : -before;
}

Sides Overlaps::sides(const PieceOfFacet& a, const PieceOfFacet& b, bool are_of_a) {
  Sides found;
  const std::size_t count = (are_of_a ? a : b).shape.points.size();
  for (std::size_t k = 0; k < count && !(found.nearer && found.farther); ++k) found.add(nearer(a, b, k, are_of_a));
  return found;
}

/// Whether a is nearer and farther than b where their images overlap, if doubles tell: at the corners of the common part, which
/// are corners of one inside the other and crossings of sides.
std::optional<Sides> Overlaps::near_sides(const PieceOfFacet& a, const PieceOfFacet& b) {
  Sides found;
  const std::size_t n = a.near.size(), m = b.near.size();
  // By side of the one, then by corner of the other.
  std::vector<ErrorBounded> of_a(n * m), of_b(n * m), beyond_b(n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < m; ++k) {
      of_a[i * m + k] = side(a, i, b.near[k]);
      of_b[k * n + i] = side(b, k, a.near[i]);
      if (!of_a[i * m + k].is_certain() || !of_b[k * n + i].is_certain()) return std::nullopt;
    }
  const auto inside = [](const std::vector<ErrorBounded>& sides, std::size_t corner, std::size_t corners) {
    for (std::size_t s = corner; s < sides.size(); s += corners)
      if (sides[s].value < 0) return false;
    return true;
  };
  for (std::size_t i = 0; i < n; ++i) {
    beyond_b[i] = beyond(b.facet, a.near[i]);
    if (!beyond_b[i].is_certain()) return std::nullopt;
    if (inside(of_b, i, n)) found.add(-sign_of(beyond_b[i].value));
  }
  for (std::size_t k = 0; k < m; ++k) {
    if (!inside(of_a, k, m)) continue;
    const ErrorBounded x = beyond(a.facet, b.near[k]);
    if (!x.is_certain()) return std::nullopt;
    found.add(sign_of(x.value));
  }
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < m; ++k) {
      const std::size_t i2 = i + 1 == n ? 0 : i + 1, k2 = k + 1 == m ? 0 : k + 1;
      const ErrorBounded p = of_b[k * n + i], q = of_b[k * n + i2];
      if ((p.value < 0) == (q.value < 0) || (of_a[i * m + k].value < 0) == (of_a[i * m + k2].value < 0)) continue;
      const ErrorBounded from = beyond_b[i], to = beyond_b[i2];
      if ((from.value < 0) == (to.value < 0)) {
        found.add(-sign_of(from.value));
        continue;
      }
      // In perspective the image of a line runs at another pace.
      if (projected_.is_perspective()) return std::nullopt;
      const ErrorBounded at = from + quotient(p, p - q) * (to - from);
      if (!at.is_certain()) return std::nullopt;
      found.add(-sign_of(at.value));
    }
  map_.exact().counts().filter += 2 * n * m + n;
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
  if (!have_common_part(a, b)) {
    ++counts_.image_sides;
    return Overlap::none;
  }
  const auto answer = [](const Sides& s) { return s.nearer ? Overlap::second_behind : Overlap::first_behind; };
  const Sides of_a = sides(a, b, true);
  if (!of_a.nearer && !of_a.farther) {
    ++counts_.coplanar;
    return projected_.ties().is_above(b.facet, a.facet) ? Overlap::first_behind : Overlap::second_behind;
  }
  if (of_a.nearer != of_a.farther) {
    ++counts_.second_planes;
    return answer(of_a);
  }
  const Sides of_b = sides(a, b, false);
  if (of_b.nearer != of_b.farther) {
    ++counts_.first_planes;
    return answer(of_b);
  }
  ++counts_.intersection;
  std::optional<Sides> there;
  if (!classic_)
    there = a.near.empty() || b.near.empty()
                ? near_sides({a.facet, a.shape, near_corners(a)}, {b.facet, b.shape, near_corners(b)})
                : near_sides(a, b);
  if (!there) {
    const auto common = common_part(a, b);
    if (!common) return Overlap::none;
    there.emplace();
    for (const MapPoint& p : common->points) there->add(map_.nearer(a.facet, b.facet, p));
  }
  return classic_ || (there->nearer && there->farther) ? Overlap::piercing : answer(*there);
}

}  // namespace hsr::internal
