#include <pybind11/stl.h>

#include <array>
#include <filesystem>
#include <optional>

#include "geometry/error.h"
#include "hsr/cli/model_section.h"
#include "hsr/cli/scale_text.h"
#include "hsr/drawing/painting.h"
#include "hsr/io/write/json.h"
#include "python/src/errors.h"
#include "python/src/order_data.h"

namespace hsr::python {

namespace {

/// The arguments, each found to be one that can be done.
struct PaintRequest {
  OutputPaths outputs;
  cli::PageArguments page;
  LineOptions lines;
  DrawingOptions drawing;
  PaintingOptions painting;
  Shading shading;
  std::string id_prefix;
  std::optional<PixelSize> size;
  bool exact;

  explicit PaintRequest(const Arguments& a)
      : outputs(a, std::array{Format::svg, Format::pdf, Format::eps, Format::tex, Format::png, Format::json}),
        page(a.page()),
        lines(a.lines().options()),
        drawing(page.options()),
        shading(a.shading()),
        id_prefix(a.get<std::string>("id_prefix", "")),
        exact(a.get<bool>("exact", false)) {
    painting.opacity = a.get<double>("opacity", 1);
    if (!(painting.opacity > 0 && painting.opacity <= 1))
      throw InputError("opacity: found " + std::to_string(painting.opacity) + ", expected more than 0 and at most 1");
    drawing.leave_out_near = true;
    check_id_prefix(id_prefix);
    if (!page.size.empty()) size = parse_size(page.size);
  }
};

/// The steps of `hsr order`, from the order on.
DrawnPage painted(const OrderData& data, PaintRequest& request) {
  const Model& model = data.data->model();
  const SceneView& scene = data.scene;
  DrawnPage page;
  page.notes = model.notes;
  request.drawing.field_of_view = data.chosen.field_of_view;
  const SceneObjects objects = objects_of(model, scene.mesh());
  request.drawing.objects = &objects;
  request.drawing.labels = &scene.labels();
  request.painting.paints_lines_with_pieces = data.may_be_wrong;
  for (const std::string& note : {data.chosen.note, data.chosen.up_axis_note, request.page.adopt_unit(model, request.drawing)})
    if (!note.empty()) page.notes.push_back(without_dashes(note));
  std::optional<Section> section;
  if (const std::string note = cli::find_section(model, scene, request.lines.classes, request.drawing, section); !note.empty())
    page.notes.push_back(note);
  page.drawing = paint_on_page(scene, data.order, face_colours(model, scene.mesh(), scene.view(), request.shading),
                               request.lines, request.drawing, request.painting);
  page.captions = {std::filesystem::path(model.name).filename().string(), "view: " + data.chosen.title, request.id_prefix};
  page.scale = cli::scale_in_title(page.drawing, request.drawing, request.page);
  page.size = request.size;
  if (request.outputs.wants(Format::json))
    page.json = order_json(scene.mesh(), scene.view(), data.order, request.exact ? Numbers::exact : Numbers::rounded,
                           scene.options().coplanar, request.drawing.section);
  return page;
}

}  // namespace

std::shared_ptr<DrawnPage> draw_order(const std::shared_ptr<OrderData>& data, const py::dict& named) {
  const Arguments arguments(named);
  PaintRequest request(arguments);
  std::shared_ptr<DrawnPage> page;
  run(arguments.control(), [&](const Ticket& ticket) {
    page = std::make_shared<DrawnPage>(painted(*data, request));
    ticket.check();
    request.outputs.write(*page);
  });
  return page;
}

}  // namespace hsr::python
