#include "tests/oracle/edge_class_oracle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tests/oracle/exact_vector.h"

namespace hsr::oracle {

namespace {

// A half-plane that ends at the edge: the direction from the edge, square to it, into a face.
struct HalfPlane {
  Vec into;
  int side;            // of the edge's view plane; 0: seen edge-on
  bool thin;           // the apex is so near to the edge's line, seen from a, that doubles may not find the direction
  FaceId top;          // the face that is on top of those that coincide in it
  int faces = 1;       // how many do
  bool front = false;  // seen edge-on, and starts toward the eye
};

bool deviates_from_flat(const HalfPlane& p, const HalfPlane& q, double crease, bool& is_near_crease) {
  const Vec turn = cross(p.into, q.into);
  const Q along = dot(p.into, q.into);
  if (is_zero(turn) && sgn(along) < 0) return false;  // exactly flat
  // The angle between the half-planes is under 180 degrees - crease where its cosine is over -cos(crease). Signed squares:
  const double c = std::cos((crease + 0.01) * 3.14159265358979323846 / 180);
  Q cosine = along * along / (dot(p.into, p.into) * dot(q.into, q.into));
  if (sgn(along) < 0) cosine = -cosine;
  const Q limit = c < 0 ? Q(Q(c) * Q(c)) : Q(-Q(c) * Q(c));
  const Q gap = cosine - limit;
  is_near_crease = p.thin || q.thin || abs(gap) < Q(1e-9);
  return sgn(gap) > 0;
}

class ClassAt {
 public:
  ClassAt(const Mesh& mesh, const View& view, const FaceLabels& labels, Coplanar coplanar, EdgeId id)
      : edge_(mesh.edges[id]), labels_(labels), coplanar_(coplanar), a_(mesh.points[edge_.a]) {
    along_ = Vec(mesh.points[edge_.b]) - a_;
    const Vec eye(view.viewpoint.at);
    projected_ = view.viewpoint.is_direction ? eye : eye - a_;
  }

  void add(const Vec& apex, FaceId face) {
    const Vec h = apex - a_;
    HalfPlane p{square_to_edge(h), sgn(dot(along_, cross(projected_, h))), false, face};
    p.thin = dot(p.into, p.into) < Q(0x1p-60) * dot(h, h);
    if (p.side == 0) p.front = sgn(dot(p.into, square_to_edge(projected_))) > 0;
    for (HalfPlane& q : half_planes_) {
      if (!is_zero(cross(p.into, q.into)) || sgn(dot(p.into, q.into)) < 0) continue;
      ++q.faces;
      q.top = coplanar_ == Coplanar::first ? std::min(q.top, face) : std::max(q.top, face);
      return;
    }
    half_planes_.push_back(std::move(p));
  }

  ClassPart verdicts(double crease) const;

 private:
  Vec square_to_edge(const Vec& h) const { return h - Q(dot(h, along_) / dot(along_, along_)) * along_; }
  // How far a half-plane is turned from the eye to its side, for comparison: whether x is turned less than y.
  bool is_nearer(const HalfPlane& x, const HalfPlane& y) const { return x.side * sgn(dot(along_, cross(x.into, y.into))) > 0; }
  std::vector<const HalfPlane*> counted() const;
  // Intersection or sharp, or nothing.
  std::optional<ClassVerdict> bent(const HalfPlane& left, const HalfPlane& right, const HalfPlane* edge_on,
                                   double crease) const;
  EdgeClass flat(FaceId left, FaceId right) const {
    if (!labels_.material.empty() && labels_.material[left.value] != labels_.material[right.value]) return EdgeClass::material;
    if (!labels_.object.empty() && labels_.object[left.value] != labels_.object[right.value]) return EdgeClass::joint;
    return EdgeClass::smooth;
  }

  const Edge& edge_;
  const FaceLabels& labels_;
  Coplanar coplanar_;
  Vec a_, along_, projected_;
  std::vector<HalfPlane> half_planes_;  // each once
};

// Those that are more than where bodies touch: several faces in a half-plane that is seen edge-on, or behind a nearer one.
std::vector<const HalfPlane*> ClassAt::counted() const {
  std::vector<const HalfPlane*> all;
  for (const HalfPlane& p : half_planes_) {
    bool touches = p.faces > 1 && p.side == 0;
    for (const HalfPlane& q : half_planes_) touches = touches || (p.faces > 1 && p.side == q.side && is_nearer(q, p));
    if (!touches) all.push_back(&p);
  }
  return all;
}

std::optional<ClassVerdict> ClassAt::bent(const HalfPlane& left, const HalfPlane& right, const HalfPlane* edge_on,
                                          double crease) const {
  const auto pierced = [&](const HalfPlane& x) {
    const Vec normal = cross(along_, x.into);
    bool opposite = false, above = false, below = false;
    for (const HalfPlane& p : half_planes_) {
      const int s = sgn(dot(normal, p.into));
      opposite = opposite || (s == 0 && sgn(dot(x.into, p.into)) < 0);
      above = above || s > 0;
      below = below || s < 0;
    }
    return opposite && above && below;
  };
  if (is_zero(cross(left.into, right.into)) && edge_on == nullptr) return std::nullopt;
  if (pierced(left) || pierced(right) || (edge_on != nullptr && pierced(*edge_on)))
    return ClassVerdict{EdgeClass::intersection};
  if (edge_on != nullptr) return ClassVerdict{EdgeClass::sharp};
  ClassVerdict verdict;
  if (deviates_from_flat(left, right, crease, verdict.is_near_crease)) verdict.edge_class = EdgeClass::sharp;
  if (verdict.edge_class != EdgeClass::sharp && !verdict.is_near_crease) return std::nullopt;
  return verdict;
}

ClassPart ClassAt::verdicts(double crease) const {
  std::array<std::vector<const HalfPlane*>, 2> sides;  // left and right, those that count
  const HalfPlane *front = nullptr, *back = nullptr;
  bool has_side[2] = {false, false};
  for (const HalfPlane& p : half_planes_)
    if (p.side != 0) has_side[p.side > 0 ? 0 : 1] = true;
  const std::vector<const HalfPlane*> all = counted();
  for (const HalfPlane* p : all) {
    if (p->side != 0) sides[p->side > 0 ? 0 : 1].push_back(p);
    if (p->side == 0) (p->front ? front : back) = p;
  }
  const auto as = [](EdgeClass c) { return ClassPart{{}, ClassVerdict{c}}; };
  const bool only_diagonal = edge_.diagonal && !edge_.of_face, one_side = has_side[0] != has_side[1];
  ClassPart part{{}, std::nullopt};
  if (only_diagonal && one_side) {
    part = as(EdgeClass::outline);
  } else if (only_diagonal) {
  } else if (half_planes_.size() == 1) {
    part = as(EdgeClass::boundary);
  } else if (one_side) {
    part = as(EdgeClass::outline);
  } else if (!has_side[0]) {
    part = as(EdgeClass::smooth);
  } else {
    for (auto& side : sides)
      std::sort(side.begin(), side.end(), [&](const HalfPlane* x, const HalfPlane* y) { return is_nearer(*x, *y); });
    part.verdict = bent(*sides[0].front(), *sides[1].front(), front, crease);
    const EdgeClass else_class = flat(sides[0].front()->top, sides[1].front()->top);
    const bool is_flat = !part.verdict || part.verdict->edge_class == EdgeClass::smooth;
    if (is_flat) part.behind = bent(*sides[0].back(), *sides[1].back(), back, crease);
    const bool is_near = part.verdict && part.verdict->is_near_crease;
    if (is_flat) part.verdict = ClassVerdict{else_class, is_near};
    part.verdict->flat = else_class;
  }
  const bool is_plain =
      !part.verdict || part.verdict->edge_class == EdgeClass::smooth || part.verdict->edge_class == EdgeClass::joint;
  if (edge_.wire && is_plain) part.verdict = ClassVerdict{EdgeClass::wire, part.verdict && part.verdict->is_near_crease};
  if (edge_.wire && part.verdict->is_near_crease) part.verdict->flat = EdgeClass::wire;
  return part;
}

// A triangle in one plane with an edge, and how far inside each of its sides the ends are.
struct Around {
  TriangleId triangle;
  std::array<Vec, 3> corners;
  std::array<Q, 3> at_a, at_b;
};

std::vector<Around> triangles_around(const Mesh& mesh, EdgeId id) {
  const Vec a(mesh.points[mesh.edges[id].a]), b(mesh.points[mesh.edges[id].b]);
  std::vector<Around> all;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    Around x{TriangleId(i), {}, {}, {}};
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

std::vector<ClassPart> class_parts(const Mesh& mesh, const View& view, const FaceLabels& labels, Coplanar coplanar, EdgeId id,
                                   double crease, const std::optional<Interval>& beyond) {
  const ClassAt empty(mesh, view, labels, coplanar, id);
  if (!beyond) {
    ClassAt own = empty;
    for (const TriangleId t : mesh.triangles_at(id)) own.add(Vec(mesh.points[mesh.apex(t, mesh.edges[id])]), mesh.face_of[t]);
    ClassPart part = own.verdicts(crease);
    part.part = {0, 1};
    part.behind.reset();
    return {part};
  }
  // A wire stays one in any face.
  if (mesh.triangles_at(id).empty()) return {{*beyond, ClassVerdict{EdgeClass::wire}}};
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
  const Vec a(mesh.points[mesh.edges[id].a]), b(mesh.points[mesh.edges[id].b]);
  std::vector<ClassPart> parts;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const Q middle = (cuts[i] + cuts[i + 1]) / 2;
    ClassAt here = empty;
    for (const Around& x : around) {
      std::array<int, 3> inside;
      std::size_t along = 3;
      for (std::size_t k = 0; k < 3; ++k) {
        inside[k] = sgn(Q(x.at_a[k] + middle * (x.at_b[k] - x.at_a[k])));
        if (inside[k] == 0) along = k;
      }
      if (*std::min_element(inside.begin(), inside.end()) < 0) continue;
      // Along a side the third corner is on the face's side of it; inside, a corner on each side stands for a half-plane.
      bool has[2] = {false, false};
      for (std::size_t k = 0; k < 3; ++k) {
        if (along < 3 && k != (along + 2) % 3) continue;
        const Vec normal = cross(x.corners[1] - x.corners[0], x.corners[2] - x.corners[0]);
        const int side = sgn(dot(normal, cross(b - a, x.corners[k] - a)));
        if (side == 0 || has[side > 0 ? 0 : 1]) continue;
        has[side > 0 ? 0 : 1] = true;
        here.add(x.corners[k], mesh.face_of[x.triangle]);
      }
    }
    ClassPart found = here.verdicts(crease);
    found.part = {cuts[i], cuts[i + 1]};
    if (!parts.empty() && parts.back().verdict == found.verdict && parts.back().behind == found.behind) {
      parts.back().part.to = cuts[i + 1];
      if (found.verdict && found.verdict->is_near_crease) parts.back().verdict->is_near_crease = true;
    } else {
      parts.push_back(std::move(found));
    }
  }
  return parts;
}

}  // namespace hsr::oracle
