#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/cli/run_command.h"

namespace hsr::cli_tests {
namespace {

const char* const pyramid = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 1 1 2\nf 1 4 3 2\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";

TEST_CASE("explain writes a page and its steps for each method, lessons and an index", "[cli][explain]") {
  const Directory d;
  const Outcome outcome = run("explain -q -o " + (d / "all"));
  CHECK(outcome.text.empty());
  REQUIRE(outcome.status == 0);
  const std::string index = contents(d / "all/index.html");
  for (const std::string method : {"depth-sort", "bsp", "z-buffer", "roberts", "scanline", "row-z-buffer", "tiled-z-buffer",
                                   "ray-casting", "a-buffer", "alpha-buffer", "painter"}) {
    INFO(method);
    CHECK(index.find("href=\"" + method + ".html\"") != std::string::npos);
    const std::string page = contents(d / ("all/" + method + ".html"));
    CHECK(page.find("<!DOCTYPE html>") == 0);
    for (const char* const elsewhere : {"src=", "href=\"http", "url(", "@import"})
      CHECK(page.find(elsewhere) == std::string::npos);
    CHECK(page.find("{{") == std::string::npos);
    CHECK(page.size() < 5'000'000);
    const auto trace = nlohmann::json::parse(contents(d / ("all/" + method + ".json")));
    CHECK(trace["format"] == "hsr-trace/1");
    CHECK(trace["method"] == method);
  }
  CHECK(contents(d / "all/z-buffer.html").find("href=\"z-compression.html\"") != std::string::npos);
  for (const std::string lesson : {"lesson-image-space", "lesson-object-space", "z-compression"}) {
    CHECK(index.find("href=\"" + lesson + ".html\"") != std::string::npos);
    CHECK(contents(d / ("all/" + lesson + ".html")).find("{{") == std::string::npos);
  }
}

TEST_CASE("explain shows one method on a model, in the view asked for", "[cli][explain]") {
  const Directory d;
  const std::string model = write(d / "pyramid.obj", pyramid);
  REQUIRE(run("explain z-buffer " + model + " --view top --size 8 -o " + (d / "one")).status == 0);
  const auto trace = nlohmann::json::parse(contents(d / "one/z-buffer.json"));
  // Alone, the page links to none but the index; with all of them, to the others.
  CHECK(contents(d / "one/z-buffer.html").find("href=\"z-compression.html\"") == std::string::npos);
  CHECK(contents(d / "one/z-buffer.html").find("href=\"index.html\"") != std::string::npos);
  CHECK(trace["view"] == "pyramid.obj, view top");
  CHECK(trace["scene"]["width"] == 8);
  CHECK(trace["scene"]["faces"].size() == 5);
  const std::string index = contents(d / "one/index.html");
  CHECK(index.find("bsp.html") == std::string::npos);  // it is not there
  // The order that is explained is that of the verb order.
  REQUIRE(run("explain depth-sort " + model + " -o " + (d / "sorted")).status == 0);
  REQUIRE(run("order " + model + " -q -o " + (d / "order.json")).status == 0);
  const auto sorted = nlohmann::json::parse(contents(d / "sorted/depth-sort.json"));
  const auto order = nlohmann::json::parse(contents(d / "order.json"));
  nlohmann::json faces = nlohmann::json::array();
  for (const auto& piece : order["pieces"]) faces.push_back(piece["face"]);
  CHECK(sorted["runs"][0]["result"]["painted"] == faces);
  // A model alone: every method.
  REQUIRE(run("explain " + model + " -o " + (d / "every")).status == 0);
  CHECK(contents(d / "every/index.html").find("bsp.html") != std::string::npos);
}

TEST_CASE("explain refuses what it cannot show", "[cli][explain]") {
  const Directory d;
  const std::string model = write(d / "pyramid.obj", pyramid), out = " -o " + (d / "out");
  const auto refused = [&](const std::string& arguments, const std::string& words) {
    const Outcome outcome = run("explain " + arguments + out);
    INFO(outcome.text);
    CHECK(outcome.status == 2);
    CHECK(outcome.text.find(words) != std::string::npos);
    CHECK(std::count(outcome.text.begin(), outcome.text.end(), '\n') == 1);
    CHECK(!std::filesystem::exists(d / "out"));
  };
  refused("depthsort " + model, "found depthsort, expected depth-sort, bsp, ");
  refused("--view top", "found a view and no MODEL");
  refused("z-buffer --size 1", "--size: found 1");
  refused("bsp " + model + " --section z=1", "a section");
  refused("bsp " + model + " --eye 1,1,-0.5 --target 5,1,-0.5", "before the near plane");
  std::string many;
  for (int k = 0; k < 201; ++k)
    many +=
        "v " + std::to_string(k) + " 0 0\nv " + std::to_string(k) + " 1 0\nv 0 2 " + std::to_string(k + 1) + "\nf -1 -2 -3\n";
  refused("all " + write(d / "many.obj", many), "201 faces, expected at most 200");
}

}  // namespace
}  // namespace hsr::cli_tests
