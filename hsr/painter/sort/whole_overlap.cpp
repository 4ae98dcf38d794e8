#include "hsr/painter/sort/whole_overlap.h"

#include <algorithm>

namespace hsr::internal {

namespace {

void make_lines(const ProjectedMesh& projected, std::span<const VertexId> ring, std::vector<LineFilter>& lines) {
  if (!lines.empty()) return;
  VertexId from = ring.back();  // side k ends at corner k
  for (const VertexId to : ring) {
    lines.emplace_back(projected, from, to);
    from = to;
  }
}

}  // namespace

void WholeOverlaps::prepare(std::uint32_t piece, Whole& whole) const {
  whole.facet = pieces_.facet[piece];
  whole.ring = pieces_.rings[piece];
  whole.inner = projected_.facing(whole.facet);
  whole.lines.clear();
  whole.has_plane = false;
  whole.image = !images_.triangles.empty() && whole.ring.size() == 3 ? &images_.triangles[piece] : nullptr;
}

void WholeOverlaps::prepare_plane(Whole& whole) const {
  if (whole.has_plane) return;
  whole.has_plane = true;
  whole.plane = projected_.face_plane(whole.facet);
  whole.filter = projected_.filter(whole.plane);
}

void WholeOverlaps::turn_to(std::uint32_t piece) {
  prepare(piece, first_);
  if (first_.image != nullptr) prepared_ = PreparedTriangle(*first_.image, images_.error);
}

/// Whether some side of a has all of the inside of b on its outer side in the image, as far as doubles tell.
Separation WholeOverlaps::separation(Whole& a, const Whole& b) const {
  make_lines(projected_, a.ring, a.lines);
  bool is_open = false;
  VertexId from = a.ring.back();
  for (std::size_t k = 0; k < a.ring.size(); ++k) {
    const VertexId to = a.ring[k];
    bool is_outside = true, is_certain = true;
    for (const VertexId v : b.ring) {
      if (v == from || v == to) continue;
      const std::optional<Sign> s = a.lines[k].side_by_doubles(v);
      is_certain = is_certain && s;
      is_outside = s != a.inner;
      if (!is_outside) break;
    }
    if (is_outside && is_certain) return Separation::yes;
    is_open = is_open || is_outside;
    from = to;
  }
  return is_open ? Separation::open : Separation::no;
}

bool WholeOverlaps::separates(Whole& a, const Whole& b) {
  make_lines(projected_, a.ring, a.lines);
  VertexId from = a.ring.back();
  for (std::size_t k = 0; k < a.ring.size(); ++k) {
    const VertexId to = a.ring[k];
    const auto is_outside = [&](VertexId v) { return v == from || v == to || a.lines[k].side(v, exact_) != a.inner; };
    if (std::all_of(b.ring.begin(), b.ring.end(), is_outside)) return true;
    from = to;
  }
  return false;
}

/// @param by what floats tell of the sides of a, and of b. @pre none of them separates
bool WholeOverlaps::are_apart(Whole& a, Whole& b, PreparedTriangle::Both by) {
  if (by.own == Separation::open) by.own = separation(a, b);
  if (by.own == Separation::yes) return true;
  if (by.other == Separation::open) by.other = separation(b, a);
  if (by.other == Separation::yes) return true;
  return (by.own == Separation::open && separates(a, b)) || (by.other == Separation::open && separates(b, a));
}

/// Whether some corners are behind the plane, and whether some are in front of it.
Sides WholeOverlaps::sides(const Whole& plane, const Whole& corners) {
  Sides found;
  // As Overlaps has it, corners of the plane's triangle are in it, and others are looked at.
  for (const VertexId v : corners.ring) {
    if (projected_.mesh().has_corner(first_triangle(plane.facet), v)) continue;
    const ErrorBounded x = plane.filter(projected_.point(v));
    if (x.is_certain()) ++exact_.counts().filter;
    const Sign s = x.is_certain() ? sign_of(x.value) : exact_.side_beyond_filter(plane.plane, projected_.point(v));
    found.add(-(s * projected_.facing(plane.facet)));
    if (found.nearer && found.farther) break;
  }
  return found;
}

std::optional<Overlap> WholeOverlaps::relation(std::uint32_t piece) {
  const std::size_t corners = pieces_.rings[piece].size();
  const ImageTriangle *const a = first_.image, *const b = a != nullptr && corners == 3 ? &images_.triangles[piece] : nullptr;
  exact_.counts().filter += 2 * first_.ring.size() * corners;
  PreparedTriangle::Both by_floats;
  if (b != nullptr) by_floats = prepared_.separation_from(*b);
  // Most pairs go no farther.
  const bool is_separated = by_floats.own == Separation::yes || by_floats.other == Separation::yes;
  if (!is_separated) prepare(piece, second_);
  if (is_separated || are_apart(first_, second_, by_floats)) {
    ++counts_.image_sides;
    return Overlap::none;
  }
  if (b != nullptr && (a->nearest < b->farthest || b->nearest < a->farthest)) {
    ++counts_.depths;
    return a->nearest < b->farthest ? Overlap::first_behind : Overlap::second_behind;
  }
  prepare_plane(first_);
  const Sides of_second = sides(first_, second_);
  if (!of_second.nearer && !of_second.farther) {
    ++counts_.coplanar;
    return projected_.ties().is_above(second_.facet, first_.facet) ? Overlap::first_behind : Overlap::second_behind;
  }
  if (of_second.nearer != of_second.farther) {
    ++counts_.first_planes;
    return of_second.nearer ? Overlap::second_behind : Overlap::first_behind;
  }
  prepare_plane(second_);
  const Sides of_first = sides(second_, first_);
  if (of_first.nearer == of_first.farther) return std::nullopt;
  ++counts_.second_planes;
  return of_first.nearer ? Overlap::first_behind : Overlap::second_behind;
}

}  // namespace hsr::internal
