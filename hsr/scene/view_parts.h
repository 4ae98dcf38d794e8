#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <vector>

#include "hsr/scene/closed_bodies.h"
#include "hsr/scene/intersections.h"
#include "hsr/scene/made_once.h"
#include "hsr/scene/occluders.h"
#include "hsr/scene/occluding_edges.h"
#include "hsr/scene/occlusion_pyramid.h"
#include "hsr/scene/projected_mesh.h"
#include "hsr/scene/scene.h"
#include "hsr/scene/scene_parts.h"
#include "hsr/scene/section_caps.h"
#include "hsr/view/section_cells.h"

namespace hsr::internal {

/// Which triangles a tree of occluders does without.
enum class Excluded : unsigned char {
  none,
  hidden,              ///< far sides of closed bodies, and what tiles hide
  edge_on,             ///< those seen edge-on
  hidden_and_edge_on,  ///< both
  hidden_or_capped,    ///< what is hidden where caps of a section hide, too
};

/// What all methods share of one view of a scene, each part made on first use. The stages come in one order: projection, closed
/// bodies, tiles, the tree, intersections, occluding edges.
///
/// Who is asked to stop, by the token of the request, throws a CancelledError instead of making a part, and from within the search for
/// intersections; what was made stays, and the next to ask makes the rest.
class ViewParts {
 public:
  ViewParts(std::shared_ptr<const SceneParts> scene, const View& view, const SceneOptions& options);
  ViewParts(const ViewParts&) = delete;
  ViewParts& operator=(const ViewParts&) = delete;

  const Mesh& mesh() const { return scene_->mesh(); }
  const FaceLabels& labels() const { return scene_->labels(); }
  const EdgeMarkTable& marks() const { return scene_->marks(); }
  const SpaceTree& space_tree() const { return scene_->space_tree(); }
  const View& view() const { return view_; }
  const SceneOptions& options() const { return options_; }

  /// A cell of a view that has some (View::has_cells), and the scene as it is seen there.
  struct Cell {
    SectionCell cell;
    SceneView scene;
  };
  const std::vector<Cell>& cells() const;

  const ProjectedMesh& projected(const std::stop_token& stop = {}) const;
  /// What a section makes of closed bodies; null: the view has none.
  const SectionCaps* caps(const std::stop_token& stop = {}) const;
  /// The closed bodies; null: not looked for.
  const ClosedBodies* bodies(const std::stop_token& stop = {}) const;
  /// Those that hide their far sides together with the caps of a section; the same as bodies() where there are tiles.
  const ClosedBodies* bodies_with_caps(const std::stop_token& stop = {}) const;
  bool is_one_convex_body(const std::stop_token& stop = {}) const;  ///< and its stage is not to be left out
  /// What hides what is behind large faces; null: not looked for, or nothing is known to be hidden.
  const OcclusionPyramid* pyramid(const std::stop_token& stop = {}) const;
  /// By triangle: on the far side of a closed body, or hidden by tiles; whole faces only. Empty: nothing is known to be.
  const std::vector<std::uint8_t>& hidden(const std::stop_token& stop = {}) const;
  /// The same for methods that know what caps hide.
  const std::vector<std::uint8_t>& hidden_or_capped(const std::stop_token& stop = {}) const;
  /// By triangle: hidden(), or seen edge-on. Empty: none is.
  const std::vector<std::uint8_t>& hidden_or_edge_on(const std::stop_token& stop = {}) const;
  bool has_edge_on(const std::stop_token& stop = {}) const;

  const Occluders& occluders(Excluded excluded, const std::stop_token& stop = {}) const;
  /// Whether some tree of occluders has been made; for tests.
  bool has_tree() const {
    for (const auto& tree : occluders_)
      if (tree.is_made()) return true;
    return false;
  }
  /// Where faces meet: with SceneOptions::hidden_lines all, else what tiles leave.
  const Intersections& intersections(const std::stop_token& stop = {}) const;
  /// Some that are hidden may be missing, and some of hidden faces may be there.
  const Intersections& visible_intersections(const std::stop_token& stop = {}) const;
  /// Where the number of layers changes: of faces that are not hidden.
  const OccludingEdges& occluding_edges(Excluded excluded, const std::stop_token& stop = {}) const;

  /// The same scene for predicates that meet other points, too, such as the samples of a picture. Where the points keep their
  /// scale the trees are these, and only the projection is made anew.
  const ViewParts& with(const BitRange& others) const;

 private:
  ViewParts(const ViewParts& base, const BitRange& others);
  /// Whose trees these are: another one's, or its own.
  const ViewParts& shared() const;
  Intersections find(Excluded excluded, const OcclusionPyramid* tiles, const std::stop_token& stop) const;
  bool is_cut_by_near_plane() const;
  Excluded needed(Excluded excluded, const std::stop_token& stop) const;
  std::vector<std::uint8_t> hidden_by(const ClosedBodies* closed, const std::stop_token& stop) const;
  const std::vector<std::uint8_t>& flags(Excluded excluded, const std::stop_token& stop) const;

  std::shared_ptr<const SceneParts> scene_;
  View view_;
  SceneOptions options_;
  BitRange others_;
  const ViewParts* base_ = nullptr;  // of which this is the same scene for more points

  MadeOnce<std::vector<Cell>> cells_;
  MadeOnce<ProjectedMesh> projected_;
  MadeOnce<std::optional<ClosedBodies>> bodies_, bodies_with_caps_;
  MadeOnce<SectionCaps> caps_;
  MadeOnce<std::unique_ptr<const OcclusionPyramid>> pyramid_;
  MadeOnce<std::vector<std::uint8_t>> hidden_, hidden_or_capped_, edge_on_, hidden_or_edge_on_;
  MadeOnce<Occluders> occluders_[5];
  MadeOnce<Intersections> intersections_, visible_intersections_;
  MadeOnce<OccludingEdges> occluding_edges_[5];
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<const ViewParts>> with_;
};

}  // namespace hsr::internal
