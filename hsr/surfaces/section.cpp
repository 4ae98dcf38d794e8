#include "hsr/surfaces/section.h"

#include <algorithm>
#include <map>
#include <utility>

#include "geometry/view_plane.h"
#include "hsr/scene/view_parts.h"
#include "hsr/surfaces/cap_arrangement.h"
#include "hsr/surfaces/plane_rings.h"
#include "hsr/surfaces/section_in_cells.h"

namespace hsr {

using namespace internal;

namespace {

/// Links parts that have the inside on their left to rings, without corners at which a ring goes straight on.
/// @return of each ring the parts that begin at its corners
std::vector<std::vector<DirectedPart>> rings_of(const std::vector<DirectedPart>& bounds) {
  std::vector<PlaneSide> sides;
  sides.reserve(bounds.size());
  for (const DirectedPart& bound : bounds)
    sides.push_back({&bound.from(), &bound.to(), bound.from_number(), bound.to_number()});
  std::vector<std::vector<DirectedPart>> rings;
  for (const std::vector<std::size_t>& linked : plane_rings(sides)) {
    auto& ring = rings.emplace_back();
    for (std::size_t k = 0; k < linked.size(); ++k) {
      const std::size_t before = linked[(k + linked.size() - 1) % linked.size()];
      if (!bounds[before].is_parallel_to(bounds[linked[k]])) ring.push_back(bounds[linked[k]]);
    }
  }
  return rings;
}

class SectionMaker {
 public:
  SectionMaker(const SceneView& scene, const SectionCaps& caps)
      : mesh_(scene.mesh()), labels_(scene.labels()), caps_(caps), arrangement_(caps) {}

  Section made() {
    section_.open_outlines = caps_.open_outlines();
    for (const CapSide& s : caps_.sides()) {
      const FaceId face = mesh_.face_of[s.triangle];
      const auto [at, is_new] = lowest_face_.emplace(s.object, face);
      if (!is_new) at->second = std::min(at->second, face);
    }
    find_bounds();
    for (const auto& [object, face] : lowest_face_) add_cap(object, face);
    add_lines();
    add_open_lines();
    return std::move(section_);
  }

 private:
  /// The parts that have an object on one side only, object by object, with the object on their left.
  void find_bounds() {
    for (const CapPart& part : arrangement_.parts())
      for (const bool is_right : {false, true})
        for (const std::uint32_t object : is_right ? part.right : part.left) {
          const std::vector<std::uint32_t>& other = is_right ? part.left : part.right;
          if (!std::binary_search(other.begin(), other.end(), object)) bounds_[object].push_back({&part, is_right});
        }
  }

  void add_cap(std::uint32_t object, FaceId face) {
    const std::vector<DirectedPart>& bounds = bounds_[object];
    SectionCap cap{object, face, 0, static_cast<std::uint32_t>(section_.rings.size()), 0};
    for (auto& ring : rings_of(bounds)) {
      if (caps_.is_mirrored()) std::reverse(ring.begin(), ring.end());
      std::vector<std::array<Rational, 3>> points;
      points.reserve(ring.size());
      for (const DirectedPart& c : ring) points.push_back(arrangement_.point(c.part->side, c.from()));
      section_.rings.push_row(points);
    }
    cap.end_ring = static_cast<std::uint32_t>(section_.rings.size());
    if (cap.end_ring > cap.first_ring) section_.caps.push_back(cap);
  }

  std::uint32_t material_of(std::uint32_t object) const {
    return labels_.material.empty() ? 0 : labels_.material[lowest_face_.at(object).value];
  }
  /// The lowest on each side; of a side whose objects are all on the other side, too, against the lowest of those that are not.
  static std::array<std::uint32_t, 2> objects_of(const DirectedPart& part) {
    const auto lowest = [](const std::vector<std::uint32_t>& own, const std::vector<std::uint32_t>& other) {
      for (const std::uint32_t object : own)
        if (!std::binary_search(other.begin(), other.end(), object)) return object;
      return own.empty() ? SectionLine::none : own.front();
    };
    return {lowest(part.left(), part.right()), lowest(part.right(), part.left())};
  }
  EdgeClass class_of(const std::array<std::uint32_t, 2>& objects) const {
    if (objects[0] == SectionLine::none || objects[1] == SectionLine::none) return EdgeClass::section;
    return material_of(objects[0]) != material_of(objects[1]) ? EdgeClass::material : EdgeClass::joint;
  }

  void add_lines() {
    const auto agree = [](const DirectedPart& a, const DirectedPart& b) { return objects_of(a) == objects_of(b); };
    for (const CapRun& run : arrangement_.runs([](const CapPart&) { return true; }, agree)) {
      const auto objects = objects_of(run.first);
      section_.lines.push_back(
          {{arrangement_.point(run.first.part->side, run.first.from()), arrangement_.point(run.last.part->side, run.last.to())},
           class_of(objects),
           objects,
           mesh_.face_of[caps_.sides()[run.first.part->side].triangle]});
    }
  }

  /// Where an open surface is cut it has a border now, which nothing but a cap hides.
  void add_open_lines() {
    for (const CapSide& open : caps_.open_sides()) {
      const RationalVector from = caps_.point(open.from), along = minus(caps_.point(open.to), from);
      const auto at = [&](const Rational& share) {
        return RationalVector{from[0] + share * along[0], from[1] + share * along[1], from[2] + share * along[2]};
      };
      for (const auto& [begin, end] : arrangement_.uncovered(open))
        section_.lines.push_back(
            {{at(begin), at(end)}, EdgeClass::boundary, {SectionLine::none, SectionLine::none}, mesh_.face_of[open.triangle]});
    }
  }

  const Mesh& mesh_;
  const FaceLabels& labels_;
  const SectionCaps& caps_;
  CapArrangement arrangement_;
  std::map<std::uint32_t, FaceId> lowest_face_;  // by object
  std::map<std::uint32_t, std::vector<DirectedPart>> bounds_;
  Section section_;
};

}  // namespace

Section section(const SceneView& scene) {
  if (scene.view().has_cells()) return section_in_cells(scene);
  const SectionCaps* const caps = scene.parts().caps();
  if (caps == nullptr) return {};
  return SectionMaker(scene, *caps).made();
}

}  // namespace hsr
