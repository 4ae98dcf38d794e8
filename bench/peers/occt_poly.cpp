// HLRBRep_PolyAlgo of OCCT: hidden lines of triangulations.
#include <HLRAlgo_EdgeIterator.hxx>
#include <HLRBRep_PolyAlgo.hxx>
#include <Standard_Failure.hxx>
#include <algorithm>
#include <memory>
#include <stdexcept>

#include "bench/peers/image.h"
#include "bench/peers/occt_shape.h"
#include "bench/peers/peer.h"

namespace hsr::bench {

namespace {

/// Where an image point lies on the image of an edge, 0 ... 1.
double along(const gp_XY& a, const gp_XY& b, const gp_XY& p) { return (p - a) * (b - a) / ((b - a) * (b - a)); }

/// A visible part as it comes out: the edge, and two points in the image.
struct Part {
  TopoDS_Shape edge;
  gp_XY from, to;
};

// It ignores a perspective (7.6 projects nothing, and so would draw a parallel view from the side of the eye). So it is handed
// the scene as seen, (x, y, nearness), and looks along nearness: what is straight in the scene is straight there.
Result run_poly(const Task& task, OcctFaces faces) try {
  Result result;
  const Image image(task.view);
  std::vector<Point3> seen;
  std::unique_ptr<OcctShape> scene;
  result.prepare = elapsed([&] {
    for (const Point3& p : task.mesh.points) {
      const ImagePoint at = image(p);
      seen.push_back({at.x, at.y, at.nearness});
    }
    scene = std::make_unique<OcctShape>(task.mesh, seen, faces);
  });

  std::vector<Part> parts;
  result.compute = elapsed([&] {
    const Handle(HLRBRep_PolyAlgo) algorithm = new HLRBRep_PolyAlgo(scene->shape);
    algorithm->Projector(HLRAlgo_Projector(gp::XOY()));
    algorithm->Update();
    HLRAlgo_EdgeStatus status;
    TopoDS_Shape edge;
    bool smooth, sewn, outline, interior;
    for (algorithm->InitHide(); algorithm->MoreHide(); algorithm->NextHide()) {
      const HLRAlgo_BiPoint::PointsT& ends = algorithm->Hide(status, edge, smooth, sewn, outline, interior);
      const gp_XY a = ends.PntP12D(), b = ends.PntP22D();
      HLRAlgo_EdgeIterator part;
      double from, to;
      float from_tolerance, to_tolerance;
      for (part.InitVisible(status); part.MoreVisible(); part.NextVisible()) {
        part.Visible(from, from_tolerance, to, to_tolerance);
        parts.push_back({edge, a + from * (b - a), a + to * (b - a)});
      }
      for (part.InitHidden(status); part.MoreHidden(); part.NextHidden()) ++result.hidden;
    }
  });
  result.visible = parts.size();

  std::vector<VisiblePart> visible;
  for (const Part& part : parts) {
    const int number = scene->edges.FindIndex(part.edge);
    if (number == 0) continue;
    const EdgeId e(static_cast<std::size_t>(number - 1));
    const VertexId a = task.mesh.edges[e].a, b = task.mesh.edges[e].b;
    const gp_XY at_a(seen[a.value].x, seen[a.value].y), at_b(seen[b.value].x, seen[b.value].y);
    const auto t = [&](const gp_XY& p) {
      return image.parameter_in_space(task.mesh.points[a], task.mesh.points[b], std::clamp(along(at_a, at_b, p), 0.0, 1.0));
    };
    visible.push_back({e, t(part.from), t(part.to)});
  }
  result.answers = answers_of(visible, task);
  return result;
} catch (const Standard_Failure& failure) {
  throw std::runtime_error(failure.GetMessageString());
}

}  // namespace

Result occt_poly(const Task& task) { return run_poly(task, OcctFaces::in_shells); }

Result occt_poly_compound(const Task& task) { return run_poly(task, OcctFaces::in_compound); }

}  // namespace hsr::bench
