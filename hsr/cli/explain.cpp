#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "geometry/error.h"
#include "hsr/cli/command_context.h"
#include "hsr/cli/commands.h"
#include "hsr/cli/directory.h"
#include "hsr/cli/explained_pages.h"

namespace hsr::cli {

using namespace internal;

namespace {

struct ExplainArguments {
  std::vector<std::string> words;
  ModelArguments models;
  std::string directory, method = "all";
  ViewOptions view;
  int size = 16;
  CommonArguments common;
};

/// "  depth-sort   faces from far to near: ..."
std::string list_of_methods() {
  std::string text;
  for (const ExplainedMethod& m : explained_methods()) text += fmt::format("  {:<12} {}\n", m.name, m.about);
  return text;
}

std::string examples() {
  return R"(Examples:
  hsr explain -o lessons                   every method on a scene made for it, and two lessons; open lessons/index.html
  hsr explain depth-sort -o sorted         one method; open sorted/depth-sort.html
  hsr explain all part.stl -o part_shown   every method on one model, of at most 200 faces
  hsr explain z-buffer part.stl -o part_shown --view front --size 24

Writes METHOD.html (needs nothing else; by mouse, finger or keyboard: arrows, space, Home and End, digits to answer), METHOD.json (the
same steps as data, hsr-trace/1) and index.html. #no-exercises behind the address of a page leaves its questions out. Exit status 2: a
scene that cannot be followed step by step.

Methods:
)" + list_of_methods();
}

const ExplainedMethod* find_method(const std::string& name) {
  const std::vector<ExplainedMethod>& methods = explained_methods();
  const auto found = std::find_if(methods.begin(), methods.end(), [&](const ExplainedMethod& m) { return m.name == name; });
  return found == methods.end() ? nullptr : &*found;
}

/// Whether a view is asked for.
bool is_given(const ViewOptions& v) {
  return !(v.name.empty() && v.eye.empty() && v.target.empty() && v.direction.empty() && v.up.empty() && v.oblique.empty() &&
           v.sections.empty() && !v.field_of_view && !v.near && !v.depth && v.up_axis.empty());
}

/// The first word is a method, or "all", or else a model.
void sort_words(ExplainArguments& a) {
  std::vector<std::string> words = a.words;
  if (!words.empty() && (words.front() == "all" || find_method(words.front()) != nullptr)) {
    a.method = words.front();
    words.erase(words.begin());
  } else if (!words.empty() && words.front().find('.') == std::string::npos && words.front() != "-") {
    std::string names;
    for (const ExplainedMethod& m : explained_methods()) names += m.name + ", ";
    throw InputError("explain: found " + words.front() + ", expected " + names + "all, or a model");
  }
  a.models.models = words;
  a.models.check();
  if (words.empty() && is_given(a.view))
    throw InputError("explain: found a view and no MODEL, expected a model with it: the examples have views of their own");
  if (a.size < 2 || a.size > 48) throw InputError(fmt::format("--size: found {}, expected 2 to 48 samples each way", a.size));
}

ExplainedScene scene_of_model(const ExplainArguments& a, CommandContext& context) {
  const ViewedModel viewed = context.read(a.models, a.view);
  context.say_notes_of(viewed);
  return {viewed.model, viewed.mesh, viewed.view(), viewed.name() + ", view " + viewed.chosen.title};
}

void run(ExplainArguments& a, UnfinishedFiles& unfinished) {
  sort_words(a);
  OutputDirectory directory(a.directory, unfinished);
  CommandContext context(a.common, a.models.models, {}, unfinished);
  std::optional<ExplainedScene> model;
  if (!a.models.models.empty()) {
    model = scene_of_model(a, context);
    check_explainable(*model);
  }
  std::vector<ExplainedMethod> shown;
  if (a.method == "all")
    shown = explained_methods();
  else
    shown.push_back(*find_method(a.method));
  write_explained(directory, "", shown, model ? &*model : nullptr, a.size, a.method == "all");
  context.say_written(directory, a.method == "all" ? "index.html" : a.method + ".html");
}

}  // namespace

void add_explain(CommandLine& command, UnfinishedFiles& unfinished) {
  auto a = std::make_shared<ExplainArguments>();
  Options options =
      command.add_verb("explain", "A method step by step, as it runs: pages to learn and to teach from", examples());
  options.add_several("METHOD|MODEL", a->words,
                      "The method [all], then OBJ, OFF, PLY, STL, glTF, STEP or IGES [a scene made for the method]");
  options.add("-o,--output", a->directory, "DIR", "The directory of the pages; made if it is not there").required();
  options.add("--size", a->size, "N", "Samples each way, of methods that work at samples").with_default_shown();
  a->models.add_objects_without_ghosts_to(options);
  a->view.add_to(options);
  options.begin_group("Report");
  a->common.add_quiet_to(options, "Say nothing but what is wrong");
  options.on_run([a, &unfinished] { run(*a, unfinished); });
}

}  // namespace hsr::cli
