#include "hsr/scene/repeated_triangles.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace hsr::internal {

namespace {

/// Ascending corners, and the sides that are edges of the mesh as bits: side k is opposite to the k-th of them.
struct Look {
  std::array<VertexId, 3> corners;
  std::uint8_t edges;

  friend bool operator==(const Look&, const Look&) = default;
  friend bool operator<(const Look& x, const Look& y) {
    return x.corners != y.corners ? x.corners < y.corners : x.edges < y.edges;
  }
};

std::array<VertexId, 3> ascending_corners(const Mesh& mesh, TriangleId t) {
  std::array<VertexId, 3> corners = mesh.triangles[t];
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// Whether two of the triangles at an edge have the same third corner.
bool may_have_repeated(const Mesh& mesh, EdgeId e) {
  const auto own = mesh.triangles_at(e);
  if (own.size() != 2) return own.size() > 2;
  return mesh.apex(own[0], mesh.edges[e]) == mesh.apex(own[1], mesh.edges[e]);
}

}  // namespace

RepeatedTriangles::RepeatedTriangles(const Mesh& mesh) {
  std::vector<TriangleId> candidates;
  for (std::size_t e = 0; e < mesh.edges.size(); ++e)
    if (may_have_repeated(mesh, EdgeId(e)))
      for (const TriangleId t : mesh.triangles_at(EdgeId(e))) candidates.push_back(t);
  if (candidates.empty()) return;
  std::sort(candidates.begin(), candidates.end());
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
  std::vector<std::uint8_t> edges(mesh.triangles.size(), 0);
  for (std::size_t e = 0; e < mesh.edges.size(); ++e)
    for (const TriangleId t : mesh.triangles_at(EdgeId(e))) {
      const auto corners = ascending_corners(mesh, t);
      const VertexId apex = mesh.apex(t, mesh.edges[EdgeId(e)]);
      edges[t.value] |= static_cast<std::uint8_t>(1U << (std::find(corners.begin(), corners.end(), apex) - corners.begin()));
    }
  std::vector<std::pair<Look, TriangleId>> looks;
  looks.reserve(candidates.size());
  for (const TriangleId t : candidates) looks.push_back({{ascending_corners(mesh, t), edges[t.value]}, t});
  std::sort(looks.begin(), looks.end(),
            [](const auto& x, const auto& y) { return x.first == y.first ? x.second < y.second : x.first < y.first; });
  for (std::size_t i = 1, first = 0; i < looks.size(); ++i) {
    if (!(looks[i].first == looks[first].first)) {
      first = i;
      continue;
    }
    if (first_.empty())
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t) first_.emplace_back(t);
    first_[looks[i].second.value] = looks[first].second;
  }
}

}  // namespace hsr::internal
