#include <catch2/catch.hpp>
#include <filesystem>
#include <functional>

#include "hsr/io/read/formats.h"
#include "tests/io/read/refused.h"
#include "tests/io/read/small_files.h"
#include "tests/io/read/temporary_directory.h"

using namespace hsr;
using namespace hsr::test;

namespace {

using internal::read::BlockFile;
using internal::read::Source;

/// A number of some bytes, as the files of small_files.h have them.
using Number = std::function<std::string(std::uint64_t, int)>;

/// A strip of `n` squares that is several blocks long, with a colour for each corner, and quads among the triangles.
std::string strip_ply(int n, const std::string& format, const Number& number, const std::function<std::string(float)>& real) {
  std::string ply = "ply\nformat " + format + " 1.0\nelement vertex " + std::to_string(2 * (n + 1)) +
                    "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nproperty uchar green\n"
                    "property uchar blue\nelement camera 3\nproperty double a\nproperty char b\nelement face " +
                    std::to_string(2 * n) + "\nproperty list uchar int vertex_indices\nproperty short flag\nend_header\n";
  for (int v = 0; v < 2 * (n + 1); ++v)
    ply += real(static_cast<float>(v / 2)) + real(static_cast<float>(v % 2)) + real(0.1F * static_cast<float>(v % 7)) +
           number(static_cast<std::uint64_t>(v % 251), 1) + number(7, 1) + number(9, 1);
  ply += std::string(27, 'c');
  for (int k = 0; k < n; ++k) {
    const auto corner = [&](int v) { return number(static_cast<std::uint64_t>(2 * k + v), 4); };
    const std::string flag = number(0, 2);
    ply += number(3, 1) + corner(0) + corner(2) + corner(3) + flag;
    ply += k % 5 == 0 ? number(4, 1) + corner(0) + corner(2) + corner(3) + corner(1) + flag
                      : number(3, 1) + corner(0) + corner(3) + corner(1) + flag;
  }
  return ply;
}

/// Triangles apart, each with the attribute that is its number.
std::string triangles_stl(int n) {
  std::vector<float> c;
  for (int t = 0; t < n; ++t)
    for (int k = 0; k < 9; ++k) c.push_back(static_cast<float>((t + k * k) % 1009));
  std::string stl = binary_stl(c);
  for (int t = 0; t < n; ++t)
    stl.replace(84 + 50 * static_cast<std::size_t>(t) + 48, 2, little(0x8000U + static_cast<std::uint64_t>(t) % 32768U, 2));
  return stl;
}

void check_same(const Model& a, const Model& b) {
  CHECK(a.format == b.format);
  CHECK((a.points == b.points));
  CHECK((a.polygons.first == b.polygons.first));
  CHECK((a.polygons.corners == b.polygons.corners));
  CHECK((a.palette == b.palette));
  CHECK((a.face_colour == b.face_colour));
  CHECK(a.notes == b.notes);
}

}  // namespace

TEST_CASE("A long binary file is read in blocks, and says what it says in one piece", "[read][blocks]") {
  const TemporaryDirectory directory;
  const auto check = [&](const std::string& name, const std::string& bytes) {
    INFO(name);
    REQUIRE(bytes.size() > (std::size_t{3} << 20));  // some blocks
    const std::string path = directory.write(name, bytes);
    check_same(read_model(path), read_model(path, bytes));
    for (const std::size_t size : {std::size_t{70000}, std::size_t{1} << 20, (std::size_t{1} << 20) + 1, bytes.size() - 1}) {
      directory.write(name, bytes.substr(0, size));
      CHECK(file_refusal(path) == refusal(path, bytes.substr(0, size)));
      CHECK_FALSE(file_refusal(path).empty());
    }
    directory.write(name, bytes + "more");
    check_same(read_model(path), read_model(path, bytes + "more"));
  };
  check("little.ply", strip_ply(60000, "binary_little_endian", little, little_float));
  check("big.ply", strip_ply(60000, "binary_big_endian", big, big_float));
  check("triangles.stl", triangles_stl(70000));
}

TEST_CASE("A bad number far behind in a long file is told as in a short one", "[read][blocks]") {
  const TemporaryDirectory directory;
  std::string stl = triangles_stl(70000);
  stl.replace(84 + 50 * 60000 + 12, 4, little(0x7fc00000U, 4));
  CHECK_THAT(file_refusal(directory.write("a.stl", stl)), Catch::Contains("face 60000: found NaN"));
  std::string ply = strip_ply(60000, "binary_little_endian", little, little_float);
  ply.replace(ply.size() - 6, 4, little(0xffffff0U, 4));
  CHECK_THAT(file_refusal(directory.write("a.ply", ply)), Catch::Contains("face 119999: found index 268435440"));
}

TEST_CASE("A file that becomes shorter while it is read is refused", "[read][blocks]") {
  const TemporaryDirectory directory;
  const std::string stl = triangles_stl(70000), path = directory.write("a.stl", stl);
  const auto file = BlockFile::open(path);
  REQUIRE(file);
  std::filesystem::resize_file(path, 2000000);
  const std::string head = stl.substr(0, 65536);
  CHECK_THROWS_WITH(read_stl(Source{path, head, &*file}),
                    Catch::Contains("found the end of the file, expected 3500084 bytes, as many as it had before"));
}

TEST_CASE("A text that counts like a binary file, or hides the end of its header, is read as before", "[read][blocks]") {
  const TemporaryDirectory directory;
  const std::string ply = "ply\nformat binary_little_endian 1.0\ncomment " + std::string(100000, '-') + "\n" +
                          strip_ply(200, "binary_little_endian", little, little_float).substr(36);
  const std::string path = directory.write("long_header.ply", ply);
  check_same(read_model(path), read_model(path, ply));
}
