#include "tests/section/cut_boxes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <sstream>

#include "geometry/vector3.h"
#include "tests/scenes/test_scene.h"

namespace hsr {

using namespace internal;

namespace {

struct Box {
  Point3 low, high;
};

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : random_(seed * 7919 + 17) {}
  int between(int low, int high) { return low + static_cast<int>(random_() % static_cast<std::uint64_t>(high - low + 1)); }
  bool chance(int percent) { return between(1, 100) <= percent; }

 private:
  std::mt19937_64 random_;
};

/// Outward.
std::array<std::array<Point3, 4>, 6> faces_of(const Box& b) {
  const auto& [l, h] = b;
  const std::array<Point3, 8> c = {{{l.x, l.y, l.z},
                                    {h.x, l.y, l.z},
                                    {h.x, h.y, l.z},
                                    {l.x, h.y, l.z},
                                    {l.x, l.y, h.z},
                                    {h.x, l.y, h.z},
                                    {h.x, h.y, h.z},
                                    {l.x, h.y, h.z}}};
  return {{{c[3], c[2], c[1], c[0]},
           {c[4], c[5], c[6], c[7]},
           {c[0], c[1], c[5], c[4]},
           {c[1], c[2], c[6], c[5]},
           {c[2], c[3], c[7], c[6]},
           {c[3], c[0], c[4], c[7]}}};
}

Point3 cross(const Point3& a, const Point3& b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }

/// What of a polygon is not in front of the plane; coordinates and cuts are small dyadic numbers, so that nothing is rounded.
std::vector<Point3> left_of(const std::vector<Point3>& ring, const SectionPlane& plane, std::vector<Point3>& in_plane) {
  const auto beyond = [&](const Point3& p) { return dot(minus(p, plane.point), plane.normal); };
  std::vector<Point3> out;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point3 &p = ring[k], &q = ring[(k + 1) % ring.size()];
    const double at_p = beyond(p), at_q = beyond(q);
    if (at_p >= 0) out.push_back(p);
    if (at_p == 0) in_plane.push_back(p);
    if ((at_p < 0) == (at_q < 0) || at_p == 0 || at_q == 0) continue;
    const double t = at_p / (at_p - at_q);
    const Point3 d = minus(q, p), at = sum(p, t, d);
    out.push_back(at);
    in_plane.push_back(at);
  }
  return out;
}

bool has_area(const std::vector<Point3>& ring) {
  for (std::size_t k = 2; k < ring.size(); ++k)
    if (norm_max(cross(minus(ring[1], ring[0]), minus(ring[k], ring[0]))) > 0) return true;
  return false;
}

/// Counter-clockwise as seen from where the plane's normal does not point to.
std::vector<Point3> ring_around(std::vector<Point3> points, const Point3& normal) {
  std::sort(points.begin(), points.end(), [](const Point3& a, const Point3& b) {
    return std::array{a.x, a.y, a.z} < std::array{b.x, b.y, b.z};
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  Point3 middle;
  for (const Point3& p : points) middle = sum(middle, 1.0 / static_cast<double>(points.size()), p);
  const Point3 right = cross(normal, normal.x != 0 || normal.y != 0 ? Point3{0, 0, 1} : Point3{1, 0, 0}),
               up = cross(right, normal);
  const auto angle = [&](const Point3& p) {
    const Point3 d = minus(p, middle);
    return std::atan2(dot(d, up) / norm_max(up), dot(d, right) / norm_max(right));
  };
  std::sort(points.begin(), points.end(), [&](const Point3& a, const Point3& b) { return angle(a) < angle(b); });
  return points;
}

void add_face(std::vector<Point3>& points, Polygons& polygons, const std::vector<Point3>& ring) {
  for (const Point3& p : ring) {
    polygons.corners.push_back(static_cast<std::uint32_t>(points.size()));
    points.push_back(p);
  }
  polygons.first.push_back(static_cast<std::uint32_t>(polygons.corners.size()));
}

View any_view(Dice& d) {
  Point3 toward;
  while (toward == Point3{} || (d.chance(70) && (toward.x == 0 || toward.y == 0)))
    toward = {static_cast<double>(d.between(-3, 3)), static_cast<double>(d.between(-3, 3)),
              static_cast<double>(d.between(-3, 3))};
  if (d.chance(65)) return scenes::from_direction(toward);
  const Point3 eye = {toward.x * 16, toward.y * 16, toward.z * 16};
  return scenes::from_eye(eye, {0, 0, 0});
}

}  // namespace

CutBoxes cut_boxes(std::uint64_t seed) {
  Dice d(seed);
  CutBoxes scene;
  std::ostringstream text;
  std::vector<Box> boxes;
  const int count = d.between(1, 4);
  for (int k = 0; k < count; ++k) {
    Box b;
    double* const low[3] = {&b.low.x, &b.low.y, &b.low.z};
    double* const high[3] = {&b.high.x, &b.high.y, &b.high.z};
    for (int axis = 0; axis < 3; ++axis) {
      *low[axis] = d.between(-3, 2);
      *high[axis] = *low[axis] + d.between(1, 3);
    }
    boxes.push_back(b);
    text << "box " << b.low.x << "," << b.low.y << "," << b.low.z << " " << b.high.x << "," << b.high.y << "," << b.high.z
         << "\n";
  }
  scene.uncut_view = any_view(d);
  // Coefficients that are powers of two cut edges along the axes at dyadic places.
  for (;;) {
    static constexpr std::array<double, 5> some = {0, 1, -1, 2, -0.5};
    const auto any = [&] { return some[static_cast<std::size_t>(d.between(0, 4))]; };
    Point3 normal = {any(), any(), any()};
    if (d.chance(40)) normal = {d.chance(50) ? 1.0 : 0.0, 0, 0};
    if (normal == Point3{0, 0, 0}) normal = {0, 0, 1};
    const double step = d.chance(50) ? 1 : 0.5;
    const Point3 point = {d.between(-3, 3) * step, d.between(-3, 3) * step, d.between(-3, 3) * step};
    try {
      scene.view = with_section(scene.uncut_view, point, normal);
    } catch (const std::exception&) {
      continue;  // seen edge-on
    }
    break;
  }
  const SectionPlane& plane = *scene.view.section;
  text << "plane " << plane.normal.x << "," << plane.normal.y << "," << plane.normal.z << "@" << plane.point.x << ","
       << plane.point.y << "," << plane.point.z << "\n"
       << (scene.view.is_perspective() ? "eye " : "direction ") << scene.view.viewpoint.at.x << "," << scene.view.viewpoint.at.y
       << "," << scene.view.viewpoint.at.z << "\n";
  scene.text = text.str();
  std::vector<std::vector<Point3>> left;
  for (std::uint32_t k = 0; k < boxes.size(); ++k) {
    std::vector<Point3> in_plane;
    bool is_cut = false;
    for (const auto& face : faces_of(boxes[k])) {
      const std::vector<Point3> ring(face.begin(), face.end());
      add_face(scene.points, scene.polygons, ring);
      scene.labels.object.push_back(k);
      for (const Point3& p : ring) is_cut = is_cut || dot(minus(p, plane.point), plane.normal) < 0;
      std::vector<Point3> rest = left_of(ring, plane, in_plane);
      if (rest.size() < 3 || !has_area(rest)) continue;
      left.push_back(rest);
      scene.original.push_back(static_cast<std::uint32_t>(scene.polygons.size() - 1));
    }
    const std::vector<Point3> cap = ring_around(in_plane, plane.normal);
    if (is_cut && cap.size() >= 3 && has_area(cap)) {
      add_face(scene.cut_points, scene.cut_polygons, cap);
      scene.box_of_cap.push_back(k);
    } else if (is_cut && cap.size() == 2) {  // an edge that touches the plane from the front
      const auto n = static_cast<std::uint32_t>(scene.cut_points.size());
      scene.cut_points.push_back(cap[0]);
      scene.cut_points.push_back(cap[1]);
      scene.cut_polygons.segments.push_back({n, n + 1});
    }
  }
  scene.caps = scene.cut_polygons.size();
  for (const auto& ring : left) add_face(scene.cut_points, scene.cut_polygons, ring);
  return scene;
}

}  // namespace hsr
