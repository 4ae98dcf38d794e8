#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hsr/io/read/gltf_file.h"

namespace hsr::internal::read {

/// The elements of an accessor, checked against its buffers. Of a sparse one the elements as they are in the end.
class GltfAccessor {
 public:
  /// @param components 1 for indices, 2 to 4 for vectors
  /// @param what for messages
  /// @throws InputError for what is no accessor of that many components
  GltfAccessor(const Source& source, const tinygltf::Model& model, int accessor, int components, const std::string& what);
  GltfAccessor(const GltfAccessor&) = delete;
  GltfAccessor& operator=(const GltfAccessor&) = delete;

  std::size_t size() const { return count_; }
  std::uint32_t index(std::size_t i) const { return index_at(data_ + i * stride_, type_); }
  /// Component `c` of element `i`; normalised integers are divided by their largest value and rounded once.
  double number(std::size_t i, int c) const;

 private:
  struct Elements {
    const unsigned char* data;
    std::size_t stride;
  };

  [[noreturn]] void refuse(const std::string& found, const std::string& expected) const;
  void check_type(const tinygltf::Accessor& a, int components) const;
  Elements elements(int view, std::size_t offset, std::size_t size, std::size_t count, const std::string& name) const;
  void replace_sparse(const tinygltf::Accessor& a, std::size_t element);
  static std::uint32_t index_at(const unsigned char* p, int type);

  const Source& source_;
  const tinygltf::Model& model_;
  std::string what_, name_;
  const unsigned char* data_ = nullptr;
  std::size_t stride_ = 0, count_ = 0;
  int type_ = 0;
  bool normalised_ = false;
  std::vector<unsigned char> replaced_;  // all elements of a sparse one
};

/// How many components the elements of an accessor have: 3 of a VEC3; 0 if there is no such accessor.
int components_of(const tinygltf::Model& model, int accessor);

}  // namespace hsr::internal::read
