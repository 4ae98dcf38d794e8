#include "hsr/scene/view_parts.h"

#include <algorithm>

#include "geometry/parallel.h"

namespace hsr {

using namespace internal;

SceneView::SceneView(const Scene& scene, const View& view, const SceneOptions& options)
    : scene_(scene), parts_(std::make_shared<const ViewParts>(scene.parts_, view, options)) {}

const View& SceneView::view() const { return parts_->view(); }

const SceneOptions& SceneView::options() const { return parts_->options(); }

ViewParts::ViewParts(std::shared_ptr<const SceneParts> scene, const View& view, const SceneOptions& options)
    : scene_(std::move(scene)), view_(view), options_(options) {}

ViewParts::ViewParts(const ViewParts& base, const BitRange& others)
    : scene_(base.scene_), view_(base.view_), options_(base.options_), others_(others), base_(&base) {}

const ViewParts& ViewParts::shared() const {
  return base_ != nullptr && projected().is_scaled_like(base_->projected()) ? *base_ : *this;
}

const ProjectedMesh& ViewParts::projected(const std::stop_token& stop) const {
  return projected_.get(stop, [&] { return ProjectedMesh(mesh(), view_, options_.arithmetic, others_, options_.coplanar); });
}

const std::vector<ViewParts::Cell>& ViewParts::cells() const {
  return cells_.get([&] {
    std::vector<Cell> cells;
    for (SectionCell& cell : section_cells(view_)) {
      const SceneView scene(Scene(scene_), cell.view, options_);
      cells.push_back({std::move(cell), scene});
    }
    return cells;
  });
}

const SectionCaps* ViewParts::caps(const std::stop_token& stop) const {
  if (!view_.section) return nullptr;
  if (&shared() != this) return shared().caps(stop);
  const ProjectedMesh& mesh = projected(stop);
  return &caps_.get(stop, [&] { return SectionCaps(mesh, view_, labels()); });
}

const ClosedBodies* ViewParts::bodies(const std::stop_token& stop) const {
  const ProjectedMesh& mesh = projected(stop);
  const auto& bodies = bodies_.get(stop, [&]() -> std::optional<ClosedBodies> {
    const bool is_needed = options_.when(Stage::back_faces) != When::never || options_.when(Stage::convex_body) != When::never;
    if (options_.arithmetic != Arithmetic::staged || !is_needed) return std::nullopt;
    return std::optional<ClosedBodies>(std::in_place, mesh, scene_->bodies());
  });
  return bodies ? &*bodies : nullptr;
}

const ClosedBodies* ViewParts::bodies_with_caps(const std::stop_token& stop) const {
  // What tiles hide of an edge ends where some occluder's shadow does, which may be that of a far side.
  if (!view_.section || bodies(stop) == nullptr || pyramid(stop) != nullptr) return bodies(stop);
  const ProjectedMesh& mesh = projected(stop);
  return &*bodies_with_caps_.get(
      stop, [&]() -> std::optional<ClosedBodies> { return ClosedBodies::with_caps(mesh, scene_->bodies(), labels()); });
}

bool ViewParts::is_one_convex_body(const std::stop_token& stop) const {
  if (options_.when(Stage::convex_body) == When::never) return false;
  const ClosedBodies* const all = bodies(stop);
  return all != nullptr && all->is_one_convex_body();
}

const OcclusionPyramid* ViewParts::pyramid(const std::stop_token& stop) const {
  const ProjectedMesh& mesh = projected(stop);
  return pyramid_
      .get(stop,
           [&]() -> std::unique_ptr<const OcclusionPyramid> {
             const When when = options_.when(Stage::hidden_tiles);
             if (options_.arithmetic != Arithmetic::staged || when == When::never) return nullptr;
             auto pyramid = std::make_unique<const OcclusionPyramid>(mesh, when == When::always);
             return pyramid->is_empty() ? nullptr : std::move(pyramid);
           })
      .get();
}

std::vector<std::uint8_t> ViewParts::hidden_by(const ClosedBodies* closed, const std::stop_token& stop) const {
  const OcclusionPyramid* const tiles = pyramid(stop);
  std::vector<std::uint8_t> hidden;
  if (closed != nullptr && closed->count() > 0 && options_.when(Stage::back_faces) != When::never) hidden = closed->far_sides();
  if (tiles != nullptr) {
    hidden.resize(mesh().triangles.size(), 0);
    tiles->mark_hidden(hidden);
  }
  if (std::find(hidden.begin(), hidden.end(), std::uint8_t{1}) == hidden.end()) hidden.clear();
  return hidden;
}

const std::vector<std::uint8_t>& ViewParts::hidden(const std::stop_token& stop) const {
  const ClosedBodies* const closed = bodies(stop);
  return hidden_.get(stop, [&] { return hidden_by(closed, stop); });
}

const std::vector<std::uint8_t>& ViewParts::hidden_or_capped(const std::stop_token& stop) const {
  const ClosedBodies* const closed = bodies_with_caps(stop);
  if (closed == bodies(stop)) return hidden(stop);
  return hidden_or_capped_.get(stop, [&] { return hidden_by(closed, stop); });
}

const std::vector<std::uint8_t>& ViewParts::flags(Excluded excluded, const std::stop_token& stop) const {
  static const std::vector<std::uint8_t> none;
  switch (excluded) {
    case Excluded::hidden:
      return hidden(stop);
    case Excluded::edge_on: {
      const ProjectedMesh& mesh = projected(stop);
      return edge_on_.get(stop, [&] {
        std::vector<std::uint8_t> edge_on(this->mesh().triangles.size());
        parallel_for_each(edge_on.size(),
                          [&](std::size_t i) { edge_on[i] = mesh.facing(TriangleId(i)) == Sign::zero ? 1 : 0; });
        if (std::find(edge_on.begin(), edge_on.end(), std::uint8_t{1}) == edge_on.end()) edge_on.clear();
        return edge_on;
      });
    }
    case Excluded::hidden_and_edge_on: {
      const auto &hidden = flags(Excluded::hidden, stop), &edge_on = flags(Excluded::edge_on, stop);
      if (hidden.empty()) return edge_on;
      if (edge_on.empty()) return hidden;
      return hidden_or_edge_on_.get(stop, [&] {
        std::vector<std::uint8_t> either = hidden;
        parallel_for_each(either.size(), [&](std::size_t i) { either[i] |= edge_on[i]; });
        return either;
      });
    }
    case Excluded::hidden_or_capped:
      return hidden_or_capped(stop);
    case Excluded::none:
      break;
  }
  return none;
}

const std::vector<std::uint8_t>& ViewParts::hidden_or_edge_on(const std::stop_token& stop) const {
  return flags(Excluded::hidden_and_edge_on, stop);
}

bool ViewParts::has_edge_on(const std::stop_token& stop) const { return !flags(Excluded::edge_on, stop).empty(); }

/// The name under which the same set is kept: a tree is made once for all that come to the same.
Excluded ViewParts::needed(Excluded excluded, const std::stop_token& stop) const {
  if (excluded == Excluded::hidden_or_capped) {
    if (!hidden_or_capped(stop).empty() && hidden_or_capped(stop) != hidden(stop)) return excluded;
    excluded = Excluded::hidden;
  }
  const bool hidden = (excluded == Excluded::hidden || excluded == Excluded::hidden_and_edge_on) && !this->hidden(stop).empty();
  const bool edge_on = (excluded == Excluded::edge_on || excluded == Excluded::hidden_and_edge_on) && has_edge_on(stop);
  return hidden && edge_on ? Excluded::hidden_and_edge_on
         : hidden          ? Excluded::hidden
         : edge_on         ? Excluded::edge_on
                           : Excluded::none;
}

const Occluders& ViewParts::occluders(Excluded excluded, const std::stop_token& stop) const {
  if (&shared() != this) return shared().occluders(excluded, stop);
  excluded = needed(excluded, stop);
  const ProjectedMesh& mesh = projected(stop);
  const auto& left_out = flags(excluded, stop);
  return occluders_[static_cast<std::size_t>(excluded)].get(stop, [&] { return Occluders(mesh, left_out); });
}

bool ViewParts::is_cut_by_near_plane() const {
  if (!view_.cuts()) return false;
  for (std::size_t t = 0; t < mesh().triangles.size(); ++t)
    if (projected().reaches_before_near(TriangleId(t))) return true;
  return false;
}

/// Of the faces that another view has found to meet, or else by a search; what a complete search finds is kept for other views.
Intersections ViewParts::find(Excluded excluded, const OcclusionPyramid* tiles, const std::stop_token& stop) const {
  const bool is_exact = options_.arithmetic != Arithmetic::double_only;
  if (const auto known = is_exact ? scene_->meeting_faces() : nullptr)
    return intersections_of(projected(stop), *known, flags(excluded, stop), stop);
  Intersections found = find_intersections(projected(stop), occluders(excluded, stop), tiles, stop);
  if (is_exact && excluded == Excluded::none && !is_cut_by_near_plane()) scene_->keep(meeting_faces(found));
  return found;
}

const Intersections& ViewParts::intersections(const std::stop_token& stop) const {
  const Excluded excluded = options_.hidden_lines ? Excluded::none : Excluded::hidden;
  const OcclusionPyramid* const tiles = options_.hidden_lines ? nullptr : pyramid(stop);
  return intersections_.get(stop, [&] { return find(excluded, tiles, stop); });
}

const Intersections& ViewParts::visible_intersections(const std::stop_token& stop) const {
  if (!options_.hidden_lines || intersections_.is_made()) return intersections(stop);
  const OcclusionPyramid* const tiles = pyramid(stop);
  return visible_intersections_.get(stop, [&] { return find(Excluded::hidden_and_edge_on, tiles, stop); });
}

const OccludingEdges& ViewParts::occluding_edges(Excluded excluded, const std::stop_token& stop) const {
  excluded = needed(excluded, stop);
  const ProjectedMesh& mesh = projected(stop);
  const auto& left_out = flags(excluded, stop);
  return occluding_edges_[static_cast<std::size_t>(excluded)].get(stop, [&] { return OccludingEdges(mesh, left_out); });
}

const ViewParts& ViewParts::with(const BitRange& others) const {
  BitRange both = others_;
  both.add(others);
  if (both == others_ || projected().covers(others)) return *this;
  const std::lock_guard lock(mutex_);
  for (const auto& parts : with_)
    if (parts->others_ == both) return *parts;
  with_.push_back(std::unique_ptr<const ViewParts>(new ViewParts(*this, both)));
  return *with_.back();
}

}  // namespace hsr
