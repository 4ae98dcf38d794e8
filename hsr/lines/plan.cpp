#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <string>

#include "hsr/image_line.h"
#include "hsr/lines/hidden_tiles.h"
#include "hsr/lines/image_mask.h"
#include "hsr/lines/layers.h"
#include "hsr/lines/methods.h"
#include "hsr/lines/occluders.h"
#include "hsr/lines/requested_edges.h"
#include "hsr/sight.h"

// What a scene does not need is left out here, before the methods, and the method is chosen.

namespace hsr {

namespace {

using Range = tbb::blocked_range<std::size_t>;
constexpr std::size_t block = 1024;

template <class F>
void for_each(std::size_t n, const F& visit) {
  tbb::parallel_for(Range(0, n, block), [&](const Range& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) visit(i);
  });
}

std::size_t count(const std::vector<std::uint8_t>& flags) {
  return static_cast<std::size_t>(std::count(flags.begin(), flags.end(), std::uint8_t{1}));
}

std::string of(std::size_t part, std::size_t all, const char* what) {
  return std::to_string(part) + " of " + std::to_string(all) + " " + what;
}

class Plan {
 public:
  Plan(const Sight& sight, const LineOptions& options) : sight_(sight), options_(options) {}

  VisibleLines lines();

 private:
  void leave_out_hidden(RequestedEdges& requested);
  std::vector<std::uint8_t> far_from(const RequestedEdges& requested);
  void say(const char* stage, std::string why) { left_out_.push_back({stage, std::move(why)}); }
  bool appel_pays(const Layers& layers) const;

  const Sight& sight_;
  const LineOptions& options_;
  std::vector<ImageBox> boxes_;       // of the triangles
  std::vector<std::uint8_t> hidden_;  // by triangle: left out; empty: none
  std::vector<LeftOut> left_out_;
};

/// Faces that are hidden hide nothing that what hides them does not, and edges that are hidden need no test.
void Plan::leave_out_hidden(RequestedEdges& requested) {
  const Mesh& mesh = sight_.mesh();
  if (options_.why || options_.hidden_tiles == Stage::never) {
    say("hidden tiles", options_.why ? "hidden faces are to be named, too" : "not asked for");
    return;
  }
  if (options_.hidden_tiles == Stage::automatic && requested.edges.size() * 8 < mesh.triangles.size()) {
    say("hidden tiles", "few edges are asked for");
    return;
  }
  const HiddenTiles tiles(sight_, boxes_, options_.hidden_tiles == Stage::always);
  if (tiles.is_empty()) {
    say("hidden tiles", "no face is large and near enough to hide much");
    return;
  }
  // Whole faces: where the triangles of a planar face meet, the mesh has no edge.
  hidden_.assign(mesh.triangles.size(), 0);
  for_each(mesh.faces.size(), [&](std::size_t f) {
    const std::uint32_t first = mesh.first_triangle[FaceId(f)], end = mesh.first_triangle[FaceId(f + 1)];
    for (std::uint32_t t = first; t < end; ++t)
      if (sight_.reaches_before_near(TriangleId(t)) || !tiles.hides(mesh.triangles[TriangleId(t)], boxes_[t].nearest)) return;
    std::fill(hidden_.begin() + first, hidden_.begin() + end, std::uint8_t{1});
  });
  requested.hidden.assign(requested.edges.size(), 0);
  for_each(requested.edges.size(), [&](std::size_t i) {
    const Edge& e = mesh.edges[requested.edges[i]];
    if (sight_.beyond_near(e.a) == Sign::negative || sight_.beyond_near(e.b) == Sign::negative) return;
    if (!tiles.hides(std::array{e.a, e.b}, requested.boxes[i].nearest)) return;
    Predicates exact = sight_.predicates();
    if (!ImageLine(sight_, e.a, e.b).is_point(exact)) requested.hidden[i] = 1;
  });
  say("hidden faces", of(count(hidden_), hidden_.size(), "triangles lie behind others that cover their part of the image"));
  say("hidden edges", of(count(requested.hidden), requested.hidden.size(), "edges lie behind such triangles"));
}

/// The triangles that are no candidates for any edge: hidden ones, and where few edges are asked for, those that overlap none
/// of them in the image. The far ones still count as layers, the hidden ones do not.
std::vector<std::uint8_t> Plan::far_from(const RequestedEdges& requested) {
  if (requested.edges.size() * 8 > boxes_.size()) return hidden_;
  const ImageMask mask(requested.boxes);
  std::vector<std::uint8_t> far = hidden_;
  far.resize(boxes_.size(), 0);
  for_each(boxes_.size(), [&](std::size_t i) {
    if (!mask.touches(boxes_[i])) far[i] = 1;
  });
  say("far faces", of(count(far), far.size(), "triangles are hidden or overlap no edge that is asked for"));
  return far;
}

/// Appel looks at occluding edges where roberts looks at faces, and then has the counts to carry on.
bool Plan::appel_pays(const Layers& layers) const {
  std::size_t faces = 0;
  for (std::size_t t = 0; t < sight_.mesh().triangles.size(); ++t) faces += layers.counts(TriangleId(t)) ? 1U : 0U;
  return layers.edges().size() < faces;
}

VisibleLines Plan::lines() {
  RequestedEdges requested(sight_, options_);
  const Mesh& mesh = sight_.mesh();
  boxes_.resize(mesh.triangles.size());
  for_each(boxes_.size(), [&](std::size_t i) { boxes_[i] = sight_.box(TriangleId(i)); });
  leave_out_hidden(requested);
  const std::vector<std::uint8_t> far = far_from(requested);
  const Occluders occluders(sight_, boxes_, far);
  const auto by_roberts = [&](const char* why) {
    say("appel", why);
    return roberts(sight_, requested, occluders, options_);
  };
  const auto found = [&] {
    if (options_.method == LineMethod::roberts) return by_roberts("roberts is asked for");
    if (options_.why) return by_roberts("the faces that hide are to be named");
    if (options_.method == LineMethod::automatic && options_.arithmetic != Arithmetic::staged)
      return by_roberts("arithmetic is compared by roberts");
    // To count the layers takes a look at every edge of the mesh.
    if (options_.method == LineMethod::automatic && requested.edges.size() * 32 < mesh.triangles.size())
      return by_roberts("few edges are asked for");
    const Layers layers(sight_, hidden_);
    if (options_.method == LineMethod::automatic && !appel_pays(layers))
      return by_roberts("nearly every edge is an outline or a boundary");
    return appel(sight_, requested, layers, occluders, options_);
  };
  VisibleLines all = found();
  all.left_out = std::move(left_out_);
  return all;
}

}  // namespace

VisibleLines visible_lines(const Mesh& mesh, const View& view, const LineOptions& options) {
  const Sight sight(mesh, view, options.arithmetic);
  return Plan(sight, options).lines();
}

}  // namespace hsr
