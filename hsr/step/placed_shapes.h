#pragma once

#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>
#include <cstddef>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "hsr/model.h"
#include "hsr/step/document.h"

namespace hsr::internal {

/// A shape as it was defined, which may be placed several times.
struct DefinedShape {
  TopoDS_Shape shape;  ///< without a location
  TopTools_IndexedMapOfShape faces;
  std::vector<std::optional<Colour>> colours;  ///< by face, its own
};

/// An instance of it.
struct PlacedShape {
  std::size_t definition = 0;
  TopLoc_Location location;
  std::string name;              ///< no two are alike
  std::optional<Colour> colour;  ///< of faces without their own
};

/// The parts of a document with their places, names and colours.
class PlacedShapes {
 public:
  /// @param path for messages
  PlacedShapes(std::string path, BrepDocument document);

  double size() const { return size_; }
  double millimetres() const { return document_.millimetres; }
  /// As BrepModel::tessellated().
  Model tessellated(double chord) const;

 private:
  void add_parts();
  std::size_t definition_of(const TDF_Label& label, const TopoDS_Shape& shape);
  std::string with_number(const std::string& name) const;
  void measure();

  std::string path_;
  BrepDocument document_;
  std::vector<DefinedShape> definitions_;
  std::vector<PlacedShape> parts_;
  double size_ = 0;
  mutable std::mutex mutex_;  // a mesh is kept in the shape that it is made of
};

}  // namespace hsr::internal
