#include "python/src/scene_data.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <memory>
#include <string_view>

#include "geometry/error.h"
#include "hsr/cli/model_file.h"
#include "hsr/io/read/read.h"
#include "hsr/object_selection.h"
#include "python/src/arrays.h"
#include "python/src/work.h"

namespace hsr::python {

namespace {

using Doubles = py::array_t<double, py::array::c_style>;
using Numbers32 = py::array_t<std::uint32_t, py::array::c_style>;

std::vector<Point3> points_of(const Doubles& points) {
  std::vector<Point3> all(static_cast<std::size_t>(points.shape(0)));
  const double* x = points.data();
  for (Point3& p : all) {
    p = {x[0], x[1], x[2]};
    x += 3;
  }
  return all;
}

/// @pre shapes and types are those that hsr/_scene.py makes
std::shared_ptr<SceneData> from_arrays(const Doubles& points, const Numbers32& corners, const Numbers32& first,
                                       const Numbers32& wires) {
  Model model;
  model.format = "arrays";
  model.points = points_of(points);
  model.polygons.corners.assign(corners.data(), corners.data() + corners.size());
  model.polygons.first.assign(first.data(), first.data() + first.size());
  for (py::ssize_t i = 0; i < wires.shape(0); ++i) model.polygons.segments.push_back({wires.at(i, 0), wires.at(i, 1)});
  return std::make_shared<SceneData>(std::move(model));
}

/// The entries of a list by face, those of one more model behind them; a model without any has none for its faces.
void append(std::vector<std::uint32_t>& all, std::size_t faces_before, const std::vector<std::uint32_t>& more,
            std::size_t faces, std::size_t names_before) {
  if (all.empty() && more.empty()) return;
  all.resize(faces_before, 0xffffffffU);
  for (const std::uint32_t name : more)
    all.push_back(name == 0xffffffffU ? name : name + static_cast<std::uint32_t>(names_before));
  all.resize(faces_before + faces, 0xffffffffU);
}

template <class T>
void append(std::vector<T>& all, const std::vector<T>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

void append(Polygons& all, const Polygons& more, std::size_t points_before) {
  const auto moved = [&](std::uint32_t v) { return v + static_cast<std::uint32_t>(points_before); };
  const auto corners_before = static_cast<std::uint32_t>(all.corners.size());
  for (const std::uint32_t v : more.corners) all.corners.push_back(moved(v));
  for (std::size_t f = 0; f < more.size(); ++f) all.first.push_back(corners_before + more.first[f + 1]);
  for (const auto& s : more.segments) all.segments.push_back({moved(s[0]), moved(s[1])});
  if (all.is_ghost.empty() && more.is_ghost.empty()) return;
  all.is_ghost.resize(all.size() - more.size(), 0);
  append(all.is_ghost, more.is_ghost);
  all.is_ghost.resize(all.size(), 0);
}

/// What is known of the surfaces and edges of one more model, which is an object of its own. @pre its points are not there yet
void add_marks(Model& all, const Model& m, std::size_t faces_before, std::uint32_t object) {
  std::size_t surfaces = 0;
  for (const std::uint32_t s : all.face_surface)
    if (s != FaceLabels::none) surfaces = std::max<std::size_t>(surfaces, s + std::size_t{1});
  append(all.face_surface, faces_before, m.face_surface, m.polygons.size(), surfaces);
  for (MarkedEdge mark : m.marks) {
    for (std::uint32_t& p : mark.points) p += static_cast<std::uint32_t>(all.points.size());
    mark.object = object;
    if (mark.circle != FaceLabels::none) mark.circle += static_cast<std::uint32_t>(all.circles.size());
    all.marks.push_back(mark);
  }
  append(all.circles, m.circles);
}

/// Several models as one: each is an object of it, named by its number.
std::shared_ptr<SceneData> joined(const std::vector<std::shared_ptr<SceneData>>& parts) {
  Model all;
  all.format = "several";
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const Model& m = parts[k]->model();
    check_countable(all.points.size() + m.points.size(), "points");
    check_countable(all.polygons.corners.size() + m.polygons.corners.size(), "corners");
    const std::size_t faces = all.polygons.size();
    append(all.face_colour, faces, m.face_colour, m.polygons.size(), all.palette.size());
    append(all.face_material, faces, m.face_material, m.polygons.size(), all.materials.size());
    add_marks(all, m, faces, static_cast<std::uint32_t>(k));
    append(all.palette, m.palette);
    append(all.materials, m.materials);
    append(all.polygons, m.polygons, all.points.size());
    append(all.points, m.points);
    append(all.notes, m.notes);
    append(all.cameras, m.cameras);
    all.objects.push_back(std::to_string(k));
    all.face_object.resize(all.polygons.size(), static_cast<std::uint32_t>(k));
    all.segment_object.resize(all.polygons.segments.size(), static_cast<std::uint32_t>(k));
    if (k == 0 || all.up_axis == m.up_axis) all.up_axis = m.up_axis;
    if (k == 0 || all.unit == m.unit) all.unit = m.unit;
  }
  return std::make_shared<SceneData>(std::move(all));
}

/// Without the objects that are not wanted, and with ghosts.
std::shared_ptr<SceneData> selected(const std::shared_ptr<SceneData>& data, const std::vector<std::string>& only,
                                    const std::vector<std::string>& hide, const std::vector<std::string>& ghost) {
  Model model = data->model();
  internal::select(model, {only, hide, ghost});
  return std::make_shared<SceneData>(std::move(model));
}

/// @param chord of STEP and IGES, in units of the model; 0: fine enough for a page
std::shared_ptr<SceneData> read(const std::string& path, double chord) {
  std::shared_ptr<SceneData> data;
  run({{}, py::none()}, [&](const Ticket&) {
    cli::ModelFile file = cli::ModelFile::read(path);
    if (!file.has_surfaces())
      data = std::make_shared<SceneData>(file.take());
    else
      data = std::make_shared<SceneData>(chord > 0 ? file.model(chord) : file.fine_model());
  });
  return data;
}

/// With what a file of marks says.
std::shared_ptr<SceneData> marked(const std::shared_ptr<SceneData>& data, const std::string& path) {
  Model model = data->model();
  run({{}, py::none()}, [&](const Ticket&) { read_marks(path, model); });
  return std::make_shared<SceneData>(std::move(model));
}

py::tuple arrays_of(const SceneData& data) {
  const Model& m = data.model();
  std::vector<double> points;
  points.reserve(3 * m.points.size());
  for (const Point3& p : m.points) points.insert(points.end(), {p.x, p.y, p.z});
  return py::make_tuple(array_of(std::move(points), {static_cast<py::ssize_t>(m.points.size()), 3}),
                        array_of(std::vector<std::uint32_t>(m.polygons.corners)),
                        array_of(std::vector<std::uint32_t>(m.polygons.first)));
}

}  // namespace

Scene SceneData::scene(double tolerance) {
  if (tolerance > 0) return Scene(make_mesh(model_.points, model_.polygons, tolerance), labels_of(model_));
  const std::scoped_lock lock(mutex_);
  if (!exact_) exact_.emplace(make_mesh(model_.points, model_.polygons), labels_of(model_));
  return *exact_;
}

cli::ViewOptions view_options(const py::dict& view) {
  cli::ViewOptions o;
  const auto text = [&](const char* name, std::string& value) {
    if (view.contains(name)) value = view[name].cast<std::string>();
  };
  text("name", o.name);
  text("eye", o.eye);
  text("target", o.target);
  text("direction", o.direction);
  text("up", o.up);
  text("oblique", o.oblique);
  if (view.contains("sections")) o.sections = view["sections"].cast<std::vector<std::string>>();
  text("up_axis", o.up_axis);
  if (view.contains("fov")) o.field_of_view = view["fov"].cast<double>();
  if (view.contains("depth")) o.depth = view["depth"].cast<double>();
  if (view.contains("near")) o.near = view["near"].cast<double>();
  return o;
}

SceneView prepared(SceneData& data, const cli::ViewOptions& view, const SceneOptions& options) {
  const Scene scene = data.scene();
  return {scene, cli::choose_view(view, scene.mesh(), data.model()).view, options};
}

void add_scene(py::module_& module) {
  py::class_<SceneData, std::shared_ptr<SceneData>>(module, "SceneData")
      .def("arrays", &arrays_of)
      .def_property_readonly("name", [](const SceneData& d) { return d.model().name; })
      .def_property_readonly("format", [](const SceneData& d) { return d.model().format; })
      .def_property_readonly("notes", [](const SceneData& d) { return d.model().notes; })
      .def_property_readonly("objects", [](const SceneData& d) { return d.model().objects; });
  module.def("read", &read);
  module.def("marked", &marked);
  module.def("from_arrays", &from_arrays);
  module.def("joined", &joined);
  module.def("selected", &selected);
}

}  // namespace hsr::python
