#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>

#include "geometry/error.h"
#include "hsr/check/error_against_time.h"
#include "hsr/check/error_csv.h"
#include "hsr/cli/coincident_note.h"
#include "hsr/cli/command_context.h"
#include "hsr/cli/commands.h"
#include "hsr/cli/draw_arguments.h"
#include "hsr/cli/draw_report.h"
#include "hsr/cli/drawing_check.h"
#include "hsr/cli/messages.h"
#include "hsr/cli/outline_only.h"
#include "hsr/cli/output_summary.h"
#include "hsr/cli/page_writing.h"
#include "hsr/cli/paper_note.h"
#include "hsr/cli/scale_text.h"
#include "hsr/drawing/drawing.h"
#include "hsr/drawing/pen_order.h"
#include "hsr/io/write/format.h"
#include "hsr/io/write/json.h"
#include "hsr/lines/overhead.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/scene/input_noise.h"
#include "hsr/surfaces/regions.h"
#include "hsr/surfaces/roberts_surfaces.h"
#include "hsr/surfaces/visible_fragments.h"

namespace hsr::cli {

using namespace internal;

namespace {

/// Why a drawing has no line, for one who wonders.
std::string empty_drawing(const DrawArguments& a, bool in_frame, const VisibleLines& lines, const Drawing& drawing) {
  if (lines.lines.empty() && in_frame)
    return "no edge of the classes " + a.lines.edges +
           " is in the picture: see --target, --fov and --near; --edges all draws every edge";
  if (lines.lines.empty())
    return "no edge of this model is of the classes " + a.lines.edges + " in this view: --edges all draws every edge";
  const bool nothing_ahead =
      std::all_of(lines.lines.begin(), lines.lines.end(), [](const Line& l) { return l.intervals() == 0; });
  if (nothing_ahead && !a.view.sections.empty()) return "the section leaves nothing, or what it leaves is seen as points";
  if (nothing_ahead && !a.view.eye.empty())
    return "nothing of the model is beyond the near plane, or seen as more than a point: see --target and --near";
  if (nothing_ahead) return "every edge is seen as a point";
  if (drawing.short_dropped > 0)
    return "every line is shorter than 0.01 mm at scale " + a.page.scale + ": --scale fit shows the whole";
  return "every line is hidden, or outside the frame: --hidden dashed shows what is hidden";
}

/// The arguments, each found to be one that can be done.
struct DrawRequest {
  std::vector<Output> outputs;
  SceneOptions scene;
  LineOptions lines;
  DrawingOptions drawing;
  std::optional<PixelSize> size;

  bool wants(Format format) const {
    return std::any_of(outputs.begin(), outputs.end(), [&](const Output& o) { return o.format == format; });
  }
  bool wants_picture() const {
    return std::any_of(outputs.begin(), outputs.end(),
                       [](const Output& o) { return o.format != Format::json && o.format != Format::csv; });
  }
};

DrawRequest parse(const DrawArguments& a) {
  DrawRequest request;
  a.models.check();
  request.outputs = parse_outputs(a.outputs, std::array{Format::svg, Format::pdf, Format::eps, Format::dxf, Format::tex,
                                                        Format::hpgl, Format::png, Format::json, Format::csv});
  if (a.lines.method == "appel" && a.why)
    throw InputError(
        "--why: appel counts the faces that hide and does not know which they are, expected --method roberts or auto");
  request.lines = a.lines.options();
  request.lines.why = a.why;
  request.scene = a.lines.scene_options();
  request.scene.coplanar = a.scene.which_coplanar();
  request.scene.arithmetic = arithmetic_named(a.arithmetic);
  request.drawing = a.page.options();
  request.drawing.hidden = hidden_lines_named(a.hidden);
  request.drawing.arithmetic = request.scene.arithmetic;
  request.drawing.leave_out_near = true;
  if (a.outline_only && request.wants(Format::json))
    throw InputError("--outline-only: json has lines and no outline, expected svg, pdf, eps, dxf, tex, hpgl or png");
  if (!a.view.sections.empty() && request.wants(Format::csv))
    throw InputError("--section: the z-buffers of a csv know no caps, expected a view without a section");
  if (a.outline_only) ask_for_outline_only(request.lines, request.drawing);
  request.scene.hidden_lines = a.why || request.drawing.hidden != HiddenLines::none || request.wants(Format::json);
  if (!a.page.size.empty()) request.size = parse_size(a.page.size);
  check_id_prefix(a.formats.id_prefix);
  return request;
}

/// From the model to the files, one step after the other; each keeps what the later ones need.
class DrawCommand {
 public:
  DrawCommand(const DrawArguments& a, UnfinishedFiles& unfinished)
      : a_(a), request_(parse(a)), context_(a.common, a.models.models, paths_of(request_.outputs), unfinished) {}

  void run() {
    read();
    find_lines();
    context_.find_section(scene_, *prepared_, request_.lines.classes, request_.drawing, section_);
    find_fragments();
    check();
    measure_errors();
    draw_page();
    draw_in_model_units();
    write();
    if (!is_right_) throw CheckFailed();
  }

 private:
  void read();
  void find_lines();
  void add_overhead();
  void find_fragments();
  void note_coincident_faces();
  void check();
  void measure_errors();
  void draw_page();
  Drawing drawn(const DrawingOptions& options) const;
  void draw_in_model_units();
  void write();
  void note_idle_options();
  std::string note_on_size() const;
  void note_noise();
  bool wants_fragments() const { return a_.fill || a_.outline_only || a_.check || request_.wants(Format::csv); }
  std::string bytes_of(Format format) const;
  std::string summary_of(Format format, const std::string& bytes) const;
  std::string summary_of_page(bool has_fills) const;
  SampleGrid samples(int width, int height) const {
    return samples_for(scene_.view(), scene_.mesh, request_.drawing, width, height);
  }

  const DrawArguments& a_;
  DrawRequest request_;
  CommandContext context_;
  ViewedModel scene_;
  SceneObjects objects_;
  std::optional<SceneView> prepared_;
  std::optional<SceneView> exact_;  // the same, but where arithmetic is compared: checks are exact
  VisibleLines lines_;
  std::optional<Section> section_;
  std::optional<VisibleLines> every_line_;  // of all edges, which bound the fragments
  std::optional<VisibleFragments> fragments_;
  std::vector<ErrorAgainstTime> errors_;
  std::optional<Drawing> drawing_;
  std::optional<Drawing> model_drawing_;  // the same in units of the model, for DXF
  DecisionCounts decisions_;
  bool is_right_ = true;
};

void DrawCommand::read() {
  scene_ = context_.read(a_.models, a_.view, request_.lines.tolerance, a_.page.unit, request_.drawing);
  objects_ = objects_of(scene_.model, scene_.mesh);
  // What is asked from here on is in the mesh.
  scene_.model.points = {};
  scene_.model.polygons = {};
  request_.drawing.objects = &objects_;
  request_.drawing.field_of_view = scene_.chosen.field_of_view;
  const std::string unit_note = a_.page.adopt_unit(scene_.model, request_.drawing);
  // Drawings only: JSON is complete.
  if (!request_.wants(Format::json)) request_.lines.frame = frame_size(scene_.view(), request_.drawing);
  request_.lines.progress = [this](double done) { context_.progress.show(done); };
  prepared_ = scene_.prepared(request_.scene);
  request_.drawing.labels = &prepared_->labels();
  exact_ = request_.scene.arithmetic == Arithmetic::staged ? prepared_ : scene_.prepared({.coplanar = request_.scene.coplanar});
  note_idle_options();
  context_.say_notes_of(scene_);
  note_noise();
  if (!unit_note.empty()) context_.note(unit_note);
  context_.report.set("view", json_of(scene_.view()));
  if (!scene_.mesh.edges.empty()) return;
  const char* const why = !a_.models.objects.is_empty() ? "no face with an area is left"
                          : scene_.mesh.faces.empty()   ? "no face is there"
                                                        : "every face has no area";
  context_.note(fmt::format("{}: {}, the drawing is empty", scene_.model.name, why));
}

/// What was asked for and does nothing here.
void DrawCommand::note_idle_options() {
  const auto note = [&](const char* option, const char* format) {
    context_.note(fmt::format("{} has no effect without an output that ends in .{}", option, format));
  };
  if (a_.why && !request_.wants(Format::json)) note("--why", "json");
  if (a_.formats.exact && !request_.wants(Format::json)) note("--exact", "json");
  if (!request_.drawing.pens.empty() && request_.wants(Format::hpgl))
    context_.note("hpgl has a pen for each layer and the dashes asked for, but no widths and colours");
  if (!a_.formats.id_prefix.empty() && !request_.wants(Format::svg)) note("--id-prefix", "svg");
  if (a_.formats.dxf_release != "r12" && !request_.wants(Format::dxf)) note("--dxf", "dxf");
  if (a_.fill && a_.outline_only) context_.note("--fill has no effect with --outline-only");
  if (a_.fill)
    for (const std::string& text : notes_on_formats_without_fills(request_.outputs)) context_.note(text);
  if (request_.size && !request_.wants(Format::png) && !request_.wants(Format::csv) && !a_.check) note("--size", "png");
}

/// Noise of the model that shows in the drawing, and the tolerance that mends it.
void DrawCommand::note_noise() {
  if (request_.lines.tolerance > 0 || a_.common.quiet) return;
  const InputNoise noise = context_.report.timed("noise", [&] { return noise_of(scene_.mesh); });
  if (noise.tolerance == 0) return;
  std::string signs;
  if (noise.open_edges > 0) signs = fmt::format("{} edges of one face would close", noise.open_edges);
  if (noise.near_planes > 0)
    signs += fmt::format("{}{} faces would lie in one plane with a face that they touch", signs.empty() ? "" : ", ",
                         noise.near_planes);
  context_.note(fmt::format("{}: {} within {:g}: --tolerance {:g} takes it for noise", scene_.model.name, signs,
                            noise.tolerance, noise.tolerance));
}

void DrawCommand::find_lines() {
  context_.progress.stage("visible lines");
  context_.report.timed("lines", [&] {
    // Fragments are bounded by the lines of all edges: these are found once, and the drawing takes some of them.
    const FaceLabels& labels = prepared_->labels();
    const bool tells_smooth = labels.surface.empty() && labels.marks.empty();
    const bool tells_intersections = labels.shape.empty();
    const bool finds_all = wants_fragments() && !a_.why && a_.lines.method != "roberts" && fragments_use_lines(*prepared_) &&
                           tells_intersections &&
                           (tells_smooth || !request_.lines.classes[static_cast<std::size_t>(EdgeClass::smooth)]);
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
    lines_ = lines_of_classes(scene_.mesh, *every_line_, request_.lines.classes);
    add_overhead();
  });
  describe(context_.report, scene_.model, scene_.mesh, lines_);
  decisions_ = lines_.decisions;
}

void DrawCommand::add_overhead() {
  if (a_.overhead != "off") lines_ = with_overhead(*prepared_, request_.lines, std::move(lines_));
}

void DrawCommand::find_fragments() {
  Report& report = context_.report;
  if (!wants_fragments()) {
    report.leave_out("fragments", "neither --fill nor --check nor a csv is asked for");
    return;
  }
  context_.progress.stage("visible fragments");
  FragmentOptions options;
  if (every_line_) options.lines = &*every_line_;
  options.progress = request_.lines.progress;
  fragments_ = report.timed("fragments", [&] {
    return a_.lines.method == "roberts" ? roberts_surfaces(*prepared_, options) : visible_fragments(*prepared_, options);
  });
  every_line_.reset();  // it may be large
  note_coincident_faces();
  decisions_ += fragments_->decisions;
  if (context_.reports())
    report.set("fragments", report.timed("areas", [&] {
      return areas_json(scene_.model, scene_.mesh, scene_.view(), *fragments_, a_.formats.exact);
    }));
}

/// Which of them is on top was the user's to say, and matters where faces are filled.
void DrawCommand::note_coincident_faces() {
  if (!a_.fill || a_.scene.asks_for_coplanar() || context_.is_quiet()) return;
  const std::string text =
      context_.report.timed("coincident faces", [&] { return coincident_note(*exact_, scene_.model, Coincidence::seen); });
  if (!text.empty()) context_.note(text);
}

void DrawCommand::check() {
  if (!a_.check) return;
  context_.progress.stage("check");
  const PixelSize pixels = request_.size.value_or(PixelSize{1024, 1024});
  const SampleGrid grid = samples(pixels.width, pixels.height);
  const DrawingCheck found =
      context_.report.timed("check", [&] { return on_samples([&] { return check_drawing(*exact_, *fragments_, grid); }); });
  context_.report.set("check", json_of(found));
  is_right_ = found.is_right();
  context_.progress.clear();
  if (!is_right_ || !context_.is_quiet()) say(found);
}

void DrawCommand::measure_errors() {
  if (!request_.wants(Format::csv)) return;
  context_.progress.stage("error against time");
  ErrorAgainstTimeOptions options;
  options.progress = request_.lines.progress;
  if (request_.size) {
    const int most = std::max(request_.size->width, request_.size->height);
    std::erase_if(options.sizes, [&](int n) { return n > most; });
    if (options.sizes.empty()) options.sizes = {most};
  }
  const auto grid = [&](int n) { return samples(n, n); };
  errors_ = context_.report.timed("error against time", [&] {
    return on_samples([&] { return error_against_time(*exact_, *fragments_, grid, options); });
  });
  if (std::all_of(errors_.begin(), errors_.end(), [](const auto& e) { return e.samples.is_explained(); })) return;
  context_.progress.clear();
  tell("hsr: check failed: differences in the table are unexplained\n");
  is_right_ = false;
}

Drawing DrawCommand::drawn(const DrawingOptions& options) const {
  if (a_.outline_only) {
    const Regions all = union_of_all(*exact_, *fragments_);
    return draw(scene_.mesh, scene_.view(), lines_, options, &all);
  }
  if (!a_.fill || options.in_frame_units) return draw(scene_.mesh, scene_.view(), lines_, options);
  const Regions regions = a_.fills.regions(*exact_, scene_.model, *fragments_);
  return draw(scene_.mesh, scene_.view(), lines_, options, &regions);
}

void DrawCommand::draw_in_model_units() {
  if (!request_.wants(Format::dxf)) return;
  const DrawingOptions options = in_model_units(request_.drawing, drawing_->scale);
  model_drawing_ = context_.report.timed("drawing in units of the model", [&] { return drawn(options); });
  model_drawing_->pens = drawing_->pens;
  decisions_ += model_drawing_->decisions;
}

void DrawCommand::draw_page() {
  if (!request_.wants_picture()) return;
  context_.progress.stage("drawing");
  drawing_ = context_.report.timed("drawing", [&] { return drawn(request_.drawing); });
  decisions_ += drawing_->decisions;
  describe(context_.report, *drawing_);
  if (drawing_->polylines.empty() && !scene_.mesh.edges.empty())
    context_.note("the drawing is empty: " + empty_drawing(a_, request_.lines.frame.has_value(), lines_, *drawing_));
  if (const std::string dot = note_on_size(); !dot.empty()) context_.note(dot);
  if (!drawing_->fits)
    context_.note(fmt::format("at scale {} the drawing is larger than the page {}: --scale fit makes it fit", a_.page.scale,
                              a_.page.page));
}

/// Of a picture that a field of view frames, nothing: it is as large as that.
std::string DrawCommand::note_on_size() const {
  if (request_.drawing.field_of_view || scene_.mesh.edges.empty()) return "";
  if (!scene_.view().is_perspective()) {
    const PaperRectangle all = paper_rectangle(scene_.mesh, scene_.view());
    return note_on_dot(all.right - all.left, all.top - all.bottom, request_.drawing.scale, request_.drawing.unit);
  }
  if (drawing_->points.empty() || !(drawing_->scale > 0)) return "";
  const auto extent = [&](auto coordinate) {
    const auto [low, high] = std::ranges::minmax(drawing_->points, {}, coordinate);
    return static_cast<double>(coordinate(high) - coordinate(low)) / 1000 / drawing_->scale;
  };
  return note_on_dot(extent([](const PaperPoint& p) { return p.x; }), extent([](const PaperPoint& p) { return p.y; }),
                     request_.drawing.scale, request_.drawing.unit);
}

void DrawCommand::write() {
  Report& report = context_.report;
  report.set_decisions(decisions_);
  if (!scene_.view().is_perspective()) report.leave_out("near plane", "a parallel view has none");
  if (!request_.wants_picture()) report.leave_out("drawing", "no picture was asked for");
  if (request_.wants(Format::json) && scene_.chosen.field_of_view)
    report.leave_out("frame", "JSON has all edges, in the picture or not");
  context_.progress.stage("writing");
  report.timed("write", [&] {
    for (const Output& output : request_.outputs) {
      const std::string bytes = bytes_of(output.format);
      context_.write(output.path, bytes, summary_of(output.format, bytes));
    }
  });
  context_.finish();
}

std::string DrawCommand::bytes_of(Format format) const {
  if (format == Format::csv) return error_csv(errors_);
  if (format == Format::json)
    return lines_json(scene_.mesh, scene_.view(), lines_,
                      {a_.formats.exact ? Numbers::exact : Numbers::rounded, a_.fill ? &*fragments_ : nullptr, a_.why,
                       &objects_, request_.drawing.section});
  SvgOptions captions = scene_.captions();
  captions.id_prefix = a_.formats.id_prefix;
  WriteOptions options = page_options(format, captions, scale_in_title(*drawing_, request_.drawing, a_.page), request_.size);
  add_dxf(options, a_.formats.dxf_release, request_.drawing.unit, drawing_->scale);
  return written(format == Format::dxf ? *model_drawing_ : *drawing_, name_of(format), options);
}

std::string DrawCommand::summary_of_page(bool has_fills) const {
  std::string text = paper_size(drawing_->width, drawing_->height);
  const bool is_empty = drawing_->polylines.empty() && drawing_->fills.fills.empty();
  if (!is_empty) text += ", " + scale_text(drawing_->scale, request_.drawing.unit, a_.page, scene_.view().is_perspective());
  text += ", " + counted_lines(*drawing_);
  if (a_.page.sort == "pen") {
    const PenTravel travel = pen_travel(*drawing_);
    text += fmt::format(", pen down {:.2f} m, up {:.2f} m", travel.down / 1000, travel.up / 1000);
  }
  return a_.fill && !a_.outline_only && has_fills ? text + ", " + counted(drawing_->fills.fills.size(), "filled area") : text;
}

/// What is in a file of that format.
std::string DrawCommand::summary_of(Format format, const std::string& bytes) const {
  switch (format) {
    case Format::svg:
    case Format::pdf:
    case Format::eps:
    case Format::tex:
    case Format::hpgl:
      return summary_of_page(format != Format::hpgl);
    case Format::dxf:
      return model_size(*model_drawing_, request_.drawing.unit) + ", " + counted_lines(*model_drawing_);
    case Format::png:
      return pixel_size(bytes);
    case Format::csv:
      return counted(errors_.size(), "row");
    case Format::json:
      break;
  }
  const std::string text = counted(lines_.lines.size(), "line");
  return a_.fill ? text + ", " + counted(fragments_->fragments.size(), "fragment") : text;
}

/// Plain doubles may contradict themselves: then there is no result to show, and that is no defect.
void run(const DrawArguments& a, UnfinishedFiles& unfinished) {
  try {
    DrawCommand(a, unfinished).run();
  } catch (const std::logic_error& e) {
    if (a.arithmetic != "double") throw;
    throw InputError(std::string("--arithmetic double: plain doubles contradict themselves on this model (") + e.what() +
                     "); expected staged for a drawing");
  }
}

/// "plan-2.svg"
std::string numbered(const std::string& path, std::size_t k) {
  const std::filesystem::path p(path);
  return (p.parent_path() / (p.stem().string() + "-" + std::to_string(k) + p.extension().string())).string();
}

/// One drawing for each plane.
void run_each(const DrawArguments& a, UnfinishedFiles& unfinished) {
  if (a.view.sections.empty()) throw InputError("--section-each: found no --section, expected one for each drawing");
  for (const std::string& output : a.outputs)
    if (output.ends_with(":-")) throw InputError("--section-each: found " + output + ", expected files, one for each drawing");
  for (std::size_t k = 0; k < a.view.sections.size(); ++k) {
    DrawArguments one = a;
    one.section_each = false;
    one.view.sections = {a.view.sections[k]};
    for (std::string& output : one.outputs) output = numbered(output, k + 1);
    if (!one.common.report.empty() && one.common.report != "-") one.common.report = numbered(one.common.report, k + 1);
    run(one, unfinished);
  }
}

}  // namespace

void add_draw(CommandLine& command, UnfinishedFiles& unfinished) {
  auto a = std::make_shared<DrawArguments>();
  Options options = a->add_to(command);
  options.on_run([a, &unfinished] { a->section_each ? run_each(*a, unfinished) : run(*a, unfinished); });
}

}  // namespace hsr::cli
