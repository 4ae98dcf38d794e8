#pragma once

#include <map>
#include <string>

#include "hsr/model.h"
#include "hsr/step/placed_shapes.h"
#include "hsr/step/shape_mesh.h"

namespace hsr::internal {

/// Puts a model together of instances of meshes.
class PartBuilder {
 public:
  PartBuilder(const std::string& path, const std::string& format);

  void add(const PlacedShape& part, const DefinedShape& definition, const ShapeMesh& mesh);
  /// @throws InputError if nothing can be drawn
  Model finish();

 private:
  void add_geometry(const PlacedShape& part, const ShapeMesh& mesh);
  void add_known_shapes(const PlacedShape& part, const ShapeMesh& mesh);
  void add_colours(const PlacedShape& part, const DefinedShape& definition, const ShapeMesh& mesh);

  Model model_;
  std::map<Colour, std::uint32_t> palette_;
  std::size_t faces_without_mesh_ = 0;
  bool is_rounded_ = false;  // a part is placed other than where it was defined
};

}  // namespace hsr::internal
