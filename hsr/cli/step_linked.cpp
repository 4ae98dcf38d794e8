#include "hsr/cli/step_functions.h"

namespace hsr::cli {

const StepFunctions& step_functions() { return linked_step_functions(); }

}  // namespace hsr::cli
