#include "tests/oracle/intersections_oracle.h"

#include <algorithm>
#include <array>
#include <optional>

#include "tests/oracle/edge_class_oracle.h"

namespace hsr::oracle {

namespace {

struct Corner {
  Vec p, inward;   // of the side that begins there
  bool is_within;  // that side is a diagonal within a planar face
};

struct Piece {
  FacetId facet;
  Vec normal;
  std::vector<std::array<Corner, 3>> triangles;

  // 0 where the point, which is in its plane, is on the border or outside.
  bool contains_inside(const Vec& p) const {
    return std::any_of(triangles.begin(), triangles.end(), [&](const auto& t) {
      return std::all_of(t.begin(), t.end(), [&](const Corner& c) {
        const int inside = sgn(dot(c.inward, p - c.p));
        return inside > 0 || (inside == 0 && c.is_within);
      });
    });
  }
};

std::vector<Piece> pieces_of(const Mesh& mesh) {
  std::vector<Piece> all;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const TriangleId t(i);
    const FaceId f = mesh.face_of[t];
    std::array<Vec, 3> c;
    for (std::size_t k = 0; k < 3; ++k) c[k] = Vec(mesh.points[mesh.triangles[t][k]]);
    const Vec normal = cross(c[1] - c[0], c[2] - c[0]);
    const bool goes_on =
        !all.empty() && mesh.face_of[first_triangle(all.back().facet)] == f && mesh.faces[f] == FaceUse::planar;
    if (!goes_on) all.push_back({FacetId(i), normal, {}});
    std::array<Corner, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = {c[k], cross(normal, c[(k + 1) % 3] - c[k]), is_within_face(mesh, t, k)};
    all.back().triangles.push_back(corners);
  }
  return all;
}

void add_piercings(const Piece& s, const Piece& t, const View& view, std::vector<Piercing>& out) {
  const Vec d = cross(s.normal, t.normal);
  if (is_zero(d)) return;
  const Q hs = dot(s.normal, s.triangles[0][0].p), ht = dot(t.normal, t.triangles[0][0].p), dd = dot(d, d);
  const Vec o = Q(hs / dd) * cross(t.normal, d) + Q(ht / dd) * cross(d, s.normal);
  std::vector<Q> cuts;
  const auto cut = [&](const Vec& normal, const Q& at_o) {
    const Q rise = dot(normal, d);
    if (sgn(rise) != 0) cuts.emplace_back(-at_o / rise);
  };
  for (const Piece* piece : {&s, &t})
    for (const auto& triangle : piece->triangles)
      for (const Corner& c : triangle) cut(c.inward, dot(c.inward, o - c.p));
  // The near plane, or the section in its place: axis . (p - at) = near.
  const Vec at = view.section ? Vec(view.section->point) : Vec(view.viewpoint.at);
  const Vec axis = view.section ? Vec(view.section->normal) : Vec(view.target) - at;
  const Q near = view.section ? Q(0) : Q(Q(view.near) * dot(axis, axis));
  if (view.cuts()) cut(axis, dot(axis, o - at) - near);
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  std::vector<std::array<Q, 2>> parts;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const Q middle = (cuts[i] + cuts[i + 1]) / 2;
    const Vec p = o + middle * d;
    if (view.cuts() && dot(axis, p - at) < near) continue;
    if (!s.contains_inside(p) || !t.contains_inside(p)) continue;
    if (!parts.empty() && parts.back()[1] == cuts[i])
      parts.back()[1] = cuts[i + 1];
    else
      parts.push_back({cuts[i], cuts[i + 1]});
  }
  const auto less = [](const Vec& a, const Vec& b) {
    for (int k = 0; k < 3; ++k)
      if (a[k] != b[k]) return a[k] < b[k];
    return false;
  };
  std::vector<Piercing> found;
  for (const auto& [from, to] : parts) {
    Piercing x{s.facet, t.facet, o + from * d, o + to * d};
    if (less(x.to, x.from)) std::swap(x.from, x.to);
    found.push_back(std::move(x));
  }
  std::sort(found.begin(), found.end(), [&](const Piercing& x, const Piercing& y) { return less(x.from, y.from); });
  out.insert(out.end(), found.begin(), found.end());
}

}  // namespace

std::vector<Piercing> piercings(const Mesh& mesh, const View& view) {
  const std::vector<Piece> pieces = pieces_of(mesh);
  std::vector<Piercing> all;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (std::size_t k = i + 1; k < pieces.size(); ++k) add_piercings(pieces[i], pieces[k], view, all);
  return all;
}

}  // namespace hsr::oracle
