#pragma once

#include <string>
#include <string_view>

#include "hsr/step/step.h"

namespace hsr::cli {

/// What models of surfaces are asked for, behind pointers: the command takes these from a library that it loads when it meets such a
/// model, since Open CASCADE is 78 libraries, which take longer to load than most drawings to make. Python's module has them linked.
struct StepFunctions {
  BrepModel (*read)(const std::string& path);
  BrepModel (*read_bytes)(const std::string& name, std::string_view bytes);
  double (*size)(const BrepModel& model);
  double (*millimetres)(const BrepModel& model);
  Model (*tessellated)(const BrepModel& model, double chord);
};

/// Those of the program. @throws InputError if the library is not where it was installed
const StepFunctions& step_functions();

/// Those of hsr_step, where it is linked.
const StepFunctions& linked_step_functions();

}  // namespace hsr::cli
