#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "geometry/mesh.h"

namespace hsr {

/// Red, green, blue, opacity, each 0 ... 255.
using Colour = std::array<std::uint8_t, 4>;

/// What a file says, before anything is merged, dropped or cut.
struct Model {
  std::string name;    ///< for messages
  std::string format;  ///< "OBJ", "PLY binary little-endian", "STL ascii", ... gzip said too
  std::vector<Point3> points;
  Polygons polygons;
  std::vector<Colour> palette;             ///< the colours in use; empty: the file has none
  std::vector<std::uint32_t> face_colour;  ///< index into palette for each face; empty like palette. 0xffffffff: none
  std::vector<std::string> objects;        ///< names of objects or groups, by first use
  std::vector<std::uint32_t> face_object;  ///< index into objects for each face; empty if objects is
  std::vector<std::string> notes;          ///< what the reader passed over or repaired, one line each
};

}  // namespace hsr
