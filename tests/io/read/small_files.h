#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace hsr::test {

/// A file that is written nowhere: its name, for the ending, and its bytes.
struct SmallFile {
  std::string name;
  std::string bytes;
};

/// The number as `n` bytes.
std::string little(std::uint64_t x, int n);
std::string big(std::uint64_t x, int n);
std::string little_float(float x);
std::string big_float(float x);

std::string gzipped(const std::string& bytes);
std::string base64(const std::string& bytes);
std::string glb(std::string json, std::string binary);
/// A binary STL of these coordinates, nine for each triangle.
std::string binary_stl(const std::vector<float>& coordinates, const std::string& header = "made by a test");

/// Two triangles of the unit square, one file in each format and way of writing: all of them can be read.
std::vector<SmallFile> small_files();

}  // namespace hsr::test
