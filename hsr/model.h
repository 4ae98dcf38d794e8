#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "geometry/mesh.h"
#include "hsr/face_labels.h"

namespace hsr {

/// Red, green, blue, opacity, each 0 ... 255.
using Colour = std::array<std::uint8_t, 4>;

/// What a file says, before anything is merged, dropped or cut.
struct Model {
  std::string name;    ///< for messages
  std::string format;  ///< "OBJ", "PLY binary little-endian", "STL ascii", ... gzip said too
  std::vector<Point3> points;
  Polygons polygons;
  std::vector<Colour> palette;               ///< the colours in use; empty: the file has none
  std::vector<std::uint32_t> face_colour;    ///< index into palette for each face; empty like palette. 0xffffffff: none
  std::vector<std::string> objects;          ///< names of objects or groups, by first use
  std::vector<std::uint32_t> face_object;    ///< index into objects for each face; empty if objects is
  std::vector<std::string> materials;        ///< names of materials, by first use; empty: the file names none
  std::vector<std::uint32_t> face_material;  ///< index into materials for each face; empty like materials. 0xffffffff: none
  std::vector<std::string> notes;            ///< what the reader passed over or repaired, one line each
};

/// Which object each face belongs to, and of which material it is: what the file names, or, in a file that names no material, the
/// colours of its faces if they are at most 16. More are a colour map, which has no borders of material.
FaceLabels labels_of(const Model& model);

}  // namespace hsr
