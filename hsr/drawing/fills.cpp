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
  /// In perspective by the plane through the target square to the view: the sight of a corner may be parallel to the plane of a facet
  /// that is only united with its own.
  std::array<Rational, 2> exact(const MapPoint& p, FacetId facet) const {
    const View& view = projection_.view();
    if (!view.is_perspective()) return projection_.exact(exact_point(projection_.mesh(), view, facet, p));
    return projection_.exact(exact_point(projection_.mesh(), view, Plane::near(view.viewpoint.at, view.target, 1), p));
  }

 private:
  static HomogeneousPoint cross(const HomogeneousPoint& a, const HomogeneousPoint& b) {
    return {a.y * b.w - a.w * b.y, a.w * b.x - a.x * b.w, a.x * b.y - a.y * b.x};
  }
  HomogeneousPoint line(const MapLine& l) const { return cross(projection_.at(VertexId(l.u)), projection_.at(VertexId(l.v))); }

  const Projection& projection_;
};

bool is_within(const PaperFrame& frame, const std::vector<HomogeneousPoint>& points) {
  return std::all_of(points.begin(), points.end(), [&](const HomogeneousPoint& p) {
    const Wide x = p.x.middle / p.w.middle, y = p.y.middle / p.w.middle;
    return x >= frame.left && x <= frame.right && y >= frame.top && y <= frame.bottom;
  });
}

/// Whether one side of the frame has all of them beyond it, certainly.
bool is_beyond(const PaperFrame& frame, const std::vector<HomogeneousPoint>& points) {
  const auto all = [&](const auto& is_there) { return std::all_of(points.begin(), points.end(), is_there); };
  return all([&](const HomogeneousPoint& p) { return (p.x / p.w).high() < frame.left; }) ||
         all([&](const HomogeneousPoint& p) { return (p.x / p.w).low() > frame.right; }) ||
         all([&](const HomogeneousPoint& p) { return (p.y / p.w).high() < frame.top; }) ||
         all([&](const HomogeneousPoint& p) { return (p.y / p.w).low() > frame.bottom; });
}

std::vector<PaperPoint> placed_ring(const Placement& placement, std::span<const MapCorner> corners, FacetId facet) {
  const CornerPlacer placer(placement.projection);
  std::vector<PaperPoint> points;
  std::vector<HomogeneousPoint> at;
  at.reserve(corners.size());
  for (const MapCorner& c : corners) at.push_back(placer.at(c.at, facet));
  if (!placement.frame || is_within(*placement.frame, at)) {
    for (std::size_t k = 0; k < corners.size(); ++k) points.push_back(placer.rounded(corners[k].at, facet, at[k]));
  } else if (!is_beyond(*placement.frame, at)) {
    // By exact places: the last bit of an enclosure is that of the name of a corner, and one corner may have several.
    std::vector<std::array<Wide, 2>> ring;
    ring.reserve(corners.size());
    for (const MapCorner& c : corners) {
      const std::array<Rational, 2> p = placer.exact(c.at, facet);
      ring.push_back({enclose(p[0]).middle, enclose(p[1]).middle});
    }
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
