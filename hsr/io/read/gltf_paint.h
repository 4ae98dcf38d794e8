#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hsr/io/read/gltf_accessor.h"
#include "hsr/io/read/gltf_file.h"
#include "hsr/io/read/linear_colour.h"
#include "hsr/io/read/picture.h"
#include "hsr/model.h"

namespace hsr::internal::read {

/// The pictures of a file, each decoded when it is first asked for.
class GltfPictures {
 public:
  GltfPictures(const Source& source, const GltfFile& file) : source_(source), file_(file) {}
  /// nullptr if the file has no such texture, or its picture cannot be read.
  const Picture* of_texture(std::size_t texture);
  /// How many pictures were asked for that cannot be read.
  std::size_t missing() const;

 private:
  const Source& source_;
  const GltfFile& file_;
  std::map<std::size_t, std::optional<Picture>> by_image_;
};

/// The colours of the faces of one primitive: of its material, times COLOR_0, times the texture.
///
/// glTF computes with amounts of light, and so does this. Of COLOR_0 it takes the mean over the corners of a face, of the texture the
/// mean over 16 to 256 texels evenly spaced on the face. The result is rounded once to bytes of sRGB; opacity is no light and is
/// rounded as it is.
///
/// By alphaMode OPAQUE ignores opacity, BLEND uses it, and MASK leaves out what is below alphaCutoff: a texel, or a whole face.
class GltfPaint {
 public:
  /// @param points how many the primitive has @param where for messages
  /// @throws InputError for accessors that are not as they should be
  GltfPaint(const Source& source, const GltfFile& file, const tinygltf::Primitive& primitive, std::size_t points,
            const std::string& where, GltfPictures& pictures);

  /// Whether faces are there, and in which colour, if they have one.
  struct Coat {
    bool is_there = true;
    std::optional<Colour> colour;
  };
  /// Of the face with these `n` corners, as points of the primitive. @pre n is not 0
  Coat of(const std::uint32_t* corners, std::size_t n) const;

 private:
  enum class Alpha { opaque, mask, blend };
  struct TextureUse;
  void read_material(const tinygltf::Material& material, TextureUse& use);
  void read_texture(const Source& source, const GltfFile& file, const tinygltf::Primitive& primitive, const TextureUse& use,
                    std::size_t points, const std::string& where, GltfPictures& pictures);
  LinearColour texel(double s, double t) const;
  Coat finish(LinearColour sum, double weight, std::size_t samples) const;

  bool has_colour_ = false;
  LinearColour factor_ = {1, 1, 1, 1};
  Alpha alpha_ = Alpha::opaque;
  double cutoff_ = 0.5;
  std::vector<std::array<float, 4>> corner_colours_;
  const Picture* picture_ = nullptr;
  Wrap wrap_s_ = Wrap::repeat, wrap_t_ = Wrap::repeat;
  std::vector<std::array<double, 2>> places_;  // of the points, in texels
};

}  // namespace hsr::internal::read
