#pragma once

#include <limits>
#include <span>

#include "geometry/mesh.h"
#include "hsr/image.h"
#include "hsr/raster/samples.h"
#include "hsr/scene/tie_rule.h"
#include "hsr/view/view.h"

namespace hsr {

/// What a z-buffer holds at a sample. Larger is nearer: Seen::nearness (sample_projection.h).
template <class Real>
struct DepthPixel {
  Real nearness = -std::numeric_limits<Real>::infinity();
  TriangleId triangle;  ///< not valid: none

  friend bool operator==(const DepthPixel&, const DepthPixel&) = default;
};

template <class Real>
using DepthImage = Image<DepthPixel<Real>>;

/// The plain z-buffer, with coordinates and depths in `Real` (float, double): the image-space method that the exact ones are
/// compared with, and that may be wrong. Each triangle beyond the near plane is drawn by scanlines; the depth at a sample is
/// that of the triangle's plane.
///
///   (1) a sample has the triangle nearest there, as exactly as Real tells; of equally near ones the one on top
///   (2) a sample on an edge is decided as samples.h says, as exactly as Real tells; triangles that share an edge leave no gap
///       and share no sample
///   (3) triangles with a corner that Real cannot hold, or that is seen 2^60 samples away, are not drawn
///
/// Exact: no. Cost: O(n + samples drawn); one thread, but for the corners.
/// Source: Catmull 1974.
template <class Real>
DepthImage<Real> z_buffer(const Mesh& mesh, const View& view, const SampleGrid& samples, TieRule ties = {});
/// The z-buffer of some triangles only, such as those that culling leaves. @pre ascending
template <class Real>
DepthImage<Real> z_buffer(const Mesh& mesh, const View& view, const SampleGrid& samples, std::span<const TriangleId> triangles,
                          TieRule ties = {});

extern template DepthImage<float> z_buffer(const Mesh&, const View&, const SampleGrid&, TieRule);
extern template DepthImage<double> z_buffer(const Mesh&, const View&, const SampleGrid&, TieRule);
extern template DepthImage<float> z_buffer(const Mesh&, const View&, const SampleGrid&, std::span<const TriangleId>, TieRule);
extern template DepthImage<double> z_buffer(const Mesh&, const View&, const SampleGrid&, std::span<const TriangleId>, TieRule);

}  // namespace hsr
