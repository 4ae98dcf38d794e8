// HLRBRep_Algo of OCCT: hidden lines of B-Rep faces.
#include <BRep_Tool.hxx>
#include <HLRAlgo_EdgeIterator.hxx>
#include <HLRAlgo_Projector.hxx>
#include <HLRBRep_Algo.hxx>
#include <HLRBRep_Data.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS.hxx>
#include <memory>
#include <stdexcept>

#include "bench/peers/occt_shape.h"
#include "bench/peers/peer.h"

namespace hsr::bench {

namespace {

HLRAlgo_Projector projector(const View& view) {
  const Frame& f = view.frame;
  const gp_Pnt origin(f.origin.x, f.origin.y, f.origin.z);
  const gp_Dir right(f.right.x, f.right.y, f.right.z), up(f.up.x, f.up.y, f.up.z);
  const gp_Ax2 axes(origin, right.Crossed(up), right);
  if (!view.is_perspective()) return HLRAlgo_Projector(axes);
  const Point3& eye = view.viewpoint.at;
  return {axes, origin.Distance({eye.x, eye.y, eye.z})};
}

}  // namespace

Result occt_exact(const Task& task) try {
  Result result;
  std::unique_ptr<OcctShape> scene;
  result.prepare = elapsed([&] { scene = std::make_unique<OcctShape>(task.mesh, task.mesh.points, OcctFaces::in_shells); });
  Handle(HLRBRep_Algo) algorithm;
  result.compute = elapsed([&] {
    algorithm = new HLRBRep_Algo;
    algorithm->Add(scene->shape);
    algorithm->Projector(projector(task.view));
    algorithm->Update();
    algorithm->Hide();
  });

  const Handle(HLRBRep_Data) data = algorithm->DataStructure();
  std::vector<VisiblePart> visible;
  for (int k = 1; k <= data->NbEdges(); ++k) {
    HLRBRep_EdgeData& edge = data->EDataArray().ChangeValue(k);
    const HLRBRep_Curve& curve = edge.Geometry();
    const TopoDS_Edge& of_shape = TopoDS::Edge(data->EdgeMap()(k));
    const int number = scene->edges.FindIndex(of_shape);
    double first, last;
    BRep_Tool::Range(of_shape, first, last);
    HLRAlgo_EdgeIterator part;
    double from, to;
    float from_tolerance, to_tolerance;
    for (part.InitVisible(edge.Status()); part.MoreVisible(); part.NextVisible()) {
      part.Visible(from, from_tolerance, to, to_tolerance);
      ++result.visible;
      if (number == 0) continue;
      const EdgeId e(static_cast<std::size_t>(number - 1));
      visible.push_back({e, curve.Parameter3d(from) / last, curve.Parameter3d(to) / last});
    }
    for (part.InitHidden(edge.Status()); part.MoreHidden(); part.NextHidden()) ++result.hidden;
  }
  result.answers = answers_of(visible, task);
  return result;
} catch (const Standard_Failure& failure) {
  throw std::runtime_error(failure.GetMessageString());
}

}  // namespace hsr::bench
