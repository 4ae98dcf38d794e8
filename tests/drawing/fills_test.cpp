#include <png.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <numeric>

#include "hsr/drawing/drawing.h"
#include "hsr/drawing/painting.h"
#include "hsr/image.h"
#include "hsr/io/write/png.h"
#include "hsr/io/write/svg.h"
#include "hsr/painter/bsp/bsp.h"
#include "hsr/painter/sort/depth_sort.h"
#include "hsr/surfaces/regions.h"
#include "hsr/surfaces/visible_fragments.h"
#include "tests/io/read/temporary_directory.h"
#include "tests/scenes/test_scene.h"

namespace hsr {

using namespace internal;

namespace {

Image<std::uint8_t> read_grey(const std::string& bytes) {
  png_image png;
  std::memset(&png, 0, sizeof png);
  png.version = PNG_IMAGE_VERSION;
  REQUIRE(png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) != 0);
  png.format = PNG_FORMAT_GRAY;
  Image<std::uint8_t> image(static_cast<int>(png.width), static_cast<int>(png.height));
  REQUIRE(png_image_finish_read(&png, nullptr, image.pixels.data(), 0, nullptr) != 0);
  return image;
}

/// As rsvg-convert (package librsvg2-bin) renders it on white, that many pixels wide.
Image<std::uint8_t> rendered(const std::string& svg, int width) {
  const test::TemporaryDirectory at;
  const std::string command = "rsvg-convert --background-color=white -w " + std::to_string(width) + " -o '" + at.file("a.png") +
                              "' '" + at.write("a.svg", svg) + "'";
  REQUIRE(std::system(command.c_str()) == 0);
  std::ifstream file(at.file("a.png"), std::ios::binary);
  return read_grey({std::istreambuf_iterator<char>(file), {}});
}

struct Shining {
  std::size_t inside = 0, shining = 0;
};

/// Of the pixels that are black in `whole`, and so are their neighbours (on the rim a pixel may be covered but for a
/// thousandth): how many are not quite so in `parts`.
Shining shining(const Image<std::uint8_t>& parts, const Image<std::uint8_t>& whole) {
  REQUIRE(parts.width == whole.width);
  REQUIRE(parts.height == whole.height);
  Shining count;
  for (int j = 1; j + 1 < whole.height; ++j)
    for (int i = 1; i + 1 < whole.width; ++i) {
      if (whole.at(i, j) + whole.at(i - 1, j) + whole.at(i + 1, j) + whole.at(i, j - 1) + whole.at(i, j + 1) > 0) continue;
      ++count.inside;
      if (parts.at(i, j) != 0) ++count.shining;
    }
  return count;
}

/// A fan of triangles around a point, with a smaller one turned before it.
scenes::TestScene fans() {
  scenes::TestScene scene;
  scene.view = parallel_view({0, 0, 1}, {0, 1, 0});
  for (int layer = 0; layer < 2; ++layer)
    for (int k = 0; k < 37; ++k) {
      const auto rim = [&](int i) {
        const double a = 2 * 3.14159 * (i % 37) / 37 + 0.1 * layer, r = layer == 0 ? 10 : 6;
        return Point3{r * std::cos(a) + layer, r * std::sin(a), static_cast<double>(layer)};
      };
      scene.add_face({Point3{0.3 + layer, 0.2, static_cast<double>(layer)}, rim(k), rim(k + 1)});
    }
  return scene;
}

Drawing filled(const scenes::TestScene& scene, const std::vector<Colour>& colours, Merge merge,
               const DrawingOptions& options = {}) {
  const Mesh mesh = scene.mesh();
  const Regions regions = regions_of(mesh, scene.view, visible_fragments(mesh, scene.view), colours, merge);
  Drawing drawing = draw(mesh, scene.view, visible_lines(mesh, scene.view), options, &regions);
  drawing.polylines.clear();
  return drawing;
}

TEST_CASE("no seam shows between fills of one colour", "[drawing][fills][D10]") {
  const scenes::TestScene scene = fans();
  const std::vector<Colour> black(scene.polygons.size(), Colour{0, 0, 0, 255});
  const Drawing parts = filled(scene, black, Merge::none), whole = filled(scene, black, Merge::colour);
  REQUIRE(whole.fills.fills.size() == 1);
  REQUIRE(parts.fills.fills.size() > 70);
  for (const PixelSize size : {PixelSize{97, 131}, PixelSize{500, 700}, PixelSize{1301, 1777}}) {
    const auto [inside, by_cairo] = shining(read_grey(png(parts, size)), read_grey(png(whole, size)));
    CHECK(inside > static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height) / 4);
    CHECK(by_cairo <= 2);
    const Shining by_rsvg = shining(rendered(svg(parts), size.width), rendered(svg(whole), size.width));
    CHECK(by_rsvg.inside > inside / 2);
    CHECK(by_rsvg.shining <= 2);
  }
}

TEST_CASE("PNG fills what SVG fills: the holes stay open, and nothing joins rings that are apart", "[drawing][fills][png]") {
  scenes::TestScene scene;
  scene.view = parallel_view({0, 0, 1}, {0, 1, 0});
  const auto at = [](double x, double y) { return Point3{x, y, 0}; };
  // A frame whose window is joined to its rim by a bridge, and a square apart from it.
  scene.add_face(
      {at(0, 0), at(30, 0), at(30, 20), at(0, 20), at(0, 0), at(10, 5), at(10, 15), at(24, 15), at(24, 5), at(10, 5)});
  scene.add_face({at(34, 12), at(40, 12), at(40, 18), at(34, 18)});
  const Drawing drawing = filled(scene, std::vector<Colour>(2, Colour{0, 0, 0, 255}), Merge::none);
  for (const int width : {210, 1050}) {
    const Image<std::uint8_t> theirs = rendered(svg(drawing), width);
    const Image<std::uint8_t> ours = read_grey(png(drawing, PixelSize{theirs.width, theirs.height}));
    std::size_t compared = 0, differing = 0, white_inside = 0;
    for (int j = 1; j + 1 < ours.height; ++j)
      for (int i = 1; i + 1 < ours.width; ++i) {
        bool is_inner = true;  // no border runs through the pixel or beside it
        for (int v = -1; v <= 1; ++v)
          for (int u = -1; u <= 1; ++u) is_inner = is_inner && theirs.at(i + u, j + v) == theirs.at(i, j);
        if (!is_inner) continue;
        ++compared;
        if (ours.at(i, j) != theirs.at(i, j)) ++differing;
        if (theirs.at(i, j) == 255 && std::abs(i - ours.width * 17 / 40) < 9 && std::abs(j - ours.height / 2) < 9)
          ++white_inside;
      }
    CHECK(compared > static_cast<std::size_t>(ours.width) * static_cast<std::size_t>(ours.height) * 8 / 10);
    CHECK(differing == 0);
    CHECK(white_inside > 0);
  }
}

/// Black paint, no lines.
std::string painted(const scenes::TestScene& scene, const PaintersOrder& order) {
  LineOptions lines;
  lines.classes = {};
  return svg(paint_on_page(scene.mesh(), scene.view, order, std::vector<Colour>(scene.polygons.size(), Colour{0, 0, 0, 255}),
                           lines, {}));
}

TEST_CASE("no seam shows between the pieces of a painting", "[drawing][fills]") {
  const scenes::TestScene scene = fans();
  const Drawing whole = filled(scene, std::vector<Colour>(scene.polygons.size(), Colour{0, 0, 0, 255}), Merge::colour);
  const Mesh mesh = scene.mesh();
  const BspTree tree(mesh);
  CHECK(tree.order(scene.view).pieces.size() >= 74);
  for (const std::string& parts : {painted(scene, depth_sort(mesh, scene.view).order), painted(scene, tree.order(scene.view))})
    for (const int width : {97, 500, 1301}) {
      const auto [inside, shines] = shining(rendered(parts, width), rendered(svg(whole), width));
      CHECK(inside > static_cast<std::size_t>(width) * static_cast<std::size_t>(width) / 4);
      CHECK(shines == 0);
    }
}

/// No lines.
LineOptions no_lines() {
  LineOptions lines;
  lines.classes = {};
  return lines;
}

TEST_CASE("no pixel within a surface is lighter or darker than its colours", "[drawing][fills][D10]") {
  const scenes::TestScene scene = fans();
  std::vector<Colour> colours;
  for (std::size_t k = 0; k < scene.polygons.size(); ++k) {
    const auto grey = static_cast<std::uint8_t>(60 + 40 * (k * 7 % 3));
    colours.push_back({grey, grey, grey, 255});
  }
  const Drawing whole = filled(scene, std::vector<Colour>(scene.polygons.size(), Colour{0, 0, 0, 255}), Merge::colour);
  const Mesh mesh = scene.mesh();
  const Drawing painted = paint_on_page(mesh, scene.view, depth_sort(mesh, scene.view).order, colours, no_lines(), {});
  for (const Drawing& drawing : {filled(scene, colours, Merge::none), filled(scene, colours, Merge::colour), painted})
    for (const int width : {97, 500, 1301}) {
      const Image<std::uint8_t> inside = rendered(svg(whole), width), image = rendered(svg(drawing), width);
      std::size_t looked_at = 0, near = 0, wrong = 0;
      for (int j = 1; j + 1 < inside.height; ++j)
        for (int i = 1; i + 1 < inside.width; ++i) {
          if (inside.at(i, j) + inside.at(i - 1, j) + inside.at(i + 1, j) + inside.at(i, j - 1) + inside.at(i, j + 1) > 0)
            continue;
          ++looked_at;
          // Where dozens of thin ones meet within a pixel some of the paper is left, a few hundredths.
          if (image.at(i, j) < 59 || image.at(i, j) > 141) ++near;
          if (image.at(i, j) < 55 || image.at(i, j) > 160) ++wrong;
        }
      CHECK(looked_at > static_cast<std::size_t>(width) * static_cast<std::size_t>(width) / 4);
      CHECK(near < 40);
      CHECK(wrong == 0);
    }
}

TEST_CASE("see-through neighbours of one colour show no seam", "[drawing][fills][layers][D21]") {
  const scenes::TestScene scene = fans();
  const Mesh mesh = scene.mesh();
  const std::vector<Colour> black(scene.polygons.size(), Colour{0, 0, 0, 255});
  for (const double opacity : {0.5, 0.999}) {
    const Drawing drawing =
        paint_on_page(mesh, scene.view, depth_sort(mesh, scene.view).order, black, no_lines(), {}, {.opacity = opacity});
    REQUIRE(drawing.fills.fills.size() == 2);  // two sheets, one over the other
    CHECK(drawing.fills.faces.size() == scene.polygons.size());
    const Image<std::uint8_t> image = rendered(svg(drawing), 500);
    std::array<std::size_t, 256> count = {};
    for (const std::uint8_t grey : image.pixels) ++count[grey];
    const auto once = static_cast<std::size_t>(std::lround(255 * (1 - opacity))),
               twice = static_cast<std::size_t>(std::lround(255 * (1 - opacity) * (1 - opacity)));
    std::size_t as_expected = 0;  // the rest: the rims of the two sheets
    for (std::size_t grey = 0; grey < 256; ++grey)
      if (grey == 255 || std::min(grey + 1 - once, once + 1 - grey) <= 2 || std::min(grey + 1 - twice, twice + 1 - grey) <= 2)
        as_expected += count[grey];
    CHECK(as_expected > image.pixels.size() * 98 / 100);
  }
}

TEST_CASE("lines between see-through pieces are covered by what is painted later", "[drawing][fills][layers][D21]") {
  const scenes::TestScene scene = fans();
  const Mesh mesh = scene.mesh();
  const std::vector<Colour> black(scene.polygons.size(), Colour{0, 0, 0, 255});
  const Drawing drawing = paint_on_page(mesh, scene.view, depth_sort(mesh, scene.view).order, black, {}, {}, {.opacity = 0.5});
  CHECK(drawing.polylines.empty());
  REQUIRE(drawing.fills.lines.size() == 2);  // around each of the two sheets
  CHECK(drawing.fills.lines[0].fills_before == 1);
  CHECK(drawing.fills.lines[1].fills_before == 2);
  CHECK(drawing.fills.lines[0].closed);
  CHECK(drawing.fills.points_of(drawing.fills.lines[0]).size() == 37);
}

TEST_CASE("wires are painted between what they are in front of and what they are behind", "[drawing][fills][layers][P20]") {
  scenes::TestScene scene;
  scene.view = scenes::from_direction({0, 0, 1});
  for (const double z : {0.0, 2.0}) scene.add_face(std::vector<Point3>{{0, 0, z}, {4, 0, z}, {4, 4, z}, {0, 4, z}});
  for (const double z : {-1.0, 0.0, 1.0, 3.0}) {
    scene.points.push_back({-1, 1 + z / 4, z});
    scene.points.push_back({5, 1 + z / 4, z});
    const auto n = static_cast<std::uint32_t>(scene.points.size());
    scene.polygons.segments.push_back({n - 2, n - 1});
  }
  const Mesh mesh = scene.mesh();
  const std::vector<Colour> grey(2, Colour{99, 99, 99, 255});
  LineOptions only_wires = no_lines();
  only_wires.classes[static_cast<std::size_t>(EdgeClass::wire)] = true;
  const PaintersOrder order = depth_sort(mesh, scene.view).order;
  const auto fills_before = [&](const LineOptions& lines, const PaintingOptions& options) {
    std::vector<std::uint32_t> all;
    const Drawing drawing = paint_on_page(mesh, scene.view, order, grey, lines, {}, options);
    CHECK(drawing.polylines.empty());
    for (const FillLine& line : drawing.fills.lines) all.push_back(line.fills_before);
    return all;
  };
  CHECK(fills_before(only_wires, {.opacity = 0.5}) == std::vector<std::uint32_t>{0, 1, 1, 2});
  CHECK(fills_before(only_wires, {.paints_lines_with_pieces = true}) == std::vector<std::uint32_t>{0, 1, 1, 2});
  CHECK(fills_before(no_lines(), {.opacity = 0.5}).empty());
  // What nothing hides is on top of opaque pieces, as in a drawing.
  const Drawing opaque = paint_on_page(mesh, scene.view, order, grey, only_wires, {});
  CHECK(opaque.fills.lines.empty());
  CHECK(opaque.polylines.size() == 7);  // of three what sticks out on both sides
}

TEST_CASE("merging unites what is of one colour, and in one plane", "[drawing][fills][D9]") {
  const scenes::TestScene scene = fans();
  std::vector<Colour> colours(scene.polygons.size(), Colour{9, 9, 9, 255});
  CHECK(filled(scene, colours, Merge::coplanar).fills.fills.size() == 2);
  CHECK(filled(scene, colours, Merge::colour).fills.fills.size() == 1);
  // Squares that only touch, with corners of their own: two in one plane, two not.
  scenes::TestScene apart;
  apart.view = scene.view;
  for (const double x : {0.0, 4.0, 8.0}) {
    const double z = x == 8 ? 1 : 0;
    apart.add_face({Point3{x, x, z}, Point3{x + 4, x, z}, Point3{x + 4, 9, z}, Point3{x, 9, z}});
  }
  CHECK(filled(apart, std::vector<Colour>(3, Colour{9, 9, 9, 255}), Merge::coplanar).fills.fills.size() == 2);
  std::fill(colours.begin(), colours.begin() + 37, Colour{200, 9, 9, 255});
  const Drawing two = filled(scene, colours, Merge::colour);
  REQUIRE(two.fills.fills.size() == 2);
  CHECK(two.fills.fills[0].colour == Colour{200, 9, 9, 255});  // the lower one, around the upper, beneath which it reaches
  CHECK(two.fills.fills[0].end_face - two.fills.fills[0].first_face == 37);
  // Of one colour and apart, each names its own face.
  scenes::TestScene far;
  far.view = scene.view;
  for (const double x : {0.0, 10.0, 20.0})
    far.add_face({Point3{x, 0, 0}, Point3{x + 4, 0, 0}, Point3{x + 4, 4, 0}, Point3{x, 4, 0}});
  const Drawing three = filled(far, std::vector<Colour>(3, Colour{9, 9, 9, 255}), Merge::colour);
  REQUIRE(three.fills.fills.size() == 3);
  CHECK(three.fills.faces.size() == 3);
  const std::string text = svg(two);
  CHECK(text.find("fill=\"#c80909\"") != std::string::npos);
}

TEST_CASE("a frame cuts what is united with a floor and as high as the eye", "[drawing][fills][D9]") {
  // The sight of the wall's upper corners is parallel to the plane of the floor, of which the region is told to be.
  scenes::TestScene scene;
  scene.add_face({Point3{-9, 0, 0}, Point3{9, 0, 0}, Point3{9, 9, 0}, Point3{-9, 9, 0}});
  scene.add_face({Point3{-9, 9, 0}, Point3{9, 9, 0}, Point3{9, 9, 4}, Point3{-9, 9, 4}});
  scene.view = perspective_view({0, -9, 4}, {0, 9, 4}, {0, 0, 1}, 0.001);
  DrawingOptions options;
  options.field_of_view = 30;
  const Drawing one = filled(scene, std::vector<Colour>(2, Colour{9, 9, 9, 255}), Merge::colour, options);
  REQUIRE(one.fills.fills.size() == 1);
  CHECK(one.fills.rings[0].size() == 4);  // the lower half of the frame
  CHECK(one.fills.faces.size() == 2);
}

}  // namespace
}  // namespace hsr
