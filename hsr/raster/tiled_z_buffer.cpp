#include "hsr/raster/tiled_z_buffer.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <limits>

#include "geometry/watched.h"
#include "hsr/raster/drawn_triangles.h"
#include "hsr/raster/tiled_z_buffer_observer.h"

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace hsr::internal {

namespace {

/// Tiles left ... right - 1 of rows top ... bottom - 1.
struct TileRange {
  std::uint16_t left = 0xffff, top = 0xffff, right = 0, bottom = 0;
};

/// Some triangles that follow one another, sorted into tiles: that of tile k are first[k] ... first[k + 1] - 1, ascending.
struct Block {
  std::vector<std::uint32_t> first;
  std::vector<TriangleId> triangles;
};

/// Draws samples begin ... end - 1 of a row of a tile whose first column is `left`.
template <class Real>
void draw_span(Real* nearness, std::uint32_t* triangle, std::uint32_t t, int left, typename ScannedTriangle<Real>::Row row,
               int begin, int end) {
  for (int k = begin; k < end; ++k) {
    const Real found = row(left + k);
    if (!(found > nearness[k])) continue;
    nearness[k] = found;
    triangle[k] = t;
  }
}

#ifdef __SSE2__
/// draw_span() for floats, four samples at once: in the first and the last group of four, samples outside of [begin, end) stay
/// as they are.
void draw_span(float* nearness, std::uint32_t* triangle, std::uint32_t t, int left, ScannedTriangle<float>::Row row, int begin,
               int end) {
  constexpr int lanes = 4;
  const __m128 at_corner = _mm_set1_ps(row.at_corner), corner = _mm_set1_ps(row.corner), step = _mm_set1_ps(row.step);
  const __m128i before = _mm_set1_epi32(begin - 1), after = _mm_set1_epi32(end), shown = _mm_set1_epi32(static_cast<int>(t));
  for (int group = begin & ~(lanes - 1); group < end; group += lanes) {
    const __m128i k = _mm_add_epi32(_mm_set1_epi32(group), _mm_setr_epi32(0, 1, 2, 3));
    const __m128 x = _mm_cvtepi32_ps(_mm_add_epi32(k, _mm_set1_epi32(left)));
    const __m128 found = _mm_add_ps(at_corner, _mm_mul_ps(_mm_sub_ps(x, corner), step)), old = _mm_loadu_ps(nearness + group);
    const __m128i is_inside = _mm_and_si128(_mm_cmpgt_epi32(k, before), _mm_cmplt_epi32(k, after));
    const __m128 is_nearer = _mm_and_ps(_mm_cmpgt_ps(found, old), _mm_castsi128_ps(is_inside));
    if (_mm_movemask_ps(is_nearer) == 0) continue;
    _mm_storeu_ps(nearness + group, _mm_or_ps(_mm_and_ps(is_nearer, found), _mm_andnot_ps(is_nearer, old)));
    auto* const place = reinterpret_cast<__m128i*>(triangle + group);
    const __m128i mask = _mm_castps_si128(is_nearer);
    _mm_storeu_si128(place, _mm_or_si128(_mm_and_si128(mask, shown), _mm_andnot_si128(mask, _mm_loadu_si128(place))));
  }
}
#endif

template <class Real, int tile_size, class Watch>
class Tile {
 public:
  explicit Tile(Watch watch = {}) : watch_(watch) {}

  void begin(int left, int top, int width, int height) {
    left_ = left;
    top_ = top;
    right_ = left + width;
    bottom_ = top + height;
    nearness_.fill(-std::numeric_limits<Real>::infinity());
    triangle_.fill(TriangleId().value);
  }

  void draw(TriangleId t, const ScannedTriangle<Real>& scanned) {
    const int bottom = std::min(scanned.bottom(), bottom_);
    for (int j = std::max(scanned.top(), top_); j < bottom; ++j) {
      const auto [first, last] = scanned.span(j);
      const int begin = std::max(first, left_), end = std::min(last, right_);
      if (begin >= end) continue;
      const std::size_t row = static_cast<std::size_t>(j - top_) * tile_size;
      if constexpr (Watch::is_watched) tell(t, scanned, j, begin, end);
      draw_span(nearness_.data() + row, triangle_.data() + row, t.value, left_, scanned.row(j), begin - left_, end - left_);
    }
  }

  void copy_to(DepthImage<Real>& image) const {
    for (int j = top_; j < bottom_; ++j) {
      const std::size_t row = static_cast<std::size_t>(j - top_) * tile_size;
      for (int i = left_; i < right_; ++i) {
        const std::size_t k = row + static_cast<std::size_t>(i - left_);
        image.row(j)[i] = {nearness_[k], TriangleId(triangle_[k])};
      }
    }
  }

 private:
  /// What is going to happen.
  void tell(TriangleId t, const ScannedTriangle<Real>& scanned, int j, int begin, int end) const {
    watch_.observer->span(t, j, begin, end);
    const auto nearness_at = scanned.row(j);
    for (int i = begin; i < end; ++i) {
      const Real found = nearness_at(i), held = nearness_[static_cast<std::size_t>((j - top_) * tile_size + i - left_)];
      watch_.observer->sample({i, j, static_cast<double>(found), static_cast<double>(held), found > held});
    }
  }

  [[no_unique_address]] Watch watch_;
  int left_ = 0, top_ = 0, right_ = 0, bottom_ = 0;
  std::array<Real, tile_size * tile_size> nearness_;
  std::array<std::uint32_t, tile_size * tile_size> triangle_;
};

template <class Real, int tile_size = 64, class Watch = Unwatched>
class TileDrawer {
 public:
  TileDrawer(const Mesh& mesh, const View& view, const SampleGrid& samples, TieRule ties, Watch watch = {})
      : watch_(watch),
        triangles_(mesh, view, samples),
        ties_(ties),
        columns_((samples.width + tile_size - 1) / tile_size),
        rows_((samples.height + tile_size - 1) / tile_size) {
    result_.image = DepthImage<Real>(samples.width, samples.height);
    constexpr std::size_t size = 32768;
    blocks_.resize((triangles_.size() + size - 1) / size);
    tbb::parallel_for(std::size_t{0}, blocks_.size(),
                      [&](std::size_t b) { sort(blocks_[b], b * size, std::min((b + 1) * size, triangles_.size())); });
  }

  TiledZBuffer<Real> drawn() && {
    using DrawnTile = Tile<Real, tile_size, Watch>;
    tbb::enumerable_thread_specific<DrawnTile> tiles([&] { return DrawnTile(watch_); });
    if constexpr (Watch::is_watched)
      for (int k = 0; k < columns_ * rows_; ++k) draw(tiles.local(), k);
    else
      tbb::parallel_for(0, columns_ * rows_, [&](int k) { draw(tiles.local(), k); });
    result_.bytes = triangles_.memory() + tiles.size() * sizeof(DrawnTile);
    for (const Block& block : blocks_) {
      result_.entries += block.triangles.size();
      result_.bytes += block.first.capacity() * sizeof(std::uint32_t) + block.triangles.capacity() * sizeof(TriangleId);
    }
    return std::move(result_);
  }

 private:
  TileRange range(TriangleId t) const {
    TileRange range;
    triangles_.visit(t, [&](const auto& a, const auto& b, const auto& c) {
      const auto box = ScannedTriangle<Real>::box(a, b, c, result_.image.width, result_.image.height);
      if (box.is_empty()) return;
      const auto tile = [](int sample) { return static_cast<std::uint16_t>(sample / tile_size); };
      range.left = std::min(range.left, tile(box.left));
      range.top = std::min(range.top, tile(box.top));
      range.right = std::max<std::uint16_t>(range.right, tile(box.right - 1) + 1);
      range.bottom = std::max<std::uint16_t>(range.bottom, tile(box.bottom - 1) + 1);
    });
    return range;
  }

  /// By counting.
  void sort(Block& block, std::size_t begin, std::size_t end) const {
    std::vector<TileRange> ranges(end - begin);
    block.first.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1);
    const auto visit = [&](const TileRange& r, const auto& found) {
      for (std::size_t y = r.top; y < r.bottom; ++y)
        for (std::size_t x = r.left; x < r.right; ++x) found(y * static_cast<std::size_t>(columns_) + x);
    };
    for (std::size_t k = begin; k < end; ++k) {
      ranges[k - begin] = range(TriangleId(k));
      visit(ranges[k - begin], [&](std::size_t tile) { ++block.first[tile + 1]; });
    }
    for (std::size_t k = 1; k < block.first.size(); ++k) block.first[k] += block.first[k - 1];
    block.triangles.resize(block.first.back());
    std::vector<std::uint32_t> next = block.first;
    for (std::size_t k = begin; k < end; ++k)
      visit(ranges[k - begin], [&](std::size_t tile) { block.triangles[next[tile]++] = TriangleId(k); });
  }

  std::vector<TriangleId> list(std::size_t tile) const {
    std::vector<TriangleId> all;
    for (const Block& block : blocks_)
      all.insert(all.end(), block.triangles.begin() + block.first[tile], block.triangles.begin() + block.first[tile + 1]);
    return all;
  }

  void draw(Tile<Real, tile_size, Watch>& tile, int k) {
    DepthImage<Real>& image = result_.image;
    const int left = k % columns_ * tile_size, top = k / columns_ * tile_size;
    if constexpr (Watch::is_watched)
      watch_.observer->tile({left, top, std::min(left + tile_size, image.width), std::min(top + tile_size, image.height)},
                            list(static_cast<std::size_t>(k)));
    bool is_begun = false;
    for (std::size_t block_place = 0; block_place < blocks_.size(); ++block_place) {
      const Block& block = blocks_[ties_.from_top(block_place, blocks_.size())];
      const std::uint32_t first = block.first[static_cast<std::size_t>(k)], end = block.first[static_cast<std::size_t>(k) + 1];
      for (std::uint32_t e = 0; e < end - first; ++e) {
        const TriangleId t = block.triangles[first + ties_.from_top(e, end - first)];
        if (!is_begun) tile.begin(left, top, std::min(tile_size, image.width - left), std::min(tile_size, image.height - top));
        is_begun = true;
        triangles_.visit(t, [&](const auto& a, const auto& b, const auto& c) {
          ScannedTriangle<Real> scanned;
          if (scanned.set(a, b, c, image.width, image.height)) tile.draw(t, scanned);
        });
      }
    }
    if (is_begun) tile.copy_to(image);
    if constexpr (Watch::is_watched) watch_.observer->done();
  }

  [[no_unique_address]] Watch watch_;
  DrawnTriangles<Real> triangles_;
  TieRule ties_;
  int columns_, rows_;
  std::vector<Block> blocks_;
  TiledZBuffer<Real> result_;
};

}  // namespace

template <class Real>
TiledZBuffer<Real> tiled_z_buffer(const Mesh& mesh, const View& view, const SampleGrid& samples, TieRule ties) {
  return TileDrawer<Real>(mesh, view, samples, ties).drawn();
}

TiledZBuffer<float> tiled_z_buffer(const Mesh& mesh, const View& view, const SampleGrid& samples, TieRule ties,
                                   TiledZBufferObserver& observer) {
  return TileDrawer<float, watched_tile_size, Watched<TiledZBufferObserver>>(mesh, view, samples, ties, {&observer}).drawn();
}

template TiledZBuffer<float> tiled_z_buffer(const Mesh&, const View&, const SampleGrid&, TieRule);
template TiledZBuffer<double> tiled_z_buffer(const Mesh&, const View&, const SampleGrid&, TieRule);

}  // namespace hsr::internal
