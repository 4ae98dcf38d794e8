// Visible fragments, told by the code that finds sides along lines and links them into rings.
#include <algorithm>

#include "hsr/scene/facet.h"
#include "hsr/surfaces/fragment_observer.h"
#include "hsr/symbols/constructions.h"
#include "study/explain/explained_methods.h"
#include "study/page_texts.h"

namespace hsr::internal {

namespace {

class Teller : public FragmentObserver {
 public:
  Teller(const ScenePicture& picture, TraceRun& run) : picture_(picture), mesh_(picture.scene().mesh), run_(run) {
    step_of("start", "start",
            "The visible parts of all edges are known, and where faces pierce each other. What is seen on each side of them?");
  }

  void looked_beside(const MapStretch& stretch, std::span<const SeenPart> left, std::span<const SeenPart> right) override {
    const std::string what = name(stretch.line);
    const bool is_meeting = right.empty();
    TraceStep& step =
        is_meeting
            ? step_of("meet", "meet",
                      "Along " + what +
                          " the two faces pierce each other: where one is seen to the left, the other one is to the right.")
            : step_of("look", "look",
                      "A visible part of " + what + ": just to its left is " + seen(left) + ", just to its right " +
                          seen(right) + ".");
    light(step, stretch.line);
    mark(step, stretch.from, stretch.to, first_facet(left, right));
    step.number("left of it, as it runs", seen(left));
    if (is_meeting) return;
    step.number("right of it", seen(right));
    if (left.size() != 1 || right.size() != 1 || ++asked_ > 6) return;
    // The right answer, the face on the other side, paper, and two others.
    std::vector<std::string> names = {seen(right), seen(left), "the paper"};
    for (std::uint32_t f = 0; f < mesh_.faces.size() && names.size() < 5; ++f) names.push_back(face(f));
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    TraceQuestion question{
        "Just to the left of the marked part of " + what + " is " + seen(left) + ". What is seen just to its right?", {}, 0};
    question.right = static_cast<std::size_t>(std::find(names.begin(), names.end(), seen(right)) - names.begin());
    question.choices = std::move(names);
    step.ask(std::move(question));
  }

  void added_side(FacetId facet, const MapSide& side) override {
    const std::uint32_t f = picture_.face_of(facet);
    const TraceLine line{at(facet, side.from), at(facet, side.to), false};
    TraceStep& step =
        step_of("side", "side", "It bounds what is seen of " + face(f) + ": a side, with " + face(f) + " to its left.");
    step.face(f).mark(line).draw({line}).number("from", name(side.from)).number("to", name(side.to));
    step.add("sides", {name(side.from) + " → " + name(side.to), static_cast<int>(f)});
  }

  void linking(FacetId facet, std::size_t sides) override {
    facet_ = facet;
    const std::uint32_t f = picture_.face_of(facet);
    step_of("face", "face", face(f) + " has " + std::to_string(sides) + " sides, in no order: where one ends, another begins.")
        .face(f)
        .number("sides", static_cast<double>(sides));
  }

  void cut_sides(std::size_t pieces, std::size_t left) override {
    TraceStep& step = step_of(
        "cut", "cut",
        pieces == left ? "Cut at the points that lie on them, they are " + std::to_string(pieces) + "; none lies on another."
                       : "Cut at the points that lie on them, they are " + std::to_string(pieces) +
                             "; what runs both ways, or twice, goes.");
    step.face(picture_.face_of(facet_))
        .number("pieces", static_cast<double>(pieces))
        .number("left of them", static_cast<double>(left));
  }

  void closed_ring(std::span<const MapCorner> corners, bool is_outer) override {
    TraceStep& step =
        step_of("ring", is_outer ? "outer" : "hole",
                "From side to side, back to the first: a ring of " + std::to_string(corners.size()) + " corners. " +
                    (is_outer ? "It turns counter-clockwise: it is an outer one." : "It turns clockwise: it is a hole."));
    std::string names;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      names += (names.empty() ? "" : ", ") + name(corners[k].at);
      step.mark({at(facet_, corners[k].at), at(facet_, corners[(k + 1) % corners.size()].at), false});
    }
    step.number("corners", names);
    if (!is_outer || ++asked_rings_ <= 2)
      step.ask({"The marked ring has what is seen of " + face(picture_.face_of(facet_)) +
                    " to its left. Is it an outer ring or a hole?",
                {"an outer ring", "a hole"},
                is_outer ? std::size_t{0} : std::size_t{1}});
  }

  void found(FacetId facet, std::span<const std::span<const MapCorner>> rings) override {
    const std::uint32_t f = picture_.face_of(facet);
    TraceStep& step = step_of(
        "fragment", "fragment",
        "A fragment of " + face(f) + (rings.size() > 1 ? ", with holes: " + std::to_string(rings.size() - 1) + "." : "."));
    std::vector<TraceRing> places;
    for (const auto& ring : rings) {
      TraceRing& to = places.emplace_back();
      for (const MapCorner& c : ring) to.push_back(at(facet, c.at));
    }
    step.make_piece(pieces_, f, picture_.name(f), joined(places))
        .paint(pieces_)
        .piece(pieces_)
        .number("rings", static_cast<double>(rings.size()));
    step.add("fragments", {picture_.name(f), static_cast<int>(f)});
    ++pieces_;
  }

 private:
  /// A sentence begins with a capital.
  TraceStep& step_of(const std::string& kind, const std::string& line, std::string says) {
    if (!says.empty() && says[0] >= 'a' && says[0] <= 'z') says[0] = static_cast<char>(says[0] - 'a' + 'A');
    return run_.step(kind, line, std::move(says));
  }
  /// One ring of all: to each hole and back along one line, as pieces have one ring.
  static TraceRing joined(const std::vector<TraceRing>& rings) {
    TraceRing ring = rings.front();
    ring.push_back(ring.front());
    for (std::size_t k = 1; k < rings.size(); ++k) {
      ring.insert(ring.end(), rings[k].begin(), rings[k].end());
      ring.push_back(rings[k].front());
      ring.push_back(rings.front().front());
    }
    if (rings.size() == 1) ring.pop_back();
    return ring;
  }

  std::string face(std::uint32_t f) const { return "face " + picture_.name(f); }
  std::string face_of(TriangleId t) const { return t.is_valid() ? face(mesh_.face_of[t].value) : "the paper"; }
  std::string seen(std::span<const SeenPart> parts) const {
    std::string text, last;
    for (const SeenPart& p : parts)
      if (const std::string next = face_of(p.seen); next != last) {
        text += (text.empty() ? "" : ", then ") + next;
        last = next;
      }
    return text;
  }
  std::string name(const MapLine& line) const {
    switch (line.kind) {
      case MapLine::Kind::edge:
        return "edge " + std::to_string(line.u) + "–" + std::to_string(line.v);
      case MapLine::Kind::meet:
        return "the line where " + face_of(TriangleId(line.u)) + " meets " + face_of(TriangleId(line.v));
      default:
        return "a cut by the near plane";
    }
  }
  std::string name(const MapPoint& p) const {
    return p.is_vertex ? std::to_string(p.vertex.value) : name(p.l) + " × " + name(p.m);
  }
  TracePlace at(FacetId facet, const MapPoint& p) const {
    return picture_.at(exact_point(mesh_, picture_.scene().view, facet, p));
  }

  TriangleId first_facet(std::span<const SeenPart> left, std::span<const SeenPart> right) const {
    for (const auto parts : {left, right})
      for (const SeenPart& p : parts)
        if (p.seen.is_valid()) return p.seen;
    return {};
  }
  void light(TraceStep& step, const MapLine& line) const {
    if (line.kind == MapLine::Kind::meet)
      for (const std::uint32_t t : {line.u, line.v}) step.face(mesh_.face_of[TriangleId(t)].value);
  }
  /// In the image it makes no difference in the plane of which face the ends are looked up.
  void mark(TraceStep& step, const MapPoint& from, const MapPoint& to, TriangleId beside) const {
    if (!beside.is_valid()) return;
    const FacetId facet = facet_of(mesh_, beside);
    step.mark({at(facet, from), at(facet, to), false});
  }

  const ScenePicture& picture_;
  const Mesh& mesh_;
  TraceRun& run_;
  FacetId facet_;
  std::uint32_t pieces_ = 0;
  int asked_ = 0, asked_rings_ = 0;
};

}  // namespace

Trace explain_fragments(const ExplainedScene& scene, int /*size*/) {
  check_explainable(scene);
  const ScenePicture picture(scene, 0);
  Trace trace;
  trace.scene = picture.traced(true);
  trace.pseudocode = page_text("fragments.txt");
  TraceRun& run = trace.run("sides, then rings");
  Teller teller(picture, run);
  const VisibleFragments found = visible_fragments(SceneView(scene.mesh, scene.view), {}, teller);
  run.step("end", "end", "All fragments: none overlaps another, and together they are the picture.")
      .undraw()
      .number("fragments", static_cast<double>(found.fragments.size()));
  std::string out = "{\"painted\":[";
  for (const Fragment& f : found.fragments) out += (out.back() == '[' ? "" : ",") + std::to_string(picture.face_of(f.facet));
  run.result = out + "]}";
  return trace;
}

}  // namespace hsr::internal
