// hsr order and hsr verify as a user meets them.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "tests/cli/run_command.h"

using namespace hsr::cli_tests;

TEST_CASE("orders are painted, written, and verified", "[cli][order][J4]") {
  const Directory d;
  const std::string model = write(d / "cube.obj", cube);
  for (const std::string method : {"depth-sort", "bsp"}) {
    const std::string order = d / (method + ".json");
    const Outcome made = run("order " + model + " --method " + method + " --check -o " + order + " -o " +
                             (d / (method + ".svg")) + " -o " + (d / (method + ".png")) + " --size 64x64");
    INFO(made.text);
    CHECK(made.status == 0);
    CHECK(made.text.find("shows the nearest face at each of 4096 samples") != std::string::npos);
    const std::string text = contents(order);
    CHECK(text.find("\"format\": \"hsr-order/1\"") != std::string::npos);
    CHECK(count(text, "{\"face\"") == 6);
    CHECK(count(text, "false") == 0);
    CHECK(count(contents(d / (method + ".svg")), "Z\" fill=\"#") == 6);
    const Outcome verified = run("verify " + order);
    CHECK(verified.status == 0);
    CHECK(verified.text.rfind("correct: 6 pieces", 0) == 0);
    CHECK(run("verify " + order + " --direction -1,1,-1").status == 1);  // from behind it is the wrong way round
  }
}

TEST_CASE("a wrong order is shown where it is wrong", "[cli][order]") {
  const Directory d;
  const std::string near_first = write(d / "near_first.json", R"({"format": "hsr-order/1",
"view": {"eye": [0, 0, 1, 0], "target": [0, 0, 0], "up": [0, 1, 0], "near": null},
"pieces": [{"points": [[0, 0, 1], [3, 0, 1], ["1/3", 3, 1]]}, {"face": 4, "points": [[0, 0, 0], [3, 0, 0], [0, 3, 0]]}]})");
  const Outcome wrong = run("verify " + near_first + " -o " + (d / "wrong.svg") + " --report " + (d / "r.json"));
  INFO(wrong.text);
  CHECK(wrong.status == 1);
  CHECK(wrong.text.find("wrong: 1 of 1 overlapping pairs") != std::string::npos);
  CHECK(wrong.text.find("piece 0 is painted before piece 1 (face 4)") != std::string::npos);
  CHECK(count(contents(d / "wrong.svg"), "<circle") == 1);
  CHECK(contents(d / "r.json").find("\"order_exists\": true") != std::string::npos);
  CHECK(run("verify " + near_first + " -q").text.empty());
}

TEST_CASE("an order that is none is refused in one line", "[cli][order]") {
  const Directory d;
  const auto refused = [&](const std::string& text, const std::vector<std::string>& words) {
    check_refused(run("verify " + write(d / "bad.json", text)), words);
  };
  const std::string head =
      R"({"format": "hsr-order/1", "view": {"eye": [0, 0, 1, 0], "target": [0, 0, 0], "up": [0, 1, 0]}, "pieces": )";
  refused("{", {"byte"});
  const std::string deep(200'000, '[');
  refused(head + deep, {"byte", "100 brackets"});
  refused(head + deep + std::string(200'000, ']') + "}", {"byte", "100 brackets"});
  refused(R"({"format": )" + deep + std::string(200'000, ']') + "}", {"byte", "100 brackets"});
  refused("[]", {"hsr-order/1"});
  refused(R"({"format": "hsr-lines/1"})", {"hsr-lines/1", "hsr-order/1"});
  refused(head + "3}", {"pieces", "3"});
  refused(head + "[{}]}", {"piece 0", "points"});
  refused(head + R"([{"points": [[0, 0, 0], [1, 0, 0]]}]})", {"piece 0", "2 points"});
  refused(head + R"([{"wire": [0, 1], "points": [[0, 0, 0], [1, 0, 0], [1, 1, 1]]}]})",
          {"piece 0", "3 points", "the two of a wire"});
  refused(head + R"([{"wire": [0, 1], "face": 2, "points": [[0, 0, 0], [1, 0, 0]]}]})", {"piece 0", "one of them"});
  refused(head + R"([{"points": [[0, 0, 0], [1, 0, "a"], [1, 1, 1]]}]})", {"piece 0, point 1", "p/q"});
  refused(head + R"([{"points": [[0, 0, 0], [1, 0, "1/0"], [1, 1, 1]]}]})", {"piece 0, point 1", "1/0"});
  refused(head + R"([{"points": [[0, 0, 0], [1, 0, 1e999], [1, 1, 1]]}]})", {"finite"});
  for (const char* frame : {R"("right": [0, 0, 0], "up": [0, 1, 0])", R"("right": [1, 0, 0], "up": [2, 0, 0])",
                            R"("right": [1, 0, 0], "up": [0, 0, 1])"})
    refused(std::string(R"({"format": "hsr-order/1", "view": {"eye": [0, 0, 1, 0], "target": [0, 0, 0], "up": [0, 1, 0],
                        "frame": {"origin": [0, 0, 0], )") +
                frame + R"(}}, "pieces": [
                        {"points": [[0, 0, 0], [1, 0, 0], [0, 1, 0]]}, {"wire": [0, 1], "points": [[0, 0, 0], [2, 0, -1]]}]})",
            {"view: frame", "crosses"});
  refused(head + R"([{"face": -1, "points": [[0, 0, 0], [1, 0, 0], [1, 1, 1]]}]})", {"piece 0: face", "-1"});
}

TEST_CASE("an exact order is read back", "[cli][J4]") {
  const Directory d;
  const std::string model = write(d / "cube.obj", cube), order = d / "v.json";
  for (const std::string view : {"--view iso", "--eye 3,4,5 --near 0.1"}) {
    REQUIRE(run("order " + model + " -q --exact " + view + " -o " + order).status == 0);
    CHECK(run("verify " + order).status == 0);
  }
  std::string text = contents(order);
  const std::size_t at = text.find("\"eye\": [\"");
  REQUIRE(at != std::string::npos);
  text.replace(at, text.find(',', at) - at, "\"eye\": [\"1/3\"");
  check_refused(run("verify " + write(d / "w.json", text)), {"w.json", "eye", "a double"});
}
