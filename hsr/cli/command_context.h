#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hsr/cli/command_line.h"
#include "hsr/cli/directory.h"
#include "hsr/cli/model_arguments.h"
#include "hsr/cli/outputs.h"
#include "hsr/cli/progress.h"
#include "hsr/cli/report.h"
#include "hsr/cli/view_options.h"
#include "hsr/drawing/drawing.h"
#include "hsr/io/write/svg.h"
#include "hsr/model.h"
#include "hsr/scene/scene.h"

namespace hsr::cli {

using namespace internal;

/// The options that are the same for all verbs.
struct CommonArguments {
  std::optional<int> threads;
  std::string report;
  bool quiet = false;

  void add_threads_to(Options& options);
  /// @param what the report tells
  void add_report_to(Options& options, const std::string& what);
  void add_quiet_to(Options& options, const std::string& help);
};

/// A model, and how it is looked at.
struct ViewedModel {
  Model model;
  Mesh mesh;
  ChosenView chosen;

  const View& view() const { return chosen.view; }
  /// Prepared for every method. @pre this stays where it is
  SceneView prepared(const SceneOptions& options = {}) const {
    return {Scene::of(mesh, labels_of(model)), chosen.view, options};
  }
  /// The model's file name without its directories.
  std::string name() const;
  /// What a picture of it is called: its name, and "view: iso".
  internal::SvgOptions captions() const;
};

/// What every verb works with, from its options to the last file that it writes.
class CommandContext {
 public:
  /// Refuses before any work what can be refused, and limits the threads.
  /// @param models the files to read, which no output may replace @param outputs the files to write, less the report
  /// @throws InputError naming the option or the file
  CommandContext(const CommonArguments& common, const std::vector<std::string>& models, std::vector<std::string> outputs,
                 UnfinishedFiles& unfinished);
  CommandContext(const CommandContext&) = delete;
  CommandContext& operator=(const CommandContext&) = delete;

  Report report;
  ProgressLine progress;

  bool is_quiet() const { return common_.quiet; }
  bool reports() const { return !common_.report.empty(); }

  /// Reads the models, as one, and chooses the view.
  /// @param tolerance below which points are one @param unit of all models; empty: what each of them says
  /// @param page for which surfaces become meshes; its unit is passed over
  ViewedModel read(const ModelArguments& models, const ViewOptions& view, double tolerance = 0, const std::string& unit = {},
                   const DrawingOptions& page = {});
  /// What the view's section cuts closed bodies to, told to the drawing, the report and the user. @param found outlives the drawing
  void find_section(const ViewedModel& model, const SceneView& scene, const EdgeClasses& classes, DrawingOptions& drawing,
                    std::optional<Section>& found);
  /// Says something about the input or the options, unless quiet.
  void note(const std::string& text);
  /// The notes that come with a model and its view.
  void say_notes_of(const ViewedModel& viewed);

  /// Writes an output; no output is in place before finish().
  /// @param summary what is in it, for one who wonders: "210 x 297 mm, scale 1:2 (0.5 mm per unit), 123 lines"
  void write(const std::string& path, const std::string& bytes, const std::string& summary);
  /// Writes the report if one is asked for, puts all outputs in place, and says so, each in one line, unless quiet.
  void finish();
  /// The same for a verb that writes a directory and keeps its report there. @param page the file to begin with
  void say_written(const OutputDirectory& directory, const std::string& page);

 private:
  const CommonArguments& common_;
  OutputFiles outputs_;
  std::vector<std::string> written_;  // a line for each output
};

}  // namespace hsr::cli
