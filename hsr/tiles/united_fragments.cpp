#include "hsr/tiles/united_fragments.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <span>

#include "geometry/error.h"
#include "geometry/ragged.h"
#include "hsr/surfaces/fragment_parts.h"
#include "hsr/tiles/tile_fragments.h"
#include "hsr/tiles/tile_mismatch.h"
#ifdef HSR_CHECKS
#include "hsr/surfaces/fragment_invariants.h"
#endif

namespace hsr::internal {

namespace {

/// What one tile has of a facet: some whole fragments, or sides.
struct PieceOfFacet {
  std::uint32_t part, begin, end;  // whole: numbers of fragments; else the number of a row of sides, twice
  bool is_whole() const { return begin < end; }
};

/// What all tiles have of each facet, by its first triangle.
Ragged<PieceOfFacet> pieces_by_facet(const std::vector<TileFragments>& tiles, std::size_t triangles) {
  Ragged<PieceOfFacet> pieces;
  pieces.assign(triangles, [&](const auto& add) {
    for (std::uint32_t p = 0; p < tiles.size(); ++p) {
      const std::vector<Fragment>& all = tiles[p].whole.fragments;
      for (std::uint32_t i = 0, end = 0; i < all.size(); i = end) {
        while (end < all.size() && all[end].facet == all[i].facet) ++end;
        add(all[i].facet.value, {p, i, end});
      }
      for (std::uint32_t row = 0; row < tiles[p].facets.size(); ++row) add(tiles[p].facets[row].value, {p, row, row});
    }
  });
  return pieces;
}

/// Links what several tiles have of a facet. One object per block of facets.
class FragmentUniter {
 public:
  FragmentUniter(const std::vector<TilePart>& parts, const std::vector<TileFragments>& tiles, const Names& names,
                 const ProjectedMesh& projected)
      : parts_(parts), tiles_(tiles), names_(names), map_(projected), linker_(map_) {}

  void add(FacetId facet, std::span<const PieceOfFacet> pieces, FragmentParts& to) {
    if (pieces.size() == 1 && pieces.front().is_whole()) {
      const VisibleFragments& whole = tiles_[pieces.front().part].whole;
      for (std::uint32_t k = pieces.front().begin; k < pieces.front().end; ++k) to.add(whole, whole.fragments[k]);
      return;
    }
    sides_.clear();
    part_of_side_.clear();
    for (const PieceOfFacet& piece : pieces) add_sides(piece);
    const Rings& rings = linker_.link(sides_);
    for (const MapCorner& corner : rings.rings.values())
      if (names_.side_of(corner.line)) refuse(corner);
    to.add(facet, rings);
  }
  MapPredicates& map() { return map_; }

 private:
  void add_sides(const PieceOfFacet& piece) {
    const TileFragments& tile = tiles_[piece.part];
    some_.clear();
    for (std::uint32_t k = piece.begin; k < piece.end; ++k) append_sides(tile.whole, tile.whole.fragments[k], some_);
    if (!piece.is_whole()) some_.assign(tile.sides[piece.begin].begin(), tile.sides[piece.begin].end());
    for (const MapSide& side : some_) sides_.push_back({side, map_.place(side.from), map_.place(side.to)});
    part_of_side_.resize(sides_.size(), piece.part);
  }
  /// Names the tile whose side begins at the corner, or goes on there.
  [[noreturn]] void refuse(const MapCorner& corner) {
    for (std::size_t k = 0; k < sides_.size(); ++k) {
      const MapSide& side = sides_[k].side;
      if (side.line != corner.line || side.reversed != corner.reversed) continue;
      const Sign way = corner.reversed ? Sign::negative : Sign::positive;
      if (map_.order(side.line, side.from, corner.at) * way != Sign::positive &&
          map_.order(side.line, corner.at, side.to) * way == Sign::negative)
        throw TileMismatch(parts_[part_of_side_[k]].tile, "face");
    }
    throw InvariantError("tiles: a side of tiles that no tile has");
  }

  const std::vector<TilePart>& parts_;
  const std::vector<TileFragments>& tiles_;
  const Names& names_;
  MapPredicates map_;
  RingLinker linker_;
  std::vector<MapSide> some_;
  std::vector<PlacedSide> sides_;
  std::vector<std::uint32_t> part_of_side_;
};

}  // namespace

VisibleFragments united_fragments(std::vector<TilePart>& parts, const Names& names, const ProjectedMesh& projected) {
  if (std::ranges::all_of(parts, [](const TilePart& part) { return part.fragments.empty(); })) return {};
  std::vector<TileFragments> tiles(parts.size());
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t p) {
    tiles[p] = tile_fragments_of(parts[p].fragments, names);
    parts[p].fragments = std::string();
  });
  const Ragged<PieceOfFacet> pieces = pieces_by_facet(tiles, projected.mesh().triangles.size());
  VisibleFragments all = fragments_in_blocks(
      projected.mesh(), {}, [&] { return FragmentUniter(parts, tiles, names, projected); },
      [&](FragmentUniter& uniter, FacetId facet, FragmentParts& to) {
        if (!pieces[facet.value].empty()) uniter.add(facet, pieces[facet.value], to);
      });
#ifdef HSR_CHECKS
  check_invariants(projected, all);
#endif
  return all;
}

}  // namespace hsr::internal
