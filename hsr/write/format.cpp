#include "hsr/write/format.h"

#include <algorithm>

#include "geometry/error.h"

namespace hsr {

Format format_of(const std::string& path) {
  const auto slash = path.find_last_of('/');
  const std::string name = slash == std::string::npos ? path : path.substr(slash + 1);
  const auto dot = name.find_last_of('.');
  std::string ending = dot == std::string::npos ? "" : name.substr(dot + 1);
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
  if (ending == "svg") return Format::svg;
  if (ending == "png") return Format::png;
  if (ending == "json") return Format::json;
  if (ending == "pdf" || ending == "eps" || ending == "dxf" || ending == "tex")
    throw InputError(path + ": " + ending + " comes in a later release; this one writes svg, png and json");
  const std::string found = ending.empty() ? "no ending" : std::string("the ending .").append(ending);
  throw InputError(path + ": found " + found + ", expected .svg, .png or .json");
}

}  // namespace hsr
