#include "hsr/io/write/output_file.h"

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "geometry/error.h"

using namespace hsr;
using namespace hsr::internal;
namespace fs = std::filesystem;

namespace {

/// A directory that goes with the test.
struct Directory {
  fs::path path;
  Directory() {
    std::string name = (fs::temp_directory_path() / "hsr-output-XXXXXX").string();
    REQUIRE(::mkdtemp(name.data()) != nullptr);
    path = name;
  }
  ~Directory() { fs::remove_all(path); }
  std::size_t entries() const { return static_cast<std::size_t>(std::distance(fs::directory_iterator(path), {})); }
};

std::string content(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

}  // namespace

TEST_CASE("A file appears when it is committed, and nothing else stays", "[write][file]") {
  const Directory d;
  {
    OutputFile file(d.path / "a.svg");
    file.write("one ");
    file.write("two");
    CHECK_FALSE(fs::exists(d.path / "a.svg"));
    file.commit();
  }
  CHECK(content(d.path / "a.svg") == "one two");
  CHECK(d.entries() == 1);
}

TEST_CASE("Without a commit no file appears and an old one stays as it was", "[write][file]") {
  const Directory d;
  {
    OutputFile file(d.path / "a.svg");
    file.write("half");
  }
  CHECK(d.entries() == 0);
  write_file(d.path / "a.svg", "old");
  {
    OutputFile file(d.path / "a.svg");
    file.write("half");
  }
  CHECK(content(d.path / "a.svg") == "old");
  CHECK(d.entries() == 1);
}

TEST_CASE("A file that is replaced keeps its permissions, and a link leads on to it", "[write][file]") {
  const Directory d;
  write_file(d.path / "a.svg", "old");
  REQUIRE(::chmod((d.path / "a.svg").c_str(), 0640) == 0);
  fs::create_symlink(d.path / "a.svg", d.path / "link.svg");
  write_file(d.path / "link.svg", "new");
  CHECK(fs::is_symlink(d.path / "link.svg"));
  CHECK(content(d.path / "a.svg") == "new");
  CHECK((fs::status(d.path / "a.svg").permissions() & fs::perms::all) == static_cast<fs::perms>(0640));
}

TEST_CASE("Two files of one process are written at the same time", "[write][file]") {
  const Directory d;
  OutputFile a(d.path / "a.svg"), b(d.path / "b.svg");
  a.write("a");
  b.write("b");
  a.commit();
  b.commit();
  CHECK(content(d.path / "a.svg") == "a");
  CHECK(content(d.path / "b.svg") == "b");
  CHECK(d.entries() == 2);
}

TEST_CASE("What cannot be written is said in one line that names the file", "[write][file]") {
  const Directory d;
  CHECK_THROWS_WITH(OutputFile(d.path / "no" / "a.svg"), Catch::Contains("a.svg: cannot be written: No such file"));
  CHECK_THROWS_WITH(OutputFile(d.path), Catch::Contains("directory"));
  CHECK_THROWS_AS(OutputFile(""), InputError);
  CHECK_THROWS_WITH(write_file("/dev/full", "x"), Catch::Contains("/dev/full: cannot be written: No space"));
}

TEST_CASE("A disk that fills up leaves nothing behind", "[write][file]") {
  const Directory d;
  rlimit old = {};
  REQUIRE(::getrlimit(RLIMIT_FSIZE, &old) == 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit small = old;
  small.rlim_cur = 4096;
  REQUIRE(::setrlimit(RLIMIT_FSIZE, &small) == 0);
  bool refused = false;
  try {
    write_file(d.path / "a.svg", std::string(10000, 'x'));
  } catch (const InputError&) {
    refused = true;
  }
  ::setrlimit(RLIMIT_FSIZE, &old);
  std::signal(SIGXFSZ, handler);
  CHECK(refused);
  CHECK(d.entries() == 0);
}

TEST_CASE("A signal handler can remove what is not complete, and only that", "[write][file]") {
  const Directory d;
  static UnfinishedFiles unfinished;
  write_file(d.path / "done.svg", "done", &unfinished);
  OutputFile file(d.path / "a.svg", &unfinished);
  file.write("half");
  CHECK(d.entries() == 2);
  unfinished.remove_all();
  CHECK(d.entries() == 1);
  CHECK(content(d.path / "done.svg") == "done");
}

TEST_CASE("A device is written in place", "[write][file]") {
  CHECK_NOTHROW(write_file("/dev/null", "anything"));
  CHECK(fs::is_character_file("/dev/null"));
}
