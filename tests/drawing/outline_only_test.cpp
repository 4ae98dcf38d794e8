// The outline of everything: against the triangles themselves.
#include <algorithm>
#include <catch2/catch.hpp>
#include <random>
#include <set>

#include "hsr/drawing/drawing.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/surfaces/regions.h"
#include "hsr/surfaces/visible_fragments.h"

using namespace hsr;

namespace {

/// Triangles with whole coordinates, seen from the front: x to the right, z up.
struct Soup {
  std::vector<Point3> points;
  std::vector<std::uint32_t> corners, first = {0};

  void add(const Point3& a, const Point3& b, const Point3& c) {
    for (const Point3& p : {a, b, c}) {
      corners.push_back(static_cast<std::uint32_t>(points.size()));
      points.push_back(p);
    }
    first.push_back(static_cast<std::uint32_t>(corners.size()));
  }

  bool covers(double x, double z) const {
    for (std::size_t t = 0; t < corners.size(); t += 3) {
      int left = 0, right = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const Point3 &a = points[t + k], &b = points[t + (k + 1) % 3];
        const double turn = (b.x - a.x) * (z - a.z) - (b.z - a.z) * (x - a.x);
        (turn > 0 ? left : right) += 1;
      }
      if (left == 3 || right == 3) return true;
    }
    return false;
  }

  Drawing outline() const {
    const Mesh mesh = make_mesh(points, corners, first);
    const View view = named_view("front");
    const SceneView scene(mesh, view);
    LineOptions every;
    every.classes.fill(true);
    const VisibleLines lines = visible_lines(scene, every);
    const Regions all =
        regions_of(scene, visible_fragments(scene), std::vector<Colour>(mesh.faces.size(), Colour{}), Merge::colour);
    DrawingOptions options;
    options.in_frame_units = true;
    options.outline_only = true;
    return draw(mesh, view, lines, options, &all);
  }
};

/// Even-odd, at a point of the view's frame.
bool is_inside(const Drawing& d, double x, double z) {
  x *= 1000 * d.scale;
  const double y = -z * 1000 * d.scale;
  bool inside = false;
  for (const Polyline& p : d.polylines) {
    const auto ring = d.points_of(p);
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const PaperPoint &a = ring[k], &b = ring[(k + 1) % ring.size()];
      if ((double(a.y) > y) != (double(b.y) > y) && x < double(a.x) + (y - double(a.y)) / double(b.y - a.y) * double(b.x - a.x))
        inside = !inside;
    }
  }
  return inside;
}

int differences(const Soup& soup, const Drawing& d, int size) {
  int wrong = 0;
  for (int i = -1; i <= size; ++i)
    for (int k = -1; k <= size; ++k) {
      const double x = i + 0.3719, z = k + 0.4127;
      if (soup.covers(x, z) != is_inside(d, x, z)) ++wrong;
    }
  return wrong;
}

}  // namespace

TEST_CASE("Only the outline of everything is closed rings around the union of all faces", "[drawing][outline_only][D19]") {
  std::mt19937 random(7);
  for (int scene = 0; scene < 30; ++scene) {
    const int size = 40;
    Soup soup;
    const auto at = [&] { return static_cast<double>(random() % size); };
    for (int t = 0; t < 3 + scene; ++t) soup.add({at(), at(), at()}, {at(), at(), at()}, {at(), at(), at()});
    const Drawing d = soup.outline();
    CAPTURE(scene);
    CHECK(differences(soup, d, size) == 0);
    CHECK(d.fills.fills.empty());
    for (const Polyline& p : d.polylines) {
      CHECK(p.closed);
      CHECK(p.edge_class == EdgeClass::outline);
      CHECK_FALSE(p.hidden);
      const auto ring = d.points_of(p);
      CHECK(std::set<PaperPoint>(ring.begin(), ring.end()).size() == ring.size());
    }
    Drawing lost = d;  // the test finds a ring that is missing
    const auto most = [](const Polyline& p, const Polyline& q) {
      return p.end_point - p.first_point < q.end_point - q.first_point;
    };
    lost.polylines.erase(std::ranges::max_element(lost.polylines, most));
    CHECK(differences(soup, lost, size) > 0);
  }
}

TEST_CASE("Holes of the outline are rings, and what is in one behind another face is gone", "[drawing][outline_only][D19]") {
  Soup frame;  // a square with a hole, of eight triangles, and one behind its side
  const Point3 outer[] = {{0, 0, 0}, {10, 0, 0}, {10, 0, 10}, {0, 0, 10}};
  const Point3 inner[] = {{3, 0, 3}, {7, 0, 3}, {7, 0, 7}, {3, 0, 7}};
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t n = (k + 1) % 4;
    frame.add(outer[k], outer[n], inner[k]);
    frame.add(inner[k], outer[n], inner[n]);
  }
  CHECK(frame.outline().polylines.size() == 2);
  CHECK(frame.outline().points.size() == 8);
  frame.add({1, 5, 1}, {2, 5, 1}, {1, 5, 2});
  CHECK(frame.outline().points.size() == 8);
  frame.add({1, 5, 1}, {5, 5, 5}, {1, 5, 2});  // its tip is seen in the hole, from a corner on
  CHECK(frame.outline().points.size() == 10);
  frame.add({20, 0, 0}, {30, 0, 0}, {20, 0, 10});
  CHECK(frame.outline().polylines.size() == 3);
}
