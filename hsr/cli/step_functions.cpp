#include "hsr/cli/step_functions.h"

namespace hsr::cli {

const StepFunctions& linked_step_functions() {
  static constexpr StepFunctions functions = {
      [](const std::string& path) { return read_brep(path); },
      [](const std::string& name, std::string_view bytes) { return read_brep(name, bytes); },
      [](const BrepModel& model) { return model.size(); },
      [](const BrepModel& model) { return model.millimetres(); },
      [](const BrepModel& model, double chord) { return model.tessellated(chord); },
  };
  return functions;
}

}  // namespace hsr::cli
