#include "geometry/simd.h"

#include <catch2/catch.hpp>
#include <limits>
#include <random>

using namespace hsr;
using namespace hsr::internal;

namespace {

template <class T>
std::vector<T> numbers() {
  using Limits = std::numeric_limits<T>;
  std::vector<T> x = {0,
                      1,
                      T(1) / 3,
                      3,
                      Limits::min(),
                      Limits::denorm_min(),
                      Limits::max(),
                      Limits::epsilon(),
                      Limits::infinity(),
                      Limits::quiet_NaN()};
  for (std::size_t k = x.size(); k-- > 0;) x.push_back(-x[k]);
  std::mt19937_64 random(7);
  while (x.size() < 64)
    x.push_back(std::ldexp(static_cast<T>(static_cast<std::int64_t>(random())), static_cast<int>(random() % 80) - 100));
  return x;
}

/// The same number, or both no numbers.
template <class T>
bool same(T a, T b) {
  using Bits = typename simd::Lanes<T, 1>::Bits;
  return (std::isnan(a) && std::isnan(b)) || std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

/// What the kind of numbers gives for x and y, place by place, against what single numbers do.
template <class Kind, class T, std::size_t n>
bool is_right(const std::array<T, n>& x, const std::array<T, n>& y) {
  const Kind a = Kind::load(x.data()), b = Kind::load(y.data());
  bool right = true;
  const auto check = [&](const Kind& found, const auto& expected) {
    alignas(16) std::array<T, n> stored;
    found.store(stored.data());
    for (std::size_t k = 0; k < n; ++k) right = right && same(stored[k], T(expected(k))) && same(found[k], stored[k]);
  };
  check(a + b, [&](std::size_t k) { return x[k] + y[k]; });
  check(a - b, [&](std::size_t k) { return x[k] - y[k]; });
  check(a * b, [&](std::size_t k) { return x[k] * y[k]; });
  check(-a, [&](std::size_t k) { return -x[k]; });
  check(a.magnitude(), [&](std::size_t k) { return std::fabs(x[k]); });
  check(Kind::all(x[0]), [&](std::size_t) { return x[0]; });
  check(Kind::zero(), [&](std::size_t) { return 0; });
  if constexpr (n == 4) check(a.turned(), [&](std::size_t k) { return x[std::array<std::size_t, 4>{1, 2, 0, 3}[k]]; });
  const auto masks = [&](const Kind& found, const auto& expected) {
    unsigned bits = 0;
    for (unsigned k = 0; k < n; ++k) bits |= unsigned{expected(k)} << k;
    right = right && found.bits() == bits;
    check(found & a, [&](std::size_t k) { return expected(k) ? x[k] : 0; });
    check(a.without(found), [&](std::size_t k) { return expected(k) ? 0 : x[k]; });
    right = right && (found | (b > a)).bits() == (bits | (b > a).bits());
  };
  masks(a > b, [&](std::size_t k) { return x[k] > y[k]; });
  masks(a >= b, [&](std::size_t k) { return x[k] >= y[k]; });
  masks(a < b, [&](std::size_t k) { return x[k] < y[k]; });
  masks(a <= b, [&](std::size_t k) { return x[k] <= y[k]; });
  return right;
}

template <class T, std::size_t n, class... Kinds>
void check_kinds() {
  const std::vector<T> all = numbers<T>();
  std::mt19937_64 random(8);
  for (int i = 0; i < 20000; ++i) {
    alignas(16) std::array<T, n> x, y;
    for (std::size_t k = 0; k < n; ++k) {
      x[k] = all[random() % all.size()];
      y[k] = random() % 4 == 0 ? x[k] : all[random() % all.size()];
    }
    if (!(is_right<Kinds>(x, y) && ...)) {
      CAPTURE(x, y);
      FAIL("not as single numbers");
    }
  }
}

}  // namespace

TEST_CASE("four floats, or two doubles, at once are computed as single ones, with vectors and without", "[geometry][simd]") {
  check_kinds<float, 4, simd::Lanes<float, 4>, FourFloats>();
  check_kinds<double, 2, simd::Lanes<double, 2>, TwoDoubles>();
}

TEST_CASE("four indices at once are compared as single ones, with vectors and without", "[geometry][simd]") {
  using Scalar = simd::Lanes<std::uint32_t, 4>;
  std::mt19937_64 random(9);
  for (int i = 0; i < 1000; ++i) {
    alignas(16) std::array<std::uint32_t, 4> x, y, turned;
    for (std::size_t k = 0; k < 4; ++k) {
      x[k] = static_cast<std::uint32_t>(random());
      y[k] = random() % 2 == 0 ? x[k] : static_cast<std::uint32_t>(random());
    }
    unsigned equal = 0;
    for (unsigned k = 0; k < 4; ++k) equal |= unsigned{x[k] == y[k]} << k;
    CHECK((Scalar::load(x.data()) == Scalar::load(y.data())).bits() == equal);
    CHECK((FourIndices::load(x.data()) == FourIndices::load(y.data())).bits() == equal);
    CHECK((Scalar::load(x.data()) == Scalar::all(x[1])).bits() ==
          (FourIndices::load(x.data()) == FourIndices::all(x[1])).bits());
    FourIndices::load(x.data()).turned().store(turned.data());
    CHECK(turned == std::array{x[1], x[2], x[0], x[3]});
    CHECK(Scalar::load(x.data()).turned().v == turned);
  }
}
