#include <sys/inotify.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include "geometry/error.h"
#include "hsr/io/read/gzip.h"
#include "tests/io/read/refused.h"
#include "tests/io/read/small_files.h"
#include "tests/io/read/temporary_directory.h"

using namespace hsr;
using namespace hsr::internal;
using namespace hsr::test;

namespace {

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 1 1 0\n";

}  // namespace

TEST_CASE("Files on disk read like bytes in memory", "[read][file]") {
  const TemporaryDirectory directory;
  for (const SmallFile& file : small_files()) {
    INFO(file.name);
    const Model m = read_model(directory.write(file.name, file.bytes));
    CHECK(m.points == read_model(file.name, file.bytes).points);
    CHECK(m.name == directory.file(file.name));
  }
}

TEST_CASE("A byte order mark before a text is passed over", "[read][file]") {
  for (const SmallFile& file : small_files()) {
    const std::string marked = "\xef\xbb\xbf" + file.bytes;
    if (read::is_gzip(file.bytes) || file.bytes.find('\0') != std::string::npos) continue;
    INFO(file.name);
    const Model model = read_model(file.name, file.bytes), same = read_model(file.name, marked);
    CHECK(same.points == model.points);
    CHECK(same.polygons.corners == model.polygons.corners);
    CHECK(same.notes == model.notes);
  }
}

TEST_CASE("A named pipe is opened once: who writes to it would not find a reader that has closed it again", "[read][file]") {
  const TemporaryDirectory directory;
  for (const SmallFile& file : small_files()) {
    INFO(file.name);
    const std::string pipe = directory.file(std::to_string(file.bytes.size()) + file.name);
    REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
    const int watch = ::inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
    REQUIRE(::inotify_add_watch(watch, pipe.c_str(), IN_OPEN | IN_CLOSE_NOWRITE) >= 0);
    std::thread writer([&] { std::ofstream(pipe, std::ios::binary) << file.bytes; });
    const std::string refused = file_refusal(pipe);
    writer.join();
    CHECK(refused.empty());
    std::size_t closed = 0;  // by a reader; the kernel says what happens twice in a row once, but it is opened in between
    std::array<inotify_event, 64> events;  // no names follow: it is no directory
    for (ssize_t n = 0; (n = ::read(watch, events.data(), sizeof events)) > 0;)
      for (std::size_t k = 0; k < static_cast<std::size_t>(n) / sizeof(inotify_event); ++k)
        closed += (events[k].mask & IN_CLOSE_NOWRITE) != 0 ? 1U : 0U;
    ::close(watch);
    CHECK(closed == 1);
  }
}

TEST_CASE("What is no file is refused", "[read][file]") {
  const TemporaryDirectory directory;
  const std::string missing = directory.file("missing.obj");
  CHECK(file_refusal(missing) == missing + ": cannot be opened: No such file or directory");
  CHECK(file_refusal(directory.file("")) == directory.file("") + ": found a directory, expected a model file");
  CHECK(file_refusal("/dev/null") == "/dev/null: found a device or socket, expected a model file");
  const std::string empty = directory.write("empty.stl", "");
  CHECK(file_refusal(empty) == empty + ": found an empty file, expected a model");
  const std::string locked = directory.write("locked.obj", triangle);
  ::chmod(locked.c_str(), 0);
  // Some users may read everything.
  if (const std::string message = file_refusal(locked); message.find("no faces") == std::string::npos)
    CHECK(message == locked + ": cannot be opened: Permission denied");
}

TEST_CASE("Colours come from the material library beside the OBJ file", "[read][obj][file]") {
  const TemporaryDirectory directory;
  directory.write("my colours.mtl",
                  "newmtl red one\nKd 1 0 0\nd 0.5\nnewmtl grey\nKd 0.5\nnewmtl glass\nKd 0 0 1\nTr 0.8\nnewmtl plain\n");
  const std::string faces =
      "usemtl red one\nf 1 2 3\nusemtl grey\nf 1 2 3\nusemtl glass\nf 1 2 3\nusemtl plain\nf 1 2 3\nusemtl red one\nf 1 2 3\n";
  const Model m = read_model(directory.write("a.obj", "mtllib my colours.mtl\n" + triangle + faces));
  CHECK(m.palette == std::vector<Colour>{{255, 0, 0, 128}, {128, 128, 128, 255}, {0, 0, 255, 51}});
  CHECK(m.face_colour == std::vector<std::uint32_t>{0, 1, 2, 0xffffffffU, 0});
  CHECK(m.notes.empty());

  directory.write("one.mtl", "newmtl red one\nKd 1 0 0\n");
  const Model two = read_model(directory.write("b.obj", "mtllib one.mtl two.mtl\n" + triangle + faces));
  CHECK(two.palette.size() == 1);
  CHECK(two.notes == std::vector<std::string>{"material library \"two.mtl\" is missing: its colours are left out"});

  const Model none = read_model(directory.write("c.obj", "mtllib ../not there.mtl\n" + triangle + faces));
  CHECK(none.palette.empty());
  CHECK(none.face_colour.empty());
  CHECK(none.notes == std::vector<std::string>{"material library \"../not there.mtl\" is missing: its colours are left out"});

  directory.write("bad.mtl", "newmtl grey\nKd 0.5\nd much\n");
  const Model bad = read_model(directory.write("d.obj", "mtllib bad.mtl\n" + triangle + faces));
  REQUIRE(bad.notes.size() == 1);
  CHECK(bad.notes[0] ==
        directory.file("bad.mtl") + ": line 3: found \"much\", expected an opacity; the colours behind it are passed over");
}

TEST_CASE("A glTF file finds its buffer beside it", "[read][gltf][file]") {
  const TemporaryDirectory directory;
  std::string buffer;
  for (const float x : {0, 0, 0, 1, 0, 0, 0, 1, 0}) buffer += little_float(x);
  const std::string json = R"({"asset": {"version": "2.0"}, "nodes": [{"mesh": 0}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
"bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"byteLength": 36, "uri": "the%20points.bin"}]})";
  const std::string path = directory.write("a.gltf", json);
  const std::string message = file_refusal(path);
  CHECK(message.find("the points.bin") != std::string::npos);
  CHECK(message.find('\n') == std::string::npos);
  directory.write("the points.bin", buffer);
  const Model m = read_model(path);
  CHECK(m.points[2] == Point3{0, 1, 0});
  CHECK(m.polygons.size() == 1);
}

TEST_CASE("A gzip bomb is refused at the limit", "[read][gzip]") {
  const std::string bomb = gzipped(std::string(std::size_t{20} << 20, ' '));
  REQUIRE(bomb.size() < 40000);
  const read::Source source{"bomb.obj.gz", bomb};
  CHECK(read::gunzip(source).size == std::size_t{20} << 20);
  // By what it says of itself, before anything is inflated.
  CHECK_THROWS_WITH(read::gunzip(source, std::size_t{1} << 20),
                    Catch::Contains("byte 0") && Catch::Contains("inflates to more than 1048576 bytes"));
  // By what comes out: two members, of which the last says little.
  const std::string two = bomb + gzipped("v 0 0 0\n");
  CHECK_THROWS_WITH(read::gunzip({"two.obj.gz", two}, std::size_t{1} << 20),
                    Catch::Contains("inflates to more than 1048576 bytes"));
}

TEST_CASE("Every public model is read, or refused in one line", "[read][models]") {
  const char* const named = std::getenv("HSR_MODELS");
  const std::filesystem::path models = named ? named : HSR_SOURCE_DIR "/../shared/models";
  if (!std::filesystem::is_directory(models)) return;
  std::size_t refused = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(models)) {
    const std::string ending = entry.path().extension().string();
    if (!entry.is_regular_file() || ending == ".md" || ending == ".txt" || ending == ".bin" || ending.empty()) continue;
    INFO(entry.path());
    const std::string message = file_refusal(entry.path().string());
    INFO(message);
    CHECK(message.find('\n') == std::string::npos);
    CHECK(message.empty() == (entry.path().parent_path().filename() != "bad"));
    refused += message.empty() ? 0 : 1;
  }
  CHECK(refused >= 5);
}
