#include "geometry/exact_meet.h"

#include <algorithm>

#include "geometry/arithmetics.h"
#include "geometry/error.h"
#include "geometry/polynomials.h"

namespace hsr::internal {

namespace {

Sign exact_sign(const CGAL::Mpzf& x) { return static_cast<Sign>(static_cast<int>(CGAL::sign(x))); }
template <std::size_t L>
Sign exact_sign(const FixedInteger<L>& x) {
  return x.sign();
}

}  // namespace

struct ExactMeet::Numbers {
  Numbers() = default;
  Numbers(const Numbers&) = delete;
  Numbers& operator=(const Numbers&) = delete;
  virtual ~Numbers() = default;
  virtual Sign side(const Plane& x) const = 0;
};

template <class Arithmetic>
struct ExactMeet::NumbersOf final : Numbers {
  NumbersOf(const Arithmetic& k, const Plane& a, const Plane& b, const Plane& c)
      : arithmetic(k), o(a.o), m(polynomials::meet_point(k, a, b, c)), d(polynomials::meet_value(k, a, b, c)) {
    require(exact_sign(d) != Sign::zero, "ExactMeet: the three planes meet in no single point");
  }
  Sign side(const Plane& x) const override {
    return exact_sign(polynomials::value(arithmetic, x, o) * d + polynomials::dot(polynomials::normal(arithmetic, x), m)) *
           exact_sign(d);
  }

  Arithmetic arithmetic;
  Point3 o;
  polynomials::Vector<typename Arithmetic::Number> m;
  typename Arithmetic::Number d;
};

ExactMeet::ExactMeet(const BitRange& points, const Plane& a, const Plane& b, const Plane& c) {
  for (const Plane* p : {&a, &b, &c}) require(p->kind == Plane::Kind::span, "ExactMeet: spans expected");
  // Of degree 9 in differences of coordinates, as in Predicates.
  const int bits = 9 * std::max(points.bits() + 1, 1) + 13;
  const auto with = [&](const auto& arithmetic) {
    numbers_ = std::make_unique<NumbersOf<std::decay_t<decltype(arithmetic)>>>(arithmetic, a, b, c);
  };
  if (bits <= 384)
    with(FixedArithmetic<6>{points.lowest, 0});
  else if (bits <= 768)
    with(FixedArithmetic<12>{points.lowest, 0});
  else
    with(BigArithmetic{});
}

ExactMeet::~ExactMeet() = default;
ExactMeet::ExactMeet(ExactMeet&&) noexcept = default;
ExactMeet& ExactMeet::operator=(ExactMeet&&) noexcept = default;

Sign ExactMeet::side(const Plane& x) const { return numbers_->side(x); }

}  // namespace hsr::internal
