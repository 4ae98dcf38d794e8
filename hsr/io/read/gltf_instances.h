#pragma once

#include <optional>
#include <string>

#include "hsr/io/read/gltf_accessor.h"
#include "hsr/io/read/gltf_transform.h"

namespace hsr::internal::read {

/// The instances of a mesh by EXT_mesh_gpu_instancing: TRANSLATION, ROTATION and SCALE of each.
class GltfInstances {
 public:
  /// @param extension of the node @param where for messages
  /// @throws InputError where attributes are not as they should be, or differ in number
  GltfInstances(const Source& source, const tinygltf::Model& model, const tinygltf::Value& extension, const std::string& where);

  std::size_t size() const { return size_; }
  /// Where instance `i` is, relative to its node. @param is_exact set to false if a number of the matrix is rounded
  Affine placed(std::size_t i, bool& is_exact) const;

 private:
  std::optional<GltfAccessor> translation_, rotation_, scale_;
  std::size_t size_ = 0;
};

}  // namespace hsr::internal::read
