#include "hsr/drawing/fills.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "hsr/drawing/paper_rings.h"
#include "hsr/surfaces/visible_fragments.h"
#include "hsr/symbols/constructions.h"

namespace hsr::internal {

namespace {

using Wide = Enclosure::Wide;

/// Where corners are seen on the page.
class CornerPlacer {
 public:
  explicit CornerPlacer(const Projection& projection) : projection_(projection) {}

  HomogeneousPoint at(const MapPoint& p, FacetId facet) const {
    if (p.is_vertex) return projection_.at(p.vertex);
    if (p.l.kind == MapLine::Kind::edge && p.m.kind == MapLine::Kind::edge) {
      const HomogeneousPoint q = cross(line(p.l), line(p.m));
      if (!(q.w.middle < 0)) return q;
      return {-q.x, -q.y, -q.w};
    }
    const std::array<Rational, 2> q = exact(p, facet);
    return {enclose(q[0]), enclose(q[1]), Enclosure(1.0)};
  }
  PaperPoint rounded(const MapPoint& p, FacetId facet, const HomogeneousPoint& at) const {
    if (const auto known = projection_.rounded(at)) return *known;
    return Projection::rounded(exact(p, facet));
  }

 private:
  static HomogeneousPoint cross(const HomogeneousPoint& a, const HomogeneousPoint& b) {
    return {a.y * b.w - a.w * b.y, a.w * b.x - a.x * b.w, a.x * b.y - a.y * b.x};
  }
  HomogeneousPoint line(const MapLine& l) const { return cross(projection_.at(VertexId(l.u)), projection_.at(VertexId(l.v))); }
  std::array<Rational, 2> exact(const MapPoint& p, FacetId facet) const {
    return projection_.exact(exact_point(projection_.mesh(), projection_.view(), facet, p));
  }

  const Projection& projection_;
};

std::vector<PaperPoint> placed_ring(const Placement& placement, std::span<const MapCorner> corners, FacetId facet) {
  const CornerPlacer placer(placement.projection);
  std::vector<PaperPoint> points;
  std::vector<HomogeneousPoint> at;
  bool inside = true;
  for (const MapCorner& c : corners) {
    at.push_back(placer.at(c.at, facet));
    if (!placement.frame) continue;
    const Wide x = at.back().x.middle / at.back().w.middle, y = at.back().y.middle / at.back().w.middle;
    inside = inside && x >= placement.frame->left && x <= placement.frame->right && y >= placement.frame->top &&
             y <= placement.frame->bottom;
  }
  if (inside) {
    for (std::size_t k = 0; k < corners.size(); ++k) points.push_back(placer.rounded(corners[k].at, facet, at[k]));
  } else {
    std::vector<std::array<Wide, 2>> ring;
    ring.reserve(at.size());
    for (const HomogeneousPoint& p : at) ring.push_back({p.x.middle / p.w.middle, p.y.middle / p.w.middle});
    points = clipped(std::move(ring), *placement.frame);
  }
  drop_repeated(points);
  return points;
}

}  // namespace

Fills placed_fills(const Placement& placement, const Regions& regions) {
  const std::size_t rings = regions.rings.size();
  std::vector<FacetId> facet(rings);
  for (const Region& r : regions.regions) std::fill(facet.begin() + r.first_ring, facet.begin() + r.end_ring, r.facet);
  std::vector<std::vector<PaperPoint>> placed(rings);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, rings, 64), [&](const auto& range) {
    for (std::size_t r = range.begin(); r != range.end(); ++r) placed[r] = placed_ring(placement, regions.rings[r], facet[r]);
  });
  Fills fills;
  for (const auto& ring : placed) fills.rings.push_row(ring);
  for (const Region& r : regions.regions) {
    Fill fill;
    fill.colour = r.colour;
    fill.first_ring = r.first_ring;
    fill.end_ring = r.end_ring;
    fill.first_face = static_cast<std::uint32_t>(fills.faces.size());
    fills.faces.insert(fills.faces.end(), r.faces.begin(), r.faces.end());
    fill.end_face = static_cast<std::uint32_t>(fills.faces.size());
    if (!placed[r.first_ring].empty()) fills.fills.push_back(fill);
  }
  return fills;
}

}  // namespace hsr::internal
