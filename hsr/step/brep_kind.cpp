#include "hsr/step/brep_kind.h"

#include <algorithm>

#include "hsr/step/step.h"

// Nothing here needs Open CASCADE: a program that only asks what a file is does not load it.

namespace hsr {

namespace {

std::string ending_of(std::string path) {
  std::transform(path.begin(), path.end(), path.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  if (path.ends_with(".gz")) path.resize(path.size() - 3);
  const std::size_t point = path.find_last_of("./");
  return point == std::string::npos || path[point] == '/' ? std::string() : path.substr(point + 1);
}

}  // namespace

bool internal::is_iges(const std::string& path) {
  const std::string ending = ending_of(path);
  return ending == "iges" || ending == "igs";
}

bool is_brep(const std::string& path, std::string_view bytes) {
  if (bytes.starts_with("ISO-10303-21")) return true;
  const std::string ending = ending_of(path);
  return ending == "step" || ending == "stp" || internal::is_iges(path);
}

}  // namespace hsr
