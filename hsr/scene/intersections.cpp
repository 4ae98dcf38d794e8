#include "hsr/scene/intersections.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>
#include <unordered_set>

#include "geometry/bounded_point.h"
#include "geometry/cancel.h"
#include "geometry/constructed_point.h"
#include "geometry/parallel.h"
#include "geometry/plane_intersection.h"
#include "hsr/scene/facet.h"
#include "hsr/scene/float_triangle.h"
#include "hsr/scene/half_space.h"
#include "hsr/scene/occlusion_pyramid.h"
#include "hsr/scene/repeated_triangles.h"
#include "hsr/symbols/cut_plane.h"

namespace hsr::internal {

namespace {

/// The triangles at their places along the tree, eight to a leaf. What a leaf has no triangle for is not set: its boxes touch nothing.
std::unique_ptr<FloatTriangle[]> along_tree(const ProjectedMesh& projected, const Occluders& occluders) {
  const BoxTree& tree = occluders.tree;
  auto placed = std::make_unique_for_overwrite<FloatTriangle[]>(tree.leaf_count() * BoxTree::width);
  // Looked up at each triangle only where some face has several.
  const Mesh& mesh = projected.mesh();
  bool all_single = true;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    all_single = all_single && mesh.first_triangle[FaceId(f + 1)] - mesh.first_triangle[FaceId(f)] <= 1;
  parallel_for_each(tree.leaf_count(), [&](std::size_t i) {
    const auto leaf = static_cast<std::uint32_t>(i);
    for (std::size_t k = 0; k < tree.leaf_size(leaf); ++k) {
      const TriangleId t = occluders.triangles[tree.box_at(leaf, k)];
      const bool is_single = all_single || triangle_count(mesh, facet_of(mesh, t)) == 1;
      placed[i * BoxTree::width + k] = FloatTriangle(projected, t, is_single);
    }
  });
  return placed;
}

class Finder {
 public:
  Finder(const ProjectedMesh& projected, const Occluders* occluders, const FloatTriangle* placed,
         const OcclusionPyramid* pyramid, const RepeatedTriangles* repeated, std::vector<std::uint8_t>& has_contact)
      : projected_(projected),
        mesh_(projected.mesh()),
        occluders_(occluders),
        placed_(placed),
        pyramid_(pyramid),
        repeated_(repeated),
        exact_(projected.predicates()),
        has_contact_(has_contact) {}

  /// Looks at the triangles of a leaf of the tree, with those that come later.
  void look_around(std::uint32_t leaf, std::vector<TriangleIntersection>& found);
  /// Clips the line in which both planes meet to both triangles. @pre the face of each passes through the other's plane
  std::optional<TriangleIntersection> segment(TriangleId s, TriangleId t);
  const DecisionCounts& decisions() { return exact_.counts(); }

 private:
  PlaneFilter filter(std::uint32_t i) const;
  std::array<Sign, 3> sides(const PlaneFilter& filter, TriangleId s, TriangleId t);
  std::optional<TriangleIntersection> look_at(TriangleId s, const PlaneFilter& of_s, std::uint32_t k);
  std::optional<std::uint64_t> key_of_repeated(TriangleId s, TriangleId t) const;
  /// Long triangles that lie behind one another touch by their boxes and are apart by their planes only, which exact_ tells as
  /// soon.
  bool floats_pay() const { return asked_of_floats_ < 256 || told_by_floats_ * 2 > asked_of_floats_; }
  bool is_apart(const TriangleSeparation& s, const FloatTriangle& t) {
    const bool is_apart = s.is_apart_from(t);
    ++asked_of_floats_;
    told_by_floats_ += is_apart ? 1U : 0U;
    return is_apart;
  }
  bool is_single(TriangleId t) const { return triangle_count(mesh_, facet_of(mesh_, t)) == 1; }
  bool meet_in_an_edge(TriangleId s, const PlaneFilter& filter, TriangleId t) const;
  void mark_contacts(TriangleId flat, TriangleId t, const std::array<Sign, 3>& at);
  void mark_bridges(TriangleId s, TriangleId t);
  bool may_lie_in(VertexId u, VertexId v, TriangleId t);
  bool passes_through(TriangleId t, const std::array<Sign, 3>& at) const;
  bool cross_beyond_common_corner(TriangleId s, TriangleId t);
  std::array<BoundedPoint3, 2> chord(TriangleId t, const std::array<Sign, 3>& at, const PlaneFilter& plane) const;
  bool certainly_no_segment(const std::array<BoundedPoint3, 2>& x, const std::array<BoundedPoint3, 2>& y) const;

  const ProjectedMesh& projected_;
  const Mesh& mesh_;
  const Occluders* occluders_;   // null: only segment() is asked for
  const FloatTriangle* placed_;  // the same triangles along their tree
  const OcclusionPyramid* pyramid_;
  const RepeatedTriangles* repeated_;              // null: as placed_
  std::unordered_set<std::uint64_t> do_not_meet_;  // of repeated triangles
  Predicates exact_;
  std::vector<std::uint8_t>& has_contact_;
  BoxTree::PairSearch search_;
  std::size_t asked_of_floats_ = 0, told_by_floats_ = 0;  // pairs
};

/// The plane of an occluder.
PlaneFilter Finder::filter(std::uint32_t i) const {
  return !occluders_->is_prepared() ? projected_.filter(projected_.face_plane(occluders_->triangles[i]))
                                    : occluders_->face(i).plane;
}

/// On which sides of the plane of s the corners of t are.
std::array<Sign, 3> Finder::sides(const PlaneFilter& filter, TriangleId s, TriangleId t) {
  const auto& d = mesh_.triangles[t];
  std::array<Sign, 3> at;
  for (std::size_t k = 0; k < 3; ++k) {
    const VertexId v = d[k];
    if (mesh_.has_corner(s, v)) {
      at[k] = Sign::zero;
      continue;
    }
    const ErrorBounded x = filter(projected_.point(v));
    at[k] = x.is_certain() ? sign_of(x.value) : exact_.side_beyond_filter(projected_.face_plane(s), projected_.point(v));
  }
  return at;
}

bool straddles(const std::array<Sign, 3>& at) {
  const auto any = [&](Sign s) { return at[0] == s || at[1] == s || at[2] == s; };
  return any(Sign::positive) && any(Sign::negative);
}

void Finder::look_around(std::uint32_t leaf, std::vector<TriangleIntersection>& found) {
  const BoxTree& tree = occluders_->tree;
  const FloatTriangle* const here = placed_ + std::size_t{leaf} * BoxTree::width;
  std::array<std::optional<TriangleSeparation>, BoxTree::width> separation;
  std::size_t turned_to = BoxTree::width;
  PlaneFilter of_s;
  LeafPlane leaf_plane;
  tree.visit_pairs_by_leaf(leaf, search_, [&](std::size_t k, std::uint32_t other, unsigned touching) {
    const FloatTriangle* const there = placed_ + std::size_t{other} * BoxTree::width;
    if (!separation[k]) separation[k].emplace(here[k]);
    const auto turn_to = [&] {
      if (k == turned_to) return;
      turned_to = k;
      of_s = filter(tree.box_at(leaf, k));
      leaf_plane = LeafPlane(of_s);
    };
    if (!floats_pay() && exact_.filter_is_proven()) {
      turn_to();
      touching &= ~occluders_->leaf_corners()[other].beside(leaf_plane);
    }
    for (; touching != 0; touching &= touching - 1) {
      const auto m = static_cast<std::size_t>(__builtin_ctz(touching));
      if (floats_pay() && is_apart(*separation[k], there[m])) continue;
      const std::uint32_t on = tree.box_at(other, m);
      const TriangleId s = occluders_->triangles[tree.box_at(leaf, k)], t = occluders_->triangles[on];
      if (facet_of(mesh_, s) == facet_of(mesh_, t)) {
        mark_bridges(s, t);
        mark_bridges(t, s);
        continue;
      }
      const auto key = key_of_repeated(s, t);
      if (key && do_not_meet_.count(*key) > 0) continue;
      turn_to();
      if (const auto crossing = look_at(s, of_s, on))
        found.push_back(*crossing);
      else if (key)
        do_not_meet_.insert(*key);
    }
  });
}

/// Two triangles with a common side, certainly not in one plane, have no more in common.
bool Finder::meet_in_an_edge(TriangleId s, const PlaneFilter& filter, TriangleId t) const {
  std::size_t common = 0;
  VertexId apex;
  for (const VertexId v : mesh_.triangles[t]) {
    if (mesh_.has_corner(s, v))
      ++common;
    else
      apex = v;
  }
  return common == 2 && filter(projected_.point(apex)).is_certain() && is_single(s) && is_single(t);
}

/// One number for all pairs that have in common what these have; nothing: both triangles are the first of their kind.
std::optional<std::uint64_t> Finder::key_of_repeated(TriangleId s, TriangleId t) const {
  const TriangleId p = repeated_->first(s), q = repeated_->first(t);
  if (p == s && q == t) return std::nullopt;
  return std::uint64_t{std::min(p, q).value} << 32U | std::max(p, q).value;
}

/// What two triangles have in common, and which sides of one lie in the other.
std::optional<TriangleIntersection> Finder::look_at(TriangleId s, const PlaneFilter& of_s, std::uint32_t k) {
  const TriangleId t = occluders_->triangles[k];
  if (meet_in_an_edge(s, of_s, t)) return std::nullopt;
  const std::array<Sign, 3> at_t = sides(of_s, s, t);
  const auto zeros = [](const std::array<Sign, 3>& at) { return std::count(at.begin(), at.end(), Sign::zero); };
  if (!straddles(at_t) && zeros(at_t) < 2) return std::nullopt;  // on one side but for a point
  const PlaneFilter of_t = filter(k);
  const std::array<Sign, 3> at_s = sides(of_t, t, s);
  if (zeros(at_t) >= 2) mark_contacts(s, t, at_t);
  if (zeros(at_s) >= 2) mark_contacts(t, s, at_s);
  if (!passes_through(t, at_t) || !passes_through(s, at_s)) return std::nullopt;
  if (straddles(at_t) && straddles(at_s)) {
    if (!cross_beyond_common_corner(s, t)) return std::nullopt;
    if (certainly_no_segment(chord(s, at_s, of_t), chord(t, at_t, of_s))) return std::nullopt;
  }
  return segment(std::min(s, t), std::max(s, t));
}

/// Marks the sides of t that lie in the plane of `flat` and may overlap it.
void Finder::mark_contacts(TriangleId flat, TriangleId t, const std::array<Sign, 3>& at) {
  const auto& c = mesh_.triangles[t];
  for (std::size_t k = 0; k < 3; ++k) {
    if (at[k] != Sign::zero || at[(k + 1) % 3] != Sign::zero) continue;
    const VertexId u = c[k], v = c[(k + 1) % 3];
    if (mesh_.has_corner(flat, u) && mesh_.has_corner(flat, v) && is_single(flat)) continue;
    if (!may_lie_in(u, v, flat)) continue;
    // A diagonal inside a planar face is no edge of the mesh; an edge of `flat` is no contact with it.
    const EdgeId e = mesh_.find_edge(u, v);
    if (!e.is_valid()) continue;
    const auto own = mesh_.triangles_at(e);
    if (std::find(own.begin(), own.end(), flat) != own.end()) continue;
    std::atomic_ref<std::uint8_t>(has_contact_[e.value]).store(1, std::memory_order_relaxed);
  }
}

/// Marks the sides of t that may run along a side of s, another triangle of its face: a bridge to a hole that the ring of the face
/// runs along twice, cut in other places on the way back.
void Finder::mark_bridges(TriangleId s, TriangleId t) {
  if (triangle_count(mesh_, facet_of(mesh_, t)) < 3) return;
  const auto half_spaces = hsr::internal::half_spaces(projected_, t, exact_);
  const auto &c = mesh_.triangles[t], &d = mesh_.triangles[s];
  for (std::size_t k = 0; k < 3; ++k) {
    const VertexId u = c[k], v = c[(k + 1) % 3];
    const auto on_line = std::count_if(d.begin(), d.end(), [&](VertexId w) {
      return w == u || w == v || projected_.side(half_spaces[k].plane, w, exact_) == Sign::zero;
    });
    if (on_line < 2 || (mesh_.has_corner(s, u) && mesh_.has_corner(s, v))) continue;
    const EdgeId e = mesh_.find_edge(u, v);
    if (e.is_valid()) std::atomic_ref<std::uint8_t>(has_contact_[e.value]).store(1, std::memory_order_relaxed);
  }
}

/// Whether the segment uv, in the plane of t, may have more than a point in common with t.
bool Finder::may_lie_in(VertexId u, VertexId v, TriangleId t) {
  const auto side = [&](const Plane& plane, const Cut& cut, VertexId p) {
    return p.value == cut.u || p.value == cut.v ? Sign::zero : projected_.side(plane, p, exact_);
  };
  const auto half_spaces = hsr::internal::half_spaces(projected_, t, exact_);
  for (const HalfSpace& h : half_spaces) {
    const Sign a = side(h.plane, h.cut, u) * h.inner, b = side(h.plane, h.cut, v) * h.inner;
    if (a != Sign::positive && b != Sign::positive && !(a == Sign::zero && b == Sign::zero)) return false;
  }
  // All of t on one side of the segment, but for a point.
  Cut cut = half_spaces[0].cut;
  cut.u = u.value;
  cut.v = v.value;
  const Plane line = cut_plane(projected_, cut);
  bool positive = false, negative = false;
  int zeros = 0;
  for (const VertexId w : mesh_.triangles[t]) {
    const Sign s = side(line, cut, w);
    zeros += s == Sign::zero ? 1 : 0;
    positive = positive || s == Sign::positive;
    negative = negative || s == Sign::negative;
  }
  return (positive && negative) || zeros >= 2;
}

/// Whether the face of t has points on both sides of a plane around t, t being on the sides `at` of it: where a diagonal lies
/// in the plane the face goes on behind it.
bool Finder::passes_through(TriangleId t, const std::array<Sign, 3>& at) const {
  if (straddles(at)) return true;
  for (std::size_t k = 0; k < 3; ++k)
    if (at[k] == Sign::zero && at[(k + 1) % 3] == Sign::zero && at[(k + 2) % 3] != Sign::zero)
      return is_inner_diagonal(mesh_, t, k);
  return false;
}

/// Two triangles with a common corner v, each with points on both sides of the other's plane, pq and ab their other corners:
/// both cross the line of both planes in a segment that starts at v, and they have more in common iff both run the same way.
/// Where ab crosses the plane of vpq is on q's side of the line vp iff b is on q's side of the plane vpa.
bool Finder::cross_beyond_common_corner(TriangleId s, TriangleId t) {
  const auto &c = mesh_.triangles[s], &d = mesh_.triangles[t];
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      if (c[i] != d[k]) continue;
      const VertexId p = d[(k + 1) % 3], q = d[(k + 2) % 3], a = c[(i + 1) % 3], b = c[(i + 2) % 3];
      const Plane plane = Plane::of_face(projected_.point(c[i]), projected_.point(p), projected_.point(a));
      return projected_.side(plane, b, exact_) * projected_.side(plane, q, exact_) == Sign::positive;
    }
  return true;
}

/// The ends of what a plane cuts of a triangle, nearly. @pre it has corners on both sides: @param at on which sides
std::array<BoundedPoint3, 2> Finder::chord(TriangleId t, const std::array<Sign, 3>& at, const PlaneFilter& plane) const {
  const auto& c = mesh_.triangles[t];
  std::array<BoundedPoint3, 2> ends;
  std::size_t n = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point3 &p = projected_.point(c[k]), &q = projected_.point(c[(k + 1) % 3]);
    if (at[k] == Sign::zero) ends[n++] = {p, 0};
    if (at[k] * at[(k + 1) % 3] != Sign::negative) continue;
    const ErrorBounded x = plane(p), y = plane(q);
    ends[n++] = between(p, q, quotient(x, x - y));
  }
  return ends;
}

/// Of two parts of one line, whether they have certainly nothing in common, or nothing that is not hidden.
bool Finder::certainly_no_segment(const std::array<BoundedPoint3, 2>& x, const std::array<BoundedPoint3, 2>& y) const {
  const auto length = [&](int k) { return std::fabs(x[1].p[k] - x[0].p[k]); };
  int axis = 0;
  for (const int k : {1, 2})
    if (length(k) > length(axis)) axis = k;
  const auto ascending = [&](const std::array<BoundedPoint3, 2>& part) {
    return part[0].p[axis] > part[1].p[axis] ? std::array{&part[1], &part[0]} : std::array{&part[0], &part[1]};
  };
  const auto a = ascending(x), b = ascending(y);
  const auto is_ordered = [&](const std::array<const BoundedPoint3*, 2>& part) {
    return part[1]->p[axis] - part[0]->p[axis] > (part[0]->error + part[1]->error) * 1.01;
  };
  if (!is_ordered(a) || !is_ordered(b)) return false;
  const BoundedPoint3 &low = a[0]->p[axis] > b[0]->p[axis] ? *a[0] : *b[0],
                      &high = a[1]->p[axis] < b[1]->p[axis] ? *a[1] : *b[1];
  if (low.p[axis] - high.p[axis] > (low.error + high.error) * 1.01) return true;
  return pyramid_ != nullptr && pyramid_->hides(low, high);
}

/// A place on the line in which two planes meet, by name.
struct Crossing {
  Cut cut;
  PlaneIntersection::Place place;
};

/// Which comes first: negative, x.
Sign order(const PlaneIntersection& line, const Crossing& x, const Crossing& y) {
  return x.cut == y.cut ? Sign::zero : line.order(x.place, y.place);
}

std::optional<TriangleIntersection> Finder::segment(TriangleId s, TriangleId t) {
  const PlaneIntersection line(projected_.face_plane(s), projected_.face_plane(t), exact_);
  struct Bound {
    HalfSpace h;
    bool goes_on;  // the face does, behind it
  };
  std::array<Bound, 7> bounds;
  std::array<std::size_t, 7> parallel;
  std::size_t n = 0, parallels = 0;
  bool near_cuts = false;
  for (const TriangleId x : {s, t}) {
    const auto half_spaces = hsr::internal::half_spaces(projected_, x, exact_);
    for (std::size_t k = 0; k < 3; ++k) bounds[n++] = {half_spaces[k], is_inner_diagonal(mesh_, x, k)};
    near_cuts = near_cuts || projected_.reaches_before_near(x);
  }
  // What lies in the near plane is left.
  if (near_cuts) bounds[n++] = {{{Cut::Kind::near, 0, 0, 0}, projected_.near_plane(), Sign::positive}, true};
  std::optional<Crossing> low, high;
  for (std::size_t i = 0; i < n; ++i) {
    const HalfSpace& h = bounds[i].h;
    const Crossing here{h.cut, line.place(h.plane)};
    if (here.place.rise == Sign::zero) {
      parallel[parallels++] = i;
    } else if (here.place.rise * h.inner == Sign::positive) {
      if (!low || order(line, *low, here) == Sign::negative) low = here;
    } else {
      if (!high || order(line, here, *high) == Sign::negative) high = here;
    }
    if (low && high && order(line, *low, *high) != Sign::negative) return std::nullopt;
  }
  if (!low || !high) return std::nullopt;
  for (std::size_t i = 0; i < parallels; ++i) {
    const auto& [h, goes_on] = bounds[parallel[i]];
    const Sign at = line.side(h.plane, low->place) * h.inner;
    if (at == Sign::negative || (at == Sign::zero && !goes_on)) return std::nullopt;
  }
  return TriangleIntersection{s, t, low->cut, high->cut};
}

}  // namespace

Intersections find_intersections(const ProjectedMesh& projected, const Occluders& occluders, const OcclusionPyramid* pyramid,
                                 const std::stop_token& stop) {
  Intersections all;
  all.has_contact.resize(projected.mesh().edges.size(), 0);
  constexpr std::size_t block = 64;
  const std::size_t n = occluders.tree.leaf_count();
  const auto placed = along_tree(projected, occluders);
  const RepeatedTriangles repeated(projected.mesh());
  std::vector<std::vector<TriangleIntersection>> parts((n + block - 1) / block);
  std::vector<DecisionCounts> counts(parts.size());
  using Range = tbb::blocked_range<std::size_t>;
  tbb::parallel_for(Range(0, parts.size(), 1), [&](const Range& range) {
    for (std::size_t part = range.begin(); part < range.end(); ++part) {
      throw_if_stopped(stop);
      Finder finder(projected, &occluders, placed.get(), pyramid, &repeated, all.has_contact);
      const std::size_t end = std::min((part + 1) * block, n);
      for (std::size_t leaf = part * block; leaf < end; ++leaf)
        finder.look_around(static_cast<std::uint32_t>(leaf), parts[part]);
      counts[part] = finder.decisions();
    }
  });
  for (std::size_t part = 0; part < parts.size(); ++part) {
    all.segments.insert(all.segments.end(), parts[part].begin(), parts[part].end());
    all.decisions += counts[part];
  }
  std::sort(all.segments.begin(), all.segments.end(), [](const TriangleIntersection& x, const TriangleIntersection& y) {
    return std::pair(x.s, x.t) < std::pair(y.s, y.t);
  });
  return all;
}

MeetingFaces meeting_faces(const Intersections& all) {
  MeetingFaces known{{}, all.has_contact};
  known.pairs.reserve(all.segments.size());
  for (const TriangleIntersection& x : all.segments) known.pairs.push_back({x.s, x.t});
  return known;
}

Intersections intersections_of(const ProjectedMesh& projected, const MeetingFaces& known,
                               const std::vector<std::uint8_t>& left_out, const std::stop_token& stop) {
  Intersections all;
  all.has_contact = known.has_contact;
  constexpr std::size_t block = 256;
  std::vector<std::vector<TriangleIntersection>> parts((known.pairs.size() + block - 1) / block);
  std::vector<DecisionCounts> counts(parts.size());
  const auto is_wanted = [&](TriangleId t) {
    return projected.reaches_beyond_near(t) && (left_out.empty() || left_out[t.value] == 0);
  };
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t part) {
    throw_if_stopped(stop);
    Finder finder(projected, nullptr, nullptr, nullptr, nullptr, all.has_contact);
    for (std::size_t k = part * block; k < std::min((part + 1) * block, known.pairs.size()); ++k) {
      const auto [s, t] = known.pairs[k];
      if (!is_wanted(s) || !is_wanted(t)) continue;
      if (const auto found = finder.segment(s, t)) parts[part].push_back(*found);
    }
    counts[part] = finder.decisions();
  });
  for (std::size_t part = 0; part < parts.size(); ++part) {
    all.segments.insert(all.segments.end(), parts[part].begin(), parts[part].end());
    all.decisions += counts[part];
  }
  return all;
}

namespace {

/// Whether the first place is the lexicographically smaller one.
bool is_ascending(const PlaneIntersection& line, const Crossing& from, const Crossing& to) {
  const auto a = line.bounded_point(from.place), b = line.bounded_point(to.place);
  std::optional<std::array<Rational, 3>> p, q;
  for (std::size_t k = 0; k < 3; ++k) {
    const ErrorBounded gap = b[k] - a[k];
    if (gap.is_certain()) return gap.value > 0;
    if (!p) {
      p = line.exact_point(from.place);
      q = line.exact_point(to.place);
    }
    if ((*p)[k] != (*q)[k]) return (*p)[k] < (*q)[k];
  }
  throw InvariantError("intersections: an empty segment");
}

struct Piece {
  Crossing from, to;
};

/// A piece, running along the line.
Piece piece(const ProjectedMesh& projected, const PlaneIntersection& line, const TriangleIntersection& x) {
  const auto crossing = [&](const Cut& cut) { return Crossing{cut, line.place(cut_plane(projected, cut))}; };
  Piece p{crossing(x.from), crossing(x.to)};
  if (order(line, p.from, p.to) == Sign::positive) std::swap(p.from, p.to);
  return p;
}

void unite(const PlaneIntersection& line, std::vector<Piece>& parts) {
  std::sort(parts.begin(), parts.end(),
            [&](const Piece& x, const Piece& y) { return order(line, x.from, y.from) == Sign::negative; });
  std::size_t last = 0;
  for (std::size_t i = 1; i < parts.size(); ++i) {
    if (order(line, parts[i].from, parts[last].to) == Sign::positive)
      parts[++last] = parts[i];
    else if (order(line, parts[last].to, parts[i].to) == Sign::negative)
      parts[last].to = parts[i].to;
  }
  parts.resize(last + 1);
  if (is_ascending(line, parts[0].from, parts[0].to)) return;
  std::reverse(parts.begin(), parts.end());
  for (Piece& p : parts) std::swap(p.from, p.to);
}

}  // namespace

std::vector<Intersection> merge_segments(const ProjectedMesh& projected, const std::vector<TriangleIntersection>& pieces) {
  const Mesh& mesh = projected.mesh();
  const auto facets = [&](const TriangleIntersection& x) { return std::pair(facet_of(mesh, x.s), facet_of(mesh, x.t)); };
  std::vector<std::uint32_t> order(pieces.size());
  std::iota(order.begin(), order.end(), 0U);
  tbb::parallel_sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t k) {
    return std::pair(facets(pieces[i]), i) < std::pair(facets(pieces[k]), k);
  });
  std::vector<std::size_t> first;  // of each pair of facets
  for (std::size_t i = 0; i < order.size(); ++i)
    if (i == 0 || facets(pieces[order[i]]) != facets(pieces[order[i - 1]])) first.push_back(i);
  first.push_back(order.size());
  return parallel_collect<Intersection>(
      first.size() - 1, [&](std::size_t begin, std::size_t end, std::vector<Intersection>& out) {
        Predicates exact = projected.predicates();
        for (std::size_t g = begin; g < end; ++g) {
          const auto [s, t] = facets(pieces[order[first[g]]]);
          const PlaneIntersection line(projected.face_plane(s), projected.face_plane(t), exact);
          std::vector<Piece> parts;
          for (std::size_t i = first[g]; i < first[g + 1]; ++i) parts.push_back(piece(projected, line, pieces[order[i]]));
          unite(line, parts);
          for (const Piece& p : parts) out.push_back({s, t, p.from.cut, p.to.cut});
        }
      });
}

ImageBox box_of(const ProjectedMesh& projected, const Intersection& meet) {
  const Plane s = projected.face_plane(meet.s), t = projected.face_plane(meet.t);
  ImageBox box = ImageBox::nothing();
  for (const Cut& cut : {meet.from, meet.to}) {
    const auto p = near_meet(s, t, cut_plane(projected, cut));
    const double error = (p[0].error + p[1].error + p[2].error) * 1.01;
    // The triangles' boxes will not do: the segment may run through all of a face.
    if (!(error < HUGE_VAL) || !projected.predicates().filter_is_proven()) return ImageBox::everything();
    box.add(projected.box({p[0].value, p[1].value, p[2].value}, error));
  }
  return box;
}

}  // namespace hsr::internal
