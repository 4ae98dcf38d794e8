#include "tests/scenes/random_scenes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>

#include "geometry/error.h"
#include "geometry/vector3.h"

namespace hsr::scenes {

using namespace internal;

namespace {

// std::uniform_int_distribution may differ between libraries; this does not. No two throws in the arguments of one call:
// compilers differ in their order.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  int between(int low, int high) { return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1)); }
  bool chance(int percent) { return between(0, 99) < percent; }
  Point3 point(int r) {
    const double x = between(-r, r), y = between(-r, r), z = between(-r, r);
    return {x, y, z};
  }
  template <class T>
  const T& pick(const std::vector<T>& from) {
    return from[static_cast<std::size_t>(between(0, static_cast<int>(from.size()) - 1))];
  }

 private:
  std::mt19937_64 engine_;
};

Point3 combined(const Point3& o, double i, const Point3& u, double j, const Point3& v) {
  return {o.x + i * u.x + j * v.x, o.y + i * u.y + j * v.y, o.z + i * u.z + j * v.z};
}

bool is_zero(const Point3& p) { return p == Point3{0, 0, 0}; }

Point3 any_direction(Dice& d) {
  static const std::vector<Point3> some = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}, {1, 1, 1},
                                           {1, -1, 1}, {0, 1, 2},  {1, 0, 1}, {-1, 2, 0}, {3, 1, 2}, {0, 1, -1}, {1, 1, 0}};
  if (d.chance(70)) return d.pick(some);
  Point3 p;
  while (is_zero(p)) p = d.point(3);
  return p;
}

double any_near(Dice& d) {
  static const std::vector<double> some = {0.001, 0.001, 0.001, 0.5, 0.25, 1, 0.125, 0.1, 1e-9, 2};
  return d.pick(some);
}

// One face's corners, if there is a face.
std::optional<std::array<Point3, 3>> some_corners(Dice& d, const TestScene& scene) {
  if (scene.polygons.size() == 0) return {};
  const auto f = scene.polygons[static_cast<std::size_t>(d.between(0, static_cast<int>(scene.polygons.size()) - 1))];
  return std::array<Point3, 3>{scene.points[f[0]], scene.points[f[1]], scene.points[f[2]]};
}

// An eye outside, inside, or on something: a vertex, an edge, a face, a face's plane. All of these are exact in doubles.
Point3 any_eye(Dice& d, const TestScene& scene, bool outside) {
  const auto corners = some_corners(d, scene);
  if (outside || !corners) {
    Point3 e = d.point(8);
    (d.chance(33) ? e.x : d.chance(50) ? e.y : e.z) = d.chance(50) ? 7 : -7;
    return e;
  }
  const auto& [a, b, c] = *corners;
  const Point3 u = minus(b, a), v = minus(c, a);
  switch (d.between(0, 5)) {
    case 0:
      return a;
    case 1:
      return combined(a, 0.5, u, 0, v);
    case 2:
      return combined(a, 0.25, u, 0.5, v);
    case 3: {
      const double i = d.between(-2, 2), j = d.between(-2, 2);
      return combined(a, i, u, j, v);
    }
    default:
      return d.point(3);
  }
}

View any_perspective(Dice& d, const TestScene& scene, bool outside) {
  const Point3 eye = any_eye(d, scene, outside);
  Point3 target = eye;
  while (target == eye) target = d.chance(60) ? d.point(2) : d.pick(scene.points);
  return from_eye(eye, target, any_near(d));
}

View any_view(Dice& d, const TestScene& scene) {
  return d.chance(60) ? from_direction(any_direction(d)) : any_perspective(d, scene, d.chance(70));
}

// Wires, a duplicate or flipped face, a face of no area.
void add_trouble(Dice& d, TestScene& scene) {
  const auto any_vertex = [&] { return static_cast<std::uint32_t>(d.between(0, static_cast<int>(scene.points.size()) - 1)); };
  if (d.chance(25)) {
    for (int n = d.between(1, 2); n > 0; --n) {
      const std::uint32_t a = any_vertex(), b = any_vertex();
      if (!(scene.points[a] == scene.points[b])) scene.polygons.segments.push_back({a, b});
    }
  }
  if (scene.polygons.size() > 0 && d.chance(15)) {
    const auto f = scene.polygons[static_cast<std::size_t>(d.between(0, static_cast<int>(scene.polygons.size()) - 1))];
    std::vector<std::uint32_t> again(f.begin(), f.end());
    if (d.chance(50)) std::reverse(again.begin(), again.end());
    scene.add_face(again);
  }
  if (d.chance(8)) {
    const std::uint32_t a = any_vertex(), b = any_vertex();
    scene.add_face({a, b, a});
  }
}

void add_triangles(Dice& d, TestScene& scene, int n, int r) {
  for (int i = 0; i < n; ++i) {
    std::vector<std::uint32_t> corners;
    for (int k = 0; k < 3; ++k) {
      if (!scene.points.empty() && d.chance(35)) {
        corners.push_back(static_cast<std::uint32_t>(d.between(0, static_cast<int>(scene.points.size()) - 1)));
      } else {
        corners.push_back(static_cast<std::uint32_t>(scene.points.size()));
        scene.points.push_back(d.point(r));
      }
    }
    scene.add_face(corners);
  }
}

using Shape = std::vector<std::array<int, 2>>;

const Shape& any_shape(Dice& d) {
  static const std::vector<Shape> shapes = {
      {{0, 0}, {2, 0}, {3, 2}, {0, 1}},                                                  // convex
      {{0, 0}, {2, 0}, {2, 2}, {0, 2}},                                                  // square
      {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}},                                  // L
      {{0, 0}, {3, 1}, {0, 2}, {1, 1}},                                                  // dart
      {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}},  // keyhole
      {{0, 0}, {2, 2}, {2, 0}, {0, 2}},                                                  // bow-tie
      {{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}},                                          // a corner of 180 degrees
      {{0, 0}, {1, 1}, {2, 0}, {2, 2}, {1, 1}, {0, 2}},                                  // pinched at a vertex
      {{0, 0}, {3, 0}, {1, 0}, {1, 2}},                                                  // a spike
  };
  return d.pick(shapes);
}

void add_shape(TestScene& scene, const Shape& shape, const Point3& o, const Point3& u, const Point3& v) {
  std::vector<Point3> corners;
  for (const auto& [i, j] : shape) corners.push_back(combined(o, i, u, j, v));
  scene.add_face(corners);
}

TestScene triangles(std::uint64_t seed) {
  Dice d(seed);
  TestScene scene;
  add_triangles(d, scene, d.between(1, 6), d.between(1, 4));
  add_trouble(d, scene);
  scene.view = any_view(d, scene);
  return scene;
}

TestScene polygons(std::uint64_t seed) {
  Dice d(seed);
  TestScene scene;
  for (int n = d.between(1, 3); n > 0; --n) {
    const Point3 o = d.point(3), u = d.point(1), v = d.point(1);
    if (d.chance(30)) {
      scene.add_face({o, d.point(3), d.point(3), d.point(3)});
    } else {
      add_shape(scene, any_shape(d), o, u, v);
      if (d.chance(15)) scene.points.back().z += 1;
    }
  }
  if (d.chance(50)) add_triangles(d, scene, 1, 3);
  add_trouble(d, scene);
  scene.view = any_view(d, scene);
  return scene;
}

TestScene edge_on(std::uint64_t seed) {
  Dice d(seed);
  TestScene scene;
  const bool parallel = d.chance(50);
  const Point3 eye = d.point(5), toward = any_direction(d);
  for (int planes = d.between(1, 2); planes > 0; --planes) {
    const Point3 o = parallel ? d.point(2) : eye;
    const Point3 u = parallel ? toward : d.point(2), v = d.point(2);
    for (int n = d.between(1, 4); n > 0; --n) {
      if (d.chance(25)) {
        const double i = d.between(-3, 3), j = d.between(-3, 3);
        add_shape(scene, any_shape(d), combined(o, i, u, j, v), u, v);
        continue;
      }
      std::vector<Point3> corners;
      for (int k = 0; k < 3; ++k) {
        const double i = d.between(-3, 3), j = d.between(-3, 3);
        corners.push_back(combined(o, i, u, j, v));
      }
      scene.add_face(corners);
    }
  }
  add_triangles(d, scene, d.between(0, 2), 4);
  add_trouble(d, scene);
  Point3 target = eye;
  while (target == eye) target = d.chance(50) ? d.pick(scene.points) : d.point(3);
  scene.view = parallel ? from_direction(toward) : from_eye(eye, target, any_near(d));
  return scene;
}

TestScene boxes(std::uint64_t seed) {
  Dice d(seed);
  TestScene scene;
  for (int n = d.between(1, 2); n > 0; --n) {
    int low[3], high[3];
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = d.between(0, 3);
      high[axis] = d.between(low[axis] + 1, 4);
    }
    const auto first = static_cast<std::uint32_t>(scene.points.size());
    for (int i = 0; i < 8; ++i) {
      const double x = (i & 1) != 0 ? high[0] : low[0], y = (i & 2) != 0 ? high[1] : low[1],
                   z = (i & 4) != 0 ? high[2] : low[2];
      scene.points.push_back({x, y, z});
    }
    for (const auto& f : std::vector<std::array<std::uint32_t, 4>>{
             {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})
      if (!d.chance(5)) scene.add_face({first + f[0], first + f[1], first + f[2], first + f[3]});
  }
  if (d.chance(20)) add_triangles(d, scene, 1, 4);
  if (d.chance(70)) {
    scene.view = from_direction(any_direction(d));
  } else {
    const double x = d.between(-6, 6), y = d.between(-6, 6), z = d.between(0, 8);
    const double k = any_near(d);
    scene.view = d.chance(70) ? from_eye({x, y, z}, {2.25, 2.25, 2.25}, k) : from_eye({x, y, z}, {x + 0.5, y - 3, z}, k);
  }
  return scene;
}

// Views onto a flat pile, from where the tiny differences decide.
View view_of_pile(Dice& d, const TestScene& scene) {
  static const std::vector<Point3> some = {{0, 0, 1}, {0, 0, 1}, {0, 0, -1}, {1, 1, 1},
                                           {0, 1, 2}, {1, 0, 0}, {0, 1, 0},  {1, 1, 0}};
  if (d.chance(65)) return from_direction(d.pick(some));
  if (d.chance(50)) return any_perspective(d, scene, d.chance(50));
  const double x = d.between(-3, 3), y = d.between(-3, 3);
  const double z = d.chance(50) ? 6 : -6;
  return from_eye({x, y, z}, {0, 0, 0}, any_near(d));
}

TestScene stacks(std::uint64_t seed) {
  Dice d(seed);
  TestScene scene;
  double level[4] = {d.chance(50) ? 0.0 : d.chance(50) ? 1.0 : -3.0};
  for (int i = 1; i < 4; ++i) level[i] = std::nextafter(level[i - 1], 9.0);
  for (int n = d.between(2, 4); n > 0; --n) {
    const double z = level[d.between(0, 3)];
    const double x = d.between(-2, 2), y = d.between(-2, 2);
    if (d.chance(50)) {
      add_shape(scene, any_shape(d), {x, y, z}, {1, 0, 0}, {0, 1, 0});
      continue;
    }
    std::vector<Point3> corners;
    for (int k = 0; k < 3; ++k) {
      const double px = d.between(-3, 3), py = d.between(-3, 3);
      corners.push_back({px, py, z});
    }
    scene.add_face(corners);
  }
  add_trouble(d, scene);
  scene.view = view_of_pile(d, scene);
  return scene;
}

TestScene slopes(std::uint64_t seed) {
  Dice d(seed);
  TestScene scene;
  const double base = d.chance(30) ? 0 : d.chance(50) ? 1 : 0x1p-30;
  const double step = base == 0 ? std::numeric_limits<double>::denorm_min() : base * std::numeric_limits<double>::epsilon();
  for (int n = d.between(2, 4); n > 0; --n) {
    std::vector<Point3> corners;
    for (int k = 0; k < 3; ++k) {
      const double x = d.between(-4, 4), y = d.between(-4, 4);
      corners.push_back({x, y, base + step * d.between(0, 3)});
    }
    scene.add_face(corners);
  }
  add_trouble(d, scene);
  scene.view = view_of_pile(d, scene);
  if (d.chance(10)) scene.view = from_direction({1, std::nextafter(1.0, 2.0), d.chance(50) ? 1.0 : step});
  return scene;
}

TestScene around_the_eye(std::uint64_t seed) {
  Dice d(seed);
  TestScene scene;
  add_triangles(d, scene, d.between(1, 5), d.between(2, 4));
  if (d.chance(30)) {
    const Point3 o = d.point(3), u = d.point(1), v = d.point(1);
    add_shape(scene, any_shape(d), o, u, v);
  }
  add_trouble(d, scene);
  scene.view = any_perspective(d, scene, false);
  return scene;
}

// Faces, and the same faces again exactly behind: moved along the direction, or scaled from the eye.
TestScene echoes(std::uint64_t seed) {
  Dice d(seed);
  TestScene scene;
  if (d.chance(50)) {
    add_triangles(d, scene, d.between(1, 2), 3);
  } else {
    const Point3 o = d.point(2);
    static const std::vector<Point3> axes = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const Point3 u = d.pick(axes), v = d.chance(60) ? d.pick(axes) : d.point(1);
    add_shape(scene, any_shape(d), o, u, v);
  }
  add_trouble(d, scene);
  scene.view = any_view(d, scene);
  const Point3 at = scene.view.viewpoint.at;
  const TestScene first = scene;
  for (int n = d.between(1, 2); n > 0; --n) {
    const double by = d.between(-3, 3), side = d.chance(30) ? 1 : 0;
    const auto start = static_cast<std::uint32_t>(scene.points.size());
    for (const Point3& p : first.points) {
      const Point3 q = scene.view.is_perspective() ? combined(at, 1 + by / 4, minus(p, at), 0, {}) : combined(p, by, at, 0, {});
      scene.points.push_back({q.x + side, q.y, q.z});
    }
    for (std::size_t f = 0; f < first.polygons.size(); ++f) {
      std::vector<std::uint32_t> corners;
      for (const std::uint32_t c : first.polygons[f]) corners.push_back(start + c);
      if (!d.chance(20)) scene.add_face(corners);
    }
    for (const auto& s : first.polygons.segments) scene.polygons.segments.push_back({start + s[0], start + s[1]});
  }
  return scene;
}

TestScene far_away(std::uint64_t seed) {
  Dice d(seed);
  static const std::vector<TestScene (*)(std::uint64_t)> others = {triangles, polygons, edge_on,       boxes,
                                                                   echoes,    echoes,   around_the_eye};
  TestScene scene = d.pick(others)(seed);
  Point3 offset = d.point(4);
  const int power = d.between(10, 47);
  offset = {std::ldexp(offset.x, power), std::ldexp(offset.y, power), std::ldexp(offset.z, power)};
  bool rounds = false;
  const auto moved = [&](const Point3& p) {
    const Point3 q = combined(p, 1, offset, 0, {});
    rounds |= !(minus(q, offset) == p);
    return q;
  };
  TestScene out = scene;
  for (Point3& p : out.points) p = moved(p);
  if (scene.view.is_perspective()) {
    const Point3 eye = moved(scene.view.viewpoint.at), target = moved(scene.view.target);
    if (!rounds) out.view = from_eye(eye, target, scene.view.near);
  }
  return rounds ? scene : out;
}

TestScene scaled(std::uint64_t seed) {
  Dice d(seed);
  static const std::vector<TestScene (*)(std::uint64_t)> others = {triangles, polygons, edge_on,       boxes,
                                                                   stacks,    slopes,   around_the_eye};
  TestScene scene = d.pick(others)(seed);
  static const std::vector<int> powers = {900, -900, 300, -300, 60, -60};
  const int k = d.chance(70) ? d.pick(powers) : d.between(-900, 900);
  bool rounds = false;
  const auto by = [&](Point3 p, int power) {
    const Point3 q = {std::ldexp(p.x, power), std::ldexp(p.y, power), std::ldexp(p.z, power)};
    rounds |= !(Point3{std::ldexp(q.x, -power), std::ldexp(q.y, -power), std::ldexp(q.z, -power)} == p);
    return q;
  };
  TestScene out = scene;
  for (Point3& p : out.points) p = by(p, k);
  const View& v = scene.view;
  const bool parallel = v.viewpoint.is_direction;
  const Point3 at = by(v.viewpoint.at, parallel && d.chance(50) ? d.pick(powers) : k);
  const Point3 target = parallel ? Point3{} : by(v.target, k);
  if (rounds) return scene;
  out.view = parallel ? from_direction(at) : from_eye(at, target, v.near);
  return out;
}

// Numbers from the whole range of the doubles side by side: products and sums leave it.
TestScene magnitudes(std::uint64_t seed) {
  Dice d(seed);
  static const std::vector<int> powers = {-1074, -1060, -900, -500, -100, -52, 0, 0, 0, 52, 100, 500, 900, 1020};
  TestScene scene;
  add_triangles(d, scene, d.between(1, 4), 3);
  const int mode = d.between(0, 2);
  const std::vector<int> some = {d.pick(powers), d.pick(powers), d.pick(powers)};
  const auto power = [&](std::size_t axis) {
    if (mode == 0) return some[axis];        // each axis has its own scale
    if (mode == 1) return d.pick(some);      // two or three scales, mixed
    return d.chance(70) ? 0 : d.pick(some);  // a few strange numbers among plain ones
  };
  const auto spread = [&](const Point3& p) {
    const double x = std::ldexp(p.x, power(0)), y = std::ldexp(p.y, power(1)), z = std::ldexp(p.z, power(2));
    return Point3{x, y, z};
  };
  for (Point3& p : scene.points) p = spread(p);
  add_trouble(d, scene);
  if (d.chance(60)) {
    const Point3 toward = any_direction(d);
    scene.view = from_direction(d.chance(50) ? spread(toward) : toward);
  } else {
    const Point3 eye = d.chance(30) ? d.pick(scene.points) : spread(d.point(4));
    Point3 target = eye;
    while (target == eye) target = d.chance(50) ? d.pick(scene.points) : d.point(3);
    scene.view = from_eye(eye, target, any_near(d));
  }
  return scene;
}

}  // namespace

std::span<const Family> families() {
  static const Family all[] = {{"triangles", triangles},
                               {"polygons", polygons},
                               {"edge_on", edge_on},
                               {"boxes", boxes},
                               {"stacks", stacks},
                               {"slopes", slopes},
                               {"around_the_eye", around_the_eye},
                               {"echoes", echoes},
                               {"far_away", far_away},
                               {"scaled", scaled},
                               {"magnitudes", magnitudes}};
  return all;
}

const Family& family(const std::string& name) {
  for (const Family& f : families())
    if (name == f.name) return f;
  throw PreconditionError("no such family of scenes");
}

}  // namespace hsr::scenes
