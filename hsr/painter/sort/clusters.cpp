#include "hsr/painter/sort/clusters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "geometry/parallel.h"
#include "hsr/scene/facet.h"

namespace hsr::internal {

namespace {

struct Range {
  double low = HUGE_VAL, high = -HUGE_VAL;

  void add(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
};

using Box = std::array<Range, 3>;

std::vector<Box> boxes_of(const ProjectedMesh& projected, const FacePieces& pieces) {
  const Mesh& mesh = projected.mesh();
  std::vector<Box> boxes(pieces.size());
  parallel_for_each(boxes.size(), [&](std::size_t i) {
    const auto add = [&](std::span<const VertexId> corners) {
      for (const VertexId v : corners)
        for (std::size_t axis = 0; axis < 3; ++axis) boxes[i][axis].add(projected.point(v)[static_cast<int>(axis)]);
    };
    add(pieces.rings[i]);
    if (!pieces.rings[i].empty()) return;
    const TriangleId end = facet_end(mesh, pieces.facet[i]);
    for (TriangleId t = first_triangle(pieces.facet[i]); t < end; t = TriangleId(t.value + 1U)) add(mesh.triangles[t]);
  });
  return boxes;
}

/// An axis in steps of one length. Which step a coordinate is in never falls as the coordinate rises, however it is rounded:
/// what is in different steps is apart.
class Steps {
 public:
  Steps(const Range& range, int count) : low_(range.low), high_(range.high), count_(count) { scale_ = count / (high_ - low_); }
  int count() const { return count_; }
  bool is_usable() const { return scale_ > 0 && scale_ < HUGE_VAL; }
  /// From 0 to the number of steps less one; -1 and the number of steps beyond the ends.
  int operator()(double x) const {
    return x < low_ ? -1 : x > high_ ? count_ : std::min(count_ - 1, static_cast<int>((x - low_) * scale_));
  }

 private:
  double low_, high_, scale_;
  int count_;
};

class Parting {
 public:
  Parting(const ProjectedMesh& projected, const FacePieces& pieces)
      : eye_(projected.eye()), boxes_(boxes_of(projected, pieces)) {}

  Clusters all();

 private:
  static constexpr std::size_t few = 16;
  static constexpr int most_steps = 4096;

  struct Slabs {
    int axis = -1, count = 1, eye = 0;  // the eye's slab: -1, before all; in steps beyond: after all
    std::vector<int> of_step;
  };
  Steps steps(std::size_t axis, std::span<const std::uint32_t> group) const;
  Slabs slabs(int axis, std::span<const std::uint32_t> group) const;
  int place(const Slabs& slabs, int slab) const;

  Viewpoint eye_;
  std::vector<Box> boxes_;
};

Steps Parting::steps(std::size_t axis, std::span<const std::uint32_t> group) const {
  Range range;
  for (const std::uint32_t i : group) {
    range.add(boxes_[i][axis].low);
    range.add(boxes_[i][axis].high);
  }
  return {range, static_cast<int>(std::min<std::size_t>(most_steps, 4 * group.size()))};
}

/// Where no piece of the group reaches from one step into the next, a slab ends.
Parting::Slabs Parting::slabs(int axis, std::span<const std::uint32_t> group) const {
  Slabs found;
  const auto a = static_cast<std::size_t>(axis);
  const Steps step = steps(a, group);
  if (!step.is_usable()) return found;
  const int count = step.count();
  std::vector<int> begins(static_cast<std::size_t>(count), 0), ends = begins;  // how many pieces do, by step
  for (const std::uint32_t i : group) {
    ++begins[static_cast<std::size_t>(step(boxes_[i][a].low))];
    ++ends[static_cast<std::size_t>(step(boxes_[i][a].high))];
  }
  found.axis = axis;
  found.of_step.resize(static_cast<std::size_t>(count));
  // Empty steps are of the slab that follows.
  int across = 0, slab = 0;
  bool is_empty = true;
  for (std::size_t s = 0; s < found.of_step.size(); ++s) {
    found.of_step[s] = slab;
    is_empty = is_empty && begins[s] == 0;
    across += begins[s] - ends[s];
    if (across > 0 || is_empty || s + 1 == found.of_step.size()) continue;
    ++slab;
    is_empty = true;
  }
  found.count = slab + 1;
  const double eye = eye_.at[axis];
  const int at = eye_.is_direction ? (eye < 0 ? -1 : count) : step(eye);
  found.eye = at < 0 ? -1 : at >= count ? found.count : found.of_step[static_cast<std::size_t>(at)];
  return found;
}

/// Toward the eye's slab from the lower end, then toward it from the upper end, then itself.
int Parting::place(const Slabs& s, int slab) const {
  if (slab < s.eye) return slab;
  if (slab > s.eye) return std::max(s.eye, 0) + (s.count - 1 - slab);
  return s.count - 1;
}

Clusters Parting::all() {
  Clusters found;
  std::vector<std::vector<std::uint32_t>> open(1);  // the farthest last
  open[0].resize(boxes_.size());
  std::iota(open[0].begin(), open[0].end(), 0U);
  found.reserve(0, boxes_.size());
  while (!open.empty()) {
    const std::vector<std::uint32_t> group = std::move(open.back());
    open.pop_back();
    Slabs best;
    if (group.size() > few)
      for (int axis = 0; axis < 3; ++axis)
        if (Slabs s = slabs(axis, group); s.count > best.count) best = std::move(s);
    if (best.count == 1) {
      found.push_row(group);
      continue;
    }
    const auto axis = static_cast<std::size_t>(best.axis);
    const Steps step = steps(axis, group);
    std::vector<std::vector<std::uint32_t>> parts(static_cast<std::size_t>(best.count));
    for (const std::uint32_t i : group)
      parts[static_cast<std::size_t>(place(best, best.of_step[static_cast<std::size_t>(step(boxes_[i][axis].low))]))].push_back(
          i);
    for (std::size_t k = parts.size(); k-- > 0;)
      if (!parts[k].empty()) open.push_back(std::move(parts[k]));
  }
  return found;
}

}  // namespace

std::vector<std::uint32_t> cluster_of_pieces(const Clusters& clusters) {
  std::vector<std::uint32_t> cluster(clusters.values().size());
  for (std::uint32_t c = 0; c < clusters.size(); ++c)
    for (const std::uint32_t piece : clusters[c]) cluster[piece] = c;
  return cluster;
}

Clusters one_cluster(const FacePieces& pieces) {
  Clusters all;
  for (std::uint32_t k = 0; k < pieces.size(); ++k) all.push_back(k);
  all.end_row();
  return all;
}

Clusters clusters(const ProjectedMesh& projected, const FacePieces& pieces) { return Parting(projected, pieces).all(); }

}  // namespace hsr::internal
