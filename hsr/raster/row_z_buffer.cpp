#include "hsr/raster/row_z_buffer.h"

#include <algorithm>

#include "geometry/watched.h"
#include "hsr/raster/drawn_triangles.h"
#include "hsr/raster/row_z_buffer_observer.h"

namespace hsr::internal {

namespace {

constexpr std::uint32_t nothing = 0xffffffffU;

template <class Real, class Watch = Unwatched>
class RowDrawer {
 public:
  RowDrawer(const Mesh& mesh, const View& view, const SampleGrid& samples, TieRule ties, Watch watch = {})
      : watch_(watch), triangles_(mesh, view, samples), ties_(ties), row_(static_cast<std::size_t>(samples.width)) {
    result_.image = DepthImage<Real>(samples.width, samples.height);
    first_.resize(static_cast<std::size_t>(samples.height), nothing);
    next_.resize(triangles_.size(), nothing);
    // From the lowest, each in front of its bucket's list: so the lists begin on top.
    for (std::size_t n = triangles_.size(); n-- > 0;) {
      const std::size_t k = ties_.from_top(n, triangles_.size());
      int top = samples.height;
      triangles_.visit(TriangleId(k), [&](const auto& a, const auto& b, const auto& c) {
        const auto box = ScannedTriangle<Real>::box(a, b, c, samples.width, samples.height);
        if (!box.is_empty()) top = std::min(top, box.top);
      });
      if (top == samples.height) continue;
      next_[k] = first_[static_cast<std::size_t>(top)];
      first_[static_cast<std::size_t>(top)] = static_cast<std::uint32_t>(k);
    }
    if constexpr (Watch::is_watched) tell_buckets();
  }

  RowZBuffer<Real> drawn() && {
    for (int j = 0; j < result_.image.height; ++j) {
      activate(j);
      std::fill(row_.begin(), row_.end(), DepthPixel<Real>{});
      if constexpr (Watch::is_watched) tell_row(j);
      for (const Active& a : active_) draw(a, j);
      std::copy(row_.begin(), row_.end(), result_.image.row(j));
      std::erase_if(active_, [&](const Active& a) { return a.scanned.bottom() == j + 1; });
    }
    result_.bytes = triangles_.memory() + row_.capacity() * sizeof(row_[0]) + active_.capacity() * sizeof(Active) +
                    (first_.capacity() + next_.capacity()) * sizeof(std::uint32_t);
    return std::move(result_);
  }

 private:
  struct Active {
    TriangleId triangle;
    ScannedTriangle<Real> scanned;
  };

  void tell_buckets() const {
    for (int j = 0; j < result_.image.height; ++j)
      for (std::uint32_t k = first_[static_cast<std::size_t>(j)]; k != nothing; k = next_[k])
        watch_.observer->waits(TriangleId(k), j);
  }
  void tell_row(int j) const {
    std::vector<TriangleId> active;
    for (const Active& a : active_) active.push_back(a.triangle);
    watch_.observer->row(j, active);
  }

  template <class Visit>
  void visit(TriangleId t, const Visit& found) const {
    triangles_.visit(t, [&](const auto& a, const auto& b, const auto& c) {
      ScannedTriangle<Real> scanned;
      if (scanned.set(a, b, c, result_.image.width, result_.image.height)) found(scanned);
    });
  }

  /// Active triangles begin on top: of equal depths the first is shown.
  void activate(int j) {
    const auto before = static_cast<std::ptrdiff_t>(active_.size());
    for (std::uint32_t k = first_[static_cast<std::size_t>(j)]; k != nothing; k = next_[k])
      visit(TriangleId(k), [&](const ScannedTriangle<Real>& scanned) { active_.push_back({TriangleId(k), scanned}); });
    std::inplace_merge(active_.begin(), active_.begin() + before, active_.end(),
                       [&](const Active& a, const Active& b) { return ties_.is_above(a.triangle, b.triangle); });
    result_.most_active = std::max(result_.most_active, active_.size());
  }

  void draw(const Active& a, int j) {
    // One of two parts of a triangle may begin later.
    if (j < a.scanned.top()) return;
    const auto [begin, end] = a.scanned.span(j);
    const auto nearness_at = a.scanned.row(j);
    if constexpr (Watch::is_watched) watch_.observer->span(a.triangle, j, begin, end, a.scanned.bottom() == j + 1);
    for (int i = begin; i < end; ++i) {
      const Real nearness = nearness_at(i);
      DepthPixel<Real>& pixel = row_[static_cast<std::size_t>(i)];
      if constexpr (Watch::is_watched)
        watch_.observer->sample(
            {i, j, static_cast<double>(nearness), static_cast<double>(pixel.nearness), nearness > pixel.nearness});
      if (nearness > pixel.nearness) pixel = {nearness, a.triangle};
    }
  }

  [[no_unique_address]] Watch watch_;
  DrawnTriangles<Real> triangles_;
  TieRule ties_;
  std::vector<std::uint32_t> first_;  // by row: of the triangles that begin there
  std::vector<std::uint32_t> next_;   // by triangle: the next that begins in the same row
  std::vector<Active> active_;
  std::vector<DepthPixel<Real>> row_;
  RowZBuffer<Real> result_;
};

}  // namespace

template <class Real>
RowZBuffer<Real> row_z_buffer(const Mesh& mesh, const View& view, const SampleGrid& samples, TieRule ties) {
  return RowDrawer<Real>(mesh, view, samples, ties).drawn();
}

RowZBuffer<double> row_z_buffer(const Mesh& mesh, const View& view, const SampleGrid& samples, TieRule ties,
                                RowZBufferObserver& observer) {
  return RowDrawer<double, Watched<RowZBufferObserver>>(mesh, view, samples, ties, {&observer}).drawn();
}

template RowZBuffer<float> row_z_buffer(const Mesh&, const View&, const SampleGrid&, TieRule);
template RowZBuffer<double> row_z_buffer(const Mesh&, const View&, const SampleGrid&, TieRule);

}  // namespace hsr::internal
