#pragma once

#include <pybind11/pybind11.h>

#include <mutex>
#include <optional>
#include <string>

#include "hsr/cli/view_options.h"
#include "hsr/model.h"
#include "hsr/scene/scene.h"

namespace hsr::python {

namespace py = pybind11;

/// What `scene` is made into: a model, and what every view of it shares.
class SceneData {
 public:
  explicit SceneData(Model model) : model_(std::move(model)) {}

  const Model& model() const { return model_; }
  /// @param tolerance below which points are one; only that of 0 is kept
  Scene scene(double tolerance = 0);

 private:
  Model model_;
  std::mutex mutex_;
  std::optional<Scene> exact_;
};

/// @param view the arguments that hsr.View stands for, by name
cli::ViewOptions view_options(const py::dict& view);

/// A scene as a view sees it.
SceneView prepared(SceneData& data, const cli::ViewOptions& view, const SceneOptions& options);

void add_scene(py::module_& module);

}  // namespace hsr::python
