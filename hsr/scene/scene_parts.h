#pragma once

#include <oneapi/tbb/collaborative_call_once.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "hsr/scene/closed_bodies.h"
#include "hsr/scene/intersections.h"
#include "hsr/scene/occluders.h"
#include "hsr/scene/occluding_edges.h"
#include "hsr/scene/occlusion_pyramid.h"
#include "hsr/scene/projected_mesh.h"
#include "hsr/scene/scene.h"

namespace hsr::internal {

/// A value that is made when it is first asked for, once; threads that ask meanwhile help to make it.
template <class T>
class MadeOnce {
 public:
  template <class Make>
  const T& get(const Make& make) const {
    tbb::collaborative_call_once(flag_, [&] {
      value_.emplace(make());
      is_made_.store(true, std::memory_order_release);
    });
    return *value_;
  }
  /// Whether it is there already; for choices of speed only.
  bool is_made() const { return is_made_.load(std::memory_order_acquire); }

 private:
  mutable tbb::collaborative_once_flag flag_;
  mutable std::optional<T> value_;
  mutable std::atomic<bool> is_made_ = false;
};

/// Which triangles a tree of occluders does without.
enum class Excluded : unsigned char {
  none,
  hidden,              ///< far sides of closed bodies, and what tiles hide
  edge_on,             ///< those seen edge-on
  hidden_and_edge_on,  ///< both
};

/// What all methods share of one view of a scene, each part made on first use. The stages come in one order: projection, closed
/// bodies, tiles, the tree, intersections, occluding edges.
class SceneParts {
 public:
  /// @param others what else predicates and filters will meet: the samples of a picture
  SceneParts(std::shared_ptr<const Mesh> mesh, const View& view, const SceneOptions& options, const BitRange& others = {});
  SceneParts(const SceneParts&) = delete;
  SceneParts& operator=(const SceneParts&) = delete;

  const Mesh& mesh() const { return *mesh_; }
  const View& view() const { return view_; }
  const SceneOptions& options() const { return options_; }

  const ProjectedMesh& projected() const;
  /// Conservative boxes in the image, by triangle.
  const std::vector<ImageBox>& boxes() const;
  /// The closed bodies; null: not looked for.
  const ClosedBodies* bodies() const;
  bool is_one_convex_body() const;  ///< and its stage is not to be left out
  /// What hides what is behind large faces; null: not looked for, or nothing is known to be hidden.
  const OcclusionPyramid* pyramid() const;
  /// By triangle: on the far side of a closed body, or hidden by tiles; whole faces only. Empty: nothing is known to be.
  const std::vector<std::uint8_t>& hidden() const;
  /// By triangle: hidden(), or seen edge-on. Empty: none is.
  const std::vector<std::uint8_t>& hidden_or_edge_on() const;
  bool has_edge_on() const;

  const Occluders& occluders(Excluded excluded) const;
  /// Where faces meet: with SceneOptions::hidden_lines all, else what tiles leave.
  const Intersections& intersections() const;
  /// Some that are hidden may be missing, and some of hidden faces may be there.
  const Intersections& visible_intersections() const;
  /// Where the number of layers changes: of faces that are not hidden.
  const OccludingEdges& occluding_edges(Excluded excluded) const;

  /// The same scene for predicates that meet other points, too.
  const SceneParts& with(const BitRange& others) const;

 private:
  Excluded needed(Excluded excluded) const;
  const std::vector<std::uint8_t>& flags(Excluded excluded) const;

  std::shared_ptr<const Mesh> mesh_;
  View view_;
  SceneOptions options_;
  BitRange others_;

  MadeOnce<ProjectedMesh> projected_;
  MadeOnce<std::vector<ImageBox>> boxes_;
  MadeOnce<std::optional<ClosedBodies>> bodies_;
  MadeOnce<bool> is_one_convex_body_;
  MadeOnce<std::unique_ptr<const OcclusionPyramid>> pyramid_;
  MadeOnce<std::vector<std::uint8_t>> hidden_, edge_on_, hidden_or_edge_on_;
  MadeOnce<Occluders> occluders_[4];
  MadeOnce<Intersections> intersections_, visible_intersections_;
  MadeOnce<OccludingEdges> occluding_edges_[4];
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<const SceneParts>> with_;
};

}  // namespace hsr::internal
