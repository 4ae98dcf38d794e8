// Visible lines by Roberts, told by the code that casts the shadows.
#include <algorithm>

#include "hsr/lines/shadow_observer.h"
#include "study/explain/drawn_lines.h"
#include "study/explain/explained_methods.h"
#include "study/page_texts.h"

namespace hsr::internal {

namespace {

class Teller : public ShadowObserver {
 public:
  Teller(const ScenePicture& picture, TraceRun& run) : picture_(picture), mesh_(picture.scene().mesh), run_(run) {
    run_.step("start", "start", "Every edge is asked by itself: which faces hide which parts of it?");
  }

  void began(const LineTask& line, const Breakpoint& first, const Breakpoint& last) override {
    edge_ = line.edge;
    shadows_.clear();
    united_.clear();
    nothing_.clear();
    TraceStep& step = run_.step("edge", "edge", what() + ": t runs from 0 to 1 along it.");
    mark(step);
    step.number("from t", first.t).number("to t", last.t);
    step.bars("shadows", {}).bars("union", {}).bars("visible", {});
  }

  void cast(TriangleId triangle, std::span<const HiddenInterval> shadows) override {
    const std::uint32_t face = mesh_.face_of[triangle].value;
    const std::string name = picture_.name(face);
    if (shadows.empty()) {
      tell_none(face);
      return;
    }
    nothing_.clear();
    std::string text;
    for (const HiddenInterval& s : shadows) {
      text += (text.empty() ? "" : " and ") + trace_text(s.from.t) + " … " + trace_text(s.to.t);
      shadows_.push_back({s.from.t, s.to.t, static_cast<int>(face)});
    }
    TraceStep& step = run_.step("shadow", "shadow",
                                name + " hides the edge from t = " + text + ": there it is between the edge and the viewer.");
    mark(step);
    step.face(face);
    for (const HiddenInterval& s : shadows) {
      step.number("begins at t", s.from.t).number("  where it is cut by", cut_name(s.from.cut));
      step.number("ends at t", s.to.t).number("  where it is cut by", cut_name(s.to.cut));
      step.mark({place(s.from.t), place(s.to.t), false});
    }
    step.bars("shadows", shadows_);
  }

  void joined(const HiddenInterval& shadow, Uniting how, const HiddenInterval& last) override {
    const std::string interval = trace_text(shadow.from.t) + " … " + trace_text(shadow.to.t);
    std::string says;
    if (how == Uniting::begins) {
      united_.push_back({last.from.t, last.to.t, -1});
      says = united_.size() == 1 ? "Sorted by where they begin, the first shadow is " + interval + ": the union begins with it."
                                 : "The shadow " + interval + " begins beyond the union: a new interval.";
    } else if (how == Uniting::reaches) {
      united_.back() = {last.from.t, last.to.t, -1};
      says = "The shadow " + interval + " begins within the union and reaches farther: the last interval now ends at " +
             trace_text(last.to.t) + ".";
    } else {
      says = "The shadow " + interval + " is within the union: nothing changes.";
    }
    TraceStep& step = run_.step("unite", how == Uniting::begins ? "new" : how == Uniting::reaches ? "longer" : "within", says);
    mark(step);
    step.bars("union", united_);
    if (united_.size() + (how == Uniting::begins ? 0U : 1U) > 1 && ++asked_ <= 5)
      step.ask(
          {"The union ends at t = " + trace_text(before_end_) + ". The next shadow is " + interval + ". What becomes of it?",
           {"a new interval begins", "the last interval becomes longer", "nothing changes"},
           static_cast<std::size_t>(how)});
    before_end_ = last.to.t;
  }

  void ended(const Line& line, std::span<const Cut> cuts) override {
    edge_ = line.edge;
    std::vector<double> at;
    const SupportingLine support{mesh_.edges[edge_].a, mesh_.edges[edge_].b, {}};
    for (const Cut& cut : cuts) at.push_back(exact_parameter(mesh_, picture_.scene().view, support, cut).to_double());
    std::vector<TraceBar> visible;
    std::vector<TraceLine> lines;
    for (std::uint32_t k = 0; k + 1 < at.size(); ++k) {
      lines.push_back({place(at[k]), place(at[k + 1]), line.hidden(k)});
      if (line.hidden(k)) continue;
      visible.push_back({at[k], at[k + 1], -1});
    }
    const bool is_point = at.empty();
    TraceStep& step = run_.step("result", "result",
                                what() + (is_point             ? " is seen as a point: nothing is drawn."
                                          : visible.empty()    ? " is hidden along its whole length."
                                          : lines.size() == 1U ? " is visible along its whole length."
                                                               : " is visible between the intervals of the union."));
    mark(step);
    for (const TraceBar& b : visible) step.number("visible", trace_text(b.from) + " … " + trace_text(b.to));
    step.bars("visible", visible).draw(lines);
  }

 private:
  /// Faces that hide nothing, one after the other, are one step.
  void tell_none(std::uint32_t face) {
    if (nothing_.empty()) mark(run_.step("no-shadow", "none", ""));
    if (std::find(nothing_.begin(), nothing_.end(), face) != nothing_.end()) return;
    nothing_.push_back(face);
    std::string names;
    for (const std::uint32_t f : nothing_) names += (names.empty() ? "" : ", ") + picture_.name(f);
    run_.steps.back().face(face).says(names + (nothing_.size() == 1 ? " is" : " are each") +
                                      " beside the edge in the image, or not in front of it: nothing of it is hidden.");
  }

  std::string what() const {
    return "Edge " + std::to_string(mesh_.edges[edge_].a.value) + "–" + std::to_string(mesh_.edges[edge_].b.value);
  }
  void mark(TraceStep& step) const { step.edge(edge_.value); }
  TracePlace place(double t) const {
    const Point3 &a = mesh_.points[mesh_.edges[edge_].a], &b = mesh_.points[mesh_.edges[edge_].b];
    return picture_.at(Point3{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)});
  }
  std::string cut_name(const Cut& cut) const {
    switch (cut.kind) {
      case Cut::Kind::start:
      case Cut::Kind::end:
        return "nothing: an end of the edge";
      case Cut::Kind::sight:
        return "the view plane of edge " + std::to_string(std::min(cut.u, cut.v)) + "–" +
               std::to_string(std::max(cut.u, cut.v));
      case Cut::Kind::face:
        return "the plane of " + picture_.name(mesh_.face_of[TriangleId(cut.u)].value);
      default:
        return "a line within a plane seen edge-on";
    }
  }

  const ScenePicture& picture_;
  const Mesh& mesh_;
  TraceRun& run_;
  EdgeId edge_;
  std::vector<TraceBar> shadows_, united_;
  std::vector<std::uint32_t> nothing_;  // faces of the last step that hide nothing
  double before_end_ = 0;
  int asked_ = 0;
};

}  // namespace

Trace explain_roberts(const ExplainedScene& scene, int /*size*/) {
  check_explainable(scene);
  const ScenePicture picture(scene, 0);
  Trace trace;
  trace.scene = picture.traced(true);
  trace.pseudocode = page_text("roberts.txt");
  TraceRun& run = trace.run("each edge against each face");
  Teller teller(picture, run);
  LineOptions options;
  options.method = LineMethod::roberts;
  options.why = true;
  // Where faces pierce each other is a line of no edge, and of no name here.
  options.classes[static_cast<std::size_t>(EdgeClass::intersection)] = false;
  const VisibleLines lines = visible_lines(SceneView(scene.mesh, scene.view), options, teller);
  end_with_lines(run, picture, lines);
  return trace;
}

}  // namespace hsr::internal
