#include "hsr/step/part_builder.h"

#include <algorithm>
#include <cmath>
#include <gp_Dir.hxx>
#include <gp_Trsf.hxx>

#include "geometry/error.h"
#include "geometry/index.h"

namespace hsr::internal {

namespace {

constexpr std::uint32_t none = 0xffffffffU;

Point3 placed(const Point3& p, const gp_Trsf& at) {
  const gp_Pnt q = gp_Pnt(p.x, p.y, p.z).Transformed(at);
  return {q.X(), q.Y(), q.Z()};
}

/// A direction, which may be none.
Point3 turned(const Point3& d, const gp_Trsf& at) {
  if (d.x == 0 && d.y == 0 && d.z == 0) return d;
  const gp_Dir q = gp_Dir(d.x, d.y, d.z).Transformed(at);
  return {q.X(), q.Y(), q.Z()};
}

/// Rounds points to multiples of a power of two, 2^-36 to 2^-37 of the largest coordinate. Open CASCADE computes the same coordinate of
/// two points, such as those of a wall above one another, with errors in the last places: then a wall is upright again.
void round_to_grid(std::vector<Point3>& points) {
  constexpr int kept_bits = 36;
  double most = 0;
  for (const Point3& p : points) most = std::max({most, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  if (!(most > 0) || !std::isfinite(most)) return;
  const double grid = std::ldexp(1.0, std::ilogb(most) - kept_bits);
  for (Point3& p : points) p = {std::round(p.x / grid) * grid, std::round(p.y / grid) * grid, std::round(p.z / grid) * grid};
}

}  // namespace

PartBuilder::PartBuilder(const std::string& path, const std::string& format) {
  model_.name = path;
  model_.format = format;
}

void PartBuilder::add(const PlacedShape& part, const DefinedShape& definition, const ShapeMesh& mesh) {
  if (!part.location.IsIdentity()) is_rounded_ = true;
  faces_without_mesh_ += mesh.faces_without_mesh;
  check_countable(model_.points.size() + mesh.points.size(), "points");
  check_countable(model_.polygons.corners.size() + 3 * mesh.triangles.size(), "corners");
  add_known_shapes(part, mesh);
  add_colours(part, definition, mesh);
  add_geometry(part, mesh);
}

void PartBuilder::add_geometry(const PlacedShape& part, const ShapeMesh& mesh) {
  const auto first_point = static_cast<std::uint32_t>(model_.points.size());
  const auto object = static_cast<std::uint32_t>(model_.objects.size());
  model_.objects.push_back(part.name);
  const gp_Trsf& at = part.location.Transformation();
  for (const gp_Pnt& p : mesh.points) model_.points.push_back(placed({p.X(), p.Y(), p.Z()}, at));
  for (const auto& corners : mesh.triangles) {
    for (const std::uint32_t c : corners) model_.polygons.corners.push_back(first_point + c);
    model_.polygons.first.push_back(static_cast<std::uint32_t>(model_.polygons.corners.size()));
  }
  for (const auto& [a, b] : mesh.segments) model_.polygons.segments.push_back({first_point + a, first_point + b});
  model_.face_object.resize(model_.polygons.size(), object);
  model_.segment_object.resize(model_.polygons.segments.size(), object);
}

void PartBuilder::add_known_shapes(const PlacedShape& part, const ShapeMesh& mesh) {
  const gp_Trsf& at = part.location.Transformation();
  const auto first_surface = static_cast<std::uint32_t>(model_.surfaces.size());
  const auto first_circle = static_cast<std::uint32_t>(model_.circles.size());
  const auto first_point = static_cast<std::uint32_t>(model_.points.size());
  for (const std::uint32_t face : mesh.face_of) model_.face_surface.push_back(first_surface + face);
  for (const KnownSurface& s : mesh.faces)
    model_.surfaces.push_back({s.kind, placed(s.point, at), turned(s.direction, at), s.radius});
  for (const KnownCircle& c : mesh.circles) model_.circles.push_back({placed(c.centre, at), turned(c.axis, at), c.radius});
  for (MarkedEdge mark : mesh.marks) {
    for (std::uint32_t& p : mark.points) p += first_point;
    mark.object = static_cast<std::uint32_t>(model_.objects.size());
    if (mark.circle != none) mark.circle += first_circle;
    model_.marks.push_back(mark);
  }
}

void PartBuilder::add_colours(const PlacedShape& part, const DefinedShape& definition, const ShapeMesh& mesh) {
  for (const std::uint32_t face : mesh.face_of) {
    const std::optional<Colour>& own = definition.colours[face];
    const std::optional<Colour>& colour = own ? own : part.colour;
    if (!colour) {
      model_.face_colour.push_back(none);
      continue;
    }
    const auto [at, is_new] = palette_.try_emplace(*colour, static_cast<std::uint32_t>(model_.palette.size()));
    if (is_new) model_.palette.push_back(*colour);
    model_.face_colour.push_back(at->second);
  }
}

Model PartBuilder::finish() {
  if (model_.polygons.size() == 0 && model_.polygons.segments.empty())
    throw InputError(model_.name + ": found no surface and no curve, expected some of which a mesh can be made");
  round_to_grid(model_.points);
  if (model_.palette.empty()) model_.face_colour.clear();
  if (faces_without_mesh_ > 0)
    model_.notes.push_back("faces of which Open CASCADE makes no triangles are left out: " +
                           std::to_string(faces_without_mesh_));
  if (is_rounded_) model_.notes.emplace_back("coordinates of placed parts are rounded to doubles");
  return std::move(model_);
}

}  // namespace hsr::internal
