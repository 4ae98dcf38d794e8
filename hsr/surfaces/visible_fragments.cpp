#include "hsr/surfaces/visible_fragments.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/cancel.h"
#include "geometry/parallel.h"
#include "hsr/lines/appel.h"
#include "hsr/lines/behind_caps.h"
#include "hsr/lines/classified_edges.h"
#include "hsr/lines/roberts.h"
#include "hsr/scene/facet.h"
#include "hsr/scene/segment_filter.h"
#include "hsr/scene/view_parts.h"
#include "hsr/surfaces/cap_arrangement.h"
#include "hsr/surfaces/fragment_invariants.h"
#include "hsr/surfaces/fragment_parts.h"
#include "hsr/surfaces/line_envelope.h"
#include "hsr/symbols/constructions.h"
#include "hsr/symbols/cut_plane.h"

namespace hsr {

using namespace internal;

namespace {

using Range = tbb::blocked_range<std::size_t>;

/// Sides of fragments, and of which facet each is.
struct FacetSides {
  std::vector<FacetId> facets;
  std::vector<PlacedSide> sides;

  void add(FacetId facet, const PlacedSide& side) {
    facets.push_back(facet);
    sides.push_back(side);
  }
};

/// Collects the sides along the lines of the map. One object per block of lines.
class SideFinder {
 public:
  /// @param place of each triangle among the prepared ones @param pyramid what is known to be hidden, or nullptr
  /// @param caps of a section, or nullptr
  SideFinder(const ProjectedMesh& projected, const Occluders& occluders, const Intersections& intersections,
             const std::vector<std::uint32_t>& place, const OcclusionPyramid* pyramid, const SectionCaps* caps)
      : projected_(projected),
        caps_(caps),
        mesh_(projected.mesh()),
        occluders_(occluders),
        intersections_(intersections),
        place_(place),
        map_(projected),
        left_(map_, occluders, pyramid),
        right_(map_, occluders, pyramid) {}

  void add_edge(const VisibleLines& lines, const Line& line);
  void add_intersection(const TriangleIntersection& crossing);
  void add_near_cut(TriangleId t);
  void add_cap_border(const CapArrangement& caps, const CapRun& run);

  FacetSides take() { return std::move(sides_); }
  const DecisionCounts& decisions() { return map_.exact().counts(); }

 private:
  /// The triangle that the edge has on a side, if it is the only one and nothing else touches the edge there; invalid
  /// otherwise.
  TriangleId only_triangle(EdgeId e, Sign side) const;
  std::vector<MapStretch> outside_caps(const MapStretch& stretch, TriangleId beside);
  BoundedPoint3 scaled_point(const RationalVector& given) const;
  MapPoint point_at(const Edge& edge, TriangleId beside, const Cut& cut) const;
  BoundedPoint3 place_of(const Edge& edge, const Cut& cut) const;
  BoundedPoint3 end_of(const TriangleIntersection& crossing, const Cut& cut, const MapPoint& seen) const;
  void add(MapStretch stretch, TriangleId left, TriangleId right);
  Sign runs_along(const TriangleIntersection& crossing, const MapStretch& stretch);
  void add_meeting(const MapStretch& stretch, std::span<const SeenPart> left);
  void add_different(const MapStretch& stretch, std::span<const SeenPart> left, std::span<const SeenPart> right);
  MapPlace place(const MapStretch& stretch, const MapPoint& p, double t, double error) const;

  const ProjectedMesh& projected_;
  const SectionCaps* caps_;
  const Mesh& mesh_;
  const Occluders& occluders_;
  const Intersections& intersections_;
  const std::vector<std::uint32_t>& place_;
  MapPredicates map_;
  LineEnvelope left_, right_;
  FacetSides sides_;
};

TriangleId SideFinder::only_triangle(EdgeId e, Sign side) const {
  if (intersections_.has_contact[e.value] != 0) return {};
  const Edge& edge = mesh_.edges[e];
  // In the near plane: the triangle may be on the side that is cut away.
  if (projected_.beyond_near(edge.a) == Sign::zero && projected_.beyond_near(edge.b) == Sign::zero) return {};
  TriangleId only;
  for (const TriangleId t : mesh_.triangles_at(e)) {
    if (projected_.side_of_edge(t, edge) != side) continue;
    if (only.is_valid()) return {};
    only = t;
  }
  return only;
}

MapPoint SideFinder::point_at(const Edge& edge, TriangleId beside, const Cut& cut) const {
  const MapLine line = MapLine::edge(edge.a, edge.b);
  switch (cut.kind) {
    case Cut::Kind::start:
      return MapPoint::of_vertex(edge.a);
    case Cut::Kind::end:
      return MapPoint::of_vertex(edge.b);
    case Cut::Kind::sight:
      return MapPoint::crossing(line, MapLine::edge(VertexId(cut.u), VertexId(cut.v)));
    case Cut::Kind::face:
      return MapPoint::crossing(line, MapLine::meet(TriangleId(cut.u), beside));
    case Cut::Kind::near:
      return MapPoint::crossing(line, MapLine::near(beside));
    case Cut::Kind::near_line:
      return MapPoint::crossing(line, MapLine::near(TriangleId(cut.u)));
    case Cut::Kind::line:
    case Cut::Kind::across:
    case Cut::Kind::sight_of_vertex:
    case Cut::Kind::near_line_end:
      break;
  }
  throw InvariantError("visible_fragments: an edge cut within an edge-on plane, where no edge-on face was looked at");
}

void SideFinder::add_edge(const VisibleLines& lines, const Line& line) {
  const Edge& edge = mesh_.edges[line.edge];
  const TriangleId left = only_triangle(line.edge, Sign::positive), right = only_triangle(line.edge, Sign::negative);
  if (left.is_valid() && right.is_valid() && facet_of(mesh_, left) == facet_of(mesh_, right)) return;
  TriangleId beside;
  for (const TriangleId t : mesh_.triangles_at(line.edge))
    if (!beside.is_valid() && projected_.facing(t) != Sign::zero) beside = t;
  const auto cuts = lines.cuts_of(line);
  MapStretch stretch;
  stretch.line = MapLine::edge(edge.a, edge.b);
  stretch.is_visible = true;
  for (std::uint32_t k = 0; k < line.intervals(); ++k) {
    if (line.hidden(k)) continue;
    const Cut &from = cuts[k], &to = cuts[k + 1];
    stretch.from = point_at(edge, beside, from);
    stretch.to = point_at(edge, beside, to);
    stretch.at_a = from.kind == Cut::Kind::start ? edge.a : VertexId();
    stretch.at_b = to.kind == Cut::Kind::end ? edge.b : VertexId();
    stretch.a = place_of(edge, from);
    stretch.b = place_of(edge, to);
    add(stretch, left, right);
  }
}

void SideFinder::add_intersection(const TriangleIntersection& crossing) {
  const MapLine line = MapLine::meet(crossing.s, crossing.t);
  const auto point = [&](const Cut& cut) {
    const bool is_near = cut.kind == Cut::Kind::near;
    return MapPoint::crossing(line, is_near ? MapLine::near(crossing.s) : MapLine::edge(VertexId(cut.u), VertexId(cut.v)));
  };
  const MapPoint from = point(crossing.from), to = point(crossing.to);
  MapStretch stretch{line, from, to, end_of(crossing, crossing.from, from), end_of(crossing, crossing.to, to)};
  if (runs_along(crossing, stretch) == Sign::negative) {
    std::swap(stretch.from, stretch.to);
    std::swap(stretch.a, stretch.b);
  }
  if (caps_ != nullptr) {
    for (const MapStretch& part : outside_caps(stretch, crossing.s)) add(part, {}, {});
    return;
  }
  if (!occluders_.is_prepared()) {
    add(stretch, {}, {});
    return;
  }
  stretch.first = {&occluders_.faces()[place_[crossing.s.value]], &occluders_.faces()[place_[crossing.t.value]]};
  const LineEnvelope::EnvelopePair meeting = left_.both_sides(stretch);
  if (meeting.is_for_both)
    add_meeting(stretch, meeting.left);
  else
    add(stretch, {}, {});
}

/// Whether the ends of an intersection are in the order of its line, along its image. Where a corner of s is before the plane
/// of t, MapPredicates::nearer(s, t) tells on which side of the line it is seen: to the left iff facing(s) t(corner) > 0.
Sign SideFinder::runs_along(const TriangleIntersection& crossing, const MapStretch& stretch) {
  const BoundedPoint2 a = projected_.image(stretch.a.p, 3 * stretch.a.error),
                      b = projected_.image(stretch.b.p, 3 * stretch.b.error);
  const SegmentFilter image(a.p, b.p, std::max({a.error, b.error, projected_.image_error()}));
  const PlaneFilter plane = projected_.filter(projected_.face_plane(crossing.t));
  for (const VertexId v : mesh_.triangles[crossing.s]) {
    const ErrorBounded at_v = plane(projected_.point(v));
    if (!at_v.is_certain() || !(projected_.image_error() < HUGE_VAL)) continue;
    const ErrorBounded turn = image.turn(projected_.image(v));
    if (turn.is_certain()) return sign_of(at_v.value) * sign_of(turn.value) * projected_.facing(crossing.s);
  }
  return -map_.order(stretch.line, stretch.from, stretch.to);
}

/// Of the two faces that meet, what is seen to the left ends where the other one begins.
void SideFinder::add_meeting(const MapStretch& stretch, std::span<const SeenPart> left) {
  const TriangleId s = stretch.first[0]->triangle, t = stretch.first[1]->triangle;
  double from_t = 0, from_error = 0;
  for (const SeenPart& part : left) {
    if (part.seen == s || part.seen == t) {
      const MapPlace from = place(stretch, part.from, from_t, from_error),
                     to = place(stretch, part.to, part.to_t, part.to_error);
      const FacetId l = facet_of(mesh_, part.seen), r = facet_of(mesh_, part.seen == s ? t : s);
      sides_.add(l, {{stretch.line, false, part.from, part.to}, from, to});
      sides_.add(r, {{stretch.line, true, part.to, part.from}, to, from});
    }
    from_t = part.to_t;
    from_error = part.to_error;
  }
}

/// Where an intersection ends in space: where an edge of one triangle meets the plane of the other. @param seen where
BoundedPoint3 SideFinder::end_of(const TriangleIntersection& crossing, const Cut& cut, const MapPoint& seen) const {
  if (cut.kind == Cut::Kind::sight) {
    const VertexId u(cut.u), v(cut.v);
    const TriangleId other = mesh_.has_corner(crossing.s, u) && mesh_.has_corner(crossing.s, v) ? crossing.t : crossing.s;
    const PlaneFilter plane = projected_.filter(projected_.face_plane(other));
    const auto value = [&](VertexId x) { return mesh_.has_corner(other, x) ? ErrorBounded{} : plane(projected_.point(x)); };
    const ErrorBounded at_u = value(u);
    const BoundedPoint3 end = between(projected_.point(u), projected_.point(v), quotient(at_u, at_u - value(v)));
    if (end.error < norm_max(end.p) * 0x1p-20) return end;
  }
  return map_.point(seen, crossing.s);
}

/// The part of a triangle in the near plane, where it has been cut; or its side there, which may be a diagonal of its face.
void SideFinder::add_near_cut(TriangleId t) {
  const auto& c = mesh_.triangles[t];
  if (std::none_of(c.begin(), c.end(), [&](VertexId v) { return projected_.beyond_near(v) == Sign::positive; })) return;
  const MapLine line = MapLine::near(t);
  std::vector<MapPoint> ends;
  for (std::size_t k = 0; k < 3; ++k) {
    const VertexId u = c[k], v = c[(k + 1) % 3];
    if (projected_.beyond_near(u) == Sign::zero) ends.push_back(MapPoint::of_vertex(u));
    if (projected_.beyond_near(u) * projected_.beyond_near(v) == Sign::negative)
      ends.push_back(MapPoint::crossing(line, MapLine::edge(u, v)));
  }
  if (ends.size() != 2) return;
  if (map_.order(line, ends[0], ends[1]) == Sign::positive) std::swap(ends[0], ends[1]);
  const MapStretch stretch = {line, ends[0], ends[1], map_.point(ends[0], t), map_.point(ends[1], t)};
  if (caps_ == nullptr) {
    add(stretch, {}, {});
  } else {
    for (const MapStretch& part : outside_caps(stretch, t)) add(part, {}, {});
  }
}

BoundedPoint3 SideFinder::scaled_point(const RationalVector& given) const {
  const Point3 p = projected_.scaled({given[0].to_double(), given[1].to_double(), given[2].to_double()});
  return {p, 2 * ErrorBounded::u * norm_max(p) + 0x1p-1000};
}

/// What of a stretch no cap covers. @param beside a triangle that has the stretch, and is not seen edge-on
std::vector<MapStretch> SideFinder::outside_caps(const MapStretch& stretch, TriangleId beside) {
  const FacetId facet = facet_of(mesh_, beside);
  const auto seen_at = [&](const MapPoint& p) { return caps_->seen_at(exact_point(mesh_, caps_->view(), facet, p)); };
  const auto bounded = [](const SectionCaps::ExactPlace& at) {
    const auto number = [](const Rational& x) {
      const double d = x.to_double();
      return ErrorBounded{d, ErrorBounded::u * std::fabs(d) + 0x1p-1074};
    };
    return SectionCaps::Place{number(at[0]), number(at[1])};
  };
  std::vector<MapPoint> cuts = {stretch.from, stretch.to};
  caps_->visit_sides(bounded(seen_at(stretch.from)), bounded(seen_at(stretch.to)), [&](std::uint32_t k) {
    const MapLine side = MapLine::near(caps_->sides()[k].triangle);
    if (side != stretch.line && map_.turn(stretch.line, side) != Sign::zero)
      cuts.push_back(MapPoint::crossing(stretch.line, side));
    // Along the stretch itself a side ends where another begins.
    for (const std::uint32_t corner : {caps_->sides()[k].from, caps_->sides()[k].to}) {
      const auto& [a, b] = caps_->corners()[corner];
      if (a == b && map_.side(stretch.line, a) == Sign::zero) cuts.push_back(MapPoint::of_vertex(a));
      if (a != b && stretch.line != MapLine::edge(a, b) && map_.turn(stretch.line, MapLine::edge(a, b)) != Sign::zero)
        cuts.push_back(MapPoint::crossing(stretch.line, MapLine::edge(a, b)));
    }
  });
  std::erase_if(cuts, [&](const MapPoint& p) {
    return map_.order(stretch.line, p, stretch.from) == Sign::negative ||
           map_.order(stretch.line, stretch.to, p) == Sign::negative;
  });
  std::stable_sort(cuts.begin(), cuts.end(),
                   [&](const MapPoint& p, const MapPoint& q) { return map_.order(stretch.line, p, q) == Sign::negative; });
  std::vector<MapStretch> parts;
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    if (map_.order(stretch.line, cuts[k], cuts[k + 1]) != Sign::negative) continue;
    const SectionCaps::ExactPlace from = seen_at(cuts[k]), to = seen_at(cuts[k + 1]);
    if (caps_->covers(SectionCaps::ExactPlace{(from[0] + to[0]) * Rational(0.5), (from[1] + to[1]) * Rational(0.5)})) continue;
    MapStretch part;
    part.line = stretch.line;
    part.from = cuts[k];
    part.to = cuts[k + 1];
    part.a = scaled_point(exact_point(mesh_, caps_->view(), facet, part.from));
    part.b = scaled_point(exact_point(mesh_, caps_->view(), facet, part.to));
    parts.push_back(part);
  }
  return parts;
}

/// The border of all caps together: what is seen outside ends there.
void SideFinder::add_cap_border(const CapArrangement& caps, const CapRun& run) {
  const auto near = [&](std::uint32_t side) { return MapLine::near(caps_->sides()[side].triangle); };
  const auto from = caps.side_across(run.first.from(), run.first), to = caps.side_across(run.last.to(), run.last);
  if (!from || !to) throw InvariantError("visible_fragments: a border of a cap that ends in itself");
  const std::uint32_t side = run.first.part->side;
  MapStretch stretch;
  stretch.line = near(side);
  stretch.from = MapPoint::crossing(stretch.line, near(*from));
  stretch.to = MapPoint::crossing(stretch.line, near(*to));
  stretch.a = scaled_point(caps.point(side, run.first.from()));
  stretch.b = scaled_point(caps.point(run.last.part->side, run.last.to()));
  Sign outside = run.first.left().empty() ? Sign::positive : Sign::negative;
  if (caps_->is_mirrored()) outside = -outside;
  if (map_.order(stretch.line, stretch.from, stretch.to) == Sign::positive) {
    std::swap(stretch.from, stretch.to);
    std::swap(stretch.a, stretch.b);
    outside = -outside;
  }
  const SeenPart nothing{stretch.from, stretch.to, {}, 1, 0};
  if (outside == Sign::positive)
    add_different(stretch, left_.find(stretch, Sign::positive), std::span(&nothing, 1));
  else
    add_different(stretch, std::span(&nothing, 1), right_.find(stretch, Sign::negative));
}

/// Where an edge is cut, in space.
BoundedPoint3 SideFinder::place_of(const Edge& edge, const Cut& cut) const {
  const Point3 &p = projected_.point(edge.a), &q = projected_.point(edge.b);
  if (cut.kind == Cut::Kind::start) return {p, 0};
  if (cut.kind == Cut::Kind::end) return {q, 0};
  const PlaneFilter filter = projected_.filter(cut_plane(projected_, cut));
  const ErrorBounded at_p = filter(p), at_q = filter(q);
  return between(p, q, quotient(at_p, at_p - at_q));
}

/// @param left what is seen to the left, if it is known
void SideFinder::add(MapStretch stretch, TriangleId left, TriangleId right) {
  const SeenPart whole_left{stretch.from, stretch.to, left, 1, 0}, whole_right{stretch.from, stretch.to, right, 1, 0};
  stretch.elsewhere = left.is_valid() ? left : right;
  const std::span<const SeenPart> l = left.is_valid() ? std::span(&whole_left, 1) : left_.find(stretch, Sign::positive);
  const std::span<const SeenPart> r = right.is_valid() ? std::span(&whole_right, 1) : right_.find(stretch, Sign::negative);
  add_different(stretch, l, r);
}

/// Where a point of the stretch is seen.
MapPlace SideFinder::place(const MapStretch& stretch, const MapPoint& p, double t, double error) const {
  constexpr MapPlace unknown = {0, 0, HUGE_VAL, HUGE_VAL};
  if (!(projected_.image_error() < HUGE_VAL)) return unknown;
  if (p.is_vertex) {
    const ImagePoint& at = projected_.image(p.vertex);
    return {at.x, at.y, projected_.image_error(), projected_.image_error()};
  }
  const BoundedPoint3 at = stretch.at(t, error);
  const BoundedPoint2 image = projected_.image(at.p, 3 * at.error);
  return image.error < HUGE_VAL ? MapPlace{image.p.x, image.p.y, image.error, image.error} : unknown;
}

/// Where what is seen to the left and to the right differs, both end. What goes on beside several others ends in one side.
void SideFinder::add_different(const MapStretch& stretch, std::span<const SeenPart> left, std::span<const SeenPart> right) {
  const auto facet = [&](TriangleId t) { return t.is_valid() ? facet_of(mesh_, t) : FacetId(); };
  MapPoint at = left.front().from;
  MapPlace place_of_at = place(stretch, at, 0, 0);
  // What ends on each side since where; none: nothing does.
  struct Ending {
    FacetId facet;
    MapPoint from;
    MapPlace place;
  };
  Ending l, r;
  const auto go_on = [&](Ending& ending, FacetId next, bool is_left) {
    if (ending.facet == next) return;
    if (ending.facet.is_valid())
      sides_.add(ending.facet, is_left ? PlacedSide{{stretch.line, false, ending.from, at}, ending.place, place_of_at}
                                       : PlacedSide{{stretch.line, true, at, ending.from}, place_of_at, ending.place});
    ending = {next, at, place_of_at};
  };
  std::size_t i = 0, j = 0;
  while (i < left.size() && j < right.size()) {
    const FacetId seen_left = facet(left[i].seen), seen_right = facet(right[j].seen);
    const bool is_border = seen_left != seen_right;
    go_on(l, is_border ? seen_left : FacetId(), true);
    go_on(r, is_border ? seen_right : FacetId(), false);
    const double gap = left[i].to_t - right[j].to_t;
    const bool is_certain = std::fabs(gap) > (left[i].to_error + right[j].to_error) * 1.01;
    const Sign first = is_certain ? sign_of(gap) : map_.order(stretch.line, left[i].to, right[j].to);
    const SeenPart& ends = first == Sign::positive ? right[j] : left[i];
    at = ends.to;
    place_of_at = place(stretch, at, ends.to_t, ends.to_error);
    if (first != Sign::positive) ++i;
    if (first != Sign::negative) ++j;
  }
  go_on(l, {}, true);
  go_on(r, {}, false);
}

class FragmentFinder {
 public:
  FragmentFinder(const SceneView& scene, const FragmentOptions& options)
      : options_(options), parts_(scene.parts()), projected_(parts_.projected(options.stop)), mesh_(parts_.mesh()) {}

  VisibleFragments fragments();

 private:
  bool is_left_out(TriangleId t) const { return !left_out_->empty() && (*left_out_)[t.value] != 0; }
  bool has_many_borders() const;
  void find_lines();
  void find_own_lines(bool is_soup);
  void find_sides();
  template <class F>
  void collect(std::span<const std::uint32_t> order, const F& visit);

  const FragmentOptions& options_;
  const ViewParts& parts_;
  const ProjectedMesh& projected_;
  const Mesh& mesh_;
  const std::vector<std::uint8_t>* left_out_ = nullptr;  // hidden or seen edge-on, by triangle
  const Occluders* occluders_ = nullptr;
  const Intersections* intersections_ = nullptr;
  const VisibleLines* lines_ = nullptr;   // of all edges of faces that are not left out, others may be among them
  VisibleLines own_lines_;                // these, unless they are given
  std::vector<std::uint32_t> place_;      // of each triangle along the tree of the occluders
  std::vector<FacetSides> found_;         // of each block of lines
  std::vector<const PlacedSide*> sides_;  // of these, by facet
  std::vector<std::size_t> first_side_;   // by TriangleId, one more
  DecisionCounts decisions_;
};

/// Whether more edges than there are faces occlude for certain, as they are borders: OccludingEdges would find no fewer.
bool FragmentFinder::has_many_borders() const {
  const auto is_counted = [&](TriangleId t) {
    const FaceId f = mesh_.face_of[t];
    if (is_left_out(t)) return false;
    for (std::uint32_t k = mesh_.first_triangle[f]; k < mesh_.first_triangle[FaceId(f.value + 1U)]; ++k)
      if (projected_.reaches_before_near(TriangleId(k))) return false;
    return true;
  };
  std::size_t borders = 0;
  for (std::size_t e = 0; e < mesh_.edges.size() && borders <= occluders_->triangles.size(); ++e) {
    const auto triangles = mesh_.triangles_at(EdgeId(e));
    if (triangles.size() == 1 && is_counted(triangles[0])) ++borders;
  }
  return borders > occluders_->triangles.size();
}

/// A face that is seen edge-on has no area in the image: it is left out, and its edges with it.
void FragmentFinder::find_lines() {
  left_out_ = &parts_.hidden_or_edge_on(options_.stop);
  occluders_ = &parts_.occluders(Excluded::hidden_and_edge_on, options_.stop);
  // Of a mesh few lines are looked along, as most edges have a face on each side: records may not pay.
  const bool is_soup = has_many_borders();
  if (is_soup) occluders_->prepare();
  intersections_ = &parts_.visible_intersections(options_.stop);
  // In lines of others a face seen edge-on hides what is behind it, here it hides nothing.
  if (options_.lines != nullptr && !parts_.has_edge_on(options_.stop)) {
    lines_ = options_.lines;
    if (lines_->plan.method != "appel") occluders_->prepare();
    return;
  }
  find_own_lines(is_soup);
  lines_ = &own_lines_;
}

void FragmentFinder::find_own_lines(bool is_soup) {
  const OcclusionPyramid* const tiles = parts_.pyramid(options_.stop);
  auto edges = parallel_collect<EdgeId>(mesh_.edges.size(), [&](std::size_t begin, std::size_t end, std::vector<EdgeId>& part) {
    for (std::size_t e = begin; e < end; ++e) {
      const auto triangles = mesh_.triangles_at(EdgeId(e));
      if (std::any_of(triangles.begin(), triangles.end(), [&](TriangleId t) { return !is_left_out(t); }) &&
          !(tiles != nullptr && tiles->hides(mesh_.edges[EdgeId(e)])))
        part.emplace_back(e);
    }
  });
  const ClassifiedEdges requested(projected_, std::move(edges));
  LineOptions line_options;
  line_options.stop = options_.stop;
  const bool may_count = projected_.arithmetic() == Arithmetic::staged && !is_soup;
  const bool appel_pays = may_count && parts_.occluding_edges(Excluded::hidden_and_edge_on, options_.stop).edges().size() <=
                                           occluders_->triangles.size();
  if (!appel_pays) occluders_->prepare();
  own_lines_ = appel_pays ? appel(projected_, requested, parts_.occluding_edges(Excluded::hidden_and_edge_on, options_.stop),
                                  *occluders_, line_options)
                          : roberts(projected_, requested, *occluders_, line_options, tiles);
  if (const SectionCaps* const caps = parts_.caps(options_.stop))
    own_lines_ = behind_caps(projected_, *caps, line_options, std::move(own_lines_));
}

/// The numbers from 0 to n - 1, ascending by key(i) < keys.
template <class Key>
std::vector<std::uint32_t> ordered(std::size_t n, std::size_t keys, const Key& key) {
  std::vector<std::uint32_t> next(keys + 1, 0), order(n);
  for (std::size_t i = 0; i < n; ++i) ++next[key(i) + 1];
  for (std::size_t k = 1; k <= keys; ++k) next[k] += next[k - 1];
  for (std::size_t i = 0; i < n; ++i) order[next[key(i)]++] = static_cast<std::uint32_t>(i);
  return order;
}

template <class F>
void FragmentFinder::collect(std::span<const std::uint32_t> order, const F& visit) {
  constexpr std::size_t block = 256;
  const std::size_t n = order.size();
  std::vector<FacetSides> parts((n + block - 1) / block);
  std::vector<DecisionCounts> counts(parts.size());
  tbb::parallel_for(Range(0, parts.size(), 1), [&](const Range& range) {
    for (std::size_t part = range.begin(); part < range.end(); ++part) {
      SideFinder finder(projected_, *occluders_, *intersections_, place_, parts_.pyramid(options_.stop),
                        parts_.caps(options_.stop));
      const std::size_t end = std::min((part + 1) * block, n);
      for (std::size_t i = part * block; i < end; ++i) visit(finder, order[i]);
      parts[part] = finder.take();
      counts[part] = finder.decisions();
    }
  });
  for (std::size_t part = 0; part < parts.size(); ++part) {
    found_.push_back(std::move(parts[part]));
    decisions_ += counts[part];
  }
}

void FragmentFinder::find_sides() {
  // Along the tree: neighbours in the image look at the same triangles, which are still in the cache.
  place_.assign(mesh_.triangles.size(), 0);
  if (occluders_->is_prepared())
    for (std::size_t i = 0; i < occluders_->place().size(); ++i)
      place_[occluders_->triangles[i].value] = occluders_->place()[i];
  const auto along_tree = [&](std::vector<std::uint32_t> numbers, const auto& triangle) {
    const auto order =
        ordered(numbers.size(), place_.size(), [&](std::size_t i) { return place_[triangle(numbers[i]).value]; });
    std::vector<std::uint32_t> sorted(numbers.size());
    for (std::size_t i = 0; i < sorted.size(); ++i) sorted[i] = numbers[order[i]];
    return sorted;
  };
  const auto numbers = [](std::size_t n, const auto& is_kept) {
    std::vector<std::uint32_t> kept;
    for (std::size_t i = 0; i < n; ++i)
      if (is_kept(i)) kept.push_back(static_cast<std::uint32_t>(i));
    return kept;
  };
  const auto& lines = lines_->lines;
  const auto& segments = intersections_->segments;
  const auto bounds_a_fragment = [&](std::size_t i) {
    if (lines[i].is_intersection() || lines[i].is_ghost || (lines[i].intervals() == 1 && lines[i].starts_hidden)) return false;
    const auto triangles = mesh_.triangles_at(lines[i].edge);
    return std::any_of(triangles.begin(), triangles.end(), [&](TriangleId t) { return !is_left_out(t); });
  };
  collect(along_tree(numbers(lines.size(), bounds_a_fragment),
                     [&](std::size_t i) { return mesh_.triangles_at(lines[i].edge).front(); }),
          [&](SideFinder& finder, std::size_t i) { finder.add_edge(*lines_, lines[i]); });
  collect(along_tree(numbers(segments.size(),
                             [&](std::size_t i) { return !is_left_out(segments[i].s) && !is_left_out(segments[i].t); }),
                     [&](std::size_t i) { return segments[i].s; }),
          [&](SideFinder& finder, std::size_t i) { finder.add_intersection(segments[i]); });
  if (projected_.has_near())
    collect(along_tree(numbers(occluders_->triangles.size(), [](std::size_t) { return true; }),
                       [&](std::size_t i) { return occluders_->triangles[i]; }),
            [&](SideFinder& finder, std::size_t i) { finder.add_near_cut(occluders_->triangles[i]); });
  if (const SectionCaps* const caps = parts_.caps(options_.stop)) {
    const CapArrangement arrangement(*caps);
    const auto runs =
        arrangement.runs([](const CapPart& part) { return part.left.empty() != part.right.empty(); },
                         [](const DirectedPart& a, const DirectedPart& b) { return a.left().empty() == b.left().empty(); });
    collect(numbers(runs.size(), [](std::size_t) { return true; }),
            [&](SideFinder& finder, std::size_t i) { finder.add_cap_border(arrangement, runs[i]); });
  }
  // A counting sort by facet.
  first_side_.assign(mesh_.triangles.size() + 1, 0);
  for (const FacetSides& part : found_)
    for (const FacetId facet : part.facets) ++first_side_[facet.value + 1U];
  for (std::size_t t = 1; t < first_side_.size(); ++t) first_side_[t] += first_side_[t - 1];
  sides_.resize(first_side_.back());
  std::vector<std::size_t> next(first_side_.begin(), first_side_.end() - 1);
  for (const FacetSides& part : found_)
    for (std::size_t i = 0; i < part.sides.size(); ++i) sides_[next[part.facets[i].value]++] = &part.sides[i];
}

VisibleFragments FragmentFinder::fragments() {
  if (mesh_.triangles.empty()) return {};
  find_lines();
  find_sides();
  struct Worker {
    MapPredicates at;
    RingLinker linker;
    std::vector<PlacedSide> sides;
    explicit Worker(const ProjectedMesh& projected) : at(projected), linker(at) {}
    MapPredicates& map() { return at; }
  };
  VisibleFragments all = fragments_in_blocks(
      mesh_, options_, [&] { return Worker(projected_); },
      [&](Worker& worker, FacetId facet, FragmentParts& parts) {
        const std::size_t begin = first_side_[facet.value], end = first_side_[facet.value + 1U];
        if (begin == end) return;
        worker.sides.clear();
        for (std::size_t k = begin; k < end; ++k) worker.sides.push_back(*sides_[k]);
        parts.add(facet, worker.linker.link(worker.sides));
      });
  all.decisions += decisions_;
  all.decisions += own_lines_.decisions;
  all.decisions += intersections_->decisions;
#ifdef HSR_CHECKS
  if (projected_.arithmetic() != Arithmetic::double_only) check_invariants(projected_, all);  // it promises nothing
#endif
  return all;
}

}  // namespace

bool fragments_use_lines(const SceneView& scene) { return !scene.parts().has_edge_on(); }

VisibleFragments visible_fragments(const SceneView& scene, const FragmentOptions& options) {
  throw_if_stopped(options.stop);
  return FragmentFinder(scene, options).fragments();
}

}  // namespace hsr
