// Ray casting, told by the exact caster.
#include <algorithm>
#include <set>

#include "hsr/raster/cast_observer.h"
#include "study/explain/explained_methods.h"
#include "study/explain/picture_result.h"
#include "study/page_texts.h"

namespace hsr::internal {

namespace {

/// What becomes of one triangle that a packet tries.
struct Trial {
  TriangleId triangle;
  int apart = -1;  // a side that has no ray of the packet on its inner side
  std::vector<CastComparison> met;

  /// Whether the same is said of both, but for the numbers.
  bool is_like(const Trial& other) const {
    return triangle == other.triangle && apart == other.apart &&
           std::equal(met.begin(), met.end(), other.met.begin(), other.met.end(), [](const auto& a, const auto& b) {
             return a.nearest == b.nearest && a.is_nearest == b.is_nearest && a.is_exact == b.is_exact;
           });
  }
};

/// Packets that lie beside each other and have the same trials.
struct Group {
  int left = 0, top = 0, right = 0, bottom = 0;
  std::vector<Trial> trials;
};

class Teller : public CastObserver {
 public:
  Teller(const ScenePicture& picture, int width, TraceRun& run)
      : picture_(picture), width_(width), run_(run), shown_(picture.samples().width, picture.samples().height) {
    start_ = &run_.step("start", "ray", "");
  }

  void packet(int left, int top, int right, int bottom) override {
    join();
    packet_ = {left, top, right, bottom, {}};
    is_open_ = true;
  }
  void tried(TriangleId t) override { packet_.trials.push_back({t, -1, {}}); }
  void apart(TriangleId /*t*/, int side) override { packet_.trials.back().apart = side; }
  void compared(const CastComparison& c) override { packet_.trials.back().met.push_back(c); }
  void tried_all_rays(TriangleId /*t*/) override { all_ += 1; }

  void end(std::size_t boxes) {
    join();
    finish();
    const auto packets = static_cast<std::size_t>((shown_.width + width_ - 1) / width_) *
                         static_cast<std::size_t>((shown_.height + width_ - 1) / width_);
    start_->says(width_ == 1
                     ? "A ray goes from the viewer through each sample. " + std::to_string(boxes) +
                           " triangles are in a tree of boxes."
                     : "Rays go in packets of " + std::to_string(width_) + " × " + std::to_string(width_) +
                           ": the tree is asked once for all of them. " + std::to_string(boxes) + " triangles are in it.");
    run_.step("end", "show",
              "All rays are cast: of " + std::to_string(packets * boxes) + " pairs of a " + (width_ == 1 ? "ray" : "packet") +
                  " and a triangle " + std::to_string(all_) + " were looked at.")
        .number("pairs of all", std::to_string(packets * boxes))
        .number("pairs that were tried", std::to_string(all_));
  }

 private:
  std::uint32_t face(TriangleId t) const { return picture_.scene().mesh.face_of[t].value; }
  std::string name(TriangleId t) const {
    const ExplainedScene& scene = picture_.scene();
    const bool is_one_of_several = scene.model.polygons[face(t)].size() > 3;
    return (is_one_of_several ? "a triangle of " : "") + picture_.name(face(t));
  }

  /// The packet that ended, with those before it where they are like it.
  void join() {
    if (!is_open_) return;
    is_open_ = false;
    const bool goes_on = has_group_ && width_ == 1 && packet_.top == group_.top && packet_.left == group_.right &&
                         std::equal(packet_.trials.begin(), packet_.trials.end(), group_.trials.begin(), group_.trials.end(),
                                    [](const Trial& a, const Trial& b) { return a.is_like(b); });
    if (goes_on) {
      group_.right = packet_.right;
      return;
    }
    finish();
    group_ = packet_;
    has_group_ = true;
  }

  std::string who() const {
    if (width_ > 1)
      return "Packet of columns " + std::to_string(group_.left) + " … " + std::to_string(group_.right - 1) + ", rows " +
             std::to_string(group_.top) + " … " + std::to_string(group_.bottom - 1);
    return "Row " + std::to_string(group_.top) + ", " + columns_text(group_.left, group_.right);
  }

  TraceStep& step(const char* kind, const char* line, const std::string& says) {
    TraceStep& made = run_.step(kind, line, says);
    mark_frame(made, group_.left, group_.top, group_.right, group_.bottom);
    return made;
  }

  void finish() {
    if (!has_group_) return;
    has_group_ = false;
    std::vector<TraceItem> tried;
    std::string names;
    std::set<std::uint32_t> faces;
    for (const Trial& t : group_.trials) {
      tried.push_back({picture_.name(face(t.triangle)), static_cast<int>(face(t.triangle))});
      if (faces.insert(face(t.triangle)).second) names += (names.empty() ? "" : ", ") + picture_.name(face(t.triangle));
    }
    const bool is_many = group_.right - group_.left > 1;
    if (tried.empty()) {
      std::vector<TraceCell> cells;
      for (int j = group_.top; j < group_.bottom; ++j)
        for (int i = group_.left; i < group_.right; ++i) cells.push_back({i, j, "", -1});
      step("none", "boxes", who() + ": no box is met. The background is seen.").list(list_name, {}).cells(cells);
      return;
    }
    step("boxes", "boxes",
         who() + ": " +
             (is_many && width_ == 1 ? "each ray meets"
              : width_ == 1          ? "the ray meets"
                                     : "the packet meets") +
             (tried.size() == 1 ? " the box of one triangle, of "
                                : " the boxes of " + std::to_string(tried.size()) + " triangles, of ") +
             names + ".")
        .list(list_name, tried);
    TraceStep* last = nullptr;
    for (const Trial& t : group_.trials) last = &tell(t);
    std::vector<TraceCell> cells;
    for (int j = group_.top; j < group_.bottom; ++j)
      for (int i = group_.left; i < group_.right; ++i) {
        const TriangleId t = width_ == 1 ? shown_.at(group_.left, j) : shown_.at(i, j);
        cells.push_back({i, j, t.is_valid() ? picture_.name(face(t)) : "", t.is_valid() ? static_cast<int>(face(t)) : -1});
      }
    if (width_ == 1 && tried.size() == 1) {  // all is said
      last->cells(cells).list(list_name, {});
      return;
    }
    const TriangleId first = shown_.at(group_.left, group_.top);
    std::string says = who() + ": ";
    if (width_ > 1)
      says += "each sample shows the nearest face that its ray met.";
    else
      says += first.is_valid() ? picture_.name(face(first)) + " is seen." : "nothing was met; the background is seen.";
    step("show", "show", says).cells(cells).list(list_name, {});
  }

  TraceStep& tell(const Trial& t) {
    const std::string who = name(t.triangle);
    if (t.met.empty()) {
      TraceStep& made = step("miss", "apart",
                             "The box of " + who + " is met, " + who +
                                 " is not: " + (width_ == 1 ? "the ray is" : "all rays are") + " outside one of its sides.");
      return made.face(face(t.triangle));
    }
    if (width_ > 1) {
      std::size_t nearest = 0;
      for (const CastComparison& c : t.met) {
        if (c.is_nearest) shown_.at(c.column, c.row) = t.triangle;
        nearest += c.is_nearest ? 1 : 0;
      }
      return step("compare", "compare",
                  std::to_string(t.met.size()) +
                      (t.met.size() == 1 ? " ray of the packet meets " : " rays of the packet meet ") + who + "; on " +
                      std::to_string(nearest) + " of them it is the nearest so far.")
          .face(face(t.triangle));
    }
    const CastComparison& c = t.met.front();
    if (c.is_nearest)
      for (int i = group_.left; i < group_.right; ++i) shown_.at(i, group_.top) = t.triangle;
    if (!c.nearest.is_valid()) {
      return step("meet", "meets",
                  "The ray meets " + who + " with nearness " + trace_text(c.nearness) + ". Nothing was met before: it is kept.")
          .face(face(t.triangle))
          .number("nearness of " + picture_.name(face(t.triangle)), c.nearness);
    }
    const std::string before = name(c.nearest);
    std::string says = "The ray meets " + who + ", too. ";
    if (c.is_exact) says += "Doubles do not tell which of it and " + before + " is nearer: that is decided exactly. ";
    says +=
        c.is_nearest ? "It is nearer than " + before + ", and is kept instead." : "It is behind " + before + ", which stays.";
    TraceStep& made = step(c.is_exact ? "exact" : "compare", c.is_exact ? "exact" : "compare", says);
    made.face(face(t.triangle))
        .number("nearness of " + picture_.name(face(t.triangle)), c.nearness)
        .number("nearness held, of " + picture_.name(face(c.nearest)), c.held)
        .number("doubles tell beyond", c.error);
    const std::uint32_t a = face(c.nearest), b = face(t.triangle);
    if (a == b || c.is_exact || asked_.size() >= 6 || !asked_.insert({a, b, c.is_nearest}).second) return made;
    return made.ask({"The ray of column " + std::to_string(c.column) + ", row " + std::to_string(c.row) + " has met " +
                         picture_.name(a) + " with nearness " + trace_text(c.held) + ", and now meets " + picture_.name(b) +
                         " with nearness " + trace_text(c.nearness) + ". Which is kept?",
                     {picture_.name(a), picture_.name(b)},
                     c.is_nearest ? 1U : 0U});
  }

  static constexpr const char* list_name = "triangles whose boxes are met, the nearest boxes first";

  const ScenePicture& picture_;
  int width_;
  TraceRun& run_;
  Image<TriangleId> shown_;
  TraceStep* start_ = nullptr;
  Group packet_, group_;
  bool is_open_ = false, has_group_ = false;
  std::size_t all_ = 0;
  std::set<std::tuple<std::uint32_t, std::uint32_t, bool>> asked_;
};

}  // namespace

Trace explain_ray_casting(const ExplainedScene& scene, int size) {
  check_explainable(scene);
  const ScenePicture picture(scene, size);
  Trace trace;
  trace.scene = picture.traced(false);
  trace.pseudocode = page_text("ray-casting.txt");
  for (const auto& [name, width] : {std::pair("ray by ray", 1), std::pair("packets of 4 × 4 rays", 4)}) {
    TraceRun& run = trace.run(name);
    Teller teller(picture, width, run);
    const WatchedCast result = cast(SceneView(scene.mesh, scene.view), picture.samples(), width, teller);
    teller.end(result.boxes);
    run.result = faces_result(picture, result.image.triangles);
  }
  return trace;
}

}  // namespace hsr::internal
