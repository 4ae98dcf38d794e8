// The scanline algorithm, told by the scanner itself.
#include <algorithm>

#include "hsr/raster/scanline_observer.h"
#include "study/explain/explained_methods.h"
#include "study/explain/picture_result.h"
#include "study/page_texts.h"

namespace hsr::internal {

namespace {

class Teller : public ScanlineObserver {
 public:
  Teller(const ScenePicture& picture, TraceRun& run) : picture_(picture), run_(run) {}

  void added_face(std::uint32_t face, TriangleId triangle) override {
    faces_.resize(std::max<std::size_t>(faces_.size(), face + 1U));
    faces_[face] = picture_.scene().mesh.face_of[triangle].value;
  }

  void began(std::span<const ScannedEdge> edges) override {
    TraceStep& step = run_.step("start", "tables",
                                "The edge table: every edge of a triangle that crosses a row, by the first row that it "
                                "crosses. The face table has the plane of each triangle, and a flag that is down.");
    std::vector<TraceItem> items;
    for (const ScannedEdge& e : edges)
      items.push_back({name(e.face) + (e.is_left ? " left" : " right") + ", rows " + std::to_string(e.first_row) + "–" +
                           std::to_string(e.end_row - 1),
                       face(e.face)});
    step.list("edge table", items);
  }

  void row(int row, std::span<const ScannedEdge> active, std::span<const ScannedCrossing> crossings) override {
    row_ = row;
    if (active.empty()) return;
    TraceStep& step = run_.step("row", "row",
                                "Row " + std::to_string(row) + " crosses " + std::to_string(active.size()) +
                                    " active edges, from the left: each is 1/m columns farther than in the row before.");
    step.row(row);
    std::vector<TraceItem> items;
    for (const ScannedCrossing& c : crossings)
      items.push_back({name(c.face) + (c.is_left ? " left" : " right") + " at " + std::to_string(c.column), face(c.face)});
    for (const ScannedEdge& e : active) step.number(name(e.face) + (e.is_left ? " left" : " right") + ", 1/m", e.columns_a_row);
    step.list("active edges", items).list("flags up", {});
  }

  void passed(const ScannedCrossing& c, std::span<const std::uint32_t> inside) override {
    std::vector<TraceItem> items;
    for (const std::uint32_t f : inside) items.push_back({name(f), face(f)});
    run_.step("flag", c.is_left ? "up" : "down",
              "Column " + std::to_string(c.column) + ": " + (c.is_left ? "the row enters " : "the row leaves ") + name(c.face) +
                  ": its flag goes " + (c.is_left ? "up." : "down."))
        .row(row_)
        .face(faces_[c.face])
        .list("flags up", items);
  }

  void compared(const ScannedComparison& c) override {
    const std::string a = name(c.face), b = name(c.shown), nearer = c.is_nearer ? a : b;
    TraceStep& step = run_.step("compare", "compare",
                                "The flags of " + a + " and " + b + " are both up: they are compared at columns " +
                                    std::to_string(c.first_column) + " and " + std::to_string(c.last_column) +
                                    ", the ends of what both have of the row. " + nearer + " is nearer.");
    step.row(row_).face(faces_[c.face]).face(faces_[c.shown]);
    step.number("nearness of " + a, trace_text(c.face_at_first) + " … " + trace_text(c.face_at_last));
    step.number("nearness of " + b, trace_text(c.shown_at_first) + " … " + trace_text(c.shown_at_last));
    if (faces_[c.face] == faces_[c.shown] || ++asked_ > 5) return;
    step.ask({"Nearness grows toward the viewer. " + a + " has " + trace_text(c.face_at_first) + " … " +
                  trace_text(c.face_at_last) + " along the part of the row that both have, " + b + " has " +
                  trace_text(c.shown_at_first) + " … " + trace_text(c.shown_at_last) + ". Which is shown?",
              {a, b},
              c.is_nearer ? 0U : 1U});
  }

  void shown(int row, int begin, int end, std::uint32_t f) override {
    if (f == none) return;
    std::vector<TraceCell> cells;
    for (int i = begin; i < end; ++i) cells.push_back({i, row, name(f), face(f)});
    run_.step("span", "span",
              "Columns " + std::to_string(begin) + " … " + std::to_string(end - 1) + " show " + name(f) +
                  ": until the next edge nothing is asked.")
        .row(row)
        .face(faces_[f])
        .cells(cells);
  }

 private:
  std::string name(std::uint32_t f) const { return picture_.name(faces_[f]); }
  int face(std::uint32_t f) const { return static_cast<int>(faces_[f]); }

  const ScenePicture& picture_;
  TraceRun& run_;
  std::vector<std::uint32_t> faces_;  // of the model, by number of the face table
  int row_ = 0, asked_ = 0;
};

}  // namespace

Trace explain_scanline(const ExplainedScene& scene, int size) {
  check_explainable(scene);
  const ScenePicture picture(scene, size);
  Trace trace;
  trace.scene = picture.traced(false);
  trace.pseudocode = page_text("scanline.txt");
  TraceRun& run = trace.run("row by row");
  Teller teller(picture, run);
  const Scanline scanned = scanline(scene.mesh, scene.view, picture.samples(), {}, teller);
  run.step("end", "end", "All rows are done.");
  run.result = faces_result(picture, scanned.triangles);
  return trace;
}

}  // namespace hsr::internal
