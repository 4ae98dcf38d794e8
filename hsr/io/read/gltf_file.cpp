// The library writes files with streams that it does not include itself.
#include <fstream>

#define TINYGLTF_IMPLEMENTATION
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "geometry/error.h"
#include "hsr/io/read/byte_scanner.h"
#include "hsr/io/read/formats.h"
#include "hsr/io/read/gltf_file.h"
#include "hsr/io/read/json_depth.h"

namespace hsr::internal::read {

namespace {

using Json = nlohmann::json;

/// The parts of a GLB file.
struct Chunks {
  std::string_view json, binary;
  std::size_t json_at = 0;
};

Chunks split_glb(const Source& source) {
  ByteScanner bytes(source, 0, ByteOrder::little);
  bytes.need(20, "the 20 bytes of a GLB header");
  bytes.skip(4);
  const auto version = bytes.get<std::uint32_t>();
  if (version != 2) bytes.refuse(4, "version " + std::to_string(version), "2");
  const auto length = bytes.get<std::uint32_t>();
  if (length > source.bytes.size() || length < 20)
    bytes.refuse(8, "a file of " + std::to_string(source.bytes.size()) + " bytes",
                 std::to_string(length) + " as the header says");
  Chunks chunks;
  while (bytes.offset() + 8 <= length) {
    const std::size_t at = bytes.offset();
    const auto size = bytes.get<std::uint32_t>();
    const auto type = bytes.get<std::uint32_t>();
    if (size > length - bytes.offset())
      bytes.refuse(at, "a chunk of " + std::to_string(size) + " bytes",
                   "no more than the " + std::to_string(length - bytes.offset()) + " that follow");
    const std::string_view chunk = source.bytes.substr(bytes.offset(), size);
    if (type == 0x4e4f534aU && chunks.json.data() == nullptr) {
      chunks.json = chunk;
      chunks.json_at = bytes.offset();
    } else if (type == 0x004e4942U && chunks.binary.data() == nullptr) {
      chunks.binary = chunk;
    }
    bytes.skip(size);
  }
  if (chunks.json.data() == nullptr) bytes.refuse(12, "no JSON chunk", "one");
  return chunks;
}

/// The first line, without the place that the parser gives in its own way.
std::string first_line(std::string text) {
  text.resize(std::min(text.find_first_of("\r\n"), text.size()));
  return printable(text, 160);
}

Json parse_json(const Source& source, std::string_view text, std::size_t first_byte) {
  check_json_depth(source, text, first_byte);
  try {
    Json json = Json::parse(text.begin(), text.end());
    if (!json.is_object()) source.refuse("byte " + std::to_string(first_byte), "found JSON that is no object, expected glTF");
    return json;
  } catch (const Json::parse_error& e) {
    const std::size_t at = std::min(e.byte == 0 ? 0 : e.byte - 1, text.size());
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    source.refuse("line " + std::to_string(line) + " of the JSON",
                  "found " + (at < text.size() ? in_quotes(text.substr(at, 20)) : std::string("the end")) +
                      ", expected well-formed JSON");
  } catch (const Json::exception& e) {
    source.refuse("", "found JSON that cannot be read (" + first_line(e.what()) + "), expected glTF");
  }
}

/// @throws InputError for extensions without which the geometry is not what the file means
void check_extensions(const Source& source, const Json& json) {
  const auto required = json.find("extensionsRequired");
  if (required == json.end() || !required->is_array()) return;
  for (const Json& e : *required) {
    if (!e.is_string()) continue;
    const std::string& name = e.get_ref<const std::string&>();
    if (name == "KHR_draco_mesh_compression" || name == "EXT_meshopt_compression")
      source.refuse("", "found geometry compressed with " + name + ", expected it uncompressed: export it without compression");
    if (name != "KHR_mesh_quantization" && !name.starts_with("KHR_materials_") && !name.starts_with("KHR_texture_") &&
        !name.starts_with("EXT_texture_") && name != "EXT_mesh_gpu_instancing" && name != "KHR_lights_punctual")
      source.refuse("", "found the required extension " + in_quotes(name) + ", expected a file that does without it");
  }
}

/// The objects of an array of the file; others in it are empty ones.
std::vector<Json> objects_of(const Json& json, const char* name) {
  std::vector<Json> objects;
  const auto at = json.find(name);
  if (at == json.end() || !at->is_array()) return objects;
  for (const Json& o : *at) objects.push_back(o.is_object() ? o : Json::object());
  return objects;
}

std::optional<double> positive_number(const Json& object, const char* name) {
  const auto at = object.find(name);
  if (at == object.end() || !at->is_number()) return {};
  const double x = at->get<double>();
  if (!(x > 0 && std::isfinite(x))) return {};
  return x;
}

std::optional<std::size_t> index(const Json& object, const char* name) {
  const auto at = object.find(name);
  if (at == object.end() || !at->is_number_unsigned()) return {};
  return at->get<std::size_t>();
}

std::string text(const Json& object, const char* name) {
  const auto at = object.find(name);
  return at != object.end() && at->is_string() ? at->get<std::string>() : std::string();
}

std::optional<GltfCamera> camera_of(const Json& json) {
  GltfCamera camera;
  camera.name = text(json, "name");
  if (text(json, "type") == "orthographic") return camera;
  const auto lens = json.find("perspective");
  if (lens == json.end() || !lens->is_object()) return {};
  camera.field_of_view = positive_number(*lens, "yfov");
  camera.aspect_ratio = positive_number(*lens, "aspectRatio");
  camera.near = positive_number(*lens, "znear");
  if (!camera.field_of_view || *camera.field_of_view >= 3.14159) return {};
  return camera;
}

Wrap wrap_of(const Json& sampler, const char* name) {
  const std::optional<std::size_t> mode = index(sampler, name);
  return mode == 33071U ? Wrap::clamp : mode == 33648U ? Wrap::mirror : Wrap::repeat;
}

/// Cameras and pictures, before they are taken out.
void read_own(const Json& json, GltfFile& file) {
  for (const Json& camera : objects_of(json, "cameras")) file.cameras.push_back(camera_of(camera));
  for (const Json& image : objects_of(json, "images")) file.images.push_back({text(image, "uri"), index(image, "bufferView")});
  const std::vector<Json> samplers = objects_of(json, "samplers");
  for (const Json& given : objects_of(json, "textures")) {
    GltfTexture texture{.image = index(given, "source")};
    if (const auto sampler = index(given, "sampler"); sampler && *sampler < samplers.size()) {
      texture.wrap_s = wrap_of(samplers[*sampler], "wrapS");
      texture.wrap_t = wrap_of(samplers[*sampler], "wrapT");
    }
    file.textures.push_back(texture);
  }
}

/// What CAD scripts say in extras of surfaces and edges: of a primitive, or of a mesh that has one.
void read_marks(const Source& source, const Json& json, GltfFile& file) {
  const auto marks_in = [](const Json& thing) -> const Json* {
    if (!thing.is_object() || !thing.contains("extras")) return nullptr;
    const Json& extras = thing["extras"];
    return extras.is_object() && extras.contains("hsr_marks") ? &extras["hsr_marks"] : nullptr;
  };
  const std::vector<Json> meshes = objects_of(json, "meshes");
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    const std::vector<Json> primitives = objects_of(meshes[m], "primitives");
    for (std::size_t k = 0; k < primitives.size(); ++k)
      if (const Json* marks = marks_in(primitives[k])) file.marks[{m, k}] = marks->dump();
    const Json* const of_mesh = marks_in(meshes[m]);
    if (of_mesh == nullptr) continue;
    if (primitives.size() != 1)
      source.refuse("mesh " + std::to_string(m) + ", extras", "found hsr_marks of " + std::to_string(primitives.size()) +
                                                                  " primitives, expected them in the extras of each primitive");
    file.marks.try_emplace({m, 0}, of_mesh->dump());
  }
}

/// What hsr has no use for, or has read itself, goes before the library sees it: it could stumble over it.
void take_out_unused(Json& json, std::vector<std::string>& notes) {
  if (json.contains("skins")) notes.emplace_back("skins are passed over: the model is as it was before it was posed");
  for (const char* name : {"images", "textures", "samplers", "animations", "skins", "cameras", "extensions", "extras", "asset"})
    json.erase(name);
  json["asset"] = {{"version", "2.0"}};
  bool targets = false;
  if (const auto meshes = json.find("meshes"); meshes != json.end() && meshes->is_array()) {
    for (Json& mesh : *meshes) {
      if (!mesh.is_object() || !mesh.contains("primitives") || !mesh["primitives"].is_array()) continue;
      for (Json& primitive : mesh["primitives"])
        if (primitive.is_object() && primitive.erase("targets") != 0) targets = true;
    }
  }
  if (targets) notes.emplace_back("morph targets are passed over");
}

std::string make_glb(const std::string& json, std::string_view binary) {
  std::string padded = json;
  padded.resize((json.size() + 3) / 4 * 4, ' ');
  std::string out = "glTF";
  const auto append = [&](std::size_t n) {
    for (int i = 0; i < 4; ++i) out += static_cast<char>((n >> (8 * i)) & 0xff);
  };
  const std::size_t binary_size = (binary.size() + 3) / 4 * 4;
  append(2);
  append(20 + padded.size() + (binary.empty() ? 0 : 8 + binary_size));
  append(padded.size());
  out += "JSON";
  out += padded;
  if (!binary.empty()) {
    append(binary_size);
    out += std::string("BIN\0", 4);
    out += binary;
    out.resize(out.size() + binary_size - binary.size(), '\0');
  }
  return out;
}

tinygltf::FsCallbacks file_callbacks() {
  tinygltf::FsCallbacks callbacks;
  callbacks.FileExists = [](const std::string& path, void*) { return read_named_file(path).has_value(); };
  callbacks.ExpandFilePath = [](const std::string& path, void*) { return path; };
  callbacks.ReadWholeFile = [](std::vector<unsigned char>* out, std::string*, const std::string& path, void*) {
    const std::optional<Bytes> bytes = read_named_file(path);
    if (!bytes) return false;
    const auto* const begin = reinterpret_cast<const unsigned char*>(bytes->data.get());
    out->assign(begin, begin + bytes->size);
    return true;
  };
  callbacks.WriteWholeFile = nullptr;
  callbacks.user_data = nullptr;
  return callbacks;
}

}  // namespace

bool looks_like_gltf(const Source& source) {
  const std::string_view b = source.bytes;
  if (b.substr(0, 4) == "glTF") return true;
  const std::size_t first = b.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && b[first] == '{' && b.find("\"asset\"") != std::string_view::npos;
}

GltfFile load_gltf(const Source& source, std::vector<std::string>& notes) {
  const bool is_glb = source.bytes.substr(0, 4) == "glTF";
  const Chunks chunks = is_glb ? split_glb(source) : Chunks{source.bytes, {}, 0};
  Json json = parse_json(source, chunks.json, chunks.json_at);
  check_extensions(source, json);
  GltfFile file;
  read_own(json, file);
  read_marks(source, json, file);
  take_out_unused(json, notes);

  tinygltf::TinyGLTF loader;
  loader.SetFsCallbacks(file_callbacks());
  std::string errors, warnings;
  bool loaded = false;
  try {
    const std::string text = is_glb ? make_glb(json.dump(), chunks.binary) : json.dump();
    if (text.size() > 0xffffffffU) source.refuse("", "found more than 4 GiB of glTF, expected less");
    std::string directory = source.beside("");
    if (directory.empty()) directory = ".";
    const auto size = static_cast<unsigned>(text.size());
    loaded = is_glb ? loader.LoadBinaryFromMemory(&file.model, &errors, &warnings,
                                                  reinterpret_cast<const unsigned char*>(text.data()), size, directory)
                    : loader.LoadASCIIFromString(&file.model, &errors, &warnings, text.data(), size, directory);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& e) {
    errors = e.what();
  }
  if (!loaded || !errors.empty()) source.refuse("", "found glTF that is not valid, expected glTF 2.0: " + first_line(errors));
  return file;
}

std::optional<std::vector<unsigned char>> image_bytes(const Source& source, const GltfFile& file, const GltfImage& image) {
  std::vector<unsigned char> bytes;
  if (image.buffer_view) {
    const tinygltf::Model& model = file.model;
    if (*image.buffer_view >= model.bufferViews.size()) return {};
    const tinygltf::BufferView& view = model.bufferViews[*image.buffer_view];
    if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= model.buffers.size()) return {};
    const std::vector<unsigned char>& data = model.buffers[static_cast<std::size_t>(view.buffer)].data;
    if (view.byteOffset > data.size() || view.byteLength > data.size() - view.byteOffset) return {};
    const auto first = data.begin() + static_cast<std::ptrdiff_t>(view.byteOffset);
    bytes.assign(first, first + static_cast<std::ptrdiff_t>(view.byteLength));
    return bytes;
  }
  if (tinygltf::IsDataURI(image.uri)) {
    std::string type;
    if (!tinygltf::DecodeDataURI(&bytes, type, image.uri, 0, false)) return {};
    return bytes;
  }
  if (image.uri.empty()) return {};
  const std::optional<Bytes> read = read_named_file(source.beside(tinygltf::dlib::urldecode(image.uri)));
  if (!read) return {};
  bytes.assign(read->data.get(), read->data.get() + read->size);
  return bytes;
}

}  // namespace hsr::internal::read
