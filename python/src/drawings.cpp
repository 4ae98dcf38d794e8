#include "python/src/drawings.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>

#include "geometry/error.h"
#include "hsr/cli/coincident_note.h"
#include "hsr/cli/model_section.h"
#include "hsr/cli/outline_only.h"
#include "hsr/cli/page_writing.h"
#include "hsr/cli/scale_text.h"
#include "hsr/drawing/shading.h"
#include "hsr/io/write/json.h"
#include "hsr/lines/overhead.h"
#include "hsr/surfaces/regions.h"
#include "hsr/surfaces/roberts_surfaces.h"
#include "hsr/surfaces/visible_fragments.h"
#include "python/src/arrays.h"
#include "python/src/drawn_page.h"
#include "python/src/errors.h"

namespace hsr::python {

using namespace internal;

namespace {

/// The arguments, each found to be one that can be done.
struct DrawRequest {
  OutputPaths outputs;
  cli::ViewOptions view;
  cli::SceneArguments scene_words;
  cli::PageArguments page;
  SceneOptions scene;
  LineOptions lines;
  DrawingOptions drawing;
  Merge merge = Merge::none;
  Shading shading = Shading::slope;
  bool fill = false, exact = false, outline_only = false, shows_overhead = false;
  std::string id_prefix, dxf_release, arithmetic;
  std::optional<PixelSize> size;

  explicit DrawRequest(const Arguments& a);
};

DrawRequest::DrawRequest(const Arguments& a)
    : outputs(a, std::array{Format::svg, Format::pdf, Format::eps, Format::dxf, Format::tex, Format::hpgl, Format::png,
                            Format::json}),
      view(a.view()),
      scene_words(a.scene()),
      page(a.page()),
      shading(a.shading()),
      fill(a.get<bool>("fill", false)),
      exact(a.get<bool>("exact", false)),
      outline_only(a.get<bool>("outline_only", false)),
      id_prefix(a.get<std::string>("id_prefix", "")),
      dxf_release(a.word("dxf", "r12", {"r12", "2000"})),
      arithmetic(a.word("arithmetic", "staged", {"staged", "double", "interval", "rational"})) {
  const cli::LineArguments line_words = a.lines();
  lines = line_words.options();
  lines.why = a.get<bool>("why", false);
  if (lines.method == LineMethod::appel && lines.why)
    throw InputError("why: appel counts the faces that hide and does not know which they are, expected method roberts or auto");
  scene = line_words.scene_options();
  scene.coplanar = scene_words.which_coplanar();
  scene.arithmetic = cli::arithmetic_named(arithmetic);
  drawing = page.options();
  drawing.arithmetic = scene.arithmetic;
  drawing.hidden = cli::hidden_lines_named(a.word("hidden", "none", {"none", "dashed", "solid"}));
  drawing.leave_out_near = true;
  scene.hidden_lines = lines.why || drawing.hidden != HiddenLines::none || outputs.wants(Format::json);
  shows_overhead = a.word("overhead", "off", {"dashed", "off"}) == "dashed";
  const std::string united = a.word("merge", "none", {"none", "coplanar", "colour"});
  merge = united == "none" ? Merge::none : united == "coplanar" ? Merge::coplanar : Merge::colour;
  drawing.in_frame_units = a.get<bool>("in_frame_units", false);
  if (!page.size.empty()) size = parse_size(page.size);
  check_id_prefix(id_prefix);
  if (!outline_only) return;
  if (outputs.wants(Format::json))
    throw InputError("outline_only: json has lines and no outline, expected svg, pdf, eps, dxf, tex, hpgl or png");
  cli::ask_for_outline_only(lines, drawing);
}

/// The steps of `hsr draw`, in its order.
class Drawer {
 public:
  Drawer(DrawRequest& request, SceneData& data, const Ticket& ticket)
      : request_(request), data_(data), ticket_(ticket), scene_(data.scene(request.lines.tolerance)) {}

  DrawnPage draw();

 private:
  void choose_view();
  void find_lines();
  void add_overhead();
  void find_fragments();
  Drawing placed(const DrawingOptions& options) const;
  void place();

  DrawRequest& request_;
  SceneData& data_;
  const Ticket& ticket_;
  Scene scene_;
  cli::ChosenView chosen_;
  SceneObjects objects_;
  std::optional<SceneView> prepared_;
  std::optional<SceneView> exact_;  // the same, but where arithmetic is compared
  VisibleLines lines_;
  std::optional<VisibleLines> every_line_;
  std::optional<VisibleFragments> fragments_;
  std::optional<Section> section_;
  DrawnPage page_;
};

void Drawer::choose_view() {
  const Model& model = data_.model();
  page_.notes = model.notes;
  chosen_ = cli::choose_view(request_.view, scene_.mesh(), model);
  for (const std::string& note : {chosen_.note, chosen_.up_axis_note})
    if (!note.empty()) page_.notes.push_back(note);
  objects_ = objects_of(model, scene_.mesh());
  request_.drawing.objects = &objects_;
  request_.drawing.labels = &scene_.labels();
  request_.drawing.field_of_view = chosen_.field_of_view;
  if (const std::string note = request_.page.adopt_unit(model, request_.drawing); !note.empty()) page_.notes.push_back(note);
  if (!request_.outputs.wants(Format::json)) request_.lines.frame = frame_size(chosen_.view, request_.drawing);
  request_.lines.progress = ticket_.progress;
  request_.lines.stop = ticket_.stop;
  prepared_.emplace(scene_, chosen_.view, request_.scene);
  exact_ = prepared_;
  if (request_.scene.arithmetic != Arithmetic::staged)
    exact_.emplace(scene_, chosen_.view, SceneOptions{.coplanar = request_.scene.coplanar});
  const std::string note = cli::find_section(model, *prepared_, request_.lines.classes, request_.drawing, section_);
  if (!note.empty()) page_.notes.push_back(note);
}

void Drawer::find_lines() {
  const bool finds_all = (request_.fill || request_.outline_only) && !request_.lines.why &&
                         request_.lines.method != LineMethod::roberts && fragments_use_lines(*prepared_);
  if (!finds_all) {
    lines_ = visible_lines(*prepared_, request_.lines);
    add_overhead();
    return;
  }
  LineOptions every = request_.lines;
  every.classes.fill(true);
  every.diagonals = true;
  every.frame = {};
  every_line_ = visible_lines(*prepared_, every);
  lines_ = lines_of_classes(scene_.mesh(), *every_line_, request_.lines.classes);
  add_overhead();
}

void Drawer::add_overhead() {
  if (request_.shows_overhead) lines_ = with_overhead(*prepared_, request_.lines, std::move(lines_));
}

void Drawer::find_fragments() {
  if (!request_.fill && !request_.outline_only) return;
  FragmentOptions options;
  if (every_line_) options.lines = &*every_line_;
  options.progress = ticket_.progress;
  options.stop = ticket_.stop;
  fragments_ = request_.lines.method == LineMethod::roberts ? roberts_surfaces(*prepared_, options)
                                                            : visible_fragments(*prepared_, options);
  every_line_.reset();
  if (request_.scene_words.asks_for_coplanar()) return;
  const std::string note = cli::coincident_note(*exact_, data_.model(), Coincidence::seen);
  if (!note.empty()) page_.notes.push_back(note);
}

Drawing Drawer::placed(const DrawingOptions& options) const {
  const Mesh& mesh = scene_.mesh();
  if (request_.outline_only) {
    const Regions all = cli::union_of_all(*exact_, *fragments_);
    return hsr::draw(mesh, chosen_.view, lines_, options, &all);
  }
  if (!request_.fill || options.in_frame_units) return hsr::draw(mesh, chosen_.view, lines_, options);
  const Regions regions =
      regions_of(*exact_, *fragments_, face_colours(data_.model(), mesh, chosen_.view, request_.shading), request_.merge);
  return hsr::draw(mesh, chosen_.view, lines_, options, &regions);
}

void Drawer::place() {
  page_.drawing = placed(request_.drawing);
  if (request_.outputs.wants(Format::dxf)) {
    page_.in_model_units = placed(cli::in_model_units(request_.drawing, page_.drawing.scale));
    page_.in_model_units->pens = page_.drawing.pens;
  }
  page_.captions = {std::filesystem::path(data_.model().name).filename().string(), "view: " + chosen_.title,
                    request_.id_prefix};
  page_.scale = cli::scale_in_title(page_.drawing, request_.drawing, request_.page);
  page_.size = request_.size;
  page_.is_in_frame_units = request_.drawing.in_frame_units;
  page_.dxf_release = request_.dxf_release;
  page_.unit = request_.drawing.unit;
  if (request_.outputs.wants(Format::json))
    page_.json = lines_json(scene_.mesh(), chosen_.view, lines_,
                            {request_.exact ? Numbers::exact : Numbers::rounded, request_.fill ? &*fragments_ : nullptr,
                             request_.lines.why, &objects_, request_.drawing.section});
}

DrawnPage Drawer::draw() {
  choose_view();
  find_lines();
  ticket_.check();
  find_fragments();
  ticket_.check();
  place();
  ticket_.check();
  request_.outputs.write(page_);
  for (std::string& note : page_.notes) note = without_dashes(note);
  return std::move(page_);
}

std::shared_ptr<DrawnPage> draw_scene(const std::shared_ptr<SceneData>& data, const py::dict& named) {
  const Arguments arguments(named);
  DrawRequest request(arguments);
  std::shared_ptr<DrawnPage> page;
  run(arguments.control(), [&](const Ticket& ticket) {
    try {
      page = std::make_shared<DrawnPage>(Drawer(request, *data, ticket).draw());
    } catch (const std::logic_error& e) {
      // Plain doubles may contradict themselves: then there is no result to show, and that is no defect.
      if (request.arithmetic != "double") throw;
      throw InputError(std::string("arithmetic double: plain doubles contradict themselves on this scene (") + e.what() +
                       "); expected staged for a drawing");
    }
  });
  return page;
}

/// A coordinate of the drawing in millimetres, or in units of the view's frame, where the scale is a power of ten: rounded once.
double coordinate_of(const DrawnPage& page, double micrometres) {
  const double in_unit = page.is_in_frame_units ? 1000 * page.drawing.scale : 1000;
  return in_unit < 1 ? micrometres * std::round(1 / in_unit) : micrometres / in_unit;
}

/// The polylines in millimetres, y down, or in units of the view's frame, y up: points (p, 2), offsets (n + 1,), hidden (n,),
/// edge_class (n,).
py::dict polylines_of(const DrawnPage& page) {
  const double down = page.is_in_frame_units ? -1 : 1;
  std::vector<double> points;
  std::vector<std::int64_t> offsets = {0};
  std::vector<std::uint8_t> hidden, edge_class;
  for (const Polyline& line : page.drawing.polylines) {
    const auto add = [&](const PaperPoint& p) {
      const double x = static_cast<double>(p.x), y = down * static_cast<double>(p.y);
      points.insert(points.end(), {coordinate_of(page, x), coordinate_of(page, y) + 0.0});
    };
    for (const PaperPoint& p : page.drawing.points_of(line)) add(p);
    if (line.closed) add(page.drawing.points_of(line).front());
    offsets.push_back(static_cast<std::int64_t>(points.size() / 2));
    hidden.push_back(line.hidden ? 1 : 0);
    edge_class.push_back(static_cast<std::uint8_t>(line.edge_class));
  }
  const auto n = static_cast<py::ssize_t>(points.size() / 2);
  py::dict all;
  all["points"] = array_of(std::move(points), {n, 2});
  all["offsets"] = array_of(std::move(offsets));
  all["hidden"] = bool_array(hidden);
  all["edge_class"] = array_of(std::move(edge_class));
  return all;
}

}  // namespace

void add_drawings(py::module_& module) {
  py::class_<DrawnPage, std::shared_ptr<DrawnPage>>(module, "DrawnPage")
      .def("svg", [](const DrawnPage& p) { return p.bytes(Format::svg); })
      .def("written",
           [](const DrawnPage& p, const std::string& format) {
             constexpr std::array formats = {Format::svg, Format::pdf,  Format::eps, Format::dxf,
                                             Format::tex, Format::hpgl, Format::png, Format::json};
             return py::bytes(p.bytes(format_named(format, "format", formats)));
           })
      .def("png",
           [](const DrawnPage& p, const std::optional<std::string>& size) {
             return py::bytes(png(p.drawing, size ? parse_size(*size) : p.size));
           })
      .def("polylines", &polylines_of)
      .def_property_readonly("notes", [](const DrawnPage& p) { return p.notes; })
      .def_property_readonly("width", [](const DrawnPage& p) { return p.drawing.width; })
      .def_property_readonly("height", [](const DrawnPage& p) { return p.drawing.height; })
      .def_property_readonly("scale", [](const DrawnPage& p) { return p.drawing.scale; })
      .def_property_readonly("fits", [](const DrawnPage& p) { return p.drawing.fits; });
  module.def("draw", &draw_scene);
}

}  // namespace hsr::python
