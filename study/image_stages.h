#pragma once

#include <functional>
#include <string>
#include <vector>

#include "geometry/mesh.h"
#include "hsr/raster/samples.h"
#include "hsr/view/view.h"

namespace hsr::internal {

/// A stage, on its own: what it costs and saves.
struct ComparedStage {
  std::string stage, kind;  ///< kind: "left out", "culling", "coherence"
  double seconds = 0;       ///< with it
  double without = 0;       ///< the same work without it
  std::string result;       ///< what it changes, or that it changes nothing
};

/// Runs a piece of work, and says how many seconds it took.
using Timer = std::function<double(const std::function<void()>&)>;

/// Each culling before a z-buffer of floats, and the z-buffer without: how many triangles it leaves out, and at how many
/// samples the picture changes. Those of the frustum look at the middle quarter of the picture.
std::vector<ComparedStage> culling_stages(const Mesh& mesh, const View& view, const SampleGrid& grid, const Timer& timed);

/// What methods rest on that neighbours are alike: of objects, faces, edges, rows, areas and depths. Each with the same work
/// done without it. (For frames, see compare().)
/// Source: the kinds of coherence, Sutherland, Sproull & Schumacker 1974; Foley, van Dam, Feiner & Hughes 1990.
std::vector<ComparedStage> coherence_stages(const Mesh& mesh, const View& view, const SampleGrid& grid, const Timer& timed);

}  // namespace hsr::internal
