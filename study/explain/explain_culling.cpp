// What is left out before anything is drawn, told by the code that leaves it out.
#include <algorithm>
#include <cmath>
#include <functional>

#include "hsr/raster/culling_observer.h"
#include "hsr/raster/facing_culling.h"
#include "hsr/raster/frustum_culling.h"
#include "hsr/raster/importance_culling.h"
#include "hsr/raster/occlusion_culling.h"
#include "study/explain/explained_methods.h"
#include "study/explain/traced_tiles.h"
#include "study/page_texts.h"

namespace hsr::internal {

namespace {

/// The words of one culling.
struct Words {
  std::string line;                                             ///< of the pseudocode
  std::string question;                                         ///< after the name of the triangle
  std::function<std::string(const CullingTest&)> kept, culled;  ///< what follows the name of the triangle
  std::string number;                                           ///< what CullingTest::value is; empty: nothing
};

std::ptrdiff_t hiding(const CullingTest& test) {
  return std::count_if(test.tiles.begin(), test.tiles.end(), [](const auto& tile) { return tile.hides; });
}

class Teller : public CullingObserver {
 public:
  Teller(const ScenePicture& picture, TraceRun& run, Words words)
      : picture_(picture), mesh_(picture.scene().mesh), run_(run), words_(std::move(words)) {
    TraceStep& step =
        run_.step("start", "start", "All triangles wait to be drawn. A face of four corners is two of them: A1, A2.");
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      TraceRing ring;
      for (const VertexId v : mesh_.triangles[TriangleId(t)]) ring.push_back(picture_.at(mesh_.points[v]));
      step.make_piece(t, face(t), name(t), ring);
    }
    step.list("kept", {}).list("culled", {});
  }

  void covered(const ProjectedMesh& projected, const OcclusionPyramid::Grid& grid) override {
    const TraceTiles tiles = traced_tiles(picture_, projected, grid);
    const auto hiding =
        static_cast<int>(std::count_if(tiles.depths.begin(), tiles.depths.end(), [](double x) { return std::isfinite(x); }));
    TraceStep& step = run_.step(
        "tiles", "tiles",
        "The picture is divided into " + std::to_string(tiles.columns) + " × " + std::to_string(tiles.rows) +
            " tiles. Where a triangle, or two with a common side, cover all of a tile, the tile keeps how deep they are "
            "there at "
            "most: what is deeper is hidden. " +
            (hiding == 0 ? "Here that is none." : "Here these are the " + std::to_string(hiding) + " shaded ones."));
    step.tiles(tiles).number("tiles", tiles.columns * tiles.rows).number("of these, covered", hiding);
    double least = HUGE_VAL, most = -HUGE_VAL;
    for (const double depth : tiles.depths)
      if (std::isfinite(depth)) least = std::min(least, depth), most = std::max(most, depth);
    if (hiding > 0) step.number("they hide what is deeper than", trace_text(least) + " … " + trace_text(most));
  }

  void tested(const CullingTest& test) override {
    std::string names;
    for (std::size_t t = test.first; t < test.end; ++t) names += (names.empty() ? "" : ", ") + name(t);
    TraceStep& step = run_.step(test.is_culled ? "culled" : "kept", test.is_culled ? words_.line : "keep",
                                names + (test.is_culled ? words_.culled(test) : words_.kept(test)));
    // Questions of both answers, a few of each.
    int& asked = test.is_culled ? asked_culled_ : asked_kept_;
    if (++asked <= 2)
      step.ask({names + words_.question, {"it is kept", "it is culled"}, test.is_culled ? std::size_t{1} : std::size_t{0}});
    if (!words_.number.empty()) step.number(words_.number, test.value);
    if (!test.tiles.empty()) {
      step.number("tiles that it touches", static_cast<double>(test.tiles.size()))
          .number("of these, hide it", static_cast<double>(hiding(test)));
      for (const auto& tile : test.tiles) step.tile({tile.column, tile.row, tile.hides});
    }
    for (std::size_t t = test.first; t < test.end; ++t) {
      const auto id = static_cast<std::uint32_t>(t);
      step.add(test.is_culled ? "culled" : "kept", {name(t), static_cast<int>(face(id))});
      if (test.is_culled)
        step.face(face(id)).drop(id);
      else
        step.piece(id);
    }
  }

  void ended(const Culled& culled) {
    run_.step("end", "end",
              std::to_string(culled.kept.size()) + " of " + std::to_string(mesh_.triangles.size()) +
                  " triangles are left for the method that draws.")
        .number("tests", static_cast<double>(culled.tests))
        .number("culled", static_cast<double>(culled.culled));
    std::string out = "{\"kept\":[";
    for (const TriangleId t : culled.kept) out += (out.back() == '[' ? "" : ",") + std::to_string(mesh_.face_of[t].value);
    run_.result = out + "]}";
  }

 private:
  std::uint32_t face(std::uint32_t t) const { return mesh_.face_of[TriangleId(t)].value; }
  /// "C", or of several triangles "C1", "C2".
  std::string name(std::size_t t) const {
    const FaceId f = mesh_.face_of[TriangleId(t)];
    const std::uint32_t first = mesh_.first_triangle[f], end = mesh_.first_triangle[FaceId(f.value + 1U)];
    const std::string face_name = picture_.name(f.value);
    if (end - first < 2) return face_name;
    return face_name + (mesh_.faces.size() > 26 ? "." : "") + std::to_string(t - first + 1);
  }

  const ScenePicture& picture_;
  const Mesh& mesh_;
  TraceRun& run_;
  Words words_;
  int asked_kept_ = 0, asked_culled_ = 0;
};

std::string side_name(int side) {
  switch (side) {
    case 0:
      return "above";
    case 1:
      return "to the right of";
    case 2:
      return "below";
    case 3:
      return "to the left of";
    default:
      return "before the near plane of";
  }
}

void add_frustum(Trace& trace, const ScenePicture& picture, Bounds bounds) {
  const ExplainedScene& scene = picture.scene();
  const std::string what = bounds == Bounds::boxes ? "box" : "sphere";
  TraceRun& run = trace.run("frustum, by " + what + (bounds == Bounds::boxes ? "es" : "s"));
  Teller teller(picture, run,
                {"frustum", ": is all of its " + what + " beyond one side of the frame?",
                 [&](const CullingTest&) { return ": its " + what + " is wholly beyond no side of the frame. It is kept."; },
                 [&](const CullingTest& test) {
                   return ": its " + what + " is wholly " + side_name(test.side) + " the picture. It is culled.";
                 },
                 ""});
  // A picture of the middle of the scene only.
  PaperRectangle part = paper_rectangle(scene.mesh, scene.view);
  const double width = part.right - part.left, height = part.top - part.bottom;
  part = {part.left + width * 0.3, part.right - width * 0.05, part.bottom + height * 0.05, part.top - height * 0.2};
  const SampleGrid samples = sample_grid(scene.view, part, 40, 40);
  const std::array<TracePlace, 4> corners = {picture.at(samples.at(-1, -1)), picture.at(samples.at(40, -1)),
                                             picture.at(samples.at(40, 40)), picture.at(samples.at(-1, 40))};
  std::vector<TraceLine> frame;
  for (std::size_t k = 0; k < 4; ++k) frame.push_back({corners[k], corners[(k + 1) % 4], false});
  run.steps.front().draw(frame).says("All triangles wait to be drawn. The picture is only what is within the frame.");
  teller.ended(frustum_culled(scene.mesh, scene.view, samples, {bounds, 1}, &teller));
}

void add_facing(Trace& trace, const ScenePicture& picture, FacingSpace space) {
  const ExplainedScene& scene = picture.scene();
  const bool is_world = space == FacingSpace::world, is_eye = space == FacingSpace::eye;
  const std::string where = is_world ? "in the world" : is_eye ? "in the space of the eye" : "after the projection";
  TraceRun& run = trace.run("back faces, " + where);
  const std::string number = is_world ? "normal · (way to the viewer)"
                             : is_eye ? "the same, the viewer at the origin"
                                      : "area as it is seen, signed";
  Teller teller(picture, run,
                {is_world ? "world"
                 : is_eye ? "eye"
                          : "projection",
                 ": do its corners turn counter-clockwise, as the viewer sees them?",
                 [](const CullingTest& test) {
                   return ": " + trace_text(test.value) +
                          " is positive: its corners turn counter-clockwise. It is a front, and is kept.";
                 },
                 [](const CullingTest& test) {
                   return ": " + trace_text(test.value) +
                          (test.value < 0 ? " is negative: its corners turn clockwise. It is a back, and is culled."
                                          : ": it is seen edge-on, and is culled.");
                 },
                 number});
  teller.ended(facing_culled(scene.mesh, scene.view, Facing::back, space, &teller));
}

void add_occlusion(Trace& trace, const ScenePicture& picture) {
  const ExplainedScene& scene = picture.scene();
  TraceRun& run = trace.run("occlusion");
  Teller teller(
      picture, run,
      {"occlusion", ": is it hidden in every tile that it touches?",
       [](const CullingTest& test) -> std::string {
         const std::ptrdiff_t open = static_cast<std::ptrdiff_t>(test.tiles.size()) - hiding(test);
         if (test.tiles.empty()) return ": it reaches beyond the tiles. It is kept.";
         if (open == 0)
           return ": every tile that it touches hides it, but not all of its face. A face is culled whole or not: it is kept.";
         const std::string all = std::to_string(test.tiles.size());
         if (open == static_cast<std::ptrdiff_t>(test.tiles.size()))
           return ": none of the " + all + " tiles that it touches hides it. It is kept.";
         return ": " + std::to_string(open) + " of the " + all +
                " tiles that it touches do not hide it. It is kept, though it may be hidden.";
       },
       [](const CullingTest& test) {
         return ": it is deeper than what covers it in each of the " + std::to_string(test.tiles.size()) +
                " tiles that it touches. It is culled.";
       },
       ""});
  teller.ended(occlusion_culled(SceneView(scene.mesh, scene.view), &teller));
}

void add_importance(Trace& trace, const ScenePicture& picture) {
  const ExplainedScene& scene = picture.scene();
  constexpr int size = 16;
  constexpr double least = 4;
  TraceRun& run = trace.run("importance");
  Teller teller(picture, run,
                {"importance", ": of a picture of 16 × 16 samples, is it less than 4 wide and high?",
                 [](const CullingTest& test) {
                   return ": it is " + trace_text(test.value) + " samples wide or high, 4 or more. It is kept.";
                 },
                 [](const CullingTest& test) {
                   return ": it is at most " + trace_text(test.value) +
                          " samples wide and high, less than 4. It is culled, though it may be seen.";
                 },
                 "samples, the larger of width and height"});
  const ScenePicture small(scene, size);
  const ImportanceCulled culled = importance_culled(scene.mesh, scene.view, small.samples(), least, &teller);
  teller.ended(culled);
  run.steps.back().number("area that is lost, in samples", culled.lost_area);
}

}  // namespace

Trace explain_culling(const ExplainedScene& scene, int /*size*/) {
  check_explainable(scene);
  const ScenePicture picture(scene, 0);
  Trace trace;
  trace.scene = picture.traced(false);
  trace.pseudocode = page_text("culling.txt");
  add_frustum(trace, picture, Bounds::boxes);
  add_frustum(trace, picture, Bounds::spheres);
  for (const FacingSpace space : {FacingSpace::world, FacingSpace::eye, FacingSpace::projection})
    add_facing(trace, picture, space);
  add_occlusion(trace, picture);
  add_importance(trace, picture);
  return trace;
}

}  // namespace hsr::internal
