#pragma once

#include <cstdint>
#include <vector>

#include "geometry/mesh.h"
#include "geometry/number.h"
#include "hsr/view/view.h"

namespace hsr::bench {

/// What CGAL's lower envelope of triangles says of a parallel view.
struct Envelope {
  double prepare = 0, compute = 0;  ///< seconds by the clock: the triangles turned into its numbers; the envelope
  std::uint64_t regions = 0;        ///< of its map, of one or more triangles each
  std::vector<Rational> areas;      ///< by triangle, if asked for: where it is seen, in the frame's coordinates
};

/// The exact visibility map of all triangles that are not seen edge-on, by CGAL::lower_envelope_3 (GPL: benches and tests only)
/// with exact constructions. Of triangles that coincide the lowest index is seen.
/// @throws PreconditionError if the view is not parallel
Envelope envelope(const Mesh& mesh, const View& view, bool with_areas);

}  // namespace hsr::bench
