// The z-buffer in tiles, told by the one that compare measures.

#include "hsr/raster/tiled_z_buffer_observer.h"
#include "study/explain/explained_methods.h"
#include "study/explain/nearness_spans.h"
#include "study/explain/picture_result.h"
#include "study/page_texts.h"

namespace hsr::internal {

namespace {

class Teller : public TiledZBufferObserver {
 public:
  Teller(const ScenePicture& picture, TraceRun& run) : picture_(picture), run_(run), spans_(picture, run) {
    start_ = &run_.step("sort", "sort", "");
  }

  void tile(const SampleTile& tile, std::span<const TriangleId> triangles) override {
    tile_ = tile;
    is_empty_ = triangles.empty();
    entries_ += triangles.size();
    ++tiles_;
    std::vector<TraceItem> items;
    for (const TriangleId t : triangles) items.push_back({name(t), face(t)});
    std::vector<TraceCell> cells;
    for (int j = tile.top; j < tile.bottom; ++j)
      for (int i = tile.left; i < tile.right; ++i) cells.push_back({i, j, trace_text(-HUGE_VAL), -1});
    TraceStep& step = run_.step(
        "tile", "tile",
        where() + (is_empty_
                       ? ": its list is empty, and nothing is drawn."
                       : ": a buffer of " + std::to_string(watched_tile_size) + " × " + std::to_string(watched_tile_size) +
                             " samples is emptied. Triangles in its list: " + std::to_string(triangles.size()) + "."));
    frame(step);
    step.number("in the list", std::to_string(triangles.size())).list("in the tile", items).cells(cells);
  }

  void span(TriangleId t, int row, int begin, int end) override { spans_.begin(t, row, begin, end); }
  void sample(const NearnessSample& sample) override { spans_.add(sample); }
  void done() override {
    spans_.finish();
    if (is_empty_) return;
    frame(run_.step("copy", "copy", where() + " is done, and is copied into the picture."));
  }

  void end() {
    start_->says("Each triangle comes into the list of every tile that its box reaches into: " + std::to_string(entries_) +
                 " entries in the lists of " + std::to_string(tiles_) + " tiles.");
    start_->number("tiles", std::to_string(tiles_)).number("entries", std::to_string(entries_));
    run_.step("end", "end", "All tiles are done. No tile needed another one: they may be drawn at the same time.");
  }

 private:
  int face(TriangleId t) const { return static_cast<int>(picture_.scene().mesh.face_of[t].value); }
  std::string name(TriangleId t) const { return picture_.name(picture_.scene().mesh.face_of[t].value); }
  std::string where() const {
    return "The tile of " + columns_text(tile_.left, tile_.right) + " and rows " + std::to_string(tile_.top) + " … " +
           std::to_string(tile_.bottom - 1);
  }
  void frame(TraceStep& step) const { mark_frame(step, tile_.left, tile_.top, tile_.right, tile_.bottom); }

  const ScenePicture& picture_;
  TraceRun& run_;
  NearnessSpans spans_;
  TraceStep* start_ = nullptr;
  SampleTile tile_;
  bool is_empty_ = false;
  std::size_t entries_ = 0, tiles_ = 0;
};

}  // namespace

Trace explain_tiled_z_buffer(const ExplainedScene& scene, int size) {
  check_explainable(scene);
  const ScenePicture picture(scene, size);
  Trace trace;
  trace.scene = picture.traced(false);
  trace.pseudocode = page_text("tiled-z-buffer.txt");
  TraceRun& run = trace.run("tile by tile");
  Teller teller(picture, run);
  const TiledZBuffer<float> buffer = tiled_z_buffer(scene.mesh, scene.view, picture.samples(), {}, teller);
  teller.end();
  run.result = faces_result(picture, buffer.image);
  return trace;
}

}  // namespace hsr::internal
