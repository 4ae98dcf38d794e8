#include "hsr/cli/stored_camera.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "geometry/error.h"

namespace hsr::cli {

namespace {

constexpr std::string_view prefix = "camera:";

const StoredCamera& camera_of(const Model& model, const std::string& view) {
  const std::string name = view.substr(prefix.size());
  const auto at =
      std::find_if(model.cameras.begin(), model.cameras.end(), [&](const StoredCamera& c) { return c.name == name; });
  if (at != model.cameras.end()) return *at;
  if (model.cameras.empty())
    throw InputError(fmt::format("--view: found \"{}\", expected another view: the model has no cameras", view));
  std::string names;
  for (const StoredCamera& c : model.cameras) names += (names.empty() ? "" : ", ") + fmt::format("\"{}{}\"", prefix, c.name);
  throw InputError(fmt::format("--view: found \"{}\", expected a camera of the model: {}", view, names));
}

double degrees_across_shorter_side(const StoredCamera& camera) {
  const double vertical = *camera.field_of_view, aspect = camera.aspect_ratio.value_or(1);
  if (aspect >= 1) return vertical;
  return 2 * std::atan(aspect * std::tan(vertical * (std::numbers::pi / 360))) * (180 / std::numbers::pi);
}

Point3 looked_at(const StoredCamera& camera, const Mesh& mesh) {
  const Point3 &e = camera.position, &d = camera.direction, c = centre(mesh);
  const double length = std::hypot(d.x, d.y, d.z);
  const Point3 unit = {d.x / length, d.y / length, d.z / length};
  const double ahead = (c.x - e.x) * unit.x + (c.y - e.y) * unit.y + (c.z - e.z) * unit.z;
  const double far = ahead > 0 && std::isfinite(ahead) ? ahead : 1;
  return {e.x + far * unit.x, e.y + far * unit.y, e.z + far * unit.z};
}

}  // namespace

bool names_camera(const std::string& view) { return view.starts_with(prefix); }

ChosenView view_through_camera(const ViewOptions& o, const Mesh& mesh, const Model& model) {
  const StoredCamera& camera = camera_of(model, o.name);
  if (!o.target.empty())
    throw InputError(
        "view: found --target with a camera, expected it with --eye or another view: a camera knows where it looks");
  const Point3 up = o.up.empty() ? camera.up : parse_point("--up", o.up);
  ChosenView chosen;
  chosen.title = o.name;
  if (camera.field_of_view) {
    chosen.view = perspective_view(camera.position, looked_at(camera, mesh), up, o.near ? o.near : camera.near);
    chosen.field_of_view = o.field_of_view ? o.field_of_view : degrees_across_shorter_side(camera);
    return chosen;
  }
  if (o.near || o.field_of_view)
    throw InputError("view: found --near or --fov with a camera of a parallel view, expected them in perspective only");
  const Point3& d = camera.direction;
  chosen.view = parallel_view({0 - d.x, 0 - d.y, 0 - d.z}, up, centre(mesh));
  return chosen;
}

}  // namespace hsr::cli
