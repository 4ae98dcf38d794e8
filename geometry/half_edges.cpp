#include "geometry/half_edges.h"

namespace hsr::internal {

void HalfEdges::reserve(std::size_t triangles) {
  origin_.reserve(3 * triangles);
  twin_.reserve(3 * triangles);
  edge_.reserve(3 * triangles);
  half_of_.reserve(3 * triangles / 2 + 3);
}

void HalfEdges::link(Half h, Half g, std::uint32_t edge) {
  twin_[h] = g;
  edge_[h] = edge;
  half_of_[edge] = h;
  if (g == none) return;
  twin_[g] = h;
  edge_[g] = edge;
}

std::uint32_t HalfEdges::new_edge() {
  half_of_.push_back(none);
  return static_cast<std::uint32_t>(half_of_.size() - 1);
}

HalfEdges::Half HalfEdges::add_triangle(Vertex a, Vertex b, Vertex c) {
  const auto h = static_cast<Half>(origin_.size());
  origin_.insert(origin_.end(), {a, b, c});
  twin_.insert(twin_.end(), 3, none);
  edge_.insert(edge_.end(), 3, none);
  for (Half k = 0; k < 3; ++k) half_at_[origin_[h + k]] = h + k;
  return h;
}

void HalfEdges::glue(Half h, Half g) { link(h, g, new_edge()); }

void HalfEdges::split(Half h, Vertex v, Half& second, Half& third) {
  const Half bc = next(h), ca = previous(h);
  const Vertex a = origin_[h], b = origin_[bc], c = origin_[ca];
  second = add_triangle(b, c, v);
  third = add_triangle(c, a, v);
  link(second, twin_[bc], edge_[bc]);
  link(third, twin_[ca], edge_[ca]);
  origin_[ca] = v;
  link(bc, previous(second), new_edge());
  link(ca, next(third), new_edge());
  link(next(second), previous(third), new_edge());
}

void HalfEdges::flip(Half h) {
  const Half g = twin_[h], h2 = previous(h), g2 = previous(g);
  const Vertex u = origin_[h], w = origin_[g];
  const std::uint32_t diagonal = edge_[h];
  const Half beyond_h2 = twin_[h2], beyond_g2 = twin_[g2];
  const std::uint32_t edge_h2 = edge_[h2], edge_g2 = edge_[g2];
  origin_[h] = origin_[g2];
  origin_[g] = origin_[h2];
  link(h, beyond_g2, edge_g2);
  link(g, beyond_h2, edge_h2);
  link(h2, g2, diagonal);
  half_at_[u] = next(g);
  half_at_[w] = next(h);
}

}  // namespace hsr::internal
