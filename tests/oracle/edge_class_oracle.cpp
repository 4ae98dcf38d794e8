#include "tests/oracle/edge_class_oracle.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/oracle/exact_vector.h"

namespace hsr::oracle {

namespace {

// A half-plane that ends at the edge: the direction from the edge, square to it, into a triangle.
struct HalfPlane {
  Vec into;
  int side;   // of the edge's view plane; 0: seen edge-on
  bool thin;  // the apex is so near to the edge's line, seen from a, that doubles may not find the direction
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

}  // namespace

std::optional<ClassVerdict> class_of(const Mesh& mesh, const View& view, EdgeId id, double crease) {
  const Edge& edge = mesh.edges[id];
  const Vec a(mesh.points[edge.a]), b(mesh.points[edge.b]);
  const Vec along = b - a;
  const Q length2 = dot(along, along);
  const Vec eye(view.viewpoint.at);
  const Vec sight = view.viewpoint.is_direction ? eye : eye - a;

  std::vector<HalfPlane> half_planes;  // each once
  for (const TriangleId t : mesh.triangles_at(id)) {
    const Vec h = Vec(mesh.points[mesh.apex(t, edge)]) - a;
    HalfPlane p{h - Q(dot(h, along) / length2) * along, sgn(dot(along, cross(sight, h))), false};
    p.thin = dot(p.into, p.into) < Q(0x1p-60) * dot(h, h);
    const bool is_known = std::any_of(half_planes.begin(), half_planes.end(), [&](const HalfPlane& q) {
      return is_zero(cross(p.into, q.into)) && sgn(dot(p.into, q.into)) > 0;
    });
    if (!is_known) half_planes.push_back(std::move(p));
  }

  // On each side the nearest: the first that a half-plane meets which turns about the edge, from the eye to that side.
  const auto nearest = [&](int side) {
    const HalfPlane* best = nullptr;
    for (const HalfPlane& p : half_planes)
      if (p.side == side && (best == nullptr || side * sgn(dot(along, cross(p.into, best->into))) > 0)) best = &p;
    return best;
  };
  const HalfPlane *left = nearest(1), *right = nearest(-1);

  if (edge.diagonal && !edge.of_face) {
    const bool is_outline = (left == nullptr) != (right == nullptr);
    if (is_outline) return ClassVerdict{EdgeClass::outline};
    if (!edge.wire) return std::nullopt;
    return ClassVerdict{EdgeClass::wire};
  }

  ClassVerdict verdict;
  if (half_planes.size() == 1) {
    verdict.edge_class = EdgeClass::boundary;
  } else if ((left == nullptr) != (right == nullptr)) {
    verdict.edge_class = EdgeClass::outline;
  } else if (left != nullptr && right != nullptr && deviates_from_flat(*left, *right, crease, verdict.is_near_crease)) {
    verdict.edge_class = EdgeClass::sharp;
  }
  if (edge.wire && verdict.edge_class == EdgeClass::smooth) verdict.edge_class = EdgeClass::wire;
  return verdict;
}

}  // namespace hsr::oracle
