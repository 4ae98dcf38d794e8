#include "hsr/model.h"

namespace hsr {

FaceLabels labels_of(const Model& model) {
  constexpr std::size_t most_colours = 16;
  FaceLabels labels{model.face_object, model.face_material};
  if (labels.material.empty() && model.palette.size() <= most_colours) labels.material = model.face_colour;
  return labels;
}

SceneObjects objects_of(const Model& model) {
  if (model.objects.size() < 2) return {};
  return {model.objects, model.face_object};
}

}  // namespace hsr
