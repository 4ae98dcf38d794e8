#include "hsr/io/read/gltf_paint.h"

#include <algorithm>
#include <cmath>

#include "hsr/io/read/material_library.h"

namespace hsr::internal::read {

namespace {

constexpr double least_steps = 4, most_steps = 16;  // along each side of a face

/// The texel of a coordinate in texels.
std::size_t wrapped(double x, std::size_t size, Wrap wrap) {
  if (!std::isfinite(x)) return 0;
  const auto n = static_cast<double>(size);
  x = std::floor(x);
  if (wrap == Wrap::repeat) x -= n * std::floor(x / n);
  if (wrap == Wrap::mirror) {
    x -= 2 * n * std::floor(x / (2 * n));
    if (x >= n) x = 2 * n - 1 - x;
  }
  return static_cast<std::size_t>(std::clamp(x, 0.0, n - 1));
}

double number(const tinygltf::Value& object, const char* name, std::size_t i, double otherwise) {
  if (!object.IsObject() || !object.Has(name)) return otherwise;
  const tinygltf::Value& list = object.Get(name);
  if (list.IsNumber()) return list.GetNumberAsDouble();
  if (!list.IsArray() || i >= list.ArrayLen() || !list.Get(static_cast<int>(i)).IsNumber()) return otherwise;
  return list.Get(static_cast<int>(i)).GetNumberAsDouble();
}

}  // namespace

/// Which texture is used where.
struct GltfPaint::TextureUse {
  int texture = -1;
  int coordinates = 0;                             // n of TEXCOORD_n
  std::array<double, 6> map = {1, 0, 0, 0, 1, 0};  // of texture coordinates, row by row

  void transform(const tinygltf::ExtensionMap& extensions) {
    const auto at = extensions.find("KHR_texture_transform");
    if (at == extensions.end()) return;
    const tinygltf::Value& v = at->second;
    const double turn = number(v, "rotation", 0, 0), c = std::cos(turn), s = std::sin(turn);
    const double sx = number(v, "scale", 0, 1), sy = number(v, "scale", 1, 1);
    map = {c * sx, s * sy, number(v, "offset", 0, 0), -s * sx, c * sy, number(v, "offset", 1, 0)};
    coordinates = static_cast<int>(number(v, "texCoord", 0, coordinates));
  }
};

const Picture* GltfPictures::of_texture(std::size_t texture) {
  if (texture >= file_.textures.size()) return nullptr;
  const std::optional<std::size_t> image = file_.textures[texture].image;
  // One that only an extension names is missing, too.
  const std::size_t key = image && *image < file_.images.size() ? *image : file_.images.size() + texture;
  const auto [at, is_new] = by_image_.try_emplace(key);
  if (is_new && key < file_.images.size())
    if (const auto bytes = image_bytes(source_, file_, file_.images[key])) at->second = decode_picture(*bytes);
  return at->second ? &*at->second : nullptr;
}

std::size_t GltfPictures::missing() const {
  return static_cast<std::size_t>(
      std::count_if(by_image_.begin(), by_image_.end(), [](const auto& entry) { return !entry.second; }));
}

GltfPaint::GltfPaint(const Source& source, const GltfFile& file, const tinygltf::Primitive& primitive, std::size_t points,
                     const std::string& where, GltfPictures& pictures) {
  const std::vector<tinygltf::Material>& materials = file.model.materials;
  if (primitive.material >= 0) {
    if (static_cast<std::size_t>(primitive.material) >= materials.size())
      source.refuse(where, "found material " + std::to_string(primitive.material) + ", expected one of " +
                               std::to_string(materials.size()));
    has_colour_ = true;
    TextureUse use;
    read_material(materials[static_cast<std::size_t>(primitive.material)], use);
    if (use.texture >= 0) read_texture(source, file, primitive, use, points, where, pictures);
  }
  const auto colours = primitive.attributes.find("COLOR_0");
  if (colours == primitive.attributes.end()) return;
  has_colour_ = true;
  const int n = components_of(file.model, colours->second) == 3 ? 3 : 4;
  const GltfAccessor given(source, file.model, colours->second, n, where + ", COLOR_0");
  if (given.size() != points)
    source.refuse(where + ", COLOR_0", "found " + std::to_string(given.size()) + " colours, expected one for each of " +
                                           std::to_string(points) + " points");
  corner_colours_.resize(points, {1, 1, 1, 1});
  for (std::size_t i = 0; i < points; ++i)
    for (int c = 0; c < n; ++c) corner_colours_[i][static_cast<std::size_t>(c)] = static_cast<float>(given.number(i, c));
}

void GltfPaint::read_material(const tinygltf::Material& material, TextureUse& use) {
  const std::vector<double>& rgba = material.pbrMetallicRoughness.baseColorFactor;
  if (rgba.size() == 4) std::copy(rgba.begin(), rgba.end(), factor_.begin());
  const tinygltf::TextureInfo& texture = material.pbrMetallicRoughness.baseColorTexture;
  use = {.texture = texture.index, .coordinates = texture.texCoord};
  use.transform(texture.extensions);
  // An older way to say the same.
  if (const auto at = material.extensions.find("KHR_materials_pbrSpecularGlossiness"); at != material.extensions.end()) {
    const tinygltf::Value& older = at->second;
    for (std::size_t c = 0; c < 4; ++c) factor_[c] = number(older, "diffuseFactor", c, 1);
    const bool has_texture = older.IsObject() && older.Has("diffuseTexture");
    const tinygltf::Value& info = has_texture ? older.Get("diffuseTexture") : older;
    use = {.texture = has_texture ? static_cast<int>(number(info, "index", 0, -1)) : -1,
           .coordinates = has_texture ? static_cast<int>(number(info, "texCoord", 0, 0)) : 0};
  }
  alpha_ = material.alphaMode == "MASK" ? Alpha::mask : material.alphaMode == "BLEND" ? Alpha::blend : Alpha::opaque;
  cutoff_ = material.alphaCutoff;
}

void GltfPaint::read_texture(const Source& source, const GltfFile& file, const tinygltf::Primitive& primitive,
                             const TextureUse& use, std::size_t points, const std::string& where, GltfPictures& pictures) {
  const std::string name = "TEXCOORD_" + std::to_string(use.coordinates);
  const auto at = primitive.attributes.find(name);
  if (at == primitive.attributes.end()) return;
  const auto texture = static_cast<std::size_t>(use.texture);
  picture_ = pictures.of_texture(texture);
  if (picture_ == nullptr) return;
  wrap_s_ = file.textures[texture].wrap_s;
  wrap_t_ = file.textures[texture].wrap_t;
  const GltfAccessor given(source, file.model, at->second, 2, where + ", " + name);
  if (given.size() != points)
    source.refuse(where + ", " + name, "found " + std::to_string(given.size()) + " places, expected one for each of " +
                                           std::to_string(points) + " points");
  const auto width = static_cast<double>(picture_->width), height = static_cast<double>(picture_->height);
  for (std::size_t i = 0; i < points; ++i) {
    const double u = given.number(i, 0), v = given.number(i, 1);
    const std::array<double, 6>& m = use.map;
    places_.push_back({(m[0] * u + m[1] * v + m[2]) * width, (m[3] * u + m[4] * v + m[5]) * height});
  }
}

LinearColour GltfPaint::texel(double s, double t) const {
  const std::uint8_t* const rgba = picture_->texel(wrapped(s, picture_->width, wrap_s_), wrapped(t, picture_->height, wrap_t_));
  return {linear_of_srgb(rgba[0]), linear_of_srgb(rgba[1]), linear_of_srgb(rgba[2]), rgba[3] / 255.0};
}

GltfPaint::Coat GltfPaint::of(const std::uint32_t* corners, std::size_t n) const {
  if (!has_colour_) return {};
  LinearColour factor = factor_;
  if (!corner_colours_.empty()) {
    for (std::size_t c = 0; c < 4; ++c) {
      double sum = 0;
      for (std::size_t k = 0; k < n; ++k) sum += corner_colours_[corners[k]][c];
      factor[c] *= sum / static_cast<double>(n);
    }
  }
  if (places_.empty() || n != 3) {
    if (alpha_ == Alpha::mask && factor[3] < cutoff_) return {.is_there = false, .colour = {}};
    return finish(factor, 1, 1);
  }
  const auto &a = places_[corners[0]], &b = places_[corners[1]], &c = places_[corners[2]];
  const double area = std::abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
  const auto steps = static_cast<int>(std::clamp(std::ceil(2 * std::sqrt(area)), least_steps, most_steps));
  LinearColour sum = {};
  double weight = 0;
  std::size_t samples = 0;
  const auto sample = [&](double i, double j) {
    const double x = i / steps, y = j / steps;
    LinearColour colour = texel(a[0] + x * (b[0] - a[0]) + y * (c[0] - a[0]), a[1] + x * (b[1] - a[1]) + y * (c[1] - a[1]));
    for (std::size_t k = 0; k < 4; ++k) colour[k] *= factor[k];
    if (alpha_ == Alpha::mask && colour[3] < cutoff_) return;
    // Of a pane what is more opaque counts more.
    const double w = alpha_ == Alpha::blend ? colour[3] : 1;
    for (std::size_t k = 0; k < 3; ++k) sum[k] += w * colour[k];
    sum[3] += colour[3];
    weight += w;
    ++samples;
  };
  // The middles of the steps x steps triangles into which the face is cut.
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; i + j < steps; ++j) sample(i + 1 / 3.0, j + 1 / 3.0);
    for (int j = 0; i + j + 1 < steps; ++j) sample(i + 2 / 3.0, j + 2 / 3.0);
  }
  return finish(sum, weight, samples);
}

GltfPaint::Coat GltfPaint::finish(LinearColour sum, double weight, std::size_t samples) const {
  if (samples == 0) return {.is_there = false, .colour = {}};
  for (std::size_t c = 0; c < 3; ++c) sum[c] = weight > 0 ? sum[c] / weight : 0;
  const std::uint8_t opacity = alpha_ == Alpha::blend ? colour_byte(sum[3] / static_cast<double>(samples)) : 255;
  return {.colour = Colour{srgb_byte(sum[0]), srgb_byte(sum[1]), srgb_byte(sum[2]), opacity}};
}

}  // namespace hsr::internal::read
