// Visible lines by Appel, told by the code that counts.
#include <algorithm>

#include "hsr/lines/count_observer.h"
#include "study/explain/drawn_lines.h"
#include "study/explain/explained_methods.h"
#include "study/page_texts.h"

namespace hsr::internal {

namespace {

/// "1 face", "2 faces".
std::string faces(std::int32_t n) { return std::to_string(n) + (n == 1 ? " face" : " faces"); }

class Teller : public CountObserver {
 public:
  Teller(const ScenePicture& picture, TraceRun& run) : picture_(picture), mesh_(picture.scene().mesh), run_(run) {}

  void occluding(std::span<const OccludingEdge> edges) override {
    TraceStep& step = step_of(
        "start", "start",
        "The number of faces in front of a point changes only at the image of an outline or a border: these edges are marked.");
    for (const OccludingEdge& e : edges) step.edge(e.edge.value);
    step.number("edges of the model", static_cast<double>(mesh_.edges.size()))
        .number("where the count changes", static_cast<double>(edges.size()));
  }

  void looked_along(EdgeId edge, const EdgeWalk& walk, std::span<const InvisibilityChange> changes) override {
    const std::string what = name(edge);
    std::string says, line = "look";
    if (walk.is_point) {
      says = what + " is seen as a point: there is nothing to walk along.";
    } else if (walk.is_degenerate) {
      says = what + " touches something in space, where a count cannot decide: it is left for shadows.";
      line = "touches";
    } else if (walk.is_hidden) {
      says = what + " is known to be hidden: nobody walks along it.";
    } else {
      says = changes.empty() ? what + ": nothing crosses in front of it, and it pierces nothing. One count holds all along."
                             : what + ": the count changes at " + std::to_string(changes.size()) +
                                   (changes.size() == 1 ? " place" : " places") + " along it. What it is, nobody knows yet.";
    }
    TraceStep& step = step_of("look", line, says);
    step.edge(edge.value);
    for (const InvisibilityChange& c : changes) {
      if (c.is_face)
        step.face(mesh_.face_of[TriangleId(c.by)].value);
      else
        step.edge(c.by);
      step.number(c.is_face ? "pierces " + face(c.by) : "passes behind " + name(EdgeId(c.by)), change_text(c));
    }
    if (!walk.is_followed()) return;
    step.number("nothing else passes in front of its first vertex", walk.start_is_clean ? "yes" : "no");
    step.number("nor of its last", walk.end_is_clean ? "yes" : "no");
  }

  void rayed(VertexId v, std::int32_t count) override {
    TraceStep& step = step_of(
        "ray", "ray",
        "A ray from vertex " + std::to_string(v.value) + " to the viewer, the only one for all that hangs together here: " +
            (count == 0 ? "no face is" : faces(count) + (count == 1 ? " is" : " are")) + " in front of it.");
    spot(step, v);
    step.number("in front of vertex " + std::to_string(v.value), count);
    if (++asked_rays_ <= 2)
      ask(step, "How many faces are in front of the marked vertex " + std::to_string(v.value) + "?", count, count);
  }

  void carried(EdgeId edge, VertexId from, VertexId to, std::int32_t count) override {
    TraceStep& step = step_of("carry", "carry",
                              "From vertex " + std::to_string(from.value) + " along " + name(edge) + " with all its changes: " +
                                  (count == 0 ? "no face is" : faces(count) + (count == 1 ? " is" : " are")) +
                                  " in front of vertex " + std::to_string(to.value) + ". No ray is needed.");
    step.edge(edge.value);
    spot(step, to);
    step.number("in front of vertex " + std::to_string(to.value), count);
  }

  void walk_began(const LineTask& line, CountStart start, const Layers& layers) override {
    edge_ = line.edge;
    rows_.assign(1, {});
    shadows_.clear();
    at_ = 0;
    count_ = std::max(layers.left, layers.right);
    const Edge& e = mesh_.edges[edge_];
    const std::string from = start == CountStart::first_vertex ? "the count of vertex " + std::to_string(e.a.value)
                             : start == CountStart::last_vertex
                                 ? "the count of vertex " + std::to_string(e.b.value) + ", less what changes on the way there"
                                 : "a ray of its own, as something passes in front of both its ends";
    TraceStep& step = step_of(
        "walk", start == CountStart::own_ray ? "own-ray" : "walk",
        name(edge_) + " begins with " + faces(count_) + " in front of it: by " + from + ", and by the faces at the vertex.");
    step.edge(edge_.value);
    count_numbers(step, layers);
    // Rows of the last edge are emptied.
    for (std::size_t k = 1; k < most_rows_; ++k) step.bars(row_name(k), {});
    step.bars("visible", {});
  }

  void changed(const Breakpoint& at, const InvisibilityChange& change, const Layers& layers) override {
    const std::int32_t before = count_;
    advance(at.t);
    count_ = std::max(layers.left, layers.right);
    const std::string by =
        change.is_face ? "it pierces " + face(change.by) : name(EdgeId(change.by)) + " crosses in front of it";
    TraceStep& step =
        step_of("change", change.is_face ? "pierce" : "cross",
                "At t = " + trace_text(at.t) + " " + by + ": from " + std::to_string(before) + " to " + faces(count_) +
                    " in front. " + (count_ > 0 ? "From here on it is hidden." : "From here on it is visible."));
    if (before > 0 && count_ > 0)
      step.says("At t = " + trace_text(at.t) + " " + by + ": from " + std::to_string(before) + " to " + faces(count_) +
                " in front. It stays hidden.");
    step.edge(edge_.value);
    if (change.is_face)
      step.face(mesh_.face_of[TriangleId(change.by)].value);
    else
      step.edge(change.by);
    cross(step, at.t);
    step.number("t", at.t).number("change", change_text(change));
    count_numbers(step, layers);
    show_rows(step);
    if (++asked_ <= 6)
      ask(step,
          name(edge_) + " has " + faces(before) + " in front of it. At t = " + trace_text(at.t) + " " + by +
              ". How many are in front beyond?",
          count_, before);
  }

  void began(const LineTask& line, const Breakpoint& /*first*/, const Breakpoint& /*last*/) override {
    edge_ = line.edge;
    rows_.assign(1, {});
    shadows_.clear();
    TraceStep& step =
        step_of("shadows", "shadows", name(edge_) + " touches something: each face casts its shadow on it, as by Roberts.");
    step.edge(edge_.value);
    for (std::size_t k = 1; k < most_rows_; ++k) step.bars(row_name(k), {});
    step.bars("visible", {}).bars("shadows", {});
  }

  void cast(TriangleId triangle, std::span<const HiddenInterval> shadows) override {
    if (shadows.empty()) return;
    const std::uint32_t f = mesh_.face_of[triangle].value;
    std::string text;
    for (const HiddenInterval& s : shadows) {
      text += (text.empty() ? "" : " and ") + trace_text(s.from.t) + " … " + trace_text(s.to.t);
      shadows_.push_back({s.from.t, s.to.t, static_cast<int>(f)});
    }
    step_of("shadow", "shadows", picture_.name(f) + " hides " + name(edge_) + " from t = " + text + ".")
        .edge(edge_.value)
        .face(f)
        .bars("shadows", shadows_);
  }

  void joined(const HiddenInterval& /*shadow*/, Uniting /*how*/, const HiddenInterval& /*last*/) override {}

  void ended(const Line& line, std::span<const Cut> cuts) override {
    edge_ = line.edge;
    std::vector<double> at;
    const SupportingLine support{mesh_.edges[edge_].a, mesh_.edges[edge_].b, {}};
    for (const Cut& cut : cuts) at.push_back(exact_parameter(mesh_, picture_.scene().view, support, cut).to_double());
    std::vector<TraceBar> visible;
    std::vector<TraceLine> lines;
    for (std::uint32_t k = 0; k + 1 < at.size(); ++k) {
      lines.push_back({place(at[k]), place(at[k + 1]), line.hidden(k)});
      if (!line.hidden(k)) visible.push_back({at[k], at[k + 1], -1});
    }
    if (!rows_.empty() && shadows_.empty() && !at.empty()) advance(1);
    TraceStep& step = step_of("result", "result",
                              name(edge_) + (at.empty()           ? " is seen as a point: nothing is drawn."
                                             : visible.empty()    ? " is hidden along its whole length."
                                             : lines.size() == 1U ? " is visible along its whole length."
                                                                  : " is visible where the count is 0."));
    step.edge(edge_.value);
    for (const TraceBar& b : visible) step.number("visible", trace_text(b.from) + " … " + trace_text(b.to));
    for (std::size_t k = 1; k < rows_.size(); ++k) step.bars(row_name(k), rows_[k]);
    step.bars("visible", visible).draw(lines);
    rows_.clear();
  }

 private:
  /// A sentence begins with a capital.
  TraceStep& step_of(const std::string& kind, const std::string& line, std::string says) {
    if (!says.empty() && says[0] >= 'a' && says[0] <= 'z') says[0] = static_cast<char>(says[0] - 'a' + 'A');
    return run_.step(kind, line, std::move(says));
  }
  std::string name(EdgeId e) const {
    return "edge " + std::to_string(mesh_.edges[e].a.value) + "–" + std::to_string(mesh_.edges[e].b.value);
  }
  std::string face(std::uint32_t triangle) const { return "face " + picture_.name(mesh_.face_of[TriangleId(triangle)].value); }
  static std::string row_name(std::size_t count) { return std::to_string(count) + " in front"; }
  static std::string signed_text(std::int32_t n) {
    return n > 0 ? "+" + std::to_string(n) : n < 0 ? "−" + std::to_string(-n) : "0";
  }
  static std::string change_text(const InvisibilityChange& c) {
    if (c.left == c.right) return signed_text(c.left);
    return "left " + signed_text(c.left) + ", right " + signed_text(c.right);
  }
  static void count_numbers(TraceStep& step, const Layers& layers) {
    if (layers.left == layers.right)
      step.number("in front", layers.left);
    else
      step.number("in front, just to the left", layers.left).number("just to the right", layers.right);
  }
  /// The choices are `right` and what is near `before`.
  static void ask(TraceStep& step, std::string question, std::int32_t right, std::int32_t before) {
    std::vector<std::int32_t> counts = {std::max(before - 1, 0), before, before + 1, right};
    std::sort(counts.begin(), counts.end());
    counts.erase(std::unique(counts.begin(), counts.end()), counts.end());
    TraceQuestion asked{std::move(question), {}, 0};
    for (std::size_t k = 0; k < counts.size(); ++k) {
      asked.choices.push_back(std::to_string(counts[k]));
      if (counts[k] == right) asked.right = k;
    }
    step.ask(std::move(asked));
  }
  void advance(double t) {
    const auto row = static_cast<std::size_t>(std::max(count_, 0));
    if (rows_.size() <= row) rows_.resize(row + 1);
    most_rows_ = std::max(most_rows_, rows_.size());
    if (t > at_) rows_[row].push_back({at_, t, -1});
    at_ = t;
  }
  void show_rows(TraceStep& step) const {
    for (std::size_t k = 0; k < rows_.size(); ++k) step.bars(k == 0 ? "visible" : row_name(k), rows_[k]);
  }
  TracePlace place(double t) const {
    const Point3 &a = mesh_.points[mesh_.edges[edge_].a], &b = mesh_.points[mesh_.edges[edge_].b];
    return picture_.at(Point3{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)});
  }
  void cross(TraceStep& step, const TracePlace& at) const {
    const double arm = picture_.samples().width / 70.0;
    step.mark({{at[0] - arm, at[1] - arm}, {at[0] + arm, at[1] + arm}})
        .mark({{at[0] - arm, at[1] + arm}, {at[0] + arm, at[1] - arm}});
  }
  void cross(TraceStep& step, double t) const { cross(step, place(t)); }
  void spot(TraceStep& step, VertexId v) const { cross(step, picture_.at(mesh_.points[v])); }

  const ScenePicture& picture_;
  const Mesh& mesh_;
  TraceRun& run_;
  EdgeId edge_;
  double at_ = 0;                            // how far the walk is
  std::int32_t count_ = 0;                   // the larger of both sides
  std::vector<std::vector<TraceBar>> rows_;  // by count
  std::size_t most_rows_ = 1;
  std::vector<TraceBar> shadows_;
  int asked_ = 0, asked_rays_ = 0;
};

}  // namespace

Trace explain_appel(const ExplainedScene& scene, int /*size*/) {
  check_explainable(scene);
  const ScenePicture picture(scene, 0);
  Trace trace;
  trace.scene = picture.traced(true);
  trace.pseudocode = page_text("appel.txt");
  TraceRun& run = trace.run("a count along each edge");
  Teller teller(picture, run);
  LineOptions options;
  options.method = LineMethod::appel;
  // Where faces pierce each other is a line of no edge, and of no name here.
  options.classes[static_cast<std::size_t>(EdgeClass::intersection)] = false;
  // All edges are walked along, those too that other stages know to be hidden.
  SceneOptions all;
  all.stages.fill(When::never);
  const VisibleLines lines = visible_lines(SceneView(scene.mesh, scene.view, all), options, teller);
  end_with_lines(run, picture, lines);
  return trace;
}

}  // namespace hsr::internal
