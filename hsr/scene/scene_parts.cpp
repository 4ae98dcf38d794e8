#include "hsr/scene/scene_parts.h"

#include "geometry/error.h"
#include "hsr/scene/scene.h"

namespace hsr {

using namespace internal;

namespace {

std::shared_ptr<const SceneParts> parts_of(std::shared_ptr<const Mesh> mesh, FaceLabels labels) {
  for (const auto* list : {&labels.object, &labels.material, &labels.surface, &labels.shape})
    require(list->empty() || list->size() == mesh->faces.size(), "Scene: a label for each face expected, or none at all");
  return std::make_shared<const SceneParts>(std::move(mesh), std::move(labels));
}

}  // namespace

Scene::Scene(Mesh mesh, FaceLabels labels)
    : parts_(parts_of(std::make_shared<const Mesh>(std::move(mesh)), std::move(labels))) {}

Scene::Scene(std::shared_ptr<const SceneParts> parts) : parts_(std::move(parts)) {}

Scene Scene::of(const Mesh& mesh, FaceLabels labels) {
  return Scene(parts_of(std::shared_ptr<const Mesh>(std::shared_ptr<const Mesh>(), &mesh), std::move(labels)));
}

const Mesh& Scene::mesh() const { return parts_->mesh(); }
const FaceLabels& Scene::labels() const { return parts_->labels(); }

}  // namespace hsr
