#include "hsr/cli/command_context.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>

#include "geometry/error.h"
#include "hsr/cli/chord.h"
#include "hsr/cli/messages.h"
#include "hsr/cli/model_defaults.h"
#include "hsr/cli/model_section.h"

namespace hsr::cli {

using namespace internal;

void CommonArguments::add_threads_to(Options& options) {
  options.add("--threads", threads, "N", "At most this many threads [all]; the result is the same");
}

void CommonArguments::add_report_to(Options& options, const std::string& what) {
  options.add("--report", report, "FILE", what + " as JSON; - for the standard output");
}

void CommonArguments::add_quiet_to(Options& options, const std::string& help) { options.add_flag("-q,--quiet", quiet, help); }

std::string ViewedModel::name() const { return std::filesystem::path(model.name).filename().string(); }

SvgOptions ViewedModel::captions() const { return {name(), "view: " + chosen.title}; }

CommandContext::CommandContext(const CommonArguments& common, const std::vector<std::string>& models,
                               std::vector<std::string> outputs, UnfinishedFiles& unfinished)
    : progress(common.quiet), common_(common), outputs_(unfinished) {
  outputs.push_back(common.report);
  check_outputs(models, outputs);
  if (!common.threads) return;
  if (*common.threads < 1) throw InputError("--threads: found " + std::to_string(*common.threads) + ", expected 1 or more");
  // For as long as the process lives: to end a limit oneTBB starts threads, and where that fails it ends the process.
  alignas(tbb::global_control) static std::array<std::byte, sizeof(tbb::global_control)> place;
  static const auto* const limit = new (place.data())
      tbb::global_control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(*common.threads));
  (void)limit;
}

ViewedModel CommandContext::read(const ModelArguments& models, const ViewOptions& view, double tolerance,
                                 const std::string& unit, const DrawingOptions& page) {
  progress.stage("reading");
  OpenedModels opened = report.timed("read", [&] { return models.open(unit, view.up_axis); });
  const auto viewed = [&](std::optional<double> chord) {
    ViewedModel of_chord{report.timed("read", [&] { return opened.model(chord); }), {}, {}};
    progress.stage("faces");
    of_chord.mesh = report.timed("mesh", [&] { return make_mesh(of_chord.model.points, of_chord.model.polygons, tolerance); });
    of_chord.chosen = choose_view(view, of_chord.mesh, of_chord.model);
    return of_chord;
  };
  ViewedModel coarse = viewed({});
  if (!opened.have_surfaces()) return coarse;
  // The scale is known once the view is, for which any mesh will do.
  DrawingOptions at_scale = page;
  at_scale.unit = unit_of(unit, coarse.model);
  at_scale.field_of_view = coarse.chosen.field_of_view;
  // The middle of a chord is to be near enough to the circle that it is to become an arc of.
  const double on_paper = page.fit_arcs > 0 ? std::min(models.chord, page.fit_arcs) : models.chord;
  return viewed(chord_for(coarse.mesh, coarse.chosen.view, at_scale, on_paper) * at_scale.unit);
}

void CommandContext::find_section(const ViewedModel& model, const SceneView& scene, const EdgeClasses& classes,
                                  DrawingOptions& drawing, std::optional<Section>& found) {
  if (!model.view().has_section()) return;
  progress.stage("section");
  const std::string text =
      report.timed("section", [&] { return cli::find_section(model.model, scene, classes, drawing, found); });
  report.set("section", {{"caps", found->caps.size()},
                         {"rings", found->rings.size()},
                         {"lines", found->lines.size()},
                         {"open_outlines", found->open_outlines}});
  if (!text.empty()) note(text);
}

void CommandContext::note(const std::string& text) {
  if (is_quiet()) return;
  progress.clear();
  tell("hsr: note: {}\n", text);
}

void CommandContext::say_notes_of(const ViewedModel& viewed) {
  for (const std::string& text : viewed.model.notes) note(text);
  if (!viewed.chosen.note.empty()) note(viewed.chosen.note);
  if (!viewed.chosen.up_axis_note.empty()) note(viewed.chosen.up_axis_note);
}

void CommandContext::write(const std::string& path, const std::string& bytes, const std::string& summary) {
  outputs_.write(path, bytes);
  written_.push_back((path == "-" ? "standard output" : path) + ": " + summary);
}

void CommandContext::finish() {
  if (reports()) write(common_.report, report.text(), "report");
  outputs_.commit();
  progress.clear();
  if (is_quiet()) return;
  for (const std::string& line : written_) tell("hsr: {}\n", line);
}

void CommandContext::say_written(const OutputDirectory& directory, const std::string& page) {
  progress.clear();
  if (!is_quiet()) tell("hsr: {}: {} files, open {}\n", directory.path(), directory.files(), directory.path(page));
}

}  // namespace hsr::cli
