#include "hsr/cli/model_file.h"

#include <algorithm>

#include "hsr/io/read/read.h"
#ifdef HSR_STEP
#include "hsr/step/step.h"
#endif

namespace hsr::cli {

#ifdef HSR_STEP

struct ModelFile::Surfaces {
  BrepModel brep;
};

ModelFile ModelFile::read(const std::string& path) {
  if (!is_brep(path)) return ModelFile(read_model(path));
  ModelFile file((Model()));
  file.surfaces_ = std::make_shared<const Surfaces>(Surfaces{read_brep(path)});
  return file;
}

ModelFile ModelFile::read(const std::string& name, std::string_view bytes) {
  if (!is_brep(name, bytes)) return ModelFile(read_model(name, bytes));
  ModelFile file((Model()));
  file.surfaces_ = std::make_shared<const Surfaces>(Surfaces{read_brep(name, bytes)});
  return file;
}

double ModelFile::millimetres() const { return has_surfaces() ? surfaces_->brep.millimetres() : mesh_.unit.value_or(1); }

Model ModelFile::model(double chord) const {
  if (!has_surfaces()) return mesh_;
  constexpr double coarse = 1.0 / 500, finest = 1e-5;  // of the size
  const double size = surfaces_->brep.size();
  Model model = surfaces_->brep.tessellated(chord > 0 ? std::max(chord, size * finest) : size * coarse);
  if (!mesh_.name.empty()) model.name = mesh_.name;
  if (chord > 0 && chord < size * finest)
    model.notes.push_back(model.name + ": curves are drawn to a hundred-thousandth of the size of the model, and no finer");
  return model;
}

Model ModelFile::fine_model() const {
  constexpr double fine = 1.0 / 20000;  // as on a page where the diagonal of its box is 400 mm long
  return has_surfaces() ? model(surfaces_->brep.size() * fine) : mesh_;
}

#else

struct ModelFile::Surfaces {};

ModelFile ModelFile::read(const std::string& path) { return ModelFile(read_model(path)); }
ModelFile ModelFile::read(const std::string& name, std::string_view bytes) { return ModelFile(read_model(name, bytes)); }
double ModelFile::millimetres() const { return mesh_.unit.value_or(1); }
Model ModelFile::model(double) const { return mesh_; }
Model ModelFile::fine_model() const { return mesh_; }

#endif

}  // namespace hsr::cli
