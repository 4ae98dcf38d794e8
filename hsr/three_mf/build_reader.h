#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "hsr/io/read/model_builder.h"
#include "hsr/io/read/source.h"
#include "hsr/three_mf/lib3mf_handle.h"

namespace hsr::internal {

/// A turn and a move: a point's coordinates are the sums of the first three rows, times the point's, and the last.
using Placement3mf = std::array<std::array<double, 3>, 4>;

/// Puts together what the build of a 3MF model names: objects, their components, and so on down to meshes.
class BuildReader {
 public:
  /// @param millimetres what coordinates are multiplied by; 1: they stay
  BuildReader(const read::Source& source, const Lib3mfHandle& model, read::ModelBuilder& builder, double millimetres)
      : source_(source), model_(model), builder_(builder), millimetres_(millimetres) {}

  /// @throws InputError
  void read();

 private:
  void add_object(const Lib3mfHandle& object, const Placement3mf& at, const std::string& parent, int depth);
  void add_mesh(const Lib3mfHandle& mesh, const Placement3mf& at, const std::string& name);
  void add_triangles(const Lib3mfHandle& mesh, std::uint32_t first_point, std::uint32_t points);
  void set_property(const Lib3mfHandle& of_triangles, const Lib3mfHandle& of_object, std::uint32_t triangle);
  void set_base_material(std::uint32_t group, std::uint32_t index);
  std::string name_of(const Lib3mfHandle& object);
  /// @throws InputError where a function of lib3mf's did not do what it was asked for
  void check(LIB3MFRESULT result) const;
  void note_left_out();

  const read::Source& source_;
  const Lib3mfHandle& model_;
  read::ModelBuilder& builder_;
  double millimetres_;
  std::size_t instances_ = 0, supports_ = 0, beams_ = 0, textured_ = 0;
  bool is_rounded_ = false;  // something is turned or moved
};

}  // namespace hsr::internal
