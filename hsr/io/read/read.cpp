#include "hsr/io/read/read.h"

#include <algorithm>
#include <array>
#include <new>
#include <optional>
#include <string_view>

#include "geometry/error.h"
#include "hsr/io/read/formats.h"
#include "hsr/io/read/gzip.h"
#include "hsr/io/read/known_formats.h"
#include "hsr/io/read/source.h"

namespace hsr {

using namespace internal;

namespace {

using read::Source;

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
constexpr const char* known = "OBJ, OFF, PLY, STL, glTF or GLB, also gzipped";

/// The ending of `path` in lower case, without the point and without ".gz".
std::string ending_of(std::string path) {
  std::transform(path.begin(), path.end(), path.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  if (path.ends_with(".gz")) path.resize(path.size() - 3);
  const std::size_t slash = path.rfind('/');
  const std::size_t point = path.rfind('.');
  if (point == std::string::npos || (slash != std::string::npos && point < slash)) return {};
  return path.substr(point + 1);
}

struct Unsupported {
  const char* ending;
  const char* name;
  const char* advice;
};
constexpr const char* surfaces = "STL or OBJ from the CAD program, or build hsr with Open CASCADE (HSR_STEP)";
constexpr std::array<Unsupported, 14> unsupported = {{
    {"step", "STEP", surfaces},
    {"stp", "STEP", surfaces},
    {"iges", "IGES", surfaces},
    {"igs", "IGES", surfaces},
    {"brep", "BREP", "STL or OBJ from the CAD program"},
    {"dwg", "DWG", "STL or OBJ from the CAD program"},
    {"dxf", "DXF", "STL or OBJ from the CAD program"},
    {"ifc", "IFC", "OBJ or glTF"},
    {"3ds", "3DS", "OBJ or glTF"},
    {"fbx", "FBX", "OBJ or glTF"},
    {"dae", "COLLADA", "OBJ or glTF"},
    {"blend", "Blender", "OBJ or glTF"},
    {"3mf", "3MF", "STL or OBJ, or build hsr with lib3mf (HSR_3MF)"},
    {"amf", "AMF", "STL or OBJ"},
}};

/// @param more how the list of known formats goes on in messages
Model read_by_content(Source source, const std::string& more) {
  // Some programs write the byte order mark of UTF-8 before a text; it would hide the first keyword.
  if (source.bytes.starts_with(byte_order_mark) && !looks_like_binary_stl(source))
    source.bytes.remove_prefix(byte_order_mark.size());
  const std::string ending = ending_of(source.path);
  if (source.bytes.empty()) source.refuse("", "found an empty file, expected a model");
  if (looks_like_ply(source)) return read_ply(source);
  if (looks_like_gltf(source)) return read_gltf(source);
  if (looks_like_off(source)) return read_off(source);
  if (looks_like_binary_stl(source)) return read_stl(source);
  if (ending == "obj") return read_obj(source);  // it has no mark of its own
  if (looks_like_ascii_stl(source) || ending == "stl") return read_stl(source);
  if (ending == "off") return read_off(source);
  if (ending == "ply") return read_ply(source);
  if (ending == "gltf" || ending == "glb") return read_gltf(source);
  for (const Unsupported& u : unsupported)
    if (ending == u.ending) source.refuse("", std::string(u.name) + " is not supported: export " + u.advice);
  source.refuse(
      "", (ending.empty() ? "found no ending that tells the format" : "found the ending " + read::in_quotes("." + ending)) +
              ", expected " + known + more);
}

Model read_source(const Source& source, const std::string& more) {
  try {
    if (!read::is_gzip(source.bytes)) return read_by_content(source, more);
    const read::Bytes inflated = read::gunzip(source);
    Model model = read_by_content({source.path, inflated.view()}, more);
    model.format += ", gzip";
    return model;
  } catch (const std::bad_alloc&) {
    source.refuse("", "found a model that is too large for the memory, expected a smaller one");
  } catch (const std::length_error&) {
    source.refuse("", "found a model that is too large for the memory, expected a smaller one");
  }
}

/// The first bytes of a file, in which a header ends.
constexpr std::size_t head_size = std::size_t{1} << 16;

/// Whether a format needs no more of a file than the block at hand: PLY and STL in binary.
bool is_gone_through_once(const Source& source) {
  if (!looks_like_ply(source))
    return looks_like_binary_stl(source) && !read::is_gzip(source.bytes) && !looks_like_gltf(source) && !looks_like_off(source);
  const std::size_t end = std::min(source.bytes.find("\nend_header"), source.bytes.find("\rend_header"));
  return end < source.bytes.size() / 2 && source.bytes.substr(0, end).find("format binary_") != std::string_view::npos;
}

}  // namespace

Model read_model(const std::string& path) { return read::read_model_among(path, ""); }

Model read_model(const std::string& name, std::string_view bytes) { return read::read_model_among(name, bytes, ""); }

namespace internal::read {

Model read_model_among(const std::string& path, const std::string& more) {
  try {
    if (const std::optional<BlockFile> file = BlockFile::open(path); file && file->size() > head_size) {
      Bytes head = Bytes::of_size(head_size);
      const Source source{path, head.view(), &*file};
      if (file->read(0, head.data.get(), head_size) == head_size && is_gone_through_once(source))
        return read_source(source, more);
    }
    const Bytes bytes = read_file(path);
    return read_source({path, bytes.view()}, more);
  } catch (const std::bad_alloc&) {
    Source{path, {}}.refuse("", "found a file that is too large for the memory, expected a smaller one");
  }
}

Model read_model_among(const std::string& name, std::string_view bytes, const std::string& more) {
  Bytes copy = Bytes::of_size(bytes.size());
  std::copy(bytes.begin(), bytes.end(), copy.data.get());
  return read_source({name, copy.view()}, more);
}

}  // namespace internal::read

}  // namespace hsr
