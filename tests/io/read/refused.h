#pragma once

#include <catch2/catch.hpp>
#include <string>

#include "geometry/error.h"
#include "hsr/io/read/read.h"

namespace hsr::test {

/// The message with which these bytes are refused; empty if they are read.
inline std::string refusal(const std::string& name, const std::string& bytes) {
  try {
    (void)read_model(name, bytes);
    return {};
  } catch (const InputError& e) {
    return e.what();
  }
}

/// The same of a file on disk.
inline std::string file_refusal(const std::string& path) {
  try {
    (void)read_model(path);
    return {};
  } catch (const InputError& e) {
    return e.what();
  }
}

inline std::vector<std::uint32_t> corners(const Model& m, std::size_t face) {
  const auto c = m.polygons[face];
  return {c.begin(), c.end()};
}

}  // namespace hsr::test
