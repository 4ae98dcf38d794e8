#pragma once

#include <cstdint>
#include <vector>

#include "geometry/mesh.h"
#include "hsr/check/sample_checks.h"
#include "hsr/raster/caster.h"
#include "hsr/raster/z_buffer.h"
#include "hsr/scene/tie_rule.h"
#include "hsr/view/view.h"

namespace hsr::internal {

/// Why a z-buffer shows another face than the nearest at a sample.
enum class Difference : std::uint8_t {
  none,
  depth,      ///< it drew both, and their depths are nearer to each other than its numbers tell there
  edge,       ///< an edge of one of them is nearer to the sample than its numbers tell
  unbounded,  ///< one of them is no triangle, or out of range, in its numbers: nothing is known of its depth or its place
  other,      ///< none of these: a mistake
};

/// How the samples differ, and why.
struct ZBufferCheck {
  std::uint64_t samples = 0;
  std::uint64_t covered = 0;  ///< of them, with a face
  std::uint64_t wrong = 0;    ///< the sum of the following
  std::uint64_t depth = 0, edge = 0, unbounded = 0, other = 0;
  std::vector<WrongSample> first_other;  ///< at most ten

  bool is_explained() const { return other == 0; }
};

/// Says of each sample at which the z-buffer shows another face than the caster why it may.
///
/// What "its numbers tell" is proven, not measured: each step from the corners of a triangle to its depth at the sample is done
/// again with the bound of its error (ErrorBounded, Bounded), so it has the roundings of coordinates, slope and depth in it.
/// The comparisons with that bound are exact, and that the drawn corners keep to it is looked at, too.
///
/// @pre `image` is z_buffer<Real>() and `seen` is cast() of this mesh, view and grid, which paint() takes
/// Exact: yes. Cost: O(samples), and per triangle at a differing sample some dozens of rationals; parallel.
template <class Real>
ZBufferCheck check_z_buffer(const Mesh& mesh, const View& view, const SampleGrid& samples, const DepthImage<Real>& image,
                            const Image<TriangleId>& seen, TieRule ties = {});

extern template ZBufferCheck check_z_buffer(const Mesh&, const View&, const SampleGrid&, const DepthImage<float>&,
                                            const Image<TriangleId>&, TieRule);
extern template ZBufferCheck check_z_buffer(const Mesh&, const View&, const SampleGrid&, const DepthImage<double>&,
                                            const Image<TriangleId>&, TieRule);

}  // namespace hsr::internal
