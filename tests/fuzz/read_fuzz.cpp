// Any bytes are read, or refused in one line. The first byte of an input chooses the ending, the rest is the file.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>

#include "geometry/error.h"
#include "hsr/io/read/read.h"
#include "tests/io/read/small_files.h"

namespace {

const char* const endings[] = {"obj", "off", "ply", "stl", "gltf", "glb", "none", "obj.gz"};

void demand(bool holds) {
  if (!holds) std::abort();
}

}  // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string name = std::string("fuzz.") + endings[data[0] % std::size(endings)];
  try {
    const hsr::Model m = hsr::read_model(name, {reinterpret_cast<const char*>(data) + 1, size - 1});
    for (const hsr::Point3& p : m.points) demand(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
    for (const std::uint32_t i : m.polygons.corners) demand(i < m.points.size());
    for (const auto& s : m.polygons.segments) demand(s[0] < m.points.size() && s[1] < m.points.size());
    demand(m.polygons.first.back() == m.polygons.corners.size());
    demand(m.face_colour.empty() || m.face_colour.size() == m.polygons.size());
    demand(m.face_object.empty() || m.face_object.size() == m.polygons.size());
    demand(m.segment_object.size() == (m.objects.empty() ? 0 : m.polygons.segments.size()));
    for (const std::uint32_t o : m.segment_object) demand(o < m.objects.size());
    for (const std::uint32_t c : m.face_colour) demand(c == 0xffffffffU || c < m.palette.size());
    for (const std::uint32_t o : m.face_object) demand(o < m.objects.size());
  } catch (const hsr::InputError& e) {
    demand(std::strchr(e.what(), '\n') == nullptr);
  }
  return 0;
}

/// Begins with the small files of the tests, now and then anew.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  static const std::vector<hsr::test::SmallFile> files = hsr::test::small_files();
  if (size < 2 || seed % 512 == 0) {
    const hsr::test::SmallFile& file = files[seed / 512 % files.size()];
    if (file.bytes.size() + 1 <= most) {
      data[0] = static_cast<std::uint8_t>(seed / 512 / files.size());
      std::copy(file.bytes.begin(), file.bytes.end(), data + 1);
      return file.bytes.size() + 1;
    }
  }
  return LLVMFuzzerMutate(data, size, most);
}
