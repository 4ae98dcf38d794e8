#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hsr/cli/command_line.h"
#include "hsr/cli/model_file.h"
#include "hsr/model.h"
#include "hsr/object_selection.h"

namespace hsr::cli {

struct ModelArguments;

/// The files of a command, read.
class OpenedModels {
 public:
  /// Whether some have surfaces: then a mesh is made for the drawing.
  bool have_surfaces() const;
  /// One model of all of them, with the objects that are wanted.
  /// @param chord of what has surfaces, in millimetres of the model; nothing: a coarse mesh, that shows the size
  /// @pre once, unless some have surfaces
  /// @throws InputError as readers, joined() and select() do
  Model model(std::optional<double> chord);

 private:
  friend struct ModelArguments;
  std::vector<ModelFile> files_;
  std::vector<std::string> marks_;
  internal::ObjectSelection objects_;
  std::string unit_, up_axis_;
};

/// The arguments that say what the scene is: models, and which of their objects.
struct ModelArguments {
  std::vector<std::string> models;  ///< paths; - is the standard input
  std::string from;                 ///< the format of the standard input; empty: by content
  std::vector<std::string> marks;   ///< files of marks, for the models in their order
  double chord = 0.02;              ///< mm on paper: how far chords may be from the curves of STEP and IGES
  internal::ObjectSelection objects;

  /// MODEL ... and --from.
  void add_to(Options& options);
  /// The same for models or a painting order.
  void add_with_order_to(Options& options);
  /// --only, --hide and --ghost.
  void add_objects_to(Options& options);
  /// --only and --hide, for verbs that show faces: a ghost has none, and check() refuses it.
  void add_objects_without_ghosts_to(Options& options);

  /// @throws InputError where standard input is asked for twice, or its format is given and it is not read, or a ghost is not shown
  void check() const;
  /// Reads all files.
  /// @param unit, up_axis what holds for all models; empty: what each of them says, else mm and z
  /// @throws InputError as readers do
  OpenedModels open(const std::string& unit, const std::string& up_axis) const;

 private:
  void add_choice_to(Options& options);

  bool shows_ghosts_ = true;
};

}  // namespace hsr::cli
