// What a section takes away, as a plan shows it.
#include "hsr/lines/overhead.h"

#include <catch2/catch.hpp>
#include <set>
#include <string>

#include "geometry/error.h"
#include "tests/scenes/test_scene.h"
#include "tests/section/cut_boxes.h"
#include "tests/section/kept_boxes_oracle.h"

namespace hsr {
namespace {

using namespace internal;

bool is_overhead(const Line& line) { return line.edge_class == EdgeClass::overhead; }

TEST_CASE("a plan shows from below what is above it, as far as nothing hides it there", "[section][overhead][X13]") {
  scenes::TestScene scene;
  scene.add_box({0, 0, 0}, {1, 1, 3});        // a post, which is cut
  scene.add_box({-1, -1, 3}, {4, 4, 3.5});    // the roof over it
  scene.add_box({2, 2, 2.5}, {2.5, 2.5, 3});  // a lamp below the roof
  scene.add_box({1, 1, 3.5}, {1.5, 1.5, 5});  // a chimney, which the roof hides
  scene.add_box({2, 0, 0}, {3, 1, 1});        // a seat, which is left
  const Mesh mesh = scene.mesh();
  const SceneView plan(mesh, with_section(scenes::from_direction({0, 0, 1}), {0, 0, 1.5}, {0, 0, 1}));
  const VisibleLines own = visible_lines(plan), lines = with_overhead(plan, {}, own);
  std::set<double> heights;
  int overhead = 0;
  for (const Line& line : lines.lines) {
    if (!is_overhead(line)) continue;
    ++overhead;
    CHECK(line.intervals() == 1);
    CHECK_FALSE(line.hidden(0));
    const Edge& e = mesh.edges[line.edge];
    CHECK(lines.cuts_of(line)[0].kind == Cut::Kind::start);
    CHECK(lines.cuts_of(line)[1].kind == Cut::Kind::end);
    CHECK(mesh.points[e.a].z == mesh.points[e.b].z);
    heights.insert(mesh.points[e.a].z);
  }
  CHECK(overhead == 8);
  CHECK(heights == std::set<double>{2.5, 3});
  CHECK(lines.lines.size() == own.lines.size() + 8);
  CHECK(std::is_sorted(lines.lines.begin(), lines.lines.end(), [](const Line& x, const Line& y) { return x.edge < y.edge; }));
}

TEST_CASE("what lies in the plane of a section is not overhead", "[section][overhead][X13]") {
  scenes::TestScene scene;
  scene.add_box({0, 0, 0}, {1, 1, 2});
  scene.add_box({3, 0, 2}, {4, 1, 3});
  const Mesh mesh = scene.mesh();
  const SceneView plan(mesh, with_section(scenes::from_direction({0, 0, 1}), {0, 0, 2}, {0, 0, 1}));
  for (const Line& line : with_overhead(plan, {}, {}).lines) CHECK_FALSE(is_overhead(line));
}

TEST_CASE("lines overhead need a section that faces the viewer, in a parallel view", "[section][overhead][X13]") {
  scenes::TestScene scene;
  scene.add_box({0, 0, 0}, {1, 1, 2});
  const Mesh mesh = scene.mesh();
  const View top = scenes::from_direction({0, 0, 1});
  CHECK_THROWS_AS(with_overhead(SceneView(mesh, top), {}, {}), InputError);
  CHECK_THROWS_AS(with_overhead(SceneView(mesh, with_sections(top, {{{0.5, 0, 0}, {1, 0, 0}}})), {}, {}), InputError);
  const View eye = scenes::from_eye({3, 4, 9}, {0, 0, 0});
  CHECK_THROWS_AS(with_overhead(SceneView(mesh, with_section(eye, {0, 0, 1}, {0, 0, 1})), {}, {}), InputError);
}

TEST_CASE("lines overhead are those that are seen from the cut point by point", "[section][overhead][random][X13]") {
  int parts = 0, whole = 0;
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    const CutBoxes boxes = cut_boxes(seed);
    if (boxes.view.is_perspective()) continue;
    std::vector<SectionPlane> planes = {*boxes.view.section};
    if (seed % 3 == 0) planes.push_back({boxes.points[seed % boxes.points.size()], {1, static_cast<double>(seed % 5) - 2, 1}});
    INFO("seed " << seed << "\n" << boxes.text);
    const SceneView scene(Scene(make_mesh(boxes.points, boxes.polygons), boxes.labels),
                          with_sections(boxes.uncut_view, planes));
    const KeptBoxesOracle oracle(boxes, scene.view());
    const VisibleLines lines = with_overhead(scene, {}, {});
    const auto at = [](const RationalVector& p, const RationalVector& q, const Rational& t) {
      RationalVector x;
      for (std::size_t axis = 0; axis < 3; ++axis) x[axis] = p[axis] + t * (q[axis] - p[axis]);
      return x;
    };
    std::vector<std::vector<std::array<Rational, 2>>> of_edge(scene.mesh().edges.size());
    for (const Line& line : lines.lines) {
      const auto p = exact_point(scene, lines, line, 0), q = exact_point(scene, lines, line, 1);
      for (const double t : {0.02, 0.43, 0.98}) {
        CHECK(oracle.is_seen_from_cut(at(p, q, t)));
        ++parts;
      }
      if (line.is_intersection()) continue;
      const SupportingLine support = supporting_line_of(scene.mesh(), lines, line);
      const auto cuts = lines.cuts_of(line);
      of_edge[line.edge.value].push_back({exact_parameter(scene.mesh(), scene.view(), support, cuts[0]),
                                          exact_parameter(scene.mesh(), scene.view(), support, cuts[1])});
    }
    if (boxes.points.size() > 24) continue;  // edges where boxes touch may be of classes that have no line
    for (std::uint32_t i = 0; i < scene.mesh().edges.size(); ++i) {
      const Edge& edge = scene.mesh().edges[EdgeId(i)];
      const RationalVector a = rational(scene.mesh().points[edge.a]), b = rational(scene.mesh().points[edge.b]);
      const RationalVector c = cross(rational(scene.view().viewpoint.at), minus(b, a));
      if (c[0].sign() == Sign::zero && c[1].sign() == Sign::zero && c[2].sign() == Sign::zero) continue;
      const std::vector<Rational> changes = oracle.changes(a, b);
      for (std::size_t k = 0; k + 1 < changes.size(); ++k) {
        const Rational t = (changes[k] + changes[k + 1]) * Rational(0.5);
        bool is_drawn = false;
        for (const auto& [from, to] : of_edge[i]) is_drawn = is_drawn || (from < t && t < to);
        CHECK(is_drawn == oracle.is_seen_from_cut(at(a, b, t)));
        ++whole;
      }
    }
  }
  CHECK(parts > 500);
  CHECK(whole > 200);
}

}  // namespace
}  // namespace hsr
