#include "hsr/lines/invisibility_events.h"

#include <bit>

#include "hsr/scene/line_filter.h"

namespace hsr::internal {

namespace {

/// How many bits are set in the lowest eight: one of a leaf's boxes each.
unsigned count_of(unsigned bits) {
  bits -= bits >> 1U & 0x55U;
  bits = (bits & 0x33U) + (bits >> 2U & 0x33U);
  return (bits + (bits >> 4U)) & 0xfU;
}

}  // namespace

void InvisibilityEvents::add(InvisibilityChange change, std::vector<InvisibilityChange>& changes) {
  course_.left += change.left;
  course_.right += change.right;
  changes.push_back(change);
}

void InvisibilityEvents::turn_to(std::span<const ImageBox> boxes) {
  constexpr std::size_t limit = 64;  // more of them cost an edge more than its own way down the tree
  ImageBox all = ImageBox::nothing();
  for (const ImageBox& box : boxes) all.add(box);
  edge_leaves_.clear();
  face_leaves_.clear();
  shares_edge_leaves_ = layers_.tree().leaves<BoxTree::Depth::hiding>(all, limit, edge_leaves_);
  shares_face_leaves_ = occluders_.tree.leaves<BoxTree::Depth::touching>(all, limit, face_leaves_);
}

EdgeWalk InvisibilityEvents::find(EdgeId id, const ImageBox& box, std::vector<InvisibilityChange>& changes) {
  const Edge& edge = projected_.mesh().edges[id];
  course_ = {};
  if (projected_.beyond_near(edge.a) == Sign::negative || projected_.beyond_near(edge.b) == Sign::negative) {
    course_.is_degenerate = true;
    return course_;
  }
  const LineFilter line(projected_, edge.a, edge.b);
  line_ = &line;
  if (line.is_point(exact_)) {
    course_.is_point = true;
    return course_;
  }
  const std::size_t before = changes.size();
  using Depth = BoxTree::Depth;
  const auto cross_one = [&](std::uint32_t i) {
    const OccludingEdge& occluding = layers_.edges()[i];
    if (occluding.edge != id) cross(edge, occluding, changes);
    return !course_.is_degenerate;
  };
  if (shares_edge_leaves_)
    for (const std::uint32_t leaf : edge_leaves_) {
      if (!layers_.tree().visit_leaf<Depth::hiding>(leaf, box, cross_one)) break;
    }
  else
    layers_.tree().visit(box, cross_one);
  if (!course_.is_degenerate) pierce_faces(edge, box, changes);
  if (course_.is_degenerate) changes.resize(before);
  return course_;
}

/// Where many boxes of each leaf overlap, as those of long slivers do, the view plane of the edge tells most of a leaf apart at once.
void InvisibilityEvents::pierce_faces(const Edge& edge, const ImageBox& box, std::vector<InvisibilityChange>& changes) {
  using Depth = BoxTree::Depth;
  constexpr unsigned many = 4;
  const BoxTree& tree = occluders_.tree;
  const std::vector<LeafCorners>* corners = nullptr;
  LeafPlane sight;
  if (leaves_ > 256 && boxes_ > many * leaves_ && exact_.filter_is_proven()) {
    corners = &occluders_.leaf_corners();
    sight = LeafPlane(projected_.filter(projected_.sight_plane(edge.a, edge.b)));
  }
  const auto pierce_leaf = [&](std::uint32_t leaf, unsigned hit) {
    ++leaves_;
    boxes_ += count_of(hit);
    if (corners != nullptr) {
      const unsigned beside = hit & (*corners)[leaf].beside(sight);
      pairs_ += count_of(beside);
      hit &= ~beside;
    }
    for (; hit != 0; hit &= hit - 1) {
      const TriangleId t = occluders_.triangles[tree.box_at(leaf, static_cast<std::size_t>(std::countr_zero(hit)))];
      if (layers_.counts(t)) pierce(edge, t, changes);
      if (course_.is_degenerate) return false;
    }
    return true;
  };
  if (!shares_face_leaves_) {
    tree.visit_leaves<Depth::touching>(box, pierce_leaf);
    return;
  }
  for (const std::uint32_t leaf : face_leaves_)
    if (const unsigned hit = tree.overlaps<Depth::touching>(leaf, box); hit != 0 && !pierce_leaf(leaf, hit)) return;
}

void InvisibilityEvents::cross(const Edge& edge, const OccludingEdge& occluding, std::vector<InvisibilityChange>& changes) {
  const Edge& f = projected_.mesh().edges[occluding.edge];
  const bool at_start = f.a == edge.a || f.b == edge.a, at_end = f.a == edge.b || f.b == edge.b;
  if (at_start || at_end) {
    // It crosses only in the common vertex. Seen along the edge, it may cover the other end.
    const VertexId other = f.a == edge.a || f.a == edge.b ? f.b : f.a;
    if (at_start && course_.end_is_clean && !line_->certainly_before_start(other) && line_->side(other, exact_) == Sign::zero)
      course_.end_is_clean = false;
    if (at_end && course_.start_is_clean && !line_->certainly_after_end(other) && line_->side(other, exact_) == Sign::zero)
      course_.start_is_clean = false;
    return;
  }
  ++pairs_;
  const Sign s0 = line_->side(f.a, exact_), s1 = line_->side(f.b, exact_);
  if (s0 == s1 && s0 != Sign::zero) return;
  if (s0 == s1) {
    // Its image is in line with the edge: it crosses nowhere, but it may be in front of the ends, or touch them.
    if (!(line_->certainly_before_start(f.a) && line_->certainly_before_start(f.b)) &&
        !(line_->certainly_after_start(f.a) && line_->certainly_after_start(f.b)))
      course_.start_is_clean = false;
    if (!(line_->certainly_before_end(f.a) && line_->certainly_before_end(f.b)) &&
        !(line_->certainly_after_end(f.a) && line_->certainly_after_end(f.b)))
      course_.end_is_clean = false;
    return;
  }
  const LineFilter other(projected_, f.a, f.b);
  const Sign sa = other.side(edge.a, exact_), sb = other.side(edge.b, exact_);
  if (sa == sb) return;  // not both zero: the lines differ
  if (sa * sb == Sign::positive) return;
  // The plane of the edge and of an end of f that is not seen on the edge: f crosses behind it iff the other end lies on the
  // side that is turned away from the eye.
  const bool by_first = s0 != Sign::zero;
  const VertexId c = by_first ? f.a : f.b, d = by_first ? f.b : f.a;
  const Plane plane = Plane::of_face(projected_.point(edge.a), projected_.point(edge.b), projected_.point(c));
  const Sign behind = -(projected_.side(plane, d, exact_) * (by_first ? s0 : s1));
  if (behind == Sign::positive) return;
  if (sa == Sign::zero) course_.start_is_clean = false;
  if (sb == Sign::zero) course_.end_is_clean = false;
  if (sa == Sign::zero || sb == Sign::zero) return;
  if (behind == Sign::zero) {
    course_.is_degenerate = true;
    return;
  }
  // From the left of f to its right the layers change by minus its weight.
  const std::int32_t change = sa == Sign::positive ? -occluding.weight : occluding.weight;
  const bool on_left = (s0 == Sign::positive) != (s1 == Sign::positive);   // zero counts as right
  const bool on_right = (s0 == Sign::negative) != (s1 == Sign::negative);  // zero counts as left
  add({occluding.edge.value, false, on_left ? change : 0, on_right ? change : 0}, changes);
}

void InvisibilityEvents::pierce(const Edge& edge, TriangleId t, std::vector<InvisibilityChange>& changes) {
  const auto& c = projected_.mesh().triangles[t];
  for (const VertexId v : c)
    if (v == edge.a || v == edge.b) return;  // it meets the plane there, or lies in it
  ++pairs_;
  const Sign first = line_->certain_side(c[0]);
  if (first != Sign::zero && line_->certain_side(c[1]) == first && line_->certain_side(c[2]) == first) return;
  const Plane plane = projected_.face_plane(t);
  const Sign at_a = projected_.side(plane, edge.a, exact_), at_b = projected_.side(plane, edge.b, exact_);
  if (at_a == at_b) return;  // wholly on one side, or in the plane, where nothing hides
  const Sign facing = projected_.facing(t);
  if (at_a == Sign::zero || at_b == Sign::zero) {
    const VertexId v = at_a == Sign::zero ? edge.a : edge.b;
    for (std::size_t k = 0; k < 3; ++k)
      if (LineFilter(projected_, c[k], c[(k + 1) % 3]).side(v, exact_) * facing == Sign::negative) return;
    course_.is_degenerate = true;
    return;
  }
  // The line of the edge passes the three sides of the triangle in one sense iff it goes through the inside.
  bool positive = false, negative = false, zero = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const Sign s = projected_.side(Plane::of_face(projected_.point(edge.a), projected_.point(edge.b), projected_.point(c[k])),
                                   c[(k + 1) % 3], exact_);
    (s == Sign::zero ? zero : s == Sign::positive ? positive : negative) = true;
  }
  if (positive && negative) return;
  if (zero) {
    course_.is_degenerate = true;
    return;
  }
  // The eye lies on the side `facing`.
  const std::int32_t change = at_b == -facing ? 1 : -1;
  add({t.value, true, change, change}, changes);
}

}  // namespace hsr::internal
