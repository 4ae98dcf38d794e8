// hsr batch: what it makes, what it does again, and what it loses when it is killed.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>
#include <map>
#include <string>
#include <thread>

#include "tests/cli/run_command.h"

using namespace hsr::cli_tests;

namespace fs = std::filesystem;

namespace {

/// A tetrahedron of some height.
std::string tetrahedron(double height) {
  return "v 0 0 0\nv 4 0 0\nv 0 3 0\nv 1 1 " + std::to_string(height) + "\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
}

/// All files of a batch but its manifest, by path.
std::map<std::string, std::string> drawings_in(const std::string& directory) {
  std::map<std::string, std::string> all;
  for (const auto& entry : fs::recursive_directory_iterator(directory))
    if (entry.is_regular_file() && entry.path().extension() != ".csv")
      all[fs::relative(entry.path(), directory).string()] = contents(entry.path().string());
  return all;
}

/// The manifest without the column of seconds.
std::string manifest_of(const std::string& directory) {
  std::istringstream lines(contents(directory + "/manifest.csv"));
  std::string text;
  for (std::string line; std::getline(lines, line);) {
    std::size_t begin = 0;
    for (int column = 0; column < 4; ++column) begin = line.find(',', begin) + 1;
    text += line.substr(0, begin) + line.substr(line.find(',', begin)) + "\n";
  }
  return text;
}

bool says(const Outcome& outcome, const std::string& text) { return outcome.text.find(text) != std::string::npos; }

}  // namespace

TEST_CASE("a batch draws each model in each view as hsr draw does, and a bad one stops nothing", "[cli][batch]") {
  const Directory d;
  fs::create_directories(d / "parts");
  write(d / "parts/a.obj", tetrahedron(2));
  write(d / "b.obj", tetrahedron(5));
  write(d / "bad.obj", "v 0 0 0\nf 1 2 3\n");
  const std::string list =
      write(d / "list.txt", "# models\nparts/a.obj\n\nbad.obj\r\n../" + fs::path(d / "").parent_path().filename().string() +
                                "/b.obj\nparts/a.obj\nmissing.obj\n");
  const std::string at = "cd " + (d / "") + " && ";
  const Outcome outcome = run("batch list.txt -o out --views iso,top -- --hidden dashed", at);
  INFO(outcome.text);
  CHECK(outcome.status == 1);
  CHECK(says(outcome, "out/manifest.csv: 8 drawings: 4 made now, 0 as they were, 4 failed"));
  const auto drawn = drawings_in(d / "out");
  CHECK(drawn.size() == 4);
  for (const char* view : {"iso", "top"}) {
    REQUIRE(run(std::string("draw parts/a.obj -o alone.svg --hidden dashed --view ") + view, at).status == 0);
    CHECK(drawn.at(std::string("parts/a.obj.") + view + ".svg") == contents(d / "alone.svg"));
  }
  CHECK(std::ranges::any_of(drawn, [](const auto& file) { return file.first.starts_with("up/"); }));
  const std::string manifest = contents(d / "out/manifest.csv");
  CHECK(manifest.starts_with("file,view,output,status,seconds,request,input,hash,message\nparts/a.obj,iso,"));
  CHECK(manifest.find("bad.obj: line 2: ") != std::string::npos);
  CHECK(manifest.find("missing.obj: cannot be opened") != std::string::npos);
}

TEST_CASE("a batch that is run again does what is missing or has changed", "[cli][batch]") {
  const Directory d;
  const std::string a = write(d / "a.obj", tetrahedron(2)), b = write(d / "b.obj", tetrahedron(3)), out = d / "out";
  const std::string list = write(d / "list.txt", a + "\n" + b + "\n");
  const auto made = [&](const std::string& options = "") {
    const Outcome outcome = run("batch " + list + " -o " + out + " --views iso,front " + options);
    INFO(outcome.text);
    const std::size_t at = outcome.text.find(" drawings: ");
    REQUIRE(at != std::string::npos);
    return outcome.text.substr(at + 11, outcome.text.find(" made", at) - at - 11);
  };
  CHECK(made() == "4");
  const auto first = drawings_in(out);
  CHECK(made() == "0");
  write(b, tetrahedron(4));
  CHECK(made() == "2");
  write(b, tetrahedron(3));
  CHECK(made() == "2");
  CHECK(drawings_in(out) == first);
  fs::remove(out + "/" + first.begin()->first);
  CHECK(made() == "1");
  write(out + "/" + first.begin()->first, "something else");
  CHECK(made() == "1");
  CHECK(drawings_in(out) == first);
  CHECK(made("-- --hidden dashed") == "4");
  CHECK(made("--jobs 1 -- --hidden dashed") == "0");
  // A model that is not right any more has no drawing any more.
  write(b, "f 1 2 3\n");
  CHECK(made("-- --hidden dashed") == "0");
  CHECK(drawings_in(out).size() == 2);
  CHECK(made("-- --hidden dashed") == "0");
  CHECK_FALSE(fs::exists(out + "/journal.csv"));
  // Where it was not the model's fault it is tried again.
  write(b, tetrahedron(3));
  const std::string blocked = out + "/" + first.rbegin()->first;
  fs::create_directories(blocked + "/x");
  CHECK(made("-- --hidden dashed") == "1");
  fs::remove_all(blocked);
  CHECK(made("-- --hidden dashed") == "1");
  CHECK(drawings_in(out).size() == 4);
}

TEST_CASE("parts of a batch, run at once anywhere, are the batch", "[cli][batch]") {
  const Directory d;
  std::string list;
  for (int k = 0; k < 7; ++k)
    list += write(d / ("m" + std::to_string(k) + ".obj"), k == 3 ? "nothing" : tetrahedron(k + 1)) + "\n";
  write(d / "list.txt", list);
  const std::string batch = "batch " + (d / "list.txt") + " --views iso,top -o ";
  CHECK(run(batch + (d / "whole")).status == 1);
  std::array<int, 3> status;
  {
    std::vector<std::jthread> parts;
    for (std::size_t k = 0; k < 3; ++k)
      parts.emplace_back([&, k] { status[k] = run(batch + (d / "parts") + " --part " + std::to_string(k + 1) + "/3").status; });
  }
  CHECK(std::ranges::count(status, 1) == 1);  // the part with the bad model
  const Outcome last = run(batch + (d / "parts"));
  CHECK(says(last, "14 drawings: 0 made now, 12 as they were, 2 failed"));
  CHECK(drawings_in(d / "parts") == drawings_in(d / "whole"));
  CHECK(manifest_of(d / "parts") == manifest_of(d / "whole"));
  for (const auto& entry : fs::directory_iterator(d / "parts"))
    CHECK_FALSE(entry.path().filename().string().starts_with("journal"));
}

TEST_CASE("a batch that is killed loses the drawings that it was at", "[cli][batch]") {
  const Directory d;
  std::string list;
  for (int k = 0; k < 60; ++k) list += write(d / ("m" + std::to_string(k) + ".obj"), tetrahedron(k + 1)) + "\n";
  write(d / "list.txt", list);
  const std::string batch = "batch " + (d / "list.txt") + " --views iso,top -o ";
  REQUIRE(run(batch + (d / "whole")).status == 0);
  for (const int milliseconds : {30, 150, 400}) {
    const std::string out = d / ("killed" + std::to_string(milliseconds));
    run(batch + out + " & p=$!; sleep " + std::to_string(milliseconds / 1000.0) + "; kill -9 $p; wait $p");
    // What it was at may still be going on.
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    const auto before = fs::exists(out) ? drawings_in(out) : std::map<std::string, std::string>{};
    for (const auto& [name, bytes] : before)
      if (name.ends_with(".svg")) CHECK(bytes.ends_with("</svg>\n"));
    const Outcome again = run(batch + out);
    INFO(again.text);
    REQUIRE(again.status == 0);
    const std::size_t at = again.text.find(" drawings: ") + 11;
    const auto made = std::stoul(again.text.substr(at));
    CHECK(made + before.size() <= 120 + 2 * std::thread::hardware_concurrency());
    auto now = drawings_in(out);
    std::erase_if(now, [](const auto& file) { return !file.first.ends_with(".svg"); });  // of the one that was killed
    CHECK(now == drawings_in(d / "whole"));
    CHECK(manifest_of(out) == manifest_of(d / "whole"));
  }
}

TEST_CASE("half a row of a batch that was killed is no row", "[cli][batch]") {
  const Directory d;
  const std::string a = write(d / "a.obj", tetrahedron(2)), out = d / "out";
  write(d / "list.txt", a + "\n");
  const std::string batch = "batch " + (d / "list.txt") + " --views iso -o " + out;
  REQUIRE(run(batch).status == 0);
  const std::string manifest = contents(out + "/manifest.csv"), row = manifest.substr(manifest.find('\n') + 1);
  fs::remove(out + "/manifest.csv");
  for (const std::size_t kept : {row.size() - 34, row.size() / 2, std::size_t{3}}) {
    write(out + "/journal.csv", row.substr(0, kept));
    CHECK(says(run(batch), "1 drawing: 1 made now"));
    fs::remove(out + "/manifest.csv");
  }
  write(out + "/journal.csv", row);
  CHECK(says(run(batch), "1 drawing: 0 made now, 1 as they were"));
}

TEST_CASE("what is no batch is refused in one line", "[cli][batch]") {
  const Directory d;
  const std::string list = write(d / "list.txt", write(d / "a.obj", tetrahedron(2)) + "\n"),
                    empty = write(d / "empty.txt", "# nothing\n"), same = write(d / "same.txt", "../q.obj\nup/q.obj\n");
  const std::pair<std::string, std::string> cases[] = {
      {(d / "none.txt") + " -o " + (d / "x"), "none.txt: cannot be read, expected a file with a model to a line"},
      {empty + " -o " + (d / "x"), "empty.txt: found no model, expected one to a line"},
      {list + " -o " + list, "list.txt: cannot be made a directory"},
      {list + " -o " + (d / "x") + " --part 3/2", "--part: found \"3/2\", expected a part such as 3/20"},
      {list + " -o " + (d / "x") + " --part 0/2", "--part: found \"0/2\""},
      {list + " -o " + (d / "x") + " --views front,", "--views: found \"front,\""},
      {list + " -o " + (d / "x") + " --views front,nope", "--view: found \"nope\", expected front, back"},
      {list + " -o " + (d / "x") + " --sheet --views front", "--views: found with --sheet"},
      {list + " -o " + (d / "x") + " --jobs 0", "--jobs: found 0, expected 1 or more"},
      {list + " -o " + (d / "x") + " -- --hidden wrong", "--hidden: "},
      {list + " -o " + (d / "x") + " -- --nonsense", "--nonsense"},
      {list + " -o " + (d / "x") + " -- -o x.svg", "-o: found after --, expected options of the drawing itself"},
      {list + " -o " + (d / "x") + " -- --help", "--help: found after --"},
      {list + " -o " + (d / "x") + " -- --report=r.json", "--report: found after --"},
      {same + " -o " + (d / "x"), "found ../q.obj and up/q.obj, whose drawings would be one file"},
  };
  for (const auto& [options, message] : cases) {
    const Outcome outcome = run("batch " + options);
    INFO(options << ": " << outcome.text);
    CHECK(outcome.status == 2);
    CHECK(says(outcome, message));
    CHECK(std::ranges::count(outcome.text, '\n') == 1);
  }
  // Another one at work: it holds its journal.
  fs::create_directories(d / "busy");
  const Outcome busy = run("batch " + list + " -o " + (d / "busy"), "flock " + (d / "busy/journal.csv") + " ");
  CHECK(busy.status == 2);
  CHECK(says(busy, "journal.csv: found another hsr batch at work on it"));
}

TEST_CASE("names that look like options, come twice or are no files", "[cli][batch]") {
  const Directory d;
  write(d / "-o", "");
  write(d / "-dash.obj", tetrahedron(2));
  write(d / "a, b.obj", tetrahedron(3));
  write(d / "list.txt", "-dash.obj\n--help\na, b.obj\n./a, b.obj\n");
  const std::string at = "cd " + (d / "") + " && mkfifo pipe.obj; echo pipe.obj >> list.txt; timeout 20 ";
  const Outcome outcome = run("batch list.txt -o out --views iso,iso", at);
  INFO(outcome.text);
  CHECK(says(outcome, "4 drawings: 2 made now, 0 as they were, 2 failed"));
  const auto drawn = drawings_in(d / "out");
  CHECK(drawn.size() == 2);
  CHECK(drawn.contains("-dash.obj.iso.svg"));
  CHECK(contents(d / "out/manifest.csv").find("\"a, b.obj\",iso,") != std::string::npos);
  // As find -print0 writes them.
  const Outcome zeros = run("batch - -o zeros --views iso", "cd " + (d / "") + " && printf '%s\\0' -dash.obj 'a, b.obj' | ");
  CHECK(says(zeros, "2 drawings: 2 made now"));
}

TEST_CASE("a batch of sheets", "[cli][batch][sheet]") {
  const Directory d;
  write(d / "list.txt", write(d / "a.obj", tetrahedron(2)) + "\n");
  REQUIRE(run("batch " + (d / "list.txt") + " -o " + (d / "out") + " --sheet --format pdf -- --page A4").status == 0);
  REQUIRE(run("sheet " + (d / "a.obj") + " -o " + (d / "a.pdf") + " --page A4").status == 0);
  const auto drawn = drawings_in(d / "out");
  REQUIRE(drawn.size() == 1);
  CHECK(drawn.begin()->second == contents(d / "a.pdf"));
}
