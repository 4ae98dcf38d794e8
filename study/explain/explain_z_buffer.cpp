// The z-buffer, told by the depth buffer that compare and stability use.
#include <algorithm>

#include "geometry/error.h"
#include "hsr/raster/depth_observer.h"
#include "study/explain/explained_methods.h"
#include "study/explain/picture_result.h"
#include "study/explain/z_buffer_run.h"
#include "study/page_texts.h"

namespace hsr::internal {

namespace {

class Teller : public DepthObserver {
 public:
  Teller(const ScenePicture& picture, const ShownDepth& shown, const DepthBufferOptions& options, TraceRun& run)
      : picture_(picture), shown_(shown), options_(options), run_(run) {}

  void began(int width, int height, double depth, double stored) override {
    holders_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), -1);
    std::vector<TraceCell> cells;
    for (int j = 0; j < height; ++j)
      for (int i = 0; i < width; ++i) cells.push_back({i, j, text(depth, stored), -1});
    run_.step("start", "clear",
              "Every sample begins with " + text(depth, stored) + ", " +
                  (depth == 1 ? "the depth of the far plane" : "the depth of the near plane") + ", and with the background.")
        .cells(cells);
  }

  void triangle(TriangleId t, const std::array<DepthCorner, 3>& corners, double right, double down) override {
    finish();
    face_ = picture_.scene().mesh.face_of[t].value;
    TraceStep& step = run_.step("face", "face",
                                "Face " + name() +
                                    ": its corners are where they are seen, each with its depth; within "
                                    "the face the depth is linear.");
    step.face(face_);
    for (const DepthCorner& c : corners)
      step.number("corner at column " + trace_text(c.x) + ", row " + trace_text(c.y), "depth " + shown_.text(c.depth));
    step.number("change from a sample to the next, −A/C" + of_what(), shown_.change(right));
    step.number("change from a row to the next, −B/C" + of_what(), shown_.change(down));
    right_ = right;
    down_ = down;
  }

  void sides(int row, const DepthSide& left, const DepthSide& right) override {
    finish();
    has_sides_ = true;
    TraceStep& step =
        run_.step("ends", "ends",
                  "Face " + name() + ", row " + std::to_string(row) + ": its sides are at columns " + trace_text(left.x) +
                      " and " + trace_text(right.x) + ". To the next row they move by 1/m, " + trace_text(left.x_a_row) +
                      " and " + trace_text(right.x_a_row) + ".");
    step.face(face_).row(row);
    const auto tell = [&](const std::string& side_name, const DepthSide& side) {
      step.number(side_name + ": column", trace_text(side.x))
          .number(side_name + ": 1/m", trace_text(side.x_a_row))
          .number(side_name + ": depth" + of_what(), shown_.text(side.depth))
          .number(side_name + ": change of it a row", shown_.change(side.depth_a_row));
    };
    tell("left side", left);
    tell("right side", right);
    step.mark({{left.x + 0.5, row + 0.5}, {right.x + 0.5, row + 0.5}});
  }

  void span(int row, int begin, int end) override {
    finish();
    if (begin >= end) return;
    row_ = row;
    begin_ = begin;
    end_ = end;
    cells_.clear();
    passed_ = failed_ = outside_ = 0;
    depth_text_.clear();
    held_text_.clear();
    interesting_.reset();
    is_open_ = true;
  }

  void sample(const DepthSample& s) override {
    if (!s.is_within) {
      ++outside_;
      return;
    }
    const std::string now = text(s.depth, s.stored), before = text(s.held, s.held_stored);
    depth_text_ += (depth_text_.empty() ? "" : " ") + now;
    held_text_ += (held_text_.empty() ? "" : " ") + before;
    if (s.is_shown) {
      ++passed_;
      cells_.push_back({s.column, s.row, now, static_cast<int>(face_)});
    } else {
      ++failed_;
    }
    int& holder = holders_[static_cast<std::size_t>(s.row * picture_.samples().width + s.column)];
    if (!interesting_ && holder >= 0 && holder != static_cast<int>(face_)) {
      interesting_ = s;
      holder_before_ = holder;
    }
    if (s.is_shown) holder = static_cast<int>(face_);
  }

  void end() {
    finish();
    run_.step("end", "show", "All faces are drawn: each sample shows the face whose depth it holds.");
  }

 private:
  std::string name() const { return picture_.name(face_); }
  std::string text(double depth, double stored) const { return shown_.text(depth, stored); }

  /// A span is one step, once all of its samples are known.
  void finish() {
    if (!is_open_) return;
    is_open_ = false;
    const std::string samples = begin_ + 1 == end_ ? "column " + std::to_string(begin_)
                                                   : "columns " + std::to_string(begin_) + " … " + std::to_string(end_ - 1);
    std::string says = "Face " + name() + ", row " + std::to_string(row_) + ", " + samples + ": ";
    if (options_.function == DepthFunction::always)
      says += "whatever is held, the depths are stored.";
    else if (failed_ == 0 && outside_ == 0)
      says += "the depths " + words() + " than what is held: all pass the test, and are stored.";
    else if (passed_ == 0)
      says += "none passes the test: what is held stays.";
    else
      says += std::to_string(passed_) + " of " + std::to_string(end_ - begin_) + " samples pass the test.";
    if (outside_ > 0) says += " " + std::to_string(outside_) + " are not between the near and the far plane.";
    TraceStep& step = run_.step("span", passed_ > 0 ? "store" : "test", says);
    step.face(face_).row(row_).number("depth of " + name(), depth_text_).number("held before", held_text_);
    if (end_ - begin_ > 1) step.number("from a sample to the next, −A/C" + of_what(), shown_.change(right_));
    if (!has_sides_) step.number("from a row to the next, −B/C" + of_what(), shown_.change(down_));
    has_sides_ = false;
    if (!cells_.empty()) step.cells(cells_);
    ask(step);
  }

  /// What is interpolated where it is not the depth.
  std::string of_what() const {
    return options_.format == DepthFormat::reversed_float32      ? " of 1 − depth"
           : options_.format == DepthFormat::logarithmic_float32 ? " of near / z"
                                                                 : "";
  }

  /// The test in words.
  std::string words() const {
    switch (options_.function) {
      case DepthFunction::less:
        return "are nearer";
      case DepthFunction::lequal:
        return "are no farther";
      case DepthFunction::greater:
        return "are farther";
      case DepthFunction::gequal:
        return "are no nearer";
      default:
        return "are another matter";
    }
  }

  void ask(TraceStep& step) {
    if (!interesting_ || asked_ >= 6 || outside_ > 0) return;
    const DepthSample& s = *interesting_;
    // Not twice of one face, unless the answer differs.
    const std::pair<std::uint32_t, bool> key{face_, s.is_shown};
    if (std::find(asked_of_.begin(), asked_of_.end(), key) != asked_of_.end()) return;
    asked_of_.push_back(key);
    ++asked_;
    const std::string before = picture_.name(static_cast<std::uint32_t>(holder_before_));
    step.ask({"Row " + std::to_string(s.row) + ", column " + std::to_string(s.column) + ": the buffer holds " +
                  text(s.held, s.held_stored) + " of " + before + ", and " + name() + " has the depth " +
                  text(s.depth, s.stored) + " there. Which face has the sample then?",
              {before, name()},
              s.is_shown ? 1U : 0U});
  }

  const ScenePicture& picture_;
  const ShownDepth& shown_;
  const DepthBufferOptions& options_;
  TraceRun& run_;
  std::uint32_t face_ = 0;
  int row_ = 0, begin_ = 0, end_ = 0, passed_ = 0, failed_ = 0, outside_ = 0, asked_ = 0;
  bool is_open_ = false, has_sides_ = false;
  double right_ = 0, down_ = 0;  // how the depth changes
  std::vector<TraceCell> cells_;
  std::string depth_text_, held_text_;
  std::vector<int> holders_;  // by sample: the face that it shows
  int holder_before_ = -1;
  std::optional<DepthSample> interesting_;
  std::vector<std::pair<std::uint32_t, bool>> asked_of_;
};

std::string result_of(const ScenePicture& picture, const DepthBuffer& buffer) {
  return "{\"faces\":" + faces_json(picture, buffer.triangles) + ",\"depths\":" + numbers_json(buffer.depths) + "}";
}

}  // namespace

std::string ShownDepth::text(double depth, double stored) const {
  if (units != 0) return trace_text(first + depth * (units - first));
  if (is_fixed) return trace_text(stored);
  return rounded_text(depth, 4);
}

void add_z_buffer_run(Trace& trace, const std::string& name, const ScenePicture& picture, const DepthRange& range,
                      const DepthBufferOptions& options, const ShownDepth& given) {
  ShownDepth shown = given;
  if (shown.is_fixed) shown.steps = std::exp2(fixed_bits(options.format)) - 1;
  TraceRun& run = trace.run(name);
  Teller teller(picture, shown, options, run);
  const ExplainedScene& scene = picture.scene();
  const DepthBuffer buffer = depth_buffer(scene.mesh, scene.view, picture.samples(), range, options, teller);
  teller.end();
  run.result = result_of(picture, buffer);
}

Trace explain_z_buffer(const ExplainedScene& scene, int size) {
  check_explainable(scene);
  const ScenePicture picture(scene, size);
  Trace trace;
  trace.scene = picture.traced(false);
  trace.pseudocode = page_text("z-buffer.txt");
  const DepthRange range = depth_range(scene.mesh, scene.view, picture.samples());
  const auto add = [&](const std::string& name, const DepthBufferOptions& options) {
    add_z_buffer_run(trace, name, picture, range, options,
                     {fixed_bits(options.format) > 0 && fixed_bits(options.format) <= 16, 0, 0});
  };
  using Format = std::pair<const char*, DepthFormat>;
  for (const auto& [format_name, format] :
       {Format("8 bits", DepthFormat::fixed8), Format("16 bits", DepthFormat::fixed16), Format("24 bits", DepthFormat::fixed24),
        Format("float", DepthFormat::float32), Format("float reversed", DepthFormat::reversed_float32),
        Format("float logarithmic", DepthFormat::logarithmic_float32)}) {
    if (format == DepthFormat::logarithmic_float32 && !range.is_perspective) continue;
    using Function = std::pair<const char*, DepthFunction>;
    for (const auto& [function_name, function] :
         {Function("less", DepthFunction::less), Function("lequal", DepthFunction::lequal),
          Function("greater", DepthFunction::greater), Function("always", DepthFunction::always)}) {
      const std::string name = std::string(format_name) + ", " + function_name + ", ";
      add(name + "from the plane", {.format = format, .function = function});
      // How depths are stepped matters little: once for each format.
      if (function == DepthFunction::less)
        add(name + "down the sides by 1/m",
            {.format = format, .function = function, .interpolation = DepthInterpolation::incremental});
    }
  }
  return trace;
}

}  // namespace hsr::internal
