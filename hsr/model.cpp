#include "hsr/model.h"

#include <algorithm>

#include "hsr/same_shapes.h"

namespace hsr {

namespace {

/// The edges that the segments of a model run along, and the object of each.
std::vector<SceneObjects::Wire> wires_of(const Model& model, const Mesh& mesh) {
  std::vector<SceneObjects::Wire> all;
  for (std::size_t k = 0; k < model.segment_object.size(); ++k) {
    const auto [from, to] = model.polygons.segments[k];
    const VertexId a = mesh.merged[VertexId(from)], b = mesh.merged[VertexId(to)];
    if (a != b) all.push_back({mesh.find_edge(a, b), model.segment_object[k]});
  }
  std::stable_sort(all.begin(), all.end(), [](const auto& x, const auto& y) { return x.edge < y.edge; });
  std::size_t kept = 0;
  for (const SceneObjects::Wire& wire : all) {
    if (kept == 0 || all[kept - 1].edge != wire.edge)
      all[kept++] = wire;
    else if (all[kept - 1].object != wire.object)
      all[kept - 1].object = SceneObjects::none;
  }
  all.resize(kept);
  return all;
}

}  // namespace

FaceLabels labels_of(const Model& model) {
  constexpr std::size_t most_colours = 16;
  FaceLabels labels{model.face_object,          model.face_material, model.face_surface,
                    internal::shapes_of(model), model.marks,         model.circles};
  if (labels.material.empty() && model.palette.size() <= most_colours) labels.material = model.face_colour;
  return labels;
}

SceneObjects objects_of(const Model& model, const Mesh& mesh) {
  if (model.objects.size() < 2) return {};
  return {model.objects, model.face_object, wires_of(model, mesh)};
}

}  // namespace hsr
