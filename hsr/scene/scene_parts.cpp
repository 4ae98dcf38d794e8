#include "hsr/scene/scene_parts.h"

#include "hsr/scene/scene.h"

namespace hsr {

using namespace internal;

Scene::Scene(Mesh mesh) : parts_(std::make_shared<const SceneParts>(std::make_shared<const Mesh>(std::move(mesh)))) {}

Scene::Scene(std::shared_ptr<const SceneParts> parts) : parts_(std::move(parts)) {}

Scene Scene::of(const Mesh& mesh) {
  return Scene(std::make_shared<const SceneParts>(std::shared_ptr<const Mesh>(std::shared_ptr<const Mesh>(), &mesh)));
}

const Mesh& Scene::mesh() const { return parts_->mesh(); }

}  // namespace hsr
