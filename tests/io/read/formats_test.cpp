#include "tests/io/read/refused.h"
#include "tests/io/read/small_files.h"

using namespace hsr;
using namespace hsr::test;

namespace {

using Corners = std::vector<std::uint32_t>;

/// An ending that tells nothing, for what the content alone must tell.
std::string without_ending(const std::string& name) { return name.find(".obj") == std::string::npos ? "square" : name; }

}  // namespace

TEST_CASE("The same square comes out of every format, told by the content alone", "[read]") {
  for (const SmallFile& file : small_files()) {
    INFO(file.name);
    const Model m = read_model(without_ending(file.name), file.bytes);
    REQUIRE(m.points.size() == 4);
    REQUIRE(m.polygons.size() == 2);
    CHECK(corners(m, 0) == Corners{0, 1, 2});
    CHECK(corners(m, 1) == Corners{0, 2, 3});
    const bool moved = m.format.starts_with("GL") || m.format.starts_with("gl");
    const Point3 first = moved ? Point3{1, 2, 3} : Point3{0, 0, 0};
    CHECK(m.points[0] == first);
    CHECK(m.points[2] == Point3{first.x + 1, first.y + 1, first.z});
    CHECK(m.points[3] == Point3{first.x, first.y + 1, first.z});
    CHECK(m.format.ends_with(", gzip") == file.name.ends_with(".gz"));
  }
}

TEST_CASE("Every file that is cut short anywhere is read or refused in one line", "[read][damaged]") {
  for (const SmallFile& file : small_files()) {
    for (std::size_t n = 0; n < file.bytes.size(); ++n) {
      const std::string message = refusal(file.name, file.bytes.substr(0, n));
      INFO(file.name << " cut to " << n << ": " << message);
      REQUIRE(message.find('\n') == std::string::npos);
      if (!message.empty()) REQUIRE(message.starts_with(file.name + ": "));
    }
  }
}

TEST_CASE("Every file with one byte changed is read or refused in one line", "[read][damaged]") {
  for (const SmallFile& file : small_files()) {
    for (std::size_t i = 0; i < file.bytes.size(); ++i) {
      for (const int change : {1, 0x10, 0x80, 0xff}) {
        std::string bytes = file.bytes;
        bytes[i] = static_cast<char>(bytes[i] ^ change);
        const std::string message = refusal(file.name, bytes);
        INFO(file.name << " byte " << i << ": " << message);
        REQUIRE(message.find('\n') == std::string::npos);
      }
    }
  }
}

TEST_CASE("A format that is not known is refused with those that are", "[read]") {
  CHECK(refusal("part.step", "ISO-10303-21;") ==
        "part.step: STEP is not supported: export STL or OBJ from the CAD program, or build hsr with Open CASCADE (HSR_STEP)");
  CHECK(refusal("part.FBX", "Kaydara") == "part.FBX: FBX is not supported: export OBJ or glTF");
  CHECK(refusal("a.xyz", "1 2 3") ==
        "a.xyz: found the ending \".xyz\", expected OBJ, OFF, PLY, STL, glTF or GLB, also gzipped");
  CHECK(refusal("dir.d/model", "1 2 3") ==
        "dir.d/model: found no ending that tells the format, expected OBJ, OFF, PLY, STL, glTF or GLB, also gzipped");
  CHECK(refusal("a.obj", "") == "a.obj: found an empty file, expected a model");
  CHECK(refusal("a.obj.gz", gzipped("")) == "a.obj.gz: found an empty file, expected a model");
  CHECK(refusal("two\nlines.xyz", "1").starts_with("two?lines.xyz: "));
}

TEST_CASE("A point cloud is refused", "[read]") {
  CHECK(refusal("a.obj", "v 1 2 3\n") == "a.obj: has points but no faces or lines: nothing to draw");
  CHECK(refusal("a.obj", "# nothing\n") == "a.obj: found no points, faces or lines, expected a model");
}

TEST_CASE("Damaged gzip data is refused, and so is what inflates without end", "[read][gzip]") {
  const std::string whole = gzipped(small_files()[0].bytes);
  CHECK(refusal("a.obj.gz", whole.substr(0, whole.size() / 2)).find("found the end of the file inside the gzip data") !=
        std::string::npos);
  std::string damaged = whole;
  damaged[damaged.size() - 6] = static_cast<char>(damaged[damaged.size() - 6] ^ 1);
  CHECK(refusal("a.obj.gz", damaged).find("incorrect data check") != std::string::npos);
  CHECK(refusal("a.obj.gz", whole + "more").find("something else behind the end") != std::string::npos);
  CHECK(read_model("a.obj.gz", whole + std::string(512, '\0')).points.size() == 4);
  CHECK(read_model("a.obj.gz", gzipped("v 0 0 0\nv 1 0 0\n") + gzipped("v 0 1 0\nf 1 2 3\n")).points.size() == 3);
}
