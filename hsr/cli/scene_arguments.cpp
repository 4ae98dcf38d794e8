#include "hsr/cli/scene_arguments.h"

namespace hsr::cli {

void SceneArguments::add_to(Options& options) {
  options.begin_group("Scene");
  options
      .add("--coplanar", coplanar, "WHICH",
           "Of faces that coincide the first in the file is on top, or the last: visible, and painted later [first]")
      .one_of({"first", "last"});
}

}  // namespace hsr::cli
