// The A-buffer, told by the one that compare uses for transparency and soft edges.
#include <algorithm>
#include <bit>
#include <map>
#include <set>

#include "hsr/raster/a_buffer_observer.h"
#include "study/explain/explained_methods.h"
#include "study/explain/picture_result.h"
#include "study/page_texts.h"

namespace hsr::internal {

namespace {

constexpr std::uint32_t all_samples = 0xffffffffU;

std::vector<std::string> rows_of(std::uint32_t mask) {
  std::vector<std::string> rows(4, std::string(8, '0'));
  for (std::size_t bit = 0; bit < 32; ++bit)
    if ((mask >> bit & 1U) != 0) rows[bit / 8][bit % 8] = '1';
  return rows;
}

std::string of_samples(std::uint32_t mask) { return std::to_string(std::popcount(mask)) + " of 32"; }

/// "0.594".
std::string share_text(double share) { return trace_text(share); }

class Teller : public ABufferObserver {
 public:
  Teller(const ScenePicture& picture, TraceRun& run) : picture_(picture), run_(run) {
    const SampleGrid& samples = picture.samples();
    counts_ = Image<int>(samples.width, samples.height, 0);
    std::vector<TraceCell> cells;
    for (int j = 0; j < samples.height; ++j)
      for (int i = 0; i < samples.width; ++i) cells.push_back({i, j, "0", -1});
    run_.step("start", "lists",
              "Each pixel has a list of fragments, which is empty at first. Cells show how many fragments there are.")
        .cells(cells);
  }

  void added(int column, int row, const PixelFragment& fragment, bool is_new) override {
    if (is_open_ && (fragment.facet != facet_ || row != row_)) finish_row();
    is_open_ = true;
    facet_ = fragment.facet;
    row_ = row;
    fragments_[column] = fragment;
    if (is_new) ++counts_.at(column, row);
  }

  void sorted(int column, int row, std::span<const PixelFragment> fragments) override {
    finish_row();
    if (row != resolved_row_) finish_resolved();
    resolved_row_ = row;
    std::pair<std::vector<std::uint32_t>, bool> kind;
    for (const PixelFragment& f : fragments) {
      kind.first.push_back(picture_.face_of(f.facet));
      kind.second = kind.second || f.mask != all_samples;
    }
    // In detail, each kind of list once.
    is_told_ = fragments.size() > 1 && told_.size() < 10 && told_.insert(kind).second;
    if (!is_told_) return;
    finish_resolved();
    std::vector<TraceItem> items;
    std::vector<TraceMask> masks;
    TraceStep& step = run_.step("sort", "sort", "");
    for (const PixelFragment& f : fragments) {
      items.push_back({name(f) + ", " + of_samples(f.mask) + " samples, nearness " + trace_text(f.nearness), face(f)});
      masks.push_back({name(f) + ": " + of_samples(f.mask), face(f), rows_of(f.mask)});
      step.number("mean nearness of " + name(f), f.nearness);
    }
    step.says("Pixel in column " + std::to_string(column) + ", row " + std::to_string(row) + ": its " +
              std::to_string(fragments.size()) + " fragments, the nearest first. All 32 samples are open.")
        .list("fragments of the pixel, the nearest first", items)
        .masks("samples within each of them, 8 × 4 to a pixel", masks);
    mark_frame(step, column, row, column + 1, row + 1);
    column_ = column;
    open_ = all_samples;
    taken_ = 0;
    before_.clear();
    list_ = {fragments.begin(), fragments.end()};
  }

  void took(const PixelFragment& f, float opacity, float share, std::uint32_t open) override {
    if (!is_told_) return;
    const std::uint32_t reached = f.mask & open_;
    std::string says = name(f) + " has " + of_samples(f.mask) + " samples";
    if (reached != f.mask) says += ", of which " + std::to_string(std::popcount(reached)) + " are open";
    says += ": its share of the light is " + share_text(share) + ".";
    if (open != open_) says += " It is opaque, and closes them.";
    ++taken_;
    const bool is_early = open == 0 && taken_ < list_.size();
    if (is_early) says += " No sample is open any more: what is behind is never looked at.";
    TraceStep& step = run_.step("take", is_early ? "early" : open != open_ ? "close" : "take", says);
    step.number("opacity", trace_text(opacity)).number("share of the light", share_text(share));
    step.number("open samples afterwards", std::to_string(std::popcount(open)));
    mark_frame(step, column_, resolved_row_, column_ + 1, resolved_row_ + 1);
    step.masks("open samples", {{std::to_string(std::popcount(open)) + " open", -1, rows_of(open)}});
    if (!before_.empty() && ++asked_ <= 5) ask(step, f, opacity, share);
    before_.push_back(f);
    open_ = open;
  }

  void resolved(int column, int row, float background, const Colour& colour) override {
    const TraceCell cell{column, row, std::to_string(counts_.at(column, row)), -1, colour};
    if (!is_told_) {
      waiting_.push_back(cell);
      return;
    }
    std::string says = "The pixel has the colour " + colour_text(colour);
    says +=
        background > 0 ? "; the background gives " + share_text(background) + " of it." : "; nothing of the background shows.";
    TraceStep& step = run_.step("rest", "rest", says);
    step.number("share of the background", share_text(background)).number("colour", colour_text(colour)).cells({cell});
    mark_frame(step, column, row, column + 1, row + 1);
    step.list("fragments of the pixel, the nearest first", {}).masks("open samples", {}).masks(mask_name, {});
  }

  void end() {
    finish_resolved();
    run_.step("end", "pixel", "All pixels are resolved.");
  }

 private:
  static constexpr const char* mask_name = "samples within each of them, 8 × 4 to a pixel";

  std::string name(const PixelFragment& f) const { return picture_.name(picture_.face_of(f.facet)); }
  int face(const PixelFragment& f) const { return static_cast<int>(picture_.face_of(f.facet)); }

  /// A row of pixels of a face is one step.
  void finish_row() {
    if (!is_open_) return;
    is_open_ = false;
    const PixelFragment& first = fragments_.begin()->second;
    std::string covered;
    std::vector<TraceCell> cells;
    const PixelFragment* partial = nullptr;
    for (const auto& [column, f] : fragments_) {
      covered += (covered.empty() ? "" : " ") + std::to_string(std::popcount(f.mask));
      cells.push_back({column, row_, std::to_string(counts_.at(column, row_)), -1});
      if (f.mask != all_samples && partial == nullptr) partial = &f;
    }
    const auto whole =
        std::count_if(fragments_.begin(), fragments_.end(), [](const auto& f) { return f.second.mask == all_samples; });
    TraceStep& step =
        run_.step("mask", "add",
                  "Face " + name(first) + ", row " + std::to_string(row_) + ": " + std::to_string(fragments_.size()) +
                      (fragments_.size() == 1 ? " pixel has" : " pixels have") + " a fragment of it, " + std::to_string(whole) +
                      " of them wholly covered.");
    step.face(static_cast<std::uint32_t>(face(first))).row(row_).cells(cells);
    step.number("samples covered, of 32", covered);
    if (partial != nullptr)
      step.masks(mask_name, {{name(*partial) + ": " + of_samples(partial->mask), face(*partial), rows_of(partial->mask)}});
    else
      step.masks(mask_name, {});
    fragments_.clear();
  }

  /// Of a row the pixels that are not told in detail.
  void finish_resolved() {
    if (waiting_.empty()) return;
    run_.step("resolve", "rest",
              "Row " + std::to_string(resolved_row_) + ", " +
                  columns_text(waiting_.front().column, waiting_.back().column + 1) +
                  ": resolved in the same way. One fragment is laid over the background, by the share of the samples that it "
                  "has.")
        .row(resolved_row_)
        .masks(mask_name, {})
        .cells(waiting_);
    waiting_.clear();
  }

  void ask(TraceStep& step, const PixelFragment& f, float opacity, float share) {
    std::vector<double> shares = {share, static_cast<double>(opacity) * std::popcount(f.mask) / 32.0,
                                  1 - static_cast<double>(std::popcount(f.mask)) / 32.0, static_cast<double>(opacity), 0.0};
    std::set<std::string> seen;
    std::vector<std::pair<double, std::string>> choices;
    for (const double s : shares)
      if (choices.size() < 3 && seen.insert(share_text(s)).second) choices.emplace_back(s, share_text(s));
    if (choices.size() < 2) return;
    std::sort(choices.begin(), choices.end());
    TraceQuestion question{"In front of " + name(f) + " is " + name(before_.back()) + ". " + name(f) + " has " +
                               of_samples(f.mask) + " samples of this pixel. What is its share of the light?",
                           {},
                           0};
    for (std::size_t k = 0; k < choices.size(); ++k) {
      question.choices.push_back(choices[k].second);
      if (choices[k].second == share_text(share)) question.right = k;
    }
    step.ask(std::move(question));
  }

  const ScenePicture& picture_;
  TraceRun& run_;
  Image<int> counts_;  // fragments of each pixel
  bool is_open_ = false, is_told_ = false;
  FacetId facet_;
  int row_ = 0, resolved_row_ = -1, column_ = 0, asked_ = 0;
  std::map<int, PixelFragment> fragments_;  // of the row, by column
  std::set<std::pair<std::vector<std::uint32_t>, bool>> told_;
  std::uint32_t open_ = 0;
  std::size_t taken_ = 0;
  std::vector<PixelFragment> list_, before_;
  std::vector<TraceCell> waiting_;
};

}  // namespace

Trace explain_a_buffer(const ExplainedScene& scene, int size) {
  check_explainable(scene);
  const ScenePicture picture(scene, size);
  Trace trace;
  trace.scene = picture.traced(false);
  trace.pseudocode = page_text("a-buffer.txt");
  const std::vector<Colour> colours = colours_of(trace.scene);
  for (const auto& [name, opacity] : {std::pair("opaque faces", 1.0), std::pair("half transparent faces", 0.5)}) {
    TraceRun& run = trace.run(name);
    Teller teller(picture, run);
    const ABuffer buffer = a_buffer(scene.mesh, scene.view, picture.samples(), colours, opacity, {}, teller);
    teller.end();
    run.result = "{\"colours\":" + colours_json(buffer.picture) + ",\"fragments\":" + std::to_string(buffer.fragments) +
                 ",\"most_fragments\":" + std::to_string(buffer.most_fragments) + "}";
  }
  return trace;
}

}  // namespace hsr::internal
