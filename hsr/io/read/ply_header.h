#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hsr/io/read/source.h"

namespace hsr::internal::read {

enum class PlyScalar : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t size_of(PlyScalar type);
bool is_float(PlyScalar type);

struct PlyProperty {
  std::string name;
  PlyScalar type = PlyScalar::float32;
  bool is_list = false;
  PlyScalar count_type = PlyScalar::uint8;  ///< of a list
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  /// -1 if there is none.
  int find(std::string_view property, bool list) const;
  bool has_lists() const;
  /// The least number of bytes of one row.
  std::size_t least_size(bool ascii) const;
};

enum class PlyFormat { ascii, little_endian, big_endian };

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;
  std::size_t body = 0;  ///< the first byte behind the header
};

/// @throws InputError also if the rows that an element counts cannot fit into the file
PlyHeader read_ply_header(const Source& source);

}  // namespace hsr::internal::read
