#include "hsr/io/write/format.h"

#include <algorithm>

#include "geometry/error.h"

namespace hsr::internal {

const char* name_of(Format format) {
  static constexpr const char* names[] = {"svg", "pdf", "eps", "dxf", "tex", "hpgl", "png", "json", "csv"};
  return names[static_cast<std::size_t>(format)];
}

namespace {

/// One of those expected, or an InputError that says what was found instead.
Format chosen(const std::string& name, const std::string& said, const std::string& found, std::span<const Format> expected) {
  std::string all;
  for (std::size_t k = 0; k < expected.size(); ++k) {
    if (name == name_of(expected[k]) || (name == "plt" && expected[k] == Format::hpgl)) return expected[k];
    all += std::string(k == 0 ? "" : k + 1 < expected.size() ? ", " : " or ") + "." + name_of(expected[k]);
  }
  throw InputError(said + ": found " + found + ", expected " + all);
}

std::string in_lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
  return text;
}

}  // namespace

Format format_of(const std::string& path, std::span<const Format> expected) {
  const auto slash = path.find_last_of('/');
  const std::string name = slash == std::string::npos ? path : path.substr(slash + 1);
  const auto dot = name.find_last_of('.');
  const std::string ending = in_lower_case(dot == std::string::npos ? "" : name.substr(dot + 1));
  return chosen(ending, path, ending.empty() ? "no ending" : "the ending ." + ending, expected);
}

Format format_named(const std::string& name, const std::string& said, std::span<const Format> expected) {
  return chosen(in_lower_case(name), said, "the format " + name, expected);
}

}  // namespace hsr::internal
