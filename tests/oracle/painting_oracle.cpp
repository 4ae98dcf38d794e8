#include "tests/oracle/painting_oracle.h"

#include <algorithm>
#include <array>
#include <map>

namespace hsr::oracle {

namespace {

/// A point of the image: in a parallel view along the direction, in perspective as homogeneous coordinates over the depth.
struct Place {
  Q x, y;
  friend bool operator==(const Place& a, const Place& b) { return a.x == b.x && a.y == b.y; }
};

class Image {
 public:
  explicit Image(const View& view) : parallel_(view.viewpoint.is_direction), eye_(view.viewpoint.at) {
    const Vec axis = parallel_ ? eye_ : Vec(view.target) - eye_;
    away_ = parallel_ ? Q(-1) * axis : axis;
    // Two directions across: any that with the axis span space.
    for (int k = 0; k < 3; ++k) {
      const Vec unit = {Q(k == 0), Q(k == 1), Q(k == 2)};
      const Vec c = cross(axis, unit);
      if (is_zero(c)) continue;
      across_[0] = c;
      across_[1] = cross(axis, c);
      break;
    }
  }

  Place place(const Vec& p) const {
    const Vec d = parallel_ ? p : p - eye_;
    const Q w = parallel_ ? Q(1) : dot(d, away_);
    return {dot(d, across_[0]) / w, dot(d, across_[1]) / w};
  }
  /// How far the plane of a polygon is where p is seen, as something that grows with the distance.
  Q distance(const PaintedPolygon& polygon, const Place& p) const {
    const Vec n = normal(polygon);
    // In parallel views the point x across + y across + t away, in perspective eye + t (...): solve n . X = n . corner.
    const Q a0 = dot(across_[0], across_[0]), a1 = dot(across_[1], across_[1]), aw = dot(away_, away_);
    const Vec in_plane = Q(p.x / a0) * across_[0] + Q(p.y / a1) * across_[1];
    if (parallel_) return (dot(n, polygon.corners[0]) - dot(n, in_plane)) / dot(n, away_);
    const Vec ray = in_plane + Q(1 / aw) * away_;
    return dot(n, polygon.corners[0] - eye_) / dot(n, ray);
  }
  static Vec normal(const PaintedPolygon& polygon) {
    // Newell's: pieces may begin with collinear corners.
    Vec n(0, 0, 0);
    for (std::size_t k = 0; k < polygon.corners.size(); ++k)
      n = n + cross(polygon.corners[k], polygon.corners[(k + 1) % polygon.corners.size()]);
    return n;
  }

 private:
  bool parallel_;
  Vec eye_, away_;
  std::array<Vec, 2> across_;
};

Q twice_area(const std::vector<Place>& ring) {
  Q sum = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Place &p = ring[k], &q = ring[(k + 1) % ring.size()];
    sum += p.x * q.y - p.y * q.x;
  }
  return sum;
}

std::vector<Place> ring_of(const Image& image, const PaintedPolygon& polygon) {
  std::vector<Place> ring;
  for (const Vec& c : polygon.corners) ring.push_back(image.place(c));
  if (twice_area(ring) < 0) std::reverse(ring.begin(), ring.end());
  return ring;
}

std::vector<Place> common(std::vector<Place> ring, const std::vector<Place>& other) {
  for (std::size_t k = 0; k < other.size() && !ring.empty(); ++k) {
    const Place &a = other[k], &b = other[(k + 1) % other.size()];
    const auto inside = [&](const Place& p) -> Q { return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x); };
    std::vector<Place> out;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Place &p = ring[i], &q = ring[(i + 1) % ring.size()];
      const Q s = inside(p), t = inside(q);
      if (s >= 0) out.push_back(p);
      if ((s > 0 && t < 0) || (s < 0 && t > 0)) {
        const Q u = s / (s - t);
        out.push_back({p.x + u * (q.x - p.x), p.y + u * (q.y - p.y)});
      }
    }
    ring = std::move(out);
  }
  return ring;
}

PairOrder order_of(const Image& image, const PaintedPolygon& a, const PaintedPolygon& b) {
  const std::vector<Place> part = common(ring_of(image, a), ring_of(image, b));
  if (twice_area(part) <= 0) return PairOrder::apart;
  bool first_farther = false, second_farther = false;
  for (const Place& p : part) {
    const Q gap = image.distance(a, p) - image.distance(b, p);
    first_farther = first_farther || gap > 0;
    second_farther = second_farther || gap < 0;
  }
  if (first_farther && second_farther) return PairOrder::piercing;
  return first_farther ? PairOrder::first_behind : second_farther ? PairOrder::second_behind : PairOrder::coplanar;
}

Vec exact_vec(const std::array<Rational, 3>& p) { return {exact(p[0]), exact(p[1]), exact(p[2])}; }

/// Part of a convex ring, on the positive side of the line through a and b or on the other.
std::vector<Place> half(const std::vector<Place>& ring, const Place& a, const Place& b, int which) {
  const auto side = [&](const Place& p) -> Q { return Q(which) * ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)); };
  std::vector<Place> out;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Place &p = ring[i], &q = ring[(i + 1) % ring.size()];
    const Q s = side(p), t = side(q);
    if (s >= 0) out.push_back(p);
    if ((s > 0 && t < 0) || (s < 0 && t > 0)) {
      const Q u = s / (s - t);
      out.push_back({p.x + u * (q.x - p.x), p.y + u * (q.y - p.y)});
    }
  }
  return out;
}

/// Twice the area of a convex ring outside the others.
Q twice_area_outside(const std::vector<Place>& ring, const std::vector<std::vector<Place>>& others) {
  std::vector<std::vector<Place>> parts = {ring};
  for (const std::vector<Place>& other : others) {
    if (other.empty()) continue;  // before the near plane
    std::vector<std::vector<Place>> outside;
    for (std::vector<Place> inside : parts)
      for (std::size_t k = 0; k < other.size() && !inside.empty(); ++k) {
        const Place &a = other[k], &b = other[(k + 1) % other.size()];
        outside.push_back(half(inside, a, b, -1));
        inside = half(inside, a, b, 1);
      }
    parts = std::move(outside);
  }
  Q sum = 0;
  for (const std::vector<Place>& part : parts) sum += twice_area(part);
  return sum;
}

/// A triangle as far as it is beyond the near plane, in the image.
std::vector<Place> seen_triangle(const Mesh& mesh, const View& view, const Image& image, TriangleId t) {
  std::vector<Vec> ring;
  for (const VertexId v : mesh.triangles[t]) ring.emplace_back(mesh.points[v]);
  if (view.is_perspective()) {
    const Vec eye(view.viewpoint.at), axis = Vec(view.target) - eye;
    const Q near = Q(view.near) * dot(axis, axis);
    std::vector<Vec> out;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Vec &p = ring[k], &q = ring[(k + 1) % ring.size()];
      const Q s = dot(p - eye, axis) - near, u = dot(q - eye, axis) - near;
      if (s >= 0) out.push_back(p);
      if ((s > 0 && u < 0) || (s < 0 && u > 0)) out.push_back(p + Q(s / (s - u)) * (q - p));
    }
    ring = std::move(out);
  }
  std::vector<Place> places;
  for (const Vec& p : ring) places.push_back(image.place(p));
  if (twice_area(places) < 0) std::reverse(places.begin(), places.end());
  return places;
}

/// Twice the area in the image of a facet, as far as it is beyond the near plane; of a face that crosses itself, without what the
/// triangles of it that are on top cover.
Q twice_area_of_facet(const Mesh& mesh, const View& view, const Image& image, FacetId facet, Coplanar coplanar) {
  const FaceId f = mesh.face_of[first_triangle(facet)];
  const std::uint32_t first = mesh.first_triangle[f], end = mesh.first_triangle[FaceId(f.value + 1)];
  const bool planar = mesh.faces[f] == FaceUse::planar;
  std::vector<std::vector<Place>> on_top;
  if (mesh.faces[f] == FaceUse::crosses_itself)
    for (std::uint32_t t = first; t < end; ++t)
      if (coplanar == Coplanar::last ? t > facet.value : t < facet.value)
        on_top.push_back(seen_triangle(mesh, view, image, TriangleId(t)));
  Q sum = 0;
  for (std::uint32_t t = facet.value; t < (planar ? end : facet.value + 1); ++t)
    sum += twice_area_outside(seen_triangle(mesh, view, image, TriangleId(t)), on_top);
  return sum;
}

}  // namespace

PairOrder pair_order(const View& view, const PaintedPolygon& a, const PaintedPolygon& b) { return order_of(Image(view), a, b); }

std::vector<std::string> wrong_with_order(const Mesh& mesh, const View& view, const PaintersOrder& order, Coplanar coplanar) {
  const Image image(view);
  std::vector<std::string> wrong;
  std::vector<PaintedPolygon> polygons;
  std::map<FacetId, Q> covered;
  for (const OrderedPiece& piece : order.pieces) {
    PaintedPolygon p;
    for (const PieceCorner& c : order.corners_of(piece))
      p.corners.push_back(exact_vec(exact_point(mesh, view, piece.facet, c)));
    p.rank = piece.facet.value;
    covered[piece.facet] += twice_area(ring_of(image, p));
    polygons.push_back(std::move(p));
  }
  const auto say = [&](std::size_t i, std::size_t k, const char* what) {
    wrong.push_back("pieces " + std::to_string(i) + " of triangle " + std::to_string(polygons[i].rank) + " and " +
                    std::to_string(k) + " of triangle " + std::to_string(polygons[k].rank) + ": " + what);
  };
  for (std::size_t i = 0; i < polygons.size(); ++i)
    for (std::size_t k = i + 1; k < polygons.size(); ++k) {
      const PairOrder how = order_of(image, polygons[i], polygons[k]);
      if (how == PairOrder::apart) continue;
      const FaceId face = mesh.face_of[TriangleId(polygons[i].rank)];
      const bool is_one_face = face == mesh.face_of[TriangleId(polygons[k].rank)] && mesh.faces[face] != FaceUse::not_coplanar;
      if (is_one_face) say(i, k, "pieces of one face overlap");
      if (how == PairOrder::second_behind) say(i, k, "the nearer is painted first");
      if (how == PairOrder::piercing) say(i, k, "they pierce each other");
      const bool is_last = coplanar == Coplanar::last;
      if (how == PairOrder::coplanar && !is_last && polygons[i].rank < polygons[k].rank)
        say(i, k, "the lower face is painted first");
      if (how == PairOrder::coplanar && is_last && polygons[i].rank > polygons[k].rank)
        say(i, k, "the higher face is painted first");
    }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const FacetId facet(t);
    const FaceId f = mesh.face_of[first_triangle(facet)];
    if (mesh.faces[f] == FaceUse::planar && mesh.first_triangle[f] != t) continue;
    const Q all = twice_area_of_facet(mesh, view, image, facet, coplanar),
            found = covered.contains(facet) ? covered[facet] : Q(0);
    if (all != found) wrong.push_back("triangle " + std::to_string(t) + " is not covered exactly once");
  }
  return wrong;
}

}  // namespace hsr::oracle
