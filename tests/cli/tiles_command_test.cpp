// hsr split, tile and join: the bytes of hsr draw, and what becomes of parts that are missing, broken or not their own.
#include <unistd.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "tests/cli/run_command.h"

using namespace hsr::cli_tests;

namespace fs = std::filesystem;

namespace {

/// Boxes on a ground, some turned, some touching, in two objects; with a wire.
std::string town(int side) {
  std::mt19937 random(7);
  const auto number = [&](double low, double high) { return low + (high - low) * static_cast<double>(random() % 1024) / 1024; };
  std::string points, faces = "o ground\nf 1 2 3 4\no houses\nusemtl brick\n", all;
  std::size_t count = 4;
  points = "v -2 -2 0\nv " + std::to_string(10 * side) + " -2 0\nv " + std::to_string(10 * side) + " " +
           std::to_string(10 * side) + " 0\nv -2 " + std::to_string(10 * side) + " 0\n";
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      const double x = 10.0 * i + number(0, 3), y = 10.0 * j + number(0, 3), w = number(3, 9), d = number(3, 9),
                   h = number(1, 20);
      const double turn = random() % 3 == 0 ? 0.5 : 0;
      for (const double z : {0.0, h})
        for (const auto& [u, v] : {std::pair{0.0, 0.0}, {w, 0.0}, {w, d}, {0.0, d}})
          points += "v " + std::to_string(x + std::cos(turn) * u - std::sin(turn) * v) + " " +
                    std::to_string(y + std::sin(turn) * u + std::cos(turn) * v) + " " + std::to_string(z) + "\n";
      if (random() % 5 == 0) faces += "usemtl glass\n";
      for (const auto& q : {std::array{1, 4, 3, 2}, {5, 6, 7, 8}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 4, 8, 7}, {4, 1, 5, 8}}) {
        faces += "f";
        for (const int k : q) faces += " " + std::to_string(count + static_cast<std::size_t>(k));
        faces += "\n";
      }
      count += 8;
    }
  return points + faces + "l 1 3\n";
}

/// "1 2 3"
std::string numbers(int n) {
  std::string all;
  for (int k = 1; k <= n; ++k) all += " " + std::to_string(k);
  return all;
}

void make_job(const std::string& job, const std::string& model, int tiles, const std::string& options = "") {
  const Outcome split = run("split " + model + " -q -o " + job + " --tiles " + std::to_string(tiles) + " " + options);
  INFO(split.text);
  REQUIRE(split.status == 0);
}

void make_parts(const std::string& job, int tiles) {
  const Outcome made = run("tile " + job + " -q" + numbers(tiles));
  INFO(made.text);
  REQUIRE(made.status == 0);
}

const std::vector<std::string> formats = {"svg", "pdf", "eps", "dxf", "tex", "hpgl", "png", "json"};

std::string outputs(const std::string& stem, bool with_json) {
  std::string all;
  for (const std::string& f : formats)
    if (f != "json" || with_json) all += " -o " + stem + "." + f;
  return all;
}

/// Status 1, and one line with these words.
void check_fails(const Outcome& outcome, const std::vector<std::string>& words) {
  INFO(outcome.text);
  CHECK(outcome.status == 1);
  CHECK(count(outcome.text, "\n") == 1);
  for (const std::string& word : words) CHECK(outcome.text.find(word) != std::string::npos);
}

/// What draw writes with options of the scene and of the page, and what comes of tiles: split has the first, join the others.
struct ByteCase {
  int tiles;
  std::string of_scene, of_page;
  bool with_json;
};

void check_same_bytes(const Directory& d, const std::string& model, const ByteCase& c) {
  INFO(c.of_scene << " | " << c.of_page << ", " << c.tiles << " tiles");
  const bool has_unit = c.of_scene.find("--unit") != std::string::npos;
  const Outcome drawn = run("draw " + model + " -q" + outputs(d / "one", c.with_json) + " " +
                            (has_unit ? c.of_scene.substr(0, c.of_scene.find("--unit")) : c.of_scene) + " " + c.of_page);
  INFO(drawn.text);
  REQUIRE(drawn.status == 0);
  make_job(d / "job", model, c.tiles, c.of_scene + (c.with_json ? " --json" : ""));
  make_parts(d / "job", c.tiles);
  const Outcome joined = run("join " + (d / "job") + " -q" + outputs(d / "many", c.with_json) + " " + c.of_page);
  INFO(joined.text);
  REQUIRE(joined.status == 0);
  for (const std::string& f : formats)
    if (f != "json" || c.with_json) CHECK(contents(d / "one." + f) == contents(d / "many." + f));
}

}  // namespace

TEST_CASE("a scene that was split is drawn byte for byte as in one piece, in every format", "[cli][tiles]") {
  const Directory d;
  const std::string model = write(d / "town.obj", town(5));
  for (const ByteCase& c :
       {ByteCase{1, "", "", false}, ByteCase{5, "", "--page A3 --scale 1:200 --pen visible=0.35", false},
        ByteCase{7, "--hidden dashed", "", true}, ByteCase{4, "--view top --edges all", "--sort pen", true},
        ByteCase{9, "--eye -30,-40,60 --target 20,20,0", "--fit-arcs 0.1", false},
        ByteCase{6, "--eye 20,20,9 --fov 80 --hidden solid", "--margin 5", true},
        ByteCase{3, "--view front --coplanar last --ghost ground", "--min-length 2", false},
        ByteCase{8, "--direction 1,2,3 --method roberts --only houses --unit m", "--scale 1:500 --unit m", true}})
    check_same_bytes(d, model, c);
}

TEST_CASE("a scene that was split is filled byte for byte as in one piece, in every format", "[cli][tiles][fills]") {
  const Directory d;
  const std::string model = write(d / "town.obj", town(5));
  for (const ByteCase& c :
       {ByteCase{1, "--fill", "", false}, ByteCase{2, "--fill", "--merge coplanar", false},
        ByteCase{3, "--fill --hidden dashed", "--merge colour", true}, ByteCase{7, "--fill", "--shade none --page A3", true},
        ByteCase{4, "--fill --view top --edges all", "--shade none --merge colour", false},
        ByteCase{7, "--fill --eye -30,-40,60 --target 20,20,0", "", true},
        ByteCase{9, "--fill --eye 20,20,9 --fov 80 --hidden solid", "--merge coplanar --margin 5", true},
        ByteCase{6, "--fill --eye 20,20,9 --fov 70", "--merge colour", false},
        ByteCase{3, "--fill --view front --coplanar last --ghost ground", "--min-length 2", false},
        ByteCase{8, "--fill --direction 1,2,3 --method roberts --only houses", "--merge coplanar", true}})
    check_same_bytes(d, model, c);
}

TEST_CASE("GNU parallel does the tiles by the line in docs/tiles.md", "[cli][tiles]") {
  const Directory d;
  const std::string model = write(d / "town.obj", town(4)), job = d / "job";
  make_job(job, model, 16, "--hidden dashed");
  write(d / "hosts", ":\n");  // this machine
  const std::string page = contents(HSR_SOURCE_DIR "/docs/tiles.md");
  const std::size_t from = page.find("parallel --retries"), to = page.find('\n', from);
  REQUIRE(to != std::string::npos);
  const std::string before = "cd " + (d / "") + " && export HOME=$PWD PATH=" + fs::path(HSR_COMMAND).parent_path().string() +
                             ":$PATH && " + page.substr(from, to - from) + " > said 2>&1 < /dev/null; ";
  const Outcome joined = run("join " + job + " -q -o " + (d / "many.svg"), before);
  INFO(contents(d / "said") << joined.text);
  REQUIRE(joined.status == 0);
  REQUIRE(run("draw " + model + " -q --hidden dashed -o " + (d / "one.svg")).status == 0);
  CHECK(contents(d / "one.svg") == contents(d / "many.svg"));
}

TEST_CASE("small models in tiles have the bytes that they have in one piece", "[cli][tiles][models]") {
  const char* const named = std::getenv("HSR_MODELS");
  const fs::path models = named ? named : HSR_SOURCE_DIR "/../shared/models";
  if (!fs::is_directory(models)) return;
  const Directory d;
  std::size_t compared = 0;
  for (const auto& entry : fs::recursive_directory_iterator(models)) {
    const std::string path = entry.path().string();
    if (!entry.is_regular_file() || entry.file_size() > 60000) continue;
    const std::string view = std::array{"", "--view front --hidden dashed", "--fill", "--fill --view front"}[compared % 4];
    const Outcome split = run("split '" + path + "' -q -o " + (d / "job") + " --tiles 3 " + view);
    if (split.status == 2) continue;  // no model, a broken one, or one with surfaces
    INFO(path << "\n" << split.text);
    CHECK(split.status == 0);
    make_parts(d / "job", 3);
    CHECK(run("join " + (d / "job") + " -q -o " + (d / "many.svg")).status == 0);
    CHECK(run("draw '" + path + "' -q -o " + (d / "one.svg") + " " + view).status == 0);
    CHECK(contents(d / "one.svg") == contents(d / "many.svg"));
    ++compared;
  }
  CHECK(compared > 0);
}

TEST_CASE("a tile that is done is left as it is, and a job that is split again begins anew", "[cli][tiles]") {
  const Directory d;
  const std::string model = write(d / "town.obj", town(3)), job = d / "job";
  make_job(job, model, 3);
  make_parts(job, 3);
  const auto time = fs::last_write_time(job + "/part-2");
  const Outcome again = run("tile " + job + " 2");
  CHECK(again.text.find("part-2: done before") != std::string::npos);
  CHECK(fs::last_write_time(job + "/part-2") == time);
  make_job(job, model, 2, "--view top");
  CHECK(!fs::exists(job + "/part-1"));
  CHECK(!fs::exists(job + "/tile-3"));
}

TEST_CASE("join says which part is missing, not whole, of another tile or of another job", "[cli][tiles][fault]") {
  const Directory d;
  const std::string model = write(d / "town.obj", town(3)), job = d / "job", part = job + "/part-2",
                    join = "join " + job + " -o " + (d / "x.svg");
  make_job(job, model, 3);
  make_parts(job, 3);
  REQUIRE(run(join).status == 0);
  const std::string whole = contents(part), drawing = contents(d / "x.svg");
  fs::remove(d / "x.svg");
  fs::remove(part);
  check_fails(run(join), {"part-2: missing", "tile 2"});
  for (const std::size_t kept : {std::size_t{0}, std::size_t{5}, whole.size() / 2, whole.size() - 1}) {
    write(part, whole.substr(0, kept));
    check_fails(run(join), {"part-2: not whole"});
  }
  std::string changed = whole;
  changed[changed.size() / 2] = static_cast<char>(changed[changed.size() / 2] ^ 1);
  write(part, changed);
  check_fails(run(join), {"part-2: not whole"});
  fs::copy_file(job + "/part-3", part, fs::copy_options::overwrite_existing);
  check_fails(run(join), {"part-2: of tile 3"});
  make_job(d / "other", model, 3, "--view top");
  make_parts(d / "other", 3);
  fs::copy_file(d / "other/part-2", part, fs::copy_options::overwrite_existing);
  check_fails(run(join), {"part-2: of another job"});
  CHECK(!fs::exists(d / "x.svg"));
  // What is wrong is done again, and nothing else.
  REQUIRE(run("tile " + job + " -q 1 2 3").status == 0);
  CHECK(contents(part) == whole);
  REQUIRE(run(join).status == 0);
  CHECK(contents(d / "x.svg") == drawing);
}

TEST_CASE("join says the same of parts with fills", "[cli][tiles][fills][fault]") {
  const Directory d;
  const std::string model = write(d / "town.obj", town(3)), job = d / "job", part = job + "/part-2",
                    join = "join " + job + " -o " + (d / "x.svg");
  make_job(job, model, 3, "--fill");
  make_parts(job, 3);
  REQUIRE(run(join).status == 0);
  const std::string whole = contents(part), drawing = contents(d / "x.svg");
  fs::remove(d / "x.svg");
  fs::remove(part);
  check_fails(run(join), {"part-2: missing", "tile 2"});
  write(part, whole.substr(0, whole.size() - 1));
  check_fails(run(join), {"part-2: not whole"});
  fs::copy_file(job + "/part-3", part, fs::copy_options::overwrite_existing);
  check_fails(run(join), {"part-2: of tile 3"});
  // Of the same tile without fills.
  make_job(d / "lines", model, 3);
  make_parts(d / "lines", 3);
  fs::copy_file(d / "lines/part-2", part, fs::copy_options::overwrite_existing);
  check_fails(run(join), {"part-2: of another job"});
  CHECK(!fs::exists(d / "x.svg"));
  REQUIRE(run("tile " + job + " -q 1 2 3").status == 0);
  CHECK(contents(part) == whole);
  REQUIRE(run(join).status == 0);
  CHECK(contents(d / "x.svg") == drawing);
}

TEST_CASE("a tile whose faces were changed, and a job that was, are refused", "[cli][tiles][fault]") {
  const Directory d;
  const std::string model = write(d / "town.obj", town(2)), job = d / "job";
  make_job(job, model, 2);
  const std::string tile = contents(job + "/tile-1"), manifest = contents(job + "/job.json");
  write(job + "/tile-1", tile.substr(0, tile.size() - 8));
  check_refused(run("tile " + job + " 1"), {"tile-1: found other bytes"});
  write(job + "/tile-1", tile);
  std::string turned = manifest;
  turned.replace(turned.find("\"hidden\": \"none\""), 16, "\"hidden\": \"solid\"");
  write(job + "/job.json", turned);
  check_refused(run("tile " + job + " 1"), {"job.json: found a hash"});
  write(job + "/job.json", "{");
  check_refused(run("join " + job + " -o " + (d / "x.svg")), {"job.json: found no JSON"});
  check_refused(run("tile " + (d / "nothing") + " 1"), {"nothing: found no directory"});
}

TEST_CASE("what tiles cannot do is refused in one line before any work", "[cli][tiles]") {
  const Directory d;
  const std::string model = write(d / "town.obj", town(1)), split = "split " + model + " -o " + (d / "job") + " ";
  check_refused(run(split + "--section z=1"), {"--section", "hsr draw"});
  check_refused(run(split + "--tolerance 0.1"), {"--tolerance"});
  check_refused(run(split + "--crease 30,20"), {"--crease"});
  check_refused(run(split + "--edges intersection"), {"--edges"});
  check_refused(run(split + "--memory lots"), {"--memory"});
  check_refused(run(split + "--tiles 0"), {"--tiles"});
  CHECK(!fs::exists(d / "job"));
  make_job(d / "job", model, 1);
  check_refused(run("tile " + (d / "job") + " 2"), {"N: found \"2\""});
  make_parts(d / "job", 1);
  check_refused(run("join " + (d / "job") + " -o " + (d / "x.json")), {"--json"});
  check_refused(run("join " + (d / "job") + " --merge colour -o " + (d / "x.svg")), {"has no fills", "--fill", "--merge"});
}

TEST_CASE("tiles that are killed at any moment and begun again give the same bytes", "[cli][tiles][fault]") {
  const Directory d;
  const std::string model = write(d / "town.obj", town(12)), job = d / "job";
  make_job(job, model, 3, "--hidden dashed");
  make_parts(job, 3);
  REQUIRE(run("join " + job + " -q -o " + (d / "whole.svg")).status == 0);
  std::mt19937 random(11);
  for (int k = 0; k < 20; ++k) {
    for (int t = 1; t <= 3; ++t) fs::remove(job + "/part-" + std::to_string(t));
    const std::string pids = d / "pids";
    // Three at once, of which one is killed.
    REQUIRE(std::system(("(for n in 1 2 3; do " HSR_COMMAND " tile " + job + " -q $n & echo $! >> " + pids +
                         "; done; sleep 0.0" + std::to_string(random() % 100) + "; kill -9 $(sed -n " +
                         std::to_string(1 + random() % 3) + "p " + pids + "); wait) >/dev/null 2>&1; rm -f " + pids)
                            .c_str()) == 0);
    const Outcome early = run("join " + job + " -q -o " + (d / "again.svg"));
    CHECK((early.status == 0 || (early.status == 1 && early.text.find("missing") != std::string::npos)));
    make_parts(job, 3);
    REQUIRE(run("join " + job + " -q -o " + (d / "again.svg")).status == 0);
    CHECK(contents(d / "again.svg") == contents(d / "whole.svg"));
  }
}

TEST_CASE("two joins at once write the same drawing, whole", "[cli][tiles][fault]") {
  const Directory d;
  const std::string model = write(d / "town.obj", town(6)), job = d / "job",
                    join = HSR_COMMAND " join " + job + " -q -o " + (d / "x.svg");
  make_job(job, model, 4);
  make_parts(job, 4);
  REQUIRE(std::system((join + " & " + join + "; a=$?; wait $! && exit $a").c_str()) == 0);
  REQUIRE(run("draw " + model + " -q -o " + (d / "one.svg")).status == 0);
  CHECK(contents(d / "x.svg") == contents(d / "one.svg"));
}

TEST_CASE("where the disk is full nothing half-written is left", "[cli][tiles][fault]") {
  const Directory d;
  const std::string model = write(d / "town.obj", town(6)), job = d / "job";
  make_job(job, model, 2);
  const std::size_t files = static_cast<std::size_t>(std::distance(fs::directory_iterator(job), fs::directory_iterator()));
  check_refused(run("tile " + job + " 1", "ulimit -f 1; "), {"part-1: cannot be written"});
  CHECK(static_cast<std::size_t>(std::distance(fs::directory_iterator(job), fs::directory_iterator())) == files);
  check_refused(run("split " + model + " -o " + (d / "small"), "ulimit -f 1; "), {"cannot be written"});
  CHECK(!fs::exists(d / "small/job.json"));
  make_parts(job, 2);
  check_refused(run("join " + job + " -o " + (d / "x.svg"), "ulimit -f 1; "), {"x.svg: cannot be written"});
  CHECK(!fs::exists(d / "x.svg"));
}
