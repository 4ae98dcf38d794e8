#include <fmt/format.h>
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>

#include "geometry/error.h"
#include "geometry/rounded_sum.h"
#include "hsr/check/error_against_time.h"
#include "hsr/check/error_csv.h"
#include "hsr/check/fragment_check.h"
#include "hsr/check/z_buffer_check.h"
#include "hsr/cli/commands.h"
#include "hsr/cli/line_arguments.h"
#include "hsr/cli/messages.h"
#include "hsr/cli/outputs.h"
#include "hsr/cli/page_arguments.h"
#include "hsr/cli/progress.h"
#include "hsr/cli/report.h"
#include "hsr/cli/view_options.h"
#include "hsr/drawing/drawing.h"
#include "hsr/drawing/shading.h"
#include "hsr/io/read/read.h"
#include "hsr/io/write/format.h"
#include "hsr/io/write/json.h"
#include "hsr/io/write/png.h"
#include "hsr/io/write/svg.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/surfaces/regions.h"
#include "hsr/surfaces/roberts_surfaces.h"
#include "hsr/surfaces/visible_fragments.h"

namespace hsr::cli {

namespace {

struct DrawArguments {
  std::string model;
  std::vector<std::string> outputs;
  ViewOptions view;
  LineArguments lines;
  bool fill = false;
  std::string merge = "none";
  bool check = false;
  std::string hidden = "none";
  PageArguments page;
  bool exact = false, why = false, quiet = false;
  std::optional<int> threads;
  std::string arithmetic = "staged", report;
};

const char* const examples = R"(Examples:
  hsr draw part.stl -o part.svg                            iso view on A4
  hsr draw part.stl -o part.svg --hidden dashed            hidden lines dashed, on their own layers
  hsr draw part.obj -o front.svg -o front.png --view front --scale 1:2
  hsr draw house.glb -o house.svg --eye 20,-30,15 --up-axis y
  hsr draw part.ply -o lines.json --edges all --exact      every edge, parameters as "p/q"
  hsr draw part.stl -o part.svg --fill                     filled, with the lines on top
  hsr draw part.stl -o part.svg -o errors.csv              and how wrong a z-buffer is, size by size, against its time
  hsr draw part.ply -o lines.json --hidden dashed --why    and which faces hide what)";

Arithmetic parse_arithmetic(const std::string& text) {
  static const std::map<std::string, Arithmetic> names = {{"staged", Arithmetic::staged},
                                                          {"double", Arithmetic::double_only},
                                                          {"interval", Arithmetic::interval},
                                                          {"rational", Arithmetic::rational}};
  return names.at(text);
}

void describe(Report& report, const Model& model, const Mesh& mesh, const VisibleLines& lines) {
  report["model"] = {{"name", model.name},
                     {"format", model.format},
                     {"points", mesh.points.size()},
                     {"faces", mesh.faces.size()},
                     {"triangles", mesh.triangles.size()},
                     {"edges", mesh.edges.size()}};
  std::uint64_t visible = 0, hidden = 0;
  for (const Line& line : lines.lines)
    for (std::uint32_t k = 0; k < line.intervals(); ++k) ++(line.hidden(k) ? hidden : visible);
  report["lines"] = {{"edges", lines.lines.size()}, {"visible_intervals", visible}, {"hidden_intervals", hidden}};
  report["method"] = lines.plan.method;
  report["pairs"] = lines.pairs;
  for (const LeftOut& stage : lines.plan.left_out) report.leave_out(stage.stage, stage.why);
}

/// The visible area of each face and each object that has one, in squares of the view's frame.
Report::Json areas_json(const Model& model, const Mesh& mesh, const View& view, const VisibleFragments& fragments, bool exact) {
  const std::vector<Rational> of_fragment = visible_areas(mesh, view, fragments);
  using Areas = std::vector<const Rational*>;
  std::map<std::uint32_t, Areas> of_face, of_object;
  Areas all;
  for (std::size_t k = 0; k < of_fragment.size(); ++k) {
    const std::uint32_t face = mesh.face_of[fragments.fragments[k].facet].value;
    of_face[face].push_back(&of_fragment[k]);
    all.push_back(&of_fragment[k]);
    if (model.face_object.empty() || model.face_object[face] == 0xffffffffU) continue;
    of_object[model.face_object[face]].push_back(&of_fragment[k]);
  }
  const auto number = [&](const Areas& areas) -> Report::Json {
    if (!exact) return rounded_sum(areas);
    Rational sum;
    for (const Rational* x : areas) sum = sum + *x;
    return sum.to_string();
  };
  Report::Json faces = Report::Json::array(), objects = Report::Json::array();
  for (const auto& [face, areas] : of_face) faces.push_back({face, number(areas)});
  for (const auto& [object, areas] : of_object) objects.push_back({model.objects[object], number(areas)});
  return {{"fragments", fragments.fragments.size()},
          {"rings", fragments.rings()},
          {"visible_area", number(all)},
          {"visible_area_of_faces", faces},
          {"visible_area_of_objects", objects}};
}

/// The fragments, and z-buffers, against the exact caster.
struct Check {
  FragmentCheck fragments;
  ZBufferCheck single, twice;

  bool is_right() const { return fragments.is_right() && single.is_explained() && twice.is_explained(); }
};

Check check(const SceneView& scene, const VisibleFragments& fragments, const SampleGrid& samples) {
  const Mesh& mesh = scene.mesh();
  const View& view = scene.view();
  const Image<TriangleId> nearest = cast(scene, samples).triangles;
  return {check_fragments(scene, fragments, samples, nearest),
          check_z_buffer(mesh, view, samples, z_buffer<float>(mesh, view, samples), nearest),
          check_z_buffer(mesh, view, samples, z_buffer<double>(mesh, view, samples), nearest)};
}

Report::Json check_json(const Check& check) {
  const FragmentCheck& f = check.fragments;
  const auto of = [](const ZBufferCheck& z) {
    return Report::Json{
        {"wrong", z.wrong}, {"depth", z.depth}, {"edge", z.edge}, {"unbounded", z.unbounded}, {"other", z.other}};
  };
  return {{"samples", f.samples},
          {"covered", f.covered},
          {"wrong", f.wrong},
          {"overlapping", f.overlapping},
          {"z_buffer", {{"float", of(check.single)}, {"double", of(check.twice)}}}};
}

void say(const Check& check) {
  const FragmentCheck& f = check.fragments;
  const auto name = [](FaceId face) { return face.is_valid() ? "face " + std::to_string(face.value) : std::string("nothing"); };
  const auto say_samples = [&](const std::vector<WrongSample>& samples) {
    for (const WrongSample& w : samples)
      tell("hsr: check failed: at sample {}, {}: found {}, expected {}\n", w.i, w.j, name(w.painted), name(w.cast));
  };
  if (f.is_right()) {
    tell("hsr: check: the fragments show the nearest face at each of {} samples, {} of them on the model\n", f.samples,
         f.covered);
  } else {
    tell("hsr: check failed: {} of {} samples show another face than the nearest, {} are painted twice\n", f.wrong, f.samples,
         f.overlapping);
    say_samples(f.first_wrong);
  }
  for (const auto& [numbers, z] : {std::pair("floats", check.single), std::pair("doubles", check.twice)}) {
    std::string why;
    const auto add = [&](std::uint64_t count, const char* text) {
      if (count > 0) why += fmt::format("{} {} {}", why.empty() ? ":" : ",", count, text);
    };
    add(z.depth, "where depths differ by less than it tells");
    add(z.edge, "at edges");
    add(z.unbounded, "of faces that have no area in its numbers");
    add(z.other, "unexplained");
    tell("hsr: check{}: a z-buffer of {} shows another face at {} samples{}\n", z.is_explained() ? "" : " failed", numbers,
         z.wrong, why);
    say_samples(z.first_other);
  }
}

/// What was asked for and does nothing here.
void note_idle_options(const DrawArguments& a, const std::vector<Format>& formats) {
  const auto any = [&](Format f) { return std::find(formats.begin(), formats.end(), f) != formats.end(); };
  const auto note = [](const char* option, const char* format) {
    tell("hsr: note: {} has no effect without an output that ends in .{}\n", option, format);
  };
  if (a.why && !any(Format::json)) note("--why", "json");
  if (a.exact && !any(Format::json)) note("--exact", "json");
  if (!a.page.size.empty() && !any(Format::png) && !any(Format::csv) && !a.check) note("--size", "png");
}

/// Why a drawing has no line, for one who wonders.
std::string empty_drawing(const DrawArguments& a, bool in_frame, const VisibleLines& lines, const Drawing& drawing) {
  if (lines.lines.empty() && in_frame)
    return "no edge of the classes " + a.lines.edges +
           " is in the picture: see --target, --fov and --near; --edges all draws every edge";
  if (lines.lines.empty())
    return "no edge of this model is of the classes " + a.lines.edges + " in this view: --edges all draws every edge";
  const bool nothing_ahead =
      std::all_of(lines.lines.begin(), lines.lines.end(), [](const Line& l) { return l.intervals() == 0; });
  if (nothing_ahead && !a.view.eye.empty())
    return "nothing of the model is beyond the near plane, or seen as more than a point: see --target and --near";
  if (nothing_ahead) return "every edge is seen as a point";
  if (drawing.short_dropped > 0)
    return "every line is shorter than 0.01 mm at scale " + a.page.scale + ": --scale fit shows the whole";
  return "every line is hidden, or outside the frame: --hidden dashed shows what is hidden";
}

void run(const DrawArguments& a, UnfinishedFiles& unfinished) {
  // Everything that can be refused is refused before the long work.
  std::vector<Format> formats;
  for (const std::string& path : a.outputs)
    formats.push_back(format_of(path, std::array{Format::svg, Format::png, Format::json, Format::csv}));
  std::vector<std::string> files = a.outputs;
  files.push_back(a.report);
  check_outputs(a.model, files);
  if (a.lines.method == "appel" && a.why)
    throw InputError(
        "--why: appel counts the faces that hide and does not know which they are, expected --method roberts or auto");
  LineOptions line_options = a.lines.options();
  line_options.why = a.why;
  SceneOptions scene_options = a.lines.scene_options();
  scene_options.arithmetic = parse_arithmetic(a.arithmetic);
  DrawingOptions drawing_options = a.page.options();
  drawing_options.hidden = a.hidden == "none"     ? HiddenLines::none
                           : a.hidden == "dashed" ? HiddenLines::dashed
                                                  : HiddenLines::solid;
  drawing_options.arithmetic = scene_options.arithmetic;
  drawing_options.leave_out_near = true;
  std::optional<PixelSize> size;
  if (!a.page.size.empty()) size = parse_size(a.page.size);
  if (a.threads && *a.threads < 1) throw InputError("--threads: found " + std::to_string(*a.threads) + ", expected 1 or more");
  std::optional<tbb::global_control> threads;
  if (a.threads) threads.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(*a.threads));

  Report report;
  ProgressLine progress(a.quiet);
  progress.stage("reading");
  const Model model = report.timed("read", [&] { return read_model(a.model); });
  progress.stage("faces");
  const Mesh mesh = report.timed("mesh", [&] { return make_mesh(model.points, model.polygons); });
  const ChosenView chosen = choose_view(a.view, mesh);
  drawing_options.field_of_view = chosen.field_of_view;
  const bool any_json = std::find(formats.begin(), formats.end(), Format::json) != formats.end();
  // Drawings only: JSON is complete.
  if (!any_json) line_options.frame = frame_size(chosen.view, drawing_options);
  if (!a.quiet) {
    progress.clear();
    note_idle_options(a, formats);
    for (const std::string& note : model.notes) tell("hsr: note: {}\n", note);
    if (!chosen.note.empty()) tell("hsr: note: {}\n", chosen.note);
    if (mesh.edges.empty()) tell("hsr: note: {}: every face has no area, the drawing is empty\n", a.model);
  }

  progress.stage("visible lines");
  line_options.progress = [&](double done) { progress.show(done); };
  const bool measures = std::find(formats.begin(), formats.end(), Format::csv) != formats.end();
  const bool with_fragments = a.fill || a.check || measures;
  scene_options.hidden_lines = any_json || a.why || drawing_options.hidden != HiddenLines::none;
  const SceneView scene(mesh, chosen.view, scene_options);
  // Fragments and checks are compared with what is exact.
  const SceneView exact = scene_options.arithmetic == Arithmetic::staged ? scene : SceneView(mesh, chosen.view);
  // Fragments are bounded by the lines of all edges: these are found once, and the drawing takes some of them.
  const bool finds_all = with_fragments && !a.why && line_options.method != LineMethod::roberts && fragments_use_lines(scene);
  std::optional<VisibleLines> all_lines;
  if (finds_all) {
    LineOptions every = line_options;
    every.classes.fill(true);
    every.frame = {};
    all_lines = report.timed("lines", [&] { return visible_lines(scene, every); });
  }
  const VisibleLines lines = finds_all ? lines_of_classes(*all_lines, line_options.classes)
                                       : report.timed("lines", [&] { return visible_lines(scene, line_options); });
  describe(report, model, mesh, lines);
  DecisionCounts decisions = lines.decisions;

  std::optional<VisibleFragments> fragments;
  if (with_fragments) {
    progress.stage("visible fragments");
    FragmentOptions fragment_options;
    fragment_options.progress = line_options.progress;
    if (finds_all) fragment_options.lines = &*all_lines;
    fragments = report.timed("fragments", [&] {
      return a.lines.method == "roberts" ? roberts_surfaces(scene, fragment_options)
                                         : visible_fragments(scene, fragment_options);
    });
    all_lines.reset();
    decisions += fragments->decisions;
    if (!a.report.empty())
      report["fragments"] = report.timed("areas", [&] { return areas_json(model, mesh, chosen.view, *fragments, a.exact); });
  } else {
    report.leave_out("fragments", "neither --fill nor --check nor a csv is asked for");
  }
  bool is_right = true;
  if (a.check) {
    progress.stage("check");
    const PixelSize pixels = size.value_or(PixelSize{1024, 1024});
    const SampleGrid samples = samples_for(chosen.view, mesh, drawing_options, pixels.width, pixels.height);
    const Check found = report.timed("check", [&] { return on_samples([&] { return check(exact, *fragments, samples); }); });
    report["check"] = check_json(found);
    is_right = found.is_right();
    progress.clear();
    if (!is_right || !a.quiet) say(found);
  }
  std::vector<ErrorAgainstTime> errors;
  if (measures) {
    progress.stage("error against time");
    ErrorAgainstTimeOptions options;
    options.progress = line_options.progress;
    if (size) {
      const int most = std::max(size->width, size->height);
      std::erase_if(options.sizes, [&](int n) { return n > most; });
      if (options.sizes.empty()) options.sizes = {most};
    }
    const auto grid = [&](int n) { return samples_for(chosen.view, mesh, drawing_options, n, n); };
    errors = report.timed("error against time",
                          [&] { return on_samples([&] { return error_against_time(exact, *fragments, grid, options); }); });
    const bool is_explained = std::all_of(errors.begin(), errors.end(), [](const auto& e) { return e.samples.is_explained(); });
    progress.clear();
    if (!is_explained) tell("hsr: check failed: differences in the table are unexplained\n");
    is_right = is_right && is_explained;
  }

  const bool draws = std::any_of(formats.begin(), formats.end(), [](Format f) { return f == Format::svg || f == Format::png; });
  std::optional<Drawing> drawing;
  if (draws) {
    progress.stage("drawing");
    drawing = report.timed("drawing", [&] {
      if (!a.fill) return draw(mesh, chosen.view, lines, drawing_options);
      const Regions regions = regions_of(exact, *fragments, face_colours(model, mesh, chosen.view),
                                         a.merge == "none"       ? Merge::none
                                         : a.merge == "coplanar" ? Merge::coplanar
                                                                 : Merge::colour);
      return draw(mesh, chosen.view, lines, drawing_options, &regions);
    });
    decisions += drawing->decisions;
    report["drawing"] = {{"polylines", drawing->polylines.size()},
                         {"visible_under_visible", drawing->visible_under_visible},
                         {"hidden_under_visible", drawing->hidden_under_visible},
                         {"hidden_under_hidden", drawing->hidden_under_hidden},
                         {"near_coincident", drawing->near_coincident},
                         {"merged", drawing->merged},
                         {"short_dropped", drawing->short_dropped},
                         {"scale_mm_per_unit", drawing->scale}};
    progress.clear();
    if (drawing->polylines.empty() && !a.quiet && !mesh.edges.empty())
      tell("hsr: note: the drawing is empty: {}\n", empty_drawing(a, line_options.frame.has_value(), lines, *drawing));
    if (!drawing->fits && !a.quiet)
      tell("hsr: note: at scale {} the drawing is larger than the page {}: --scale fit makes it fit\n", a.page.scale,
           a.page.page);
  }
  report.set_decisions(decisions);
  if (!chosen.view.is_perspective()) report.leave_out("near plane", "a parallel view has none");
  if (!draws) report.leave_out("drawing", "no picture was asked for");
  if (any_json && chosen.field_of_view) report.leave_out("frame", "JSON has all edges, in the picture or not");

  progress.stage("writing");
  OutputFiles output(unfinished);
  report.timed("write", [&] {
    for (std::size_t i = 0; i < a.outputs.size(); ++i) {
      std::string bytes;
      if (formats[i] == Format::json)
        bytes = lines_json(mesh, chosen.view, lines,
                           {a.exact ? Numbers::exact : Numbers::rounded, a.fill ? &*fragments : nullptr, a.why});
      else if (formats[i] == Format::svg)
        bytes = svg(*drawing, {std::filesystem::path(model.name).filename().string(), "view: " + chosen.title});
      else if (formats[i] == Format::csv)
        bytes = error_csv(errors);
      else
        bytes = png(*drawing, size);
      output.write(a.outputs[i], bytes);
    }
  });
  if (!a.report.empty()) output.write(a.report, report.text());
  output.commit();
  if (!is_right) throw CheckFailed();
}

/// Plain doubles may contradict themselves: then there is no result to show, and that is no defect.
void run_guarded(const DrawArguments& a, UnfinishedFiles& unfinished) {
  try {
    run(a, unfinished);
  } catch (const std::logic_error& e) {
    if (a.arithmetic != "double") throw;
    throw InputError(std::string("--arithmetic double: plain doubles contradict themselves on this model (") + e.what() +
                     "); expected staged for a drawing");
  }
}

}  // namespace

void add_draw(CLI::App& app, UnfinishedFiles& unfinished) {
  auto a = std::make_shared<DrawArguments>();
  CLI::App* sub = app.add_subcommand("draw", "Draw the visible lines of a model: SVG, PNG or JSON");
  sub->footer(examples);
  sub->add_option("MODEL", a->model, "OBJ, OFF, PLY, STL (each also .gz), glTF or GLB")->required();
  sub->add_option("-o,--output", a->outputs,
                  "The drawing; its ending chooses svg, png or json; csv: a table of error against run time, of the "
                  "exact fragments and of z-buffers of 256, 512, ... samples each way, up to --size [8192]; may be repeated")
      ->required()
      ->type_name("FILE");
  a->view.add_to(*sub);
  const std::string lines = "Lines";
  sub->add_option("--hidden", a->hidden, "Hidden lines: none, dashed or solid")
      ->capture_default_str()
      ->type_name("STYLE")
      ->check(CLI::IsMember({"none", "dashed", "solid"}))
      ->group(lines);
  a->lines.add_to(*sub);
  sub->add_flag("--why", a->why, "JSON: which faces hide each hidden interval")->group(lines);
  const std::string surfaces = "Surfaces";
  sub->add_flag("--fill", a->fill,
                "Fill the visible parts of faces, in the file's colours or grey by their slope; JSON: with fragments")
      ->group(surfaces);
  sub->add_option("--merge", a->merge,
                  "With --fill: unite neighbours of one colour: none, coplanar (only in one plane) or colour")
      ->capture_default_str()
      ->type_name("WHICH")
      ->check(CLI::IsMember({"none", "coplanar", "colour"}))
      ->group(surfaces);
  sub->add_flag(
         "--check", a->check,
         "Compare the visible fragments with the nearest face at each sample of --size [1024x1024], exit status 1 if they "
         "differ; and z-buffers, with the reason for each difference")
      ->group(surfaces);
  a->page.add_to(*sub);
  const std::string numbers = "Numbers";
  sub->add_flag("--exact", a->exact, "JSON: exact numbers as strings \"p/q\"")->group(numbers);
  sub->add_option("--threads", a->threads, "At most this many threads [all]; the result is the same")
      ->type_name("N")
      ->group(numbers);
  sub->add_option("--arithmetic", a->arithmetic,
                  "staged (exact, fast), or for comparison double (may be wrong!), interval, rational")
      ->capture_default_str()
      ->type_name("KIND")
      ->check(CLI::IsMember({"staged", "double", "interval", "rational"}))
      ->group(numbers);
  const std::string reporting = "Report";
  sub->add_option("--report", a->report, "Times, counts and decisions as JSON; - for the standard output")
      ->type_name("FILE")
      ->group(reporting);
  sub->add_flag("-q,--quiet", a->quiet, "No notes, no progress")->group(reporting);
  sub->callback([a, &unfinished] { run_guarded(*a, unfinished); });
}

}  // namespace hsr::cli
