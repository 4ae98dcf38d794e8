// The z-buffer of one row, told by the one that compare measures.

#include "hsr/raster/row_z_buffer_observer.h"
#include "study/explain/explained_methods.h"
#include "study/explain/nearness_spans.h"
#include "study/explain/picture_result.h"
#include "study/page_texts.h"

namespace hsr::internal {

namespace {

class Teller : public RowZBufferObserver {
 public:
  Teller(const ScenePicture& picture, TraceRun& run) : picture_(picture), run_(run), spans_(picture, run) {}

  void waits(TriangleId t, int first_row) override {
    buckets_.push_back({name(t) + " from row " + std::to_string(first_row), face(t)});
  }

  void row(int row, std::span<const TriangleId> active) override {
    start();
    finish_row();
    row_ = row;
    std::vector<TraceItem> items;
    std::string names;
    for (const TriangleId t : active) {
      items.push_back({name(t), face(t)});
      names += (names.empty() ? "" : ", ") + name(t);
    }
    std::vector<TraceCell> cells;
    for (int i = 0; i < picture_.samples().width; ++i) cells.push_back({i, row, trace_text(-HUGE_VAL), -1});
    run_.step("row", "row",
              "Row " + std::to_string(row) + ": the buffer of one row is emptied. " +
                  (active.empty() ? "No face is active." : "Active are " + names + "."))
        .row(row)
        .number("depths held", std::to_string(picture_.samples().width))
        .number("active", std::to_string(active.size()))
        .list("active", items)
        .cells(cells);
  }

  void span(TriangleId t, int row, int begin, int end, bool is_last_row) override {
    spans_.begin(t, row, begin, end);
    if (is_last_row) ending_.push_back(t);
  }
  void sample(const NearnessSample& sample) override { spans_.add(sample); }

  void end(std::size_t most_active) {
    start();
    finish_row();
    run_.step("end", "end",
              "All rows are done. No more than " + std::to_string(most_active) +
                  " triangles were active at once, and one row of depths was held.");
  }

 private:
  int face(TriangleId t) const { return static_cast<int>(picture_.scene().mesh.face_of[t].value); }
  std::string name(TriangleId t) const { return picture_.name(picture_.scene().mesh.face_of[t].value); }

  void start() {
    if (is_started_) return;
    is_started_ = true;
    run_.step("buckets", "buckets",
              "Each triangle waits in the bucket of the first row that it may cross: no row looks at it before.")
        .list("buckets", buckets_);
  }
  void finish_row() {
    spans_.finish();
    if (row_ < 0) return;
    std::string names;
    for (const TriangleId t : ending_) names += (names.empty() ? "" : ", ") + name(t);
    run_.step("copy", names.empty() ? "copy" : "drop",
              "Row " + std::to_string(row_) + " goes into the picture; its depths are forgotten." +
                  (names.empty() ? "" : " No longer active: " + names + "."))
        .row(row_);
    ending_.clear();
    row_ = -1;
  }

  const ScenePicture& picture_;
  TraceRun& run_;
  NearnessSpans spans_;
  std::vector<TraceItem> buckets_;
  std::vector<TriangleId> ending_;  // in this row
  bool is_started_ = false;
  int row_ = -1;
};

}  // namespace

Trace explain_row_z_buffer(const ExplainedScene& scene, int size) {
  check_explainable(scene);
  const ScenePicture picture(scene, size);
  Trace trace;
  trace.scene = picture.traced(false);
  trace.pseudocode = page_text("row-z-buffer.txt");
  TraceRun& run = trace.run("row by row");
  Teller teller(picture, run);
  const RowZBuffer<double> buffer = row_z_buffer(scene.mesh, scene.view, picture.samples(), {}, teller);
  teller.end(buffer.most_active);
  run.result = faces_result(picture, buffer.image);
  return trace;
}

}  // namespace hsr::internal
