#include "geometry/merge_points.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

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

IndexedVector<VertexId, VertexId> merge_points(const IndexedVector<VertexId, Point3>& points) {
  const std::size_t n = points.size();
  IndexedVector<VertexId, VertexId> merged(n);
  // Open addressing, half full at most; a slot has the upper half of the hash, so that a point is fetched only to confirm,
  // and one more than the index. Slots are fetched ahead: the table does not fit into the cache.
  const std::size_t mask = std::bit_ceil(std::max<std::size_t>(2 * n, 16)) - 1;
  std::vector<std::uint64_t> table(mask + 1, 0);
  constexpr std::size_t ahead = 16;
  std::uint64_t hashes[ahead];
  const auto prepare = [&](std::size_t k) {
    hashes[k % ahead] = hash(points[VertexId(k)]);
    __builtin_prefetch(&table[hashes[k % ahead] & mask], 1);
  };
  for (std::size_t k = 0; k < std::min(ahead, n); ++k) prepare(k);
  for (std::size_t k = 0; k < n; ++k) {
    const std::uint64_t h = hashes[k % ahead];
    if (k + ahead < n) prepare(k + ahead);
    const std::uint64_t tag = h >> 32 << 32;
    VertexId representative(k);
    for (std::size_t slot = h & mask;; slot = (slot + 1) & mask) {
      const std::uint64_t entry = table[slot];
      if (entry == 0) {
        table[slot] = tag | (k + 1);
        break;
      }
      const VertexId other((entry & 0xffffffffU) - 1);
      if ((entry >> 32 << 32) == tag && points[other] == points[VertexId(k)]) {
        representative = other;
        break;
      }
    }
    merged[VertexId(k)] = representative;
  }
  return merged;
}

}  // namespace hsr::internal
