#include "hsr/sheet/model_circles.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>

#include "hsr/drawing/space_circle.h"

namespace hsr::internal {

namespace {

constexpr double most_turn = 46;      // degrees from one edge to the next: eight edges are a circle
constexpr double least_around = 170;  // degrees: the round end of a slot has 180
constexpr double same_curvature = 0.5;
constexpr double same_axis = 0.2;       // the sine of an angle between the axes of two turns
constexpr std::size_t least_known = 6;  // vertices, before a circle says where to go on
constexpr double on_circle = 1e-3;      // of the radius, of a vertex whose turn says something else
constexpr double near_circle = 1e-2;    // of the radius: meshes of solvers have vertices on chords

SpaceVector minus(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double dot(const SpaceVector& a, const SpaceVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
SpaceVector cross(const SpaceVector& a, const SpaceVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double length(const SpaceVector& a) { return std::hypot(a[0], a[1], a[2]); }

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

SpaceVector normal_of(const Mesh& mesh, TriangleId t) {
  const auto& c = mesh.triangles[t];
  return cross(minus(mesh.points[c[1]], mesh.points[c[0]]), minus(mesh.points[c[2]], mesh.points[c[0]]));
}

/// Whether an edge is one of a face alone, or bends by more than the crease.
bool is_feature(const Mesh& mesh, EdgeId e, double crease) {
  if (!mesh.edges[e].of_face) return false;
  const auto triangles = mesh.triangles_at(e);
  if (triangles.size() != 2) return true;
  SpaceVector a = normal_of(mesh, triangles[0]), b = normal_of(mesh, triangles[1]);
  const bool turned = mesh.runs_along(triangles[0], mesh.edges[e]) == mesh.runs_along(triangles[1], mesh.edges[e]);
  if (turned) b = {-b[0], -b[1], -b[2]};
  return degrees(std::atan2(length(cross(a, b)), dot(a, b))) > crease;
}

/// How a path turns at a vertex, from one edge to the next.
struct Turn {
  SpaceVector axis;  ///< of length 1
  double degrees, curvature;
};

/// The edges that may be of circles, by vertex.
class FeatureEdges {
 public:
  FeatureEdges(const Mesh& mesh, double crease) : mesh_(mesh), first_(mesh.points.size() + 1, 0) {
    std::vector<EdgeId> found;
    for (std::uint32_t e = 0; e < mesh.edges.size(); ++e)
      if (is_feature(mesh, EdgeId(e), crease)) found.emplace_back(e);
    for (const EdgeId e : found)
      for (const VertexId v : {mesh.edges[e].a, mesh.edges[e].b}) ++first_[v.value + 1];
    for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
    at_.resize(2 * found.size());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (const EdgeId e : found)
      for (const VertexId v : {mesh.edges[e].a, mesh.edges[e].b}) at_[next[v.value]++] = e;
    edges_ = std::move(found);
  }

  const std::vector<EdgeId>& edges() const { return edges_; }

  /// The turn from the edge between two vertices to a third; nothing where it is none of a circle.
  std::optional<Turn> turn(VertexId a, VertexId b, VertexId c) const {
    const SpaceVector u = minus(mesh_.points[b], mesh_.points[a]), v = minus(mesh_.points[c], mesh_.points[b]);
    const SpaceVector n = cross(u, v);
    const double size = length(n), angle = degrees(std::atan2(size, dot(u, v)));
    if (!(size > 0) || !(angle <= most_turn)) return {};
    return Turn{{n[0] / size, n[1] / size, n[2] / size}, angle, angle / (length(u) + length(v))};
  }

  /// Where a path from a to b goes on, as it turned before.
  std::optional<VertexId> next(VertexId a, VertexId b, const Turn& as) const {
    std::optional<VertexId> best;
    double least = same_curvature;
    for (const VertexId c : neighbours(b)) {
      if (c == a) continue;
      const auto t = turn(a, b, c);
      if (!t || !(dot(t->axis, as.axis) > 0) || !(length(cross(t->axis, as.axis)) < same_axis)) continue;
      const double off = std::fabs(t->curvature / as.curvature - 1);
      if (off < least) {
        least = off;
        best = c;
      }
    }
    return best;
  }
  /// Where it goes on along the circle that it is on so far: beside an edge that is very short turns say little.
  std::optional<VertexId> next_on_circle_of(const std::vector<VertexId>& path, VertexId a, VertexId b) const {
    const Point3 origin = mesh_.points[path[0]];
    std::vector<SpaceVector> places;
    for (const VertexId v : path) places.push_back(minus(mesh_.points[v], origin));
    const auto circle = circle_through(places);
    if (!circle) return {};
    for (const VertexId c : neighbours(b)) {
      if (c == a || !(circle->distance(minus(mesh_.points[c], origin)) <= on_circle * circle->radius)) continue;
      const SpaceVector u = minus(mesh_.points[b], mesh_.points[a]), v = minus(mesh_.points[c], mesh_.points[b]);
      if (degrees(std::atan2(length(cross(u, v)), dot(u, v))) <= most_turn) return c;
    }
    return {};
  }

  std::vector<VertexId> neighbours(VertexId v) const {
    std::vector<VertexId> all;
    for (std::uint32_t k = first_[v.value]; k < first_[v.value + 1]; ++k) {
      const Edge& e = mesh_.edges[at_[k]];
      all.push_back(e.a == v ? e.b : e.a);
    }
    return all;
  }

 private:
  const Mesh& mesh_;
  std::vector<std::uint32_t> first_;
  std::vector<EdgeId> at_;
  std::vector<EdgeId> edges_;
};

/// A path along one circle, both ways from its first turn as far as it goes.
std::vector<VertexId> path_along(const FeatureEdges& features, VertexId a, VertexId b, VertexId c, const Turn& turn) {
  std::vector<VertexId> path = {a, b, c};
  constexpr std::size_t longest = 4096;
  while (path.back() != path.front() && path.size() < longest) {
    const VertexId from = path[path.size() - 2], at = path.back();
    auto next = features.next(from, at, turn);
    if (!next && path.size() >= least_known) next = features.next_on_circle_of(path, from, at);
    if (!next) break;
    path.push_back(*next);
  }
  if (path.back() == path.front()) return path;
  const Turn back = {{-turn.axis[0], -turn.axis[1], -turn.axis[2]}, turn.degrees, turn.curvature};
  std::vector<VertexId> before;
  VertexId from = b, at = a;
  for (std::size_t steps = 0; steps < 4096; ++steps) {
    const auto next = features.next(from, at, back);
    if (!next || *next == path.back()) break;
    before.push_back(*next);
    from = at;
    at = *next;
  }
  std::reverse(before.begin(), before.end());
  before.insert(before.end(), path.begin(), path.end());
  return before;
}

std::vector<std::array<std::uint32_t, 2>> edges_of(const std::vector<VertexId>& path) {
  std::vector<std::array<std::uint32_t, 2>> edges;
  for (std::size_t k = 0; k + 1 < path.size(); ++k)
    edges.push_back({std::min(path[k], path[k + 1]).value, std::max(path[k], path[k + 1]).value});
  std::ranges::sort(edges);
  return edges;
}

/// The circle of a path, if its vertices are on one and it goes far enough around.
std::optional<ModelCircle> circle_of(const Mesh& mesh, const std::vector<VertexId>& path) {
  const bool closed = path.front() == path.back();
  const Point3 base = mesh.points[path[0]];
  std::vector<SpaceVector> places;
  for (std::size_t k = 0; k + (closed ? 1 : 0) < path.size(); ++k) places.push_back(minus(mesh.points[path[k]], base));
  const auto circle = circle_through(places);
  if (!circle) return {};
  double around = closed ? 360 : 0;
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (!(circle->distance(places[k]) <= near_circle * circle->radius)) return {};
    if (k + 1 == places.size() && !closed) break;
    const SpaceVector& following = places[(k + 1) % places.size()];
    const double span =
        degrees(std::fabs(std::remainder(circle->angle(following) - circle->angle(places[k]), 2 * std::numbers::pi)));
    if (span > most_turn) return {};
    if (!closed) around += span;
  }
  if (around < least_around) return {};
  const SpaceVector axis = cross(circle->u, circle->v);
  return ModelCircle{{base.x + circle->centre[0], base.y + circle->centre[1], base.z + circle->centre[2]},
                     {axis[0], axis[1], axis[2]},
                     circle->radius,
                     edges_of(path)};
}

}  // namespace

std::vector<ModelCircle> model_circles(const Mesh& mesh, double crease) {
  const FeatureEdges features(mesh, crease);
  IndexedVector<EdgeId, std::uint8_t> is_done(mesh.edges.size(), 0);
  std::vector<ModelCircle> circles;
  const auto done = [&](VertexId a, VertexId b) -> std::uint8_t& {
    return is_done[mesh.find_edge(std::min(a, b), std::max(a, b))];
  };
  for (const EdgeId e : features.edges()) {
    const Edge& edge = mesh.edges[e];
    for (const VertexId c : features.neighbours(edge.b)) {
      if (is_done[e] != 0) break;
      if (c == edge.a || done(edge.b, c) != 0) continue;
      const auto turn = features.turn(edge.a, edge.b, c);
      if (!turn) continue;
      const std::vector<VertexId> path = path_along(features, edge.a, edge.b, c, *turn);
      const auto circle = circle_of(mesh, path);
      if (!circle) continue;
      circles.push_back(*circle);
      for (std::size_t k = 0; k + 1 < path.size(); ++k) done(path[k], path[k + 1]) = 1;
    }
  }
  return circles;
}

std::vector<ModelAxis> axes_of(const std::vector<ModelCircle>& circles, double reach) {
  std::vector<ModelAxis> axes;
  const double near = reach * 1e-4;
  for (const ModelCircle& c : circles) {
    const auto fits = [&](const ModelAxis& a) {
      const SpaceVector d = {a.direction.x, a.direction.y, a.direction.z}, n = {c.axis.x, c.axis.y, c.axis.z};
      return length(cross(d, n)) < 1e-3 && length(cross(minus(c.centre, a.point), d)) < near;
    };
    auto found = std::ranges::find_if(axes, fits);
    if (found == axes.end()) {
      axes.push_back({c.centre, c.axis, 0, 0, c.radius});
      continue;
    }
    const double along = dot(minus(c.centre, found->point), {found->direction.x, found->direction.y, found->direction.z});
    found->first = std::min(found->first, along);
    found->last = std::max(found->last, along);
    found->radius = std::max(found->radius, c.radius);
  }
  return axes;
}

}  // namespace hsr::internal
