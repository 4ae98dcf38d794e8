#include "geometry/merge_points.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "geometry/disjoint_sets.h"
#include "geometry/error.h"

namespace hsr::internal {

namespace {

std::uint64_t mix(std::uint64_t a, std::uint64_t b) {
  __extension__ using Wide = unsigned __int128;
  const Wide product = static_cast<Wide>(a ^ 0x9e3779b97f4a7c15ULL) * (b ^ 0xd6e8feb86659fd93ULL);
  return static_cast<std::uint64_t>(product) ^ static_cast<std::uint64_t>(product >> 64);
}

std::uint64_t hash(const Point3& p) {
  const auto x = std::bit_cast<std::uint64_t>(p.x), y = std::bit_cast<std::uint64_t>(p.y),
             z = std::bit_cast<std::uint64_t>(p.z);
  return mix(mix(x, y), z ^ std::rotl(x, 32));
}

}  // namespace

namespace {

/// Points whose hashes are one share of all: their table fits into a cache, or nearly, whatever the number of points.
class ShareOfPoints {
 public:
  /// @param most points that this share has
  ShareOfPoints(const IndexedVector<VertexId, Point3>& points, std::size_t most, IndexedVector<VertexId, VertexId>& merged)
      : points_(points), merged_(merged), mask_(std::bit_ceil(std::max<std::size_t>(2 * most, 16)) - 1), table_(mask_ + 1, 0) {}

  /// Slots are fetched ahead, so a point is merged when some more have been added.
  void add(VertexId v, std::uint64_t hash) {
    if (added_ - settled_ == ahead) settle();
    waiting_[added_++ % ahead] = {v, hash};
    __builtin_prefetch(&table_[hash & mask_], 1);
  }
  void settle_all() {
    while (settled_ < added_) settle();
  }

 private:
  static constexpr std::size_t ahead = 16;
  struct Waiting {
    VertexId v;
    std::uint64_t hash = 0;
  };

  /// Open addressing, half full at most; a slot has the upper half of the hash, so that a point is fetched only to confirm, and
  /// one more than the index.
  void settle() {
    const auto [v, hash] = waiting_[settled_++ % ahead];
    const std::uint64_t tag = hash >> 32 << 32;
    for (std::size_t slot = hash & mask_;; slot = (slot + 1) & mask_) {
      const std::uint64_t entry = table_[slot];
      if (entry == 0) {
        table_[slot] = tag | (v.value + 1ULL);
        merged_[v] = v;
        return;
      }
      const VertexId other((entry & 0xffffffffU) - 1);
      if ((entry >> 32 << 32) == tag && points_[other] == points_[v]) {
        merged_[v] = other;
        return;
      }
    }
  }

  const IndexedVector<VertexId, Point3>& points_;
  IndexedVector<VertexId, VertexId>& merged_;
  std::size_t mask_;
  std::vector<std::uint64_t> table_;
  std::array<Waiting, ahead> waiting_ = {};
  std::size_t added_ = 0, settled_ = 0;
};

constexpr std::size_t points_of_share = std::size_t{1} << 21, most_shares = 256;

}  // namespace

IndexedVector<VertexId, VertexId> merge_points(const IndexedVector<VertexId, Point3>& points) {
  IndexedVector<VertexId, VertexId> merged(points.size());
  const std::size_t shares = std::min(most_shares, std::bit_ceil(points.size() / points_of_share + 1));
  const auto share_of = [&](std::uint64_t h) { return (h >> 24U) & (shares - 1); };
  std::vector<std::size_t> most(shares, 0);
  if (shares == 1)
    most[0] = points.size();
  else
    for (const Point3& p : points) ++most[share_of(hash(p))];
  for (std::size_t share = 0; share < shares; ++share) {
    ShareOfPoints some(points, most[share], merged);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const std::uint64_t h = hash(points[VertexId(k)]);
      if (share_of(h) == share) some.add(VertexId(k), h);
    }
    some.settle_all();
  }
  return merged;
}

namespace {

double distance(const Point3& a, const Point3& b) { return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z); }

/// Distinct points by cells as wide as the tolerance: those that are near one another are in neighbouring cells.
class Cells {
 public:
  Cells(const IndexedVector<VertexId, Point3>& points, double width) : points_(points), width_(width) {}

  /// Calls f(k) for the points in and around the cell of v, and puts v into it.
  template <class F>
  void visit_around(VertexId v, const F& f) {
    const Point3 cell = cell_of(points_[v]);
    for (double i = -1; i <= 1; ++i)
      for (double j = -1; j <= 1; ++j)
        for (double k = -1; k <= 1; ++k) {
          const auto found = in_cell_.find(hash({cell.x + i, cell.y + j, cell.z + k}));
          if (found == in_cell_.end()) continue;
          for (const VertexId other : found->second) f(other);
        }
    in_cell_[hash({cell.x, cell.y, cell.z})].push_back(v);
  }

 private:
  /// + 0: the cell -0 is the cell 0.
  Point3 cell_of(const Point3& p) const {
    return {std::floor(p.x / width_) + 0.0, std::floor(p.y / width_) + 0.0, std::floor(p.z / width_) + 0.0};
  }

  const IndexedVector<VertexId, Point3>& points_;
  double width_;
  std::unordered_map<std::uint64_t, std::vector<VertexId>> in_cell_;  // by hash: a collision costs a distance, no more
};

void check_width(const IndexedVector<VertexId, Point3>& points, const std::vector<VertexId>& cluster, double tolerance) {
  constexpr std::size_t few = 64;
  const auto fail = [&](VertexId a, VertexId b) {
    throw InputError("points " + std::to_string(a.value) + " and " + std::to_string(b.value) +
                     " are joined by points between them and are farther apart than twice the tolerance, expected a tolerance "
                     "that is larger than the noise and smaller than the model's details");
  };
  for (std::size_t i = 0; i < std::min(cluster.size(), few); ++i)
    for (std::size_t j = i + 1; j < cluster.size(); ++j)
      if (distance(points[cluster[i]], points[cluster[j]]) > 2 * tolerance) fail(cluster[i], cluster[j]);
}

}  // namespace

void merge_clusters(const IndexedVector<VertexId, Point3>& points, double tolerance,
                    IndexedVector<VertexId, VertexId>& merged) {
  DisjointSets sets(points.size());
  Cells cells(points, tolerance);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const VertexId v(k);
    if (merged[v] != v) continue;
    cells.visit_around(v, [&](VertexId other) {
      if (distance(points[v], points[other]) <= tolerance) sets.join(v.value, other.value);
    });
  }
  std::unordered_map<std::uint32_t, std::vector<VertexId>> clusters;  // by root, each ascending
  for (std::size_t k = 0; k < points.size(); ++k)
    if (merged[VertexId(k)] == VertexId(k)) clusters[sets.find(static_cast<std::uint32_t>(k))].emplace_back(k);
  IndexedVector<VertexId, VertexId> lowest(points.size());
  for (const auto& [root, cluster] : clusters) {
    check_width(points, cluster, tolerance);
    for (const VertexId v : cluster) lowest[v] = cluster.front();
  }
  for (VertexId& m : merged) m = lowest[m];
}

}  // namespace hsr::internal
