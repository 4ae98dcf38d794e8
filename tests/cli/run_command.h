#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

/// The command as a user meets it, for tests: runs it, and looks at what it prints, writes and returns.
namespace hsr::cli_tests {

struct Outcome {
  int status;
  std::string text;  // standard output and standard error
};

inline Outcome run(const std::string& arguments, const std::string& before = "") {
  FILE* pipe = popen((before + HSR_COMMAND + " " + arguments + " 2>&1").c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::string text;
  std::array<char, 4096> buffer;
  for (std::size_t n = 0; (n = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) text.append(buffer.data(), n);
  const int status = pclose(pipe);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text};
}

class Directory {
 public:
  Directory() : path_(std::filesystem::temp_directory_path() / ("hsr_cli_test_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(path_);
  }
  ~Directory() { std::filesystem::remove_all(path_); }
  Directory(const Directory&) = delete;
  Directory& operator=(const Directory&) = delete;
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  std::size_t files() const {
    return static_cast<std::size_t>(
        std::distance(std::filesystem::directory_iterator(path_), std::filesystem::directory_iterator()));
  }

 private:
  std::filesystem::path path_;
};

inline std::string write(const std::string& path, const std::string& text) {
  std::ofstream(path) << text;
  return path;
}
inline std::string contents(const std::string& path) {
  std::ostringstream s;
  s << std::ifstream(path).rdbuf();
  return s.str();
}

inline const char* const cube =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n"
    "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";

inline std::size_t count(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
  return n;
}

/// One line, status 2, and the words that matter.
inline void check_refused(const Outcome& outcome, const std::vector<std::string>& words) {
  INFO(outcome.text);
  CHECK(outcome.status == 2);
  CHECK(count(outcome.text, "\n") == 1);
  CHECK(outcome.text.rfind("hsr: ", 0) == 0);
  for (const std::string& word : words) CHECK(outcome.text.find(word) != std::string::npos);
}

}  // namespace hsr::cli_tests
