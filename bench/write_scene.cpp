// write_scene NAME OUT.obj|OUT.ply|OUT.stl: a scene of the benchmarks as a file, to try the command at size.
#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <exception>
#include <fstream>
#include <string>

#include "bench/scenes.h"
#include "geometry/error.h"

namespace hsr::bench {
namespace {

static_assert(std::endian::native == std::endian::little, "PLY and STL are written as the bytes lie in memory");

template <class T>
void append(std::string& out, T x) {
  char bytes[sizeof x];
  std::memcpy(bytes, &x, sizeof x);
  out.append(bytes, sizeof x);
}

void append_float32(std::string& out, const Point3& p) {
  for (int axis = 0; axis < 3; ++axis) append(out, static_cast<float>(p[axis]));
}

std::string obj(const Model& model) {
  std::string out = fmt::format("# {}: {} faces\n", model.name, model.polygons.size());
  for (const Point3& p : model.points) fmt::format_to(std::back_inserter(out), "v {} {} {}\n", p.x, p.y, p.z);
  for (std::size_t f = 0; f < model.polygons.size(); ++f) {
    out += 'f';
    for (const std::uint32_t corner : model.polygons[f]) fmt::format_to(std::back_inserter(out), " {}", corner + 1);
    out += '\n';
  }
  return out;
}

std::string ply(const Model& model) {
  std::string out = fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
      "element face {}\nproperty list uchar uint vertex_indices\nend_header\n",
      model.points.size(), model.polygons.size());
  for (const Point3& p : model.points) append_float32(out, p);
  for (std::size_t f = 0; f < model.polygons.size(); ++f) {
    append(out, static_cast<std::uint8_t>(model.polygons[f].size()));
    for (const std::uint32_t corner : model.polygons[f]) append(out, corner);
  }
  return out;
}

std::string stl(const Model& model) {
  std::string out = model.name;
  out.resize(80, ' ');
  append(out, static_cast<std::uint32_t>(model.polygons.size()));
  for (std::size_t f = 0; f < model.polygons.size(); ++f) {
    append_float32(out, {});  // no normal: readers compute it
    for (const std::uint32_t corner : model.polygons[f]) append_float32(out, model.points[corner]);
    append(out, std::uint16_t{0});
  }
  return out;
}

std::string in_format_of(const std::string& path, const Model& model) {
  if (path.ends_with(".obj")) return obj(model);
  if (path.ends_with(".ply")) return ply(model);
  if (path.ends_with(".stl")) return stl(model);
  throw InputError(path + ": expected an ending .obj, .ply or .stl");
}

}  // namespace
}  // namespace hsr::bench

int main(int argc, char** argv) {
  try {
    if (argc != 3)
      throw hsr::InputError("usage: write_scene NAME OUT.obj|OUT.ply|OUT.stl, as in write_scene knot100k knot.ply");
    const std::string bytes = hsr::bench::in_format_of(argv[2], hsr::bench::scene(argv[1]));
    std::ofstream out(argv[2], std::ios::binary);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (!out.flush()) throw hsr::InputError(std::string(argv[2]) + ": cannot be written");
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
