#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "hsr/model.h"

namespace hsr::cli {

/// What a file holds: a mesh, or surfaces of which meshes of any accuracy are made.
class ModelFile {
 public:
  /// @throws InputError as readers do; of STEP and IGES where hsr is built without them
  static ModelFile read(const std::string& path);
  /// Of bytes in memory; `name` is used like a path.
  static ModelFile read(const std::string& name, std::string_view bytes);

  bool has_surfaces() const { return surfaces_ != nullptr; }
  /// In a unit of it: what the file says, else 1.
  double millimetres() const;
  /// Messages have this name of it.
  void call(const std::string& name) { mesh_.name = name; }
  /// The mesh of the file; of surfaces one with that chord error, in units of the model; 0: a coarse one, that shows its size.
  Model model(double chord) const;
  /// The mesh of the file, which is then gone. @pre it has no surfaces
  Model take() { return std::move(mesh_); }
  /// The same at the accuracy that suits a drawing on a large page, whatever the view.
  Model fine_model() const;

 private:
  explicit ModelFile(Model mesh) : mesh_(std::move(mesh)) {}
  struct Surfaces;

  Model mesh_;
  std::shared_ptr<const Surfaces> surfaces_;
};

}  // namespace hsr::cli
