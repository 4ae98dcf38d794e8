#include "tests/io/read/small_files.h"

#include <zlib.h>

#include <algorithm>
#include <bit>

namespace hsr::test {

namespace {

const std::string square_floats = [] {
  std::string s;
  for (const float x : {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}) s += little_float(x);
  return s;
}();

std::string gltf_json(const std::string& buffer) {
  return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
"nodes": [{"name": "square", "mesh": 0, "translation": [1, 2, 3]}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
"materials": [{"pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 0.5]}}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
{"bufferView": 1, "componentType": 5121, "count": 6, "type": "SCALAR"}],
"bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 6}],
"buffers": [)" +
         buffer + "]}";
}

}  // namespace

std::string little(std::uint64_t x, int n) {
  std::string s;
  for (int i = 0; i < n; ++i) s += static_cast<char>((x >> (8 * i)) & 0xff);
  return s;
}

std::string big(std::uint64_t x, int n) {
  std::string s = little(x, n);
  std::reverse(s.begin(), s.end());
  return s;
}

std::string little_float(float x) { return little(std::bit_cast<std::uint32_t>(x), 4); }
std::string big_float(float x) { return big(std::bit_cast<std::uint32_t>(x), 4); }

std::string gzipped(const std::string& bytes) {
  z_stream z{};
  deflateInit2(&z, 9, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
  std::string out(deflateBound(&z, bytes.size()) + 64, '\0');
  std::string in = bytes;
  z.next_in = reinterpret_cast<Bytef*>(in.data());
  z.avail_in = static_cast<uInt>(in.size());
  z.next_out = reinterpret_cast<Bytef*>(out.data());
  z.avail_out = static_cast<uInt>(out.size());
  deflate(&z, Z_FINISH);
  out.resize(z.total_out);
  deflateEnd(&z);
  return out;
}

std::string base64(const std::string& bytes) {
  static const char* const digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) out += i + k <= bytes.size() ? digits[group >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

std::string glb(std::string json, std::string binary) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  binary.resize((binary.size() + 3) / 4 * 4, '\0');
  return "glTF" + little(2, 4) + little(28 + json.size() + binary.size(), 4) + little(json.size(), 4) + "JSON" + json +
         little(binary.size(), 4) + std::string("BIN\0", 4) + binary;
}

std::string binary_stl(const std::vector<float>& coordinates, const std::string& header) {
  std::string s = header;
  s.resize(80, ' ');
  s += little(coordinates.size() / 9, 4);
  for (std::size_t i = 0; i < coordinates.size(); i += 9) {
    s += std::string(12, '\0');
    for (std::size_t k = 0; k < 9; ++k) s += little_float(coordinates[i + k]);
    s += little(0x1234, 2);
  }
  return s;
}

std::vector<SmallFile> small_files() {
  std::vector<SmallFile> files = {
      {"square.obj",
       "# a square\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\ng a\nf 1/1 2/1 3/1\ng b\nf -4//1 -2 \\\n-1\nl 1 3 2\n"},
      {"square.off", "OFF\n4 2 5\n0 0 0\n1 0 0\n1 1 0\n0 1 0 # the last\n3 0 1 2 1 0 0\n3 0 2 3 0 0 255 128\n"},
      {"square_coloured.off", "COFF\n4 2 5\n0 0 0 1 0 0 1\n1 0 0 1 0 0 1\n1 1 0 1 0 0 1\n0 1 0 1 0 0 1\n3 0 1 2\n3 0 2 3\n"},
      {"square.ply",
       "ply\nformat ascii 1.0\ncomment x\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
       "element face 2\nproperty list uchar int vertex_indices\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
       "end_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 255 0 0\n3 0 2 3 0 0 255\n"},
      {"square.stl",
       "solid square\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nendloop\nendfacet\n"
       "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid square\n"},
      {"square_binary.stl", binary_stl({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0})},
      {"square_solid.stl", binary_stl({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0}, "solid but binary")},
  };
  for (const bool is_big : {false, true}) {
    const auto number = [&](std::uint64_t x, int n) { return is_big ? big(x, n) : little(x, n); };
    const auto real = [&](float x) { return is_big ? big_float(x) : little_float(x); };
    const std::string header = std::string("ply\nformat binary_") + (is_big ? "big" : "little") +
                               "_endian 1.0\nelement other 1\nproperty list uchar short numbers\nelement vertex 4\nproperty "
                               "uchar flag\nproperty float z\n"
                               "property float y\nproperty float x\n";
    std::string body = number(2, 1) + number(7, 2) + number(8, 2);
    for (const auto& [x, y] : {std::pair<float, float>{0, 0}, {1, 0}, {1, 1}, {0, 1}})
      body += number(9, 1) + real(0) + real(y) + real(x);
    const std::string name = is_big ? "square_big" : "square_little";
    files.push_back({name + ".ply", header + "element face 2\nproperty list int ushort vertex_index\nend_header\n" + body +
                                        number(3, 4) + number(0, 2) + number(1, 2) + number(2, 2) + number(3, 4) +
                                        number(0, 2) + number(2, 2) + number(3, 2)});
    std::string strip = number(7, 4);
    for (const int i : {0, 1, 2, -1, 0, 2, 3}) strip += number(static_cast<std::uint32_t>(i), 4);
    files.push_back({name + "_strips.ply",
                     header + "element tristrips 1\nproperty list int int vertex_indices\nend_header\n" + body + strip});
  }
  std::string off = "OFF BINARY\n" + big(4, 4) + big(2, 4) + big(5, 4);
  for (const float x : {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}) off += big_float(x);
  off += big(3, 4) + big(0, 4) + big(1, 4) + big(2, 4) + big(0, 4);
  off += big(3, 4) + big(0, 4) + big(2, 4) + big(3, 4) + big(4, 4) + big_float(1) + big_float(0) + big_float(0) + big_float(1);
  files.push_back({"square_binary.off", off});

  const std::string buffer = square_floats + std::string("\0\1\2\0\2\3\0\0", 8);
  files.push_back({"square.gltf",
                   gltf_json(R"({"byteLength": 56, "uri": "data:application/octet-stream;base64,)" + base64(buffer) + "\"}")});
  files.push_back({"square.glb", glb(gltf_json(R"({"byteLength": 56})"), buffer)});
  for (std::size_t i = 0, n = files.size(); i < n; ++i)
    if (files[i].name.starts_with("square.")) files.push_back({files[i].name + ".gz", gzipped(files[i].bytes)});
  return files;
}

}  // namespace hsr::test
