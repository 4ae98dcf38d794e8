#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/parallel.h"
#include "hsr/raster/sample_projection.h"
#include "hsr/raster/scanned_triangle.h"

namespace hsr::internal {

template <class Real>
struct RoundedNearness {
  Real operator()(double nearness) const { return static_cast<Real>(nearness); }
};

/// The triangles of a mesh as every image-space method draws them: corners projected in doubles and rounded to `Real` (float,
/// double), what is nearer than the near plane cut away. So methods that differ, differ by what they do with them.
///
/// @param depth_of what a picture interpolates as the depth (it takes the place of Seen::nearness): linear in the nearness
/// Exact: no. Triangles with a corner that is out of range (ScannedTriangle::is_drawable) are not drawn. Corners are projected
/// in parallel.
template <class Real, class DepthOf = RoundedNearness<Real>>
class DrawnTriangles {
 public:
  DrawnTriangles(const Mesh& mesh, const View& view, const SampleGrid& samples, DepthOf depth_of = {})
      : mesh_(mesh), view_(view), depth_of_(std::move(depth_of)), project_(view, samples), points_(mesh.points.size()) {
    state_.resize(points_.size(), drawn);
    std::atomic<bool> all_are_drawn = true;
    parallel_for_each(points_.size(), [&](std::size_t v) {
      const Point3& p = mesh.points[VertexId(v)];
      points_[v] = rounded(project_(p));
      state_[v] = view.cuts() && is_before_near(view, p)           ? cut_away
                  : ScannedTriangle<Real>::is_drawable(points_[v]) ? drawn
                                                                   : out_of_range;
      if (state_[v] != drawn) all_are_drawn.store(false, std::memory_order_relaxed);
    });
    if (all_are_drawn) state_.clear();
  }

  std::size_t size() const { return mesh_.triangles.size(); }

  /// Calls draw(a, b, c), corners of type Seen<Real>, for each triangle that is left of triangle t: none, one or two.
  template <class Draw>
  void visit(TriangleId t, const Draw& draw) const {
    const auto& [a, b, c] = mesh_.triangles[t];
    if (state_.empty() || (state_[a.value] | state_[b.value] | state_[c.value]) == drawn) {
      draw(points_[a.value], points_[b.value], points_[c.value]);
      return;
    }
    std::array<Seen<double>, 4> left;
    const int corners = seen_corners<double>(
        mesh_, view_, project_, t, [&](VertexId v) { return state_[v.value] == cut_away; },
        [&](VertexId v) { return project_(mesh_.points[v]); }, left);
    std::array<Seen<Real>, 4> seen;
    std::transform(left.begin(), left.end(), seen.begin(), [&](const Seen<double>& s) { return rounded(s); });
    if (!std::all_of(seen.begin(), seen.begin() + corners, ScannedTriangle<Real>::is_drawable)) return;
    for (int m = 2; m < corners; ++m) draw(seen[0], seen[m - 1], seen[m]);
  }

  /// In bytes.
  std::size_t memory() const { return points_.capacity() * sizeof(Seen<Real>) + state_.capacity(); }

 private:
  enum : std::uint8_t { drawn = 0, cut_away = 1, out_of_range = 2 };

  Seen<Real> rounded(const Seen<double>& s) const {
    return {static_cast<Real>(s.x), static_cast<Real>(s.y), depth_of_(s.nearness)};
  }

  const Mesh& mesh_;
  const View& view_;
  DepthOf depth_of_;
  SampleProjection<double> project_;
  std::vector<Seen<Real>> points_;   // by vertex
  std::vector<std::uint8_t> state_;  // by vertex; empty: all are drawn
};

}  // namespace hsr::internal
