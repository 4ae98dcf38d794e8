#include "python/src/sheets.h"

#include <pybind11/stl.h>

#include <array>
#include <memory>

#include "hsr/cli/sheet_arguments.h"
#include "hsr/cli/sheet_json.h"
#include "python/src/drawn_page.h"
#include "python/src/errors.h"

namespace hsr::python {

namespace {

cli::SheetArguments words_of(const Arguments& a) {
  cli::SheetArguments words;
  words.page = a.get("page", words.page);
  words.angle = a.word("angle", "", {"first", "third"});
  words.scale = a.get("scale", words.scale);
  words.unit = a.word("unit", "", {"mm", "cm", "m", "in"});
  words.up_axis = a.word("up_axis", "", {"y", "z"});
  words.views = a.get("views", words.views);
  words.sections = a.get("section", words.sections);
  words.details = a.get("detail", words.details);
  words.titles = a.get("title", words.titles);
  words.title_file = a.get("title_block", words.title_file);
  words.pens = a.get("pen", words.pens);
  words.dimensions = a.get("dimensions", true) ? "overall" : "none";
  words.centre_lines = a.get("centre_lines", true) ? "on" : "off";
  words.hidden = a.word("hidden", "dashed", {"none", "dashed", "solid"});
  words.formats.dxf_release = a.word("dxf", "r12", {"r12", "2000"});
  words.fit_arcs = a.get("fit_arcs", words.fit_arcs);
  words.size = a.get("size", words.size);
  words.scene = a.scene();
  words.lines = a.lines();
  return words;
}

DrawnPage sheet_of(const cli::SheetArguments& words, const OutputPaths& outputs, SceneData& data, const Ticket& ticket) {
  SheetOptions options = words.options();
  const Scene scene = data.scene(options.lines.tolerance);
  const Model& model = data.model();
  DrawnPage page;
  page.notes = model.notes;
  const SceneObjects objects = objects_of(model, scene.mesh());
  options.objects = &objects;
  if (const std::string note = words.adopt(model, options); !note.empty()) page.notes.push_back(note);
  options.lines.progress = ticket.progress;
  options.lines.stop = ticket.stop;
  const Sheet sheet = draw_sheet(scene, options);
  page.notes.insert(page.notes.end(), sheet.notes.begin(), sheet.notes.end());
  page.drawing = sheet.drawing;
  page.in_model_units = cli::from_lower_left(sheet);
  page.json = cli::json_of(sheet, options).text() + "\n";
  page.captions = {options.title.title, "drawing sheet", {}};
  page.size = words.pixels();
  page.dxf_release = words.formats.dxf_release;
  page.unit = options.unit;
  ticket.check();
  outputs.write(page);
  for (std::string& note : page.notes) note = without_dashes(note);
  return page;
}

}  // namespace

void add_sheets(py::module_& module) {
  module.def("sheet", [](const std::shared_ptr<SceneData>& data, const py::dict& named) {
    const Arguments a(named);
    const OutputPaths outputs(a, std::array{Format::pdf, Format::svg, Format::eps, Format::dxf, Format::tex, Format::hpgl,
                                            Format::png, Format::json});
    const cli::SheetArguments words = words_of(a);
    std::shared_ptr<DrawnPage> page;
    run(a.control(),
        [&](const Ticket& ticket) { page = std::make_shared<DrawnPage>(sheet_of(words, outputs, *data, ticket)); });
    return page;
  });
}

}  // namespace hsr::python
