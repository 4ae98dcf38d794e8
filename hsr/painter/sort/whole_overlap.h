#pragma once

#include <optional>
#include <vector>

#include "hsr/painter/sort/face_pieces.h"
#include "hsr/painter/sort/image_triangle.h"
#include "hsr/painter/sort/overlap.h"
#include "hsr/scene/line_filter.h"

namespace hsr::internal {

/// The relation of pieces that nothing has cut, which most are: Newell's tests as Overlaps has them, of vertices alone. One
/// object per thread.
///
/// A side that separates two images is looked for in floats with a proven bound first, among the sides of both, then in
/// doubles; predicates are asked where neither tells. Then depths, then planes. Exact: yes. Cost: a few signs of doubles
/// mostly, and no allocation.
class WholeOverlaps {
 public:
  /// @param images of image_triangles()
  WholeOverlaps(const ProjectedMesh& projected, const FacePieces& pieces, const ImageTriangles& images)
      : projected_(projected), pieces_(pieces), images_(images), exact_(projected.predicates()) {}

  /// Chooses the first piece of the pairs that follow. @pre nothing has cut it
  void turn_to(std::uint32_t piece);
  /// How the chosen piece and this one overlap; nothing: no plane of the two tells. @pre nothing has cut it
  std::optional<Overlap> relation(std::uint32_t piece);

  const OverlapCounts& counts() const { return counts_; }
  const DecisionCounts& decisions() const { return exact_.counts(); }

 private:
  struct Whole {
    FacetId facet;
    std::span<const VertexId> ring;
    Sign inner = Sign::zero;               // of O along its sides, within
    const ImageTriangle* image = nullptr;  // if there is one
    std::vector<LineFilter> lines;         // along its sides, where they are asked for
    bool has_plane = false;                // where it is asked for
    Plane plane;
    PlaneFilter filter;
  };
  void prepare(std::uint32_t piece, Whole& whole) const;
  void prepare_plane(Whole& whole) const;
  bool are_apart(Whole& a, Whole& b, PreparedTriangle::Both in_floats);
  Separation separation(Whole& a, const Whole& b) const;
  bool separates(Whole& a, const Whole& b);
  Sides sides(const Whole& plane, const Whole& corners);

  const ProjectedMesh& projected_;
  const FacePieces& pieces_;
  const ImageTriangles& images_;
  Predicates exact_;
  OverlapCounts counts_;
  Whole first_, second_;
  PreparedTriangle prepared_;  // the image of the first, if there is one
};

}  // namespace hsr::internal
