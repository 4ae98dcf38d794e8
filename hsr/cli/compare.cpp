#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cctype>
#include <filesystem>
#include <memory>

#include "geometry/error.h"
#include "hsr/cli/commands.h"
#include "hsr/cli/directory.h"
#include "hsr/cli/messages.h"
#include "hsr/cli/page_arguments.h"
#include "hsr/cli/progress.h"
#include "hsr/cli/report.h"
#include "hsr/cli/view_options.h"
#include "hsr/drawing/shading.h"
#include "hsr/io/read/read.h"
#include "study/comparison.h"
#include "study/comparison_csv.h"
#include "study/comparison_page.h"
#include "study/comparison_plots.h"

namespace hsr::cli {

namespace {

struct CompareArguments {
  std::string model, directory;
  ViewOptions view;
  int size = 1024, runs = 3, threads = 1;
  std::uint64_t seed = 1;
  bool quiet = false;
};

const char* const examples = R"(Examples:
  hsr compare part.stl -o part_compared                open part_compared/index.html
  hsr compare part.stl -o part_compared --view front
  hsr compare city.ply -o city --eye 20,-30,15 --size 512

Writes index.html (needs nothing else), table.csv, report.json, plots/*.svg and pictures/*.png.)";

Report::Json json_of(const ComparedMethod& m) {
  return {{"method", m.method},
          {"numbers", m.numbers},
          {"space", m.is_object_space ? "object" : "image"},
          {"size", m.size},
          {"seconds", m.seconds},
          {"peak_bytes", m.peak_bytes},
          {"samples", m.samples},
          {"covered", m.covered},
          {"wrong", m.wrong},
          {"edge", m.edge},
          {"tie", m.tie},
          {"order", m.order},
          {"wrong_area_share", m.wrong_area_share},
          {"edge_error_pixels", m.edge_error},
          {"note", m.note}};
}

Report::Json json_of(const std::vector<ComparedColours>& compared) {
  Report::Json rows = Report::Json::array();
  for (const ComparedColours& c : compared)
    rows.push_back({{"method", c.method},
                    {"samples", c.samples},
                    {"seconds", c.seconds},
                    {"bytes", c.bytes},
                    {"mean_difference", c.mean_difference},
                    {"most_difference", c.most_difference},
                    {"changed_share", c.changed_share}});
  return rows;
}

void describe(Report& report, const Comparison& c) {
  report["faces"] = c.faces;
  report["triangles"] = c.triangles;
  report["size"] = c.size;
  report["threads"] = c.threads;
  Report::Json methods = Report::Json::array(), growth = Report::Json::array(), stages = Report::Json::array();
  for (const ComparedMethod& m : c.methods) methods.push_back(json_of(m));
  for (const Growth& g : c.growth)
    growth.push_back({{"method", g.method}, {"triangles", g.faces}, {"seconds", g.seconds}, {"slope", g.slope}});
  for (const ComparedStage& s : c.stages)
    stages.push_back(
        {{"stage", s.stage}, {"kind", s.kind}, {"seconds", s.seconds}, {"without", s.without}, {"result", s.result}});
  report["supersampling"] = json_of(c.supersampling);
  report["transparency"] = json_of(c.transparency);
  report["methods"] = std::move(methods);
  report["growth"] = std::move(growth);
  report["stages"] = std::move(stages);
  for (const LeftOut& l : c.left_out) report.leave_out(l.stage, l.why);
}

/// "z-buffer, float" -> "z-buffer-float"
std::string file_name(const std::string& text) {
  std::string name;
  for (const char c : text)
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      name += c;
    else if (!name.empty() && name.back() != '-')
      name += '-';
  return name;
}

void run(const CompareArguments& a, UnfinishedFiles& unfinished) {
  if (a.size < 16 || a.size > 4096)
    throw InputError(fmt::format("--size: found {}, expected 16 to 4096 samples each way", a.size));
  if (a.runs < 1) throw InputError(fmt::format("--runs: found {}, expected 1 or more", a.runs));
  if (a.threads < 1) throw InputError(fmt::format("--threads: found {}, expected 1 or more", a.threads));
  OutputDirectory directory(a.directory, unfinished);

  Report report;
  ProgressLine progress(a.quiet);
  progress.stage("reading");
  const Model model = report.timed("read", [&] { return read_model(a.model); });
  const Mesh mesh = report.timed("mesh", [&] { return make_mesh(model.points, model.polygons); });
  const ChosenView chosen = choose_view(a.view, mesh);
  DrawingOptions drawing_options;
  drawing_options.field_of_view = chosen.field_of_view;
  progress.clear();
  if (!a.quiet) {
    for (const std::string& note : model.notes) tell("hsr: note: {}\n", note);
    if (!chosen.note.empty()) tell("hsr: note: {}\n", chosen.note);
  }

  ComparisonOptions options;
  options.size = a.size;
  options.runs = a.runs;
  options.threads = a.threads;
  options.seed = a.seed;
  options.progress = [&](const std::string& stage, double done) { progress.show(stage, done); };
  const Comparison comparison = report.timed("compare", [&] {
    return on_samples([&] {
      return compare(
          mesh, chosen.view, [&](int size) { return samples_for(chosen.view, mesh, drawing_options, size, size); }, options);
    });
  });

  progress.stage("writing");
  const std::vector<Colour> colours = face_colours(model, mesh, chosen.view);
  std::vector<ComparisonImages> images;
  for (const ComparedPicture& picture : comparison.pictures) images.push_back(comparison_images(mesh, picture, colours));
  directory.write("pictures/exact.png", images[0].shown);
  for (const ComparedMethod& m : comparison.methods) {
    if (m.picture < 0) continue;
    const ComparisonImages& i = images[static_cast<std::size_t>(m.picture)];
    const std::string name = "pictures/" + file_name(m.name());
    directory.write(name + ".png", i.shown);
    directory.write(name + "-difference.png", i.mistakes);
    if (!i.depth.empty()) directory.write(name + "-depth.png", i.depth);
  }
  for (const NamedPlot& p : comparison_plots(comparison)) directory.write("plots/" + p.name + ".svg", plot_file(p.plot));
  directory.write("table.csv", comparison_csv(comparison));
  PageText text;
  const std::string name = std::filesystem::path(model.name).filename().string();
  text.title = name + ": visibility methods compared";
  text.facts = {
      fmt::format("{}: {} faces, {} triangles", name, comparison.faces, comparison.triangles), "view: " + chosen.title,
      fmt::format("{0} x {0} samples in the pictures below; {1} runs of each method, {2} thread(s)", a.size, a.runs, a.threads),
      machine_and_date(), std::string("hsr ") + HSR_VERSION};
  directory.write("index.html", comparison_page(comparison, images, text));
  describe(report, comparison);
  report["view"] = chosen.title;
  report["machine"] = machine_and_date();
  directory.write("report.json", report.text());
  progress.clear();
  if (!a.quiet) tell("hsr: compared: open {}\n", directory.path("index.html"));

  // An exact method that shows another face than the caster is a defect of hsr, and never goes unsaid.
  for (const ComparedMethod& m : comparison.methods)
    if (m.is_exact && m.wrong > 0) {
      tell("hsr: compare: {} shows another face than the nearest at {} samples: please report it\n", m.name(), m.wrong);
      throw CheckFailed();
    }
}

}  // namespace

void add_compare(CLI::App& app, UnfinishedFiles& unfinished) {
  auto a = std::make_shared<CompareArguments>();
  CLI::App* sub = app.add_subcommand("compare", "All methods on one scene: error against run time, pictures, an HTML page");
  sub->footer(examples);
  sub->add_option("MODEL", a->model, "OBJ, OFF, PLY, STL (each also .gz), glTF or GLB")->required();
  sub->add_option("-o,--output", a->directory, "The directory of the results; made if it is not there")
      ->required()
      ->type_name("DIR");
  a->view.add_to(*sub);
  const std::string runs = "Runs";
  sub->add_option("--size", a->size, "Samples each way; sizes from a quarter to twice this are compared")
      ->capture_default_str()
      ->type_name("N")
      ->group(runs);
  sub->add_option("--runs", a->runs, "Of each method, in shuffled order; slow ones run once")
      ->capture_default_str()
      ->type_name("N")
      ->group(runs);
  sub->add_option("--threads", a->threads, "Of what is timed")->capture_default_str()->type_name("N")->group(runs);
  sub->add_option("--seed", a->seed, "Of the shuffling")->capture_default_str()->type_name("N")->group(runs);
  sub->add_flag("-q,--quiet", a->quiet, "No notes, no progress")->group("Report");
  sub->callback([a, &unfinished] { run(*a, unfinished); });
}

}  // namespace hsr::cli
