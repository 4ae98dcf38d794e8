#include "hsr/cli/step_functions.h"

/// The one name of the library that step_loaded.cpp looks for.
extern "C" __attribute__((visibility("default"))) const hsr::cli::StepFunctions* hsr_step_functions() {
  return &hsr::cli::linked_step_functions();
}
