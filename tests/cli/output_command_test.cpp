// What becomes of outputs when something goes wrong: names that meet, full disks, closed streams, limits, interrupts.
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "tests/cli/run_command.h"

namespace fs = std::filesystem;
using nlohmann::json;
using namespace hsr::cli_tests;

TEST_CASE("an output never takes the place of the model or of another output", "[cli]") {
  const Directory d;
  const std::string model = write(d / "cube.obj", cube);
  fs::create_symlink(model, d / "link.svg");
  fs::create_hard_link(model, d / "hard.svg");
  const std::string svg = d / "a.svg";
  check_refused(run("draw " + model + " -o " + svg + " --report " + model), {"cube.obj", "model itself"});
  check_refused(run("info " + model + " --mesh " + model), {"cube.obj", "model itself"});
  check_refused(run("draw " + model + " -o " + (d / "link.svg")), {"link.svg", "model itself"});
  check_refused(run("draw " + model + " -o " + (d / "hard.svg")), {"hard.svg", "model itself"});
  check_refused(run("draw " + model + " -o " + svg + " --report " + (d / "./a.svg")), {"a.svg", "twice"});
  check_refused(run("draw " + model + " -o " + svg + " -o " + (d / "no/b.svg")), {"no/b.svg"});
  CHECK(contents(model) == cube);
  CHECK_FALSE(fs::exists(svg));
}

TEST_CASE("two names of one file are found out before it is there", "[cli]") {
  const Directory d;
  write(d / "cube.obj", cube);
  fs::create_directory(d / "sub");
  fs::create_directory_symlink(".", d / "linked");
  const std::string here = "cd " + (d / "") + " && ";
  for (const std::string& other :
       {std::string("./a.svg"), std::string("sub/../a.svg"), std::string("linked/a.svg"), d / "a.svg"}) {
    check_refused(run("draw cube.obj -o a.svg -o " + other, here), {other, "twice"});
    check_refused(run("draw cube.obj -o " + other + " -o a.svg", here), {"a.svg", "twice"});
    check_refused(run("order cube.obj -o a.svg --report " + other, here), {other, "twice"});
  }
  check_refused(run("draw cube.obj -o no/a.svg", here), {"no/a.svg", "directory"});
  CHECK(run("draw cube.obj -q -o a.svg -o sub/a.svg", here).status == 0);
}

TEST_CASE("a full disk is an error, not a success", "[cli]") {
  const Directory d;
  const std::string model = write(d / "cube.obj", cube);
  for (const std::string& verb : {"info " + model, std::string("--help")}) {
    const int status = std::system((std::string(HSR_COMMAND) + " " + verb + " > /dev/full 2> /dev/null").c_str());
    CHECK(WEXITSTATUS(status) == 2);
  }
}

TEST_CASE("a limit on the size of files is an error that leaves nothing", "[cli]") {
  const Directory d;
  const std::string model = write(d / "cube.obj", cube);
  const std::string limit = "ulimit -f 1; ";  // of what the shell runs
  for (const char* name : {"a.svg", "a.pdf", "a.json", "a.png"}) {
    check_refused(run("draw " + model + " --edges all --fill --hidden dashed -o " + (d / name), limit),
                  {name, "File too large"});
    CHECK(d.files() == 1);
  }
  check_refused(run("compare " + model + " -q -o " + (d / "study"), limit), {"File too large"});
  CHECK(d.files() == 1);
}

TEST_CASE("messages that cannot be written are no reason to die", "[cli]") {
  const Directory d;
  const std::string model = write(d / "cube.obj", cube);
  for (const char* error : {" 2> /dev/full", " 2>&-"}) {
    const std::string svg = d / "a.svg";
    const std::string eye = " --eye 0.25,0.5,0.75";  // makes a note
    const int status = std::system((HSR_COMMAND + (" draw " + model) + eye + " -o " + svg + error).c_str());
    REQUIRE(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 0);
    CHECK(contents(svg).rfind("<?xml", 0) == 0);
    const int refused = std::system((HSR_COMMAND + (" draw " + (d / "none.obj")) + " -o " + (d / "b.svg") + error).c_str());
    REQUIRE(WIFEXITED(refused));
    CHECK(WEXITSTATUS(refused) == 2);
    fs::remove(svg);
  }
}

TEST_CASE("a closed standard output is not taken for a file", "[cli]") {
  const Directory d;
  const std::string model = write(d / "cube.obj", cube), lines = d / "c.json";
  for (const char* closed : {" >&-", " >&- <&-", " <&- >&- 2>&-"}) {
    const int status = std::system((HSR_COMMAND + (" draw " + model) + " -o " + lines + " --report -" + closed).c_str());
    REQUIRE(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 2);
    CHECK_FALSE(fs::exists(lines));  // complete or absent
    // Where nothing is written to it, it is not missed.
    const int drawn = std::system((HSR_COMMAND + (" draw " + model) + " -o " + lines + closed).c_str());
    REQUIRE(WIFEXITED(drawn));
    CHECK(WEXITSTATUS(drawn) == 0);
    CHECK(json::parse(contents(lines))["format"] == "hsr-lines/1");
    fs::remove(lines);
  }
}

TEST_CASE("an interrupt leaves no half file", "[cli]") {
  const Directory d;
  std::string scene;
  for (int i = 0; i < 30000; ++i)
    scene +=
        "v " + std::to_string(i * 37 % 1009) + " " + std::to_string(i * 53 % 997) + " " + std::to_string(i * 71 % 991) + "\n";
  for (int i = 1; i + 2 <= 30000; i += 3)
    scene += "f " + std::to_string(i) + " " + std::to_string(i + 1) + " " + std::to_string(i + 2) + "\n";
  const std::string model = write(d / "soup.obj", scene);
  for (const int milliseconds : {20, 200, 1000}) {
    const pid_t child = fork();
    if (child == 0) {
      execl(HSR_COMMAND, HSR_COMMAND, "draw", model.c_str(), "--edges", "all", "-o", (d / "a.json").c_str(), nullptr);
      _exit(127);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    kill(child, SIGINT);
    int status = 0;
    waitpid(child, &status, 0);
    const bool interrupted = WIFSIGNALED(status) || WEXITSTATUS(status) != 0;
    // Absent, or, where it was faster than the signal, complete.
    CHECK(d.files() == (interrupted ? 1 : 2));
    if (!interrupted) CHECK(json::parse(contents(d / "a.json"))["format"] == "hsr-lines/1");
    fs::remove(d / "a.json");
  }
}
