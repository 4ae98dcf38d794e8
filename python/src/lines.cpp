#include "python/src/lines.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <memory>

#include "geometry/error.h"
#include "hsr/coordinates/coordinates.h"
#include "hsr/drawing/cut_parameter.h"
#include "hsr/io/write/json.h"
#include "hsr/lines/hidden_points.h"
#include "python/src/arguments.h"
#include "python/src/arrays.h"

namespace hsr::python {

using namespace internal;

namespace {

/// Visible and hidden parts, and the scene that they are of.
class LinesData {
 public:
  LinesData(SceneView scene, VisibleLines lines) : scene_(std::move(scene)), lines_(std::move(lines)) {
    segments_ = segments(scene_, lines_);
    parameters_.resize(2 * segments_.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, segments_.size(), 64), [&](const auto& range) {
      for (std::size_t i = range.begin(); i != range.end(); ++i)
        for (std::uint32_t end = 0; end < 2; ++end) parameters_[2 * i + end] = parameter(i, end);
    });
  }

  py::dict arrays();
  py::array occluders(std::size_t i) const;
  /// Of an end: x, y, z and t, "p/q" each.
  std::vector<std::string> exact_end(std::size_t i, std::uint32_t end) const;
  std::string json(bool exact) const {
    return lines_json(scene_.mesh(), scene_.view(), lines_, {exact ? Numbers::exact : Numbers::rounded, nullptr, false});
  }

 private:
  const Line& line_of(std::size_t i) const { return lines_.lines[segments_[i].line]; }
  const Cut& cut(std::size_t i, std::uint32_t end) const { return lines_.cuts_of(line_of(i))[segments_[i].interval + end]; }
  double parameter(std::size_t i, std::uint32_t end) const {
    return rounded_parameter(scene_.mesh(), scene_.view(), supporting_line_of(scene_.mesh(), lines_, line_of(i)), cut(i, end));
  }
  const Segment& at(std::size_t i) const {
    require(i < segments_.size(), "the number of a part is from 0 to less than their count");
    return segments_[i];
  }

  SceneView scene_;
  VisibleLines lines_;
  std::vector<Segment> segments_;
  std::vector<double> parameters_;
};

py::dict LinesData::arrays() {
  const auto n = static_cast<py::ssize_t>(segments_.size());
  std::vector<std::int64_t> edge;
  std::vector<std::uint8_t> edge_class, visible, behind;
  std::vector<std::int64_t> faces, first = {0}, line;
  std::vector<double> points, image;
  for (const Segment& s : segments_) {
    for (const VertexId v : {s.a, s.b}) edge.push_back(v.is_valid() ? std::int64_t{v.value} : -1);
    edge_class.push_back(static_cast<std::uint8_t>(s.edge_class));
    visible.push_back(s.is_hidden ? 0 : 1);
    behind.push_back(s.is_behind ? 1 : 0);
    for (const FaceId f : s.faces) faces.push_back(f.value);
    first.push_back(static_cast<std::int64_t>(faces.size()));
    line.push_back(s.line);
    for (const PlacedPoint* p : {&s.from, &s.to}) {
      points.insert(points.end(), {p->space.x, p->space.y, p->space.z});
      image.insert(image.end(), {p->paper.x, p->paper.y});
    }
  }
  py::dict all;
  all["edge"] = array_of(std::move(edge), {n, 2});
  all["edge_class"] = array_of(std::move(edge_class));
  all["visible"] = bool_array(visible);
  all["behind"] = bool_array(behind);
  all["faces"] = array_of(std::move(faces));
  all["faces_offsets"] = array_of(std::move(first));
  all["line"] = array_of(std::move(line));
  all["t"] = array_of(std::vector<double>(parameters_), {n, 2});
  all["points"] = array_of(std::move(points), {n, 2, 3});
  all["image"] = array_of(std::move(image), {n, 2, 2});
  return all;
}

py::array LinesData::occluders(std::size_t i) const {
  const Segment& segment = at(i);
  std::vector<std::int64_t> faces;
  {
    const py::gil_scoped_release release;
    for (const FaceId f : hsr::occluders_of(scene_, lines_, segment)) faces.push_back(f.value);
  }
  return array_of(std::move(faces));
}

std::vector<std::string> LinesData::exact_end(std::size_t i, std::uint32_t end) const {
  const Segment& segment = at(i);
  const Line& line = line_of(i);
  const SupportingLine support = supporting_line_of(scene_.mesh(), lines_, line);
  std::vector<std::string> all;
  for (const Rational& x : exact_point(scene_, lines_, line, segment.interval + end)) all.push_back(x.to_string());
  all.push_back(exact_parameter(scene_.mesh(), scene_.view(), support, cut(i, end)).to_string());
  return all;
}

std::shared_ptr<LinesData> find_lines(const std::shared_ptr<SceneData>& data, const py::dict& named) {
  const Arguments arguments(named);
  const cli::ViewOptions view = arguments.view();
  LineOptions options = arguments.lines().options();
  SceneOptions scene_options;
  scene_options.coplanar = arguments.scene().which_coplanar();
  std::shared_ptr<LinesData> found;
  run(arguments.control(), [&](const Ticket& ticket) {
    options.progress = ticket.progress;
    options.stop = ticket.stop;
    const Scene scene = data->scene(options.tolerance);
    const SceneView prepared(scene, cli::choose_view(view, scene.mesh(), data->model()).view, scene_options);
    found = std::make_shared<LinesData>(prepared, visible_lines(prepared, options));
  });
  return found;
}

using Doubles = py::array_t<double, py::array::c_style>;

/// In blocks, so that Ctrl-C is heard.
py::array find_hidden(const std::shared_ptr<SceneData>& data, const Doubles& points, const py::dict& named) {
  const Arguments arguments(named);
  const cli::ViewOptions view = arguments.view();
  const auto n = static_cast<std::size_t>(points.shape(0));
  std::vector<Point3> all(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double* x = points.data() + 3 * i;
    all[i] = {x[0], x[1], x[2]};
  }
  std::vector<std::uint8_t> hidden;
  run(arguments.control(), [&](const Ticket& ticket) {
    const SceneView scene = prepared(*data, view, {});
    constexpr std::size_t block = 1U << 16U;
    for (std::size_t i = 0; i < n; i += block) {
      ticket.check();
      for (const bool is_hidden : hidden_points(scene, std::span(all).subspan(i, std::min(block, n - i))))
        hidden.push_back(is_hidden ? 1 : 0);
      ticket.progress(static_cast<double>(hidden.size()) / static_cast<double>(n));
    }
  });
  return bool_array(hidden);
}

}  // namespace

void add_lines(py::module_& module) {
  py::class_<LinesData, std::shared_ptr<LinesData>>(module, "LinesData")
      .def("arrays", &LinesData::arrays)
      .def("occluders", &LinesData::occluders)
      .def("exact_end", &LinesData::exact_end)
      .def("json", &LinesData::json);
  module.def("visible_lines", &find_lines);
  py::list names;
  for (const char* name : edge_class_names) names.append(name);
  module.attr("edge_class_names") = py::tuple(names);
}

void add_hidden_points(py::module_& module) { module.def("hidden", &find_hidden); }

}  // namespace hsr::python
