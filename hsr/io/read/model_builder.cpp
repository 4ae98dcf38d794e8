#include "hsr/io/read/model_builder.h"

namespace hsr::internal::read {

void ModelBuilder::note_colour() {
  if (colour_ && colour_index_ == none) {
    const auto [at, is_new] = palette_.try_emplace(*colour_, static_cast<std::uint32_t>(model_.palette.size()));
    if (is_new) model_.palette.push_back(*colour_);
    colour_index_ = at->second;
  }
  model_.face_colour.resize(faces() - 1, none);
  model_.face_colour.push_back(colour_index_);
}

void ModelBuilder::note_object() {
  if (model_.face_object.empty() && faces() > 1) {
    // Faces before the first name are of an object without one.
    model_.objects.emplace_back();
    object_names_.emplace("", 0U);
    model_.face_object.resize(faces() - 1, 0);
  }
  if (object_ == none) {
    const auto [at, is_new] = object_names_.try_emplace(object_name_, static_cast<std::uint32_t>(model_.objects.size()));
    if (is_new) model_.objects.push_back(object_name_);
    object_ = at->second;
  }
  model_.face_object.push_back(object_);
}

void ModelBuilder::too_many(const char* what) const {
  source_.refuse("", std::string("found more than 4294967294 ") + what + ", expected no more than can be counted in 32 bits");
}

Model ModelBuilder::finish() {
  if (model_.points.size() > most) too_many("points");
  if (model_.polygons.segments.size() > most) too_many("lines");
  if (faces() > most) too_many("faces");
  if (faces() == 0 && model_.polygons.segments.empty())
    source_.refuse("", model_.points.empty() ? "found no points, faces or lines, expected a model"
                                             : "has points but no faces or lines: nothing to draw");
  return std::move(model_);
}

}  // namespace hsr::internal::read
