#include "hsr/sheet/sheet.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <memory>

#include "hsr/cli/command_context.h"
#include "hsr/cli/commands.h"
#include "hsr/cli/output_summary.h"
#include "hsr/cli/sheet_arguments.h"
#include "hsr/cli/sheet_json.h"

namespace hsr::cli {

using namespace internal;

namespace {

struct SheetCommand {
  ModelArguments models;
  std::vector<std::string> outputs;
  SheetArguments sheet;
  CommonArguments common;
};

const char* const examples = R"(Examples:
  hsr sheet part.stl -o part.pdf                        front, top, left and iso on A3, the largest standard scale
  hsr sheet part.stl -o part.pdf -o part.dxf --angle third --page ANSI-B
  hsr sheet part.stl -o part.pdf --section x=12.5       with the section A-A, hatched, and its cutting line
  hsr sheet part.stl -o part.svg --detail front:10,0,5:4:5:1   what is within 4 of (10,0,5) again, at 5:1
  hsr sheet part.stl -o part.pdf --title title=Bracket --title number=4711 --title owner="Acme Ltd"
  hsr sheet part.stl -o part.pdf -o places.json         and where everything is, for programs that add to it

Writes each FILE, all of them or none: .pdf, .svg, .eps, .tex (TikZ), .hpgl (or .plt), .png, and .dxf in units of the model, 1:1;
.json says where views, dimensions and the title block are.)";

std::string summary_of(const Sheet& sheet, const SheetOptions& o) {
  const std::string ratio = sheet.scale < 1 ? fmt::format("1:{:.6g}", 1 / sheet.scale) : fmt::format("{:.6g}:1", sheet.scale);
  return fmt::format("{}, {}, scale {}, {}", o.format.name, paper_size(o.format.width, o.format.height), ratio,
                     counted(sheet.views.size(), "view"));
}

void run(const SheetCommand& a, UnfinishedFiles& unfinished) {
  a.models.check();
  const std::vector<Output> outputs = parse_outputs(
      a.outputs,
      std::array{Format::pdf, Format::svg, Format::eps, Format::dxf, Format::tex, Format::hpgl, Format::png, Format::json});
  SheetOptions options = a.sheet.options();
  CommandContext context(a.common, a.models.models, paths_of(outputs), unfinished);
  ViewOptions view;
  view.up_axis = a.sheet.up_axis;
  // A view has half of the sheet at most, and details are larger.
  DrawingOptions of_view;
  of_view.page = {options.format.width / 2, options.format.height / 2, 0, true, false};
  of_view.scale = options.scale;
  for (const SheetDetail& detail : options.details) of_view.scale = std::max(of_view.scale.value_or(0), detail.scale);
  const ViewedModel model = context.read(a.models, view, options.lines.tolerance, a.sheet.unit, of_view);
  context.say_notes_of(model);
  const SceneObjects objects = objects_of(model.model, model.mesh);
  options.objects = &objects;
  if (const std::string note = a.sheet.adopt(model.model, options); !note.empty()) context.note(note);
  context.progress.stage("views");
  options.lines.progress = [&](double done) { context.progress.show(done); };
  const Scene scene = Scene::of(model.mesh, labels_of(model.model));
  const Sheet sheet = context.report.timed("sheet", [&] { return draw_sheet(scene, options); });
  for (const std::string& note : sheet.notes) context.note(note);
  context.report.set("sheet", json_of(sheet, options));
  context.progress.stage("writing");
  context.report.timed("write", [&] {
    for (const Output& output : outputs)
      context.write(output.path, sheet_bytes(sheet, options, a.sheet, output.format), summary_of(sheet, options));
  });
  context.finish();
}

}  // namespace

void add_sheet(CommandLine& command, UnfinishedFiles& unfinished) {
  auto a = std::make_shared<SheetCommand>();
  Options options = command.add_verb(
      "sheet", "Draw several views on one sheet with frame, title block, dimensions and sections: PDF, SVG, DXF, ...",
      examples);
  a->models.add_to(options);
  options
      .add_one_each("-o,--output", a->outputs, "FILE",
                    "The sheet; its ending chooses pdf, svg, eps, dxf, tex, hpgl, png or json; may be repeated")
      .required();
  a->models.add_objects_to(options);
  a->sheet.add_to(options);
  options.begin_group("Report");
  a->common.add_threads_to(options);
  a->common.add_report_to(options, "Times and places");
  a->common.add_quiet_to(options, "Say nothing but what is wrong");
  options.on_run([a, &unfinished] { run(*a, unfinished); });
}

}  // namespace hsr::cli
