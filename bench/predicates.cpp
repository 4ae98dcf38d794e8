// Nanoseconds per predicate and stage (Google Benchmark). The input decides which stage answers: generic points the filter,
// nearly degenerate ones the interval or the exact stage, and the bits of the coordinates which exact arithmetic. The share of
// each stage in the answers is printed with the time, so that the name of a benchmark can be checked against what it did.
#include "geometry/predicates.h"

#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "geometry/bit_range.h"
#include "geometry/error.h"
#include "geometry/error_bounded.h"
#include "geometry/plane.h"
#include "geometry/plane_filter.h"

namespace hsr::bench {

using namespace internal;

namespace {

std::uint64_t splitmix64(std::uint64_t& state) {
  std::uint64_t z = (state += 0x9e3779b97f4a7c15U);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

/// What the points are like.
enum class Input {
  generic,    ///< doubles of 53 bits in [-1, 1]: the filter decides
  bits_40,    ///< coplanar and concurrent, whole numbers of at most 40 bits: fixed-width integers
  bits_61,    ///< the same, 61 bits
  bits_123,   ///< the same, 123 bits
  bits_1848,  ///< the same, exponents from -900 to 948: big floats
};

/// Sixty-four points, used in a ring. All but the generic ones lie in the plane z = x + y: any face of three contains all
/// others.
class Points {
 public:
  Points(Input input, std::uint64_t seed) : state_(seed) {
    for (int k = 0; k < 64; ++k) points_.push_back(input == Input::generic ? generic() : coplanar(input));
  }
  const Point3& operator[](std::size_t k) const { return points_[k % points_.size()]; }
  BitRange bit_range() const { return hsr::bit_range(points_); }

 private:
  double unit() { return static_cast<double>(splitmix64(state_) >> 11) * 0x1p-52 - 1; }
  /// Of at most `bits` bits, so that sums of two are exact.
  double whole(int bits) { return std::floor(unit() * std::ldexp(1.0, bits)); }
  Point3 generic() { return {unit(), unit(), unit()}; }
  Point3 coplanar(Input input) {
    int shift = 0;
    switch (input) {
      case Input::bits_40:
        shift = whole(1) < 0 ? 0 : 12;
        break;
      case Input::bits_61:
        shift = whole(1) < 0 ? 0 : 34;
        break;
      case Input::bits_123:
        shift = whole(1) < 0 ? 0 : 95;
        break;
      default:
        shift = static_cast<int>(whole(9));
        shift = shift < 0 ? -900 : 900;
    }
    const double x = std::ldexp(whole(24), shift), y = std::ldexp(whole(24), shift);
    return {x, y, x + y};
  }

  std::uint64_t state_;
  std::vector<Point3> points_;
};

void report_stages(benchmark::State& state, const Predicates& predicates) {
  const DecisionCounts& n = predicates.counts();
  const double all = static_cast<double>(n.all());
  state.counters["filter"] = static_cast<double>(n.filter) / all;
  state.counters["interval"] = static_cast<double>(n.interval) / all;
  state.counters["exact"] = static_cast<double>(n.exact()) / all;
  state.counters["zero"] = static_cast<double>(n.zero) / all;
}

/// Degree 3: which side of a face plane a point lies on.
void side(benchmark::State& state, Input input, Arithmetic arithmetic) {
  const Points p(input, 1);
  Predicates predicates(p.bit_range(), {}, arithmetic);
  std::vector<Plane> planes;
  for (std::size_t k = 0; k < 64; ++k) planes.push_back(Plane::of_face(p[k], p[k + 1], p[k + 2]));
  std::size_t k = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(predicates.side(planes[k % 64], p[k + 5 + k / 64 % 50]));
    ++k;
  }
  report_stages(state, predicates);
}

/// A plane prepared for many points, as the hot loops use it. What it leaves open is not decided here.
void prepared_side(benchmark::State& state) {
  const Points p(Input::generic, 1);
  std::vector<PlaneFilter> planes;
  for (std::size_t k = 0; k < 64; ++k) planes.emplace_back(Plane::of_face(p[k], p[k + 1], p[k + 2]), Arithmetic::staged);
  std::size_t k = 0, certain = 0;
  for (auto _ : state) {
    const ErrorBounded value = planes[k % 64](p[k + 5 + k / 64 % 50]);
    certain += value.is_certain() ? 1 : 0;
    ++k;
  }
  state.counters["filter"] = static_cast<double>(certain) / static_cast<double>(k);
}

/// Degree 6: the sign of x(p) y(q) - x(q) y(p) for two faces. To make it zero with all four factors alive, y is the face x once
/// more, spanned by the same points in another order, and p and q lie off it.
void cross(benchmark::State& state, Input input, Arithmetic arithmetic) {
  const Points p(input, 2);
  std::vector<Plane> x, y;
  std::vector<Point3> lifted;
  BitRange bit_range = p.bit_range();
  for (std::size_t k = 0; k < 64; ++k) {
    x.push_back(Plane::of_face(p[k], p[k + 1], p[k + 2]));
    y.push_back(input == Input::generic ? Plane::of_face(p[k + 9], p[k + 7], p[k + 5])
                                        : Plane::of_face(p[k + 1], p[k + 2], p[k]));
    Point3 off = p[k];
    if (input != Input::generic) off.z = -off.z;
    lifted.push_back(off);
  }
  for (const Point3& point : lifted) bit_range.add(point);
  Predicates predicates(bit_range, {}, arithmetic);
  std::size_t k = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        predicates.cross(x[k % 64], y[k % 64], lifted[(k + 11) % 64], lifted[(k + 20 + k / 64 % 40) % 64]));
    ++k;
  }
  report_stages(state, predicates);
}

/// Degree 9 (and 6 for the sign of the meet): on which side of a plane three others meet. To make it zero, all four pass
/// through one corner.
void side_of_meet(benchmark::State& state, Input input, Arithmetic arithmetic) {
  const Points p(input, 4);
  BitRange bit_range = p.bit_range();
  std::vector<std::array<Plane, 4>> planes;
  const auto off_the_plane = [&](std::size_t k) {
    Point3 q = p[k];
    if (input != Input::generic) q.z = (k % 2 == 0) ? -q.z : q.x;
    bit_range.add(q);
    return q;
  };
  for (std::size_t k = 0; k < 64; ++k) {
    std::array<Plane, 4> four;
    for (std::size_t i = 0; i < 4; ++i) {
      const Point3 a = off_the_plane(k + 3 * i + 1), b = off_the_plane(k + 3 * i + 2);
      four[i] = Plane::of_face(a, input == Input::generic ? p[k + 13 * i] : p[k], b);  // not first: o differs, no term is zero
    }
    planes.push_back(four);
  }
  Predicates predicates(bit_range, {}, arithmetic);
  std::erase_if(planes, [&](const auto& four) {
    try {
      predicates.side(four[0], four[1], four[2], four[3]);
    } catch (const PreconditionError&) {
      return true;  // they meet in no point
    }
    return false;
  });
  predicates.counts() = {};
  std::size_t k = 0;
  for (auto _ : state) {
    const auto& four = planes[k++ % planes.size()];
    benchmark::DoNotOptimize(predicates.side(four[0], four[1], four[2], four[3]));
  }
  report_stages(state, predicates);
}

void add(const std::string& name, void (*predicate)(benchmark::State&, Input, Arithmetic)) {
  const auto add_one = [&](const std::string& stage, Input input, Arithmetic arithmetic) {
    benchmark::RegisterBenchmark((name + "/" + stage).c_str(), predicate, input, arithmetic);
  };
  add_one("plain double", Input::generic, Arithmetic::double_only);
  add_one("filter", Input::generic, Arithmetic::staged);
  add_one("interval", Input::generic, Arithmetic::interval);
  add_one("exact, 40 bits", Input::bits_40, Arithmetic::staged);
  add_one("exact, 61 bits", Input::bits_61, Arithmetic::staged);
  add_one("exact, 123 bits", Input::bits_123, Arithmetic::staged);
  add_one("exact, 1848 bits", Input::bits_1848, Arithmetic::staged);
  add_one("rational, 53 bits", Input::generic, Arithmetic::rational);
  add_one("rational, 40 bits", Input::bits_40, Arithmetic::rational);
}

}  // namespace
}  // namespace hsr::bench

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RegisterBenchmark("side/prepared filter", hsr::bench::prepared_side);
  hsr::bench::add("side", hsr::bench::side);
  hsr::bench::add("cross", hsr::bench::cross);
  hsr::bench::add("side of a meet", hsr::bench::side_of_meet);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
