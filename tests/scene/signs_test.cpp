#include <array>
#include <catch2/catch.hpp>
#include <cstdint>
#include <span>
#include <vector>

#include "hsr/lines/invisibility_count.h"
#include "hsr/lines/invisibility_events.h"
#include "hsr/painter/bsp/bsp.h"
#include "hsr/painter/sort/depth_sort.h"
#include "hsr/painter/verify/painted_parts.h"
#include "hsr/raster/facing_culling.h"
#include "hsr/raster/sample_signs.h"
#include "hsr/scene/closed_bodies.h"
#include "hsr/scene/half_space.h"
#include "hsr/scene/line_filter.h"
#include "hsr/scene/occluding_edges.h"
#include "hsr/scene/triangle_filter.h"
#include "hsr/scene/view_parts.h"
#include "hsr/surfaces/line_envelope.h"
#include "hsr/surfaces/visible_fragments.h"
#include "hsr/visibility_map/convex_piece.h"
#include "hsr/visibility_map/map_predicates.h"
#include "tests/scenes/test_scene.h"

// docs/architecture.md, "Signs", on the triangle (0,0,0), (1,0,0), (0,1,0). Seen from above (from where z is positive) its
// corners run counter-clockwise, its apex is to the left of each side, and all signs are positive; seen from below they are
// negative. Nothing here asks one function what another one says: what is right is read off the side that the viewer is on.

namespace hsr {

using namespace internal;

namespace {

using scenes::TestScene;

const std::array<Point3, 3> unit_corners = {Point3{0, 0, 0}, Point3{1, 0, 0}, Point3{0, 1, 0}};
constexpr TriangleId only{0};

struct SignedView {
  View view;
  Sign facing;  // of the unit triangle
};

/// From above and from below, along each axis in turn more than along the others.
std::vector<SignedView> views() {
  std::vector<SignedView> all;
  for (const double side : {1.0, -1.0}) {
    const Sign facing = side > 0 ? Sign::positive : Sign::negative;
    for (const Point3& d : {Point3{0, 0, 1}, Point3{1, 2, 4}, Point3{5, 1, 2}, Point3{-5, 2, 1}, Point3{1, 5, 2},
                            Point3{2, -5, 3}, Point3{-1, -2, 3}}) {
      all.push_back({scenes::from_direction({d.x, d.y, side * d.z}), facing});
      all.push_back({scenes::from_eye({2 * d.x, 2 * d.y, side * 2 * d.z}, {0.25, 0.25, 0}), facing});
    }
  }
  return all;
}

TestScene unit_triangle(const View& view) {
  TestScene scene;
  scene.view = view;
  scene.add_face(std::vector<Point3>{unit_corners[0], unit_corners[1], unit_corners[2]});
  return scene;
}

/// A point on the line of sight of p, nearer to the viewer, or farther away.
Point3 toward_viewer(const View& view, const Point3& p, double by) {
  const Point3& e = view.viewpoint.at;
  if (!view.is_perspective()) return {p.x + by * e.x, p.y + by * e.y, p.z + by * e.z};
  return {p.x + by * (e.x - p.x), p.y + by * (e.y - p.y), p.z + by * (e.z - p.z)};
}

void note(const SignedView& v) {
  const Point3& e = v.view.viewpoint.at;
  UNSCOPED_INFO((v.view.is_perspective() ? "from the eye " : "in the direction ") << e.x << " " << e.y << " " << e.z);
}

Sign turn(const std::array<Rational, 2>& a, const std::array<Rational, 2>& b, const std::array<Rational, 2>& c) {
  return ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).sign();
}

}  // namespace

TEST_CASE("seen from above, the image on the paper turns counter-clockwise", "[scene][signs]") {
  for (const SignedView& v : views()) {
    note(v);
    const auto at = [&](std::size_t k) {
      return image(v.view, {Rational(unit_corners[k].x), Rational(unit_corners[k].y), Rational(unit_corners[k].z)});
    };
    CHECK(turn(at(0), at(1), at(2)) == v.facing);
  }
}

TEST_CASE("predicates are positive to the left as seen", "[scene][signs]") {
  for (const SignedView& v : views()) {
    note(v);
    const Viewpoint& e = v.view.viewpoint;
    const Camera camera{e, v.view.target};
    const Point3 &a = unit_corners[0], &b = unit_corners[1], &c = unit_corners[2];
    BitRange points, direction;
    for (const Point3& p : {a, b, c, v.view.target, Point3{3, 5, 7}}) points.add(p);
    (e.is_direction ? direction : points).add(e.at);
    Predicates exact(points, direction);
    const Plane ab = Plane::of_sight(e, a, b), bc = Plane::of_sight(e, b, c), ca = Plane::of_sight(e, c, a);
    CHECK(exact.side(ab, c) == v.facing);
    CHECK(exact.side(Plane::of_sight(e, b, a), c) == -v.facing);
    CHECK(exact.side(camera, ViewPlane::of(ab), c) == v.facing);
    // Around a triangle that is seen counter-clockwise each side turns left against the one before.
    CHECK(exact.turn(camera, ViewPlane::of(ab), ViewPlane::of(bc)) == v.facing);
    CHECK(exact.turn(camera, ViewPlane::of(bc), ViewPlane::of(ca)) == v.facing);
    CHECK(exact.turn(camera, ViewPlane::of(ca), ViewPlane::of(bc)) == -v.facing);
    CHECK(exact.side(camera, ViewPlane::of(ab), ViewPlane::of(bc), ViewPlane::of(ca)) == v.facing);
    // The viewpoint is on the positive side of the triangle's plane.
    if (!e.is_direction) CHECK(exact.side(Plane::of_face(a, b, c), e.at) == v.facing);
    // A plane that leans on ab toward the viewer is nearer than the triangle's on the side of c. Both are positive at the
    // viewpoint, or both are negative.
    const Plane leaning = Plane::of_face(a, b, {0, 1, v.facing == Sign::positive ? 0x1p-6 : -0x1p-6});
    CHECK(exact.side(camera, ViewPlane::of_meet(leaning, Plane::of_face(a, b, c)), c) == Sign::positive);
  }
}

TEST_CASE("a projected triangle is positive seen counter-clockwise, and left of its edges", "[scene][signs]") {
  for (const SignedView& v : views()) {
    note(v);
    const Mesh mesh = unit_triangle(v.view).mesh();
    const ProjectedMesh projected(mesh, v.view, Arithmetic::staged);
    Predicates exact = projected.predicates();
    CHECK(projected.facing(only) == v.facing);
    const VertexId a(0), b(1), c(2);
    CHECK(projected.side_of_edge(only, mesh.edges[mesh.find_edge(a, b)]) == v.facing);
    CHECK(projected.side_of_edge(only, mesh.edges[mesh.find_edge(b, c)]) == v.facing);
    CHECK(projected.side_of_edge(only, mesh.edges[mesh.find_edge(a, c)]) == -v.facing);
    CHECK(projected.side(projected.sight_plane(a, b), c, exact) == v.facing);
    REQUIRE(projected.image_error() < 0x1p-30);
    const SegmentFilter segment(projected.image(a), projected.image(b), projected.image_error());
    CHECK(sign_of(segment.turn(projected.image(c)).value) == v.facing);
    CHECK(sign_of(segment.turn(projected.image(projected.point(c), 0).p).value) == v.facing);
    const LineFilter line(projected, a, b);
    CHECK(line.certain_side(c) == v.facing);
    CHECK(line.side_by_doubles(c) == v.facing);
    CHECK(line.side(c, exact) == v.facing);
    const ProjectedMesh by_rationals(mesh, v.view, Arithmetic::rational);
    CHECK(by_rationals.facing(only) == v.facing);
    for (const FacingSpace space : {FacingSpace::world, FacingSpace::eye, FacingSpace::projection})
      CHECK(facing(mesh, v.view, only, space) == v.facing);
    for (const HalfSpace& h : half_spaces(projected, only, exact))
      CHECK(h.inner == (VertexId(h.cut.u) == a && VertexId(h.cut.v) == c ? -v.facing : v.facing));
    const TriangleFilter face(projected, only);
    CHECK(face.facing == static_cast<int>(v.facing));
    const ImagePoint &p = projected.image(a), &q = projected.image(b), &r = projected.image(c);
    const ImagePoint middle = {(p.x + q.x + r.x) / 3, (p.y + q.y + r.y) / 3};
    CHECK(face.overlap(SegmentFilter(middle, {(middle.x + p.x) / 2, (middle.y + p.y) / 2}, 0x1p-30)).is_within == 7);
    // The plane is positive at the viewpoint seen from above: -1 / plane(E).
    CHECK(sign_of(face.per_eye.value) == -v.facing);
  }
}

TEST_CASE("nearness grows toward the viewer, and the near plane is positive beyond it", "[scene][signs]") {
  for (const SignedView& v : views()) {
    note(v);
    const Point3 p = {0.25, 0.25, 0}, nearer = toward_viewer(v.view, p, 0.125), farther = toward_viewer(v.view, p, -0.125);
    TestScene scene = unit_triangle(v.view);
    scene.add_face(std::vector<Point3>{nearer, farther, {0.5, 0.25, 0}});
    const Mesh mesh = scene.mesh();
    const ProjectedMesh projected(mesh, v.view, Arithmetic::staged);
    const auto at = [&](std::uint32_t k) { return projected.nearness(projected.point(VertexId(k)), 0); };
    const ErrorBounded gap = at(3) - at(4);
    CHECK(gap.is_certain());
    CHECK(gap.value > 0);
    CHECK(projected.box(VertexId(3)).farthest > projected.box(VertexId(4)).nearest);
    // As boxes have it.
    for (std::uint32_t k = 0; k < 6; ++k) {
      CHECK(projected.box(VertexId(k)).farthest <= at(k).value);
      CHECK(projected.box(VertexId(k)).nearest >= at(k).value);
    }
    CHECK(projected.beyond_near(VertexId(3)) == Sign::positive);
    if (!v.view.is_perspective()) continue;
    const View cut = scenes::from_eye(v.view.viewpoint.at, v.view.target, 1);  // the near plane through the target
    const ProjectedMesh half(mesh, cut, Arithmetic::staged);
    CHECK(half.beyond_near(VertexId(3)) == Sign::negative);
    CHECK(half.beyond_near(VertexId(4)) == Sign::positive);
  }
}

TEST_CASE("a triangle is to the left of what runs along its side", "[scene][signs]") {
  for (const SignedView& v : views()) {
    note(v);
    // Behind the side from the first corner to the second an edge runs along it, and another one ends behind the first corner.
    TestScene scene = unit_triangle(v.view);
    const auto behind = [&](double x) { return toward_viewer(v.view, {x, 0, 0}, -0.0625); };
    scene.points.insert(scene.points.end(), {behind(0.25), behind(0.75), behind(-1), behind(0.5)});
    scene.polygons.segments = {{3, 4}, {5, 6}};
    const Mesh mesh = scene.mesh();
    const SceneView seen(mesh, v.view);
    const ProjectedMesh& projected = seen.parts().projected();
    const Occluders& occluders = seen.parts().occluders(Excluded::none);
    const std::vector<std::uint8_t> none_left_out;
    const OccludingEdges layers(projected, none_left_out);
    REQUIRE(layers.edges().size() == 3);
    for (const OccludingEdge& e : layers.edges()) {
      const bool runs_against = mesh.edges[e.edge].b == VertexId(2) && mesh.edges[e.edge].a == VertexId(0);
      CHECK(e.weight == (runs_against ? -1 : 1) * static_cast<int>(v.facing));
    }
    if (v.view.is_perspective()) continue;  // scaled points are rounded: the edge is not exactly behind the side
    const bool is_left = v.facing == Sign::positive;
    InvisibilityCount count(projected, layers);
    CHECK(count.before(VertexId(3), VertexId(4), Sign::positive, occluders) == (is_left ? 1 : 0));
    CHECK(count.before(VertexId(3), VertexId(4), Sign::negative, occluders) == (is_left ? 0 : 1));
    InvisibilityEvents events(projected, layers, occluders);
    const EdgeId e = mesh.find_edge(VertexId(5), VertexId(6));
    const ImageBox box = projected.box(VertexId(5), VertexId(6));
    events.turn_to(std::span(&box, 1));
    std::vector<InvisibilityChange> changes;
    const EdgeWalk walk = events.find(e, box, changes);
    CHECK(walk.left == (is_left ? 1 : 0));
    CHECK(walk.right == (is_left ? 0 : 1));
  }
}

TEST_CASE("the visibility map is positive to the left, and its rings turn as they are seen", "[scene][signs]") {
  for (const SignedView& v : views()) {
    note(v);
    TestScene scene = unit_triangle(v.view);
    const bool from_above = v.facing == Sign::positive;
    // Nearer wherever y is above -1.
    scene.add_face(std::vector<Point3>{{0, -1, 0}, {2, -1, 0}, {0, 2, from_above ? 0x1p-6 : -0x1p-6}});
    const Mesh mesh = scene.mesh();
    const ProjectedMesh projected(mesh, v.view, Arithmetic::staged);
    MapPredicates map(projected);
    const VertexId a(0), b(1), c(2);
    const MapLine ab = MapLine::edge(a, b), bc = MapLine::edge(b, c), ac = MapLine::edge(a, c);
    CHECK(map.side(ab, c) == v.facing);
    CHECK(map.side(ac, b) == -v.facing);
    CHECK(map.side(ab, MapPoint::crossing(bc, ac)) == v.facing);
    CHECK(map.turn(ab, bc) == v.facing);
    CHECK(map.order(ab, MapPoint::of_vertex(a), MapPoint::of_vertex(b)) == Sign::negative);
    const TriangleId leaning(1);
    CHECK(map.nearer(leaning, only, MapPoint::of_vertex(c)) == Sign::positive);
    CHECK(map.nearer(only, leaning, MapPoint::of_vertex(c)) == Sign::negative);
    const auto exact_place = [&](VertexId x) { return map.exact_place(MapPoint::of_vertex(x)); };
    CHECK(turn(exact_place(a), exact_place(b), exact_place(c)) == v.facing);
    const auto place = [&](VertexId x) { return map.place(MapPoint::of_vertex(x)); };
    const MapPlace p = place(a), q = place(b), r = place(c);
    CHECK(sign_of((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x)) == v.facing);
    for (std::size_t k = 0; k < 3; ++k) CHECK(side_of_triangle(projected, only, k).inner == (k == 2 ? -v.facing : v.facing));
    const ConvexPiece piece = convex_piece(projected, only);
    for (std::size_t k = 0; k < 3; ++k) CHECK(map.side(piece.lines[k].line, piece.points[(k + 2) % 3]) == piece.lines[k].inner);
    const auto corner = [&](std::size_t k) { return map.exact_place(piece.points[k]); };
    CHECK(turn(corner(0), corner(1), corner(2)) == Sign::positive);
  }
}

TEST_CASE("fragments, pieces and what is seen beside a line lie on the side that is said", "[scene][signs]") {
  for (const SignedView& v : views()) {
    note(v);
    const Mesh mesh = unit_triangle(v.view).mesh();
    const SceneView scene(mesh, v.view);
    const ProjectedMesh& projected = scene.parts().projected();
    MapPredicates map(projected);
    const VertexId a(0), b(1);
    MapStretch stretch;
    stretch.line = MapLine::edge(a, b);
    stretch.from = MapPoint::of_vertex(a);
    stretch.to = MapPoint::of_vertex(b);
    stretch.a = {projected.point(a), 0};
    stretch.b = {projected.point(b), 0};
    stretch.at_a = a;
    stretch.at_b = b;
    LineEnvelope envelope(map, scene.parts().occluders(Excluded::none), nullptr);
    CHECK(envelope.find(stretch, v.facing).front().seen == only);
    CHECK_FALSE(envelope.find(stretch, -v.facing).front().seen.is_valid());

    const auto is_counter_clockwise = [&](const auto& vertex) {
      const auto at = [&](std::size_t k) {
        const Point3& p = mesh.points[vertex(k)];
        return image(v.view, {Rational(p.x), Rational(p.y), Rational(p.z)});
      };
      return turn(at(0), at(1), at(2)) == Sign::positive;
    };
    const VisibleFragments fragments = visible_fragments(scene);
    REQUIRE(fragments.rings.size() == 1);
    CHECK(is_counter_clockwise([&](std::size_t k) { return fragments.rings[0][k].at.vertex; }));
    for (const PaintersOrder& order : {BspTree(mesh).order(scene), depth_sort(scene).order}) {
      REQUIRE(order.pieces.size() == 1);
      CHECK(is_counter_clockwise([&](std::size_t k) { return order.corners[k].vertex; }));
    }
  }
}

TEST_CASE("what verifies painted polygons turns as they are seen", "[scene][signs]") {
  for (const SignedView& v : views()) {
    note(v);
    // Corners in doubles are asked of the predicates, others of rationals.
    for (const bool is_double : {true, false}) {
      const Rational scale = is_double ? Rational(1.0) : Rational(1.0) / Rational(3.0);
      std::vector<PaintedPolygon> all(2);  // the second is nearer
      for (const Point3& p : unit_corners) {
        const Point3 q = toward_viewer(v.view, p, 0.0625);
        all[0].corners.push_back({scale * Rational(p.x), scale * Rational(p.y), scale * Rational(p.z)});
        all[1].corners.push_back({Rational(q.x), Rational(q.y), Rational(q.z)});
      }
      PaintedPoints points(all);
      const ImageRows rows(v.view);
      PaintedSides in_space(points, rows, v.view);
      const auto c = points.corners_of(0);
      CHECK(in_space.turn(c[0], c[1], c[2]) == v.facing);
      points.place(rows);
      CHECK(PaintedSides(points, rows, v.view).turn(c[0], c[1], c[2]) == v.facing);

      const PaintedParts parts(all, v.view);
      REQUIRE(parts.parts().size() == 2);
      PaintedSides sides(parts.points(), parts.rows(), v.view);
      const PaintedPart &farther = parts.parts()[0], &nearest = parts.parts()[1];
      CHECK(before_plane(sides, farther, parts.corners_of(nearest)[0]) == Sign::positive);
      CHECK(before_plane(sides, nearest, parts.corners_of(farther)[0]) == Sign::negative);
      const auto found = nearer(parts, sides, farther, nearest);
      CHECK((found && !found->first && found->second));
    }
  }
}

TEST_CASE("a body's face is on its near side where the viewer is on the outer side of the face", "[scene][signs]") {
  for (const SignedView& v : views()) {
    note(v);
    TestScene scene = unit_triangle(v.view);  // with the body below it
    scene.points.push_back({0.25, 0.25, -1});
    for (const std::vector<std::uint32_t>& face : {std::vector<std::uint32_t>{1, 0, 3}, {2, 1, 3}, {0, 2, 3}})
      scene.add_face(face);
    const Mesh mesh = scene.mesh();
    const ProjectedMesh projected(mesh, v.view, Arithmetic::staged);
    const StarShapedBodies star_shaped{ScaledMesh(projected.mesh())};
    const ClosedBodies bodies(projected, star_shaped);
    REQUIRE(bodies.count() == 1);
    CHECK(bodies.is_on_near_side(only) == (v.facing == Sign::positive));
  }
}

TEST_CASE("a row of samples is positive below it, whichever way the samples turn", "[scene][signs]") {
  for (const SignedView& v : views())
    for (const double right : {0.125, -0.125}) {
      note(v);
      const Mesh mesh = unit_triangle(v.view).mesh();
      const SampleGrid grid{{0, 1, 0}, {right, 0, 0}, {0, -0.125, 0}, 8, 8};
      const SceneView scene(mesh, v.view);
      const ProjectedMesh& projected = scene.parts().with(grid.bit_range()).projected();
      const SampleSigns signs(projected, grid);
      Predicates exact = projected.predicates();
      CHECK(exact.side(signs.row_plane(3), signs.at(0, 4)) == Sign::positive);
      CHECK(exact.side(signs.row_plane(3), signs.at(0, 2)) == Sign::negative);
      CHECK(signs.is_in_front(VertexId(0), exact));
      if (v.view.is_perspective()) CHECK(signs.is_in_front({Rational(0.0), Rational(0.0), Rational(0.0)}));
    }
}

}  // namespace hsr
