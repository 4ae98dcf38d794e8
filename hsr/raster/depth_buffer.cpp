#include "hsr/raster/depth_buffer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/error.h"
#include "geometry/watched.h"
#include "hsr/raster/depth_observer.h"
#include "hsr/raster/drawn_triangles.h"

namespace hsr::internal {

namespace {

/// What is interpolated is `interpolated(depth)` in Real; what is held is `stored` of that. Larger is farther in all of them
/// but the reversed one.
template <int bits>
struct Fixed {
  using Real = double;
  using Stored = std::uint32_t;
  static constexpr double most = static_cast<double>((std::uint64_t{1} << bits) - 1);
  static constexpr double bytes = bits / 8.0;
  static constexpr Real away = 1;  // the sign of farther
  explicit Fixed(const DepthRange&) {}
  Real interpolated(const DepthRange& r, double nearness) const { return r.depth(nearness); }
  bool is_within(Real d) const { return d >= 0 && d <= 1; }
  Stored stored(Real d) const { return static_cast<Stored>(d * most + 0.5); }
  double depth(Stored s) const { return s / most; }
  Real biased(Real d, double steps) const { return d + steps / most; }
  static bool nearer(Stored a, Stored b) { return a < b; }
  Stored first(bool farthest) const { return farthest ? static_cast<Stored>(most) : 0; }
};

template <class Number>
struct Floating {
  using Real = Number;
  using Stored = Number;
  static constexpr double bytes = sizeof(Number);
  static constexpr Real away = 1;
  explicit Floating(const DepthRange&) {}
  Real interpolated(const DepthRange& r, double nearness) const { return static_cast<Real>(r.depth(nearness)); }
  bool is_within(Real d) const { return d >= 0 && d <= 1; }
  Stored stored(Real d) const { return d; }
  double depth(Stored s) const { return static_cast<double>(s); }
  Real biased(Real d, double steps) const { return d + static_cast<Real>(steps) * std::numeric_limits<Real>::epsilon() / 2; }
  static bool nearer(Stored a, Stored b) { return a < b; }
  Stored first(bool farthest) const { return farthest ? Stored{1} : Stored{0}; }
};

struct Reversed {
  using Real = float;
  using Stored = float;
  static constexpr double bytes = 4;
  static constexpr Real away = -1;
  explicit Reversed(const DepthRange&) {}
  // 1 - depth, without the rounding of that difference.
  Real interpolated(const DepthRange& r, double nearness) const {
    return static_cast<Real>((nearness - r.far) / (r.near - r.far));
  }
  bool is_within(Real d) const { return d >= 0 && d <= 1; }
  Stored stored(Real d) const { return d; }
  double depth(Stored s) const { return 1 - static_cast<double>(s); }
  Real biased(Real d, double steps) const { return d - static_cast<Real>(steps) * std::numeric_limits<float>::epsilon() / 2; }
  static bool nearer(Stored a, Stored b) { return a > b; }
  Stored first(bool farthest) const { return farthest ? 0.0F : 1.0F; }
};

/// Interpolates near / z, which is linear over the picture.
struct Logarithmic {
  using Real = float;
  using Stored = float;
  static constexpr double bytes = 4;
  static constexpr Real away = -1;
  explicit Logarithmic(const DepthRange& r)
      : least_{static_cast<float>((r.far + 1) / (r.near + 1))}, factor_{-1 / std::log2(least_)} {}
  Real interpolated(const DepthRange& r, double nearness) const { return static_cast<Real>((nearness + 1) / (r.near + 1)); }
  bool is_within(Real d) const { return d >= least_ && d <= 1; }
  Stored stored(Real d) const { return -std::log2(d) * factor_; }
  double depth(Stored s) const { return static_cast<double>(s); }
  Real biased(Real d, double steps) const {
    return d * std::exp2(-static_cast<Real>(steps) * std::numeric_limits<float>::epsilon() / 2 / factor_);
  }
  static bool nearer(Stored a, Stored b) { return a < b; }
  Stored first(bool farthest) const { return farthest ? 1.0F : 0.0F; }

 private:
  float least_, factor_;
};

template <class Format, class Watch>
class Buffer {
  using Real = typename Format::Real;
  using Stored = typename Format::Stored;

 public:
  Buffer(const SampleGrid& samples, const DepthRange& range, const DepthBufferOptions& options, Watch watch)
      : watch_(watch),
        range_(range),
        options_(options),
        format_(range),
        triangles_(samples.width, samples.height),
        stored_(samples.width, samples.height,
                format_.first(options.function != DepthFunction::greater && options.function != DepthFunction::gequal)) {
    if constexpr (Watch::is_watched) {
      const Stored first = stored_.pixels.front();
      watch_.observer->began(samples.width, samples.height, format_.depth(first), static_cast<double>(first));
    }
  }

  void draw(TriangleId t, Seen<Real> a, Seen<Real> b, Seen<Real> c) {
    ScannedTriangle<Real> scanned;
    if (!scanned.set(a, b, c, triangles_.width, triangles_.height)) return;
    bias_ = options_.slope_bias == 0
                ? 0
                : static_cast<Real>(options_.slope_bias) * std::max(std::fabs(scanned.step()), std::fabs(scanned.step_down()));
    if constexpr (Watch::is_watched) tell(t, scanned, a, b, c);
    switch (options_.interpolation) {
      case DepthInterpolation::plane:
        return draw_by_plane(t, scanned);
      case DepthInterpolation::incremental:
        return draw_incrementally(t, a, b, c);
      case DepthInterpolation::barycentric:
        return draw_by_weights(t, scanned, a, b, c);
    }
  }

  DepthBuffer result() && {
    DepthBuffer buffer;
    buffer.depths = Image<double>(triangles_.width, triangles_.height);
    std::transform(stored_.pixels.begin(), stored_.pixels.end(), buffer.depths.pixels.begin(),
                   [&](Stored s) { return format_.depth(s); });
    buffer.triangles = std::move(triangles_);
    buffer.bytes_a_sample = static_cast<std::size_t>(Format::bytes);
    return buffer;
  }

  Real interpolated(double nearness) const { return format_.interpolated(range_, nearness); }

 private:
  void tell(TriangleId t, const ScannedTriangle<Real>& scanned, const Seen<Real>& a, const Seen<Real>& b, const Seen<Real>& c) {
    const auto corner = [](const Seen<Real>& p) {
      return DepthCorner{static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.nearness)};
    };
    watch_.observer->triangle(t, {corner(a), corner(b), corner(c)}, static_cast<double>(scanned.step()),
                              static_cast<double>(scanned.step_down()));
  }

  /// Of samples begin ... end - 1 of a row; depth_at(i) is called once for each, from the left.
  template <class DepthAt>
  void draw_span(TriangleId t, int j, int begin, int end, const DepthAt& depth_at) {
    TriangleId* const shown = triangles_.row(j);
    Stored* const stored = stored_.row(j);
    const bool is_biased = bias_ != 0 || options_.bias != 0;
    const bool is_less = options_.function == DepthFunction::less;
    if constexpr (Watch::is_watched) watch_.observer->span(j, begin, end);
    for (int i = begin; i < end; ++i) {
      Real d = depth_at(i);
      if (is_biased) d = format_.biased(d + Format::away * bias_, options_.bias);
      if constexpr (Watch::is_watched) tell(i, j, d, stored[i]);
      if (!format_.is_within(d)) continue;
      const Stored s = format_.stored(d);
      if (is_less ? !Format::nearer(s, stored[i]) : !passes(s, stored[i])) continue;
      stored[i] = s;
      shown[i] = t;
    }
  }

  /// What is going to happen at a sample.
  void tell(int i, int j, Real d, Stored held) const {
    const bool is_within = format_.is_within(d);
    const Stored s = is_within ? format_.stored(d) : Stored{};
    watch_.observer->sample({i, j, format_.depth(s), static_cast<double>(s), format_.depth(held), static_cast<double>(held),
                             is_within, is_within && passes(s, held)});
  }

  void draw_by_plane(TriangleId t, const ScannedTriangle<Real>& scanned) {
    for (int j = scanned.top(); j < scanned.bottom(); ++j) {
      const auto [begin, end] = scanned.span(j);
      Real next = scanned.nearness(begin, j);
      draw_span(t, j, begin, end, [&](int) {
        const Real d = next;
        next += scanned.step();
        return d;
      });
    }
  }

  void draw_by_weights(TriangleId t, const ScannedTriangle<Real>& scanned, const Seen<Real>& a, const Seen<Real>& b,
                       const Seen<Real>& c) {
    const auto twice_area = [](const Seen<Real>& p, const Seen<Real>& q, Real x, Real y) {
      return (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
    };
    const Real all = twice_area(a, b, c.x, c.y);
    for (int j = scanned.top(); j < scanned.bottom(); ++j) {
      const auto [begin, end] = scanned.span(j);
      const Real y = static_cast<Real>(j);
      draw_span(t, j, begin, end, [&](int i) {
        const Real x = static_cast<Real>(i);
        const Real u = twice_area(b, c, x, y) / all, v = twice_area(c, a, x, y) / all;
        return u * a.nearness + v * b.nearness + (1 - u - v) * c.nearness;
      });
    }
  }

  /// A side that goes down row by row, and the depth on it.
  struct MovingSide {
    Real x, z, x_a_row, z_a_row;
    MovingSide(const Seen<Real>& p, const Seen<Real>& q, int row)
        : x_a_row((q.x - p.x) / (q.y - p.y)), z_a_row((q.nearness - p.nearness) / (q.y - p.y)) {
      const Real down = static_cast<Real>(row) - p.y;
      x = p.x + down * x_a_row;
      z = p.nearness + down * z_a_row;
    }
    void move() {
      x += x_a_row;
      z += z_a_row;
    }
  };

  static DepthSide told(const MovingSide& s) {
    return {static_cast<double>(s.x), static_cast<double>(s.z), static_cast<double>(s.x_a_row), static_cast<double>(s.z_a_row)};
  }

  void draw_incrementally(TriangleId t, Seen<Real> a, Seen<Real> b, Seen<Real> c) {
    if (b.y < a.y) std::swap(a, b);
    if (c.y < a.y) std::swap(a, c);
    if (c.y < b.y) std::swap(b, c);
    const auto row_from = [&](Real y) {
      return static_cast<int>(std::clamp(std::ceil(y), Real{0}, static_cast<Real>(triangles_.height)));
    };
    const auto column_from = [&](Real x) {
      return static_cast<int>(std::clamp(std::ceil(x), Real{0}, static_cast<Real>(triangles_.width)));
    };
    const Real area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    const Real z_a_sample = ((b.nearness - a.nearness) * (c.y - a.y) - (c.nearness - a.nearness) * (b.y - a.y)) / area;
    const int top = row_from(a.y), middle = row_from(b.y), bottom = row_from(c.y);
    MovingSide long_side(a, c, top);
    const auto draw_half = [&](const Seen<Real>& from, const Seen<Real>& to, int first, int end) {
      if (first >= end) return;
      MovingSide short_side(from, to, first);
      for (int j = first; j < end; ++j) {
        const MovingSide &left = area > 0 ? long_side : short_side, &right = area > 0 ? short_side : long_side;
        const int begin = column_from(left.x);
        if constexpr (Watch::is_watched) watch_.observer->sides(j, told(left), told(right));
        Real next = left.z + (static_cast<Real>(begin) - left.x) * z_a_sample;
        draw_span(t, j, begin, column_from(right.x), [&](int) {
          const Real d = next;
          next += z_a_sample;
          return d;
        });
        long_side.move();
        short_side.move();
      }
    };
    draw_half(a, b, top, middle);
    draw_half(b, c, middle, bottom);
  }

  bool passes(Stored s, Stored old) const {
    switch (options_.function) {
      case DepthFunction::never:
        return false;
      case DepthFunction::less:
        return Format::nearer(s, old);
      case DepthFunction::equal:
        return s == old;
      case DepthFunction::lequal:
        return !Format::nearer(old, s);
      case DepthFunction::greater:
        return Format::nearer(old, s);
      case DepthFunction::notequal:
        return s != old;
      case DepthFunction::gequal:
        return !Format::nearer(s, old);
      case DepthFunction::always:
        return true;
    }
    return false;
  }

  [[no_unique_address]] Watch watch_;
  DepthRange range_;
  DepthBufferOptions options_;
  Format format_;
  Image<TriangleId> triangles_;
  Image<Stored> stored_;
  Real bias_ = 0;
};

template <class Format, class Watch>
DepthBuffer drawn(const Mesh& mesh, const View& view, const SampleGrid& samples, const DepthRange& range,
                  const DepthBufferOptions& options, Watch watch) {
  using Real = typename Format::Real;
  Buffer<Format, Watch> buffer(samples, range, options, watch);
  const auto depth_of = [&](double nearness) { return buffer.interpolated(nearness); };
  const DrawnTriangles<Real, decltype(depth_of)> triangles(mesh, view, samples, depth_of);
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    const TriangleId t(options.ties.from_top(k, triangles.size()));
    triangles.visit(t, [&](const auto& a, const auto& b, const auto& c) { buffer.draw(t, a, b, c); });
  }
  return std::move(buffer).result();
}

template <class Watch>
DepthBuffer drawn_in_format(const Mesh& mesh, const View& view, const SampleGrid& samples, const DepthRange& range,
                            const DepthBufferOptions& options, Watch watch) {
  switch (options.format) {
    case DepthFormat::fixed8:
      return drawn<Fixed<8>>(mesh, view, samples, range, options, watch);
    case DepthFormat::fixed16:
      return drawn<Fixed<16>>(mesh, view, samples, range, options, watch);
    case DepthFormat::fixed24:
      return drawn<Fixed<24>>(mesh, view, samples, range, options, watch);
    case DepthFormat::fixed32:
      return drawn<Fixed<32>>(mesh, view, samples, range, options, watch);
    case DepthFormat::float32:
      return drawn<Floating<float>>(mesh, view, samples, range, options, watch);
    case DepthFormat::float64:
      return drawn<Floating<double>>(mesh, view, samples, range, options, watch);
    case DepthFormat::reversed_float32:
      return drawn<Reversed>(mesh, view, samples, range, options, watch);
    case DepthFormat::logarithmic_float32:
      if (!range.is_perspective) throw InputError("logarithmic depths: found a parallel view, expected a perspective");
      return drawn<Logarithmic>(mesh, view, samples, range, options, watch);
  }
  throw InputError("depth format: found no known one");
}

}  // namespace

DepthBuffer depth_buffer(const Mesh& mesh, const View& view, const SampleGrid& samples, const DepthRange& range,
                         const DepthBufferOptions& options) {
  return drawn_in_format(mesh, view, samples, range, options, Unwatched{});
}

DepthBuffer depth_buffer(const Mesh& mesh, const View& view, const SampleGrid& samples, const DepthRange& range,
                         const DepthBufferOptions& options, DepthObserver& observer) {
  return drawn_in_format(mesh, view, samples, range, options, Watched<DepthObserver>{&observer});
}

}  // namespace hsr::internal
