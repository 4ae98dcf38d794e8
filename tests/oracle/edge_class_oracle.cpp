#include "tests/oracle/edge_class_oracle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tests/oracle/exact_vector.h"

namespace hsr::oracle {

namespace {

// A half-plane that ends at the edge: the direction from the edge, square to it, into a triangle.
struct HalfPlane {
  Vec into;
  int side;     // of the edge's view plane; 0: seen edge-on
  bool thin;    // the apex is so near to the edge's line, seen from a, that doubles may not find the direction
  bool passes;  // of a face that has the edge inside
};

bool deviates_from_flat(const HalfPlane& p, const HalfPlane& q, double crease, bool& is_near_crease) {
  const Vec turn = cross(p.into, q.into);
  const Q along = dot(p.into, q.into);
  if (is_zero(turn) && sgn(along) < 0) return false;  // exactly flat
  // The angle between the half-planes is under 180 degrees - crease where its cosine is over -cos(crease). Signed squares:
  const double c = std::cos(crease * 3.14159265358979323846 / 180);
  Q cosine = along * along / (dot(p.into, p.into) * dot(q.into, q.into));
  if (sgn(along) < 0) cosine = -cosine;
  const Q limit = c < 0 ? Q(Q(c) * Q(c)) : Q(-Q(c) * Q(c));
  const Q gap = cosine - limit;
  is_near_crease = p.thin || q.thin || abs(gap) < Q(1e-9);
  return sgn(gap) > 0;
}

class ClassAt {
 public:
  ClassAt(const Mesh& mesh, const View& view, EdgeId id) : edge_(mesh.edges[id]), a_(mesh.points[edge_.a]) {
    along_ = Vec(mesh.points[edge_.b]) - a_;
    const Vec eye(view.viewpoint.at);
    projected_ = view.viewpoint.is_direction ? eye : eye - a_;
  }

  void add(const Vec& apex, bool passes) {
    const Vec h = apex - a_;
    HalfPlane p{h - Q(dot(h, along_) / dot(along_, along_)) * along_, sgn(dot(along_, cross(projected_, h))), false, passes};
    p.thin = dot(p.into, p.into) < Q(0x1p-60) * dot(h, h);
    for (HalfPlane& q : half_planes_) {
      if (!is_zero(cross(p.into, q.into)) || sgn(dot(p.into, q.into)) < 0) continue;
      q.passes = q.passes || passes;
      return;
    }
    half_planes_.push_back(std::move(p));
  }

  std::optional<ClassVerdict> verdict(double crease) const;

 private:
  // On each side the nearest: the first that a half-plane meets which turns about the edge, from the eye to that side.
  const HalfPlane* nearest(int side) const {
    const HalfPlane* best = nullptr;
    for (const HalfPlane& p : half_planes_)
      if (p.side == side && (best == nullptr || side * sgn(dot(along_, cross(p.into, best->into))) > 0)) best = &p;
    return best;
  }
  // A face that has the edge inside, with others on both sides of it.
  bool is_pierced(const HalfPlane& face) const {
    const Vec normal = cross(along_, face.into);
    bool above = false, below = false;
    for (const HalfPlane& p : half_planes_) {
      above = above || sgn(dot(normal, p.into)) > 0;
      below = below || sgn(dot(normal, p.into)) < 0;
    }
    return face.passes && above && below;
  }

  const Edge& edge_;
  Vec a_, along_, projected_;
  std::vector<HalfPlane> half_planes_;  // each once
};

std::optional<ClassVerdict> ClassAt::verdict(double crease) const {
  const HalfPlane *left = nearest(1), *right = nearest(-1);
  const bool one_side = (left == nullptr) != (right == nullptr);
  if (edge_.diagonal && !edge_.of_face) {
    if (one_side) return ClassVerdict{EdgeClass::outline};
    if (!edge_.wire) return std::nullopt;
    return ClassVerdict{EdgeClass::wire};
  }
  ClassVerdict verdict;
  if (half_planes_.size() == 1) {
    verdict.edge_class = EdgeClass::boundary;
  } else if (one_side) {
    verdict.edge_class = EdgeClass::outline;
  } else if (left != nullptr && right != nullptr) {
    if (!is_zero(cross(left->into, right->into)) && (is_pierced(*left) || is_pierced(*right)))
      verdict.edge_class = EdgeClass::intersection;
    else if (deviates_from_flat(*left, *right, crease, verdict.is_near_crease))
      verdict.edge_class = EdgeClass::sharp;
  }
  if (edge_.wire && verdict.edge_class == EdgeClass::smooth) verdict.edge_class = EdgeClass::wire;
  return verdict;
}

// A triangle in one plane with an edge that it is not at, and how far inside each of its sides the ends are.
struct Around {
  TriangleId triangle;
  std::array<Vec, 3> corners;
  std::array<Q, 3> at_a, at_b;
};

std::vector<Around> triangles_around(const Mesh& mesh, EdgeId id) {
  const Vec a(mesh.points[mesh.edges[id].a]), b(mesh.points[mesh.edges[id].b]);
  const auto own = mesh.triangles_at(id);
  std::vector<Around> all;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    Around x{TriangleId(i), {}, {}, {}};
    if (std::find(own.begin(), own.end(), x.triangle) != own.end()) continue;
    for (std::size_t k = 0; k < 3; ++k) x.corners[k] = Vec(mesh.points[mesh.triangles[x.triangle][k]]);
    const Vec normal = cross(x.corners[1] - x.corners[0], x.corners[2] - x.corners[0]);
    if (sgn(dot(normal, a - x.corners[0])) != 0 || sgn(dot(normal, b - x.corners[0])) != 0) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec inward = cross(normal, x.corners[(k + 1) % 3] - x.corners[k]);
      x.at_a[k] = dot(inward, a - x.corners[k]);
      x.at_b[k] = dot(inward, b - x.corners[k]);
    }
    all.push_back(std::move(x));
  }
  return all;
}

}  // namespace

bool is_within_face(const Mesh& mesh, TriangleId t, std::size_t k) {
  if (mesh.faces[mesh.face_of[t]] != FaceUse::planar) return false;
  const VertexId u = mesh.triangles[t][k], v = mesh.triangles[t][(k + 1) % 3];
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const Edge& edge = mesh.edges[EdgeId(e)];
    if (std::minmax(edge.a, edge.b) != std::minmax(u, v)) continue;
    const auto at = mesh.triangles_at(EdgeId(e));
    return std::find(at.begin(), at.end(), t) == at.end();
  }
  return true;
}

std::vector<ClassPart> class_parts(const Mesh& mesh, const View& view, EdgeId id, double crease,
                                   const std::optional<Interval>& beyond) {
  ClassAt own(mesh, view, id);
  for (const TriangleId t : mesh.triangles_at(id)) own.add(Vec(mesh.points[mesh.apex(t, mesh.edges[id])]), false);
  if (!beyond) return {{{0, 1}, own.verdict(crease)}};
  if (mesh.triangles_at(id).empty()) return {{*beyond, own.verdict(crease)}};  // a wire stays one in any face
  const std::vector<Around> around = triangles_around(mesh, id);
  std::vector<Q> cuts = {beyond->from, beyond->to};
  for (const Around& x : around)
    for (std::size_t k = 0; k < 3; ++k)
      if (x.at_a[k] != x.at_b[k]) {
        const Q t = x.at_a[k] / (x.at_a[k] - x.at_b[k]);
        if (t > beyond->from && t < beyond->to) cuts.push_back(t);
      }
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  std::vector<ClassPart> parts;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const Q middle = (cuts[i] + cuts[i + 1]) / 2;
    ClassAt here = own;
    for (const Around& x : around) {
      std::array<int, 3> inside;
      std::size_t along = 3;
      for (std::size_t k = 0; k < 3; ++k) {
        inside[k] = sgn(Q(x.at_a[k] + middle * (x.at_b[k] - x.at_a[k])));
        if (inside[k] == 0) along = k;
      }
      if (*std::min_element(inside.begin(), inside.end()) < 0) continue;
      if (along < 3) {
        if (is_within_face(mesh, x.triangle, along)) here.add(x.corners[(along + 2) % 3], true);
        continue;
      }
      // The edge runs through: a corner on each side of it stands for a half-plane.
      const Vec a(mesh.points[mesh.edges[id].a]), b(mesh.points[mesh.edges[id].b]);
      for (const Vec& corner : x.corners)
        if (!is_zero(cross(b - a, corner - a))) here.add(corner, true);
    }
    const auto verdict = here.verdict(crease);
    const bool goes_on = !parts.empty() && parts.back().verdict.has_value() == verdict.has_value() &&
                         (!verdict || parts.back().verdict->edge_class == verdict->edge_class);
    if (goes_on) {
      parts.back().part.to = cuts[i + 1];
      if (verdict && verdict->is_near_crease) parts.back().verdict->is_near_crease = true;
    } else {
      parts.push_back({{cuts[i], cuts[i + 1]}, verdict});
    }
  }
  return parts;
}

}  // namespace hsr::oracle
