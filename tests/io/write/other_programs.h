#pragma once

#include <png.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "tests/io/write/exact_picture.h"

namespace hsr {

/// A directory that goes when it is done with.
class Workplace {
 public:
  explicit Workplace(const std::string& name)
      : path_(std::filesystem::temp_directory_path() / (name + "_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(path_);
  }
  ~Workplace() { std::filesystem::remove_all(path_); }
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;

  std::string write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path_ / name, std::ios::binary) << bytes;
    return (path_ / name).string();
  }
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  /// What a program says, run here; its status in `status`.
  std::string run(const std::string& command, int& status) const {
    const std::string log = *this / "log";
    const int ended = std::system(("cd " + path_.string() + " && ( " + command + " ) > " + log + " 2>&1 < /dev/null").c_str());
    status = WIFEXITED(ended) ? WEXITSTATUS(ended) : -1;
    std::ostringstream text;
    text << std::ifstream(log).rdbuf();
    return text.str();
  }

 private:
  std::filesystem::path path_;
};

inline bool has_program(const std::string& name) {
  return std::system(("command -v " + name + " > /dev/null 2>&1").c_str()) == 0;
}

/// Says so where it is not.
inline bool is_there(const std::string& program) {
  if (has_program(program)) return true;
  WARN(program << " is missing: what it would have shown is not tested");
  return false;
}

/// Empty where the file is no PNG.
inline RenderedPage read_png(const std::string& path) {
  RenderedPage page;
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&image, path.c_str()) == 0) return page;
  image.format = PNG_FORMAT_RGB;
  page.width = int(image.width);
  page.height = int(image.height);
  page.bytes.resize(PNG_IMAGE_SIZE(image));
  const png_color white = {255, 255, 255};
  if (png_image_finish_read(&image, &white, page.bytes.data(), 0, nullptr) == 0) return {};
  return page;
}

}  // namespace hsr
