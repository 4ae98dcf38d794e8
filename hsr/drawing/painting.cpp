#include "hsr/drawing/painting.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <numeric>

#include "geometry/parallel.h"
#include "hsr/drawing/placement.h"
#include "hsr/lines/edge_classifier.h"
#include "hsr/scene/view_parts.h"
#include "hsr/symbols/constructions.h"

namespace hsr {

using namespace internal;

namespace {

/// Every edge beyond the near plane, as if nothing hid anything: what the page has to hold.
VisibleLines all_edges(const Mesh& mesh, const ProjectedMesh& projected) {
  VisibleLines all;
  for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
    const EdgeId e(i);
    const Sign a = projected.beyond_near(mesh.edges[e].a), b = projected.beyond_near(mesh.edges[e].b);
    if (a != Sign::positive && b != Sign::positive) continue;
    Line line;
    line.edge = e;
    line.first_cut = static_cast<std::uint32_t>(all.cuts.size());
    all.cuts.push_back({a == Sign::negative ? Cut::Kind::near : Cut::Kind::start, 0, 0, 0});
    all.cuts.push_back({b == Sign::negative ? Cut::Kind::near : Cut::Kind::end, 0, 0, 0});
    line.end_cut = static_cast<std::uint32_t>(all.cuts.size());
    all.lines.push_back(line);
  }
  return all;
}

std::vector<std::uint8_t> edges_of_classes(const ViewParts& parts, const LineOptions& options) {
  const ProjectedMesh& projected = parts.projected();
  std::vector<std::uint8_t> asked(parts.mesh().edges.size(), 0);
  const EdgeClassifier classifier(projected, parts.labels(), options);
  using Range = tbb::blocked_range<std::size_t>;
  tbb::parallel_for(Range(0, asked.size(), 512), [&](const Range& range) {
    Predicates exact = projected.predicates();
    for (std::size_t e = range.begin(); e < range.end(); ++e) {
      const auto c = classifier(exact, EdgeId(e)).seen;
      asked[e] = c && options.classes[static_cast<std::size_t>(*c)] ? 1 : 0;
    }
  });
  return asked;
}

class Placer {
 public:
  Placer(const Mesh& mesh, const View& view, const Projection& projection)
      : mesh_(mesh), view_(view), projection_(projection) {}

  PaperPoint operator()(FacetId facet, const PieceCorner& corner) const {
    const HomogeneousPoint at = enclosed(facet, corner);
    if (const auto known = Projection::rounded(at)) return *known;
    return Projection::rounded(projection_.exact(exact_point(mesh_, view_, facet, corner)));
  }

 private:
  HomogeneousPoint enclosed(FacetId facet, const PieceCorner& corner) const {
    if (corner.vertex.is_valid()) return projection_.at(corner.vertex);
    const auto& c = mesh_.triangles[first_triangle(facet)];
    return projection_.at(Plane::of_face(mesh_.points[c[0]], mesh_.points[c[1]], mesh_.points[c[2]]),
                          plane_of(mesh_, view_, corner.a), plane_of(mesh_, view_, corner.b));
  }

  const Mesh& mesh_;
  const View& view_;
  const Projection& projection_;
};

}  // namespace

Painting paint_on_page(const SceneView& scene, const PaintersOrder& order, const std::vector<Colour>& colours,
                       const LineOptions& lines, const DrawingOptions& options) {
  const Mesh& mesh = scene.mesh();
  const View& view = scene.view();
  const ProjectedMesh& projected = scene.parts().projected();
  const VisibleLines all = all_edges(mesh, projected);
  std::vector<std::uint32_t> drawn(all.lines.size());
  std::iota(drawn.begin(), drawn.end(), 0U);
  const Placement place = placement(mesh, view, all, drawn, options);
  Painting painting;
  painting.width = place.width;
  painting.height = place.height;
  painting.scale = place.scale;
  painting.fits = place.fits;
  painting.frame = place.frame;
  const std::vector<std::uint8_t> asked = edges_of_classes(scene.parts(), lines);
  painting.points.resize(order.corners.size());
  painting.sides.resize(order.corners.size());
  painting.pieces.resize(order.pieces.size());
  const Placer placer(mesh, view, place.projection);
  parallel_for_each(order.pieces.size(), [&](std::size_t i) {
    const OrderedPiece& piece = order.pieces[i];
    const FaceId face = mesh.face_of[first_triangle(piece.facet)];
    painting.pieces[i] = {face.value, colours[face.value], piece.first_corner, piece.end_corner};
    for (std::uint32_t k = piece.first_corner; k < piece.end_corner; ++k) {
      const PieceCorner& corner = order.corners[k];
      painting.points[k] = placer(piece.facet, corner);
      const bool is_edge = corner.side.kind == Cut::Kind::sight || corner.side.kind == Cut::Kind::line;
      const EdgeId e = corner.original && is_edge ? mesh.find_edge(VertexId(corner.side.u), VertexId(corner.side.v)) : EdgeId();
      painting.sides[k] = !corner.original ? SideOf::cut : e.is_valid() && asked[e.value] != 0 ? SideOf::line : SideOf::face;
    }
  });
  return painting;
}

}  // namespace hsr
