#include "hsr/io/read/gltf_instances.h"

namespace hsr::internal::read {

GltfInstances::GltfInstances(const Source& source, const tinygltf::Model& model, const tinygltf::Value& extension,
                             const std::string& where) {
  const std::string here = where + ", EXT_mesh_gpu_instancing";
  if (!extension.IsObject() || !extension.Has("attributes") || !extension.Get("attributes").IsObject())
    source.refuse(here, "found no attributes, expected TRANSLATION, ROTATION or SCALE");
  const tinygltf::Value& attributes = extension.Get("attributes");
  bool any = false;
  const auto read = [&](const char* name, int components, std::optional<GltfAccessor>& to) {
    if (!attributes.Has(name)) return;
    const tinygltf::Value& accessor = attributes.Get(name);
    to.emplace(source, model, accessor.IsInt() ? accessor.GetNumberAsInt() : -1, components, here + ", " + name);
    if (any && to->size() != size_)
      source.refuse(here + ", " + name,
                    "found " + std::to_string(to->size()) + " elements, expected " + std::to_string(size_) + " as others have");
    size_ = to->size();
    any = true;
  };
  read("TRANSLATION", 3, translation_);
  read("ROTATION", 4, rotation_);
  read("SCALE", 3, scale_);
  if (!any) source.refuse(here, "found no attributes, expected TRANSLATION, ROTATION or SCALE");
}

Affine GltfInstances::placed(std::size_t i, bool& is_exact) const {
  const auto xyz = [i](const GltfAccessor& a) { return Point3{a.number(i, 0), a.number(i, 1), a.number(i, 2)}; };
  std::array<double, 4> rotation = {0, 0, 0, 1};
  if (rotation_)
    for (int c = 0; c < 4; ++c) rotation[static_cast<std::size_t>(c)] = rotation_->number(i, c);
  return placement(translation_ ? xyz(*translation_) : Point3{0, 0, 0}, rotation, scale_ ? xyz(*scale_) : Point3{1, 1, 1},
                   is_exact);
}

}  // namespace hsr::internal::read
