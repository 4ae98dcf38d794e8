#pragma once

#include "hsr/painter/painters_order.h"
#include "hsr/painter/sort/face_pieces.h"
#include "hsr/painter/sort/overlap.h"

namespace hsr::internal {

/// Appends a piece to an order.
void append(const Mesh& mesh, const PieceOfFacet& piece, PaintersOrder& order);
/// Appends a piece of faces.
void append(const ProjectedMesh& projected, const FacePieces& pieces, std::size_t piece, PaintersOrder& order);

}  // namespace hsr::internal
