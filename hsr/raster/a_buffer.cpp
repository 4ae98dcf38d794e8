#include "hsr/raster/a_buffer.h"

#include <algorithm>
#include <array>
#include <bit>

#include "geometry/watched.h"
#include "hsr/raster/a_buffer_observer.h"
#include "hsr/raster/compositing.h"
#include "hsr/raster/drawn_triangles.h"
#include "hsr/raster/sample_lists.h"
#include "hsr/scene/facet.h"

namespace hsr::internal {

namespace {

constexpr int mask_columns = 8, mask_rows = 4;
using Mask = std::uint32_t;  // bit 8 v + u: the sample in row v and column u of the pixel
constexpr Mask whole = 0xffffffffU;

struct Fragment {
  FacetId facet;
  Mask mask = 0;
  double nearness = 0;  // the sum over the samples of the mask

  double mean() const { return nearness / std::popcount(mask); }
  bool is_before(const Fragment& other, TieRule ties) const {
    const double a = mean(), b = other.mean();
    return a != b ? a > b : ties.is_above(facet, other.facet);
  }
};

PixelFragment told(const Fragment& f) { return {f.facet, f.mask, f.mean()}; }

template <class Watch>
class Fragments {
 public:
  Fragments(const Mesh& mesh, const SampleGrid& samples, Watch watch)
      : watch_(watch), mesh_(mesh), width_(samples.width), height_(samples.height), lists_(width_, height_) {}

  void add(TriangleId t, const Seen<double>& a, const Seen<double>& b, const Seen<double>& c) {
    ScannedTriangle<double> scanned;
    if (!scanned.set(finer(a), finer(b), finer(c), width_ * mask_columns, height_ * mask_rows)) return;
    const FacetId facet = facet_of(mesh_, t);
    for (int v = scanned.top(); v < scanned.bottom(); ++v) {
      const auto [begin, end] = scanned.span(v);
      const auto nearness_at = scanned.row(v);
      for (int i = begin / mask_columns; i * mask_columns < end && begin < end; ++i) {
        const int first = std::max(begin, i * mask_columns), last = std::min(end, (i + 1) * mask_columns) - 1;
        const Mask row = ((2U << (last - first)) - 1U) << (first - i * mask_columns);
        // The mean depth of samples in a row is that of the first and the last.
        add(i, v / mask_rows, facet, row << (v % mask_rows * mask_columns),
            (nearness_at(first) + nearness_at(last)) / 2 * (last - first + 1));
      }
    }
  }

  const SampleLists<Fragment>& lists() const { return lists_; }

 private:
  /// From pixels, whose samples are at whole numbers, to the samples of their masks.
  static Seen<double> finer(const Seen<double>& p) {
    return {(p.x + 0.5) * mask_columns - 0.5, (p.y + 0.5) * mask_rows - 0.5, p.nearness};
  }

  /// The triangles of one facet are one fragment, where nothing else came between.
  void add(int i, int j, FacetId facet, Mask mask, double nearness) {
    Fragment* const latest = lists_.latest(i, j);
    if (latest != nullptr && latest->facet == facet) {
      latest->mask |= mask;
      latest->nearness += nearness;
      if constexpr (Watch::is_watched) watch_.observer->added(i, j, told(*latest), false);
    } else {
      lists_.add(i, j, {facet, mask, nearness});
      if constexpr (Watch::is_watched) watch_.observer->added(i, j, told({facet, mask, nearness}), true);
    }
  }

  [[no_unique_address]] Watch watch_;
  const Mesh& mesh_;
  int width_, height_;
  SampleLists<Fragment> lists_;
};

/// The light of one pixel.
template <class Watch>
class Resolver {
 public:
  Resolver(const Mesh& mesh, const std::vector<Colour>& colours, double opacity, TieRule ties, Watch watch)
      : watch_(watch), mesh_(mesh), colours_(colours), opacity_(opacity), ties_(ties) {}

  Colour operator()([[maybe_unused]] int i, [[maybe_unused]] int j, std::vector<Fragment>& fragments) {
    std::sort(fragments.begin(), fragments.end(), [&](const Fragment& a, const Fragment& b) { return a.is_before(b, ties_); });
    if constexpr (Watch::is_watched) {
      std::vector<PixelFragment> all;
      for (const Fragment& f : fragments) all.push_back(told(f));
      watch_.observer->sorted(i, j, all);
    }
    Light sum{};
    const auto add = [&](const Light& light, float share) {
      for (std::size_t k = 0; k < 3; ++k) sum[k] += light[k] * share;
    };
    std::array<float, mask_columns * mask_rows> passes;  // the light from behind that still gets through, by sample
    passes.fill(1);
    Mask open = whole;  // where any does
    for (const Fragment& f : fragments) {
      const Colour& c = colours_[mesh_.face_of[first_triangle(f.facet)].value];
      const float a = opacity_of(c, opacity_);
      float share = 0;
      for (Mask left = f.mask & open; left != 0; left &= left - 1) {
        float& through = passes[static_cast<std::size_t>(std::countr_zero(left))];
        share += a * through;
        through *= 1 - a;
      }
      if (share > 0) add({static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2])}, share);
      if (a == 1) open &= ~f.mask;
      if constexpr (Watch::is_watched) watch_.observer->took(told(f), a, share / (mask_columns * mask_rows), open);
      if (open == 0) break;
    }
    for (Mask left = open; left != 0; left &= left - 1)
      add(white_light, passes[static_cast<std::size_t>(std::countr_zero(left))]);
    Light light;
    for (std::size_t k = 0; k < 3; ++k) light[k] = sum[k] / (mask_columns * mask_rows);
    if constexpr (Watch::is_watched) {
      float background = 0;
      for (Mask left = open; left != 0; left &= left - 1)
        background += passes[static_cast<std::size_t>(std::countr_zero(left))];
      watch_.observer->resolved(i, j, background / (mask_columns * mask_rows), rounded(light));
    }
    return rounded(light);
  }

 private:
  [[no_unique_address]] Watch watch_;
  const Mesh& mesh_;
  const std::vector<Colour>& colours_;
  double opacity_;
  TieRule ties_;
};

template <class Watch>
ABuffer resolved(const Mesh& mesh, const View& view, const SampleGrid& samples, const std::vector<Colour>& colours,
                 double opacity, TieRule ties, Watch watch) {
  const DrawnTriangles<double> triangles(mesh, view, samples);
  Fragments<Watch> made(mesh, samples, watch);
  for (std::size_t k = 0; k < triangles.size(); ++k)
    triangles.visit(TriangleId(k), [&](const auto& a, const auto& b, const auto& c) { made.add(TriangleId(k), a, b, c); });

  ABuffer result;
  result.picture = Image<Colour>(samples.width, samples.height);
  result.fragments = made.lists().size();
  result.bytes = triangles.memory() + made.lists().bytes();
  Resolver<Watch> resolve(mesh, colours, opacity, ties, watch);
  std::vector<Fragment> fragments;
  for (int j = 0; j < samples.height; ++j)
    for (int i = 0; i < samples.width; ++i) {
      made.lists().copy(i, j, fragments);
      result.most_fragments = std::max(result.most_fragments, fragments.size());
      result.picture.at(i, j) = resolve(i, j, fragments);
    }
  return result;
}

}  // namespace

ABuffer a_buffer(const Mesh& mesh, const View& view, const SampleGrid& samples, const std::vector<Colour>& colours,
                 double opacity, TieRule ties) {
  return resolved(mesh, view, samples, colours, opacity, ties, Unwatched{});
}

ABuffer a_buffer(const Mesh& mesh, const View& view, const SampleGrid& samples, const std::vector<Colour>& colours,
                 double opacity, TieRule ties, ABufferObserver& observer) {
  return resolved(mesh, view, samples, colours, opacity, ties, Watched<ABufferObserver>{&observer});
}

}  // namespace hsr::internal
