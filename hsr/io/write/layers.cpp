#include "hsr/io/write/layers.h"

#include <algorithm>

#include "hsr/io/write/json.h"
#include "hsr/utf8.h"

namespace hsr::internal {

std::string Layer::name(char between) const {
  if (!given_name.empty()) {
    std::string name = given_name;
    std::replace(name.begin(), name.end(), ' ', between);
    return name;
  }
  return (hidden ? std::string("hidden") : std::string("visible")) + between + name_of(edge_class);
}

std::vector<Layer> layers_of(const Drawing& drawing) {
  std::vector<Layer> layers;
  const std::span<const Polyline> all = drawing.polylines;
  for (const NamedLayer& layer : drawing.layers) {
    const auto polylines = all.subspan(layer.first_polyline, layer.end_polyline - layer.first_polyline);
    if (polylines.empty()) continue;
    layers.push_back({polylines[0].hidden, polylines[0].edge_class, layer.pen, polylines, layer.name});
  }
  if (!drawing.layers.empty()) return layers;
  for (std::size_t first = 0, end = 0; first < all.size(); first = end) {
    const bool hidden = all[first].hidden;
    const EdgeClass edge_class = all[first].edge_class;
    while (end < all.size() && all[end].hidden == hidden && all[end].edge_class == edge_class) ++end;
    layers.push_back({hidden, edge_class, drawing.pens.of(hidden, edge_class), all.subspan(first, end - first)});
  }
  return layers;
}

void ObjectComments::append(std::string& out, std::uint32_t object) {
  if (object < names_.size() && names_[object].empty()) object = SceneObjects::none;
  if (object == object_) return;
  object_ = object;
  out += object == SceneObjects::none ? "% of several objects" : "% object: " + printable(names_[object]);
  out += '\n';
}

}  // namespace hsr::internal
