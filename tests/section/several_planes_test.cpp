// Several section planes, planes that are seen edge-on, and far planes, against what they leave told point by point.
#include <catch2/catch.hpp>
#include <map>
#include <random>
#include <set>
#include <sstream>

#include "geometry/error.h"
#include "hsr/check/sample_checks.h"
#include "hsr/lines/hidden_points.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/painter/bsp/bsp.h"
#include "hsr/painter/sort/depth_sort.h"
#include "hsr/painter/verify/verify.h"
#include "hsr/raster/capped_samples.h"
#include "hsr/raster/caster.h"
#include "hsr/surfaces/section.h"
#include "hsr/surfaces/visible_fragments.h"
#include "tests/scenes/test_scene.h"
#include "tests/section/cut_boxes.h"
#include "tests/section/kept_boxes_oracle.h"

namespace hsr {
namespace {

using namespace internal;

/// One to three planes, through corners, along edges and along faces of the boxes or off them, some seen edge-on; now and then a far plane.
std::optional<View> any_cuts(const CutBoxes& boxes, std::uint64_t seed, std::string& text) {
  std::mt19937_64 random(seed * 131 + 5);
  const auto between = [&](int low, int high) {
    return low + static_cast<int>(random() % static_cast<std::uint64_t>(high - low + 1));
  };
  const View& view = boxes.uncut_view;
  const auto small = [&] {
    return Point3{static_cast<double>(between(-2, 2)), static_cast<double>(between(-2, 2)),
                  static_cast<double>(between(-2, 2))};
  };
  std::vector<SectionPlane> planes;
  std::ostringstream out;
  const int count = between(1, 3);
  while (static_cast<int>(planes.size()) < count) {
    SectionPlane plane{boxes.points[random() % boxes.points.size()], small()};
    if (between(0, 2) == 0) plane.normal = {between(0, 1) == 0 ? 1.0 : 0.0, 0, between(0, 1) == 0 ? 1.0 : 0.0};
    if (between(0, 2) == 0) plane.point = {plane.point.x + 0.5, plane.point.y - 0.25, plane.point.z + 0.5};
    if (between(0, 2) == 0) {
      const Point3 e = view.viewpoint.at, s = small();
      plane.normal = {e.y * s.z - e.z * s.y, e.z * s.x - e.x * s.z, e.x * s.y - e.y * s.x};
      if (view.is_perspective()) plane.point = {0, 0, 0};
    }
    if (plane.normal == Point3{}) continue;
    planes.push_back(plane);
    out << "plane " << plane.normal.x << "," << plane.normal.y << "," << plane.normal.z << "@" << plane.point.x << ","
        << plane.point.y << "," << plane.point.z << "\n";
  }
  View cut = with_sections(view, planes);
  if (between(0, 2) == 0) {
    const double depth = between(1, 6) * 0.5;
    out << "depth " << depth << "\n";
    try {
      cut = with_depth(cut, depth);
    } catch (const InputError&) {
      out << "  (none)\n";
    }
  }
  text = boxes.text + out.str();
  if (!cut.has_cells()) return {};
  return cut;
}

template <class Check>
void on_cut_views(std::uint64_t count, const Check& check) {
  int checked = 0;
  for (std::uint64_t seed = 0; seed < count; ++seed) {
    const CutBoxes boxes = cut_boxes(seed);
    std::string text;
    const std::optional<View> view = any_cuts(boxes, seed, text);
    if (!view) continue;
    ++checked;
    INFO("seed " << seed << "\n" << text);
    check(boxes, SceneView(Scene(make_mesh(boxes.points, boxes.polygons), boxes.labels), *view));
  }
  CHECK(checked > static_cast<int>(count / 2));
}

using Intervals = std::vector<std::array<Rational, 2>>;

std::string united(Intervals all) {
  std::sort(all.begin(), all.end());
  std::string text;
  for (std::size_t k = 0; k < all.size();) {
    Rational from = all[k][0], to = all[k][1];
    for (; k < all.size() && all[k][0] <= to; ++k) to = std::max(to, all[k][1]);
    text += " " + from.to_string() + ".." + to.to_string();
  }
  return text;
}

/// Of each edge the visible and the hidden parts.
std::string edges_of(const SceneView& scene, const VisibleLines& lines) {
  std::map<std::uint32_t, std::array<Intervals, 2>> of_edge;
  for (const Line& line : lines.lines) {
    if (line.is_intersection() || line.is_behind) continue;
    const auto cuts = lines.cuts_of(line);
    const SupportingLine support = supporting_line_of(scene.mesh(), lines, line);
    for (std::uint32_t k = 0; k < line.intervals(); ++k)
      of_edge[line.edge.value][line.hidden(k) ? 1 : 0].push_back(
          {exact_parameter(scene.mesh(), scene.view(), support, cuts[k]),
           exact_parameter(scene.mesh(), scene.view(), support, cuts[k + 1])});
  }
  std::string text;
  for (const auto& [edge, parts] : of_edge)
    text += std::to_string(edge) + ":" + united(parts[0]) + " |" + united(parts[1]) + "\n";
  return text;
}

bool is_seen_as_point(const View& view, const RationalVector& a, const RationalVector& b) {
  const RationalVector e = rational(view.viewpoint.at), c = cross(view.is_perspective() ? minus(e, a) : e, minus(b, a));
  return c[0].sign() == Sign::zero && c[1].sign() == Sign::zero && c[2].sign() == Sign::zero;
}

std::string expected_edges(const CutBoxes& boxes, const SceneView& scene) {
  const KeptBoxesOracle oracle(boxes, scene.view());
  std::string text;
  for (std::uint32_t i = 0; i < scene.mesh().edges.size(); ++i) {
    const Edge& edge = scene.mesh().edges[EdgeId(i)];
    const RationalVector a = rational(scene.mesh().points[edge.a]), b = rational(scene.mesh().points[edge.b]);
    if (edge.diagonal || is_seen_as_point(scene.view(), a, b)) continue;
    const std::vector<Rational> changes = oracle.changes(a, b);
    std::array<Intervals, 2> parts;
    for (std::size_t k = 0; k + 1 < changes.size(); ++k) {
      const Rational t = (changes[k] + changes[k + 1]) * Rational(0.5);
      RationalVector p;
      for (std::size_t axis = 0; axis < 3; ++axis) p[axis] = a[axis] + t * (b[axis] - a[axis]);
      if (oracle.is_kept(p)) parts[oracle.is_hidden(p) ? 1 : 0].push_back({changes[k], changes[k + 1]});
    }
    if (parts[0].empty() && parts[1].empty()) continue;
    text += std::to_string(i) + ":" + united(parts[0]) + " |" + united(parts[1]) + "\n";
  }
  return text;
}

TEST_CASE("lines of what several planes leave are those that the planes leave point by point",
          "[section][planes][random][X9][X10][X11]") {
  on_cut_views(500, [](const CutBoxes& boxes, const SceneView& scene) {
    LineOptions options;
    options.classes.fill(true);
    options.method = LineMethod::roberts;
    const std::string found = edges_of(scene, visible_lines(scene, options));
    CHECK(found == expected_edges(boxes, scene));
    options.method = LineMethod::appel;
    CHECK(edges_of(scene, visible_lines(scene, options)) == found);
  });
}

TEST_CASE("where faces pierce each other several planes leave the right parts", "[section][planes][random]") {
  int parts = 0;
  on_cut_views(500, [&](const CutBoxes& boxes, const SceneView& scene) {
    const KeptBoxesOracle oracle(boxes, scene.view());
    const VisibleLines lines = visible_lines(scene);
    for (const Line& line : lines.lines) {
      if (!line.is_intersection() || line.is_behind) continue;
      for (std::uint32_t k = 0; k < line.intervals(); ++k) {
        const auto p = exact_point(scene, lines, line, k), q = exact_point(scene, lines, line, k + 1);
        for (const double t : {0.03, 0.41, 0.97}) {
          RationalVector at;
          for (std::size_t axis = 0; axis < 3; ++axis) at[axis] = p[axis] + Rational(t) * (q[axis] - p[axis]);
          CHECK(oracle.is_kept(at));
          CHECK(oracle.is_hidden(at) == line.hidden(k));
          ++parts;
        }
      }
    }
  });
  CHECK(parts > 100);
}

/// Whether the place of the paper is within the rings, whichever way round.
bool is_within(const View& view, const Section& section, const SectionCap& cap, const std::array<Rational, 2>& at) {
  bool within = false;
  for (std::uint32_t r = cap.first_ring; r < cap.end_ring; ++r) {
    const auto ring = section.rings[r];
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const auto p = image(view, ring[k]), q = image(view, ring[(k + 1) % ring.size()]);
      if ((p[1] > at[1]) == (q[1] > at[1])) continue;
      const Rational x = p[0] + (at[1] - p[1]) / (q[1] - p[1]) * (q[0] - p[0]);
      if (at[0] < x) within = !within;
    }
  }
  return within;
}

TEST_CASE("samples, fragments and caps show what several planes leave", "[section][planes][random][X9][X10][X11]") {
  on_cut_views(500, [](const CutBoxes& boxes, const SceneView& scene) {
    const KeptBoxesOracle oracle(boxes, scene.view());
    PaperRectangle part = paper_rectangle(scene.mesh(), scene.view());
    part = {part.left - 0.137, part.right + 0.0731, part.bottom - 0.0871, part.top + 0.0517};
    const SampleGrid samples = sample_grid(scene.view(), part, 13, 17);
    const CastImage cast_image = cast(scene, samples);
    const Image<std::uint8_t> capped = capped_samples(scene, samples);
    const Section caps = section(scene);
    int wrong = 0;
    for (int j = 0; j < samples.height; ++j)
      for (int i = 0; i < samples.width; ++i) {
        const RationalVector p = rational(samples.at(i, j));
        const KeptBoxesOracle::Seen seen = oracle.seen(p);
        const FaceId face = cast_image.face(scene.mesh(), i, j);
        const bool is_face = seen.kind == KeptBoxesOracle::Seen::Kind::face;
        if (face.is_valid() != is_face || (is_face && face.value != seen.face)) ++wrong;
        if (seen.kind == KeptBoxesOracle::Seen::Kind::cap && capped.at(i, j) == 0) ++wrong;
        const auto at = image(scene.view(), p);
        const bool is_in_cap = std::any_of(caps.caps.begin(), caps.caps.end(),
                                           [&](const SectionCap& cap) { return is_within(scene.view(), caps, cap, at); });
        if (is_in_cap != (seen.kind == KeptBoxesOracle::Seen::Kind::cap)) ++wrong;
      }
    CHECK(wrong == 0);
    CHECK(check_fragments(scene, visible_fragments(scene), samples).is_right());
  });
}

TEST_CASE("orders paint what several planes leave", "[section][planes][random][X8][X9][X10][X11]") {
  on_cut_views(300, [](const CutBoxes&, const SceneView& scene) {
    const SampleGrid samples = sample_grid(scene.view(), paper_rectangle(scene.mesh(), scene.view()), 23, 19);
    CHECK(check_order(scene, depth_sort(scene).order, samples).wrong == 0);
    CHECK(check_order(scene, BspTree(scene.mesh()).order(scene), samples).wrong == 0);
  });
}

TEST_CASE("points are hidden as several planes leave what hides them", "[section][planes][random]") {
  on_cut_views(300, [](const CutBoxes& boxes, const SceneView& scene) {
    const KeptBoxesOracle oracle(boxes, scene.view());
    std::vector<Point3> points;
    for (int k = 0; k < 60; ++k)
      points.push_back({-3 + k * 0.1 + 0.01 * (k % 7), 3 - (k * 37 % 60) * 0.1, -3 + (k * 23 % 60) * 0.1});
    const std::vector<bool> hidden = hidden_points(scene, points);
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (!oracle.is_kept(rational(points[k]))) continue;
      INFO(points[k].x << "," << points[k].y << "," << points[k].z);
      CHECK(hidden[k] == oracle.is_hidden(rational(points[k])));
    }
  });
}

/// A wall that is cut twice, and one beside it.
SceneView walls_seen(const std::vector<SectionPlane>& planes, const Point3& direction) {
  static const std::array<std::array<Point3, 2>, 2> boxes = {{{{{0, 0, 0}, {4, 4, 4}}}, {{{4, 0, 0}, {6, 4, 4}}}}};
  std::vector<Point3> points;
  Polygons polygons;
  FaceLabels labels;
  for (std::uint32_t b = 0; b < 2; ++b) {
    scenes::TestScene box;
    box.add_box(boxes[b][0], boxes[b][1]);
    const auto base = static_cast<std::uint32_t>(points.size());
    points.insert(points.end(), box.points.begin(), box.points.end());
    for (std::size_t f = 0; f < box.polygons.size(); ++f) {
      for (const std::uint32_t c : box.polygons[f]) polygons.corners.push_back(base + c);
      polygons.first.push_back(static_cast<std::uint32_t>(polygons.corners.size()));
      labels.object.push_back(b);
    }
  }
  return {Scene(make_mesh(points, polygons), labels), with_sections(scenes::from_direction(direction), planes)};
}

/// The lines of one class, as "x,y,z x,y,z".
std::set<std::string> lines_of(const Section& section, EdgeClass edge_class) {
  std::set<std::string> all;
  const auto text = [](const RationalVector& p) { return p[0].to_string() + "," + p[1].to_string() + "," + p[2].to_string(); };
  for (const SectionLine& line : section.lines)
    if (line.edge_class == edge_class)
      all.insert(text(std::min(line.ends[0], line.ends[1])) + " " + text(std::max(line.ends[0], line.ends[1])));
  return all;
}

TEST_CASE("where caps of two planes meet in one object is a joint", "[section][planes][X6][X12]") {
  // From the front, right and above: planes x = 3 and y = 2 leave a corner out of the first box only behind x = 3.
  const Section cut = section(walls_seen({{{3, 0, 0}, {1, 0, 0}}, {{0, 2, 0}, {0, 1, 0}}}, {1, -1, 1}));
  CHECK(lines_of(cut, EdgeClass::joint) == std::set<std::string>{"3,2,0 3,2,4", "4,2,0 4,2,4"});
  const std::set<std::string> border = lines_of(cut, EdgeClass::section);
  CHECK(border.contains("3,0,0 3,2,0"));
  CHECK(border.contains("3,2,0 4,2,0"));
  CHECK_FALSE(border.contains("3,2,0 3,2,4"));
  REQUIRE(cut.caps.size() == 3);
  CHECK(cut.caps[0].object == 0);
  CHECK(cut.caps[0].plane + cut.caps[1].plane == 1);
  CHECK(cut.caps[2].object == 1);
  CHECK(cut.caps[2].plane == 1);
}

TEST_CASE("a half section has no line between its halves, and one plane that is seen edge-on has one",
          "[section][planes][X10]") {
  const Section half = section(walls_seen({{{0, 2, 0}, {0, 1, 0}}, {{3, 0, 0}, {-1, 0, 0}}}, {0, -1, 0}));
  CHECK(lines_of(half, EdgeClass::section) ==
        std::set<std::string>{"3,2,0 4,2,0", "3,2,4 4,2,4", "4,2,0 6,2,0", "4,2,4 6,2,4", "6,2,0 6,2,4"});
  CHECK(half.caps.size() == 2);
  const Section side = section(walls_seen({{{3, 0, 0}, {-1, 0, 0}}}, {0, -1, 0}));
  CHECK(side.caps.empty());
  REQUIRE(lines_of(side, EdgeClass::section).size() == 1);
  CHECK(side.lines[0].ends[0][0] == Rational(3.0));
  // A body whose face lies in the plane: cut where it is taken away, untouched where it is left.
  CHECK(section(walls_seen({{{4, 0, 0}, {-1, 0, 0}}}, {0, -1, 0})).lines.size() == 1);
  CHECK(section(walls_seen({{{6, 0, 0}, {-1, 0, 0}}}, {0, -1, 0})).lines.empty());
}

TEST_CASE("two planes that leave both sides of one plane take nothing away, and have no line", "[section][planes][X9][X10]") {
  CHECK(section(walls_seen({{{3, 0, 0}, {-1, 0, 0}}, {{3, 0, 0}, {1, 0, 0}}}, {0, -1, 0})).lines.empty());
  CHECK(section(walls_seen({{{3, 0, 0}, {-1, 0, 0}}, {{2.5, 0, 0}, {1, 0, 0}}}, {0, -1, 0})).lines.empty());
  CHECK(section(walls_seen({{{2.5, 0, 0}, {-1, 0, 0}}, {{3, 0, 0}, {2, 0, 0}}}, {0, -1, 0})).lines.size() == 2);
}

TEST_CASE("of parallel planes the one that takes less away is left", "[section][planes][X9]") {
  const View view = scenes::from_direction({0, 0, 1});
  const View cut = with_sections(view, {{{0, 0, 3}, {0, 0, 1}}, {{0, 0, 1}, {0, 0, -2}}, {{0, 0, 2}, {0, 0, 1}}});
  REQUIRE(cut.section);
  CHECK(cut.section->point == Point3{0, 0, 3});
  CHECK(cut.section->normal == Point3{0, 0, -1});
  CHECK(cut.planes.empty());
}

TEST_CASE("the far plane is computed once, and needs a section that faces the viewer", "[section][planes][X11]") {
  const View view = scenes::from_direction({0, 0, 1});
  CHECK(with_depth(with_section(view, {0, 0, 3}, {0, 0, 7}), 2).far->point == Point3{0, 0, 1});
  CHECK_THROWS_AS(with_depth(view, 1), InputError);
  CHECK_THROWS_AS(with_depth(with_sections(view, {{{0, 0, 0}, {1, 0, 0}}}), 1), InputError);
  CHECK_THROWS_AS(with_depth(with_section(view, {0, 0, 3}, {0, 0, 7}), 0), InputError);
}

/// The faces as they come, whole.
std::vector<PaintedPolygon> faces_as_they_come(const CutBoxes& boxes) {
  std::vector<PaintedPolygon> all;
  for (std::size_t f = 0; f < boxes.polygons.size(); ++f) {
    PaintedPolygon& polygon = all.emplace_back();
    polygon.face = static_cast<std::uint32_t>(f);
    for (const std::uint32_t c : boxes.polygons[f]) polygon.corners.push_back(rational(boxes.points[c]));
  }
  return all;
}

/// Of which faces the earlier is painted too early. The witness of each is a point that the planes leave.
std::set<std::array<std::uint32_t, 2>> wrong_faces(const std::vector<PaintedPolygon>& painted, const View& view,
                                                   const KeptBoxesOracle& oracle) {
  std::set<std::array<std::uint32_t, 2>> wrong;
  for (const Violation& v : verify(painted, view, {.limit = 1'000'000}).first) {
    CHECK(oracle.is_kept(v.witness.of_earlier));
    CHECK(oracle.is_kept(v.witness.of_later));
    wrong.insert({*painted[v.earlier].face, *painted[v.later].face});
  }
  return wrong;
}

TEST_CASE("verify judges of whole faces what several planes leave of them", "[section][verify][P22][X9][X10][X11]") {
  std::size_t found = 0;
  on_cut_views(120, [&](const CutBoxes& boxes, const SceneView& scene) {
    // The pieces of an order, cut off at the sides of cells, in the order of their faces; the planes take nothing away from these.
    std::vector<PaintedPolygon> pieces = painted_polygons(scene, depth_sort(scene).order);
    std::stable_sort(pieces.begin(), pieces.end(), [](const auto& a, const auto& b) { return *a.face < *b.face; });
    const KeptBoxesOracle oracle(boxes, scene.view());
    const auto expected = wrong_faces(pieces, boxes.uncut_view, oracle);
    CHECK(wrong_faces(faces_as_they_come(boxes), scene.view(), oracle) == expected);
    found += expected.size();
  });
  CHECK(found > 500);
}

}  // namespace
}  // namespace hsr
