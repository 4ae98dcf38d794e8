#include "hsr/check/z_buffer_check.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <unordered_map>

#include "hsr/check/exact_triangle.h"
#include "hsr/raster/scanned_triangle.h"
#include "hsr/scene/facet.h"

namespace hsr::internal {

namespace {

/// A triangle as it is seen, and as the z-buffer draws it.
template <class Real>
struct SeenTriangle : ExactTriangle {
  // As drawn:
  std::array<Seen<Bounded<Real>>, 4> drawn;  ///< as many as corners
  bool is_drawn = false;                     ///< false: out of range
  bool keeps_to_bounds = true;               ///< each corner is where it may be
  /// A sample that is drawn and should not be, or should and is not, is at most this far from an edge, both ways.
  double reach_x = 0, reach_y = 0;

  /// Whether a point of an edge is within reach of the sample. By the separating axes of a segment and a box.
  bool is_edge_within_reach(int i, int j) const {
    if (!(reach_x < HUGE_VAL && reach_y < HUGE_VAL)) return true;
    const Rational left = Rational(i) - Rational(reach_x), right = Rational(i) + Rational(reach_x),
                   top = Rational(j) - Rational(reach_y), bottom = Rational(j) + Rational(reach_y);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const ExactPoint &p = corners[k], &q = corners[(k + 1) % corners.size()];
      if (std::max(p.x, q.x) < left || std::min(p.x, q.x) > right || std::max(p.y, q.y) < top || std::min(p.y, q.y) > bottom)
        continue;
      const ImageFunction f = line(p, q);
      if (ImageFunction::magnitude(f.at(i, j)) <= f.change(reach_x, reach_y)) return true;
    }
    return false;
  }

  /// What is drawn at a sample, if it is.
  std::optional<Bounded<Real>> drawn_at(int i, int j, int width, int height) const {
    if (!is_drawn) return {};
    for (std::size_t k = 2; k < corners.size(); ++k) {
      ScannedTriangle<Bounded<Real>> scanned;
      if (!scanned.set(drawn[0], drawn[k - 1], drawn[k], width, height)) continue;
      if (j < scanned.top() || j >= scanned.bottom()) continue;
      const auto [begin, end] = scanned.span(j);
      if (i < begin || i >= end) continue;
      return scanned.nearness(i, j);
    }
    return {};
  }
};

/// The triangles of one check, each made when first asked for. One object per thread.
template <class Real>
class SeenTriangles {
 public:
  SeenTriangles(const Mesh& mesh, const View& view, const SampleGrid& grid)
      : mesh_(mesh), view_(view), exact_(mesh, view, grid), near_(view, grid) {}

  const SeenTriangle<Real>& operator()(TriangleId t) {
    std::unique_ptr<SeenTriangle<Real>>& made = made_[t.value];
    if (!made) made = std::make_unique<SeenTriangle<Real>>(make(t));
    return *made;
  }

 private:
  SeenTriangle<Real> make(TriangleId t) const {
    SeenTriangle<Real> result{exact_(t), {}, false, true, 0, 0};
    std::array<Seen<ErrorBounded>, 4> near;
    seen_corners<ErrorBounded>(
        mesh_, view_, near_, t, [&](VertexId v) { return exact_.is_cut_away(v); },
        [&](VertexId v) { return near_(mesh_.points[v]); }, near);
    result.is_drawn = true;
    double largest = 0;
    for (std::size_t k = 0; k < result.corners.size(); ++k) {
      Seen<Bounded<Real>>& d = result.drawn[k] = {bounded(near[k].x), bounded(near[k].y), bounded(near[k].nearness)};
      result.is_drawn = result.is_drawn && ScannedTriangle<Bounded<Real>>::is_drawable(d);
      result.reach_x = std::max(result.reach_x, d.x.error);
      result.reach_y = std::max(result.reach_y, d.y.error);
      largest = std::max({largest, std::fabs(static_cast<double>(d.x.value)), std::fabs(static_cast<double>(d.y.value))});
      result.keeps_to_bounds = result.keeps_to_bounds && keeps_to(d.x, result.corners[k].x) &&
                               keeps_to(d.y, result.corners[k].y) && keeps_to(d.nearness, result.corners[k].nearness);
    }
    // A side's crossing with a row, from.x + (y - from.y) (dx / dy), rounds by at most 5.05 u |dx| in the product and u |x| of
    // what it gives; |dx| is at most twice the largest coordinate X, what it gives three times: 14 u X. Where the sign of the
    // area is lost, nothing is drawn of what is at most 4 u (|bx cy| + |by cx|) / cy <= 16 u X wide. Slopes that are taken as
    // 0, and what is lost below the smallest number, put a side within its height, or 2^-60, of where it is.
    result.reach_x = (result.reach_x + 30 * Bounded<Real>::u * largest + 0x1p-60) * Bounded<Real>::grow;
    result.reach_y = (result.reach_y + 0x1p-118 * largest + 0x1p-60) * Bounded<Real>::grow;
    if (!(largest < ScannedTriangle<Bounded<Real>>::far)) result.reach_x = result.reach_y = HUGE_VAL;

    return result;
  }

  static Bounded<Real> bounded(const ErrorBounded& x) {
    const Real rounded = static_cast<Real>(x.value);
    // Of a double and what it rounds to the difference is a double.
    const double error = x.error + std::fabs(x.value - static_cast<double>(rounded));
    return {rounded, error < HUGE_VAL ? error * Bounded<Real>::grow : HUGE_VAL};
  }
  static bool keeps_to(const Bounded<Real>& found, const Rational& exact) {
    if (!std::isfinite(found.value) || !(found.error < HUGE_VAL)) return true;
    return ImageFunction::magnitude(Rational(found.value) - exact) <= Rational(found.error);
  }

  const Mesh& mesh_;
  const View& view_;
  ExactTriangles exact_;
  SampleProjection<ErrorBounded> near_;
  std::unordered_map<std::uint32_t, std::unique_ptr<SeenTriangle<Real>>> made_;
};

template <class Real>
class Judge {
 public:
  Judge(const Mesh& mesh, const View& view, const SampleGrid& grid, TieRule ties)
      : triangles_(mesh, view, grid), ties_(ties), width_(grid.width), height_(grid.height) {}

  /// @param shown what the z-buffer has @param nearest the truth; another facet
  Difference why(const DepthPixel<Real>& shown, TriangleId nearest, int i, int j) {
    const SeenTriangle<Real>* const z = shown.triangle.is_valid() ? &triangles_(shown.triangle) : nullptr;
    const SeenTriangle<Real>* const c = nearest.is_valid() ? &triangles_(nearest) : nullptr;
    for (const auto* t : {z, c})
      if (t != nullptr && !t->keeps_to_bounds) return Difference::other;

    // What is shown was drawn there, as it says.
    std::optional<Bounded<Real>> of_z, of_c;
    const bool z_covers = z != nullptr && z->covers(i, j);
    if (z != nullptr) {
      of_z = z->drawn_at(i, j, width_, height_);
      if (!of_z || of_z->value != shown.nearness) return Difference::other;
      if (!z_covers && !z->is_edge_within_reach(i, j)) return Difference::other;
    }
    if (c == nullptr) return z->reach_x < HUGE_VAL ? Difference::edge : Difference::unbounded;

    // What is nearest was not drawn there, or lost to the other.
    if (!c->covers(i, j)) return Difference::other;
    of_c = c->drawn_at(i, j, width_, height_);
    if (!of_c || std::isnan(of_c->value)) {
      if (!c->is_drawn || (of_c && !(of_c->error < HUGE_VAL))) return Difference::unbounded;
      if (of_c || !c->is_edge_within_reach(i, j)) return Difference::other;
      return c->reach_x < HUGE_VAL ? Difference::edge : Difference::unbounded;
    }
    // Of equal depths the one on top is shown.
    if (z == nullptr || of_c->value > of_z->value || (of_c->value == of_z->value && ties_.is_above(nearest, shown.triangle)))
      return Difference::other;
    const double bound = (of_c->error + of_z->error) * Bounded<Real>::grow;
    if (!(bound < HUGE_VAL) || !z->has_area) return Difference::unbounded;
    const Sign nearer = compared(c->nearness, z->nearness, i, j, bound);
    if (nearer == Sign::positive || (z_covers && nearer == Sign::negative)) return Difference::other;
    return z_covers ? Difference::depth : Difference::edge;
  }

 private:
  SeenTriangles<Real> triangles_;
  TieRule ties_;
  int width_, height_;
};

}  // namespace

template <class Real>
ZBufferCheck check_z_buffer(const Mesh& mesh, const View& view, const SampleGrid& samples, const DepthImage<Real>& image,
                            const Image<TriangleId>& seen, TieRule ties) {
  constexpr int rows = 16;
  std::vector<ZBufferCheck> parts(static_cast<std::size_t>((samples.height + rows - 1) / rows));
  tbb::enumerable_thread_specific<Judge<Real>> judges([&] { return Judge<Real>(mesh, view, samples, ties); });
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t p) {
    ZBufferCheck& part = parts[p];
    const int first = static_cast<int>(p) * rows;
    for (int j = first; j < std::min(first + rows, samples.height); ++j)
      for (int i = 0; i < samples.width; ++i) {
        const DepthPixel<Real>& shown = image.at(i, j);
        const TriangleId nearest = seen.at(i, j);
        ++part.samples;
        if (nearest.is_valid()) ++part.covered;
        if (shown.triangle == nearest) continue;
        if (shown.triangle.is_valid() && nearest.is_valid() && facet_of(mesh, shown.triangle) == facet_of(mesh, nearest))
          continue;
        ++part.wrong;
        const Difference why = judges.local().why(shown, nearest, i, j);
        ++(why == Difference::depth       ? part.depth
           : why == Difference::edge      ? part.edge
           : why == Difference::unbounded ? part.unbounded
                                          : part.other);
        if (why == Difference::other && part.first_other.size() < 10) {
          const auto face = [&](TriangleId t) { return t.is_valid() ? mesh.face_of[t] : FaceId(); };
          part.first_other.push_back({i, j, face(shown.triangle), face(nearest)});
        }
      }
  });
  ZBufferCheck all;
  for (const ZBufferCheck& part : parts) {
    all.samples += part.samples;
    all.covered += part.covered;
    all.wrong += part.wrong;
    all.depth += part.depth;
    all.edge += part.edge;
    all.unbounded += part.unbounded;
    all.other += part.other;
    for (const WrongSample& w : part.first_other)
      if (all.first_other.size() < 10) all.first_other.push_back(w);
  }
  return all;
}

template ZBufferCheck check_z_buffer(const Mesh&, const View&, const SampleGrid&, const DepthImage<float>&,
                                     const Image<TriangleId>&, TieRule);
template ZBufferCheck check_z_buffer(const Mesh&, const View&, const SampleGrid&, const DepthImage<double>&,
                                     const Image<TriangleId>&, TieRule);

}  // namespace hsr::internal
