#include "python/src/drawings.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>

#include "geometry/error.h"
#include "hsr/cli/coincident_note.h"
#include "hsr/cli/outline_only.h"
#include "hsr/cli/page_arguments.h"
#include "hsr/cli/scale_text.h"
#include "hsr/drawing/drawing.h"
#include "hsr/drawing/shading.h"
#include "hsr/io/write/format.h"
#include "hsr/io/write/json.h"
#include "hsr/io/write/output_file.h"
#include "hsr/io/write/png.h"
#include "hsr/io/write/svg.h"
#include "hsr/surfaces/regions.h"
#include "hsr/surfaces/roberts_surfaces.h"
#include "hsr/surfaces/visible_fragments.h"
#include "python/src/arguments.h"
#include "python/src/arrays.h"
#include "python/src/errors.h"

namespace hsr::python {

using namespace internal;

namespace {

/// The arguments, each found to be one that can be done.
struct DrawRequest {
  std::vector<std::string> outputs;
  std::vector<Format> formats;
  cli::ViewOptions view;
  cli::SceneArguments scene_words;
  cli::PageArguments page;
  SceneOptions scene;
  LineOptions lines;
  DrawingOptions drawing;
  Merge merge = Merge::none;
  bool fill = false, exact = false, outline_only = false;
  std::string id_prefix;
  std::optional<PixelSize> size;

  explicit DrawRequest(const Arguments& a);
  bool wants(Format format) const { return std::find(formats.begin(), formats.end(), format) != formats.end(); }
};

cli::PageArguments page_of(const Arguments& a) {
  cli::PageArguments page;
  page.page = a.get<std::string>("page", page.page);
  page.scale = a.get<std::string>("scale", page.scale);
  page.unit = a.word("unit", "", {"mm", "cm", "m", "in"});
  page.margin = a.get<double>("margin", page.margin);
  page.min_length = a.get<double>("min_length", page.min_length);
  page.size = a.get<std::string>("size", "");
  page.pens = a.get<std::vector<std::string>>("pen", {});
  page.pens_file = a.get<std::string>("pens", "");
  page.sort = a.word("sort", page.sort, {"none", "pen"});
  return page;
}

DrawRequest::DrawRequest(const Arguments& a)
    : outputs(a.get<std::vector<std::string>>("outputs", {})),
      view(a.view()),
      scene_words(a.scene()),
      page(page_of(a)),
      fill(a.get<bool>("fill", false)),
      exact(a.get<bool>("exact", false)),
      outline_only(a.get<bool>("outline_only", false)),
      id_prefix(a.get<std::string>("id_prefix", "")) {
  for (const std::string& path : outputs)
    formats.push_back(format_of(path, std::array{Format::svg, Format::png, Format::json}));
  lines = a.lines().options();
  lines.why = a.get<bool>("why", false);
  if (lines.method == LineMethod::appel && lines.why)
    throw InputError("why: appel counts the faces that hide and does not know which they are, expected method roberts or auto");
  scene.coplanar = scene_words.which_coplanar();
  drawing = page.options();
  const std::string hidden = a.word("hidden", "none", {"none", "dashed", "solid"});
  drawing.hidden = hidden == "none" ? HiddenLines::none : hidden == "dashed" ? HiddenLines::dashed : HiddenLines::solid;
  drawing.leave_out_near = true;
  scene.hidden_lines = lines.why || drawing.hidden != HiddenLines::none || wants(Format::json);
  const std::string united = a.word("merge", "none", {"none", "coplanar", "colour"});
  merge = united == "none" ? Merge::none : united == "coplanar" ? Merge::coplanar : Merge::colour;
  if (!page.size.empty()) size = parse_size(page.size);
  check_id_prefix(id_prefix);
  if (!outline_only) return;
  if (wants(Format::json)) throw InputError("outline_only: json has lines and no outline, expected svg or png");
  cli::ask_for_outline_only(lines, drawing);
}

/// What was drawn.
struct DrawnPage {
  Drawing drawing;
  SvgOptions captions;
  std::optional<PixelSize> size;
  std::string json;  ///< only if a file wants it
  std::vector<std::string> notes;

  std::string bytes(Format format) const {
    return format == Format::svg ? svg(drawing, captions) : format == Format::png ? png(drawing, size) : json;
  }
};

/// The steps of `hsr draw`, in its order.
class Drawer {
 public:
  Drawer(DrawRequest& request, SceneData& data, const Ticket& ticket)
      : request_(request), data_(data), ticket_(ticket), scene_(data.scene(request.lines.tolerance)) {}

  DrawnPage draw();

 private:
  void choose_view();
  void find_lines();
  void find_fragments();
  void place();
  void write() const;

  DrawRequest& request_;
  SceneData& data_;
  const Ticket& ticket_;
  Scene scene_;
  cli::ChosenView chosen_;
  SceneObjects objects_;
  std::optional<SceneView> prepared_;
  VisibleLines lines_;
  std::optional<VisibleLines> every_line_;
  std::optional<VisibleFragments> fragments_;
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
  request_.drawing.field_of_view = chosen_.field_of_view;
  if (const std::string note = request_.page.adopt_unit(model, request_.drawing); !note.empty()) page_.notes.push_back(note);
  if (!request_.wants(Format::json)) request_.lines.frame = frame_size(chosen_.view, request_.drawing);
  request_.lines.progress = ticket_.progress;
  request_.lines.stop = ticket_.stop;
  prepared_.emplace(scene_, chosen_.view, request_.scene);
}

void Drawer::find_lines() {
  const bool finds_all = (request_.fill || request_.outline_only) && !request_.lines.why &&
                         request_.lines.method != LineMethod::roberts && fragments_use_lines(*prepared_);
  if (!finds_all) {
    lines_ = visible_lines(*prepared_, request_.lines);
    return;
  }
  LineOptions every = request_.lines;
  every.classes.fill(true);
  every.diagonals = true;
  every.frame = {};
  every_line_ = visible_lines(*prepared_, every);
  lines_ = lines_of_classes(scene_.mesh(), *every_line_, request_.lines.classes);
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
  const std::string note = cli::coincident_note(*prepared_, data_.model(), Coincidence::seen);
  if (!note.empty()) page_.notes.push_back(note);
}

void Drawer::place() {
  const Mesh& mesh = scene_.mesh();
  if (request_.outline_only) {
    const Regions all = cli::union_of_all(*prepared_, *fragments_);
    page_.drawing = hsr::draw(mesh, chosen_.view, lines_, request_.drawing, &all);
  } else if (request_.fill) {
    const Regions regions =
        regions_of(*prepared_, *fragments_, face_colours(data_.model(), mesh, chosen_.view), request_.merge);
    page_.drawing = hsr::draw(mesh, chosen_.view, lines_, request_.drawing, &regions);
  } else {
    page_.drawing = hsr::draw(mesh, chosen_.view, lines_, request_.drawing);
  }
  page_.captions = {std::filesystem::path(data_.model().name).filename().string(),
                    "view: " + chosen_.title + cli::scale_in_title(page_.drawing, request_.drawing, request_.page),
                    request_.id_prefix};
  page_.size = request_.size;
  if (request_.wants(Format::json))
    page_.json = lines_json(mesh, chosen_.view, lines_,
                            {request_.exact ? Numbers::exact : Numbers::rounded, request_.fill ? &*fragments_ : nullptr,
                             request_.lines.why, &objects_});
}

/// All of the files, or none.
void Drawer::write() const {
  std::vector<std::unique_ptr<OutputFile>> files;
  for (std::size_t i = 0; i < request_.outputs.size(); ++i) {
    files.push_back(std::make_unique<OutputFile>(request_.outputs[i]));
    files.back()->write(page_.bytes(request_.formats[i]));
  }
  for (const auto& file : files) file->commit();
}

DrawnPage Drawer::draw() {
  choose_view();
  find_lines();
  ticket_.check();
  find_fragments();
  ticket_.check();
  place();
  ticket_.check();
  write();
  for (std::string& note : page_.notes) note = without_dashes(note);
  return std::move(page_);
}

std::shared_ptr<DrawnPage> draw_scene(const std::shared_ptr<SceneData>& data, const py::dict& named) {
  const Arguments arguments(named);
  DrawRequest request(arguments);
  std::shared_ptr<DrawnPage> page;
  run(arguments.control(),
      [&](const Ticket& ticket) { page = std::make_shared<DrawnPage>(Drawer(request, *data, ticket).draw()); });
  return page;
}

/// The polylines in millimetres: points (p, 2), offsets (n + 1,), hidden (n,), edge_class (n,).
py::dict polylines_of(const DrawnPage& page) {
  std::vector<double> points;
  std::vector<std::int64_t> offsets = {0};
  std::vector<std::uint8_t> hidden, edge_class;
  for (const Polyline& line : page.drawing.polylines) {
    const auto add = [&](const PaperPoint& p) {
      points.insert(points.end(), {static_cast<double>(p.x) / 1000, static_cast<double>(p.y) / 1000});
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
