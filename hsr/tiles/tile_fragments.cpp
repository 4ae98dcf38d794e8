#include "hsr/tiles/tile_fragments.h"

#include <algorithm>
#include <span>
#include <utility>

#include "hsr/scene/facet.h"
#include "hsr/scene/view_parts.h"
#include "hsr/surfaces/fragment_parts.h"
#include "hsr/surfaces/map_clipper.h"

namespace hsr::internal {

namespace {

class FragmentClipper {
 public:
  FragmentClipper(const SceneView& scene, const std::vector<TileBound>& bounds, const Names& names)
      : map_(scene.parts().projected()), clipper_(map_), bounds_(bounds) {
    for (const TileBound& b : bounds_) {
      const MapLine line = names.side_line(b.side);
      lines_.push_back(line);
      planes_.push_back(map_.projected().sight_plane(VertexId(line.u), VertexId(line.v)));
    }
  }

  void add(const VisibleFragments& all, std::span<const Fragment> of_facet) {
    const FacetId facet = of_facet.front().facet;
    sides_.clear();
    for (std::size_t k = 0; k < bounds_.size(); ++k) {
      const Reach reach = reach_of(facet, k);
      if (reach == Reach::beyond) return;
      if (reach == Reach::within) continue;
      if (sides_.empty())
        for (const Fragment& f : of_facet) append_sides(all, f, sides_);
      clipper_.keep(lines_[k], bounds_[k].kept, sides_);
      if (sides_.empty()) return;
    }
    if (sides_.empty()) {
      for (const Fragment& f : of_facet) whole_.add(all, f);
      return;
    }
    found_.facets.push_back(facet);
    found_.sides.push_row(sides_);
  }
  TileFragments take() {
    found_.whole = std::move(whole_.found);
    return std::move(found_);
  }

 private:
  enum class Reach { within, across, beyond };

  Reach reach_of(FacetId facet, std::size_t bound) {
    const Mesh& mesh = map_.mesh();
    bool is_kept = true, is_beyond = true;
    for (TriangleId t = first_triangle(facet); t < facet_end(mesh, facet); t = TriangleId(t.value + 1U))
      for (const VertexId v : mesh.triangles[t]) {
        const Sign s = map_.projected().side(planes_[bound], v, map_.exact()) * bounds_[bound].kept;
        is_kept = is_kept && s != Sign::negative;
        is_beyond = is_beyond && s != Sign::positive;
      }
    return is_kept ? Reach::within : is_beyond ? Reach::beyond : Reach::across;
  }
  MapPredicates map_;
  MapClipper clipper_;
  const std::vector<TileBound>& bounds_;
  std::vector<MapLine> lines_;
  std::vector<Plane> planes_;
  std::vector<MapSide> sides_;
  FragmentParts whole_;
  TileFragments found_;
};

}  // namespace

TileFragments fragments_in_tile(const SceneView& scene, const VisibleFragments& found, const std::vector<TileBound>& bounds,
                                const Names& names) {
  FragmentClipper clipper(scene, bounds, names);
  const std::span all(found.fragments);
  for (std::size_t i = 0, end = 0; i < all.size(); i = end) {
    while (end < all.size() && all[end].facet == all[i].facet) ++end;
    clipper.add(found, all.subspan(i, end - i));
  }
  return clipper.take();
}

}  // namespace hsr::internal
