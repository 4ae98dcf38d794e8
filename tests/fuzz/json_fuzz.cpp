// Any bytes as JSON that hsr reads: a painting order, which is judged then, or marks of a model's edges. They are read, or refused in one
// line. The first byte of an input chooses which.
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <string>
#include <string_view>

#include "geometry/error.h"
#include "geometry/number.h"
#include "hsr/io/read/read.h"
#include "hsr/painter/verify/verify.h"

namespace {

void demand(bool holds) {
  if (!holds) std::abort();
}

/// A file in memory, as those readers take paths.
class MemoryFile {
 public:
  MemoryFile() : descriptor_(memfd_create("fuzz", 0)) { demand(descriptor_ >= 0); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { close(descriptor_); }

  void fill(const std::uint8_t* data, std::size_t size) const {
    demand(ftruncate(descriptor_, 0) == 0);
    demand(pwrite(descriptor_, data, size, 0) == static_cast<ssize_t>(size));
  }
  std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

void read_and_judge_order(const std::string& path) {
  const hsr::PaintingFile file = hsr::read_order(path);
  std::size_t corners = 0;
  for (const hsr::PaintedPolygon& p : file.far_to_near) corners += p.corners.size();
  if (corners > 60) return;  // every pair is compared
  const hsr::Verdict verdict = hsr::verify(file.far_to_near, file.view.value_or(hsr::named_view("iso")));
  demand(verdict.is_correct() || !verdict.first.empty());
}

void read_marks_of_tetrahedron(const std::string& path) {
  hsr::Model model;
  model.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  model.polygons.corners = {0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0};
  model.polygons.first = {0, 3, 6, 9, 12};
  hsr::read_marks(path, model);
}

const std::string_view examples[] = {
    R"(0{"format": "hsr-order/1", "view": {"eye": [0, 0, 1, 0], "target": [1, 0, 0], "up": [0, 1, 0],
"frame": {"origin": [1, 0, 0], "right": [1, 0, 0], "up": [0, 1, 0]}, "near": null}, "coplanar": "last", "pieces": [
{"face": 0, "points": [[0, -2, 0], ["1/3", 2, 0], [0, 0, 0]], "original": [true, false, true]},
{"wire": [0, 1], "points": [[0, 0, 0], [2, 0, "-7/2"]]}]})",
    R"(0{"pieces": [{"points": [[0, 0, 0], [2, 0, 0], [2, 2, 0]]}, {"points": [[0, 0, 1], [2, 0, -1], [2, 2, 0]]}]})",
    R"(1{"format": "hsr-marks/1", "surfaces": [0, 0, 1, 2], "edges": [{"points": [0, 1, 2], "mark": "smooth"},
{"points": [0, 3], "mark": "seam", "circle": {"centre": [0, 0, 0.5], "axis": [0, 1, 0], "radius": 0.5}}]})",
};

}  // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  static const MemoryFile file;
  file.fill(data + 1, size - 1);
  try {
    if (data[0] % 2 == 0)
      read_and_judge_order(file.path());
    else
      read_marks_of_tetrahedron(file.path());
  } catch (const hsr::InputError& e) {
    demand(std::strchr(e.what(), '\n') == nullptr);
  }
  return 0;
}

/// Begins with the examples, now and then anew.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  if (size < 2 || seed % 512 == 0) {
    const std::string_view example = examples[seed / 512 % std::size(examples)];
    if (example.size() <= most) {
      std::copy(example.begin(), example.end(), data);
      return example.size();
    }
  }
  return LLVMFuzzerMutate(data, size, most);
}
