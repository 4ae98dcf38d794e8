#include "tests/lines/labelled_scene.h"

#include <algorithm>
#include <optional>
#include <set>
#include <sstream>

#include "tests/oracle/exact_vector.h"

namespace hsr {

using oracle::Vec;
using scenes::TestScene;

Labelled without_faces(const Labelled& x) {
  Labelled empty = x;
  empty.scene.polygons.first = {0};
  empty.scene.polygons.corners.clear();
  empty.labels = {};
  return empty;
}

Labelled recut(const Labelled& x, const Recut& cut) {
  const Mesh mesh = x.scene.mesh();
  Labelled y = without_faces(x);
  for (std::size_t f = 0; f < x.scene.polygons.size(); ++f) {
    const auto corners = x.scene.polygons[f];
    const Ring ring(corners.begin(), corners.end());
    // Faces that are cut into triangles for not being planar are cut otherwise if they have more corners.
    const bool stays = mesh.faces[FaceId(f)] != FaceUse::planar;
    for (const Ring& r : stays ? std::vector<Ring>{ring} : cut(mesh, FaceId(f), ring, y)) {
      y.add_face(r, x.labels.object[f], x.labels.material[f]);
      if (!x.labels.surface.empty()) y.labels.surface.push_back(x.labels.surface[f]);
      if (!x.labels.shape.empty()) y.labels.shape.push_back(x.labels.shape[f]);
    }
  }
  return y;
}

namespace {

/// A point exactly on the segment at t, a power of two; nothing where doubles do not hold it.
std::optional<Point3> exactly_between(const Point3& a, const Point3& b, double t) {
  const Point3 p = {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, a.z + (b.z - a.z) * t};
  const Vec va(a), vb(b);
  if (!(va + oracle::Q(t) * (vb - va) == Vec(p)) || p == a || p == b) return std::nullopt;
  return p;
}

std::uint32_t added(Labelled& to, const Point3& p) {
  to.scene.points.push_back(p);
  return static_cast<std::uint32_t>(to.scene.points.size() - 1);
}

}  // namespace

std::vector<Ring> with_cut_sides(const Mesh&, FaceId, const Ring& ring, Labelled& to) {
  Ring more;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    more.push_back(ring[k]);
    const Point3 a = to.scene.points[ring[k]], b = to.scene.points[ring[(k + 1) % ring.size()]];
    for (const double t : {0.25, 0.5})
      if (const auto p = exactly_between(a, b, t)) more.push_back(added(to, *p));
  }
  return {more};
}

std::vector<Ring> as_triangles(const Mesh& mesh, FaceId face, const Ring&, Labelled&) {
  std::vector<Ring> all;
  for (std::uint32_t t = mesh.first_triangle[face]; t < mesh.first_triangle[FaceId(face.value + 1U)]; ++t) {
    const auto& c = mesh.triangles[TriangleId(t)];
    all.push_back({c[0].value, c[1].value, c[2].value});
  }
  return all;
}

std::vector<Ring> in_halves(const Mesh& mesh, FaceId face, const Ring& ring, Labelled& to) {
  std::vector<Ring> all;
  for (const Ring& t : as_triangles(mesh, face, ring, to)) {
    const auto p = exactly_between(to.scene.points[t[0]], to.scene.points[t[1]], 0.5);
    if (!p) {
      all.push_back(t);
      continue;
    }
    const std::uint32_t m = added(to, *p);
    all.push_back({t[0], m, t[2]});
    all.push_back({m, t[1], t[2]});
  }
  return all;
}

std::vector<Ring> turned_over(const Mesh&, FaceId face, const Ring& ring, Labelled&) {
  Ring turned = ring;
  if (face.value % 2 == 0) std::reverse(turned.begin(), turned.end());
  std::rotate(turned.begin(), turned.begin() + 1, turned.end());
  return {turned};
}

Labelled labelled(const TestScene& scene, bool with_labels) {
  Labelled x{scene, {}};
  for (std::uint32_t f = 0; f < scene.polygons.size(); ++f) {
    x.labels.object.push_back(with_labels ? f % 3 : 0);
    x.labels.material.push_back(with_labels && f % 4 == 0 ? 1 : 0);
  }
  return x;
}

std::string difference(const std::string& x, const std::string& y) {
  const auto lines = [](const std::string& text) {
    std::multiset<std::string> all;
    std::string key;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
      if (!line.starts_with("  "))
        key = line;
      else
        all.insert(key + ":" + line);
    }
    return all;
  };
  const auto in_x = lines(x), in_y = lines(y);
  std::string text;
  for (const std::string& line : in_x)
    if (in_y.count(line) != in_x.count(line)) text += "- " + line + "\n";
  for (const std::string& line : in_y)
    if (in_y.count(line) != in_x.count(line)) text += "+ " + line + "\n";
  return text;
}

int lines_of(const Labelled& x, const char* style) {
  const std::string ink = x.ink();
  int n = 0;
  for (std::size_t at = ink.find(style); at != std::string::npos; at = ink.find(style, at + 1)) ++n;
  return n;
}

std::string by_visibility(std::string ink) {
  for (const char* c : {"sharp", "outline", "boundary", "intersection"})
    for (std::size_t at = ink.find(c); at != std::string::npos; at = ink.find(c))
      ink.replace(at, std::string(c).size(), "line");
  return ink;
}

}  // namespace hsr
