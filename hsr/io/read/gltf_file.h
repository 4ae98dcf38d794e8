#pragma once

// The library keeps its names: a program that links hsr may bring its own tiny_gltf.
#define tinygltf hsr_tinygltf
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_FS
#include <tiny_gltf.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hsr/io/read/source.h"

namespace hsr::internal::read {

/// A camera, looking along its -z with y up. Nodes place it.
struct GltfCamera {
  std::string name;
  std::optional<double> field_of_view;  ///< vertical, radians; nothing: parallel
  std::optional<double> aspect_ratio, near;
};

/// How coordinates beyond 0 ... 1 find a texel.
enum class Wrap { repeat, clamp, mirror };

struct GltfTexture {
  std::optional<std::size_t> image;
  Wrap wrap_s = Wrap::repeat, wrap_t = Wrap::repeat;
};

struct GltfImage {
  std::string uri;
  std::optional<std::size_t> buffer_view;
};

/// A glTF or GLB file: what tiny_gltf reads, with the buffers, and what hsr reads itself. Indices in it are unchecked.
struct GltfFile {
  tinygltf::Model model;
  std::vector<std::optional<GltfCamera>> cameras;  ///< nothing for one that is not as it should be
  std::vector<GltfTexture> textures;
  std::vector<GltfImage> images;
  std::map<std::pair<std::size_t, std::size_t>, std::string> marks;  ///< "hsr_marks" in extras, as JSON, by mesh and primitive
};

/// What hsr has no use for (animations, skins) is taken out before tiny_gltf sees it, and so is what hsr reads itself: the library
/// would refuse the file for a camera or a picture that is not as it should be.
/// @throws InputError also for files that need an extension that hides the geometry (Draco, meshopt)
GltfFile load_gltf(const Source& source, std::vector<std::string>& notes);

/// The bytes of an image, from the file itself or beside it; nothing if they are not there.
std::optional<std::vector<unsigned char>> image_bytes(const Source& source, const GltfFile& file, const GltfImage& image);

}  // namespace hsr::internal::read
