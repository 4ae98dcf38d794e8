#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/mesh.h"
#include "hsr/lines/line_options.h"
#include "hsr/symbols/cut.h"
#include "hsr/symbols/map_point.h"
#include "hsr/tiles/model_part.h"

namespace hsr::internal {

constexpr std::uint32_t no_number = 0xffffffffU;

/// A triangle by the number of its face in the whole model, and which of the face's triangles it is.
struct NamedTriangle {
  std::uint32_t face = no_number, triangle = 0;
  friend bool operator==(const NamedTriangle&, const NamedTriangle&) = default;
};

/// A Cut that means the same in every part of a model: u and v are numbers of points in the whole, or the triangle u of face v. Of a side
/// of tiles u is no_number, and v the side.
struct NamedCut {
  Cut::Kind kind = Cut::Kind::start;
  std::uint8_t axis = 0;
  std::uint32_t u = 0, v = 0;

  bool is_side() const { return kind == Cut::Kind::sight && u == no_number; }
};

/// What of a line lies in one tile.
struct LinePiece {
  bool is_ghost = false, is_behind = false, starts_hidden = false;
  bool is_only_bound = false;  ///< not drawn: it tells how large the drawing is
  EdgeClass edge_class = EdgeClass::smooth;
  bool goes_on_before = false, goes_on_after = false;  ///< a side of the tile cuts it off there
  std::uint32_t a = no_number, b = no_number;          ///< the edge, by its points; no numbers: an intersection
  NamedTriangle s, t;                                  ///< of an intersection, the facets, by their first triangles
  NamedCut meet_from, meet_to;
  std::uint32_t first_cut = 0, end_cut = 0;

  bool is_intersection() const { return a == no_number; }
};

/// Lines in pieces and fragments of faces, and what of the model these need to be understood.
struct TilePart {
  std::uint32_t tile = 0;
  ModelPart model;
  std::vector<LinePiece> pieces;
  std::vector<NamedCut> cuts;
  std::string fragments;    ///< of the faces that are seen there, by name: see tile_fragments.h
  std::uint64_t pairs = 0;  ///< edge-triangle pairs that were tested
};

/// Tells the names of a part of a model from those in the mesh that was made of it.
class Names {
 public:
  /// @param mesh of the part's model, with two more points for each side of the tiles at the end @pre both outlive this
  Names(const ModelPart& part, const Mesh& mesh)
      : part_(part), mesh_(mesh), first_side_point_(static_cast<std::uint32_t>(part.points.size())) {}

  /// The view plane of a side.
  Cut side(std::uint32_t k) const { return {Cut::Kind::sight, 0, first_side_point_ + 2 * k, first_side_point_ + 2 * k + 1}; }

  /// A number of a side that was read. @throws InputError where there is no such side
  std::uint32_t checked_side(std::uint32_t k) const;
  /// Its line in the map, and which side of tiles a line is.
  MapLine side_line(std::uint32_t k) const {
    return {MapLine::Kind::edge, first_side_point_ + 2 * k, first_side_point_ + 2 * k + 1};
  }
  std::optional<std::uint32_t> side_of(const MapLine& line) const {
    if (line.kind != MapLine::Kind::edge || line.u < first_side_point_) return {};
    return (line.u - first_side_point_) / 2;
  }

  std::uint32_t number(VertexId v) const { return part_.points[v.value]; }
  NamedTriangle name(TriangleId t) const;
  NamedCut name(const Cut& cut) const;
  /// @throws InputError where the part has no such thing
  VertexId vertex(std::uint32_t number) const;
  TriangleId triangle(const NamedTriangle& name) const;
  Cut cut(const NamedCut& name) const;

 private:
  bool is_side(const Cut& cut) const { return cut.kind == Cut::Kind::sight && cut.u >= first_side_point_; }

  const ModelPart& part_;
  const Mesh& mesh_;
  std::uint32_t first_side_point_;
};

}  // namespace hsr::internal
