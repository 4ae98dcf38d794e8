// The painter's algorithm by one depth of each face, and where the verifier proves it wrong.
#include <algorithm>
#include <cmath>

#include "geometry/vector3.h"
#include "hsr/painter/sort/z_sort_observer.h"
#include "hsr/painter/verify/verify.h"
#include "hsr/scene/view_parts.h"
#include "study/explain/explained_methods.h"
#include "study/page_texts.h"

namespace hsr::internal {

namespace {

class Teller : public ZSortObserver {
 public:
  /// @param unit of the sorter's depths, in units of the model
  Teller(const ScenePicture& picture, TraceRun& run, const std::string& key, double unit)
      : picture_(picture), run_(run), key_(key), unit_(unit) {}

  void began(const FacePieces& pieces) override {
    TraceStep& step = run_.step("start", "start", "Each face gets one number: the depth of " + key_ + ".");
    for (std::uint32_t k = 0; k < pieces.size(); ++k) {
      const std::uint32_t face = picture_.face_of(pieces.facet[k]);
      faces_.push_back(face);
      TraceRing ring;
      for (const VertexId v : pieces.rings[k]) ring.push_back(picture_.at(picture_.scene().mesh.points[v]));
      step.make_piece(k, face, picture_.name(face), ring);
    }
  }

  void keyed(std::uint32_t piece, double depth) override {
    keys_.push_back(depth * unit_);
    least_ = std::min(least_, depth * unit_);
    run_.step("key", "key", "").piece(piece);
  }

  void sorted(std::span<const std::uint32_t> pieces) override {
    // Depths grow from that of the nearest key: the sorter's own have an arbitrary zero.
    for (std::uint32_t k = 0; k < keys_.size(); ++k) {
      TraceStep& step = run_.steps[k + 1];
      step.says(picture_.name(faces_[k]) + ": the depth of " + key_ + " is " + trace_text(keys_[k] - least_) +
                " beyond that of the nearest face.");
      step.number("depth of " + picture_.name(faces_[k]), keys_[k] - least_);
      step.add("keys", {picture_.name(faces_[k]) + ": " + trace_text(keys_[k] - least_), static_cast<int>(faces_[k])});
    }
    std::vector<TraceItem> items;
    for (const std::uint32_t k : pieces) items.push_back(picture_.item(faces_[k]));
    run_.step("sort", "sort", "Sorted by these numbers, the farthest first.").list("order", items);
    for (std::size_t place = 0; place < pieces.size(); ++place) {
      const std::uint32_t k = pieces[place];
      TraceStep& step = run_.step("paint", "paint", picture_.name(faces_[k]) + " is painted over what is there.");
      step.piece(k).paint(k).add("painted", picture_.item(faces_[k]));
    }
  }

 private:
  const ScenePicture& picture_;
  TraceRun& run_;
  std::string key_;
  double unit_;
  std::vector<std::uint32_t> faces_;
  std::vector<double> keys_;
  double least_ = 1e300;
};

/// Of depths that z_sort() tells, in units of the model: points and direction are multiplied by powers of two.
double unit_of(const SceneView& prepared) {
  const ProjectedMesh& projected = prepared.parts().projected();
  const Camera camera = projected.camera();
  const Point3 &e = camera.eye.at, &t = camera.target;
  const double length = camera.eye.is_direction ? std::hypot(e.x, e.y, e.z) : std::hypot(t.x - e.x, t.y - e.y, t.z - e.z);
  for (std::size_t k = 0; k < prepared.mesh().points.size(); ++k) {
    const double scaled = norm_max(projected.point(VertexId(k)));
    if (scaled > 0) return norm_max(prepared.mesh().points[VertexId(k)]) / scaled / length;
  }
  return 1;
}

/// What the verifier says of the order, with a place for each pair.
void add_verdict(const ScenePicture& picture, const SceneView& prepared, const PaintersOrder& order, TraceRun& run) {
  const std::vector<PaintedPolygon> painted = painted_polygons(prepared, order);
  const Verdict verdict = verify(painted, prepared.view());
  const auto name = [&](std::uint32_t polygon) {
    return painted[polygon].face ? picture.name(*painted[polygon].face) : std::string("a wire");
  };
  const auto light = [&](TraceStep& step, std::uint32_t polygon) {
    if (painted[polygon].face) step.face(*painted[polygon].face);
  };
  if (verdict.is_correct()) {
    run.step("right", "wrong", "The verifier compares every two faces that overlap in the image, exactly: this order is right.")
        .number("pairs that overlap", static_cast<double>(verdict.overlapping));
    return;
  }
  run.step("wrong", "wrong", "The verifier compares every two faces that overlap in the image, exactly: this order is wrong.")
      .number("pairs that overlap", static_cast<double>(verdict.overlapping))
      .number("painted the wrong way round", static_cast<double>(verdict.wrong))
      .ask({"Is the picture right?", {"yes", "no"}, 1});
  for (const Violation& v : verdict.first) {
    const std::string earlier = name(v.earlier), later = name(v.later);
    const TracePlace at = picture.at(v.witness.of_earlier);
    const double far = picture.depth(
        {v.witness.of_later[0].to_double(), v.witness.of_later[1].to_double(), v.witness.of_later[2].to_double()});
    const double near = picture.depth(
        {v.witness.of_earlier[0].to_double(), v.witness.of_earlier[1].to_double(), v.witness.of_earlier[2].to_double()});
    const double arm = picture.samples().width / 60.0;
    TraceStep& step =
        run.step("violation", "wrong",
                 v.fault == Fault::piercing
                     ? earlier + " and " + later + " pierce each other: no order of the two is right."
                     : later + " is painted over " + earlier + ", but where the cross is, " + earlier + " is nearer.");
    light(step, v.earlier);
    light(step, v.later);
    step.number("depth of " + earlier + " at the cross", near).number("depth of " + later + " at the cross", far);
    step.mark({{at[0] - arm, at[1] - arm}, {at[0] + arm, at[1] + arm}})
        .mark({{at[0] - arm, at[1] + arm}, {at[0] + arm, at[1] - arm}});
  }
  if (verdict.order_exists) return;
  std::string cycle;
  for (const std::uint32_t polygon : verdict.cycle) cycle += name(polygon) + " before ";
  TraceStep& step = run.step(
      "cycle", "wrong",
      "No order of these faces is right: " + cycle + name(verdict.cycle.front()) + ". Depth sort and BSP cut faces for that.");
  for (const std::uint32_t polygon : verdict.cycle) light(step, polygon);
}

}  // namespace

Trace explain_painter(const ExplainedScene& scene, int /*size*/) {
  check_explainable(scene);
  const ScenePicture picture(scene, 0);
  Trace trace;
  trace.scene = picture.traced(false);
  trace.pseudocode = page_text("painter.txt");
  const SceneView prepared(scene.mesh, scene.view);
  for (const DepthKey key : {DepthKey::centroid, DepthKey::farthest_vertex}) {
    const bool is_middle = key == DepthKey::centroid;
    TraceRun& run = trace.run(is_middle ? "by the middle of the corners" : "by the farthest corner");
    Teller teller(picture, run, is_middle ? "the middle of its corners" : "its farthest corner", unit_of(prepared));
    const PaintersOrder order = z_sort(prepared, key, teller);
    run.result = painted_result(scene, order);
    add_verdict(picture, prepared, order, run);
  }
  return trace;
}

}  // namespace hsr::internal
