#include <dlfcn.h>

#include "geometry/error.h"
#include "hsr/cli/step_functions.h"

namespace hsr::cli {

namespace {

const StepFunctions& loaded() {
  // Found by the RUNPATH of the program, beside which it is installed.
  void* const library = dlopen("hsr_step.so", RTLD_NOW | RTLD_LOCAL);
  void* const found = library == nullptr ? nullptr : dlsym(library, "hsr_step_functions");
  if (found == nullptr) {
    const char* const why = dlerror();
    throw InputError("STEP and IGES: found no library hsr_step.so that can be loaded (" +
                     std::string(why == nullptr ? "" : why) + "), expected it where hsr was installed");
  }
  return *reinterpret_cast<const StepFunctions* (*)()>(found)();
}

}  // namespace

const StepFunctions& step_functions() {
  static const StepFunctions& functions = loaded();
  return functions;
}

}  // namespace hsr::cli
