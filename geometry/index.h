#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "geometry/error.h"

namespace hsr {

/// A number that counts one kind of thing: a VertexId is no FaceId.
template <class Tag>
struct Index {
  std::uint32_t value = 0xffffffffU;

  constexpr Index() = default;
  constexpr explicit Index(std::size_t v) : value(static_cast<std::uint32_t>(v)) {}
  constexpr bool is_valid() const { return value != 0xffffffffU; }
  friend constexpr auto operator<=>(Index, Index) = default;
};

using VertexId = Index<struct VertexTag>;      ///< a point of the model, in file order
using FaceId = Index<struct FaceTag>;          ///< a face of the model, in file order
using TriangleId = Index<struct TriangleTag>;  ///< a triangle of the faces as used
/// A planar face, or one triangle of a face that is cut: counted by its first triangle, but no triangle.
using FacetId = Index<struct FacetTag>;
using EdgeId = Index<struct EdgeTag>;  ///< an edge of the mesh, sorted by its vertices

/// The first of the facet's triangles: it is in the facet's plane, and all of them are of one face.
constexpr TriangleId first_triangle(FacetId facet) { return TriangleId(facet.value); }

/// @throws InputError if `n` things are too many for an index, one value of which stands for none
inline void check_countable(std::size_t n, const char* things) {
  if (n >= 0xffffffffU)
    throw InputError("fewer than 2^32 - 1 " + std::string(things) + " expected, found " + std::to_string(n));
}

/// A vector that one kind of index addresses.
template <class Id, class T>
class IndexedVector : public std::vector<T> {
 public:
  using std::vector<T>::vector;
  T& operator[](Id id) { return std::vector<T>::operator[](id.value); }
  const T& operator[](Id id) const { return std::vector<T>::operator[](id.value); }
};

}  // namespace hsr
