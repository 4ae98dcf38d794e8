#include "hsr/cli/standard_input.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <string_view>
#include <system_error>

#include "geometry/error.h"

namespace hsr::cli {

namespace {

constexpr std::string_view name = "standard input";
/// A pipe has no size that could be checked, so it ends here.
constexpr std::size_t most = std::size_t{1} << 32;

std::string all_bytes() {
  std::string all;
  std::array<char, 1 << 16> chunk;
  for (;;) {
    const ssize_t n = ::read(STDIN_FILENO, chunk.data(), chunk.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) throw InputError(std::string(name) + ": cannot be read: " + std::generic_category().message(errno));
    if (n == 0) return all;
    all.append(chunk.data(), static_cast<std::size_t>(n));
    if (all.size() > most)
      throw InputError(std::string(name) + ": found more than 4 GiB, expected a file for a model of that size");
  }
}

/// OBJ has no mark of its own: the first word that is no comment is one of its words.
bool looks_like_obj(std::string_view text) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    const auto begin = line.find_first_not_of(" \t\r");
    if (begin == std::string_view::npos || line[begin] == '#') continue;
    const auto end = std::min(line.find_first_of(" \t\r", begin), line.size());
    static constexpr std::array<std::string_view, 12> words = {"v", "vn", "vt", "vp", "f",      "l",
                                                               "p", "o",  "g",  "s",  "usemtl", "mtllib"};
    return std::find(words.begin(), words.end(), line.substr(begin, end - begin)) != words.end();
  }
  return false;
}

}  // namespace

ModelFile read_standard_input(const std::string& format) {
  const std::string bytes = all_bytes();
  const std::string ending = !format.empty() ? "." + format : looks_like_obj(bytes) ? ".obj" : "";
  // Readers know a format by the ending of a path; who reads their messages gave none.
  const std::string path = std::string(name) + ending;
  try {
    ModelFile file = ModelFile::read(path, bytes);
    file.call(std::string(name));
    return file;
  } catch (const InputError& e) {
    const std::string message = e.what();
    if (ending.empty() || !message.starts_with(path)) throw;
    throw InputError(std::string(name) + message.substr(path.size()));
  }
}

}  // namespace hsr::cli
