#include "tests/scenes/test_scene.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <sstream>

#include "geometry/error.h"

namespace hsr::scenes {

namespace {

// The axis along which the direction is shortest is not parallel to it.
Point3 some_up(const Point3& d) {
  const double x = std::abs(d.x), y = std::abs(d.y), z = std::abs(d.z);
  if (z <= x && z <= y) return {0, 0, 1};
  return y <= x ? Point3{0, 1, 0} : Point3{1, 0, 0};
}

std::string text_of(double x) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.17g", x);  // reads back as the same double
  return buffer;
}

std::string text_of(const Point3& p) { return text_of(p.x) + " " + text_of(p.y) + " " + text_of(p.z); }

double number(std::istringstream& in) {
  std::string word;
  if (!(in >> word)) throw InputError("scene: expected a number");
  char* end = nullptr;
  const double x = std::strtod(word.c_str(), &end);
  if (*end != '\0') throw InputError("scene: expected a number, found " + word);
  return x;
}

Point3 point(std::istringstream& in) {
  Point3 p;
  p.x = number(in);
  p.y = number(in);
  p.z = number(in);
  return p;
}

std::vector<std::uint32_t> corners_of(const TestScene& scene, std::size_t face) {
  const auto corners = scene.polygons[face];
  return {corners.begin(), corners.end()};
}

TestScene without_face(const TestScene& scene, std::size_t face) {
  TestScene out{scene.name, scene.points, {}, scene.view};
  out.polygons.segments = scene.polygons.segments;
  for (std::size_t f = 0; f < scene.polygons.size(); ++f)
    if (f != face) out.add_face(corners_of(scene, f));
  return out;
}

TestScene without_corner(const TestScene& scene, std::size_t face, std::size_t corner) {
  TestScene out{scene.name, scene.points, {}, scene.view};
  out.polygons.segments = scene.polygons.segments;
  for (std::size_t f = 0; f < scene.polygons.size(); ++f) {
    auto corners = corners_of(scene, f);
    if (f == face) corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(corner));
    out.add_face(corners);
  }
  return out;
}

TestScene without_unused_points(const TestScene& scene) {
  TestScene out{scene.name, {}, {}, scene.view};
  std::vector<std::optional<std::uint32_t>> number_of(scene.points.size());
  const auto use = [&](std::uint32_t v) {
    if (!number_of[v]) {
      number_of[v] = static_cast<std::uint32_t>(out.points.size());
      out.points.push_back(scene.points[v]);
    }
    return *number_of[v];
  };
  for (std::size_t f = 0; f < scene.polygons.size(); ++f) {
    auto corners = corners_of(scene, f);
    for (auto& v : corners) v = use(v);
    out.add_face(corners);
  }
  for (const auto& s : scene.polygons.segments) {
    const std::uint32_t a = use(s[0]);
    out.polygons.segments.push_back({a, use(s[1])});
  }
  return out;
}

}  // namespace

void TestScene::add_face(const std::vector<std::uint32_t>& corners) {
  polygons.corners.insert(polygons.corners.end(), corners.begin(), corners.end());
  polygons.first.push_back(static_cast<std::uint32_t>(polygons.corners.size()));
}

void TestScene::add_face(const std::vector<Point3>& corners) {
  std::vector<std::uint32_t> indices;
  for (const Point3& p : corners) {
    indices.push_back(static_cast<std::uint32_t>(points.size()));
    points.push_back(p);
  }
  add_face(indices);
}

void TestScene::add_box(const Point3& low, const Point3& high) {
  const auto n = static_cast<std::uint32_t>(points.size());
  for (int k = 0; k < 8; ++k)
    points.push_back({(k & 1) != 0 ? high.x : low.x, (k & 2) != 0 ? high.y : low.y, (k & 4) != 0 ? high.z : low.z});
  using Side = std::array<std::uint32_t, 4>;
  for (const Side& f :
       {Side{0, 2, 3, 1}, Side{4, 5, 7, 6}, Side{0, 1, 5, 4}, Side{2, 6, 7, 3}, Side{0, 4, 6, 2}, Side{1, 3, 7, 5}})
    add_face({n + f[0], n + f[1], n + f[2], n + f[3]});
}

View from_direction(const Point3& toward_viewer) { return parallel_view(toward_viewer, some_up(toward_viewer)); }

View from_eye(const Point3& eye, const Point3& target, double k) {
  View view = perspective_view(eye, target, some_up({target.x - eye.x, target.y - eye.y, target.z - eye.z}));
  view.near = k;
  return view;
}

std::string to_text(const TestScene& scene) {
  std::ostringstream text;
  text << "# name " << scene.name << "\n";
  if (scene.view.viewpoint.is_direction) {
    text << "# direction " << text_of(scene.view.viewpoint.at) << "\n";
  } else {
    text << "# eye " << text_of(scene.view.viewpoint.at) << "\n# target " << text_of(scene.view.target);
    text << "\n# near " << text_of(scene.view.near) << "\n";
  }
  if (const auto& section = scene.view.section)
    text << "# section " << text_of(section->point) << " " << text_of(section->normal) << "\n";
  for (const Point3& p : scene.points) text << "v " << text_of(p) << "\n";
  for (std::size_t f = 0; f < scene.polygons.size(); ++f) {
    text << "f";
    for (const std::uint32_t v : scene.polygons[f]) text << " " << v + 1;
    text << "\n";
  }
  for (const auto& s : scene.polygons.segments) text << "l " << s[0] + 1 << " " << s[1] + 1 << "\n";
  return text.str();
}

TestScene scene_from_text(const std::string& text) {
  TestScene scene;
  std::optional<Point3> direction, eye, target;
  std::optional<std::array<Point3, 2>> section;
  double near = 0.001;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream in(line);
    std::string word;
    if (!(in >> word)) continue;
    if (word == "#") {
      in >> word;
      if (word == "name") std::getline(in >> std::ws, scene.name);
      if (word == "direction") direction = point(in);
      if (word == "eye") eye = point(in);
      if (word == "target") target = point(in);
      if (word == "near") near = number(in);
      if (word == "section") {
        const Point3 at = point(in);
        section = {at, point(in)};
      }
    } else if (word == "v") {
      scene.points.push_back(point(in));
    } else if (word == "f" || word == "l") {
      std::vector<std::uint32_t> corners;
      for (std::uint32_t v = 0; in >> v;) corners.push_back(v - 1);
      if (word == "f") {
        scene.add_face(corners);
      } else if (corners.size() == 2) {
        scene.polygons.segments.push_back({corners[0], corners[1]});
      }
    } else {
      throw InputError("scene: unknown line " + line);
    }
  }
  if (!direction && !(eye && target)) throw InputError("scene: no view");
  scene.view = direction ? from_direction(*direction) : from_eye(*eye, *target, near);
  if (section) scene.view = with_section(scene.view, (*section)[0], (*section)[1]);
  return scene;
}

TestScene shrunk(TestScene scene, const std::function<bool(const TestScene&)>& fails) {
  const auto try_it = [&](TestScene smaller) {
    if (!fails(smaller)) return false;
    scene = std::move(smaller);
    return true;
  };
  for (bool shrinks = true; shrinks;) {
    shrinks = false;
    for (std::size_t f = scene.polygons.size(); f-- > 0;) shrinks |= try_it(without_face(scene, f));
    for (std::size_t s = scene.polygons.segments.size(); s-- > 0;) {
      TestScene smaller = scene;
      smaller.polygons.segments.erase(smaller.polygons.segments.begin() + static_cast<std::ptrdiff_t>(s));
      shrinks |= try_it(std::move(smaller));
    }
    for (std::size_t f = 0; f < scene.polygons.size(); ++f)
      for (std::size_t c = scene.polygons[f].size(); c-- > 0 && scene.polygons[f].size() > 3;)
        shrinks |= try_it(without_corner(scene, f, c));
  }
  TestScene tidy = without_unused_points(scene);
  return fails(tidy) ? tidy : scene;
}

}  // namespace hsr::scenes
