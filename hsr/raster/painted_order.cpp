#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "geometry/constructed_point.h"
#include "geometry/error.h"
#include "hsr/raster/caster.h"
#include "hsr/raster/compositing.h"
#include "hsr/raster/rasterizer.h"
#include "hsr/scene/view_parts.h"
#include "hsr/symbols/cut_plane.h"

namespace hsr {

using namespace internal;

namespace {

/// The spans of pieces. One object per block of them.
class PieceSpans {
 public:
  PieceSpans(const SampleSigns& signs, const PaintersOrder& order)
      : signs_(signs), projected_(signs.projected()), order_(order), rasterizer_(signs) {}

  /// Whether every corner is in front of the eye as the samples are.
  bool is_in_front(const OrderedPiece& piece) {
    const auto corners = order_.corners_of(piece);
    return std::all_of(corners.begin(), corners.end(), [&](const PieceCorner& c) {
      if (c.vertex.is_valid()) return signs_.is_in_front(c.vertex, rasterizer_.exact());
      const Plane face = projected_.face_plane(piece.facet), a = cut_plane(projected_, c.a), b = cut_plane(projected_, c.b);
      const Sign certain = signs_.certain_front(bounded_point(near_meet(face, a, b)));
      if (certain != Sign::zero) return certain == Sign::positive;
      return signs_.is_in_front(ConstructedPoint::meet(face, a, b).exact());
    });
  }

  std::span<const SampleSpan> operator()(const OrderedPiece& piece) {
    const auto corners = order_.corners_of(piece);
    rows_.clear();
    for (const PieceCorner& c : corners) rows_.push_back(rows_above(piece.facet, c));
    sides_.clear();
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const auto [first, end] = std::minmax({rows_[k], rows_[(k + 1) % corners.size()]});
      if (first < end) sides_.push_back({line(piece.facet, corners[k].side), first, end});
    }
    return rasterizer_.spans(sides_);
  }

 private:
  /// The image of where a cut meets the facet's plane.
  ViewPlane line(FacetId facet, const Cut& cut) {
    // A side of the face, however its plane is chosen.
    if (cut.kind == Cut::Kind::sight || cut.kind == Cut::Kind::line)
      return ViewPlane::of(projected_.sight_plane(VertexId(cut.u), VertexId(cut.v)));
    const Plane face = projected_.face_plane(facet);
    if (cut.kind == Cut::Kind::fold) return ViewPlane::of(cut_plane(projected_, cut));
    if (cut.kind == Cut::Kind::near) return ViewPlane::of(projected_.cutting_plane(cut.plane()).line_with(face));
    const Plane plane = cut_plane(projected_, cut);
    return contains_viewpoint(cut) ? ViewPlane::of(plane) : ViewPlane::of_meet(face, plane);
  }
  bool contains_viewpoint(const Cut& cut) const {
    if (cut.kind == Cut::Kind::face) return projected_.facing(TriangleId(cut.u)) == Sign::zero;
    const double e = projected_.eye().at[cut.axis];
    return e == (projected_.is_perspective() ? projected_.point(VertexId(cut.u))[cut.axis] : 0);
  }
  int rows_above(FacetId facet, const PieceCorner& c) {
    Predicates& exact = rasterizer_.exact();
    if (c.vertex.is_valid()) return signs_.rows_above(c.vertex, exact);
    const ViewPlane l = line(facet, c.a), m = line(facet, c.b);
    const auto near = near_meet(projected_.face_plane(facet), cut_plane(projected_, c.a), cut_plane(projected_, c.b));
    return signs_.rows_above(std::ceil(signs_.row_of({near[0].value, near[1].value, near[2].value}).value),
                             [&](int j) { return exact.side(projected_.camera(), ViewPlane::of(signs_.row_plane(j)), l, m); });
  }

  const SampleSigns& signs_;
  const ProjectedMesh& projected_;
  const PaintersOrder& order_;
  Rasterizer rasterizer_;
  std::vector<RasterSide> sides_;
  std::vector<int> rows_;
};

/// Calls visit(piece, span) for the spans of all pieces, in their order.
template <class Visit>
void visit_spans(const SceneView& scene, const PaintersOrder& order, const SampleGrid& samples, const Visit& visit) {
  if (order.pieces.empty()) return;
  const ProjectedMesh& projected = scene.parts().with(samples.bit_range()).projected();
  const SampleSigns signs(projected, samples);
  constexpr std::size_t block = 1024;
  struct Part {
    std::vector<SampleSpan> spans;
    std::vector<std::uint32_t> piece;  // of each span
  };
  std::vector<Part> parts((order.pieces.size() + block - 1) / block);
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t p) {
    PieceSpans spans_of(signs, order);
    for (std::size_t k = p * block; k < std::min((p + 1) * block, order.pieces.size()); ++k) {
      require(!projected.is_perspective() || spans_of.is_in_front(order.pieces[k]),
              "paint: a part of the model is not in front of the eye as the samples are");
      for (const SampleSpan& span : spans_of(order.pieces[k])) {
        parts[p].spans.push_back(span);
        parts[p].piece.push_back(static_cast<std::uint32_t>(k));
      }
    }
  });
  for (const Part& part : parts)
    for (std::size_t s = 0; s < part.spans.size(); ++s) visit(part.piece[s], part.spans[s]);
}

}  // namespace

Image<std::uint32_t> paint(const SceneView& scene, const PaintersOrder& order, const SampleGrid& samples) {
  Image<std::uint32_t> image(samples.width, samples.height, no_piece);
  visit_spans(scene, order, samples,
              [&](std::uint32_t piece, const SampleSpan& span) { Rasterizer::paint(image, std::span(&span, 1), piece); });
  return image;
}

Image<Colour> paint(const SceneView& scene, const PaintersOrder& order, const SampleGrid& samples,
                    const std::vector<Colour>& colours, double opacity) {
  const Mesh& mesh = scene.mesh();
  Image<Light> light(samples.width, samples.height, white_light);
  visit_spans(scene, order, samples, [&](std::uint32_t piece, const SampleSpan& span) {
    const Colour& c = colours[mesh.face_of[first_triangle(order.pieces[piece].facet)].value];
    const float a = opacity_of(c, opacity);
    for (int i = span.begin; i < span.end; ++i) lay_over(light.row(span.row)[i], c, a);
  });
  Image<Colour> image(samples.width, samples.height);
  std::transform(light.pixels.begin(), light.pixels.end(), image.pixels.begin(), rounded);
  return image;
}

}  // namespace hsr
