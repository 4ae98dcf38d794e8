#include "hsr/surfaces/section_in_cells.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "hsr/scene/view_parts.h"
#include "hsr/surfaces/cutting_planes.h"
#include "hsr/surfaces/edge_on_caps.h"
#include "hsr/surfaces/place_numbers.h"
#include "hsr/surfaces/plane_rings.h"
#include "hsr/surfaces/region_clipper.h"

namespace hsr::internal {

namespace {

/// A part of the line in which two planes meet that a cap ends at, in the direction in which it has the cap on its left.
struct FoldSide {
  RationalVector from, to;
  std::uint32_t object;
  FaceId face;
  bool is_reversed;  ///< against the direction that all on the line are compared in
};

class CellSections {
 public:
  explicit CellSections(const SceneView& scene) : scene_(scene), view_(scene.view()), labels_(scene.labels()) {}

  Section united() {
    for (const ViewParts::Cell& cell : scene_.parts().cells())
      if (cell.scene.view().section) add(cell);
    std::stable_sort(section_.caps.begin(), section_.caps.end(),
                     [](const SectionCap& x, const SectionCap& y) { return x.object < y.object; });
    for (auto& [line, sides] : folds_) add_fold(sides);
    for (SectionLine& line : edge_on_cap_lines(scene_)) section_.lines.push_back(std::move(line));
    return std::move(section_);
  }

 private:
  void add(const ViewParts::Cell& cell) {
    const Section found = section(cell.scene);
    const SectionPlane& plane = *cell.scene.view().section;
    RationalVector toward;
    for (std::size_t k = 0; k < 3; ++k) toward[k] = -rational(plane.normal)[k];
    std::vector<CuttingPlane> cutters;
    for (const CellSide& side : cell.cell.sides) cutters.push_back(cutting_plane_of(view_, side));
    const std::size_t folds = cutters.size();
    if (view_.far) cutters.push_back(before_far(view_));
    for (const SectionCap& cap : found.caps) add_cap(cell, found, cap, toward, cutters, folds);
    bool has_open = false;
    for (SectionLine line : found.lines) {
      const bool is_left = std::all_of(cutters.begin(), cutters.end(),
                                       [&](const CuttingPlane& cutter) { return keep(cutter, line.ends[0], line.ends[1]); });
      if (!is_left || (line.edge_class != EdgeClass::boundary && is_of_others(line, cell, cutters, toward))) continue;
      has_open = has_open || line.edge_class == EdgeClass::boundary;
      section_.lines.push_back(std::move(line));
    }
    if (has_open) section_.open_outlines += found.open_outlines;
  }
  /// Lines between caps of two planes are found with what is on both sides; and along the side of a cell that has no other plane beyond it
  /// what is there is not of this cap.
  static bool is_of_others(const SectionLine& line, const ViewParts::Cell& cell, const std::vector<CuttingPlane>& cutters,
                           const RationalVector& toward) {
    for (std::size_t k = 0; k < cell.cell.sides.size(); ++k) {
      const CuttingPlane& cutter = cutters[k];
      if (cutter.at(line.ends[0]).sign() != Sign::zero || cutter.at(line.ends[1]).sign() != Sign::zero) continue;
      if (cell.cell.sides[k].u != cell.cell.sides[k].v) return true;
      const RationalVector left = cross(toward, minus(line.ends[1], line.ends[0]));
      const bool is_left = dot(cutter.gradient, left).sign() == Sign::positive;
      const bool is_mirrored = cell.scene.parts().caps()->is_mirrored();
      if (line.objects[is_left != is_mirrored ? 0 : 1] == SectionLine::none) return true;
    }
    return false;
  }

  void add_cap(const ViewParts::Cell& cell, const Section& found, SectionCap cap, const RationalVector& toward,
               const std::vector<CuttingPlane>& cutters, std::size_t folds) {
    std::vector<RegionSide> sides;
    for (std::uint32_t r = cap.first_ring; r < cap.end_ring; ++r) {
      const auto ring = found.rings[r];
      for (std::size_t k = 0; k < ring.size(); ++k) sides.push_back({ring[k], ring[(k + 1) % ring.size()]});
    }
    for (std::uint32_t k = 0; k < cutters.size(); ++k) keep_of_cap(cutters[k], k, toward, sides);
    const auto [face, is_new] = lowest_face_.emplace(cap.object, cap.face);
    if (!is_new) face->second = std::min(face->second, cap.face);
    for (const RegionSide& side : sides) {
      if (side.cut_by >= folds) continue;
      const CellSide& fold = cell.cell.sides[side.cut_by];
      if (fold.u != fold.v) add_fold_side(side, cap);
    }
    cap.plane = static_cast<std::uint8_t>(cell.cell.plane == 0 ? 0 : cell.cell.plane - 1);
    cap.first_ring = static_cast<std::uint32_t>(section_.rings.size());
    for (const auto& ring : rings_of(sides, toward)) section_.rings.push_row(ring);
    cap.end_ring = static_cast<std::uint32_t>(section_.rings.size());
    if (cap.end_ring > cap.first_ring) section_.caps.push_back(cap);
  }
  /// A plane that is parallel to the cap leaves all of it, or nothing.
  static void keep_of_cap(const CuttingPlane& cutter, std::uint32_t name, const RationalVector& toward,
                          std::vector<RegionSide>& sides) {
    const RationalVector across = cross(cutter.gradient, toward);
    const bool is_parallel =
        std::all_of(across.begin(), across.end(), [](const Rational& x) { return x.sign() == Sign::zero; });
    if (!is_parallel)
      keep(cutter, name, toward, sides);
    else if (!sides.empty() && cutter.at(sides.front().from).sign() == Sign::negative)
      sides.clear();
  }

  /// Without corners at which a ring goes straight on.
  static std::vector<std::vector<RationalVector>> rings_of(const std::vector<RegionSide>& sides, const RationalVector& toward) {
    std::size_t dropped = 0;
    while (toward[dropped].sign() == Sign::zero) ++dropped;
    const bool is_mirrored = toward[dropped].sign() == Sign::negative;
    const auto flat = [&](const RationalVector& p) {
      const Rational &x = p[(dropped + 1) % 3], &y = p[(dropped + 2) % 3];
      return is_mirrored ? PlanePlace{y, x} : PlanePlace{x, y};
    };
    std::vector<PlanePlace> places;  // of each side the first and the last
    places.reserve(2 * sides.size());
    for (const RegionSide& side : sides)
      for (const RationalVector* end : {&side.from, &side.to}) places.push_back(flat(*end));
    std::vector<NumberedPlace> ends;
    for (const PlanePlace& place : places) ends.push_back({&place, {place[0].to_double(), place[1].to_double()}});
    const std::vector<std::uint32_t> numbers = place_numbers(ends);
    std::vector<PlaneSide> flat_sides;
    for (std::size_t k = 0; k < sides.size(); ++k)
      flat_sides.push_back({&places[2 * k], &places[2 * k + 1], numbers[2 * k], numbers[2 * k + 1]});
    const auto along = [&](std::size_t k) {
      const PlanePlace &from = places[2 * k], &to = places[2 * k + 1];
      return PlanePlace{to[0] - from[0], to[1] - from[1]};
    };
    std::vector<std::vector<RationalVector>> rings;
    for (const std::vector<std::size_t>& linked : plane_rings(flat_sides)) {
      auto& ring = rings.emplace_back();
      for (std::size_t k = 0; k < linked.size(); ++k) {
        const std::size_t before = linked[(k + linked.size() - 1) % linked.size()];
        if (cross(along(before), along(linked[k])).sign() != Sign::zero) ring.push_back(sides[linked[k]].from);
      }
    }
    return rings;
  }

  /// Lines in space by a direction, whose first entry that is not 0 is 1, and the point of it where that coordinate is 0.
  using LineKey = std::pair<RationalVector, RationalVector>;

  void add_fold_side(const RegionSide& side, const SectionCap& cap) {
    RationalVector direction = minus(side.to, side.from);
    std::size_t axis = 0;
    while (direction[axis].sign() == Sign::zero) ++axis;
    const Rational length = direction[axis];
    RationalVector foot;
    for (Rational& x : direction) x = x / length;
    for (std::size_t k = 0; k < 3; ++k) foot[k] = side.from[k] - side.from[axis] * direction[k];
    folds_[{direction, foot}].push_back({side.from, side.to, cap.object, cap.face, length.sign() == Sign::negative});
  }

  /// Between caps of the same objects a joint, as between what has one material.
  void add_fold(const std::vector<FoldSide>& sides) {
    std::set<RationalVector> places;  // along the line, as its direction is positive in the first coordinate that changes
    for (const FoldSide& side : sides) places.insert({side.from, side.to});
    std::optional<SectionLine> last;
    const auto end_last = [&] {
      if (last) section_.lines.push_back(*last);
      last.reset();
    };
    for (auto at = places.begin(); at != places.end() && std::next(at) != places.end(); ++at) {
      const RationalVector &from = *at, &to = *std::next(at);
      std::array<std::map<std::uint32_t, FaceId>, 2> caps;  // on the left and on the right
      for (const FoldSide& side : sides)
        if (std::min(side.from, side.to) <= from && to <= std::max(side.from, side.to))
          caps[side.is_reversed ? 1 : 0].emplace(side.object, side.face);
      if (caps[0].empty() && caps[1].empty()) {
        end_last();
        continue;
      }
      const SectionLine line = line_between(from, to, caps);
      if (last && last->ends[1] == from && last->objects == line.objects && last->edge_class == line.edge_class) {
        last->ends[1] = to;
        continue;
      }
      end_last();
      last = line;
    }
    end_last();
  }
  SectionLine line_between(const RationalVector& from, const RationalVector& to,
                           const std::array<std::map<std::uint32_t, FaceId>, 2>& caps) const {
    const auto lowest = [&](std::size_t own) {
      for (const auto& [object, face] : caps[own])
        if (!caps[1 - own].contains(object)) return object;
      return caps[own].empty() ? SectionLine::none : caps[own].begin()->first;
    };
    SectionLine line;
    line.ends = {from, to};
    line.objects = {lowest(0), lowest(1)};
    line.face = (caps[0].empty() ? caps[1] : caps[0]).begin()->second;
    const auto [left, right] = line.objects;
    const auto material_of = [&](std::uint32_t object) {
      return labels_.material.empty() ? 0 : labels_.material[lowest_face_.at(object).value];
    };
    if (left == SectionLine::none || right == SectionLine::none)
      line.edge_class = EdgeClass::section;
    else
      line.edge_class = left != right && material_of(left) != material_of(right) ? EdgeClass::material : EdgeClass::joint;
    return line;
  }

  const SceneView& scene_;
  const View& view_;
  const FaceLabels& labels_;
  Section section_;
  std::map<std::uint32_t, FaceId> lowest_face_;  // by object
  std::map<LineKey, std::vector<FoldSide>> folds_;
};

}  // namespace

Section section_in_cells(const SceneView& scene) { return CellSections(scene).united(); }

}  // namespace hsr::internal
