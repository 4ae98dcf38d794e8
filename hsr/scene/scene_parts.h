#pragma once

#include <memory>
#include <mutex>

#include "hsr/face_labels.h"
#include "hsr/scene/edge_mark_table.h"
#include "hsr/scene/intersections.h"
#include "hsr/scene/made_once.h"
#include "hsr/scene/space_tree.h"
#include "hsr/scene/star_shaped_bodies.h"

namespace hsr::internal {

/// What all views of a scene share, each part made on first use.
class SceneParts {
 public:
  SceneParts(std::shared_ptr<const Mesh> mesh, FaceLabels labels)
      : mesh_(std::move(mesh)), labels_(std::move(labels)), marks_(*mesh_, labels_.marks) {}
  SceneParts(const SceneParts&) = delete;
  SceneParts& operator=(const SceneParts&) = delete;

  const Mesh& mesh() const { return *mesh_; }
  const FaceLabels& labels() const { return labels_; }
  const EdgeMarkTable& marks() const { return marks_; }
  const StarShapedBodies& bodies() const {
    return bodies_.get([&] { return StarShapedBodies(ScaledMesh(*mesh_)); });
  }
  const SpaceTree& space_tree() const {
    return space_tree_.get([&] { return SpaceTree(*mesh_); });
  }
  /// Which faces meet, once a view has looked for all of them; null before.
  std::shared_ptr<const MeetingFaces> meeting_faces() const {
    const std::lock_guard lock(mutex_);
    return meeting_faces_;
  }
  void keep(MeetingFaces found) const {
    auto kept = std::make_shared<const MeetingFaces>(std::move(found));
    const std::lock_guard lock(mutex_);
    if (meeting_faces_ == nullptr) meeting_faces_ = std::move(kept);
  }

 private:
  std::shared_ptr<const Mesh> mesh_;
  FaceLabels labels_;
  EdgeMarkTable marks_;
  MadeOnce<StarShapedBodies> bodies_;
  MadeOnce<SpaceTree> space_tree_;
  mutable std::mutex mutex_;
  mutable std::shared_ptr<const MeetingFaces> meeting_faces_;
};

}  // namespace hsr::internal
