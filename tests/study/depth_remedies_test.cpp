#include "study/depth_remedies.h"

#include <algorithm>
#include <catch2/catch.hpp>

namespace hsr {

using namespace internal;

namespace {

const MeasuredGap& gap_of(const std::vector<MeasuredGap>& gaps, DepthFormat format, double near) {
  return *std::find_if(gaps.begin(), gaps.end(),
                       [&](const MeasuredGap& g) { return g.drawn_by == "hsr" && g.format == format && g.near == near; });
}

TEST_CASE("walls are told apart from one to four steps of a fixed format on", "[check][depth_remedies]") {
  const std::vector<MeasuredGap> gaps = measured_gaps();
  CHECK(std::count_if(gaps.begin(), gaps.end(), [](const MeasuredGap& g) { return g.drawn_by == "hsr"; }) ==
        3 * depth_formats.size());
  for (const MeasuredGap& g : gaps) {
    INFO(g.drawn_by << ", " << name(g.format) << ", near plane at " << g.near);
    if (g.measured == 0) {
      CHECK(2 * g.predicted > g.distance / 2);  // the coarsest would need a larger gap than any that was tried
      continue;
    }
    CHECK(g.measured >= g.predicted);
    if (fixed_bits(g.format) > 0) CHECK(g.measured <= 4 * g.predicted);
  }
  // Eight bits more: 256 times as fine, a power of two. Ten times the near distance: ten times, as powers of two 8 or 16.
  for (const double near : {0.1, 1.0, 10.0})
    CHECK(gap_of(gaps, DepthFormat::fixed16, near).measured == 256 * gap_of(gaps, DepthFormat::fixed24, near).measured);
  const double times = gap_of(gaps, DepthFormat::fixed24, 0.1).measured / gap_of(gaps, DepthFormat::fixed24, 1).measured;
  CHECK((times == 8 || times == 16));
  CHECK(gap_of(gaps, DepthFormat::reversed_float32, 0.1).measured < gap_of(gaps, DepthFormat::float32, 0.1).measured / 400);
}

TEST_CASE("two steps of bias show a decal, and let through as much", "[check][depth_remedies]") {
  double before = 0;  // what the row above lets through
  for (const MeasuredBias& b : measured_biases()) {
    if (b.drawn_by != "hsr") continue;
    INFO(name(b.format) << ", bias " << b.bias << " and " << b.slope_bias << " slopes");
    const double step = smallest_gap(b.format, 100, 1, 10000);
    if (b.bias == 0) {
      before = 0;
      CHECK(b.shown_share == 0);
      CHECK(b.shines_through == 0);
    } else {
      if (b.bias == 2) CHECK(b.shown_share == 1);
      CHECK(b.shines_through >= step / 2);
      if (b.slope_bias == 0) CHECK(b.shines_through <= 2 * (b.bias + 1) * step);
      CHECK(b.shines_through > before);
    }
    before = b.shines_through;
  }
}

TEST_CASE("two units of polygon offset show a decal in the driver, too", "[check][depth_remedies][opengl]") {
  for (const MeasuredBias& b : measured_biases()) {
    if (b.drawn_by == "hsr") continue;
    INFO(b.drawn_by << ", " << name(b.format) << ", bias " << b.bias << " and " << b.slope_bias << " slopes");
    const double step = smallest_gap(b.format, 100, 1, 10000);
    if (b.bias == 0) CHECK(b.shown_share < 1);
    if (b.bias == 2) CHECK(b.shown_share == 1);
    if (b.bias > 0) CHECK(b.shines_through >= step / 2);
    if (b.slope_bias == 0) CHECK(b.shines_through <= 2 * (b.bias + 1) * step);
  }
}

}  // namespace
}  // namespace hsr
