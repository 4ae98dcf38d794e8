#include "hsr/cli/model_arguments.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/error.h"
#include "hsr/cli/standard_input.h"
#include "hsr/drawing/page.h"
#include "hsr/io/read/read.h"
#include "hsr/joined_models.h"

namespace hsr::cli {

using namespace internal;

void ModelArguments::add_to(Options& options) {
  options
      .add_several(
          "MODEL", models,
          "OBJ, OFF, PLY, STL (each also .gz), glTF, GLB, STEP, IGES or 3MF; several are one scene, - is standard input")
      .required();
  options.add("--from", from, "FORMAT", "What standard input holds, where MODEL is - [by content]")
      .one_of({"obj", "off", "ply", "stl", "gltf", "glb", "step", "3mf"});
  options.add("--chord", chord, "MM", "STEP, IGES: how far lines may be from the curves that they stand for, on paper")
      .with_default_shown();
  options.add_one_each("--marks", marks, "FILE",
                       "JSON, hsr-marks/1: which faces are of one surface, which edges are smooth, sharp or none, whatever the "
                       "crease; with several models one for each of the first, in their order");
}

void ModelArguments::add_with_order_to(Options& options) {
  options
      .add_several("ORDER.json|MODEL", models,
                   "hsr-order/1 by anyone, or models whose faces are painted in the files' order; - is standard input")
      .required();
  options.add("--from", from, "FORMAT", "What standard input holds; json: an order [a model, by content]")
      .one_of({"json", "obj", "off", "ply", "stl", "gltf", "glb", "step", "3mf"});
}

void ModelArguments::add_choice_to(Options& options) {
  options.begin_group("Objects");
  options.add_one_each(
      "--only", objects.only, "NAME",
      "No other objects than this one, as the file names it, or a file that names none, wires and all; may be repeated");
  options.add_one_each("--hide", objects.hide, "NAME", "This object is not there; may be repeated");
}

void ModelArguments::add_objects_to(Options& options) {
  add_choice_to(options);
  options.add_one_each("--ghost", objects.ghost, "NAME",
                       "The lines of this object are drawn, and it hides nothing; may be repeated");
}

void ModelArguments::add_objects_without_ghosts_to(Options& options) {
  add_choice_to(options);
  shows_ghosts_ = false;
  options.begin_hidden_group();
  options.add_one_each("--ghost", objects.ghost, "NAME", "Refused");
}

void ModelArguments::check() const {
  if (!shows_ghosts_ && !objects.ghost.empty())
    throw InputError(
        "--ghost: found \"" + objects.ghost.front() +
        "\", expected it with hsr draw only: here faces are shown, and of a ghost there are only lines; --hide leaves it out");
  if (!(chord > 0) || !std::isfinite(chord))
    throw InputError(fmt::format("--chord: found {}, expected millimetres, more than 0", chord));
  if (marks.size() > models.size())
    throw InputError(
        fmt::format("--marks: found {} files for {} models, expected one for each at most", marks.size(), models.size()));
  const auto of_input = std::count(models.begin(), models.end(), "-");
  if (of_input > 1) throw InputError("-: found twice among the models, expected standard input once");
  if (of_input == 0 && !from.empty())
    throw InputError("--from: found no MODEL that is -, expected it with standard input only: the format of a file is its own");
}

OpenedModels ModelArguments::open(const std::string& unit, const std::string& up_axis) const {
  OpenedModels opened;
  for (const std::string& path : models)
    opened.files_.push_back(path == "-" ? read_standard_input(from) : ModelFile::read(path));
  opened.objects_ = objects;
  opened.marks_ = marks;
  opened.unit_ = unit;
  opened.up_axis_ = up_axis;
  return opened;
}

bool OpenedModels::have_surfaces() const {
  return std::any_of(files_.begin(), files_.end(), [](const ModelFile& file) { return file.has_surfaces(); });
}

Model OpenedModels::model(std::optional<double> chord) {
  std::vector<ModelToJoin> parts;
  const bool is_asked_again = have_surfaces();
  for (ModelFile& file : files_) {
    const double millimetres = unit_.empty() ? file.millimetres() : parse_unit(unit_);
    ModelToJoin part{is_asked_again ? file.model(chord ? *chord / millimetres : 0) : file.take()};
    if (parts.size() < marks_.size()) {
      if (file.has_surfaces())
        throw InputError("--marks: found with " + part.model.name +
                         ", which says itself what its edges are, expected marks of meshes: models that have none come last");
      read_marks(marks_[parts.size()], part.model);
    }
    // What is given for all is no reason to convert anything: the options say it again where it is used.
    if (unit_.empty()) part.unit = name_of_unit(part.model.unit.value_or(1));
    if (up_axis_.empty()) part.is_y_up = part.model.up_axis == 'y';
    parts.push_back(std::move(part));
  }
  Model all = joined(std::move(parts)).model;
  select(all, objects_);
  return all;
}

}  // namespace hsr::cli
