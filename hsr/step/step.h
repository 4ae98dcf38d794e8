#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "hsr/model.h"

namespace hsr {

namespace internal {
class PlacedShapes;
}

/// The surfaces of a STEP or IGES file, of which meshes of any accuracy are made. Copies are cheap and share everything.
class BrepModel {
 public:
  /// The diagonal of the box around it, in units of the model.
  double size() const;
  /// Millimetres in a unit of the model.
  double millimetres() const;

  /// A mesh of it.
  ///
  ///   (1) edges and faces are cut into chords that are no farther from them than `chord`, as Open CASCADE measures that
  ///   (2) faces that share an edge share its points, bit by bit, so that closed shells are closed
  ///   (3) `face_surface` is the face of the B-rep that each triangle is of; `marks` are its edges: smooth where two faces have one
  ///       tangent plane along it, to half a degree, sharp where they have not; a seam is sharp or nothing
  ///   (4) each instance of a part is an object, named by its path in the assembly; a second one of a name is "name [2]"
  ///   (5) coordinates are in the unit of the file where that is one of hsr's, else in millimetres, and rounded to multiples of a power
  ///       of two of at most 2^-36 of the largest one
  ///   (6) the same for any number of threads
  ///
  /// @pre 0 < chord, in units of the model
  /// @throws InputError if there is nothing to draw, or more than 32 bits count
  Model tessellated(double chord) const;

 private:
  friend BrepModel read_brep(const std::string& path);
  friend BrepModel read_brep(const std::string& path, std::string_view bytes);
  explicit BrepModel(std::shared_ptr<const internal::PlacedShapes> shapes) : shapes_(std::move(shapes)) {}

  std::shared_ptr<const internal::PlacedShapes> shapes_;
};

/// Whether a file is STEP or IGES: by its content, where there is some, or else by its ending.
bool is_brep(const std::string& path, std::string_view bytes = {});

/// Reads a file of these.
/// @throws InputError in one line: the file, what was found and what was expected
BrepModel read_brep(const std::string& path);
/// The same of its bytes in memory; `path` is the name for messages.
/// @throws InputError as above; also of IGES, which is read from files only
BrepModel read_brep(const std::string& path, std::string_view bytes);

}  // namespace hsr
