#include "hsr/joined_models.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "geometry/error.h"
#include "geometry/index.h"
#include "geometry/number.h"

namespace hsr::internal {

namespace {

constexpr std::uint32_t none = 0xffffffffU;

/// Millimetres in a unit; in doubles an inch would not be exact.
Rational millimetres(const std::string& unit) {
  if (unit == "mm") return 1.0;
  if (unit == "cm") return 10.0;
  if (unit == "m") return 1000.0;
  if (unit == "in") return Rational(127.0) / Rational(5.0);
  throw InputError("unit: found \"" + unit + "\", expected mm, cm, m or in");
}

std::string file_name(const Model& model) { return std::filesystem::path(model.name).filename().string(); }

/// The number in the other unit; nothing if no double is exactly that.
std::optional<double> converted(double x, const Rational& factor) {
  const Rational exact = Rational(x) * factor;
  const double rounded = exact.to_double();
  if (!std::isfinite(rounded) || Rational(rounded) != exact) return {};
  return rounded;
}

/// The first coordinate of the model that does not convert.
struct Inexact {
  std::size_t point = 0;
  double coordinate = 0;
};
std::optional<Inexact> first_inexact(const ModelToJoin& part, const std::string& unit) {
  if (part.unit == unit) return {};
  const Rational factor = millimetres(part.unit) / millimetres(unit);
  for (std::size_t k = 0; k < part.model.points.size(); ++k)
    for (int axis = 0; axis < 3; ++axis)
      if (!converted(part.model.points[k][axis], factor)) return Inexact{k, part.model.points[k][axis]};
  return {};
}

std::string common_unit(const std::vector<ModelToJoin>& models) {
  for (const ModelToJoin& candidate : models)
    if (std::none_of(models.begin(), models.end(),
                     [&](const ModelToJoin& part) { return first_inexact(part, candidate.unit).has_value(); }))
      return candidate.unit;
  const std::string& unit = models.front().unit;
  for (const ModelToJoin& part : models)
    if (const auto found = first_inexact(part, unit)) {
      std::array<char, 32> number;
      std::snprintf(number.data(), number.size(), "%.17g", found->coordinate);
      throw InputError(part.model.name + ": point " + std::to_string(found->point) + ": found " + number.data() + " " +
                       part.unit + ", which is no double in " + unit + ", the unit of " + models.front().model.name +
                       "; expected models that convert exactly, or --unit for what holds for all");
    }
  throw InvariantError("joined: no unit, and no coordinate that does not convert");
}

/// From one up axis to the other.
Point3 turned(const Point3& p, bool to_y_up) { return to_y_up ? Point3{p.x, p.z, 0 - p.y} : Point3{p.x, 0 - p.z, p.y}; }

void convert(ModelToJoin& part, const std::string& unit, bool is_y_up) {
  if (part.unit != unit) {
    const Rational factor = millimetres(part.unit) / millimetres(unit);
    for (Point3& p : part.model.points) p = {*converted(p.x, factor), *converted(p.y, factor), *converted(p.z, factor)};
  }
  if (part.is_y_up == is_y_up) return;
  for (Point3& p : part.model.points) p = turned(p, is_y_up);
}

/// The surfaces and circles likewise; they decide nothing, and are rounded where they are no doubles.
void convert_shapes(ModelToJoin& part, const std::string& unit, bool is_y_up) {
  const Rational factor = millimetres(part.unit) / millimetres(unit);
  const auto scaled = [&](double x) { return part.unit == unit ? x : (Rational(x) * factor).to_double(); };
  const auto place = [&](const Point3& p) {
    const Point3 q = {scaled(p.x), scaled(p.y), scaled(p.z)};
    return part.is_y_up == is_y_up ? q : turned(q, is_y_up);
  };
  const auto direction = [&](const Point3& d) { return part.is_y_up == is_y_up ? d : turned(d, is_y_up); };
  for (KnownSurface& s : part.model.surfaces) s = {s.kind, place(s.point), direction(s.direction), scaled(s.radius)};
  for (KnownCircle& c : part.model.circles) c = {place(c.centre), direction(c.axis), scaled(c.radius)};
}

/// The cameras in the coordinates of all. A viewpoint is rounded where it is no double there.
void convert_cameras(ModelToJoin& part, const std::string& unit, bool is_y_up) {
  const Rational factor = millimetres(part.unit) / millimetres(unit);
  const auto scaled = [&](double x) { return part.unit == unit ? x : (Rational(x) * factor).to_double(); };
  for (StoredCamera& c : part.model.cameras) {
    c.position = {scaled(c.position.x), scaled(c.position.y), scaled(c.position.z)};
    if (c.near) c.near = scaled(*c.near);
    if (part.is_y_up == is_y_up) continue;
    for (Point3* p : {&c.position, &c.direction, &c.up}) *p = turned(*p, is_y_up);
  }
}

/// Names of objects for each model: those of its file, or the file's own name.
std::vector<std::vector<std::string>> object_names(const std::vector<ModelToJoin>& models) {
  std::vector<std::vector<std::string>> names;
  std::map<std::string, std::size_t> models_with;
  for (const ModelToJoin& part : models) {
    std::vector<std::string> own = part.model.objects;
    if (own.empty()) own.emplace_back();
    for (std::string& name : own)
      if (name.empty()) name = file_name(part.model);
    for (const std::string& name : std::set<std::string>(own.begin(), own.end())) ++models_with[name];
    names.push_back(std::move(own));
  }
  std::set<std::string> taken;
  for (std::size_t m = 0; m < models.size(); ++m) {
    std::map<std::string, std::string> renamed;  // within a model one name is one object
    for (std::string& name : names[m]) {
      const auto [at, is_new] = renamed.try_emplace(name, name);
      if (is_new) {
        if (models_with[name] > 1) at->second = file_name(models[m].model) + ":" + name;
        const std::string wanted = at->second;
        for (int k = 2; !taken.insert(at->second).second; ++k) at->second = wanted + "#" + std::to_string(k);
      }
      name = at->second;
    }
  }
  return names;
}

class Joiner {
 public:
  /// @param objects the names of its objects
  void add(const Model& part, std::vector<std::string> objects) {
    const std::size_t faces_before = all_.polygons.size(), faces = part.polygons.size();
    check_countable(all_.points.size() + part.points.size(), "points");
    check_countable(all_.polygons.corners.size() + part.polygons.corners.size(), "corners");
    check_countable(faces_before + faces, "faces");
    add_geometry(part);
    const auto first_object = static_cast<std::uint32_t>(all_.objects.size());
    for (std::string& name : objects) all_.objects.push_back(std::move(name));
    const auto append_objects = [&](std::vector<std::uint32_t>& all, const std::vector<std::uint32_t>& own, std::size_t count) {
      for (std::size_t k = 0; k < count; ++k) {
        const std::uint32_t object = !own.empty() ? own[k] : part.objects.empty() ? 0 : none;
        all.push_back(object == none ? none : first_object + object);
      }
    };
    append_objects(all_.face_object, part.face_object, faces);
    append_objects(all_.segment_object, part.segment_object, part.polygons.segments.size());
    const auto first_colour = static_cast<std::uint32_t>(all_.palette.size());
    all_.palette.insert(all_.palette.end(), part.palette.begin(), part.palette.end());
    append(all_.face_colour, part.face_colour, faces_before, faces, [&](std::uint32_t c) { return first_colour + c; });
    append(all_.face_material, part.face_material, faces_before, faces,
           [&](std::uint32_t m) { return number_of_material(part.materials[m]); });
    add_surfaces(part, faces_before, first_object);
    const std::string name = file_name(part);
    for (StoredCamera camera : part.cameras) {
      const auto is_taken = [&](const StoredCamera& c) { return c.name == camera.name; };
      if (std::any_of(all_.cameras.begin(), all_.cameras.end(), is_taken)) camera.name = name + ":" + camera.name;
      if (std::none_of(all_.cameras.begin(), all_.cameras.end(), is_taken)) all_.cameras.push_back(std::move(camera));
    }
    for (const std::string& note : part.notes) all_.notes.push_back(name + ": " + note);
    all_.name += (all_.name.empty() ? "" : " + ") + name;
    all_.format += (all_.format.empty() ? "" : " + ") + part.format;
  }
  Model take() { return std::move(all_); }

 private:
  void add_geometry(const Model& part) {
    const auto first_point = static_cast<std::uint32_t>(all_.points.size());
    const auto first_corner = static_cast<std::uint32_t>(all_.polygons.corners.size());
    all_.points.insert(all_.points.end(), part.points.begin(), part.points.end());
    for (const std::uint32_t c : part.polygons.corners) all_.polygons.corners.push_back(first_point + c);
    for (std::size_t f = 0; f < part.polygons.size(); ++f)
      all_.polygons.first.push_back(first_corner + part.polygons.first[f + 1]);
    for (const auto& [a, b] : part.polygons.segments) all_.polygons.segments.push_back({first_point + a, first_point + b});
  }
  /// What is known of its surfaces and edges. @pre its geometry has been added
  void add_surfaces(const Model& part, std::size_t faces_before, std::uint32_t first_object) {
    const std::uint32_t first_surface = surfaces_;
    append(all_.face_surface, part.face_surface, faces_before, part.polygons.size(),
           [&](std::uint32_t s) { return first_surface + s; });
    for (const std::uint32_t s : part.face_surface)
      if (s != none) surfaces_ = std::max(surfaces_, first_surface + s + 1);
    surfaces_ = std::max(surfaces_, first_surface + static_cast<std::uint32_t>(part.surfaces.size()));
    if (!part.surfaces.empty()) all_.surfaces.resize(first_surface);
    all_.surfaces.insert(all_.surfaces.end(), part.surfaces.begin(), part.surfaces.end());
    const auto first_point = static_cast<std::uint32_t>(all_.points.size() - part.points.size());
    const auto first_circle = static_cast<std::uint32_t>(all_.circles.size());
    for (MarkedEdge mark : part.marks) {
      for (std::uint32_t& p : mark.points) p += first_point;
      if (mark.object != none) mark.object += first_object;
      if (mark.circle != none) mark.circle += first_circle;
      all_.marks.push_back(mark);
    }
    all_.circles.insert(all_.circles.end(), part.circles.begin(), part.circles.end());
  }
  /// By face: what this model says, `none` for the faces before if it is the first to say anything, and after it if others did.
  template <class Number>
  static void append(std::vector<std::uint32_t>& all, const std::vector<std::uint32_t>& of_part, std::size_t before,
                     std::size_t faces, const Number& number) {
    if (of_part.empty() && all.empty()) return;
    all.resize(before, none);
    for (std::size_t f = 0; f < faces; ++f) all.push_back(of_part.empty() || of_part[f] == none ? none : number(of_part[f]));
  }
  std::uint32_t number_of_material(const std::string& name) {
    const auto [at, is_new] = materials_.try_emplace(name, static_cast<std::uint32_t>(all_.materials.size()));
    if (is_new) all_.materials.push_back(name);
    return at->second;
  }

  Model all_;
  std::uint32_t surfaces_ = 0;  // how many numbers of surfaces are in use
  std::map<std::string, std::uint32_t> materials_;
};

}  // namespace

JoinedModels joined(std::vector<ModelToJoin> models) {
  require(!models.empty(), "joined: no model");
  for (const ModelToJoin& part : models) static_cast<void>(millimetres(part.unit));
  if (models.size() == 1) return {std::move(models.front().model), models.front().unit, models.front().is_y_up};
  const std::string unit = common_unit(models);
  const bool is_y_up = models.front().is_y_up;
  const bool says_unit =
      std::any_of(models.begin(), models.end(), [](const auto& part) { return part.model.unit.has_value(); });
  std::vector<std::vector<std::string>> objects = object_names(models);
  Joiner joiner;
  for (std::size_t m = 0; m < models.size(); ++m) {
    convert(models[m], unit, is_y_up);
    convert_cameras(models[m], unit, is_y_up);
    convert_shapes(models[m], unit, is_y_up);
    joiner.add(models[m].model, std::move(objects[m]));
    models[m].model = {};
  }
  Model all = joiner.take();
  if (says_unit) all.unit = millimetres(unit).to_double();
  if (is_y_up) all.up_axis = 'y';
  return {std::move(all), unit, is_y_up};
}

}  // namespace hsr::internal
