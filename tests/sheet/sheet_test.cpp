#include "hsr/sheet/sheet.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "geometry/error.h"
#include "hsr/io/write/write.h"
#include "hsr/sheet/paper_box.h"
#include "tests/drawing/round_models.h"
#include "tests/io/write/other_programs.h"

using namespace hsr;

namespace {

/// Deeper than it is high, and off the origin.
Mesh box() {
  ModelMaker maker;
  for (int k = 0; k < 8; ++k) maker.add((k & 1) != 0 ? 31.3 : 1.1, (k & 2) != 0 ? 42.9 : -17.4, (k & 4) != 0 ? 12.25 : -7.5);
  for (const auto& f :
       {std::array{0U, 2U, 3U, 1U}, {4U, 5U, 7U, 6U}, {0U, 1U, 5U, 4U}, {2U, 6U, 7U, 3U}, {0U, 4U, 6U, 2U}, {1U, 3U, 7U, 5U}})
    maker.add_face({f.begin(), f.end()});
  return maker.mesh();
}

const PlacedView& view_named(const Sheet& sheet, const std::string& name) {
  const auto found = std::ranges::find(sheet.views, name, &PlacedView::name);
  REQUIRE(found != sheet.views.end());
  return *found;
}

bool has_view(const Sheet& sheet, const std::string& name) {
  return std::ranges::find(sheet.views, name, &PlacedView::name) != sheet.views.end();
}

std::set<std::string> layers_of(const Sheet& sheet) {
  std::set<std::string> names;
  for (const NamedLayer& layer : sheet.drawing.layers) {
    CHECK(names.insert(layer.name).second);  // each once
    CHECK(layer.first_polyline <= layer.end_polyline);
  }
  return names;
}

/// The points of the layers whose names begin so.
std::vector<PaperPoint> points_of(const Sheet& sheet, const std::string& prefix) {
  std::vector<PaperPoint> all;
  for (const NamedLayer& layer : sheet.drawing.layers) {
    if (!layer.name.starts_with(prefix)) continue;
    for (std::uint32_t k = layer.first_polyline; k < layer.end_polyline; ++k)
      for (const PaperPoint& p : sheet.drawing.points_of(sheet.drawing.polylines[k])) all.push_back(p);
  }
  return all;
}

/// Where a point of the model is on the sheet, by what the sheet says of the view.
Point2 on_paper(const PlacedView& v, const Point3& p) {
  const Frame& f = v.view.frame;
  const Point3 d = {p.x - f.origin.x, p.y - f.origin.y, p.z - f.origin.z};
  return {v.origin.x + v.scale * (d.x * f.right.x + d.y * f.right.y + d.z * f.right.z),
          v.origin.y - v.scale * (d.x * f.up.x + d.y * f.up.y + d.z * f.up.z)};
}

std::set<std::int64_t> coordinates(const std::vector<PaperPoint>& points, std::int64_t PaperPoint::*which) {
  std::set<std::int64_t> all;
  for (const PaperPoint& p : points) all.insert(p.*which);
  return all;
}

}  // namespace

TEST_CASE("What a view shows is where the sheet says that it is", "[sheet][L1]") {
  const Mesh mesh = box();
  for (const auto angle : {ProjectionAngle::first, ProjectionAngle::third}) {
    SheetOptions options;
    options.angle = angle;
    const Sheet sheet = draw_sheet(Scene::of(mesh), options);
    for (const PlacedView& v : sheet.views) {
      CAPTURE(v.name);
      const auto drawn = points_of(sheet, v.name + " visible");
      REQUIRE(drawn.size() >= 4);
      for (const PaperPoint& p : drawn)
        CHECK(std::ranges::any_of(mesh.points, [&](const Point3& q) {
          const Point2 at = on_paper(v, q);
          return std::hypot(at.x - static_cast<double>(p.x) / 1000, at.y - static_cast<double>(p.y) / 1000) < 0.00072;
        }));
      // The edges that a line is said to show are there.
      for (const NamedLayer& layer : sheet.drawing.layers) {
        if (!layer.name.starts_with(v.name + " visible")) continue;
        for (std::uint32_t k = layer.first_polyline; k < layer.end_polyline; ++k) {
          const Polyline& line = sheet.drawing.polylines[k];
          CHECK_FALSE(sheet.drawing.edges_of(line).empty());
          CHECK_FALSE(sheet.drawing.faces_of(line).empty());
          for (const auto& edge : sheet.drawing.edges_of(line))
            for (const std::uint32_t end : edge) {
              const Point2 at = on_paper(v, mesh.points[VertexId(end)]);
              CHECK(std::ranges::any_of(sheet.drawing.points_of(line), [&](const PaperPoint& p) {
                return std::hypot(at.x - static_cast<double>(p.x) / 1000, at.y - static_cast<double>(p.y) / 1000) < 0.00072;
              }));
            }
        }
      }
      for (const PaperPoint& p : drawn) {
        CHECK(static_cast<double>(p.x) / 1000 > v.box.left - 0.001);
        CHECK(static_cast<double>(p.x) / 1000 < v.box.right + 0.001);
      }
    }
  }
}

TEST_CASE("Views line up to the last digit, and stand where the angle of projection says", "[sheet][L1][L2]") {
  const Mesh mesh = plate_with_holes(24);
  for (const auto angle : {ProjectionAngle::first, ProjectionAngle::third}) {
    SheetOptions options;
    options.angle = angle;
    const Sheet sheet = draw_sheet(Scene::of(mesh), options);
    const auto &front = view_named(sheet, "front"), &top = view_named(sheet, "top"), &side = view_named(sheet, "side");
    CHECK((top.origin.y > front.origin.y) == (angle == ProjectionAngle::first));
    CHECK(side.origin.x > front.origin.x);
    // From the left in first angle, from the right in third.
    CHECK(side.view.viewpoint.at.x == (angle == ProjectionAngle::first ? -1 : 1));
    // The hidden edges of the holes in one view begin where those of another do.
    const auto x_of_front = coordinates(points_of(sheet, "front "), &PaperPoint::x);
    for (const std::int64_t x : coordinates(points_of(sheet, "top visible"), &PaperPoint::x)) CHECK(x_of_front.contains(x));
    const auto y_of_front = coordinates(points_of(sheet, "front "), &PaperPoint::y);
    for (const std::int64_t y : coordinates(points_of(sheet, "side visible"), &PaperPoint::y)) CHECK(y_of_front.contains(y));
  }
}

TEST_CASE("The overall dimensions say how large the model is, in millimetres", "[sheet][L6]") {
  const Mesh mesh = box();
  SheetOptions options;
  for (const double unit : {1.0, 10.0, 25.4}) {
    options.unit = unit;
    const Sheet sheet = draw_sheet(Scene::of(mesh), options);
    REQUIRE(sheet.dimensions.size() == 3);
    std::multiset<double> found, expected = {std::round(30.2 * unit * 100) / 100, std::round(19.75 * unit * 100) / 100,
                                             std::round(60.3 * unit * 100) / 100};
    for (const PlacedDimension& d : sheet.dimensions) {
      found.insert(std::stod(d.text));
      const auto& [a, b] = d.points;
      CHECK(std::hypot(a.x - b.x, a.y - b.y, a.z - b.z) * unit == Approx(std::stod(d.text)).margin(0.006));
      CHECK(std::hypot(d.line[0].x - d.line[1].x, d.line[0].y - d.line[1].y) ==
            Approx(std::stod(d.text) * sheet.scale).margin(0.006 * sheet.scale));
    }
    CHECK(found == expected);
  }
  options.has_dimensions = false;
  const Sheet without = draw_sheet(Scene::of(mesh), options);
  CHECK(without.dimensions.empty());
  CHECK_FALSE(layers_of(without).contains("dimensions"));
}

TEST_CASE("A section has its own view, and a cutting line in the view that sees it edge-on", "[sheet][section][L4]") {
  const Mesh mesh = plate_with_holes(24);
  SheetOptions options;
  options.format = sheet_format("A2");
  options.sections = {{{60, 0, 0}, {1, 0, 0}}, {{0, 0, 20}, {0, 0, -1}}, {{0, 5, 0}, {0, 1, 0}}};
  const Sheet sheet = draw_sheet(Scene::of(mesh), options);
  const auto layers = layers_of(sheet);
  for (const char* name : {"A-A", "B-B", "C-C"}) {
    CAPTURE(name);
    CHECK(layers.contains(std::string(name) + " visible section"));
    CHECK(layers.contains(std::string(name) + " visible hatching"));
    CHECK(view_named(sheet, name).label == name);
    CHECK(view_named(sheet, name).view.section);
    for (const std::string& layer : layers) CHECK_FALSE(layer.starts_with(std::string(name) + " hidden"));
  }
  CHECK(layers.contains("cutting lines"));
  // A and B in the front view, C, which it sees face-on, from above. A is looked at as the side is, B as from above.
  CHECK(view_named(sheet, "A-A").view.viewpoint.at == view_named(sheet, "side").view.viewpoint.at);
  CHECK(view_named(sheet, "A-A").origin.y == view_named(sheet, "front").origin.y);
  CHECK(view_named(sheet, "B-B").view.viewpoint.at == view_named(sheet, "top").view.viewpoint.at);
  CHECK(view_named(sheet, "B-B").origin.y == view_named(sheet, "top").origin.y);
  const auto& front = view_named(sheet, "front");
  const double x = on_paper(front, {60, 0, 0}).x, y = on_paper(front, {0, 0, 20}).y;
  std::size_t upright = 0, level = 0, other = 0;
  const auto traces = points_of(sheet, "cutting lines");
  for (const NamedLayer& layer : sheet.drawing.layers) {
    if (layer.name != "cutting lines") continue;
    for (std::uint32_t k = layer.first_polyline; k < layer.end_polyline; ++k) {
      const auto p = sheet.drawing.points_of(sheet.drawing.polylines[k]);
      if (p[0].x == p[1].x && std::fabs(static_cast<double>(p[0].x) / 1000 - x) < 0.001)
        ++upright;
      else if (p[0].y == p[1].y && std::fabs(static_cast<double>(p[0].y) / 1000 - y) < 0.001)
        ++level;
      else
        ++other;
    }
  }
  CHECK(upright == 1);
  CHECK(level == 1);
  CHECK(other == 1);
  CHECK(sheet.notes.empty());

  options.sections = {{{1e6, 0, 0}, {1, 0, 0}}, {{60, 5, 20}, {1, 1, 1}}};
  const Sheet odd = draw_sheet(Scene::of(mesh), options);
  REQUIRE(odd.notes.size() == 2);
  CHECK(odd.notes[0] == "section A-A: the plane cuts no closed body");
  CHECK(odd.notes[1] == "no view of the sheet sees the section B-B edge-on: without a cutting line");
}

TEST_CASE("No line of a dimension runs through a letter of a cutting line", "[sheet][section][L6]") {
  const Mesh mesh = box();
  std::size_t letters_seen = 0;
  for (double y = -17; y < 42.9; y += 1.1) {
    INFO("section y=" << y);
    SheetOptions options;
    options.sections = {{{0, y, 0}, {0, 1, 0}}};
    const Sheet sheet = draw_sheet(Scene::of(mesh), options);
    const auto each_stroke = [&](const std::string& prefix, const auto& visit) {
      for (const NamedLayer& layer : sheet.drawing.layers)
        for (std::uint32_t k = layer.first_polyline; layer.name.starts_with(prefix) && k < layer.end_polyline; ++k)
          visit(layer, sheet.drawing.points_of(sheet.drawing.polylines[k]));
    };
    each_stroke("cutting lines text", [&](const NamedLayer& /*layer*/, const auto& letter) {
      const auto [left, right] = std::ranges::minmax(letter, {}, &PaperPoint::x);
      const auto [top, bottom] = std::ranges::minmax(letter, {}, &PaperPoint::y);
      ++letters_seen;
      each_stroke("dimensions", [&](const NamedLayer& layer, const auto& line) {
        if (layer.name.find("text") != std::string::npos || line.size() != 2) return;
        const auto [x, more_x] = std::minmax(line[0].x, line[1].x);
        const auto [y_low, y_high] = std::minmax(line[0].y, line[1].y);
        CHECK_FALSE((x < right.x && more_x > left.x && y_low < bottom.y && y_high > top.y));
      });
    });
  }
  CHECK(letters_seen > 100);
}

TEST_CASE("A detail shows what is inside its circle, larger", "[sheet]") {
  const Mesh mesh = plate_with_holes(24);
  SheetOptions options;
  options.details = {{"front", {20, 0, 60}, 6, 5}};
  const Sheet sheet = draw_sheet(Scene::of(mesh), options);
  const PlacedView& detail = view_named(sheet, "detail A");
  CHECK(detail.label == "A (5:1)");
  CHECK(detail.scale == 5);
  const Point2 middle = on_paper(detail, {20, 0, 60});
  const auto points = points_of(sheet, "detail A visible");
  REQUIRE(points.size() >= 24);  // the hole of radius 3.5 is inside
  double farthest = 0;
  for (const PaperPoint& p : points)
    farthest =
        std::max(farthest, std::hypot(static_cast<double>(p.x) / 1000 - middle.x, static_cast<double>(p.y) / 1000 - middle.y));
  CHECK(farthest <= 30.001);
  CHECK(farthest >= 17.4);

  // A corner of the plate: both of its edges end at the circle.
  options.details = {{"front", {0, 0, 80}, 6, 5}};
  const Sheet corner = draw_sheet(Scene::of(mesh), options);
  const Point2 at = on_paper(view_named(corner, "detail A"), {0, 0, 80});
  std::size_t on_circle = 0;
  for (const PaperPoint& p : points_of(corner, "detail A visible")) {
    const double distance = std::hypot(static_cast<double>(p.x) / 1000 - at.x, static_cast<double>(p.y) / 1000 - at.y);
    CHECK(distance <= 30.001);
    if (distance > 29.999) ++on_circle;
  }
  CHECK(on_circle == 2);
  options.details = {{"front", {500, 0, 500}, 6, 2}};
  const Sheet beside = draw_sheet(Scene::of(mesh), options);
  REQUIRE(beside.notes.size() == 1);
  CHECK(beside.notes[0] == "detail A (2:1): there is no line within its circle");
  CHECK_THROWS_AS(draw_sheet(Scene::of(mesh), {.details = {{"back", {}, 1, 2}}}), InputError);
  CHECK_THROWS_AS(draw_sheet(Scene::of(mesh), {.details = {{"front", {}, 0, 2}}}), InputError);
}

TEST_CASE("The letter of a detail stands where no line of the view is", "[sheet]") {
  const Mesh mesh = plate_with_holes(24);
  std::size_t letters = 0;
  // Around a hole and a corner, and across an edge.
  for (const Point3& at : {Point3{20, 0, 60}, {0, 0, 80}, {26, 0, 66}, {23, 0, 64}, {15, 0, 55}}) {
    SheetOptions options;
    options.details = {{"front", at, 2, 10}};
    const Sheet sheet = draw_sheet(Scene::of(mesh), options);
    for (const NamedLayer& layer : sheet.drawing.layers) {
      if (!layer.name.starts_with("details text")) continue;
      for (std::uint32_t k = layer.first_polyline; k < layer.end_polyline; ++k) {
        const auto letter = sheet.drawing.points_of(sheet.drawing.polylines[k]);
        const auto [left, right] = std::ranges::minmax(letter, {}, &PaperPoint::x);
        const auto [top, bottom] = std::ranges::minmax(letter, {}, &PaperPoint::y);
        const auto mm = [](std::int64_t x) { return static_cast<double>(x) / 1000; };
        INFO(at.x << ", " << at.z);
        CHECK(internal::is_free(sheet.drawing, "front", {mm(left.x), mm(top.y), mm(right.x), mm(bottom.y)}));
        ++letters;
      }
    }
  }
  CHECK(letters >= 5);
}

TEST_CASE("Centre lines cross at the middle of holes, and run along their axes", "[sheet][L5]") {
  const Mesh mesh = plate_with_holes(24);
  const Sheet sheet = draw_sheet(Scene::of(mesh), {});
  const auto& front = view_named(sheet, "front");
  const auto points = points_of(sheet, "front centre lines");
  for (const Hole& hole : plate_holes) {
    const Point2 at = on_paper(front, {hole.x, 0, hole.z});
    const auto is_at = [&](double dx, double dy) {
      return std::ranges::any_of(points, [&](const PaperPoint& p) {
        return std::hypot(static_cast<double>(p.x) / 1000 - at.x - dx, static_cast<double>(p.y) / 1000 - at.y - dy) < 0.002;
      });
    };
    const double reach = hole.radius * front.scale + 3;
    CHECK(is_at(0, 0));
    CHECK(is_at(reach, 0));
    CHECK(is_at(-reach, 0));
    CHECK(is_at(0, reach));
    CHECK(is_at(0, -reach));
  }
  // From above the holes of the upper row are behind those of the lower: three axes, not six.
  std::set<std::int64_t> across;
  for (const PaperPoint& p : points_of(sheet, "top centre lines")) across.insert(p.x);
  CHECK(across.size() == 3);
  // Without hidden lines none of holes that are not to be seen.
  const Sheet plain = draw_sheet(Scene::of(mesh), {.hidden = HiddenLines::none});
  CHECK(points_of(plain, "top centre lines").empty());
  CHECK(points_of(plain, "front centre lines").size() == points.size());
  // A section has those that it cuts, wherever beside their axes, and no hidden ones.
  for (const double x : {60.0, 60 + 1e-9, 60 - 1e-9, 64.0, 67.0}) {
    CAPTURE(x);
    const Sheet cut = draw_sheet(Scene::of(mesh), {.sections = {{{x, 0, 0}, {1, 0, 0}}}});
    std::set<std::int64_t> heights;
    for (const PaperPoint& p : points_of(cut, "A-A centre lines")) heights.insert(p.y);
    CHECK(heights.size() == 2);  // of the holes at 60, of the radii 15 and 12
  }
  CHECK_FALSE(layers_of(draw_sheet(Scene::of(mesh), {.has_centre_lines = false})).contains("front centre lines"));
  // The cutting line stands for the centre line that it runs along.
  SheetOptions cut;
  cut.sections = {{{20, 0, 0}, {1, 0, 0}}};
  const Sheet with_cut = draw_sheet(Scene::of(mesh), cut);
  const auto axis = std::llround(on_paper(view_named(with_cut, "front"), {20, 0, 0}).x * 1000);
  for (const NamedLayer& layer : with_cut.drawing.layers) {
    if (layer.name != "front centre lines") continue;
    for (std::uint32_t k = layer.first_polyline; k < layer.end_polyline; ++k) {
      const auto p = with_cut.drawing.points_of(with_cut.drawing.polylines[k]);
      CHECK_FALSE((p[0].x == axis && p[1].x == axis));
    }
  }
}

TEST_CASE("What has no room, or is no view, is refused in one line", "[sheet][L3]") {
  const Mesh mesh = plate_with_holes(24);
  CHECK_THROWS_WITH(draw_sheet(Scene::of(mesh), {.scale = 20}),
                    "scale: the views have no room on A3 at 20:1, expected 1:1 or less, or a larger sheet");
  CHECK_THROWS_WITH(draw_sheet(Scene::of(mesh), {.views = {"front", "below"}}),
                    "views: found \"below\", expected some of front, top, side, iso");
  CHECK_THROWS_AS(draw_sheet(Scene::of(mesh), {.views = {}}), InputError);
  CHECK_THROWS_AS(sheet_format("A9"), InputError);
  CHECK_THROWS_AS(draw_sheet(Scene(Mesh()), {}), InputError);
}

TEST_CASE("Models of any size have a scale", "[sheet][L3]") {
  for (const double size : {1e-290, 1e-30, 1e-3, 1e9, 1e30, 1e150, 1e290}) {
    CAPTURE(size);
    ModelMaker maker;
    for (const auto& [x, y, z] : {std::array{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}})
      maker.add(size * x, size * y, size * z);
    for (const auto& face : {std::vector{0U, 2U, 1U}, {0U, 1U, 3U}, {1U, 2U, 3U}, {2U, 0U, 3U}}) maker.add_face(face);
    const Sheet sheet = draw_sheet(Scene(maker.mesh()), {});
    const PlacedView& front = view_named(sheet, "front");
    CHECK(front.box.right - front.box.left > 20);
    CHECK(front.box.right - front.box.left < 200);
    CHECK_FALSE(points_of(sheet, "front visible").empty());
  }
}

TEST_CASE("The grid has as many fields as ISO 5457 has for each size", "[sheet]") {
  const std::tuple<const char*, std::size_t, std::size_t> sizes[] = {
      {"A0", 24, 16}, {"A1", 16, 12}, {"A2", 12, 8}, {"A3", 8, 6}, {"A4", 4, 6}};
  for (const auto& [name, across, down] : sizes) {
    CAPTURE(name);
    SheetOptions options;
    options.format = sheet_format(name);
    options.views = {"front"};
    const Sheet sheet = draw_sheet(Scene::of(box()), options);
    std::set<std::int64_t> x, y;
    for (const NamedLayer& layer : sheet.drawing.layers) {
      if (layer.name != "frame grid") continue;
      for (std::uint32_t k = layer.first_polyline; k < layer.end_polyline; ++k) {
        const auto p = sheet.drawing.points_of(sheet.drawing.polylines[k]);
        if (p.size() != 2) continue;  // the border around it
        if (p[0].x == p[1].x) x.insert(p[0].x);
        if (p[0].y == p[1].y) y.insert(p[0].y);
      }
    }
    CHECK(x.size() + 1 == across);
    CHECK(y.size() + 1 == down);
  }
}

TEST_CASE("Every sheet has a frame and a title block within the paper", "[sheet]") {
  for (const char* name : {"A0", "A1", "A2", "A3", "A4", "ANSI-A", "ANSI-B"}) {
    CAPTURE(name);
    SheetOptions options;
    options.format = sheet_format(name);
    options.title.title = "A title that is so long that it would not fit into the block without being written narrower";
    const Sheet sheet = draw_sheet(Scene::of(box()), options);
    CHECK(sheet.drawing.width == options.format.width);
    for (const PaperPoint& p : sheet.drawing.points) {
      CHECK(p.x >= 0);
      CHECK(static_cast<double>(p.x) / 1000 <= options.format.width);
      CHECK(p.y >= 0);
      CHECK(static_cast<double>(p.y) / 1000 <= options.format.height);
    }
    for (const PaperPoint& p : points_of(sheet, "title block"))
      CHECK(static_cast<double>(p.x) / 1000 <= sheet.frame.right + 0.01);
    CHECK(layers_of(sheet).contains("frame"));
    CHECK(has_view(sheet, "iso"));
  }
}

TEST_CASE("A text that is too long for its field has smaller letters or two lines, and else a note", "[sheet][L7]") {
  const Mesh mesh = box();
  const Scene scene = Scene::of(mesh);
  const auto drawn = [&](std::string TitleBlock::*field, const std::string& text) {
    SheetOptions options;
    options.title.*field = text;
    return draw_sheet(scene, options);
  };
  const auto letters_of = [&](const Sheet& sheet) {
    std::set<std::string> names;
    for (const std::string& name : layers_of(sheet))
      if (name.starts_with("title block text")) names.insert(name.substr(17));
    return names;
  };
  // How many lines: the heights at which the texts end that are that high.
  const auto bottoms_of = [&](const Sheet& sheet, const std::string& letters) {
    std::set<std::int64_t> bottoms;
    for (const PaperPoint& p : points_of(sheet, "title block text " + letters)) bottoms.insert(p.y / 5000);
    return bottoms.size();
  };
  const Sheet one = drawn(&TitleBlock::title, "BRACKET"),
              two = drawn(&TitleBlock::title, "BRACKET FOR THE BEARINGS OF THE SECOND SHAFT");
  CHECK(one.notes.empty());
  CHECK(two.notes.empty());
  CHECK(letters_of(two) == letters_of(one));
  CHECK(bottoms_of(two, "50") > bottoms_of(one, "50"));
  CHECK(drawn(&TitleBlock::creator, "A. B. Creator and C. D. Draughtsman").notes.empty());
  const std::string word(80, 'W');
  const Sheet narrow = drawn(&TitleBlock::title, word);
  REQUIRE(narrow.notes.size() == 1);
  CHECK(narrow.notes[0] == "title block: \"" + word + "\" is too long for its field and is written narrower");
}

TEST_CASE("An object has one hatching in all sections of a sheet", "[sheet][section][X12]") {
  // Long and narrow: cut across, it is thick, and cut near a side, too, but its bar is thin.
  ModelMaker maker;
  const auto add_box = [&](const Point3& low, const Point3& high) {
    std::array<std::uint32_t, 8> corner;
    for (std::size_t k = 0; k < 8; ++k)
      corner[k] = maker.add((k & 1) != 0 ? high.x : low.x, (k & 2) != 0 ? high.y : low.y, (k & 4) != 0 ? high.z : low.z);
    for (const auto& f :
         {std::array{0U, 2U, 3U, 1U}, {4U, 5U, 7U, 6U}, {0U, 1U, 5U, 4U}, {2U, 6U, 7U, 3U}, {0U, 4U, 6U, 2U}, {1U, 3U, 7U, 5U}})
      maker.add_face({corner[f[0]], corner[f[1]], corner[f[2]], corner[f[3]]});
  };
  add_box({0, 0, 0}, {60, 40, 40});
  add_box({80, 0, 0}, {140, 6, 6});
  const Mesh mesh = maker.mesh();
  SheetOptions options;
  options.format = sheet_format("A1");
  options.scale = 1;
  options.sections = {{{30, 0, 0}, {1, 0, 0}}, {{110, 0, 0}, {1, 0, 0}}};
  const Sheet sheet = draw_sheet(Scene::of(mesh), options);
  // How far apart lines at 45 degrees are: by where they meet an upright.
  const auto spacing = [&](const std::string& view) {
    std::set<std::int64_t> feet;
    for (const PaperPoint& p : points_of(sheet, view + " visible hatching")) feet.insert((p.x + p.y + 5) / 10);
    REQUIRE(feet.size() > 1);
    std::int64_t least = 1000000;
    for (auto at = feet.begin(); std::next(at) != feet.end(); ++at)
      if (*std::next(at) - *at > 20) least = std::min(least, *std::next(at) - *at);
    return static_cast<double>(least) / 100 / std::sqrt(2.0);
  };
  CHECK(spacing("A-A") == Approx(4).epsilon(0.02));
  CHECK(spacing("B-B") == Approx(spacing("A-A")).epsilon(0.02));
}

namespace {

constexpr int dots = 10;  // to a millimetre

/// How far each pixel is from the nearest line of a drawing, less half of its width, mm; up to a millimetre.
std::vector<float> distances(const Drawing& drawing, int width, int height) {
  std::vector<float> all(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 1);
  const auto add = [&](const PaperPoint& from, const PaperPoint& to, double half) {
    const double ax = double(from.x) / 1000, ay = double(from.y) / 1000, bx = double(to.x) / 1000, by = double(to.y) / 1000;
    const double length = (bx - ax) * (bx - ax) + (by - ay) * (by - ay);
    const int first_x = std::max(0, int((std::min(ax, bx) - 2) * dots)),
              last_x = std::min(width - 1, int((std::max(ax, bx) + 2) * dots));
    const int first_y = std::max(0, int((std::min(ay, by) - 2) * dots)),
              last_y = std::min(height - 1, int((std::max(ay, by) + 2) * dots));
    for (int y = first_y; y <= last_y; ++y)
      for (int x = first_x; x <= last_x; ++x) {
        const double px = (x + 0.5) / dots, py = (y + 0.5) / dots;
        const double t = length > 0 ? std::clamp(((px - ax) * (bx - ax) + (py - ay) * (by - ay)) / length, 0.0, 1.0) : 0;
        const double d = std::hypot(px - ax - t * (bx - ax), py - ay - t * (by - ay)) - half;
        float& least = all[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
        least = std::min(least, static_cast<float>(d));
      }
  };
  for (const NamedLayer& layer : drawing.layers)
    for (std::uint32_t k = layer.first_polyline; k < layer.end_polyline; ++k) {
      const Polyline& p = drawing.polylines[k];
      const auto points = drawing.points_of(p);
      for (std::size_t i = 0; i + (p.closed ? 0 : 1) < points.size(); ++i)
        add(points[i], points[(i + 1) % points.size()], layer.pen.width / 2);
    }
  return all;
}

struct WrongPixels {
  std::size_t dark = 0, missing = 0, stray = 0;
};

/// @param without_dashes the drawing without the layers that are dashed, of which each point of a line is ink
WrongPixels wrong_in(const RenderedPage& page, const Drawing& drawing, const Drawing& without_dashes) {
  const auto any = distances(drawing, page.width, page.height), solid = distances(without_dashes, page.width, page.height);
  WrongPixels wrong;
  for (std::size_t k = 0; k < any.size(); ++k) {
    const int grey = page.bytes[3 * k];
    if (solid[k] < -0.1F) ++wrong.dark;
    if (solid[k] < -0.1F && grey > 128) ++wrong.missing;
    if (any[k] > 0.15F && grey < 250) ++wrong.stray;
  }
  return wrong;
}

}  // namespace

TEST_CASE("Other programs show a sheet with every line of it and nothing else", "[sheet][others]") {
  const Mesh mesh = plate_with_holes(24);
  SheetOptions options;
  options.sections = {{{60, 0, 0}, {1, 0, 0}}};
  options.details = {{"front", {20, 0, 60}, 6, 2}};
  options.title = {"Owner",        "Plate", "with six holes", "4711", "M. Muster", "B. Boss",
                   "Part drawing", "Steel", "2020-02-02",     "A",    "en",        "1/1"};
  const Sheet sheet = draw_sheet(Scene::of(mesh), options);
  Drawing solid = sheet.drawing;
  std::erase_if(solid.layers, [](const NamedLayer& layer) { return layer.pen.is_dashed(); });
  struct Renderer {
    const char *program, *format, *command;
  };
  for (const Renderer& r :
       {Renderer{"rsvg-convert", "svg", "rsvg-convert -w 4200 -h 2970 -b white -o picture.png drawn.svg"},
        Renderer{"pdftoppm", "pdf", "pdftoppm -scale-to-x 4200 -scale-to-y 2970 -png -singlefile drawn.pdf picture"},
        Renderer{"gs", "eps",
                 "gs -q -dSAFER -dNOPAUSE -dBATCH -dEPSCrop -r254 -sDEVICE=png16m -dGraphicsAlphaBits=4 "
                 "-sOutputFile=picture.png drawn.eps"}}) {
    if (!is_there(r.program)) continue;
    CAPTURE(r.program);
    const Workplace here("hsr_sheet");
    here.write(std::string("drawn.") + r.format, written(sheet.drawing, r.format));
    int status = 0;
    INFO(here.run(r.command, status));
    REQUIRE(status == 0);
    const RenderedPage page = read_png(here / "picture.png");
    REQUIRE(page.width == 4200);
    REQUIRE(page.height == 2970);
    const WrongPixels wrong = wrong_in(page, sheet.drawing, solid);
    CHECK(wrong.dark > 50000);
    CHECK(wrong.missing == 0);
    CHECK(wrong.stray == 0);
    // A line that is lost is found, and one that is too much.
    Drawing less = sheet.drawing;
    less.layers.pop_back();
    CHECK(wrong_in(page, less, less).stray > 100);
  }
}
