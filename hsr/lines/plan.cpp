#include "hsr/lines/plan.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <string>

#include "geometry/cancel.h"
#include "geometry/error.h"
#include "geometry/parallel.h"
#include "hsr/lines/appel.h"
#include "hsr/lines/behind_caps.h"
#include "hsr/lines/classified_edges.h"
#include "hsr/lines/convex_body.h"
#include "hsr/lines/count_observer.h"
#include "hsr/lines/hidden_classes.h"
#include "hsr/lines/image_mask.h"
#include "hsr/lines/inside_bodies.h"
#include "hsr/lines/lines_in_cells.h"
#include "hsr/lines/near_parts.h"
#include "hsr/lines/roberts.h"
#include "hsr/lines/shadow_observer.h"
#include "hsr/scene/line_filter.h"
#include "hsr/scene/view_parts.h"
#include "hsr/view/frustum.h"

// What a scene does not need is left out here, before the methods, and the method is chosen.

namespace hsr {

using namespace internal;

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
  Plan(const SceneView& scene, const LineOptions& options);

  /// @param observer, counts of roberts, and of appel, or null
  VisibleLines run(ShadowObserver* observer = nullptr, CountObserver* counts = nullptr) const;
  const LinePlan& outcome() const { return outcome_; }
  const std::vector<EdgeId>& in_doubt() const { return requested_->in_doubt; }

 private:
  void find_intersections();
  void add_ghosts();
  void leave_out_same_shapes();
  void find_intersection_boxes();
  void classify_intersections(const NearParts& near);
  void leave_out_far_sides();
  void leave_out_hidden();
  void leave_out_far_faces();
  void choose_method();
  VisibleLines classes_by_visibility(VisibleLines all) const;
  bool few_edges(std::size_t share) const { return requested_->edges.size() * share < parts_.mesh().triangles.size(); }
  /// Whether a stage is run; else says why not.
  bool wants(Stage stage, const char* name);
  void say(const char* stage, std::string why) { outcome_.left_out.push_back({stage, std::move(why)}); }
  bool appel_pays() const;

  const LineOptions& options_;
  const ViewParts& parts_;
  const ProjectedMesh& projected_;
  Excluded excluded_;  // which triangles are no candidates
  std::optional<ViewFrustum> outside_;
  std::optional<NearStretches> near_stretches_;  // with a tolerance
  std::optional<ClassifiedEdges> requested_;
  const Intersections* intersections_ = nullptr;  // null: there is none
  std::vector<Intersection> merged_segments_;
  struct SegmentClass {
    EdgeClass seen;
    EdgeClass hidden;
  };
  std::vector<SegmentClass> segment_classes_;  // of these; empty: all are intersections
  std::vector<ImageBox> meet_boxes_;           // of these
  std::optional<Occluders> near_request_;      // without faces that overlap nothing that is asked for
  std::optional<LineMethod> method_;           // nothing: one convex body takes none
  LinePlan outcome_;
};

std::optional<ViewFrustum> outside_frame(const SceneView& scene, const LineOptions& options) {
  if (!options.frame || !scene.view().is_perspective() || scene.options().when(Stage::frame) == When::never) return {};
  return ViewFrustum(scene.mesh(), scene.view(), *options.frame);
}

Plan::Plan(const SceneView& scene, const LineOptions& options)
    : options_(options),
      parts_(scene.parts()),
      projected_(parts_.projected(options.stop)),
      excluded_(options.why ? Excluded::none : Excluded::hidden_or_capped),
      outside_(outside_frame(scene, options)) {
  const Mesh& mesh = parts_.mesh();
  find_intersections();
  // Faces that may contain an edge, and so count for its class: all, or those that are not hidden.
  const Occluders* const containing =
      intersections_ == nullptr
          ? nullptr
          : &parts_.occluders(parts_.options().hidden_lines ? Excluded::none : Excluded::hidden, options_.stop);
  const EdgeClassifier classifier(projected_, parts_.labels(), parts_.marks(), options);
  std::optional<NearParts> near;
  if (options.tolerance > 0) {
    near_stretches_.emplace(projected_, parts_.space_tree(), options.tolerance);
    near.emplace(classifier, parts_.view(), *near_stretches_);
  }
  if (near) classify_intersections(*near);
  const InsideBodies inside(parts_, options.tolerance);
  requested_.emplace(classifier, options, outside_ ? &*outside_ : nullptr, containing,
                     intersections_ == nullptr ? std::vector<std::uint8_t>() : intersections_->has_contact,
                     parts_.options().hidden_lines, near ? &*near : nullptr, &inside);
  add_ghosts();
  if (requested_->edges.size() < mesh.edges.size())
    say("edges", of(mesh.edges.size() - requested_->edges.size(), mesh.edges.size(),
                    outside_ ? "edges are outside the picture, or of classes that are not asked for"
                             : "edges are of classes that are not asked for"));
  leave_out_far_sides();
  if (parts_.is_one_convex_body(options_.stop) && !options_.why) return;
  leave_out_hidden();
  leave_out_far_faces();
  choose_method();
}

/// Among themselves as in a scene of nothing else.
void Plan::add_ghosts() {
  const Mesh* const ghosts = parts_.mesh().ghosts.get();
  if (ghosts == nullptr) return;
  const ProjectedMesh projected(*ghosts, parts_.view(), projected_.arithmetic());
  const EdgeClassifier classifier(projected, parts_.labels(), parts_.marks(), options_);
  requested_->add_ghosts(projected_, classifier, options_, outside_ ? &*outside_ : nullptr);
}

void Plan::find_intersections() {
  if (!options_.why && parts_.is_one_convex_body(options_.stop)) {
    say("intersections", "the faces of one convex body meet in their edges only");
    return;
  }
  intersections_ = &parts_.intersections(options_.stop);
  if (!options_.classes[static_cast<std::size_t>(EdgeClass::intersection)] && options_.tolerance == 0) {
    say("intersections", "they are not asked for");
    return;
  }
  if (intersections_->segments.empty()) say("intersections", "no two faces pierce each other");
  merged_segments_ = merge_segments(projected_, intersections_->segments);
  leave_out_same_shapes();
  find_intersection_boxes();
}

/// Where a shaft fills a hole, facets of both pierce each other, and the surfaces that they stand for do not.
void Plan::leave_out_same_shapes() {
  const std::vector<std::uint32_t>& shape = parts_.labels().shape;
  if (shape.empty() || options_.diagonals) return;
  const auto shape_of = [&](FacetId facet) { return shape[parts_.mesh().face_of[first_triangle(facet)].value]; };
  const auto left_out = std::erase_if(merged_segments_, [&](const Intersection& meet) {
    return shape_of(meet.s) != FaceLabels::none && shape_of(meet.s) == shape_of(meet.t);
  });
  if (left_out > 0) say("intersections", std::to_string(left_out) + " are of faces that are parts of one shape");
}

/// Where noise makes two faces pierce each other the line has the class that it has without, and may be none that is asked for.
void Plan::classify_intersections(const NearParts& near) {
  std::vector<Intersection> asked_for;
  TriangleOcclusion occlusion(projected_);
  for (const Intersection& meet : merged_segments_)
    for (const EdgePart& part : near.of_intersection(occlusion, meet)) {
      const SegmentClass classes{*part.found.seen, *part.found.hidden};
      const auto is_wanted = [&](EdgeClass c) { return options_.classes[static_cast<std::size_t>(c)]; };
      if (!is_wanted(classes.seen) && !is_wanted(classes.hidden)) continue;
      asked_for.push_back({meet.s, meet.t, part.from, part.to});
      segment_classes_.push_back(classes);
    }
  merged_segments_ = std::move(asked_for);
  find_intersection_boxes();
}

void Plan::find_intersection_boxes() {
  meet_boxes_.resize(merged_segments_.size());
  parallel_for_each(merged_segments_.size(), [&](std::size_t i) { meet_boxes_[i] = box_of(projected_, merged_segments_[i]); });
}

bool Plan::wants(Stage stage, const char* name) {
  const char* why_not = options_.why                                        ? "hidden faces are to be named, too"
                        : parts_.options().arithmetic != Arithmetic::staged ? "arithmetic is compared without it"
                        : parts_.options().when(stage) == When::never       ? "not asked for"
                                                                            : nullptr;
  if (why_not != nullptr) say(name, why_not);
  return why_not == nullptr;
}

/// The far sides of bodies hide nothing that their near sides do not, and one convex body hides nothing else.
void Plan::leave_out_far_sides() {
  const bool wants_back_faces = wants(Stage::back_faces, "back faces");
  if (wants(Stage::convex_body, "convex body")) {
    if (parts_.is_one_convex_body(options_.stop)) {
      outcome_.method = "none";
      say("convex body", "all of it: of one convex body, what is turned to the eye is visible");
      return;
    }
    say("convex body", "the scene is not one convex body");
  }
  if (!wants_back_faces) return;
  const ClosedBodies& bodies = *parts_.bodies_with_caps(options_.stop);
  if (bodies.count() == 0) {
    say("back faces", "no component is proven to be a closed body all of which one point inside sees");
    return;
  }
  const std::size_t edges_before = count(requested_->hidden);
  requested_->hidden.resize(requested_->edges.size(), 0);
  parallel_for_each(requested_->edges.size(), [&](std::size_t i) {
    const Edge& e = parts_.mesh().edges[requested_->edges[i]];
    const Sign at_a = projected_.beyond_near(e.a), at_b = projected_.beyond_near(e.b);
    // Of an edge of a body that is cut only what is left is hidden, and one that lies in the plane may not be.
    const bool is_beyond = at_a != Sign::negative && at_b != Sign::negative && (at_a != Sign::zero || at_b != Sign::zero);
    if (is_beyond && bodies.is_on_far_side(requested_->edges[i])) requested_->hidden[i] = 1;
  });
  say("back faces", of(count(bodies.far_sides()), bodies.far_sides().size(), "triangles and ") +
                        of(count(requested_->hidden) - edges_before, requested_->hidden.size(), "edges are far sides of ") +
                        std::to_string(bodies.count()) + (bodies.count() == 1 ? " closed body" : " closed bodies"));
}

/// Faces that are hidden hide nothing that what hides them does not, and edges that are hidden need no test.
void Plan::leave_out_hidden() {
  if (!wants(Stage::hidden_tiles, "hidden tiles")) return;
  const Mesh& mesh = parts_.mesh();
  const OcclusionPyramid* const tiles = parts_.pyramid(options_.stop);
  if (tiles == nullptr) {
    say("hidden tiles", "no face is large and near enough to hide much");
    return;
  }
  const std::size_t edges_before = count(requested_->hidden);
  requested_->hidden.resize(requested_->edges.size(), 0);
  parallel_for_each(requested_->edges.size(), [&](std::size_t i) {
    const Edge& e = mesh.edges[requested_->edges[i]];
    if (!tiles->hides(e)) return;
    Predicates exact = projected_.predicates();
    if (!LineFilter(projected_, e.a, e.b).is_point(exact)) requested_->hidden[i] = 1;
  });
  say("hidden tiles",
      of(count(parts_.hidden_or_capped(options_.stop)), mesh.triangles.size(), "triangles (far sides among them) and ") +
          of(count(requested_->hidden) - edges_before, requested_->hidden.size(),
             "more edges lie behind others that cover their part of the image"));
}

/// Where few edges are asked for, the triangles that overlap none of them in the image are no candidates. They still count as
/// layers, as those that are hidden do not.
void Plan::leave_out_far_faces() {
  const When when = parts_.options().when(Stage::far_faces);
  if (when == When::never || (when == When::automatic && !few_edges(8))) {
    say("far faces", when == When::never ? "not asked for" : "too many edges are asked for");
    return;
  }
  std::vector<ImageBox> asked_for = requested_->boxes;
  asked_for.insert(asked_for.end(), meet_boxes_.begin(), meet_boxes_.end());
  const std::vector<std::uint8_t> hidden =
      excluded_ == Excluded::hidden_or_capped ? parts_.hidden_or_capped(options_.stop) : std::vector<std::uint8_t>();
  const std::size_t triangles = parts_.mesh().triangles.size();
  const ImageMask mask(asked_for, triangles);
  std::vector<std::uint8_t> far = hidden;
  far.resize(triangles, 0);
  parallel_for_each(triangles, [&](std::size_t i) {
    if (!mask.touches(projected_.box(TriangleId(i)))) far[i] = 1;
  });
  const std::size_t more = count(far) - count(hidden);
  if (more > 0) near_request_.emplace(projected_, far);
  say("far faces", of(more, far.size(), "triangles overlap no edge that is asked for, as seen"));
}

/// Appel looks at occluding edges where roberts looks at faces, and then has the counts to carry on.
bool Plan::appel_pays() const {
  const OccludingEdges& layers = parts_.occluding_edges(excluded_, options_.stop);
  const std::size_t faces = tbb::parallel_reduce(
      Range(0, parts_.mesh().triangles.size(), block), std::size_t{0},
      [&](const Range& range, std::size_t n) {
        for (std::size_t t = range.begin(); t < range.end(); ++t) n += layers.counts(TriangleId(t)) ? 1U : 0U;
        return n;
      },
      std::plus<>());
  return layers.edges().size() <= faces;
}

void Plan::choose_method() {
  const auto roberts_because = [&](const char* why) {
    say("appel", why);
    outcome_.method = "roberts";
    method_ = LineMethod::roberts;
  };
  const bool is_automatic = options_.method == LineMethod::automatic;
  if (options_.method == LineMethod::roberts) return roberts_because("roberts is asked for");
  if (options_.why) return roberts_because("the faces that hide are to be named");
  if (is_automatic && parts_.options().arithmetic != Arithmetic::staged)
    return roberts_because("arithmetic is compared by roberts");
  // To count the layers takes a look at every edge of the mesh.
  if (is_automatic && few_edges(32)) return roberts_because("few edges are asked for");
  if (is_automatic && !appel_pays()) return roberts_because("nearly every edge is an outline or a boundary");
  outcome_.method = "appel";
  method_ = LineMethod::appel;
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

VisibleLines Plan::run(ShadowObserver* observer, CountObserver* counts) const {
  VisibleLines all;
  if (!method_) {
    all = lines_of_convex_body(projected_, *requested_, *parts_.bodies(options_.stop), options_);
  } else {
    const Occluders& occluders = near_request_ ? *near_request_ : parts_.occluders(excluded_, options_.stop);
    all = *method_ == LineMethod::appel
              ? appel(projected_, *requested_, parts_.occluding_edges(excluded_, options_.stop), occluders, options_, counts)
              : roberts(projected_, *requested_, occluders, options_, options_.why ? nullptr : parts_.pyramid(options_.stop),
                        observer);
    if (!merged_segments_.empty())
      append(all, lines_of_intersections(projected_, merged_segments_, meet_boxes_, occluders, options_, observer));
  }
  if (parts_.mesh().ghosts != nullptr)
    for (std::size_t i = 0; i < requested_->edges.size(); ++i) all.lines[i].is_ghost = requested_->is_ghost(i);
  if (intersections_ != nullptr) all.decisions += intersections_->decisions;
  all.intersections = merged_segments_;
  all.plan = outcome_;
  if (const SectionCaps* const caps = parts_.caps(options_.stop))
    all = behind_caps(projected_, *caps, options_, std::move(all));
  return classes_by_visibility(std::move(all));
}

/// Where the class of a line depends on whether it is hidden, and those of lines in which faces pierce each other.
VisibleLines Plan::classes_by_visibility(VisibleLines all) const {
  ClassesByVisibility hidden;
  const auto set = [&](std::size_t i, const ByVisibility& classes) {
    hidden.resize(all.lines.size());
    hidden[i] = classes;
  };
  if (requested_->has_hidden_classes)
    for (std::size_t i = 0; i < requested_->edges.size(); ++i)
      if (const RequestedPart p = (*requested_)[i]; p.hidden || p.behind_seen) set(i, {p.hidden, p.behind_seen});
  for (std::size_t i = requested_->edges.size(); i < all.lines.size() && !segment_classes_.empty(); ++i) {
    const SegmentClass& classes = segment_classes_[all.lines[i].intersection];
    all.lines[i].edge_class = classes.seen;
    if (classes.hidden != classes.seen) set(i, {classes.hidden, {}});
  }
  std::optional<NearOccluders> near;
  if (near_stretches_ && requested_->has_hidden_classes && parts_.options().hidden_lines)
    near.emplace(NearOccluders{*near_stretches_, parts_.occluders(Excluded::none, options_.stop)});
  return with_hidden_classes(projected_, parts_.view(), *requested_, options_, near ? &*near : nullptr, hidden, std::move(all));
}

}  // namespace

LinePlan internal::plan_lines(const SceneView& scene, const LineOptions& options) {
  if (scene.view().has_cells()) return plan_lines(scene.parts().cells().front().scene, options);
  return Plan(scene, options).outcome();
}

VisibleLines internal::visible_lines_and_doubts(const SceneView& scene, const LineOptions& options,
                                                std::vector<EdgeId>& in_doubt) {
  const Plan plan(scene, options);
  in_doubt = plan.in_doubt();
  return plan.run();
}

VisibleLines internal::visible_lines(const SceneView& scene, const LineOptions& options, ShadowObserver& observer) {
  require(options.method == LineMethod::roberts && options.why,
          "visible_lines: watched are the shadows that roberts casts, all of them");
  return Plan(scene, options).run(&observer);
}

VisibleLines internal::visible_lines(const SceneView& scene, const LineOptions& options, CountObserver& observer) {
  require(options.method == LineMethod::appel && !options.why, "visible_lines: watched are the layers that appel counts");
  return Plan(scene, options).run(nullptr, &observer);
}

VisibleLines visible_lines(const SceneView& scene, const LineOptions& options) {
  require(options.method != LineMethod::appel || !options.why,
          "visible_lines: appel counts layers and does not say which faces they are; roberts does");
  if ((scene.view().has_section() || scene.view().has_cells()) && options.why)
    throw InputError("section: its caps hide, too, and are no faces to be named, expected a view without a section, or no why");
  throw_if_stopped(options.stop);
  if (scene.view().has_cells()) return lines_in_cells(scene, options);
  return Plan(scene, options).run();
}

}  // namespace hsr
