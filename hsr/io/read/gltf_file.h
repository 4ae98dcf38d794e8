#pragma once

// The library keeps its names: a program that links hsr may bring its own tiny_gltf.
#define tinygltf hsr_tinygltf
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_FS
#include <tiny_gltf.h>

#include <cstdint>
#include <string>
#include <vector>

#include "hsr/io/read/source.h"

namespace hsr::internal::read {

/// A glTF or GLB file as tiny_gltf reads it, with the buffers. Indices in it are unchecked.
///
/// What hsr has no use for (images, textures, samplers, animations, skins, cameras) is taken out before.
/// @throws InputError also for files that need an extension that hides the geometry (Draco, meshopt)
tinygltf::Model load_gltf(const Source& source, std::vector<std::string>& notes);

/// The elements of an accessor, checked against its buffer.
class GltfAccessor {
 public:
  /// @throws InputError @param what for messages; `components` 1 for indices, 3 for positions
  GltfAccessor(const Source& source, const tinygltf::Model& model, int accessor, int components, const std::string& what);

  std::size_t size() const { return count_; }
  std::uint32_t index(std::size_t i) const;
  /// Component `c` of element `i`; normalised integers are divided by their largest value and rounded once.
  double number(std::size_t i, int c) const;

 private:
  const unsigned char* data_ = nullptr;
  std::size_t stride_ = 0, count_ = 0;
  int type_ = 0;
  bool normalised_ = false;
};

}  // namespace hsr::internal::read
