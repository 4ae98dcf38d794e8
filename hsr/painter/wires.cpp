#include "hsr/painter/wires.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "geometry/near_value.h"
#include "geometry/rational_vector.h"
#include "hsr/scene/box_tree.h"
#include "hsr/scene/facet.h"
#include "hsr/scene/view_parts.h"

namespace hsr::internal {

namespace {

/// A stretch of a wire, by parameters.
struct WireStretch {
  Rational from, to;
};

/// Where a wire is in front of a piece, or on it, or else behind it.
struct Meeting {
  WireStretch where;
  std::uint32_t piece;
  bool is_in_front;
};

/// What of a stretch is where a function that is linear along the wire, from `a` at 0 to `b` at 1, is positive. False: nothing.
bool keep_positive(WireStretch& s, const Rational& a, const Rational& b) {
  if (a.sign() != Sign::positive && b.sign() != Sign::positive) return false;
  if (a.sign() == Sign::negative) s.from = std::max(s.from, a / (a - b));
  if (b.sign() == Sign::negative) s.to = std::min(s.to, a / (a - b));
  return s.from < s.to;
}

bool is_seen_as_point(const Mesh& mesh, const View& view, const Edge& wire) {
  const RationalVector eye = rational(view.viewpoint.at), a = rational(mesh.points[wire.a]), b = rational(mesh.points[wire.b]);
  const RationalVector normal = view.is_perspective() ? cross(minus(a, eye), minus(b, eye)) : cross(minus(b, a), eye);
  return dot(normal, normal).sign() == Sign::zero;
}

/// What of a wire is beyond the near plane; nothing: none.
std::optional<WireStretch> beyond_near(const Mesh& mesh, const View& view, const Edge& wire) {
  WireStretch all = {0.0, 1.0};
  if (!view.cuts()) return all;
  const auto beyond = [&, near = view.near_plane()](VertexId v) { return near_value(near, rational(mesh.points[v])); };
  const Rational at_a = beyond(wire.a), at_b = beyond(wire.b);
  if (at_a.sign() == Sign::zero && at_b.sign() == Sign::zero) return all;  // what lies in the plane stays
  if (!keep_positive(all, at_a, at_b)) return {};
  return all;
}

/// Meetings of wires and pieces, in rationals of the points as given.
class WireMeetings {
 public:
  WireMeetings(const Mesh& mesh, const View& view, const PaintersOrder& order)
      : mesh_(mesh), view_(view), order_(order), eye_(rational(view.viewpoint.at)) {}

  void add(const Edge& wire, const WireStretch& all, std::uint32_t piece, std::vector<Meeting>& meetings) const {
    const RationalVector a = rational(mesh_.points[wire.a]), b = rational(mesh_.points[wire.b]);
    std::vector<RationalVector> ring;
    for (const PieceCorner& c : order_.corners_of(order_.pieces[piece]))
      ring.push_back(exact_point(mesh_, view_, order_.pieces[piece].facet, c));
    WireStretch common = all;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      // Pieces are counter-clockwise as seen: inside is where their corners are.
      const RationalVector side = sight_plane(ring[k], ring[(k + 1) % ring.size()]);
      Sign inside = Sign::zero;
      for (std::size_t i = 0; i < ring.size() && inside == Sign::zero; ++i) inside = value(side, ring[k], ring[i]).sign();
      const Rational way = inside == Sign::negative ? -1.0 : 1.0;
      if (!keep_positive(common, way * value(side, ring[k], a), way * value(side, ring[k], b))) return;
    }
    add_by_depth(ring, a, b, common, piece, meetings);
  }

 private:
  /// Square to the plane through two points and the viewpoint.
  RationalVector sight_plane(const RationalVector& p, const RationalVector& q) const {
    return view_.is_perspective() ? cross(minus(p, eye_), minus(q, eye_)) : cross(minus(q, p), eye_);
  }
  static Rational value(const RationalVector& normal, const RationalVector& on, const RationalVector& p) {
    return dot(normal, minus(p, on));
  }

  void add_by_depth(const std::vector<RationalVector>& ring, const RationalVector& a, const RationalVector& b,
                    const WireStretch& common, std::uint32_t piece, std::vector<Meeting>& meetings) const {
    RationalVector normal;
    for (std::size_t k = 1; k + 1 < ring.size(); ++k) {
      normal = cross(minus(ring[k], ring[0]), minus(ring[k + 1], ring[0]));
      if (dot(normal, normal).sign() != Sign::zero) break;
    }
    const Rational eye = view_.is_perspective() ? value(normal, ring[0], eye_) : dot(normal, eye_);
    const Rational way = eye.sign() == Sign::negative ? -1.0 : 1.0;
    const Rational at_a = way * value(normal, ring[0], a), at_b = way * value(normal, ring[0], b);
    if (at_a.sign() == Sign::zero && at_b.sign() == Sign::zero) {
      meetings.push_back({common, piece, true});
      return;
    }
    WireStretch front = common, behind = common;
    if (keep_positive(front, at_a, at_b)) meetings.push_back({front, piece, true});
    if (keep_positive(behind, -at_a, -at_b)) meetings.push_back({behind, piece, false});
  }

  const Mesh& mesh_;
  const View& view_;
  const PaintersOrder& order_;
  RationalVector eye_;
};

/// A filter: whether a side of a piece, or the wire, has all of the other on one side of it in the image, by signs of vertices.
class WireSeparator {
 public:
  WireSeparator(const ProjectedMesh& projected, const PaintersOrder& order)
      : projected_(projected), order_(order), exact_(projected.predicates()) {}

  bool are_certainly_apart(const Edge& wire, std::uint32_t piece) {
    const auto corners = order_.corners_of(order_.pieces[piece]);
    bool left = false, right = false;  // of the wire are corners, or may be
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const VertexId v = corners[k].vertex, next = corners[(k + 1) % corners.size()].vertex;
      const Sign at = v.is_valid() ? side(wire.a, wire.b, v) : Sign::zero;
      left = left || !v.is_valid() || at == Sign::positive;
      right = right || !v.is_valid() || at == Sign::negative;
      // Pieces are counter-clockwise as seen.
      if (v.is_valid() && next.is_valid() && side(v, next, wire.a) != Sign::positive && side(v, next, wire.b) != Sign::positive)
        return true;
    }
    return !(left && right);
  }

 private:
  Sign side(VertexId a, VertexId b, VertexId p) { return exact_.side(projected_.sight_plane(a, b), projected_.point(p)); }

  const ProjectedMesh& projected_;
  const PaintersOrder& order_;
  Predicates exact_;
};

/// Tiles a wire by its meetings: each part as long as there is a place for it in the order.
class WireCutter {
 public:
  WireCutter(EdgeId wire, const WireStretch& all, std::uint32_t pieces) : wire_(wire), all_(all), pieces_(pieces) {}

  std::vector<OrderedWire> parts(const std::vector<Meeting>& meetings) {
    struct Event {
      const Rational* at;
      std::uint32_t piece;
      bool is_in_front, begins;
    };
    std::vector<Event> events;
    for (const Meeting& m : meetings) {
      events.push_back({&m.where.from, m.piece, m.is_in_front, true});
      events.push_back({&m.where.to, m.piece, m.is_in_front, false});
    }
    std::sort(events.begin(), events.end(), [](const Event& x, const Event& y) { return *x.at < *y.at; });
    from_ = all_.from;
    std::multiset<std::uint32_t> behind_it, before_it;  // pieces that the wire is in front of here, and behind
    for (auto e = events.begin(); e != events.end();) {
      const Rational at = *e->at;
      for (; e != events.end() && *e->at == at; ++e) {
        auto& some = e->is_in_front ? behind_it : before_it;
        if (e->begins)
          some.insert(e->piece);
        else
          some.erase(some.find(e->piece));
      }
      const std::uint32_t earliest = behind_it.empty() ? 0 : *behind_it.rbegin() + 1;
      const std::uint32_t latest = before_it.empty() ? pieces_ : *before_it.begin();
      if (std::max(earliest, earliest_) > std::min(latest, latest_)) {
        end_part(at);
        earliest_ = earliest;
        latest_ = latest;
      } else {
        earliest_ = std::max(earliest, earliest_);
        latest_ = std::min(latest, latest_);
      }
    }
    end_part(all_.to);
    return std::move(parts_);
  }

 private:
  void end_part(const Rational& to) {
    if (from_ < to) parts_.push_back({wire_, from_, to, latest_});
    from_ = to;
  }

  EdgeId wire_;
  const WireStretch& all_;
  std::uint32_t pieces_;
  Rational from_;
  std::uint32_t earliest_ = 0, latest_ = pieces_;
  std::vector<OrderedWire> parts_;
};

std::vector<ImageBox> boxes_of(const ViewParts& parts, const PaintersOrder& order) {
  const ProjectedMesh& projected = parts.projected();
  std::vector<ImageBox> boxes;
  boxes.reserve(order.pieces.size());
  for (const OrderedPiece& piece : order.pieces) {
    ImageBox box = ImageBox::nothing();
    for (std::uint32_t t = first_triangle(piece.facet).value; t < facet_end(parts.mesh(), piece.facet).value; ++t)
      box.add(projected.box(TriangleId(t)));
    boxes.push_back(box);
  }
  return boxes;
}

}  // namespace

std::vector<OrderedWire> whole_wires(const SceneView& scene) {
  std::vector<OrderedWire> wires;
  for (std::size_t e = 0; e < scene.mesh().edges.size(); ++e) {
    const Edge& edge = scene.mesh().edges[EdgeId(e)];
    if (!edge.wire || is_seen_as_point(scene.mesh(), scene.view(), edge)) continue;
    if (const auto all = beyond_near(scene.mesh(), scene.view(), edge)) wires.push_back({EdgeId(e), all->from, all->to, 0});
  }
  return wires;
}

std::vector<OrderedWire> ordered_wires(const SceneView& scene, const PaintersOrder& order) {
  const Mesh& mesh = scene.mesh();
  const std::vector<OrderedWire> wires = whole_wires(scene);
  if (wires.empty()) return {};
  const BoxTree tree(boxes_of(scene.parts(), order));
  const ProjectedMesh& projected = scene.parts().projected();
  tbb::enumerable_thread_specific<WireSeparator> separators([&] { return WireSeparator(projected, order); });
  const WireMeetings finder(mesh, scene.view(), order);
  const auto pieces = static_cast<std::uint32_t>(order.pieces.size());
  std::vector<std::vector<OrderedWire>> found(wires.size());
  tbb::parallel_for(std::size_t{0}, wires.size(), [&](std::size_t w) {
    const Edge& wire = mesh.edges[wires[w].edge];
    const WireStretch all = {wires[w].from, wires[w].to};
    std::vector<Meeting> meetings;
    const auto meet = [&](std::uint32_t piece, std::uint32_t /*at*/) {
      if (!separators.local().are_certainly_apart(wire, piece)) finder.add(wire, all, piece, meetings);
      return true;
    };
    if (!tree.is_empty()) tree.visit_boxes<BoxTree::Depth::any>(projected.box(wire.a, wire.b), meet);
    found[w] = WireCutter(wires[w].edge, all, pieces).parts(meetings);
  });
  std::vector<OrderedWire> parts;
  for (auto& some : found)
    parts.insert(parts.end(), std::make_move_iterator(some.begin()), std::make_move_iterator(some.end()));
  std::stable_sort(parts.begin(), parts.end(), [](const OrderedWire& a, const OrderedWire& b) { return a.before < b.before; });
  return parts;
}

}  // namespace hsr::internal
