#include "hsr/io/read/model_builder.h"

#include <algorithm>

namespace hsr::internal::read {

std::uint32_t ModelBuilder::colour_number(const Colour& colour) {
  std::uint32_t bytes = 0;
  for (const std::uint8_t channel : colour) bytes = bytes << 8 | channel;
  const auto [at, is_new] = palette_.try_emplace(bytes, static_cast<std::uint32_t>(model_.palette.size()));
  if (is_new) model_.palette.push_back(colour);
  return at->second;
}

void ModelBuilder::note_colour() {
  if (colour_ && colour_index_ == none) colour_index_ = colour_number(*colour_);
  model_.face_colour.resize(faces() - 1, none);
  model_.face_colour.push_back(colour_index_);
}

void ModelBuilder::colour_by_corners() {
  if (corner_colours_.empty()) return;
  std::vector<std::uint32_t> colours = std::move(model_.face_colour);
  colours.resize(faces(), none);
  bool any = !model_.palette.empty();
  for (std::size_t f = 0; f < faces(); ++f) {
    if (colours[f] != none) continue;
    const std::uint32_t* const corners = model_.polygons.corners.data();
    const auto mean = corner_colours_.mean(corners + model_.polygons.first[f], corners + model_.polygons.first[f + 1]);
    if (!mean) continue;
    colours[f] = colour_number(*mean);
    any = true;
  }
  if (any) model_.face_colour = std::move(colours);
}

void ModelBuilder::too_many(const char* what) const {
  source_.refuse("", std::string("found more than 4294967294 ") + what + ", expected no more than can be counted in 32 bits");
}

void ModelBuilder::add_camera(StoredCamera camera) {
  const auto is_taken = [&](const std::string& name) {
    return std::any_of(model_.cameras.begin(), model_.cameras.end(), [&](const StoredCamera& c) { return c.name == name; });
  };
  const std::string name = camera.name;
  for (std::size_t k = 2; is_taken(camera.name); ++k) camera.name = name + " [" + std::to_string(k) + "]";
  model_.cameras.push_back(std::move(camera));
}

Model ModelBuilder::finish(bool may_be_empty) {
  if (model_.points.size() > most) too_many("points");
  if (model_.polygons.segments.size() > most) too_many("lines");
  if (faces() > most) too_many("faces");
  if (faces() == 0 && model_.polygons.segments.empty() && !may_be_empty)
    source_.refuse("", model_.points.empty() ? "found no points, faces or lines, expected a model"
                                             : "has points but no faces or lines: nothing to draw");
  colour_by_corners();
  (objects_.empty() ? groups_ : objects_).move_to(model_.objects, model_.face_object, model_.segment_object);
  std::vector<std::uint32_t> of_wire;
  materials_.move_to(model_.materials, model_.face_material, of_wire);
  return std::move(model_);
}

}  // namespace hsr::internal::read
