// The alpha-buffer, told by the one that compare uses for transparency.
#include <algorithm>
#include <set>

#include "hsr/raster/alpha_buffer_observer.h"
#include "study/explain/explained_methods.h"
#include "study/explain/picture_result.h"
#include "study/page_texts.h"

namespace hsr::internal {

namespace {

std::string light_text(const Light& light) {
  return "(" + trace_text(light[0]) + ", " + trace_text(light[1]) + ", " + trace_text(light[2]) + ")";
}

class Teller : public AlphaBufferObserver {
 public:
  Teller(const ScenePicture& picture, TraceRun& run) : picture_(picture), run_(run) {
    const SampleGrid& samples = picture.samples();
    lists_ = Image<std::vector<std::uint32_t>>(samples.width, samples.height);
    std::vector<TraceCell> cells;
    for (int j = 0; j < samples.height; ++j)
      for (int i = 0; i < samples.width; ++i) cells.push_back({i, j, "0", -1});
    run_.step("start", "lists",
              "Each sample has a list of layers, which is empty at first. Cells show how many layers there are.")
        .cells(cells);
  }

  void added(int column, int row, const SampleLayer& layer) override {
    if (!columns_.empty() && (row != row_ || layer.triangle != triangle_)) finish_row();
    row_ = row;
    triangle_ = layer.triangle;
    columns_.emplace_back(column, layer.nearness);
    lists_.at(column, row).push_back(face(layer));
  }

  void sorted(int column, int row, std::span<const SampleLayer> layers) override {
    finish_row();
    if (row != blended_row_) finish_blended();
    blended_row_ = row;
    std::vector<std::uint32_t> kind;
    for (const SampleLayer& l : layers) kind.push_back(face(l));
    // In detail, each list of faces once.
    is_told_ = layers.size() > 1 && told_.size() < 10 && told_.insert(kind).second;
    if (!is_told_) return;
    finish_blended();
    column_ = column;
    std::vector<TraceItem> items;
    TraceStep& step =
        run_.step("sort", "sort",
                  "Column " + std::to_string(column) + ", row " + std::to_string(row) + ": " + std::to_string(layers.size()) +
                      " layers came, and are sorted by their depths. The background " + "is white.");
    for (const SampleLayer& l : layers) {
      items.push_back({name(l) + ", nearness " + trace_text(l.nearness), static_cast<int>(face(l))});
      step.number("nearness of " + name(l), l.nearness);
    }
    step.list(list_name, items);
    mark_frame(step, column, row, column + 1, row + 1);
    if (++asked_ <= 6) ask(step, layers);
  }

  void laid_over(const SampleLayer& layer, float opacity, const Light& before, const Light& after) override {
    if (!is_told_) return;
    TraceStep& step = run_.step("over", "over",
                                name(layer) + " is laid over what is there: " + trace_text(opacity) + " of its colour and " +
                                    trace_text(1 - static_cast<double>(opacity)) + " of the light from behind.");
    step.number("light before", light_text(before)).number("light after", light_text(after));
    step.face(face(layer)).cells({{column_, blended_row_, count(column_, blended_row_), -1, rounded(after)}});
    mark_frame(step, column_, blended_row_, column_ + 1, blended_row_ + 1);
  }

  void blended(int column, int row, const Colour& colour) override {
    const TraceCell cell{column, row, count(column, row), -1, colour};
    if (!is_told_) {
      waiting_.push_back(cell);
      return;
    }
    TraceStep& step =
        run_.step("show", "show", "All layers are laid down: the sample has the colour " + colour_text(colour) + ".");
    step.number("colour", colour_text(colour)).cells({cell}).list(list_name, {});
    mark_frame(step, column, row, column + 1, row + 1);
  }

  void end() {
    finish_blended();
    run_.step("end", "sample", "All samples are blended. Any order of the faces would have given the same picture.");
  }

 private:
  static constexpr const char* list_name = "layers of the sample, the farthest first";

  std::string name(const SampleLayer& l) const { return picture_.name(face(l)); }
  std::uint32_t face(const SampleLayer& l) const { return picture_.scene().mesh.face_of[l.triangle].value; }
  std::string count(int column, int row) const { return std::to_string(lists_.at(column, row).size()); }

  /// A row of a triangle is one step.
  void finish_row() {
    if (columns_.empty()) return;
    const std::uint32_t f = picture_.scene().mesh.face_of[triangle_].value;
    std::string nearness;
    std::vector<TraceCell> cells;
    for (const auto& [column, near] : columns_) {
      nearness += (nearness.empty() ? "" : " ") + trace_text(near);
      cells.push_back({column, row_, count(column, row_), -1});
    }
    run_.step("add", "add",
              "Face " + picture_.name(f) + ", row " + std::to_string(row_) + ", " +
                  columns_text(columns_.front().first, columns_.back().first + 1) +
                  ": a layer of it comes into each list, whatever is there.")
        .face(f)
        .row(row_)
        .number("nearness of " + picture_.name(f), nearness)
        .cells(cells);
    columns_.clear();
  }

  /// Of a row the samples that are not told in detail.
  void finish_blended() {
    if (waiting_.empty()) return;
    run_.step("blend", "show",
              "Row " + std::to_string(blended_row_) + ", " + columns_text(waiting_.front().column, waiting_.back().column + 1) +
                  ": sorted and laid over one another in the same way.")
        .row(blended_row_)
        .cells(waiting_);
    waiting_.clear();
  }

  /// The choices are in the order in which the layers came.
  void ask(TraceStep& step, std::span<const SampleLayer> layers) {
    const std::vector<std::uint32_t>& came = lists_.at(column_, blended_row_);
    if (std::set<std::uint32_t>(came.begin(), came.end()).size() != came.size()) return;
    TraceQuestion question{
        "The layers of column " + std::to_string(column_) + ", row " + std::to_string(blended_row_) + " are", {}, 0};
    for (std::size_t k = 0; k < came.size(); ++k) {
      const auto layer = std::find_if(layers.begin(), layers.end(), [&](const SampleLayer& l) { return face(l) == came[k]; });
      question.question += (k == 0 ? " " : ", ") + name(*layer) + " with nearness " + trace_text(layer->nearness);
      question.choices.push_back(name(*layer));
      if (came[k] == face(layers.front())) question.right = k;
    }
    question.question += ". Which is laid down first?";
    step.ask(std::move(question));
  }

  const ScenePicture& picture_;
  TraceRun& run_;
  Image<std::vector<std::uint32_t>> lists_;  // faces, as they came
  int row_ = 0, blended_row_ = -1, column_ = 0, asked_ = 0;
  TriangleId triangle_;
  std::vector<std::pair<int, double>> columns_;  // of the row, and the nearness there
  bool is_told_ = false;
  std::set<std::vector<std::uint32_t>> told_;
  std::vector<TraceCell> waiting_;
};

}  // namespace

Trace explain_alpha_buffer(const ExplainedScene& scene, int size) {
  check_explainable(scene);
  const ScenePicture picture(scene, size);
  Trace trace;
  trace.scene = picture.traced(false);
  trace.pseudocode = page_text("alpha-buffer.txt");
  const std::vector<Colour> colours = colours_of(trace.scene);
  for (const auto& [name, opacity] : {std::pair("half transparent faces", 0.5), std::pair("opaque faces", 1.0)}) {
    TraceRun& run = trace.run(name);
    Teller teller(picture, run);
    const AlphaBuffer buffer = alpha_buffer(scene.mesh, scene.view, picture.samples(), colours, opacity, {}, teller);
    teller.end();
    run.result = "{\"colours\":" + colours_json(buffer.picture) + ",\"fragments\":" + std::to_string(buffer.layers) +
                 ",\"most_fragments\":" + std::to_string(buffer.most_layers) + "}";
  }
  return trace;
}

}  // namespace hsr::internal
