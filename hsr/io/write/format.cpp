#include "hsr/io/write/format.h"

#include <algorithm>

#include "geometry/error.h"

namespace hsr::internal {

namespace {

const char* name_of(Format f) {
  static constexpr const char* names[] = {"svg", "pdf", "eps", "dxf", "tex", "hpgl", "png", "json", "csv"};
  return names[static_cast<std::size_t>(f)];
}

}  // namespace

Format format_of(const std::string& path, std::span<const Format> expected) {
  const auto slash = path.find_last_of('/');
  const std::string name = slash == std::string::npos ? path : path.substr(slash + 1);
  const auto dot = name.find_last_of('.');
  std::string ending = dot == std::string::npos ? "" : name.substr(dot + 1);
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
  if (ending == "plt") ending = "hpgl";
  std::string all;
  for (std::size_t k = 0; k < expected.size(); ++k) {
    if (ending == name_of(expected[k])) return expected[k];
    all += std::string(k == 0 ? "" : k + 1 < expected.size() ? ", " : " or ") + "." + name_of(expected[k]);
  }
  const std::string found = ending.empty() ? "no ending" : std::string("the ending .").append(ending);
  throw InputError(path + ": found " + found + ", expected " + all);
}

}  // namespace hsr::internal
