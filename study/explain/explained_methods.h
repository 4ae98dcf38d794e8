#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "study/explain/trace.h"
#include "study/explain/traced_scene.h"

namespace hsr::internal {

/// A method that can be explained.
struct ExplainedMethod {
  std::string name;   ///< as the command has it: "depth-sort"
  std::string title;  ///< "Depth sort"
  std::string about;  ///< what it does, in one sentence
  Trace (*explain)(const ExplainedScene& scene, int size);
  const char* scene;  ///< the example that is shown where no model is given (example_scenes.h)
  /// After it, runs of this name on other examples.
  struct More {
    const char *scene, *run, *shown_as;
  };
  std::vector<More> more = {};
};

/// Those most taught come first.
const std::vector<ExplainedMethod>& explained_methods();

/// On the examples that are made for it.
Trace example_trace(const ExplainedMethod& method, int size);

// Each the trace of the method as it runs on the scene. @param size samples each way, of methods that work at samples
// @throws InputError as check_explainable() and the method do
Trace explain_depth_sort(const ExplainedScene& scene, int size);
Trace explain_bsp(const ExplainedScene& scene, int size);
Trace explain_z_buffer(const ExplainedScene& scene, int size);
Trace explain_roberts(const ExplainedScene& scene, int size);
Trace explain_appel(const ExplainedScene& scene, int size);
Trace explain_culling(const ExplainedScene& scene, int size);
Trace explain_fragments(const ExplainedScene& scene, int size);
Trace explain_scanline(const ExplainedScene& scene, int size);
Trace explain_a_buffer(const ExplainedScene& scene, int size);
Trace explain_alpha_buffer(const ExplainedScene& scene, int size);
Trace explain_ray_casting(const ExplainedScene& scene, int size);
Trace explain_row_z_buffer(const ExplainedScene& scene, int size);
Trace explain_tiled_z_buffer(const ExplainedScene& scene, int size);
Trace explain_painter(const ExplainedScene& scene, int size);

/// The faces of an order from far to near, as the result of a run: {"painted": [0, 2, ...]}.
std::string painted_result(const ExplainedScene& scene, const PaintersOrder& order);

}  // namespace hsr::internal
