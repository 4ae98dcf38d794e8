#pragma once

#include <cstdint>
#include <vector>

namespace hsr::internal {

/// Triangles glued side to side, which can be split and flipped. They know no coordinates.
///
/// Half-edge 3t + k is the side of triangle t from its corner k to the next; its twin is the same side of the neighbour, run the
/// other way. An edge keeps its number through every flip, its half-edges do not.
class HalfEdges {
 public:
  using Half = std::uint32_t;
  using Vertex = std::uint32_t;
  static constexpr std::uint32_t none = 0xffffffffU;

  explicit HalfEdges(std::size_t vertices) : half_at_(vertices, none) {}

  static Half next(Half h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Half previous(Half h) { return h % 3 == 0 ? h + 2 : h - 1; }

  std::size_t halves() const { return origin_.size(); }
  std::size_t edges() const { return half_of_.size(); }
  Vertex origin(Half h) const { return origin_[h]; }
  Vertex target(Half h) const { return origin_[next(h)]; }
  Vertex apex(Half h) const { return origin_[previous(h)]; }
  Half twin(Half h) const { return twin_[h]; }  ///< none on the border
  std::uint32_t edge(Half h) const { return edge_[h]; }
  Half half_of(std::uint32_t edge) const { return half_of_[edge]; }
  Half half_at(Vertex v) const { return half_at_[v]; }  ///< one that begins at v
  /// The next half-edge that begins where h does, counter-clockwise; none at the border.
  Half turned(Half h) const { return twin_[previous(h)]; }

  void reserve(std::size_t triangles);
  /// A triangle with a border all around. @returns its first half-edge
  Half add_triangle(Vertex a, Vertex b, Vertex c);
  /// Makes two sides at the border one edge.
  void glue(Half h, Half g);
  /// Cuts the triangle of h into three at v; afterwards the sides opposite to v are h and the two that are given.
  void split(Half h, Vertex v, Half& second, Half& third);
  /// Turns the diagonal h of two triangles. With the apex p of h and the apex d of its twin g: h becomes a side of d, w, p that
  /// was beyond it, and the side of the other triangle beyond p is next(g).
  /// @pre h has a twin
  void flip(Half h);

 private:
  void link(Half h, Half g, std::uint32_t edge);
  std::uint32_t new_edge();

  std::vector<Vertex> origin_;
  std::vector<Half> twin_;
  std::vector<std::uint32_t> edge_;
  std::vector<Half> half_of_, half_at_;
};

}  // namespace hsr::internal
