#include <catch2/catch.hpp>
#include <cmath>

#include "tests/drawing/hand_made_lines.h"

namespace hsr {
namespace {

/// Hidden lines end to end around a circle, of two objects in turn, but for two neighbours of one.
Drawing two_rims(double radius, std::uint32_t count, HiddenLines hidden_lines, bool is_hidden = true) {
  HandMadeLines made;
  const auto corner = [&](std::uint32_t k) {
    const double turn = 2 * std::acos(-1.0) * (k % count) / count;
    return Point3{radius * std::cos(turn), 0, radius * std::sin(turn)};
  };
  for (std::uint32_t k = 0; k < count; ++k) made.add(corner(k), corner(k + 1), EdgeClass::outline, is_hidden);
  const Mesh mesh = made.mesh();
  SceneObjects objects;
  objects.names = {"hole", "pin"};
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) objects.wires.push_back({EdgeId(e), static_cast<std::uint32_t>(e % 2)});
  DrawingOptions options;
  options.page = parse_page("100x100mm");
  options.scale = 1;
  options.hidden = hidden_lines;
  options.objects = &objects;
  return draw(mesh, named_view("front"), made.lines(mesh), options);
}

TEST_CASE("Where objects take turns along a dashed line it is one of several objects, and its dashes run on",
          "[drawing][D16]") {
  const Drawing drawing = two_rims(20, 120, HiddenLines::dashed);  // a millimetre each
  REQUIRE(drawing.polylines.size() == 1);
  CHECK(drawing.polylines[0].closed);
  CHECK(drawing.polylines[0].object == SceneObjects::none);
  CHECK(drawing.points_of(drawing.polylines[0]).size() >= 118);
}

TEST_CASE("What has room for dashes, or is continuous, stays with its object", "[drawing][D16]") {
  CHECK(two_rims(20, 12, HiddenLines::dashed).polylines.size() >= 10);  // ten millimetres each
  CHECK(two_rims(20, 120, HiddenLines::solid).polylines.size() >= 118);
  CHECK(two_rims(20, 120, HiddenLines::dashed, false).polylines.size() >= 118);
}

}  // namespace
}  // namespace hsr
