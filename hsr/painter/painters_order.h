#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "geometry/mesh.h"
#include "geometry/number.h"
#include "geometry/predicates.h"
#include "hsr/symbols/cut.h"
#include "hsr/view/view.h"

namespace hsr {

/// A corner of a piece, and the side that leaves it. Never a rounded number: on the plane of the piece's facet.
struct PieceCorner {
  VertexId vertex;  ///< whose place the corner is; not valid: where the planes of the cuts a and b meet the facet's
  Cut a, b;
  Cut side;               ///< the plane of the side from here to the next corner
  bool original = false;  ///< that side lies on an edge of the face: it may be drawn
};

/// A convex part of a face, counter-clockwise as seen.
struct OrderedPiece {
  FacetId facet;  ///< the planar piece of the face that it lies in
  std::uint32_t first_corner = 0, end_corner = 0;
};

/// A part of a wire among the pieces of an order.
struct OrderedWire {
  EdgeId edge;
  Rational from = 0.0, to = 1.0;  ///< parameters along the edge, 0 at its first vertex: exact, and ascending
  std::uint32_t before = 0;       ///< the piece that is painted just after it; the number of pieces: none is
};

/// Convex pieces from far to near (docs/conventions.md, "Painter's order").
struct PaintersOrder {
  std::vector<OrderedPiece> pieces;
  std::vector<PieceCorner> corners;
  std::vector<OrderedWire> wires;  ///< ascending by `before`, then by edge and along it
  DecisionCounts decisions;

  std::span<const PieceCorner> corners_of(const OrderedPiece& p) const {
    return {corners.data() + p.first_corner, corners.data() + p.end_corner};
  }
};

/// The corner in space, exactly.
/// @throws PreconditionError if its planes meet in no single point: a corner of another mesh or view
std::array<Rational, 3> exact_point(const Mesh& mesh, const View& view, FacetId facet, const PieceCorner& corner);

/// The ends of a part of a wire in space, exactly.
std::array<std::array<Rational, 3>, 2> exact_ends(const Mesh& mesh, const OrderedWire& wire);

}  // namespace hsr
