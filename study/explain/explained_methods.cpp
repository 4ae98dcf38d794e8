#include "study/explain/explained_methods.h"

#include "study/explain/example_scenes.h"

namespace hsr::internal {

const std::vector<ExplainedMethod>& explained_methods() {
  static const std::vector<ExplainedMethod> methods = {
      {"depth-sort",
       "Depth sort",
       "faces from far to near: Newell's tests, cycles, cuts",
       explain_depth_sort,
       "ring",
       {{"plates", "few cuts", "plates of which an order exists"}, {"star", "few cuts", "ten sheets through one axis"}}},
      {"bsp", "BSP tree", "planes divide the faces once, and order them for every viewer", explain_bsp, "walls"},
      {"z-buffer", "z-buffer", "the nearest depth at each sample, in formats of few bits", explain_z_buffer, "triangles"},
      {"roberts", "Visible lines by Roberts", "each edge, the shadows of faces on it, and what their union leaves",
       explain_roberts, "house"},
      {"appel", "Visible lines by Appel", "how many faces are in front, counted once and carried along the edges",
       explain_appel, "house"},
      {"fragments", "Visible fragments", "what is seen of each face: sides along visible lines, linked into rings",
       explain_fragments, "house"},
      {"scanline", "Scanline algorithm", "row by row: active edges, flags of faces, depths compared where a face begins",
       explain_scanline, "triangles"},
      {"row-z-buffer", "z-buffer of one row", "row by row: buckets, active faces, and depths of one row only",
       explain_row_z_buffer, "triangles"},
      {"tiled-z-buffer", "z-buffer in tiles", "faces sorted into tiles, each of which is drawn by itself",
       explain_tiled_z_buffer, "triangles"},
      {"ray-casting", "Ray casting", "for each sample the nearest of the faces that its line of sight meets, exactly",
       explain_ray_casting, "triangles"},
      {"a-buffer", "A-buffer", "lists of fragments at pixels, with masks: soft edges, transparent faces", explain_a_buffer,
       "triangles"},
      {"alpha-buffer", "α-buffer", "lists of layers at samples, sorted and laid over one another", explain_alpha_buffer,
       "triangles"},
      {"painter", "Painter's algorithm", "faces sorted by one depth each, and where that fails", explain_painter, "middle"},
      {"culling", "Culling", "what need not be drawn: beside the picture, turned away, behind others, too small",
       explain_culling, "yard"},
  };
  return methods;
}

Trace example_trace(const ExplainedMethod& method, int size) {
  const ExplainedScene scene = example_scene(method.scene);
  Trace trace = method.explain(scene, size);
  trace.view = scene.title;
  for (const ExplainedMethod::More& more : method.more) {
    Trace other = method.explain(example_scene(more.scene), size);
    for (TraceRun& run : other.runs) {
      if (run.name != more.run) continue;
      run.name = more.shown_as;
      if (!run.scene) run.scene = other.scene;
      trace.runs.push_back(std::move(run));
    }
  }
  trace.method = method.name;
  trace.title = method.title;
  return trace;
}

}  // namespace hsr::internal
