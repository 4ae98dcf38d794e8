#include "study/explain/explained_methods.h"

namespace hsr::internal {

const std::vector<ExplainedMethod>& explained_methods() {
  static const std::vector<ExplainedMethod> methods = {
      {"depth-sort", "Depth sort", "faces from far to near: Newell's tests, cycles, cuts", explain_depth_sort, "ring"},
      {"bsp", "BSP tree", "planes divide the faces once, and order them for every viewer", explain_bsp, "walls"},
      {"z-buffer", "z-buffer", "the nearest depth at each sample, in formats of few bits", explain_z_buffer, "triangles"},
      {"roberts", "Visible lines by Roberts", "each edge, the shadows of faces on it, and what their union leaves",
       explain_roberts, "house"},
      {"scanline", "Scanline algorithm", "row by row: active edges, flags of faces, depths compared where a face begins",
       explain_scanline, "triangles"},
      {"painter", "Painter's algorithm", "faces sorted by one depth each, and where that fails", explain_painter, "middle"},
  };
  return methods;
}

}  // namespace hsr::internal
