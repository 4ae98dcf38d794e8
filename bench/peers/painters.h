#pragma once

#include <cstdint>

#include "geometry/mesh.h"
#include "hsr/view/view.h"

namespace hsr::bench {

/// What another program made of a painting order.
struct PeerOrder {
  double compute = 0;        ///< seconds by the clock
  std::uint64_t pieces = 0;  ///< polygons that it paints
};

/// The command `sketch` (package sketch), depth sort with splitting or, if asked for, its BSP. The seconds are those of the
/// whole command: it reads triangles and writes PSTricks, and has no way to be asked for less.
/// @throws PreconditionError in perspective; InputError if it fails
PeerOrder sketch(const Mesh& mesh, const View& view, bool bsp);

#ifdef HSR_BENCH_GL2PS
/// The library gl2ps (package libgl2ps-dev), BSP with best root: from the finished list of triangles to the end of its output,
/// which goes nowhere and is counted.
/// @throws PreconditionError in perspective
PeerOrder gl2ps(const Mesh& mesh, const View& view);
#endif

}  // namespace hsr::bench
