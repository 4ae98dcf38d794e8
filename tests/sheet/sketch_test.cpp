#include "hsr/sheet/sketch.h"

#include <catch2/catch.hpp>
#include <cmath>

using namespace hsr;
using namespace hsr::internal;

namespace {

/// Millimetres of the lines of a layer.
double length_of(const Sketch& sketch, const std::string& name) {
  Drawing drawing;
  sketch.append_to(drawing);
  double length = 0;
  for (const NamedLayer& layer : drawing.layers) {
    if (layer.name != name) continue;
    for (std::uint32_t k = layer.first_polyline; k < layer.end_polyline; ++k) {
      const auto points = drawing.points_of(drawing.polylines[k]);
      for (std::size_t i = 0; i + 1 < points.size(); ++i)
        length +=
            std::hypot(static_cast<double>(points[i + 1].x - points[i].x), static_cast<double>(points[i + 1].y - points[i].y)) /
            1000;
    }
  }
  return length;
}

}  // namespace

TEST_CASE("A line beside texts leaves room for those that it would run through", "[sheet][sketch]") {
  for (const auto& [text, is_broken] : {std::pair{"H", true}, {"", false}, {"  ", false}})
    for (const Point2& to : {Point2{40, 20}, Point2{40, 23}, Point2{20, 40}}) {
      INFO('"' << text << "\" to " << to.x << ", " << to.y);
      Sketch sketch;
      sketch.text("words", text, 5, {20, 22});
      sketch.line_beside_texts(sketch.layer("lines", {}), {0, 20}, to);
      const double whole = std::hypot(to.x, to.y - 20), drawn = length_of(sketch, "lines");
      // The letter reaches from 20 to 24 and from 17 to 22, and 0.8 around: all but the last of the lines run through that.
      if (is_broken && to.x > 20) {
        CHECK(drawn < whole - 2);
        CHECK(drawn > whole - 10);
      } else {
        CHECK(drawn == Approx(whole).margin(0.01));
      }
    }
}
