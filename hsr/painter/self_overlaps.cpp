#include "hsr/painter/self_overlaps.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "hsr/painter/piece_clipper.h"
#include "hsr/painter/sort/cluster_boxes.h"
#include "hsr/scene/facet.h"
#include "hsr/scene/view_parts.h"

namespace hsr::internal {

namespace {

using Corners = std::vector<PieceCorner>;

class SelfOverlaps {
 public:
  SelfOverlaps(const ProjectedMesh& projected, PaintersOrder& order)
      : projected_(projected), order_(order), clipper_(projected), left_(order.pieces.size()) {}

  void cut() {
    const Mesh& mesh = projected_.mesh();
    const auto face_of = [&](std::uint32_t piece) { return mesh.face_of[first_triangle(order_.pieces[piece].facet)]; };
    std::vector<std::uint32_t> pieces;  // of faces that cross themselves, by face
    for (std::uint32_t k = 0; k < order_.pieces.size(); ++k)
      if (mesh.faces[face_of(k)] == FaceUse::crosses_itself) pieces.push_back(k);
    std::stable_sort(pieces.begin(), pieces.end(), [&](std::uint32_t x, std::uint32_t y) { return face_of(x) < face_of(y); });
    for (std::size_t first = 0, end = 0; first < pieces.size(); first = end) {
      while (end < pieces.size() && face_of(pieces[end]) == face_of(pieces[first])) ++end;
      const std::span<const std::uint32_t> of_face = std::span(pieces).subspan(first, end - first);
      for (std::size_t k = 0; k < of_face.size(); ++k) cut_by_later(of_face[k], of_face.subspan(k + 1));
    }
  }

  /// The order of what is left.
  void finish() {
    PaintersOrder all;
    all.decisions = order_.decisions;
    all.decisions += clipper_.decisions();
    const auto add = [&](FacetId facet, std::span<const PieceCorner> corners) {
      const auto first = static_cast<std::uint32_t>(all.corners.size());
      all.corners.insert(all.corners.end(), corners.begin(), corners.end());
      all.pieces.push_back({facet, first, static_cast<std::uint32_t>(all.corners.size())});
    };
    for (std::size_t k = 0; k < order_.pieces.size(); ++k) {
      const OrderedPiece& piece = order_.pieces[k];
      if (!left_[k].is_cut) add(piece.facet, order_.corners_of(piece));
      for (const Corners& part : left_[k].parts) add(piece.facet, part);
    }
    check_countable(all.corners.size(), "corners of a painting order");
    order_ = std::move(all);
  }

 private:
  /// Of a piece that loses something.
  struct Left {
    bool is_cut = false;
    std::vector<Corners> parts;
  };

  void cut_by_later(std::uint32_t number, std::span<const std::uint32_t> later_pieces) {
    const OrderedPiece& piece = order_.pieces[number];
    const ImageBox box = projected_.box(first_triangle(piece.facet));
    const std::span<const PieceCorner> given = order_.corners_of(piece);
    std::vector<Corners> parts{Corners(given.begin(), given.end())};
    bool is_cut = false;
    for (const std::uint32_t k : later_pieces) {
      const OrderedPiece& later = order_.pieces[k];
      if (later.facet == piece.facet || !touch_in_image(projected_.box(first_triangle(later.facet)), box)) continue;
      find_borders(later);
      std::vector<Corners> outside;
      for (Corners& part : parts) is_cut |= add_outside(piece.facet, std::move(part), outside);
      parts = std::move(outside);
    }
    if (is_cut) left_[number] = {true, std::move(parts)};
  }

  /// The sides of a piece, and on which side of each it lies: that of any of its corners beside it.
  void find_borders(const OrderedPiece& piece) {
    borders_.clear();
    const std::span<const PieceCorner> corners = order_.corners_of(piece);
    for (const PieceCorner& c : corners) {
      PieceClipper::Border border = clipper_.border(c.side, Sign::positive);
      for (const PieceCorner& other : corners) {
        const Sign side = clipper_.side(border, piece.facet, other);
        if (side == Sign::zero) continue;
        border.kept = side;
        break;
      }
      borders_.push_back(border);
    }
  }

  /// What of a part is outside the borders, as convex parts. False: all of it is, and the part is one still.
  bool add_outside(FacetId facet, Corners part, std::vector<Corners>& all) {
    if (is_beside(facet, part)) {
      all.push_back(std::move(part));
      return false;
    }
    std::vector<Corners> outside;
    Corners inside = part;
    for (const PieceClipper::Border& border : borders_) {
      const PieceClipper::Border beyond{border.cut, border.plane, border.kept * Sign::negative};
      Corners cut_off = inside;
      if (clipper_.keep(beyond, facet, cut_off)) outside.push_back(std::move(cut_off));
      if (clipper_.keep(border, facet, inside)) continue;
      all.push_back(std::move(part));
      return false;
    }
    std::move(outside.begin(), outside.end(), std::back_inserter(all));
    return true;
  }

  /// Whether one of the borders has nothing of the part inside: so it is with most pairs.
  bool is_beside(FacetId facet, const Corners& part) {
    return std::any_of(borders_.begin(), borders_.end(), [&](const PieceClipper::Border& border) {
      return std::none_of(part.begin(), part.end(),
                          [&](const PieceCorner& c) { return clipper_.side(border, facet, c) == Sign::positive; });
    });
  }

  const ProjectedMesh& projected_;
  PaintersOrder& order_;
  PieceClipper clipper_;
  std::vector<Left> left_;  // by piece
  std::vector<PieceClipper::Border> borders_;
};

}  // namespace

void cut_self_overlaps(const SceneView& scene, PaintersOrder& order) {
  const auto& faces = scene.mesh().faces;
  if (std::find(faces.begin(), faces.end(), FaceUse::crosses_itself) == faces.end()) return;
  SelfOverlaps overlaps(scene.parts().projected(), order);
  overlaps.cut();
  overlaps.finish();
}

}  // namespace hsr::internal
