// The library writes files with streams that it does not include itself.
#include <fstream>

#define TINYGLTF_IMPLEMENTATION
#include <algorithm>
#include <array>
#include <cstring>
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
        !name.starts_with("EXT_texture_") && name != "KHR_lights_punctual")
      source.refuse("", "found the required extension " + in_quotes(name) + ", expected a file that does without it");
  }
}

/// What hsr has no use for goes before the library sees it: it would decode images and could stumble over the rest.
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

std::size_t component_size(int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return 4;
    default:
      return 0;
  }
}

template <class T>
T load(const unsigned char* p) {
  T value;
  std::memcpy(&value, p, sizeof(T));
  if constexpr (std::endian::native == std::endian::big && sizeof(T) > 1) {
    std::array<unsigned char, sizeof(T)> raw;
    std::reverse_copy(p, p + sizeof(T), raw.begin());
    std::memcpy(&value, raw.data(), sizeof(T));
  }
  return value;
}

}  // namespace

bool looks_like_gltf(const Source& source) {
  const std::string_view b = source.bytes;
  if (b.substr(0, 4) == "glTF") return true;
  const std::size_t first = b.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && b[first] == '{' && b.find("\"asset\"") != std::string_view::npos;
}

tinygltf::Model load_gltf(const Source& source, std::vector<std::string>& notes) {
  const bool is_glb = source.bytes.substr(0, 4) == "glTF";
  const Chunks chunks = is_glb ? split_glb(source) : Chunks{source.bytes, {}, 0};
  Json json = parse_json(source, chunks.json, chunks.json_at);
  check_extensions(source, json);
  take_out_unused(json, notes);

  tinygltf::TinyGLTF loader;
  loader.SetFsCallbacks(file_callbacks());
  tinygltf::Model model;
  std::string errors, warnings;
  bool loaded = false;
  try {
    const std::string text = is_glb ? make_glb(json.dump(), chunks.binary) : json.dump();
    if (text.size() > 0xffffffffU) source.refuse("", "found more than 4 GiB of glTF, expected less");
    std::string directory = source.beside("");
    if (directory.empty()) directory = ".";
    const auto size = static_cast<unsigned>(text.size());
    loaded = is_glb ? loader.LoadBinaryFromMemory(&model, &errors, &warnings,
                                                  reinterpret_cast<const unsigned char*>(text.data()), size, directory)
                    : loader.LoadASCIIFromString(&model, &errors, &warnings, text.data(), size, directory);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& e) {
    errors = e.what();
  }
  if (!loaded || !errors.empty()) source.refuse("", "found glTF that is not valid, expected glTF 2.0: " + first_line(errors));
  return model;
}

GltfAccessor::GltfAccessor(const Source& source, const tinygltf::Model& model, int accessor, int components,
                           const std::string& what) {
  const auto refuse = [&](const std::string& found, const std::string& expected) {
    source.refuse(what, "found " + found + ", expected " + expected);
  };
  if (accessor < 0 || static_cast<std::size_t>(accessor) >= model.accessors.size())
    refuse("accessor " + std::to_string(accessor), "one of " + std::to_string(model.accessors.size()));
  const tinygltf::Accessor& a = model.accessors[static_cast<std::size_t>(accessor)];
  const std::string name = "accessor " + std::to_string(accessor);
  if (a.sparse.isSparse) refuse("the sparse " + name, "one that is not sparse");
  if (a.bufferView < 0 || static_cast<std::size_t>(a.bufferView) >= model.bufferViews.size())
    refuse(name + " without data", "a bufferView (is the geometry compressed?)");
  const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(a.bufferView)];
  if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= model.buffers.size())
    refuse("bufferView " + std::to_string(a.bufferView) + " of buffer " + std::to_string(view.buffer),
           "one of " + std::to_string(model.buffers.size()) + " buffers");
  const std::vector<unsigned char>& data = model.buffers[static_cast<std::size_t>(view.buffer)].data;
  type_ = a.componentType;
  normalised_ = a.normalized;
  count_ = a.count;
  const std::size_t component = component_size(type_);
  const bool whole = type_ == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE || type_ == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                     type_ == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
  if (component == 0 || (components == 1 && !whole) || (components == 3 && type_ == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT))
    refuse(name + " of component type " + std::to_string(type_),
           components == 1 ? "an unsigned byte, short or int" : "a float, byte or short");
  if (a.type != (components == 1 ? TINYGLTF_TYPE_SCALAR : TINYGLTF_TYPE_VEC3))
    refuse(name + " of another type", components == 1 ? "SCALAR" : "VEC3");
  const std::size_t element = component * static_cast<std::size_t>(components);
  stride_ = view.byteStride == 0 ? element : view.byteStride;
  if (stride_ < element) refuse("a byteStride of " + std::to_string(stride_), std::to_string(element) + " or more");
  const std::size_t room = data.size() > view.byteOffset ? std::min(view.byteLength, data.size() - view.byteOffset) : 0;
  if (view.byteOffset > data.size() || view.byteLength > data.size() - view.byteOffset)
    refuse("bufferView " + std::to_string(a.bufferView) + " beyond its buffer of " + std::to_string(data.size()) + " bytes",
           "one inside it");
  if (a.byteOffset > room ||
      (count_ != 0 && (room - a.byteOffset < element || (room - a.byteOffset - element) / stride_ < count_ - 1)))
    refuse(name + " of " + std::to_string(count_) + " elements",
           "no more than fit into the " + std::to_string(room) + " bytes of its bufferView");
  data_ = data.data() + view.byteOffset + a.byteOffset;
}

std::uint32_t GltfAccessor::index(std::size_t i) const {
  const unsigned char* const p = data_ + i * stride_;
  switch (type_) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return *p;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return load<std::uint16_t>(p);
    default:
      return load<std::uint32_t>(p);
  }
}

double GltfAccessor::number(std::size_t i, int c) const {
  const unsigned char* const p = data_ + i * stride_ + static_cast<std::size_t>(c) * component_size(type_);
  switch (type_) {
    case TINYGLTF_COMPONENT_TYPE_BYTE: {
      const double x = load<std::int8_t>(p);
      return normalised_ ? std::max(x / 127, -1.0) : x;
    }
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return normalised_ ? *p / 255.0 : *p;
    case TINYGLTF_COMPONENT_TYPE_SHORT: {
      const double x = load<std::int16_t>(p);
      return normalised_ ? std::max(x / 32767, -1.0) : x;
    }
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: {
      const double x = load<std::uint16_t>(p);
      return normalised_ ? x / 65535 : x;
    }
    default:
      return load<float>(p);
  }
}

}  // namespace hsr::internal::read
