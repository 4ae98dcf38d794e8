#include "hsr/raster/caster.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "geometry/error.h"
#include "geometry/parallel.h"
#include "geometry/watched.h"
#include "hsr/raster/capped_samples.h"
#include "hsr/raster/cast_observer.h"
#include "hsr/raster/cell_samples.h"
#include "hsr/raster/sample_signs.h"
#include "hsr/scene/box_tree.h"
#include "hsr/scene/view_parts.h"

namespace hsr {

using namespace internal;

namespace {

constexpr int packet_width = 16;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// How near a triangle's plane is at a sample: larger is nearer, and affine in the sample.
///
/// The line of sight of p meets the plane L at p + s D with s = -L(p) / n.D, seen in a direction D; seen from an eye e, at
/// e + s (p - e) with 1 / s = 1 - L(p) / L(e), of which -L(p) / L(e) is kept.
SampleFunction nearness(const PlaneFilter& face, const ProjectedMesh& projected, const SampleGrid& grid) {
  const ErrorBounded b = projected.is_perspective() ? face(projected.eye().at) : face.change(projected.eye().at);
  return {quotient(-face(grid.origin), b), quotient(-face.change(grid.right), b), quotient(-face.change(grid.down), b), grid};
}

/// The samples of one tile, and what is nearest there so far.
template <int tile_width, class Watch>
class Tile {
  static constexpr int tile_size = tile_width * tile_width;

 public:
  Tile(const SampleSigns& signs, const Occluders& occluders, Predicates& exact, int left, int top, Watch watch = {})
      : watch_(watch),
        signs_(signs),
        projected_(signs.projected()),
        occluders_(occluders),
        exact_(exact),
        left_(left),
        top_(top),
        right_(std::min(left + tile_width, signs.grid().width)),
        bottom_(std::min(top + tile_width, signs.grid().height)),
        uncovered_((right_ - left_) * (bottom_ - top_)) {
    low_.fill(-infinity);
    high_.fill(-infinity);
  }

  void cast(Image<TriangleId>& image) {
    query_ = ImageBox::nothing();
    for (const int i : {left_, right_ - 1})
      for (const int j : {top_, bottom_ - 1}) query_.add(projected_.box(signs_.at(i, j)));
    samples_farthest_ = query_.farthest;
    query_.farthest = -std::numeric_limits<float>::infinity();
    query_.nearest = std::numeric_limits<float>::infinity();
    if constexpr (Watch::is_watched) watch_.observer->packet(left_, top_, right_, bottom_);
    // The query shrinks on the way: what is behind all samples is passed over.
    occluders_.tree.visit(query_, [&](std::uint32_t k) {
      if constexpr (Watch::is_watched) watch_.observer->tried(occluders_.triangles[k]);
      add(occluders_.triangles[k]);
      if constexpr (Watch::is_watched) watch_.observer->tried_all_rays(occluders_.triangles[k]);
      return true;
    });
    for (int j = top_; j < bottom_; ++j)
      for (int i = left_; i < right_; ++i) image.at(i, j) = nearest_[place(i, j)];
  }

 private:
  std::size_t place(int i, int j) const {
    return static_cast<std::size_t>(j - top_) * tile_width + static_cast<std::size_t>(i - left_);
  }

  /// Whether doubles tell that no sample of the tile has the sign `wanted`.
  bool is_apart(const SampleFunction& f, Sign wanted) const {
    const double s = static_cast<double>(static_cast<int>(wanted));
    const double best = s * f.value(f.on_row(s * f.down > 0 ? bottom_ - 1 : top_), s * f.right > 0 ? right_ - 1 : left_);
    return best < -f.error;
  }

  void add(TriangleId t) {
    const Sign facing = projected_.facing(t);
    const auto& corners = projected_.mesh().triangles[t];
    const auto side_plane = [&](std::size_t k) { return projected_.sight_plane(corners[k], corners[k == 2 ? 0 : k + 1]); };
    const auto near_plane = [&] { return projected_.near_line(projected_.face_plane(t)); };
    std::array<SampleFunction, 4> sides;
    for (std::size_t k = 0; k < 3; ++k) {
      sides[k] = {projected_.filter(side_plane(k)), signs_.grid()};
      if (is_apart(sides[k], facing)) return tell_apart(t, static_cast<int>(k));
    }
    // Where the near line is positive, and the eye on the positive side of the face, the face is beyond the near plane.
    const std::size_t count = projected_.reaches_before_near(t) ? 4 : 3;
    if (count == 4) {
      sides[3] = {projected_.filter(near_plane()), signs_.grid()};
      if (is_apart(sides[3], facing)) return tell_apart(t, 3);
    }
    const SampleFunction depth = nearness(projected_.filter(projected_.face_plane(t)), projected_, signs_.grid());
    bool changed = false;
    for (int j = top_; j < bottom_; ++j) {
      int begin = left_, end = right_;
      for (std::size_t k = 0; k < count && begin < end; ++k) {
        const RowCut cut = signs_.cut(
            sides[k], sides[k].on_row(j), j, begin, end, [&] { return ViewPlane::of(k == 3 ? near_plane() : side_plane(k)); },
            exact_);
        (cut.first == facing ? end : begin) = cut.change;
      }
      for (int i = begin; i < end; ++i) changed |= compare(t, depth, i, j);
    }
    if (changed && uncovered_ == 0) shrink_query();
  }

  void tell_apart([[maybe_unused]] TriangleId t, [[maybe_unused]] int side) const {
    if constexpr (Watch::is_watched) watch_.observer->apart(t, side);
  }

  /// Puts the triangle in its place at a sample it covers. False: it is behind.
  bool compare(TriangleId t, const SampleFunction& depth, int i, int j) {
    if constexpr (!Watch::is_watched) return compare_unwatched(t, depth, i, j);
    const double z = depth.value(depth.on_row(j), i);
    const std::size_t k = place(i, j);
    const TriangleId held = nearest_[k];
    const double low = low_[k], high = high_[k];
    const bool is_nearest = compare_unwatched(t, depth, i, j);
    if constexpr (Watch::is_watched)
      watch_.observer->compared({i, j, t, held, z, (low + high) / 2, depth.error + (high - low) / 2,
                                 held.is_valid() && !(z + depth.error < low) && !(z - depth.error > high), is_nearest});
    return is_nearest;
  }

  bool compare_unwatched(TriangleId t, const SampleFunction& depth, int i, int j) {
    const double z = depth.value(depth.on_row(j), i), low = z - depth.error, high = z + depth.error;
    const std::size_t k = place(i, j);
    if (high < low_[k]) return false;
    if (!nearest_[k].is_valid()) {
      --uncovered_;
    } else if (!(low > high_[k])) {
      const Sign s = nearer(t, nearest_[k], i, j);
      if (s == Sign::negative || (s == Sign::zero && projected_.ties().is_above(nearest_[k], t))) return false;
    }
    low_[k] = low;
    high_[k] = high;
    nearest_[k] = t;
    return true;
  }

  /// Which of two triangles is nearer at a sample, moved if need be: positive, t; zero, they are in one plane.
  Sign nearer(TriangleId t, TriangleId g, int i, int j) {
    if (t != last_[0] || g != last_[1]) {
      last_ = {t, g};
      const Plane plane = projected_.face_plane(t);
      const auto& corners = projected_.mesh().triangles[g];
      are_coplanar_ = std::all_of(corners.begin(), corners.end(),
                                  [&](VertexId v) { return projected_.side(plane, v, exact_) == Sign::zero; });
    }
    if (are_coplanar_) return Sign::zero;
    // The difference of two affine functions is affine: the ties are broken as in SampleSigns::side.
    for (const Point3& p : {signs_.at(i, j), signs_.at(i + 1, j), signs_.at(i, j + 1)})
      if (const Sign s = nearer_at(t, g, p); s != Sign::zero) return s;
    return Sign::zero;
  }

  /// The eye is on the side `facing` of a face, and n.D has that sign, too. With the formulas of `nearness`: from an eye,
  /// z_t - z_g = (T(e) G(p) - T(p) G(e)) / T(e) G(e); in a direction, T is at the point where g is seen (z_g - z_t) n.D.
  Sign nearer_at(TriangleId t, TriangleId g, const Point3& p) {
    const Plane of_t = projected_.face_plane(t), of_g = projected_.face_plane(g);
    const Viewpoint& e = projected_.eye();
    if (projected_.is_perspective()) return exact_.cross(of_t, of_g, e.at, p) * projected_.facing(t) * projected_.facing(g);
    const int axis = e.at.x != 0 ? 0 : e.at.y != 0 ? 1 : 2;
    return -(exact_.side(of_t, of_g, Plane::of_sight_along_axis(e, p, (axis + 1) % 3),
                         Plane::of_sight_along_axis(e, p, (axis + 2) % 3)) *
             projected_.facing(t));
  }

  /// All samples are covered: what is farther than the farthest of them need not be looked at. The nearness of boxes is that of
  /// ProjectedMesh::add_to: p.depth in a direction, -(p - e).depth from an eye.
  void shrink_query() {
    double farthest = infinity;
    for (int j = top_; j < bottom_; ++j)
      for (int i = left_; i < right_; ++i) farthest = std::min(farthest, low_[place(i, j)]);
    const double of_samples = samples_farthest_;
    const Point3& d = projected_.eye().at;
    const double along = norm_max(d) * farthest;
    const double bound = projected_.is_perspective() ? of_samples / (1 + farthest) : of_samples + along;
    const double margin =
        0x1p-20 * (std::fabs(bound) + std::fabs(of_samples) + (projected_.is_perspective() ? 0 : std::fabs(along)));
    const bool is_known = !projected_.is_perspective() || (of_samples < 0 && 1 + farthest > 0x1p-20);
    const double limit = bound - margin;
    if (is_known && limit > query_.farthest)
      query_.farthest = std::nextafter(static_cast<float>(limit), -std::numeric_limits<float>::infinity());
  }

  [[no_unique_address]] Watch watch_;
  const SampleSigns& signs_;
  const ProjectedMesh& projected_;
  const Occluders& occluders_;
  Predicates& exact_;
  int left_, top_, right_, bottom_;
  int uncovered_;
  ImageBox query_;
  double samples_farthest_ = 0;
  std::array<double, tile_size> low_, high_;  // of the nearness of the nearest
  std::array<TriangleId, tile_size> nearest_;
  std::array<TriangleId, 2> last_;  // compared
  bool are_coplanar_ = false;
};

}  // namespace

namespace {

/// What is seen in each cell.
CastImage cast_in_cells(const SceneView& scene, const SampleGrid& samples) {
  const Image<std::uint8_t> cell_of = cell_samples(scene, samples);
  CastImage result;
  result.triangles = Image<TriangleId>(samples.width, samples.height);
  const auto& cells = scene.parts().cells();
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const CastImage one = cast(cells[k].scene, samples);
    for (std::size_t p = 0; p < cell_of.pixels.size(); ++p)
      if (cell_of.pixels[p] == k) result.triangles.pixels[p] = one.triangles.pixels[p];
    result.decisions += one.decisions;
  }
  leave_out_beyond_far(scene, samples, result.triangles);
  return result;
}

}  // namespace

CastImage cast(const SceneView& scene, const SampleGrid& samples) {
  if (scene.view().has_cells()) return cast_in_cells(scene, samples);
  const ViewParts& parts = scene.parts().with(samples.bit_range());
  const ProjectedMesh& projected = parts.projected();
  const SampleSigns signs(projected, samples);
  const Occluders& occluders = parts.occluders(Excluded::edge_on);

  CastImage result;
  result.triangles = Image<TriangleId>(samples.width, samples.height);
  const int across = (samples.width + packet_width - 1) / packet_width,
            down = (samples.height + packet_width - 1) / packet_width;
  tbb::enumerable_thread_specific<Predicates> predicates([&] { return projected.predicates(); });
  tbb::parallel_for(tbb::blocked_range<int>(0, across * down, 8), [&](const tbb::blocked_range<int>& range) {
    for (int k = range.begin(); k < range.end(); ++k)
      Tile<packet_width, Unwatched>(signs, occluders, predicates.local(), k % across * packet_width, k / across * packet_width)
          .cast(result.triangles);
  });
  for (const Predicates& p : predicates) result.decisions += p.counts();
  const Image<std::uint8_t> capped = capped_samples(scene, samples);
  for (std::size_t k = 0; k < capped.pixels.size(); ++k)
    if (capped.pixels[k] != 0) result.triangles.pixels[k] = TriangleId();
  return result;
}

namespace internal {

namespace {

template <int width>
WatchedCast cast_in_packets(const SceneView& scene, const SampleGrid& samples, CastObserver& observer) {
  const ViewParts& parts = scene.parts().with(samples.bit_range());
  const ProjectedMesh& projected = parts.projected();
  const SampleSigns signs(projected, samples);
  const Occluders& occluders = parts.occluders(Excluded::edge_on);
  Predicates predicates = projected.predicates();
  WatchedCast result{{Image<TriangleId>(samples.width, samples.height), {}}, occluders.triangles.size()};
  for (int top = 0; top < samples.height; top += width)
    for (int left = 0; left < samples.width; left += width)
      Tile<width, Watched<CastObserver>>(signs, occluders, predicates, left, top, {&observer}).cast(result.image.triangles);
  result.image.decisions = predicates.counts();
  return result;
}

}  // namespace

WatchedCast cast(const SceneView& scene, const SampleGrid& samples, int width, CastObserver& observer) {
  switch (width) {
    case 1:
      return cast_in_packets<1>(scene, samples, observer);
    case 4:
      return cast_in_packets<4>(scene, samples, observer);
    case packet_width:
      return cast_in_packets<packet_width>(scene, samples, observer);
    default:
      throw PreconditionError("cast: packets of no known width");
  }
}

}  // namespace internal

}  // namespace hsr
