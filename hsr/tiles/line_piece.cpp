#include "hsr/tiles/line_piece.h"

#include <algorithm>

#include "geometry/error.h"

namespace hsr::internal {

namespace {

enum class Named : std::uint8_t { nothing, triangle, point, points };

Named named_by(Cut::Kind kind) {
  switch (kind) {
    case Cut::Kind::face:
    case Cut::Kind::near_line:
      return Named::triangle;
    case Cut::Kind::sight:
    case Cut::Kind::line:
    case Cut::Kind::near_line_end:
      return Named::points;
    case Cut::Kind::sight_of_vertex:
    case Cut::Kind::across:
      return Named::point;
    case Cut::Kind::fold:
      throw PreconditionError("tiles: a view of several sections has cells of its own");
    case Cut::Kind::start:
    case Cut::Kind::end:
    case Cut::Kind::near:
      break;
  }
  return Named::nothing;
}

std::uint32_t place(const std::vector<std::uint32_t>& numbers, std::uint32_t number, const char* what) {
  const auto at = std::lower_bound(numbers.begin(), numbers.end(), number);
  if (at == numbers.end() || *at != number)
    throw InputError(std::string(what) + " " + std::to_string(number) +
                     ": not found in the part that names it, expected a part that is whole");
  return static_cast<std::uint32_t>(at - numbers.begin());
}

}  // namespace

NamedTriangle Names::name(TriangleId t) const {
  const FaceId face = mesh_.face_of[t];
  return {part_.faces[face.value], t.value - mesh_.first_triangle[face]};
}

NamedCut Names::name(const Cut& cut) const {
  NamedCut name{cut.kind, cut.axis, 0, 0};
  if (is_side(cut)) {
    name.u = no_number;
    name.v = (cut.u - first_side_point_) / 2;
    return name;
  }
  const Named by = named_by(cut.kind);
  if (by == Named::triangle) {
    const NamedTriangle t = this->name(TriangleId(cut.u));
    name.u = t.triangle;
    name.v = t.face;
  }
  if (by == Named::point || by == Named::points) name.u = number(VertexId(cut.u));
  if (by == Named::points) name.v = number(VertexId(cut.v));
  return name;
}

std::uint32_t Names::checked_side(std::uint32_t k) const {
  const std::size_t sides = (mesh_.points.size() - first_side_point_) / 2;
  if (k >= sides)
    throw InputError("side " + std::to_string(k) + " of tiles: found in a part, expected one of the " + std::to_string(sides) +
                     " of its job");
  return k;
}

VertexId Names::vertex(std::uint32_t number) const { return VertexId(place(part_.points, number, "point")); }

TriangleId Names::triangle(const NamedTriangle& name) const {
  const FaceId face(place(part_.faces, name.face, "face"));
  const std::uint32_t first = mesh_.first_triangle[face], end = mesh_.first_triangle[FaceId(face.value + 1U)];
  if (name.triangle >= end - first)
    throw InputError("face " + std::to_string(name.face) +
                     ": found with fewer triangles than its part names, expected a part of this model");
  return TriangleId(first + name.triangle);
}

Cut Names::cut(const NamedCut& name) const {
  if (name.is_side()) return side(checked_side(name.v));
  Cut cut{name.kind, name.axis, 0, 0};
  const Named by = named_by(name.kind);
  if (by == Named::triangle) cut.u = triangle({name.v, name.u}).value;
  if (by == Named::point || by == Named::points) cut.u = vertex(name.u).value;
  if (by == Named::points) cut.v = vertex(name.v).value;
  return cut;
}

}  // namespace hsr::internal
