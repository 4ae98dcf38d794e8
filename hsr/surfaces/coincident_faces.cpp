#include "hsr/surfaces/coincident_faces.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "geometry/error.h"
#include "hsr/scene/view_parts.h"
#include "hsr/surfaces/shadow.h"

namespace hsr::internal {

namespace {

ImageBox common(const ImageBox& a, const ImageBox& b) {
  ImageBox both = a;
  for (std::size_t k = 0; k < 2; ++k) {
    both.low[k] = std::max(a.low[k], b.low[k]);
    both.high[k] = std::min(a.high[k], b.high[k]);
  }
  both.farthest = std::max(a.farthest, b.farthest);
  both.nearest = std::min(a.nearest, b.nearest);
  return both;
}

/// Looks at pairs of triangles. One object per block of them.
class CoincidenceFinder {
 public:
  CoincidenceFinder(const ProjectedMesh& projected, const Occluders& occluders, Coincidence which)
      : map_(projected), projected_(projected), occluders_(occluders), which_(which) {}

  /// Begins with other triangles s.
  void turn() { planes_.clear(); }
  /// Whether they are in one plane and have a part in common, one that is seen if that is asked for.
  bool coincide(TriangleId s, TriangleId t) {
    if (is_certainly_apart(s, t) || !map_.coplanar(s, t)) return false;
    std::vector<ConvexPiece> pieces = {convex_piece(projected_, s)};
    ConvexPiece& common_part = pieces.front();
    if (projected_.reaches_before_near(s)) cut(map_, common_part, beyond_near(projected_, s));
    for (std::size_t k = 0; k < 3 && !common_part.points.empty(); ++k)
      cut(map_, common_part, side_of_triangle(projected_, t, k));
    if (common_part.points.empty()) return false;
    return which_ == Coincidence::all || is_seen(pieces, s, t);
  }

 private:
  /// Whether doubles tell that t is not in the plane of s: most pairs go no farther.
  bool is_certainly_apart(TriangleId s, TriangleId t) {
    auto known = std::find_if(planes_.begin(), planes_.end(), [&](const auto& p) { return p.first == s; });
    if (known == planes_.end()) known = planes_.insert(known, {s, projected_.filter(projected_.face_plane(s))});
    const auto& corners = projected_.mesh().triangles[t];
    return std::any_of(corners.begin(), corners.end(),
                       [&](VertexId v) { return known->second(projected_.point(v)).is_certain(); });
  }

  bool is_seen(std::vector<ConvexPiece>& pieces, TriangleId s, TriangleId t) {
    occluders_.tree.visit(common(projected_.box(s), projected_.box(t)), [&](std::uint32_t i) {
      const TriangleId other = occluders_.triangles[i];
      if (map_.coplanar(other, s)) return true;
      shadow_on(projected_, other, s, false, shadow_);
      subtract(map_, pieces, shadow_);
      return !pieces.empty();
    });
    return !pieces.empty();
  }

  MapPredicates map_;
  const ProjectedMesh& projected_;
  const Occluders& occluders_;
  Coincidence which_;
  std::vector<MapHalfPlane> shadow_;
  std::vector<std::pair<TriangleId, PlaneFilter>> planes_;  // of a few triangles that are asked for in turns
};

}  // namespace

std::vector<FaceId> under_coincident_faces(const SceneView& scene, const std::vector<std::uint32_t>& kind, Coincidence which) {
  const Mesh& mesh = scene.mesh();
  require(kind.size() == mesh.faces.size(), "under_coincident_faces: the kind of each face expected");
  if (std::adjacent_find(kind.begin(), kind.end(), std::not_equal_to<>()) == kind.end()) return {};
  const ViewParts& parts = scene.parts();
  const ProjectedMesh& projected = parts.projected();
  const Occluders& occluders = parts.occluders(which == Coincidence::all ? Excluded::edge_on : Excluded::hidden_and_edge_on);
  constexpr std::size_t block = 32;
  const std::size_t leaves = occluders.tree.leaf_count();
  std::vector<std::vector<FaceId>> found((leaves + block - 1) / block);
  tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t at) {
    CoincidenceFinder finder(projected, occluders, which);
    BoxTree::PairSearch search;
    for (std::size_t leaf = at * block; leaf < std::min(leaves, (at + 1) * block); ++leaf) {
      finder.turn();
      occluders.tree.visit_pairs(static_cast<std::uint32_t>(leaf), search, [&](std::uint32_t i, std::uint32_t k) {
        const TriangleId s = occluders.triangles[i], t = occluders.triangles[k];
        const FaceId f = mesh.face_of[s], g = mesh.face_of[t];
        if (kind[f.value] != kind[g.value] && finder.coincide(s, t))
          found[at].push_back(projected.ties().is_above(f, g) ? g : f);
      });
    }
  });
  std::vector<FaceId> all;
  for (const std::vector<FaceId>& some : found) all.insert(all.end(), some.begin(), some.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

}  // namespace hsr::internal
