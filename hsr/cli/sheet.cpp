#include "hsr/sheet/sheet.h"

#include <fmt/core.h>

#include <array>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>

#include "geometry/error.h"
#include "hsr/cli/command_context.h"
#include "hsr/cli/commands.h"
#include "hsr/cli/line_arguments.h"
#include "hsr/cli/model_defaults.h"
#include "hsr/cli/output_summary.h"
#include "hsr/cli/page_arguments.h"
#include "hsr/cli/page_writing.h"
#include "hsr/cli/scene_arguments.h"
#include "hsr/cli/sheet_json.h"
#include "hsr/drawing/drawing.h"
#include "hsr/io/write/format.h"

namespace hsr::cli {

using namespace internal;

namespace {

struct SheetArguments {
  ModelArguments models;
  std::vector<std::string> outputs;
  std::string page = "A3", angle, scale = "standard", unit, up_axis, views = "front,top,side,iso";
  std::vector<std::string> sections, details, titles;
  std::string title_file, dimensions = "overall", centre_lines = "on", hidden = "dashed", dxf_release = "r12", fit_arcs, size;
  std::vector<std::string> pens;
  SceneArguments scene;
  LineArguments lines;
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

/// Numbers with a separator between.
std::vector<double> numbers_of(const std::string& option, const std::string& text, const std::string& whole,
                               const std::string& expected, char separator) {
  std::vector<double> numbers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    double x = 0;
    const auto [stop, error] = std::from_chars(text.data() + begin, text.data() + end, x);
    if (error != std::errc{} || stop != text.data() + end || !std::isfinite(x))
      throw InputError(option + ": found \"" + whole + "\", expected " + expected);
    numbers.push_back(x);
    begin = end + 1;
  }
  return numbers;
}

/// "front:10,0,5:4:5:1": view, middle, radius, scale.
SheetDetail parse_detail(const std::string& text) {
  const std::string expected = "VIEW:X,Y,Z:RADIUS:SCALE such as front:10,0,5:4:5:1";
  const std::size_t first = text.find(':'), second = first == std::string::npos ? first : text.find(':', first + 1);
  const std::size_t third = second == std::string::npos ? second : text.find(':', second + 1);
  if (third == std::string::npos) throw InputError("--detail: found \"" + text + "\", expected " + expected);
  const auto scale = numbers_of("--detail", text.substr(third + 1), text, expected, ':');
  const auto radius = numbers_of("--detail", text.substr(second + 1, third - second - 1), text, expected, ',');
  if (radius.size() != 1 || scale.size() != 2 || !(scale[0] > 0) || !(scale[1] > 0) || !(radius[0] > 0))
    throw InputError("--detail: found \"" + text + "\", expected " + expected);
  return {text.substr(0, first), parse_point("--detail", text.substr(first + 1, second - first - 1)), radius[0],
          scale[0] / scale[1]};
}

std::vector<std::string> parse_views(const std::string& text) {
  std::vector<std::string> views;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    views.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return views;
}

SheetOptions parse(const SheetArguments& a) {
  SheetOptions o;
  o.format = sheet_format(a.page);
  const bool is_american = a.page.starts_with("ANSI");
  o.angle = a.angle == "third" || (a.angle.empty() && is_american) ? ProjectionAngle::third : ProjectionAngle::first;
  if (a.scale == "fit")
    throw InputError("--scale: found \"fit\", expected standard or a ratio like 1:5, as a sheet says its scale");
  o.scale = parse_scale(a.scale);
  o.views = parse_views(a.views);
  for (const std::string& text : a.sections) o.sections.push_back(parse_plane(text));
  for (const std::string& text : a.details) o.details.push_back(parse_detail(text));
  if (!a.title_file.empty()) {
    std::ifstream file(a.title_file, std::ios::binary);
    if (!file || std::filesystem::is_directory(a.title_file))
      throw InputError("--title-block: " + a.title_file + ": cannot be read, expected a file of JSON");
    read_title_block({std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()}, a.title_file, o.title);
  }
  for (const std::string& text : a.titles) set_title_field(text, o.title);
  o.has_dimensions = a.dimensions == "overall";
  o.has_centre_lines = a.centre_lines == "on";
  o.lines = a.lines.options();
  o.hidden = a.hidden == "none" ? HiddenLines::none : a.hidden == "dashed" ? HiddenLines::dashed : HiddenLines::solid;
  o.coplanar = a.scene.which_coplanar();
  for (const std::string& text : a.pens) {
    const auto more = parse_pens(text);
    o.pens.insert(o.pens.end(), more.begin(), more.end());
  }
  if (!a.fit_arcs.empty()) o.fit_arcs = tolerance_of_arcs(a.fit_arcs);
  return o;
}

std::string summary_of(const Sheet& sheet, const SheetOptions& o) {
  const std::string ratio = sheet.scale < 1 ? fmt::format("1:{:.6g}", 1 / sheet.scale) : fmt::format("{:.6g}:1", sheet.scale);
  return fmt::format("{}, {}, scale {}, {}", o.format.name, paper_size(o.format.width, o.format.height), ratio,
                     counted(sheet.views.size(), "view"));
}

std::string bytes_of(Format format, const Sheet& sheet, const SheetOptions& o, const SheetArguments& a,
                     const ViewedModel& model) {
  if (format == Format::json) return json_of(sheet, o).text() + "\n";
  std::optional<PixelSize> size;
  if (!a.size.empty()) size = parse_size(a.size);
  SvgOptions captions = model.captions();
  if (!o.title.title.empty()) captions.title = o.title.title;
  captions.description = "drawing sheet";
  WriteOptions options = page_options(format, captions, "", size);
  add_dxf(options, a.dxf_release, o.unit, sheet.drawing.scale);
  if (format != Format::dxf) return written(sheet.drawing, name_of(format), options);
  Drawing raised = sheet.drawing;  // the origin is the lower left corner of the sheet
  const auto height = static_cast<std::int64_t>(std::llround(o.format.height * 1000));
  for (PaperPoint& p : raised.points) p.y -= height;
  for (DrawnArc& arc : raised.arcs) arc.ellipse.centre.y -= o.format.height;
  return written(raised, "dxf", options);
}

void run(const SheetArguments& a, UnfinishedFiles& unfinished) {
  a.models.check();
  const std::vector<Output> outputs = parse_outputs(
      a.outputs,
      std::array{Format::pdf, Format::svg, Format::eps, Format::dxf, Format::tex, Format::hpgl, Format::png, Format::json});
  SheetOptions options = parse(a);
  CommandContext context(a.common, a.models.models, paths_of(outputs), unfinished);
  ViewOptions view;
  view.up_axis = a.up_axis;
  const ViewedModel model = context.read(a.models, view, options.lines.tolerance, a.unit);
  context.say_notes_of(model);
  const SceneObjects objects = objects_of(model.model, model.mesh);
  options.objects = &objects;
  options.unit = unit_of(a.unit, model.model);
  options.y_up = up_axis_of(a.up_axis, model.model) == 'y';
  if (a.unit.empty())
    if (const std::string note = unit_note(model.model); !note.empty()) context.note(note);
  if (options.title.title.empty()) options.title.title = std::filesystem::path(model.name()).stem().string();
  context.progress.stage("views");
  const Scene scene = Scene::of(model.mesh, labels_of(model.model));
  const Sheet sheet = context.report.timed("sheet", [&] { return draw_sheet(scene, options); });
  for (const std::string& note : sheet.notes) context.note(note);
  context.report.set("sheet", json_of(sheet, options));
  context.progress.stage("writing");
  context.report.timed("write", [&] {
    for (const Output& output : outputs)
      context.write(output.path, bytes_of(output.format, sheet, options, a, model), summary_of(sheet, options));
  });
  context.finish();
}

void add_page_options(SheetArguments& a, Options& options) {
  options.begin_group("Sheet");
  options.add("--page", a.page, "SHEET", "A0 ... A4, ANSI-A or ANSI-B")
      .with_default_shown()
      .such_as({"A0", "A1", "A2", "A3", "A4", "ANSI-A", "ANSI-B"});
  options.add("--angle", a.angle, "ANGLE", "first or third: where views stand [ANSI: third, else first]")
      .one_of({"first", "third"});
  options
      .add("--scale", a.scale, "RATIO",
           "Of all views but details, such as 1:5, or standard: the largest of 1:1, 1:2, 1:5, 1:10, ..., "
           "2:1, 5:1, ... that fits")
      .with_default_shown()
      .such_as({"standard"});
  options.add("--unit", a.unit, "UNIT", "The model's unit: mm, cm, m or in [glTF: m, else mm]").one_of({"mm", "cm", "m", "in"});
  options.add("--views", a.views, "LIST", "Some of front, top, side, iso, with commas between")
      .with_default_shown()
      .list_of({"front", "top", "side", "iso"});
  options.add_one_each(
      "--section", a.sections, "PLANE",
      "Also the section by this plane, such as x=12.5 or NX,NY,NZ@X,Y,Z, as A-A with its cutting line; may be repeated");
  options.add_one_each("--detail", a.details, "VIEW:X,Y,Z:RADIUS:SCALE",
                       "Also what is within RADIUS of a point of a view, larger: front:10,0,5:4:5:1; may be repeated");
  options.add("--dimensions", a.dimensions, "WHICH", "overall: width, height and depth; or none")
      .with_default_shown()
      .one_of({"overall", "none"});
  options.add("--centre-lines", a.centre_lines, "WHICH", "Centre lines of circles, and axes: on or off")
      .with_default_shown()
      .one_of({"on", "off"});
  options.add_one_each(
      "--title", a.titles, "FIELD=TEXT",
      "A field of the title block: owner, title, subtitle, number, creator, approver, type, material, date, revision, language "
      "or sheet; may be repeated");
  options.add("--title-block", a.title_file, "FILE",
              "Fields of the title block as JSON, such as {\"title\": \"Bracket\"}; --title counts more");
  options.add("--size", a.size, "WxH", "PNG: pixels [150 to the inch]");
  options.add("--dxf", a.dxf_release, "RELEASE", "DXF: r12, which everything reads, or 2000, with line weights")
      .with_default_shown()
      .one_of({"r12", "2000"});
  options.add_one_each("--pen", a.pens, "NAME=MM[:COLOUR[:DASH]]", "Pens of the views' lines, as hsr draw has them");
  options.add("--fit-arcs", a.fit_arcs, "MM",
              "Draw lines that lie on one circle, within this on paper, as arcs, as hsr draw does");
}

}  // namespace

void add_sheet(CommandLine& command, UnfinishedFiles& unfinished) {
  auto a = std::make_shared<SheetArguments>();
  Options options = command.add_verb(
      "sheet", "Draw several views on one sheet with frame, title block, dimensions and sections: PDF, SVG, DXF, ...",
      examples);
  a->models.add_to(options);
  options
      .add_one_each("-o,--output", a->outputs, "FILE",
                    "The sheet; its ending chooses pdf, svg, eps, dxf, tex, hpgl, png or json; may be repeated")
      .required();
  a->models.add_objects_to(options);
  add_page_options(*a, options);
  options.begin_group("Scene");
  options.add("--up-axis", a->up_axis, "AXIS", "What is up in the model: y or z [glTF: y, else z]").one_of({"y", "z"});
  a->scene.add_to(options);
  options.begin_group("Lines");
  options.add("--hidden", a->hidden, "STYLE", "Hidden lines of front, top and side: none, dashed or solid")
      .with_default_shown()
      .one_of({"none", "dashed", "solid"});
  a->lines.add_to(options);
  options.begin_group("Report");
  a->common.add_threads_to(options);
  a->common.add_report_to(options, "Times and places");
  a->common.add_quiet_to(options, "Say nothing but what is wrong");
  options.on_run([a, &unfinished] { run(*a, unfinished); });
}

}  // namespace hsr::cli
