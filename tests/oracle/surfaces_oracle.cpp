#include "tests/oracle/surfaces_oracle.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <set>

#include "hsr/symbols/constructions.h"

namespace hsr::oracle {

namespace {

Q cross2(const Place& o, const Place& p, const Place& q) {
  return (p[0] - o[0]) * (q[1] - o[1]) - (p[1] - o[1]) * (q[0] - o[0]);
}

bool is_inside(const std::vector<Place>& ring, const Place& p) {
  bool inside = false;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Place &a = ring[k], &b = ring[(k + 1) % ring.size()];
    if ((a[1] > p[1]) == (b[1] > p[1])) continue;
    const Q at = a[0] + (p[1] - a[1]) * (b[0] - a[0]) / (b[1] - a[1]);
    if (at > p[0]) inside = !inside;
  }
  return inside;
}

Q twice_area(const std::vector<Place>& ring) {
  Q sum = 0;
  for (std::size_t k = 1; k + 1 < ring.size(); ++k) sum += cross2(ring[0], ring[k], ring[k + 1]);
  return sum;
}

FacetId facet_with(const Mesh& mesh, TriangleId t) {
  const FaceId f = mesh.face_of[t];
  return mesh.faces[f] == FaceUse::planar ? FacetId(mesh.first_triangle[f]) : FacetId(t.value);
}

}  // namespace

Q SurfacesOracle::Segment::at(const Q& u) const {
  const Q share = (u - from[0]) / (to[0] - from[0]);
  return from[1] + share * (to[1] - from[1]);
}

SurfacesOracle::SurfacesOracle(const Mesh& mesh, const View& view, Coplanar coplanar)
    : mesh_(mesh),
      view_(view),
      is_last_visible_(coplanar == Coplanar::last),
      parallel_(view.viewpoint.is_direction),
      eye_(view.viewpoint.at) {
  // Rows that make an image without a mirror: u x v points to the viewer.
  const Vec toward = parallel_ ? eye_ : eye_ - Vec(view.target);
  axis_ = Q(-1) * toward;
  const Vec units[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (std::size_t k = 0; k < 3; ++k) {
    if (sgn(toward[static_cast<int>(k)]) == 0) continue;
    rows_ = {units[(k + 1) % 3], units[(k + 2) % 3]};
    if (sgn(toward[static_cast<int>(k)]) < 0) std::swap(rows_[0], rows_[1]);
    break;
  }
  areas_.resize(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) add_piece(TriangleId(t));
  cut_image();
}

/// Parallel: along the direction onto the plane of the two rows. Perspective: the ray, divided by its share of the axis.
Place SurfacesOracle::image(const Vec& p) const {
  if (parallel_) {
    const Q depth = dot(p, axis_) / dot(axis_, axis_);
    // Onto any plane across: (row . (p - s axis)) with s such that the third coordinate vanishes.
    const Vec third = {rows_[0].y * rows_[1].z - rows_[0].z * rows_[1].y, rows_[0].z * rows_[1].x - rows_[0].x * rows_[1].z,
                       rows_[0].x * rows_[1].y - rows_[0].y * rows_[1].x};
    const Q s = dot(third, p) / dot(third, axis_);
    const Vec on = p - s * axis_;
    return {dot(rows_[0], on), dot(rows_[1], on)};
  }
  const Vec q = p - eye_;
  const Q depth = dot(axis_, q);
  return {Q(dot(rows_[0], q) / depth), Q(dot(rows_[1], q) / depth)};
}

/// A number that is linear over the image of each plane, and larger nearer to the viewer.
Q SurfacesOracle::nearness(const Vec& p) const {
  if (!parallel_) return 1 / Q(dot(axis_, p - eye_));
  const Vec third = {rows_[0].y * rows_[1].z - rows_[0].z * rows_[1].y, rows_[0].z * rows_[1].x - rows_[0].x * rows_[1].z,
                     rows_[0].x * rows_[1].y - rows_[0].y * rows_[1].x};
  return -dot(third, p) / dot(third, axis_);
}

void SurfacesOracle::add_piece(TriangleId t) {
  std::vector<Vec> corners;
  const auto beyond = [&](const Vec& p) -> Q {
    if (view_.section) return dot(p - Vec(view_.section->point), Vec(view_.section->normal));
    if (parallel_) return 1;
    return dot(axis_, p - eye_) - Q(view_.near) * dot(axis_, axis_);
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec a(mesh_.points[mesh_.triangles[t][k]]), b(mesh_.points[mesh_.triangles[t][(k + 1) % 3]]);
    const Q at_a = beyond(a), at_b = beyond(b);
    if (sgn(at_a) >= 0) corners.push_back(a);
    if (sgn(at_a) * sgn(at_b) < 0) corners.push_back(a + Q(at_a / (at_a - at_b)) * (b - a));
  }
  if (corners.size() < 3) return;
  Piece piece{facet_with(mesh_, t), {}, {}};
  for (const Vec& p : corners) piece.corners.push_back(image(p));
  const Q area = twice_area(piece.corners);
  if (sgn(area) == 0) return;
  if (sgn(area) < 0) std::reverse(piece.corners.begin(), piece.corners.end());
  // n(u, v) through three corners that span the plane.
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const Place o = image(corners[0]), p = image(corners[i]), q = image(corners[i + 1]);
    const Q det = cross2(o, p, q);
    if (sgn(det) == 0) continue;
    const Q n0 = nearness(corners[0]), dp = nearness(corners[i]) - n0, dq = nearness(corners[i + 1]) - n0;
    const Q du = (dp * (q[1] - o[1]) - dq * (p[1] - o[1])) / det;
    const Q dv = (dq * (p[0] - o[0]) - dp * (q[0] - o[0])) / det;
    piece.nearness = {du, dv, Q(n0 - du * o[0] - dv * o[1])};
    break;
  }
  pieces_.push_back(std::move(piece));
}

std::vector<SurfacesOracle::Segment> SurfacesOracle::segments() const {
  std::vector<Segment> out;
  const auto add = [&](Place p, Place q) {
    if (p[0] > q[0]) std::swap(p, q);
    out.push_back({p, q});
  };
  for (const Piece& piece : pieces_)
    for (std::size_t k = 0; k < piece.corners.size(); ++k) add(piece.corners[k], piece.corners[(k + 1) % piece.corners.size()]);
  for (std::size_t i = 0; i < pieces_.size(); ++i)
    for (std::size_t j = i + 1; j < pieces_.size(); ++j) {
      const auto &x = pieces_[i].nearness, &y = pieces_[j].nearness;
      const Q a = x[0] - y[0], b = x[1] - y[1], c = x[2] - y[2];
      if (sgn(a) == 0 && sgn(b) == 0) continue;
      // The line a u + b v + c = 0, as a point and a direction, clipped to both.
      const Q square = a * a + b * b;
      const Place o = {Q(-a * c / square), Q(-b * c / square)}, d = {Q(-b), a};
      std::optional<Q> low, high;
      bool none = false;
      for (const Piece* piece : {&pieces_[i], &pieces_[j]})
        for (std::size_t k = 0; k < piece->corners.size(); ++k) {
          const Place &p = piece->corners[k], &q = piece->corners[(k + 1) % piece->corners.size()];
          const Q at_o = cross2(p, q, o), rise = (q[0] - p[0]) * d[1] - (q[1] - p[1]) * d[0];
          if (sgn(rise) == 0) {
            none = none || sgn(at_o) < 0;
            continue;
          }
          const Q t = -at_o / rise;
          if (sgn(rise) > 0 && (!low || t > *low)) low = t;
          if (sgn(rise) < 0 && (!high || t < *high)) high = t;
        }
      if (none || !low || !high || *low >= *high) continue;
      add({Q(o[0] + *low * d[0]), Q(o[1] + *low * d[1])}, {Q(o[0] + *high * d[0]), Q(o[1] + *high * d[1])});
    }
  return out;
}

FacetId SurfacesOracle::visible_at(const Place& p) const {
  FacetId best;
  Q nearest;
  for (const Piece& piece : pieces_) {
    bool inside = true;
    for (std::size_t k = 0; k < piece.corners.size() && inside; ++k)
      inside = sgn(cross2(piece.corners[k], piece.corners[(k + 1) % piece.corners.size()], p)) >= 0;
    if (!inside) continue;
    const Q n = piece.nearness[0] * p[0] + piece.nearness[1] * p[1] + piece.nearness[2];
    if (!best.is_valid() || n > nearest || (n == nearest && (is_last_visible_ ? piece.facet > best : piece.facet < best))) {
      best = piece.facet;
      nearest = n;
    }
  }
  return best;
}

void SurfacesOracle::cut_image() {
  std::vector<Segment> all = segments();
  std::set<Q> events;
  for (const Piece& piece : pieces_)
    for (const Place& p : piece.corners) events.insert(p[0]);
  for (const Segment& s : all) {
    events.insert(s.from[0]);
    events.insert(s.to[0]);
  }
  std::erase_if(all, [](const Segment& s) { return s.from[0] == s.to[0]; });  // upright ones bound slabs by their events
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      const Q left = std::max(all[i].from[0], all[j].from[0]), right = std::min(all[i].to[0], all[j].to[0]);
      if (left >= right) continue;
      const Q at_left = all[i].at(left) - all[j].at(left), at_right = all[i].at(right) - all[j].at(right);
      if (sgn(at_left) * sgn(at_right) < 0) events.insert(Q(left + (right - left) * at_left / (at_left - at_right)));
    }
  const std::vector<Q> at(events.begin(), events.end());
  for (std::size_t k = 0; k + 1 < at.size(); ++k) {
    const Q middle = (at[k] + at[k + 1]) / 2;
    std::vector<std::pair<Q, const Segment*>> spanning;
    for (const Segment& s : all)
      if (s.from[0] <= at[k] && s.to[0] >= at[k + 1]) spanning.emplace_back(s.at(middle), &s);
    std::sort(spanning.begin(), spanning.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
    for (std::size_t i = 0; i + 1 < spanning.size(); ++i) {
      if (spanning[i].first == spanning[i + 1].first) continue;
      const Place p = {middle, Q((spanning[i].first + spanning[i + 1].first) / 2)};
      const FacetId seen = visible_at(p);
      const Q area = (at[k + 1] - at[k]) * (spanning[i + 1].first - spanning[i].first);
      trapezoids_.push_back({p, at[k], at[k + 1], area, *spanning[i].second, *spanning[i + 1].second, seen});
      if (seen.is_valid()) areas_[seen.value] += area;
    }
  }
}

/// The connected interiors of each facet's visible part.
std::vector<std::size_t> SurfacesOracle::count_regions() const {
  std::vector<std::size_t> parent(trapezoids_.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto find = [&](std::size_t k) {
    while (parent[k] != k) k = parent[k] = parent[parent[k]];
    return k;
  };
  for (std::size_t i = 0; i < trapezoids_.size(); ++i)
    for (std::size_t j = i + 1; j < trapezoids_.size() && trapezoids_[j].left <= trapezoids_[i].right; ++j) {
      const Trapezoid &x = trapezoids_[i], &y = trapezoids_[j];
      if (x.visible != y.visible) continue;
      bool touch = false;
      if (x.left == y.left) {
        touch = x.above.at(x.middle[0]) == y.below.at(y.middle[0]);
      } else if (y.left == x.right) {
        const Q low = std::max(x.below.at(x.right), y.below.at(x.right)),
                high = std::min(x.above.at(x.right), y.above.at(x.right));
        touch = low < high;
      }
      if (touch) parent[find(j)] = find(i);
    }
  std::vector<std::size_t> count(mesh_.triangles.size(), 0);
  for (std::size_t k = 0; k < trapezoids_.size(); ++k)
    if (find(k) == k && trapezoids_[k].visible.is_valid()) ++count[trapezoids_[k].visible.value];
  return count;
}

std::vector<Place> SurfacesOracle::ring(const VisibleFragments& found, FacetId facet, std::uint32_t r) const {
  std::vector<Place> out;
  for (const MapCorner& c : found.rings[r]) {
    const auto at = exact_point(mesh_, view_, facet, c.at);
    out.push_back(image({exact(at[0]), exact(at[1]), exact(at[2])}));
  }
  return out;
}

std::vector<std::string> SurfacesOracle::differences(const VisibleFragments& found) const {
  std::vector<std::string> out;
  const auto complain = [&](const std::string& text) {
    if (out.size() < 8) out.push_back(text);
  };
  const std::size_t n = mesh_.triangles.size();
  std::vector<Q> areas(n);
  std::vector<std::size_t> count(n, 0);
  std::vector<std::vector<std::vector<Place>>> rings;  // by fragment
  for (const Fragment& f : found.fragments) {
    ++count[f.facet.value];
    rings.emplace_back();
    for (std::uint32_t r = f.first_ring; r < f.end_ring; ++r) {
      rings.back().push_back(ring(found, f.facet, r));
      const std::vector<Place>& corners = rings.back().back();
      const std::string name = "ring " + std::to_string(r) + " of triangle " + std::to_string(f.facet.value);
      const Q area = twice_area(corners);
      if ((sgn(area) > 0) != (r == f.first_ring)) complain(name + " runs the wrong way round");
      areas[f.facet.value] += area / 2;
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const Place &a = corners[k], &b = corners[(k + 1) % corners.size()], &c = corners[(k + 2) % corners.size()];
        if (sgn(cross2(a, b, c)) == 0) complain(name + " has a corner that is none");
        for (std::size_t j = k + 1; j < corners.size(); ++j)
          if (corners[j] == a) complain(name + " passes twice through a point");
      }
    }
  }
  const std::vector<std::size_t> regions = count_regions();
  for (std::size_t t = 0; t < n; ++t) {
    const std::string name = "triangle " + std::to_string(t);
    if (areas[t] != areas_[t]) complain(name + ": area found " + areas[t].get_str() + ", expected " + areas_[t].get_str());
    if (count[t] != regions[t])
      complain(name + ": fragments found " + std::to_string(count[t]) + ", expected " + std::to_string(regions[t]));
  }
  for (const Trapezoid& z : trapezoids_) {
    std::string seen;
    for (std::size_t k = 0; k < found.fragments.size(); ++k) {
      bool inside = false;
      for (const auto& corners : rings[k])
        if (is_inside(corners, z.middle)) inside = !inside;
      if (inside) seen += " " + std::to_string(found.fragments[k].facet.value);
    }
    const std::string expected = z.visible.is_valid() ? " " + std::to_string(z.visible.value) : "";
    if (seen != expected)
      complain("at " + z.middle[0].get_str() + ", " + z.middle[1].get_str() + ": found triangles" + seen + ", expected" +
               expected);
  }
  return out;
}

}  // namespace hsr::oracle
