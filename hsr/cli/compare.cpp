#include <fmt/core.h>

#include <cctype>
#include <memory>

#include "geometry/error.h"
#include "hsr/cli/command_context.h"
#include "hsr/cli/commands.h"
#include "hsr/cli/directory.h"
#include "hsr/cli/explained_pages.h"
#include "hsr/cli/messages.h"
#include "hsr/cli/page_arguments.h"
#include "hsr/cli/scene_arguments.h"
#include "hsr/drawing/shading.h"
#include "study/attempt.h"
#include "study/comparison.h"
#include "study/comparison_csv.h"
#include "study/comparison_page.h"
#include "study/comparison_plots.h"

namespace hsr::cli {

using namespace internal;

namespace {

struct CompareArguments {
  ModelArguments models;
  std::string directory;
  ViewOptions view;
  SceneArguments scene;
  int size = 1024, runs = 3, threads = 1;
  std::uint64_t seed = 1;
  CommonArguments common;
};

const char* const examples = R"(Examples:
  hsr compare part.stl -o part_compared                open part_compared/index.html
  hsr compare part.stl -o part_compared --view front
  hsr compare city.ply -o city --eye 20,-30,15 --size 512

Writes index.html (needs nothing else), table.csv, report.json, plots/*.svg, pictures/*.png and explain/*.html (the methods step by step, on
this model if it has at most 200 faces). Exit status 1: an exact
method was wrong.)";

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
  report.set("faces", c.faces);
  report.set("triangles", c.triangles);
  report.set("size", c.size);
  report.set("threads", c.threads);
  Report::Json methods = Report::Json::array(), growth = Report::Json::array(), stages = Report::Json::array();
  for (const ComparedMethod& m : c.methods) methods.push_back(json_of(m));
  for (const Growth& g : c.growth)
    growth.push_back({{"method", g.method}, {"triangles", g.faces}, {"seconds", g.seconds}, {"slope", g.slope}});
  for (const ComparedStage& s : c.stages)
    stages.push_back(
        {{"stage", s.stage}, {"kind", s.kind}, {"seconds", s.seconds}, {"without", s.without}, {"result", s.result}});
  report.set("supersampling", json_of(c.supersampling));
  report.set("transparency", json_of(c.transparency));
  report.set("methods", std::move(methods));
  report.set("growth", std::move(growth));
  report.set("stages", std::move(stages));
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

void check(const CompareArguments& a) {
  a.models.check();
  if (a.size < 16 || a.size > 4096)
    throw InputError(fmt::format("--size: found {}, expected 16 to 4096 samples each way", a.size));
  if (a.runs < 1) throw InputError(fmt::format("--runs: found {}, expected 1 or more", a.runs));
  if (a.threads < 1) throw InputError(fmt::format("--threads: found {}, expected 1 or more", a.threads));
}

Comparison compared(const CompareArguments& a, const ViewedModel& viewed, CommandContext& context) {
  DrawingOptions drawing_options;
  drawing_options.field_of_view = viewed.chosen.field_of_view;
  ComparisonOptions options;
  options.size = a.size;
  options.runs = a.runs;
  options.threads = a.threads;
  options.seed = a.seed;
  options.coplanar = a.scene.which_coplanar();
  options.progress = [&](const std::string& stage, double done) { context.progress.show(stage, done); };
  const auto samples = [&](int size) { return samples_for(viewed.view(), viewed.mesh, drawing_options, size, size); };
  return context.report.timed(
      "compare", [&] { return on_samples([&] { return compare(viewed.mesh, viewed.view(), samples, options); }); });
}

void write_pictures(const Comparison& comparison, const std::vector<ComparisonImages>& images, OutputDirectory& directory) {
  directory.write("pictures/exact.png", images[0].shown);
  for (const ComparedMethod& m : comparison.methods) {
    if (m.picture < 0) continue;
    const ComparisonImages& i = images[static_cast<std::size_t>(m.picture)];
    const std::string name = "pictures/" + file_name(m.name());
    directory.write(name + ".png", i.shown);
    directory.write(name + "-difference.png", i.mistakes);
    if (!i.depth.empty()) directory.write(name + "-depth.png", i.depth);
  }
}

/// The pages to which the names of methods lead: of this scene where it can be followed, else of examples.
void explain_methods(const ViewedModel& viewed, OutputDirectory& directory) {
  const ExplainedScene scene{viewed.model, viewed.mesh, viewed.view(), viewed.name() + ", view " + viewed.chosen.title};
  constexpr int size = 16;
  const Attempt tried = attempt([&] { check_explainable(scene); });
  write_explained(directory, "explain/", explained_methods(), tried.ending == Ending::done ? &scene : nullptr, size, false);
}

/// What the page says of its making.
PageText page_text(const CompareArguments& a, const ViewedModel& viewed, const Comparison& comparison) {
  PageText text;
  text.title = viewed.name() + ": visibility methods compared";
  text.facts = {
      fmt::format("{}: {} faces, {} triangles", viewed.name(), comparison.faces, comparison.triangles),
      "view: " + viewed.chosen.title,
      fmt::format("{0} x {0} samples in the pictures below; {1} runs of each method, {2} thread(s)", a.size, a.runs, a.threads),
      machine_and_date(), std::string("hsr ") + HSR_VERSION};
  if (a.scene.which_coplanar() == Coplanar::last)
    text.facts.emplace_back("of faces that coincide the last in the file is on top");
  return text;
}

void run(const CompareArguments& a, UnfinishedFiles& unfinished) {
  check(a);
  OutputDirectory directory(a.directory, unfinished);
  CommandContext context(a.common, a.models.models, {}, unfinished);
  if (!a.view.sections.empty())
    throw InputError("--section: the methods of compare know no caps, expected a view without a section");
  const ViewedModel viewed = context.read(a.models, a.view);
  context.say_notes_of(viewed);
  const Comparison comparison = compared(a, viewed, context);

  context.progress.stage("writing");
  const std::vector<Colour> colours = face_colours(viewed.model, viewed.mesh, viewed.view());
  std::vector<ComparisonImages> images;
  for (const ComparedPicture& picture : comparison.pictures) images.push_back(comparison_images(viewed.mesh, picture, colours));
  write_pictures(comparison, images, directory);
  for (const NamedPlot& p : comparison_plots(comparison)) directory.write("plots/" + p.name + ".svg", plot_file(p.plot));
  directory.write("table.csv", comparison_csv(comparison));
  explain_methods(viewed, directory);
  directory.write("index.html", comparison_page(comparison, images, page_text(a, viewed, comparison)));
  describe(context.report, comparison);
  context.report.set("view", viewed.chosen.title);
  context.report.set("machine", machine_and_date());
  directory.write("report.json", context.report.text());
  context.say_written(directory, "index.html");

  // An exact method that shows another face than the caster is a defect of hsr, and never goes unsaid.
  for (const ComparedMethod& m : comparison.methods)
    if (m.is_exact && m.wrong > 0) {
      tell("hsr: compare: {} shows another face than the nearest at {} samples: please report it\n", m.name(), m.wrong);
      throw CheckFailed();
    }
}

}  // namespace

void add_compare(CommandLine& command, UnfinishedFiles& unfinished) {
  auto a = std::make_shared<CompareArguments>();
  Options options =
      command.add_verb("compare", "All methods on one scene: error against run time, pictures, an HTML page", examples);
  a->models.add_to(options);
  options.add("-o,--output", a->directory, "DIR", "The directory of the results; made if it is not there").required();
  a->models.add_objects_without_ghosts_to(options);
  a->view.add_to(options);
  a->scene.add_to(options);
  options.begin_group("Runs");
  options.add("--size", a->size, "N", "Samples each way; sizes from a quarter to twice this are compared").with_default_shown();
  options.add("--runs", a->runs, "N", "Of each method, in shuffled order; slow ones run once").with_default_shown();
  options.add("--threads", a->threads, "N", "Of what is timed").with_default_shown();
  options.add("--seed", a->seed, "N", "Of the shuffling").with_default_shown();
  options.begin_group("Report");
  a->common.add_quiet_to(options, "Say nothing but what is wrong");
  options.on_run([a, &unfinished] { run(*a, unfinished); });
}

}  // namespace hsr::cli
