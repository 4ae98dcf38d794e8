#include "hsr/painter/sort/image_bsp.h"

#include <algorithm>
#include <array>

namespace hsr::internal {

namespace {

enum class Where { far, near, in_plane, both };

class Divider {
 public:
  explicit Divider(MapPredicates& map) : map_(map), projected_(map.projected()) {}

  /// Where a piece lies as seen from the plane of a facet.
  Where where(const PieceOfFacet& piece, FacetId plane) {
    if (piece.facet == plane) return Where::in_plane;
    const auto& c = map_.mesh().triangles[first_triangle(plane)];
    bool near = false, far = false;
    for (const MapPoint& p : piece.shape.points) {
      Sign nearer = Sign::zero;
      if (!p.is_vertex)
        nearer = map_.nearer(piece.facet, plane, p);
      else if (p.vertex != c[0] && p.vertex != c[1] && p.vertex != c[2])
        nearer = projected_.side(projected_.face_plane(plane), p.vertex, map_.exact()) * projected_.facing(plane);
      near = near || nearer == Sign::positive;
      far = far || nearer == Sign::negative;
    }
    return near && far ? Where::both : near ? Where::near : far ? Where::far : Where::in_plane;
  }

  /// The part of the piece before the plane, of one that it passes through; what is behind it stays.
  PieceOfFacet cut_off_near(PieceOfFacet& piece, FacetId plane) {
    piece.near.clear();  // of what it was
    const MapLine meet = MapLine::meet(piece.facet, plane);
    const Sign nearer = projected_.facing(piece.facet) * projected_.facing(plane);
    const Sign inner = meet.u == piece.facet.value ? nearer : -nearer;  // of where the piece is the nearer one
    auto front = cut(map_, piece.shape, {meet, -inner});
    if (!front) throw InvariantError("image_bsp: a plane passes through a piece and does not cut it");
    return {piece.facet, std::move(*front)};
  }

  /// Of a few facets the one whose plane cuts little and divides evenly.
  FacetId choose(std::span<const PieceOfFacet> pieces) {
    constexpr std::size_t candidates = 8, tested = 64;
    FacetId best;
    std::size_t best_score = ~std::size_t{0};
    for (std::size_t i = 0; i < std::min(candidates, pieces.size()); ++i) {
      const FacetId plane = pieces[i * pieces.size() / std::min(candidates, pieces.size())].facet;
      std::array<std::size_t, 4> count = {0, 0, 0, 0};
      for (std::size_t k = 0; k < std::min(tested, pieces.size()); ++k)
        ++count[static_cast<std::size_t>(where(pieces[k * pieces.size() / std::min(tested, pieces.size())], plane))];
      const auto [far, near, in_plane, both] = count;
      const std::size_t score = 4 * both + (far > near ? far - near : near - far);
      if (score < best_score) {
        best = plane;
        best_score = score;
      }
    }
    return best;
  }

 private:
  MapPredicates& map_;
  const ProjectedMesh& projected_;
};

}  // namespace

std::vector<PieceOfFacet> ordered_by_planes(MapPredicates& map, std::vector<PieceOfFacet> pieces,
                                            const std::function<void()>& before_cut) {
  Divider divider(map);
  std::vector<PieceOfFacet> done;
  std::vector<std::vector<PieceOfFacet>> waiting;  // the farthest last
  waiting.push_back(std::move(pieces));
  while (!waiting.empty()) {
    std::vector<PieceOfFacet> all = std::move(waiting.back());
    waiting.pop_back();
    if (all.empty()) continue;
    if (all.size() == 1) {
      done.push_back(std::move(all.front()));
      continue;
    }
    const FacetId plane = divider.choose(all);
    std::vector<PieceOfFacet> far, near, in_plane;
    for (PieceOfFacet& piece : all) {
      switch (divider.where(piece, plane)) {
        case Where::both:
          before_cut();
          near.push_back(divider.cut_off_near(piece, plane));
          [[fallthrough]];
        case Where::far:
          far.push_back(std::move(piece));
          break;
        case Where::near:
          near.push_back(std::move(piece));
          break;
        case Where::in_plane:
          in_plane.push_back(std::move(piece));
          break;
      }
    }
    if (far.empty() && near.empty()) {
      // Coplanar pieces: of two that overlap the one on top comes last.
      const TieRule ties = map.projected().ties();
      std::stable_sort(in_plane.begin(), in_plane.end(),
                       [&](const PieceOfFacet& x, const PieceOfFacet& y) { return ties.is_above(y.facet, x.facet); });
      std::move(in_plane.begin(), in_plane.end(), std::back_inserter(done));
      continue;
    }
    waiting.push_back(std::move(near));
    waiting.push_back(std::move(in_plane));
    waiting.push_back(std::move(far));
  }
  return done;
}

}  // namespace hsr::internal
