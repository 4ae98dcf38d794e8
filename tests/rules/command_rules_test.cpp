#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

// Rules of docs/conventions.md that the command keeps, and that no other test shows.

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class Directory {
 public:
  Directory() : path_(fs::temp_directory_path() / ("hsr_rules_test_" + std::to_string(getpid()))) {
    fs::create_directories(path_);
  }
  ~Directory() { fs::remove_all(path_); }
  Directory(const Directory&) = delete;
  Directory& operator=(const Directory&) = delete;
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }

 private:
  fs::path path_;
};

/// What the command says to standard error.
std::string said(const std::string& arguments, const std::string& file) {
  (void)std::system((std::string(HSR_COMMAND) + " " + arguments + " > /dev/null 2> " + file).c_str());
  std::ostringstream s;
  s << std::ifstream(file).rdbuf();
  return s.str();
}
/// The status of the command; its output goes nowhere.
int run(const std::string& arguments) {
  const int ended = std::system((std::string(HSR_COMMAND) + " " + arguments + " > /dev/null 2>&1").c_str());
  return WIFEXITED(ended) ? WEXITSTATUS(ended) : -1;
}
std::string write(const std::string& path, const std::string& text) {
  std::ofstream(path) << text;
  return path;
}
std::string contents(const std::string& path) {
  std::ostringstream s;
  s << std::ifstream(path).rdbuf();
  return s.str();
}

const char* const cube =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n"
    "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";

TEST_CASE("up is the up axis, or where the view runs along it what the view from the top has", "[rules][V4]") {
  const Directory d;
  const std::string model = write(d / "cube.obj", cube);
  const auto up = [&](const std::string& view) {
    REQUIRE(run("draw " + model + " -o " + (d / "a.json") + " " + view) == 0);
    return json::parse(contents(d / "a.json"))["view"]["up"];
  };
  const json x_y_z[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  CHECK(up("--direction 1,2,3") == x_y_z[2]);
  CHECK(up("--eye 5,6,7") == x_y_z[2]);
  CHECK(up("--direction 0,0,2") == x_y_z[1]);
  CHECK(up("--eye 0.5,0.5,9") == x_y_z[1]);
  CHECK(up("--direction 1,2,3 --up-axis y") == x_y_z[1]);
  CHECK(up("--direction 0,3,0 --up-axis y") == json({0, 0, -1}));
  CHECK(up("--view top --up-axis y") == json({0, 0, -1}));
}

TEST_CASE("one convex body is drawn by no method", "[rules][M3]") {
  const Directory d;
  const std::string model = write(d / "cube.obj", cube);
  REQUIRE(run("draw " + model + " -o " + (d / "a.svg") + " --report " + (d / "r.json")) == 0);
  CHECK(json::parse(contents(d / "r.json"))["method"] == "none");
}

TEST_CASE("an order with corners that no double holds survives its file", "[rules][J4]") {
  const Directory d;
  // A floor, and a slope that passes through it where x = 1/3.
  const std::string model = write(d / "pierced.obj",
                                  "v -2 -2 0\nv 2 -2 0\nv 2 2 0\nv -2 2 0\nv -1 -1 -4\nv 1 -1 2\nv 1 1 2\nv -1 1 -4\n"
                                  "f 1 2 3 4\nf 5 6 7 8\n");
  const std::string order = d / "order.json";
  REQUIRE(run("order " + model + " --view top -o " + order) == 0);
  const json pieces = json::parse(contents(order))["pieces"];
  CHECK(pieces.size() == 3);
  std::size_t fractions = 0;
  for (const json& piece : pieces)
    for (const json& point : piece["points"])
      for (const json& x : point)
        if (x.is_string()) {
          CHECK(x == "1/3");
          ++fractions;
        }
  CHECK(fractions == 4);  // both ends of the cut, on both sides of it
  CHECK(run("verify " + order) == 0);
}

TEST_CASE("fills lie under the lines, in the file's colours or light grey, darker by the slope of the face", "[rules][D8]") {
  const Directory d;
  const std::string grey = write(d / "cube.obj", cube);
  REQUIRE(run("draw " + grey + " --fill --view iso -o " + (d / "a.svg")) == 0);
  const std::string text = contents(d / "a.svg");
  REQUIRE(text.find("id=\"fills\"") != std::string::npos);
  CHECK(text.find("id=\"fills\"") < text.find("id=\"visible-"));
  std::vector<std::string> colours;
  for (std::size_t at = text.find(" fill=\"#"); at != std::string::npos; at = text.find(" fill=\"#", at + 1)) {
    const std::string colour = text.substr(at + 8, 6);
    CHECK(colour.substr(0, 2) == colour.substr(2, 2));
    CHECK(colour.substr(0, 2) == colour.substr(4, 2));
    if (std::find(colours.begin(), colours.end(), colour) == colours.end()) colours.push_back(colour);
  }
  CHECK(colours.size() == 3);  // three sides of a cube, turned three ways to the light
  const std::string red =
      write(d / "red.ply",
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
            "element face 1\nproperty list uchar int vertex_indices\nproperty uchar red\n"
            "property uchar green\nproperty uchar blue\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 200 10 30\n");
  REQUIRE(run("draw " + red + " --fill --shade none --view top -o " + (d / "b.svg")) == 0);
  CHECK(contents(d / "b.svg").find("fill=\"#c80a1e\"") != std::string::npos);
  // The light comes from the upper left of the viewer: which this face is turned to by 36 degrees: it has 0.9 of its colour.
  REQUIRE(run("draw " + red + " --fill --view top -o " + (d / "b.svg")) == 0);
  CHECK(contents(d / "b.svg").find("fill=\"#b3091b\"") != std::string::npos);
  REQUIRE(run("draw " + grey + " --fill --shade none --view iso -o " + (d / "a.svg")) == 0);
  CHECK(contents(d / "a.svg").find("fill=\"#c8c8c8\"") != std::string::npos);
}

/// A grey board, and on it red and blue copper in the same plane, which cross.
const char* const board =
    "ply\nformat ascii 1.0\nelement vertex 12\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 3\nproperty list uchar int vertex_indices\nproperty uchar red\nproperty uchar green\n"
    "property uchar blue\nend_header\n0 0 0\n9 0 0\n9 9 0\n0 9 0\n1 4 0\n8 4 0\n8 5 0\n1 5 0\n4 1 0\n5 1 0\n5 8 0\n4 8 0\n"
    "4 0 1 2 3 99 99 99\n4 4 5 6 7 200 0 0\n4 8 9 10 11 0 0 200\n";

TEST_CASE("the first or the last of coincident faces is filled, as --coplanar says", "[rules][S3][S8]") {
  const Directory d;
  const std::string model = write(d / "board.ply", board), file = d / "a.json";
  const auto faces = [&](const std::string& options) {
    REQUIRE(run("draw " + model + " --view top --fill --check -o " + file + options) == 0);
    std::vector<int> shown;
    const json drawing = json::parse(contents(file));
    for (const json& fragment : drawing["fragments"]) shown.push_back(fragment["face"]);
    return shown;
  };
  CHECK(faces("") == std::vector{0});
  CHECK(faces(" --coplanar first") == std::vector{0});
  CHECK(faces(" --coplanar last") == std::vector{0, 1, 1, 2});  // the board around the cross, the red in two
  CHECK(faces(" --coplanar last --method roberts") == std::vector{0, 1, 1, 2});
  CHECK(run("draw " + model + " --fill -o " + file + " --coplanar upper") == 2);
}

TEST_CASE("a note counts faces under coincident ones of another colour unless told which is on top", "[rules][S9]") {
  const Directory d;
  const std::string model = write(d / "board.ply", board);
  const auto notes = [&](const std::string& arguments) {
    return said(arguments + " -o " + (d / "a.json"), d / "said").find("2 faces lie under faces of another colour") !=
           std::string::npos;
  };
  CHECK(notes("draw --fill " + model));
  CHECK(notes("order " + model));
  CHECK_FALSE(notes("draw " + model));
  CHECK_FALSE(notes("draw --fill --coplanar first " + model));
  CHECK_FALSE(notes("order --coplanar last " + model));
  CHECK_FALSE(notes("draw --fill --view front " + model));  // edge-on
  // One colour for all: nothing to tell.
  std::string grey = board;
  for (const char* colour : {"200 0 0\n", "0 0 200\n"}) grey.replace(grey.find(colour), 8, "99 99 99\n");
  CHECK_FALSE(notes("draw --fill " + write(d / "grey.ply", grey)));
}

TEST_CASE("an order of the last face says so, and is verified so", "[rules][P2][P18][P19]") {
  const Directory d;
  const std::string model = write(d / "board.ply", board), file = d / "a.json";
  for (const std::string method : {"depth-sort", "bsp", "z-sort", "naive"}) {
    const std::string order = "order " + model + " --view top --check -o " + file + " --method " + method;
    REQUIRE(run(order) == 0);
    CHECK_FALSE(json::parse(contents(file)).contains("coplanar"));
    CHECK(json::parse(contents(file))["pieces"][0]["face"] == 2);
    CHECK(run("verify " + file) == 0);
    CHECK(run("verify --coplanar last " + file) == 1);
    REQUIRE(run(order + " --coplanar last") == 0);
    CHECK(json::parse(contents(file))["coplanar"] == "last");
    CHECK(json::parse(contents(file))["pieces"][0]["face"] == 0);
    CHECK(run("verify " + file) == 0);
    CHECK(run("verify --coplanar first " + file) == 1);
  }
  // Painted in the file's order the last is on top.
  CHECK(run("verify --view top " + model) == 1);
  CHECK(run("verify --view top --coplanar last " + model) == 0);
  std::string text = contents(file);
  text.replace(text.find("\"last\""), 6, "\"none\"");
  CHECK(run("verify " + write(d / "none.json", text)) == 2);
}

}  // namespace
