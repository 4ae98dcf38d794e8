#include "hsr/lines/plan.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <string>

#include "geometry/error.h"
#include "geometry/parallel.h"
#include "hsr/lines/classified_edges.h"
#include "hsr/lines/image_mask.h"
#include "hsr/lines/methods.h"
#include "hsr/scene/occluding_edges.h"
#include "hsr/scene/closed_bodies.h"
#include "hsr/scene/intersections.h"
#include "hsr/scene/line_filter.h"
#include "hsr/scene/occluders.h"
#include "hsr/scene/occlusion_pyramid.h"
#include "hsr/scene/projected_mesh.h"
#include "hsr/view/frustum.h"

// What a scene does not need is left out here, before the methods, and the method is chosen.

namespace hsr {

namespace {

using Range = tbb::blocked_range<std::size_t>;
constexpr std::size_t block = 1024;

std::size_t count(const std::vector<std::uint8_t>& flags) {
  return static_cast<std::size_t>(std::count(flags.begin(), flags.end(), std::uint8_t{1}));
}

std::string of(std::size_t part, std::size_t all, const char* what) {
  return std::to_string(part) + " of " + std::to_string(all) + " " + what;
}

class Plan {
 public:
  Plan(const Mesh& mesh, const View& view, const LineOptions& options);

  VisibleLines run() const;
  const LinePlan& outcome() const { return outcome_; }

 private:
  void find_bodies();
  void find_occluders();
  void find_contacts();
  void leave_out_far_sides();
  void leave_out_hidden();
  void choose_method();
  bool few_edges(std::size_t share) const { return requested_->edges.size() * share < projected_.mesh().triangles.size(); }
  std::vector<std::uint8_t> far_from_requested();
  /// Whether to run a stage that a request for few edges does not pay for; else says why not.
  bool wants(LineStage stage, const char* name);
  void say(const char* stage, std::string why) { outcome_.left_out.push_back({stage, std::move(why)}); }
  bool appel_pays() const;

  const LineOptions& options_;
  ProjectedMesh projected_;
  std::optional<ViewFrustum> outside_;
  std::optional<ClassifiedEdges> requested_;
  Intersections intersections_;
  std::vector<Intersection> merged_segments_;
  std::vector<ImageBox> meet_boxes_;    // of these
  std::vector<ImageBox> boxes_;         // of the triangles
  std::vector<std::uint8_t> left_out_;  // by triangle: whole faces; empty: none
  std::optional<ClosedBodies> bodies_;
  std::optional<Occluders> occluders_;
  std::optional<OccludingEdges> layers_;
  LinePlan outcome_;
};

std::optional<ViewFrustum> outside_frame(const Mesh& mesh, const View& view, const LineOptions& options) {
  if (!options.frame || !view.is_perspective() || options.when(LineStage::frame) == When::never) return {};
  return ViewFrustum(mesh, view, *options.frame);
}

Plan::Plan(const Mesh& mesh, const View& view, const LineOptions& options)
    : options_(options), projected_(mesh, view, options.arithmetic), outside_(outside_frame(mesh, view, options)) {
  find_bodies();
  find_contacts();
  requested_.emplace(projected_, options, outside_ ? &*outside_ : nullptr, occluders_ ? &*occluders_ : nullptr,
                     intersections_.has_contact);
  if (requested_->edges.size() < mesh.edges.size())
    say("edges", of(mesh.edges.size() - requested_->edges.size(), mesh.edges.size(),
                    outside_ ? "edges are outside the picture, or of classes that are not asked for"
                             : "edges are of classes that are not asked for"));
  leave_out_far_sides();
  if (outcome_.method == "none") return;
  if (!occluders_) find_occluders();  // a convex body, but it was not to be left at that
  leave_out_hidden();
  const std::vector<std::uint8_t> far = far_from_requested();
  if (count(far) > 0) occluders_.emplace(projected_, boxes_, far);
  choose_method();
}

/// What would make the search for contacts needless, too.
void Plan::find_bodies() {
  if (options_.why || options_.arithmetic != Arithmetic::staged) return;
  if (options_.when(LineStage::back_faces) == When::never && options_.when(LineStage::convex_body) == When::never) return;
  bodies_.emplace(projected_);
}

void Plan::find_occluders() {
  boxes_.resize(projected_.mesh().triangles.size());
  parallel_for_each(boxes_.size(), [&](std::size_t i) { boxes_[i] = projected_.box(TriangleId(i)); });
  occluders_.emplace(projected_, boxes_, left_out_);
}

void Plan::find_contacts() {
  if (bodies_ && options_.when(LineStage::convex_body) != When::never && bodies_->is_one_convex_body()) {
    say("intersections", "the faces of one convex body meet in their edges only");
    return;
  }
  find_occluders();
  intersections_ = find_intersections(projected_, *occluders_);
  if (!options_.classes[static_cast<std::size_t>(EdgeClass::intersection)]) {
    say("intersections", "they are not asked for");
    return;
  }
  if (intersections_.segments.empty()) say("intersections", "no two faces pierce each other");
  merged_segments_ = merge_segments(projected_, intersections_.segments);
  meet_boxes_.resize(merged_segments_.size());
  parallel_for_each(merged_segments_.size(), [&](std::size_t i) { meet_boxes_[i] = box_of(projected_, merged_segments_[i]); });
}

bool Plan::wants(LineStage stage, const char* name) {
  const When when = options_.when(stage);
  const char* why_not = options_.why                                ? "hidden faces are to be named, too"
                        : options_.arithmetic != Arithmetic::staged ? "arithmetic is compared without it"
                        : when == When::never                       ? "not asked for"
                        : when == When::automatic && few_edges(8)   ? "few edges are asked for"
                                                                    : nullptr;
  if (why_not != nullptr) say(name, why_not);
  return why_not == nullptr;
}

/// The far sides of bodies hide nothing that their near sides do not, and one convex body hides nothing else.
void Plan::leave_out_far_sides() {
  const bool wants_back_faces = wants(LineStage::back_faces, "back faces");
  const bool wants_convex_body = wants(LineStage::convex_body, "convex body");
  if (!wants_back_faces && !wants_convex_body) return;
  const ClosedBodies& bodies = *bodies_;
  if (wants_convex_body && bodies.is_one_convex_body()) {
    outcome_.method = "none";
    say("convex body", "all of it: of one convex body, what is turned to the eye is visible");
    return;
  }
  if (wants_convex_body) say("convex body", "the scene is not one convex body");
  if (!wants_back_faces) return;
  if (bodies.count() == 0) {
    say("back faces", "no component is proven to be a closed body all of which one point inside sees");
    return;
  }
  left_out_ = bodies.far_sides();
  requested_->hidden.resize(requested_->edges.size());
  parallel_for_each(requested_->edges.size(),
                    [&](std::size_t i) { requested_->hidden[i] = bodies.is_on_far_side(requested_->edges[i]) ? 1 : 0; });
  say("back faces", of(count(left_out_), left_out_.size(), "triangles and ") +
                        of(count(requested_->hidden), requested_->hidden.size(), "edges are far sides of ") +
                        std::to_string(bodies.count()) + (bodies.count() == 1 ? " closed body" : " closed bodies"));
}

/// Faces that are hidden hide nothing that what hides them does not, and edges that are hidden need no test.
void Plan::leave_out_hidden() {
  if (!wants(LineStage::hidden_tiles, "hidden tiles")) return;
  const Mesh& mesh = projected_.mesh();
  const OcclusionPyramid pyramid(projected_, options_.when(LineStage::hidden_tiles) == When::always);
  if (pyramid.is_empty()) {
    say("hidden tiles", "no face is large and near enough to hide much");
    return;
  }
  const std::size_t faces_before = count(left_out_), edges_before = count(requested_->hidden);
  pyramid.mark_hidden(left_out_);
  requested_->hidden.resize(requested_->edges.size(), 0);
  parallel_for_each(requested_->edges.size(), [&](std::size_t i) {
    const Edge& e = mesh.edges[requested_->edges[i]];
    if (!pyramid.hides(e)) return;
    Predicates exact = projected_.predicates();
    if (!LineFilter(projected_, e.a, e.b).is_point(exact)) requested_->hidden[i] = 1;
  });
  say("hidden tiles", of(count(left_out_) - faces_before, left_out_.size(), "triangles and ") +
                          of(count(requested_->hidden) - edges_before, requested_->hidden.size(),
                             "edges lie behind others that cover their part of the image"));
}

/// The triangles that are no candidates for any edge: those left out, and where few edges are asked for, those that overlap
/// none of them in the image. The far ones still count as layers, the others do not.
std::vector<std::uint8_t> Plan::far_from_requested() {
  const When when = options_.when(LineStage::far_faces);
  if (when == When::never || (when == When::automatic && !few_edges(8))) {
    say("far faces", when == When::never ? "not asked for" : "too many edges are asked for");
    return left_out_;
  }
  std::vector<ImageBox> asked_for = requested_->boxes;
  asked_for.insert(asked_for.end(), meet_boxes_.begin(), meet_boxes_.end());
  const ImageMask mask(asked_for);
  std::vector<std::uint8_t> far = left_out_;
  far.resize(boxes_.size(), 0);
  parallel_for_each(boxes_.size(), [&](std::size_t i) {
    if (!mask.touches(boxes_[i])) far[i] = 1;
  });
  say("far faces", of(count(far) - count(left_out_), far.size(), "triangles overlap no edge that is asked for, as seen"));
  return far;
}

/// Appel looks at occluding edges where roberts looks at faces, and then has the counts to carry on.
bool Plan::appel_pays() const {
  const std::size_t faces = tbb::parallel_reduce(
      Range(0, projected_.mesh().triangles.size(), block), std::size_t{0},
      [&](const Range& range, std::size_t n) {
        for (std::size_t t = range.begin(); t < range.end(); ++t) n += layers_->counts(TriangleId(t)) ? 1U : 0U;
        return n;
      },
      std::plus<>());
  return layers_->edges().size() <= faces;
}

void Plan::choose_method() {
  const auto roberts_because = [&](const char* why) {
    say("appel", why);
    outcome_.method = "roberts";
  };
  const bool is_automatic = options_.method == LineMethod::automatic;
  if (options_.method == LineMethod::roberts) return roberts_because("roberts is asked for");
  if (options_.why) return roberts_because("the faces that hide are to be named");
  if (is_automatic && options_.arithmetic != Arithmetic::staged) return roberts_because("arithmetic is compared by roberts");
  // To count the layers takes a look at every edge of the mesh.
  if (is_automatic && few_edges(32)) return roberts_because("few edges are asked for");
  layers_.emplace(projected_, left_out_);
  if (is_automatic && !appel_pays()) return roberts_because("nearly every edge is an outline or a boundary");
  outcome_.method = "appel";
}

void append(VisibleLines& all, const VisibleLines& more) {
  const auto shift = [](std::size_t n) { return static_cast<std::uint32_t>(n); };
  if (all.cuts.size() + more.cuts.size() > 0xffffffffU || all.occluders.size() + more.occluders.size() > 0xffffffffU)
    throw InputError("the drawing has more than 2^32 - 1 interval ends, expected fewer");
  for (Line line : more.lines) {
    line.first_cut += shift(all.cuts.size());
    line.end_cut += shift(all.cuts.size());
    line.first_occluder += shift(all.occluders.size());
    line.end_occluder += shift(all.occluders.size());
    all.lines.push_back(line);
  }
  all.cuts.insert(all.cuts.end(), more.cuts.begin(), more.cuts.end());
  all.occluders.insert(all.occluders.end(), more.occluders.begin(), more.occluders.end());
  all.pairs += more.pairs;
  all.decisions += more.decisions;
}

VisibleLines Plan::run() const {
  VisibleLines all = outcome_.method == "none"    ? lines_of_convex_body(projected_, *requested_, *bodies_, options_)
                     : outcome_.method == "appel" ? appel(projected_, *requested_, *layers_, *occluders_, options_)
                                                  : roberts(projected_, *requested_, *occluders_, options_);
  all.decisions += intersections_.decisions;
  if (!merged_segments_.empty())
    append(all, lines_of_intersections(projected_, merged_segments_, meet_boxes_, *occluders_, options_));
  all.intersections = merged_segments_;
  all.plan = outcome_;
  return all;
}

}  // namespace

LinePlan plan_lines(const Mesh& mesh, const View& view, const LineOptions& options) {
  return Plan(mesh, view, options).outcome();
}

VisibleLines visible_lines(const Mesh& mesh, const View& view, const LineOptions& options) {
  return Plan(mesh, view, options).run();
}

}  // namespace hsr
