#include "tests/oracle/edge_class_oracle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

#include "tests/oracle/exact_vector.h"

namespace hsr::oracle {

namespace {

// A half-plane that ends at the edge: the direction from the edge, square to it, into a face.
struct HalfPlane {
  Vec into;
  int side;    // of the edge's view plane; 0: seen edge-on
  bool thin;   // the apex is so near to the edge's line, seen from a, that doubles may not find the direction
  FaceId top;  // the face that is on top of those that coincide in it
  std::vector<FaceId> faces;
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
    HalfPlane p{square_to_edge(h), sgn(dot(along_, cross(projected_, h))), false, face, {face}};
    p.thin = dot(p.into, p.into) < Q(0x1p-60) * dot(h, h);
    if (p.side == 0) p.front = sgn(dot(p.into, square_to_edge(projected_))) > 0;
    for (HalfPlane& q : half_planes_) {
      if (!is_zero(cross(p.into, q.into)) || sgn(dot(p.into, q.into)) < 0) continue;
      q.faces.push_back(face);
      q.top = coplanar_ == Coplanar::first ? std::min(q.top, face) : std::max(q.top, face);
      return;
    }
    half_planes_.push_back(std::move(p));
  }

  // The mark of an edge that runs along the part.
  void add_mark(const MarkedEdge& mark) { marks_.push_back(mark); }

  ClassPart verdicts(double crease) const { return verdicts(crease, pointers(), touching() == 'o' ? least() : any); }
  // Of those that are alike, if it is in doubt whether bodies touch.
  ClassPart verdicts_in_doubt(double crease) const { return verdicts(crease, pointers(), least() / 2); }
  // What the numbers of faces tell: 'n' nothing coincides, 'b' bodies touch, 'o' they do not, 'a' all are alike.
  char touching() const;
  // With those in which bodies touch only on top.
  ClassPart verdicts_on_top(double crease) const { return verdicts(crease, pointers(), least()); }
  // Without the half-planes in which bodies touch.
  ClassPart verdicts_of_surfaces(double crease) const { return verdicts(crease, surfaces(), any); }
  // The faces that coincide in half-planes that are no surfaces of bodies that touch; where it is open, those that end there.
  std::vector<std::vector<FaceId>> sets() const;

 private:
  using Pointers = std::vector<const HalfPlane*>;
  Pointers pointers() const {
    Pointers all;
    for (const HalfPlane& p : half_planes_) all.push_back(&p);
    return all;
  }
  Pointers surfaces() const;
  bool is_before(const HalfPlane& x, const HalfPlane& y) const;
  static constexpr std::size_t any = static_cast<std::size_t>(-1);
  std::size_t least() const;
  bool goes_on(const HalfPlane& p) const;
  // Half-planes with more faces than `surface` count only on top.
  ClassPart verdicts(double crease, const Pointers& all, std::size_t surface) const;

  Vec square_to_edge(const Vec& h) const { return h - Q(dot(h, along_) / dot(along_, along_)) * along_; }
  // How far a half-plane is turned from the eye to its side, for comparison: whether x is turned less than y.
  bool is_nearer(const HalfPlane& x, const HalfPlane& y) const { return x.side * sgn(dot(along_, cross(x.into, y.into))) > 0; }
  // Intersection or sharp, or nothing.
  std::optional<ClassVerdict> bent(const Pointers& all, const HalfPlane& left, const HalfPlane& right, const HalfPlane* edge_on,
                                   double crease) const;
  // Whether some face in the half-plane satisfies the condition.
  template <class Condition>
  static bool has_face(const HalfPlane& p, const Condition& condition) {
    return std::any_of(p.faces.begin(), p.faces.end(), condition);
  }
  std::optional<EdgeMark> mark_between(const HalfPlane& left, const HalfPlane& right) const;
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
  std::vector<MarkedEdge> marks_;
};

std::optional<EdgeMark> ClassAt::mark_between(const HalfPlane& left, const HalfPlane& right) const {
  const auto holds = [&](EdgeMark mark) {
    return std::any_of(marks_.begin(), marks_.end(), [&](const MarkedEdge& m) {
      const auto is_of_object = [&](FaceId f) { return labels_.object.empty() || labels_.object[f.value] == m.object; };
      return m.mark == mark && has_face(left, is_of_object) && has_face(right, is_of_object);
    });
  };
  for (const EdgeMark mark : {EdgeMark::sharp, EdgeMark::smooth, EdgeMark::inner})
    if (holds(mark)) return mark;
  if (labels_.surface.empty()) return std::nullopt;
  const bool is_one_surface = has_face(left, [&](FaceId f) {
    return labels_.surface[f.value] != FaceLabels::none &&
           has_face(right, [&](FaceId g) { return labels_.surface[g.value] == labels_.surface[f.value]; });
  });
  return is_one_surface ? std::optional(EdgeMark::inner) : std::nullopt;
}

std::size_t ClassAt::least() const {
  std::size_t least = any;
  for (const HalfPlane& p : half_planes_) least = std::min(least, p.faces.size());
  return least;
}

ClassAt::Pointers ClassAt::surfaces() const {
  Pointers all;
  for (const HalfPlane& p : half_planes_)
    if (p.faces.size() == least()) all.push_back(&p);
  return all;
}

// Whether as many faces or more are opposite.
bool ClassAt::goes_on(const HalfPlane& p) const {
  return std::any_of(half_planes_.begin(), half_planes_.end(), [&](const HalfPlane& q) {
    return q.faces.size() >= p.faces.size() && is_zero(cross(p.into, q.into)) && sgn(dot(p.into, q.into)) < 0;
  });
}

// Counter-clockwise around the edge from the first half-plane.
bool ClassAt::is_before(const HalfPlane& x, const HalfPlane& y) const {
  const Vec& zero = half_planes_.front().into;
  const auto half = [&](const HalfPlane& p) {
    const int s = sgn(dot(along_, cross(zero, p.into)));
    return s > 0 || (s == 0 && sgn(dot(zero, p.into)) > 0) ? 0 : 1;
  };
  if (half(x) != half(y)) return half(x) < half(y);
  return sgn(dot(along_, cross(x.into, y.into))) > 0;
}

char ClassAt::touching() const {
  if (half_planes_.empty()) return 'n';
  const Pointers of_bodies = surfaces();
  bool coincide = false;
  for (const HalfPlane& p : half_planes_) coincide = coincide || p.faces.size() > 1;
  if (!coincide) return 'n';
  if (of_bodies.size() == half_planes_.size()) return of_bodies.size() > 1 ? 'a' : 'o';
  if (of_bodies.size() % 2 == 1) return 'o';
  // The surfaces have an inside and an outside in turn: all others are in the one or the other.
  std::array<bool, 2> touch = {false, false};
  for (const HalfPlane& p : half_planes_) {
    if (std::find(of_bodies.begin(), of_bodies.end(), &p) != of_bodies.end()) continue;
    const auto before = std::count_if(of_bodies.begin(), of_bodies.end(), [&](const auto* s) { return is_before(*s, p); });
    touch[static_cast<std::size_t>(before % 2)] = true;
  }
  return touch[0] && touch[1] ? 'o' : 'b';
}

std::vector<std::vector<FaceId>> ClassAt::sets() const {
  const Pointers of_bodies = surfaces();
  std::vector<std::vector<FaceId>> all;
  for (const HalfPlane& p : half_planes_) {
    const bool is_surface = std::find(of_bodies.begin(), of_bodies.end(), &p) != of_bodies.end();
    if (p.faces.size() < 2 || (touching() == 'b' && is_surface) || (touching() == 'o' && goes_on(p))) continue;
    all.push_back(p.faces);
    std::sort(all.back().begin(), all.back().end());
  }
  return all;
}

std::optional<ClassVerdict> ClassAt::bent(const Pointers& all, const HalfPlane& left, const HalfPlane& right,
                                          const HalfPlane* edge_on, double crease) const {
  const auto pierced = [&](const HalfPlane& x) {
    const Vec normal = cross(along_, x.into);
    bool opposite = false, above = false, below = false;
    for (const HalfPlane* p : touching() == 'b' ? surfaces() : all) {
      const int s = sgn(dot(normal, p->into));
      opposite = opposite || (s == 0 && sgn(dot(x.into, p->into)) < 0);
      above = above || s > 0;
      below = below || s < 0;
    }
    return opposite && above && below;
  };
  const auto mark = mark_between(left, right);
  if (is_zero(cross(left.into, right.into)) && edge_on == nullptr)
    return mark == EdgeMark::sharp ? std::optional(ClassVerdict{EdgeClass::sharp}) : std::nullopt;
  if (pierced(left) || pierced(right) || (edge_on != nullptr && pierced(*edge_on)))
    return ClassVerdict{EdgeClass::intersection};
  if (edge_on != nullptr || mark == EdgeMark::sharp) return ClassVerdict{EdgeClass::sharp};
  if (mark) return std::nullopt;
  ClassVerdict verdict;
  if (deviates_from_flat(left, right, crease, verdict.is_near_crease)) verdict.edge_class = EdgeClass::sharp;
  if (verdict.edge_class != EdgeClass::sharp && !verdict.is_near_crease) return std::nullopt;
  return verdict;
}

ClassPart ClassAt::verdicts(double crease, const Pointers& all, std::size_t surface) const {
  std::array<std::vector<const HalfPlane*>, 2> sides;  // left and right, those that count
  const HalfPlane *front = nullptr, *back = nullptr;
  bool has_side[2] = {false, false};
  for (const HalfPlane* p : all) {
    if (p->side != 0) has_side[p->side > 0 ? 0 : 1] = true;
    if (p->side != 0) sides[p->side > 0 ? 0 : 1].push_back(p);
    if (p->side == 0 && p->faces.size() <= surface) (p->front ? front : back) = p;
  }
  const auto as = [](EdgeClass c) { return ClassPart{{}, ClassVerdict{c}}; };
  const bool only_diagonal = edge_.diagonal && !edge_.of_face, one_side = has_side[0] != has_side[1];
  ClassPart part{{}, std::nullopt};
  if (only_diagonal && one_side) {
    part = as(EdgeClass::outline);
  } else if (only_diagonal) {
  } else if (all.size() == 1) {
    part = as(EdgeClass::boundary);
  } else if (one_side) {
    part = as(EdgeClass::outline);
  } else if (!has_side[0]) {
    const bool is_inner =
        half_planes_.size() == 2 && mark_between(half_planes_.front(), half_planes_.back()) == EdgeMark::inner;
    if (!is_inner) part = as(EdgeClass::smooth);
  } else {
    for (auto& side : sides)
      std::sort(side.begin(), side.end(), [&](const HalfPlane* x, const HalfPlane* y) { return is_nearer(*x, *y); });
    for (auto& side : sides)
      while (side.size() > 1 && side.back()->faces.size() > surface) side.pop_back();
    part.verdict = bent(all, *sides[0].front(), *sides[1].front(), front, crease);
    const EdgeClass else_class = flat(sides[0].front()->top, sides[1].front()->top);
    const bool is_flat = !part.verdict || part.verdict->edge_class == EdgeClass::smooth;
    if (is_flat) part.behind = bent(all, *sides[0].back(), *sides[1].back(), back, crease);
    const bool is_near = part.verdict && part.verdict->is_near_crease;
    const bool is_inner = mark_between(*sides[0].front(), *sides[1].front()) == EdgeMark::inner;
    if (is_flat && is_inner)
      part.verdict.reset();
    else if (is_flat)
      part.verdict = ClassVerdict{else_class, is_near};
    if (part.verdict) part.verdict->flat = else_class;
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

// Where an edge passes through triangles, from one side to the other: there it may lead into a body, or out of one.
std::vector<Q> passages(const Mesh& mesh, EdgeId id) {
  const Vec a(mesh.points[mesh.edges[id].a]), b(mesh.points[mesh.edges[id].b]);
  std::vector<Q> all;
  for (const auto& t : mesh.triangles) {
    const std::array<Vec, 3> corners = {Vec(mesh.points[t[0]]), Vec(mesh.points[t[1]]), Vec(mesh.points[t[2]])};
    const Vec normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    const Q height_a = dot(normal, a - corners[0]), height_b = dot(normal, b - corners[0]);
    if (sgn(height_a) * sgn(height_b) >= 0) continue;
    const Q at = height_a / (height_a - height_b);
    const Vec p = a + at * (b - a);
    bool is_inside = true;
    for (std::size_t k = 0; k < 3; ++k)
      is_inside = is_inside && sgn(dot(cross(normal, corners[(k + 1) % 3] - corners[k]), p - corners[k])) >= 0;
    if (is_inside) all.push_back(at);
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

namespace {

// A part with what the faces that coincide there tell.
struct RawPart : ClassPart {
  char touching = 'n';
  std::vector<std::vector<FaceId>> sets;
  std::optional<ClassVerdict> in_doubt = {};
};

std::vector<RawPart> raw_parts(const Mesh& mesh, const std::vector<MarkedEdge>& marks, EdgeId id, const ClassAt& empty,
                               double crease, const std::optional<Interval>& beyond) {
  const auto is_side = [&](const MarkedEdge& m, VertexId u, VertexId v) {
    return std::minmax(mesh.merged[VertexId(m.points[0])], mesh.merged[VertexId(m.points[1])]) == std::minmax(u, v);
  };
  if (!beyond) {
    ClassAt own = empty;
    for (const TriangleId t : mesh.triangles_at(id)) own.add(Vec(mesh.points[mesh.apex(t, mesh.edges[id])]), mesh.face_of[t]);
    for (const MarkedEdge& m : marks)
      if (is_side(m, mesh.edges[id].a, mesh.edges[id].b)) own.add_mark(m);
    RawPart part{own.verdicts(crease), 'n', {}, {}};
    part.part = {0, 1};
    part.behind.reset();
    return {part};
  }
  // A wire stays one in any face.
  if (mesh.triangles_at(id).empty()) return {{{*beyond, ClassVerdict{EdgeClass::wire}}, 'n', {}, {}}};
  const std::vector<Around> around = triangles_around(mesh, id);
  std::vector<Q> cuts = {beyond->from, beyond->to};
  for (const Around& x : around)
    for (std::size_t k = 0; k < 3; ++k)
      if (x.at_a[k] != x.at_b[k]) {
        const Q t = x.at_a[k] / (x.at_a[k] - x.at_b[k]);
        if (t > beyond->from && t < beyond->to) cuts.push_back(t);
      }
  for (const Q& t : passages(mesh, id))
    if (t > beyond->from && t < beyond->to) cuts.push_back(t);
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  const Vec a(mesh.points[mesh.edges[id].a]), b(mesh.points[mesh.edges[id].b]);
  std::vector<RawPart> parts;
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
      const auto& v = mesh.triangles[x.triangle];
      for (const MarkedEdge& m : marks)
        if (along < 3 && is_side(m, v[along], v[(along + 1) % 3])) here.add_mark(m);
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
    RawPart found{here.verdicts(crease), here.touching(), here.sets(), {}};
    found.part = {cuts[i], cuts[i + 1]};
    if (found.touching == 'a') found.in_doubt = here.verdicts_in_doubt(crease).verdict;
    if (found.touching == 'b') {
      const ClassPart of_surfaces = here.verdicts_of_surfaces(crease);
      found.behind = of_surfaces.behind;
      // Where what is flat is seen no bodies touch on top.
      const auto is = [&](EdgeClass c) { return found.verdict && found.verdict->edge_class == c; };
      const bool is_flat = is(EdgeClass::smooth) || is(EdgeClass::joint) || is(EdgeClass::material) || is(EdgeClass::wire);
      if (is_flat || (found.verdict && found.verdict->is_near_crease)) found.behind_seen = here.verdicts_on_top(crease).behind;
      found.hidden = of_surfaces.verdict ? *of_surfaces.verdict : ClassVerdict{EdgeClass::smooth};
    }
    parts.push_back(std::move(found));
  }
  return parts;
}

// How many triangles a ray crosses; nothing: it touches the border of one.
std::optional<std::size_t> crossed(const Mesh& mesh, const Vec& from, const Vec& along) {
  std::size_t count = 0;
  for (const auto& t : mesh.triangles) {
    const Vec a(mesh.points[t[0]]), b(mesh.points[t[1]]), c(mesh.points[t[2]]);
    const Vec normal = cross(b - a, c - a);
    const Q rise = dot(normal, along), height = dot(normal, a - from);
    if (sgn(height) == 0 && sgn(rise) != 0) continue;
    if (sgn(rise) == 0) {
      if (sgn(height) == 0) return std::nullopt;
      continue;
    }
    const Q at = height / rise;
    if (sgn(at) < 0) continue;
    const Vec p = from + at * along;
    int least = 1;
    for (const auto& [u, v] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
      least = std::min(least, sgn(dot(normal, cross(v - u, p - u))));
    if (least == 0) return std::nullopt;
    if (least > 0) ++count;
  }
  return count;
}

std::optional<std::size_t> crossed(const Mesh& mesh, const Vec& from, int axis, int step) {
  for (const double slant : {0x1p-7, 0x1.8p-6, 0x1.4p-5, 0x1.cp-8}) {
    std::array<Q, 3> along;
    along[static_cast<std::size_t>(axis)] = step;
    along[static_cast<std::size_t>((axis + 1) % 3)] = slant;
    along[static_cast<std::size_t>((axis + 2) % 3)] = slant * 0.64;
    if (const auto count = crossed(mesh, from, Vec(along[0], along[1], along[2]))) return count;
  }
  return std::nullopt;
}

// Whether by each of six rays an odd number of faces, each stored so many times, is between a point and the eye.
bool is_inside(const Mesh& mesh, const View& view, const Vec& p, std::size_t copies) {
  for (int axis = 0; axis < 3; ++axis)
    for (const int step : {-1, 1}) {
      const auto here = crossed(mesh, p, axis, step);
      const auto at_eye =
          view.is_perspective() ? crossed(mesh, Vec(view.viewpoint.at), axis, step) : std::optional<std::size_t>(0);
      if (!here || !at_eye || (*here + *at_eye) % copies != 0 || (*here + *at_eye) / copies % 2 == 0) return false;
    }
  return true;
}

// Bodies touch all around these parts: by painting what leads to one another, from where they do and where one ends in the open.
void decide_alike(const Mesh& mesh, const View& view, std::vector<std::vector<RawPart>>& of_edges) {
  using Set = std::vector<FaceId>;
  std::set<Set> touch, open;
  for (const auto& parts : of_edges)
    for (const RawPart& p : parts)
      for (const Set& s : p.sets) {
        if (p.touching == 'b') touch.insert(s);
        if (p.touching == 'o') open.insert(s);
      }
  for (std::set<Set>* painted : {&touch, &open})
    for (bool is_more = true; is_more;) {
      is_more = false;
      for (const auto& parts : of_edges)
        for (const RawPart& p : parts) {
          if (p.touching != 'a') continue;
          const bool is_painted =
              std::any_of(p.sets.begin(), p.sets.end(), [&](const Set& s) { return painted->count(s) > 0; });
          if (!is_painted) continue;
          for (const Set& s : p.sets) is_more = painted->insert(s).second || is_more;
        }
    }
  for (std::size_t e = 0; e < of_edges.size(); ++e)
    for (RawPart& p : of_edges[e]) {
      if (p.touching != 'a' || touch.count(p.sets.front()) == 0) continue;
      const Vec a(mesh.points[mesh.edges[EdgeId(e)].a]), b(mesh.points[mesh.edges[EdgeId(e)].b]);
      const Vec middle = a + Q((p.part.from + p.part.to) / 2) * (b - a);
      const std::size_t faces = p.sets.front().size();
      p.behind.reset();
      if (open.count(p.sets.front()) == 0 && faces % 2 == 0 && is_inside(mesh, view, middle, faces / 2))
        p.hidden = ClassVerdict{EdgeClass::smooth};
      else
        p.verdict = p.in_doubt;
    }
}

bool is_one(const ClassPart& x, const ClassPart& y) {
  return x.verdict == y.verdict && x.behind == y.behind && x.hidden == y.hidden && x.behind_seen == y.behind_seen;
}

}  // namespace

std::vector<std::vector<ClassPart>> class_parts(const Mesh& mesh, const View& view, const FaceLabels& labels, Coplanar coplanar,
                                                double crease, const std::vector<std::optional<Interval>>& beyond) {
  std::vector<std::vector<RawPart>> raw;
  for (std::size_t e = 0; e < mesh.edges.size(); ++e)
    raw.push_back(
        raw_parts(mesh, labels.marks, EdgeId(e), ClassAt(mesh, view, labels, coplanar, EdgeId(e)), crease, beyond[e]));
  decide_alike(mesh, view, raw);
  std::vector<std::vector<ClassPart>> all;
  for (std::size_t e = 0; e < raw.size(); ++e) {
    std::vector<ClassPart>& parts = all.emplace_back();
    for (RawPart& found : raw[e]) {
      if (mesh.edges[EdgeId(e)].wire && found.hidden &&
          (found.hidden->edge_class == EdgeClass::smooth || found.hidden->edge_class == EdgeClass::joint))
        found.hidden->edge_class = EdgeClass::wire;
      if (found.hidden && found.verdict && *found.hidden == *found.verdict) found.hidden.reset();
      if (!found.verdict) found.hidden.reset();
      if (!found.behind_seen) found.behind_seen = found.behind;
      if (!parts.empty() && is_one(parts.back(), found)) {
        parts.back().part.to = found.part.to;
        if (found.verdict && found.verdict->is_near_crease) parts.back().verdict->is_near_crease = true;
      } else {
        parts.push_back(std::move(found));
      }
    }
  }
  return all;
}

}  // namespace hsr::oracle
