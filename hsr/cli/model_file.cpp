#include "hsr/cli/model_file.h"

#include <algorithm>

#include "hsr/io/read/known_formats.h"
#ifdef HSR_STEP
#include "hsr/cli/step_functions.h"
#endif
#ifdef HSR_3MF
#include "hsr/three_mf/three_mf.h"
#endif

namespace hsr::cli {

namespace {

/// The end of a message on formats that are known: what hsr is built with, and what it might be.
std::string other_formats() {
  std::string with, without;
#ifdef HSR_STEP
  with += ", STEP, IGES";
#else
  without += " STEP and IGES (HSR_STEP)";
#endif
#ifdef HSR_3MF
  with += ", 3MF";
#else
  without += std::string(without.empty() ? "" : " and") + " 3MF (HSR_3MF)";
#endif
  return with + (without.empty() ? "" : "; hsr is built without" + without);
}

Model read_mesh(const std::string& path) {
#ifdef HSR_3MF
  if (is_three_mf(path)) return read_three_mf(path);
#endif
  return internal::read::read_model_among(path, other_formats());
}

Model read_mesh(const std::string& name, std::string_view bytes) {
#ifdef HSR_3MF
  if (is_three_mf(name, bytes)) return read_three_mf(name, bytes);
#endif
  return internal::read::read_model_among(name, bytes, other_formats());
}

}  // namespace

#ifdef HSR_STEP

struct ModelFile::Surfaces {
  BrepModel brep;
};

ModelFile ModelFile::read(const std::string& path) {
  if (!is_brep(path)) return ModelFile(read_mesh(path));
  ModelFile file((Model()));
  file.surfaces_ = std::make_shared<const Surfaces>(Surfaces{step_functions().read(path)});
  return file;
}

ModelFile ModelFile::read(const std::string& name, std::string_view bytes) {
  if (!is_brep(name, bytes)) return ModelFile(read_mesh(name, bytes));
  ModelFile file((Model()));
  file.surfaces_ = std::make_shared<const Surfaces>(Surfaces{step_functions().read_bytes(name, bytes)});
  return file;
}

double ModelFile::millimetres() const {
  return has_surfaces() ? step_functions().millimetres(surfaces_->brep) : mesh_.unit.value_or(1);
}

Model ModelFile::model(double chord) const {
  if (!has_surfaces()) return mesh_;
  constexpr double coarse = 1.0 / 500, finest = 1e-5;  // of the size
  const double size = step_functions().size(surfaces_->brep);
  Model model = step_functions().tessellated(surfaces_->brep, chord > 0 ? std::max(chord, size * finest) : size * coarse);
  if (!mesh_.name.empty()) model.name = mesh_.name;
  if (chord > 0 && chord < size * finest)
    model.notes.push_back(model.name + ": curves are drawn to a hundred-thousandth of the size of the model, and no finer");
  return model;
}

Model ModelFile::fine_model() const {
  constexpr double fine = 1.0 / 20000;  // as on a page where the diagonal of its box is 400 mm long
  return has_surfaces() ? model(step_functions().size(surfaces_->brep) * fine) : mesh_;
}

#else

struct ModelFile::Surfaces {};

ModelFile ModelFile::read(const std::string& path) { return ModelFile(read_mesh(path)); }
ModelFile ModelFile::read(const std::string& name, std::string_view bytes) { return ModelFile(read_mesh(name, bytes)); }
double ModelFile::millimetres() const { return mesh_.unit.value_or(1); }
Model ModelFile::model(double) const { return mesh_; }
Model ModelFile::fine_model() const { return mesh_; }

#endif

}  // namespace hsr::cli
