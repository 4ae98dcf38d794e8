#include "hsr/sheet/sheet_layout.h"

#include <catch2/catch.hpp>
#include <random>

#include "hsr/sheet/title_block.h"

using namespace hsr;
using namespace hsr::internal;

namespace {

const SheetFormat a3 = sheet_format("A3");
const PaperFrame area = {25, 15, 405, 282};
const PaperFrame title = title_block_place(a3.frame());

/// What a view covers on paper with what is around it.
PaperFrame box_of(const ViewToPlace& v, const Point2& origin, double scale) {
  const double s = v.is_on_paper ? 1 : scale;
  return {origin.x - s * v.left - v.pad_left, origin.y - s * v.above - v.pad_above, origin.x + s * v.right + v.pad_right,
          origin.y + s * v.below + v.pad_below};
}

bool overlap(const PaperFrame& a, const PaperFrame& b) {
  return a.left < b.right - 1e-9 && b.left < a.right - 1e-9 && a.top < b.bottom - 1e-9 && b.top < a.bottom - 1e-9;
}

bool is_within(const PaperFrame& a, const PaperFrame& b) {
  return a.left >= b.left - 1e-9 && a.right <= b.right + 1e-9 && a.top >= b.top - 1e-9 && a.bottom <= b.bottom + 1e-9;
}

/// Front, top, side and iso of a box.
std::vector<ViewToPlace> views_of_box(double width, double depth, double height) {
  std::vector<ViewToPlace> views(4);
  views[0] = {ViewToPlace::Row::of_front, width / 2, width / 2, height / 2, height / 2};
  views[1] = {ViewToPlace::Row::of_top, width / 2, width / 2, depth / 2, depth / 2};
  views[2] = {ViewToPlace::Row::of_front, depth / 2, depth / 2, height / 2, height / 2};
  const double across = 0.71 * (width + depth) / 2, up = (0.41 * (width + depth) + 0.82 * height) / 2;
  views[3] = {ViewToPlace::Row::of_top, across, across, up, up, false, false, true};
  for (ViewToPlace& v : views) v.pad_left = v.pad_above = 15;
  return views;
}

}  // namespace

TEST_CASE("Views stand apart, within the area and free of the title block, in line", "[sheet][layout]") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> exponent(0, 3);
  std::size_t laid = 0;
  for (int k = 0; k < 300; ++k) {
    auto views = views_of_box(std::pow(10, exponent(random)), std::pow(10, exponent(random)), std::pow(10, exponent(random)));
    const auto angle = k % 2 == 0 ? ProjectionAngle::first : ProjectionAngle::third;
    if (k % 3 == 0) views.push_back({ViewToPlace::Row::of_front, 20, 20, 20, 20, true, false, true});
    const auto layout = lay_out(views, area, title, angle, {});
    if (!layout) continue;
    ++laid;
    CAPTURE(k, layout->scale);
    const auto& at = layout->origins;
    for (std::size_t i = 0; i < views.size(); ++i) {
      const PaperFrame box = box_of(views[i], at[i], layout->scale);
      CHECK(is_within(box, area));
      CHECK_FALSE(overlap(box, title));
      for (std::size_t j = 0; j < i; ++j) CHECK_FALSE(overlap(box, box_of(views[j], at[j], layout->scale)));
    }
    CHECK(at[0].x == at[1].x);
    CHECK(at[0].y == at[2].y);
    CHECK((angle == ProjectionAngle::first) == (at[1].y > at[0].y));
    CHECK(at[2].x > at[0].x);
  }
  CHECK(laid > 290);
}

TEST_CASE("The scale is the largest of ISO 5455 at which the views fit", "[sheet][layout][L3]") {
  const double scales[] = {50, 20, 10, 5, 2, 1, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01};
  for (const double size : {3.0, 17.0, 60.0, 80.0, 99.0, 250.0, 1234.0, 4000.0}) {
    CAPTURE(size);
    const auto views = views_of_box(size, size / 2, size / 3);
    const auto found = lay_out(views, area, title, ProjectionAngle::first, {});
    REQUIRE(found);
    double largest = 0;
    for (const double s : scales)
      if (largest == 0 && lay_out(views, area, title, ProjectionAngle::first, s)) largest = s;
    CHECK(found->scale == largest);
  }
}

TEST_CASE("Views that do not fit at the scale that is asked for are not placed", "[sheet][layout]") {
  const auto views = views_of_box(100, 100, 100);
  CHECK(lay_out(views, area, title, ProjectionAngle::first, 0.5));
  CHECK_FALSE(lay_out(views, area, title, ProjectionAngle::first, 2));
  // Nor where what is around them leaves no room at any scale.
  auto wide = views;
  wide[0].pad_left = 400;
  CHECK_FALSE(lay_out(wide, area, title, ProjectionAngle::first, {}));
}

TEST_CASE("One view alone stands above the title block", "[sheet][layout]") {
  const std::vector<ViewToPlace> one = {{ViewToPlace::Row::of_top, 50, 50, 20, 20}};
  for (const auto angle : {ProjectionAngle::first, ProjectionAngle::third}) {
    const auto layout = lay_out(one, area, title, angle, {});
    REQUIRE(layout);
    CHECK(layout->scale == 2);
    CHECK(is_within(box_of(one[0], layout->origins[0], 2), area));
    CHECK_FALSE(overlap(box_of(one[0], layout->origins[0], 2), title));
  }
}
