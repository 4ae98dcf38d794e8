#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/mesh.h"
#include "hsr/face_labels.h"
#include "hsr/known_shapes.h"

namespace hsr {

/// Red, green, blue, opacity, each 0 ... 255.
using Colour = std::array<std::uint8_t, 4>;

/// A camera that a file stores.
struct StoredCamera {
  std::string name;
  Point3 position;
  Point3 direction;  ///< along which it looks
  Point3 up;
  std::optional<double> field_of_view;  ///< vertical, degrees; nothing: a parallel view
  std::optional<double> aspect_ratio;   ///< width to height, if the file says
  std::optional<double> near;           ///< the distance of the near plane, if the file says
};

/// What a file says, before anything is merged, dropped or cut.
struct Model {
  std::string name;    ///< for messages
  std::string format;  ///< "OBJ", "PLY binary little-endian", "STL ascii", ... gzip said too
  std::vector<Point3> points;
  Polygons polygons;
  std::vector<Colour> palette;                ///< the colours in use; empty: the file has none
  std::vector<std::uint32_t> face_colour;     ///< index into palette for each face; empty like palette. 0xffffffff: none
  std::vector<std::string> objects;           ///< names of objects or groups, by first use
  std::vector<std::uint32_t> face_object;     ///< index into objects for each face; empty if objects is
  std::vector<std::uint32_t> segment_object;  ///< as face_object, for each of the segments
  std::vector<std::string> materials;         ///< names of materials, by first use; empty: the file names none
  std::vector<std::uint32_t> face_material;   ///< index into materials for each face; empty like materials. 0xffffffff: none
  std::vector<std::uint32_t> face_surface;    ///< number of a surface for each face; empty: none known. 0xffffffff: of none
  std::vector<MarkedEdge> marks;       ///< edges of which more is known than the angle; object: an index into objects, else 0
  std::vector<KnownSurface> surfaces;  ///< by face_surface, where more is known of them; else empty
  std::vector<KnownCircle> circles;    ///< those that marks name
  std::optional<char> up_axis;         ///< 'y' where the format says which axis is up
  std::optional<double> unit;          ///< millimetres in a unit of the model, where the format says
  std::vector<StoredCamera> cameras;   ///< no two of one name
  std::vector<std::string> notes;      ///< what the reader passed over or repaired, one line each
};

/// Which object each face belongs to, and of which material it is: what the file names, or, in a file that names no material, the
/// colours of its faces if they are at most 16. More are a colour map, which has no borders of material.
FaceLabels labels_of(const Model& model);

/// The objects that the file tells apart; nothing where it has one or none.
/// @pre `mesh` was made of the model's points and polygons
SceneObjects objects_of(const Model& model, const Mesh& mesh);

}  // namespace hsr
