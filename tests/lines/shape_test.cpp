#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <numeric>
#include <random>
#include <set>
#include <sstream>

#include "hsr/io/read/read.h"
#include "tests/lines/checked_lines.h"
#include "tests/lines/ink.h"
#include "tests/oracle/exact_vector.h"
#include "tests/scenes/random_scenes.h"

// A drawing depends on the shape, not on how it is cut into faces.

namespace hsr {

namespace {

using oracle::Vec;
using scenes::TestScene;
using Ring = std::vector<std::uint32_t>;

/// A scene whose faces are of objects and materials.
struct Labelled {
  TestScene scene;
  FaceLabels labels;

  std::string ink() const { return ink_of(SceneView(Scene(scene.mesh(), labels), scene.view)); }
  void add_face(const Ring& ring, std::uint32_t object = 0, std::uint32_t material = 0) {
    scene.add_face(ring);
    labels.object.push_back(object);
    labels.material.push_back(material);
  }
  /// With points of its own.
  void add_face(const std::vector<Point3>& corners, std::uint32_t object = 0, std::uint32_t material = 0) {
    Ring ring;
    for (const Point3& p : corners) {
      ring.push_back(static_cast<std::uint32_t>(scene.points.size()));
      scene.points.push_back(p);
    }
    add_face(ring, object, material);
  }
  /// A box between two corners, with points of its own.
  void add_box(const Point3& a, const Point3& b, std::uint32_t object = 0, std::uint32_t material = 0) {
    const auto n = static_cast<std::uint32_t>(scene.points.size());
    for (int k = 0; k < 8; ++k)
      scene.points.push_back({(k & 1) != 0 ? b.x : a.x, (k & 2) != 0 ? b.y : a.y, (k & 4) != 0 ? b.z : a.z});
    for (const Ring& f :
         {Ring{0, 2, 3, 1}, Ring{4, 5, 7, 6}, Ring{0, 1, 5, 4}, Ring{2, 6, 7, 3}, Ring{0, 4, 6, 2}, Ring{1, 3, 7, 5}})
      add_face({n + f[0], n + f[1], n + f[2], n + f[3]}, object, material);
  }
};

Labelled without_faces(const Labelled& x) {
  Labelled empty = x;
  empty.scene.polygons.first = {0};
  empty.scene.polygons.corners.clear();
  empty.labels = {};
  return empty;
}

/// What a face becomes: rings over the points of `to`, to which it may add some.
using Recut = std::function<std::vector<Ring>(const Mesh& mesh, FaceId face, const Ring& ring, Labelled& to)>;

Labelled recut(const Labelled& x, const Recut& cut) {
  const Mesh mesh = x.scene.mesh();
  Labelled y = without_faces(x);
  for (std::size_t f = 0; f < x.scene.polygons.size(); ++f) {
    const auto corners = x.scene.polygons[f];
    const Ring ring(corners.begin(), corners.end());
    // Faces that are cut into triangles for not being planar are cut otherwise if they have more corners.
    const bool stays = mesh.faces[FaceId(f)] != FaceUse::planar;
    for (const Ring& r : stays ? std::vector<Ring>{ring} : cut(mesh, FaceId(f), ring, y))
      y.add_face(r, x.labels.object[f], x.labels.material[f]);
  }
  return y;
}

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

/// Its sides cut in three: its neighbours' are not.
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

/// Each of its triangles cut in two, from a corner to the middle of a side: the sides overlap those of the neighbours.
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

/// Whether two triangles with a side in common lie in one plane, on either side of it.
bool go_on_flat(const Mesh& mesh, const Edge& e, TriangleId t, TriangleId u) {
  const Vec a(mesh.points[e.a]), side = Vec(mesh.points[e.b]) - a;
  const Vec c = Vec(mesh.points[mesh.apex(t, e)]) - a, d = Vec(mesh.points[mesh.apex(u, e)]) - a;
  const Vec n = cross(side, c);
  return dot(n, d) == 0 && dot(n, cross(side, d)) < 0;
}

/// Pairs of triangles of one plane become quadrangles.
Labelled with_joined_triangles(const Labelled& x) {
  const Mesh mesh = x.scene.mesh();
  const auto is_triangle = [&](FaceId f) { return mesh.faces[f] == FaceUse::planar && x.scene.polygons[f.value].size() == 3; };
  std::vector<Ring> joined(x.scene.polygons.size());  // by the first face of a pair
  std::vector<std::uint8_t> is_gone(joined.size(), 0);
  for (std::size_t k = 0; k < mesh.edges.size(); ++k) {
    const auto at = mesh.triangles_at(EdgeId(k));
    if (at.size() != 2) continue;
    const Edge& e = mesh.edges[EdgeId(k)];
    const std::size_t f = mesh.face_of[at[0]].value, g = mesh.face_of[at[1]].value;
    const bool is_free = is_gone[f] == 0 && is_gone[g] == 0 && joined[f].empty() && joined[g].empty();
    if (!is_free || !is_triangle(FaceId(f)) || !is_triangle(FaceId(g)) || x.labels.object[f] != x.labels.object[g] ||
        x.labels.material[f] != x.labels.material[g] || !go_on_flat(mesh, e, at[0], at[1]))
      continue;
    joined[f] = {e.a.value, mesh.apex(at[0], e).value, e.b.value, mesh.apex(at[1], e).value};
    is_gone[g] = 1;
  }
  Labelled y = without_faces(x);
  for (std::size_t f = 0; f < joined.size(); ++f) {
    if (is_gone[f] != 0) continue;
    const auto corners = x.scene.polygons[f];
    y.add_face(joined[f].empty() ? Ring(corners.begin(), corners.end()) : joined[f], x.labels.object[f], x.labels.material[f]);
  }
  return y;
}

/// All of one object and one material.
Labelled without_labels(const Labelled& x) {
  Labelled y = x;
  std::fill(y.labels.object.begin(), y.labels.object.end(), 0);
  std::fill(y.labels.material.begin(), y.labels.material.end(), 0);
  return y;
}

/// The faces in another order: of coincident faces another one is then on top, and with it its material.
Labelled permuted(const Labelled& x) {
  std::vector<std::size_t> order(x.scene.polygons.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::mt19937_64 random(1);
  std::shuffle(order.begin(), order.end(), random);
  Labelled y = without_faces(x);
  for (const std::size_t f : order) {
    const auto corners = x.scene.polygons[f];
    y.add_face(Ring(corners.begin(), corners.end()), x.labels.object[f], x.labels.material[f]);
  }
  return y;
}

Labelled labelled(const TestScene& scene, bool with_labels) {
  Labelled x{scene, {}};
  for (std::uint32_t f = 0; f < scene.polygons.size(); ++f) {
    x.labels.object.push_back(with_labels ? f % 3 : 0);
    x.labels.material.push_back(with_labels && f % 4 == 0 ? 1 : 0);
  }
  return x;
}

/// The lines of one text that the other has not.
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

void check_cuts(std::uint64_t first_seed, std::uint64_t seeds) {
  const std::pair<const char*, Recut> ways[] = {{"sides cut in three", with_cut_sides},
                                                {"as triangles", as_triangles},
                                                {"in halves", in_halves},
                                                {"turned over", turned_over}};
  for (const scenes::Family& family : scenes::families())
    for (std::uint64_t seed = first_seed; seed < first_seed + seeds; ++seed) {
      const Labelled x = labelled(family.make(seed), seed % 2 == 0);
      const std::string ink = x.ink();
      for (const auto& [name, way] : ways) {
        INFO(family.name << " " << seed << ": " << name << "\n" << scenes::to_text(x.scene));
        CHECK(difference(ink, recut(x, way).ink()) == "");
      }
    }
}

TEST_CASE("how the faces of a scene are cut changes no ink", "[lines][metamorphic][shape][C1][C12]") {
  check_cuts(700'000, 12);
}

TEST_CASE("how the faces of many scenes are cut changes no ink", "[lines][metamorphic][shape][.][long]") {
  check_cuts(720'000, 300);
}

/// A number of the environment, or what it is else.
double setting(const char* name, double otherwise) {
  const char* const text = std::getenv(name);
  return text == nullptr ? otherwise : std::atof(text);
}

/// The models in a directory, those of few faces first.
std::vector<Labelled> models_in(const char* directory, std::size_t most_faces, std::vector<std::string>& names) {
  std::vector<std::pair<std::string, Labelled>> all;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(directory)) {
    Labelled x;
    try {
      const Model model = read_model(entry.path().string());
      if (model.polygons.size() > most_faces || static_cast<double>(model.polygons.size()) < setting("HSR_MODEL_LEAST", 0))
        continue;
      x.scene.points = model.points;
      x.scene.polygons = model.polygons;
      x.labels = labels_of(model);
    } catch (const std::exception&) {
      continue;  // no model, or one that is refused
    }
    x.labels.object.resize(x.scene.polygons.size(), 0);
    x.labels.material.resize(x.scene.polygons.size(), 0);
    all.emplace_back(entry.path().string(), std::move(x));
  }
  std::sort(all.begin(), all.end(), [](const auto& x, const auto& y) {
    return std::pair(x.second.scene.polygons.size(), x.first) < std::pair(y.second.scene.polygons.size(), y.first);
  });
  std::vector<Labelled> models;
  for (auto& [name, model] : all) {
    names.push_back(name);
    models.push_back(std::move(model));
  }
  return models;
}

/// Of every model in the directory HSR_MODELS of HSR_MODEL_LEAST [0] to HSR_MODEL_FACES faces [1200], from two sides, each for no more
/// than about HSR_MODEL_SECONDS [60]: rationals take their time.
TEST_CASE("how the faces of models are cut changes no ink", "[lines][metamorphic][shape][.][long][models]") {
  const char* const directory = std::getenv("HSR_MODELS");
  if (directory == nullptr) {
    WARN("HSR_MODELS is not set: no model is looked at");
    return;
  }
  std::vector<std::string> names;
  std::vector<Labelled> models = models_in(directory, static_cast<std::size_t>(setting("HSR_MODEL_FACES", 1200)), names);
  CHECK(!models.empty());
  for (std::size_t m = 0; m < models.size(); ++m) {
    Labelled& x = models[m];
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
    const auto is_late = [&] { return seconds() > setting("HSR_MODEL_SECONDS", 60); };
    int done = 0;
    for (const Point3& direction : {Point3{1, -1, 1}, Point3{0, -1, 0}}) {
      if (is_late()) break;
      x.scene.view = scenes::from_direction(direction);
      const std::string ink = x.ink();
      const auto check = [&](const char* way, const std::string& expected, const std::function<Labelled()>& other) {
        if (is_late()) return;
        INFO(names[m] << ": " << way);
        CHECK(difference(expected, other().ink()) == "");
        ++done;
      };
      check("sides cut in three", ink, [&] { return recut(x, with_cut_sides); });
      check("triangles joined", ink, [&] { return with_joined_triangles(x); });
      check("as triangles", ink, [&] { return recut(x, as_triangles); });
      check("in halves", ink, [&] { return recut(x, in_halves); });
      const Labelled plain = without_labels(x);
      check("permuted", plain.ink(), [&] { return permuted(plain); });
    }
    std::fprintf(stderr, "%s: %zu faces, %d of 10 in %.1f s\n", names[m].c_str(), x.scene.polygons.size(), done, seconds());
  }
}

TEST_CASE("cutting twice changes no ink, and joining what was cut gives it back", "[lines][metamorphic][shape][C1]") {
  for (const char* name : {"polygons", "boxes", "edge_on"})
    for (std::uint64_t seed = 710'000; seed < 710'010; ++seed) {
      const Labelled x = labelled(scenes::family(name).make(seed), true);
      INFO(name << " " << seed << "\n" << scenes::to_text(x.scene));
      CHECK(difference(x.ink(), recut(recut(x, in_halves), with_cut_sides).ink()) == "");
    }
}

// Two boxes side by side, the second as high, or higher: one flat side is one flat side.
Labelled two_boxes(double height) {
  Labelled x;
  x.add_box({0, 0, 0}, {4, 3, 3}, 0);
  x.add_box({4, 0, 0}, {9, 3, height}, 1);
  return x;
}

int lines_of(const Labelled& x, const char* style) {
  const std::string ink = x.ink();
  int n = 0;
  for (std::size_t at = ink.find(style); at != std::string::npos; at = ink.find(style, at + 1)) ++n;
  return n;
}

TEST_CASE("one flat side is one flat side, however high its neighbours are", "[lines][shape][C12][C18]") {
  for (const double height : {3.0, 4.0}) {
    Labelled x = two_boxes(height);
    x.scene.view = scenes::from_direction({0, -1, 0});
    INFO(x.ink());
    CHECK(lines_of(x, "visible joint") == 1);
    CHECK(lines_of(x, "visible sharp") == 0);
    CHECK(lines_of(x, "visible boundary") == 0);
    // Of one object there is no joint; of two materials there is more.
    Labelled one = x, painted = x;
    one.labels.object.assign(12, 0);
    CHECK(lines_of(one, "joint") == 0);
    for (std::size_t f = 6; f < 12; ++f) painted.labels.material[f] = 1;
    CHECK(lines_of(painted, "visible material") == 1);
    CHECK(lines_of(painted, "joint") == 0);
  }
}

// Two boxes with the same sides that overlap, and a third around a part of an edge of both: there it is inside of a body, elsewhere
// it is not, however long the edges are.
TEST_CASE("an edge that leads into a body is cut where it enters", "[lines][shape][C21]") {
  Labelled x;
  x.add_box({0, 0, 0}, {4, 4, 10});
  x.add_box({0, 0, 3}, {4, 4, 13});
  x.add_box({-2, -2, 5}, {2, 2, 7});
  for (const Point3& direction : {Point3{0, -1, 0}, Point3{1, -2, 1}, Point3{-3, 2, 1}}) {
    x.scene.view = scenes::from_direction(direction);
    CHECK(difference(x.ink(), recut(x, with_cut_sides).ink()) == "");
    CHECK(difference(x.ink(), recut(x, in_halves).ink()) == "");
  }
}

TEST_CASE("a side that is cut at a T is smooth", "[lines][shape][C12]") {
  Labelled x;
  const std::vector<std::vector<Point3>> panels = {{{0, 0, 0}, {4, 0, 0}, {4, 0, 4}, {0, 0, 4}},
                                                   {{4, 0, 0}, {8, 0, 0}, {8, 0, 1}, {4, 0, 1}},
                                                   {{4, 0, 1}, {8, 0, 1}, {8, 0, 4}, {4, 0, 4}}};
  for (const auto& panel : panels) x.add_face(panel);
  for (const Point3& direction : {Point3{0, -1, 0}, Point3{1, -2, 1}}) {
    x.scene.view = scenes::from_direction(direction);
    CHECK(lines_of(x, "visible boundary") == 4);
    CHECK(lines_of(x, "visible") == 4);
  }
}

// Bricks of 4 x 1 in courses, each course shifted by half a brick.
TEST_CASE("the joints of a bond are all joints", "[lines][shape][C18]") {
  Labelled x;
  std::uint32_t brick = 0;
  for (int course = 0; course < 3; ++course)
    for (int k = 0; k < 3; ++k, ++brick) {
      const double left = 4 * k + 2 * (course % 2);
      x.add_face(
          {{left, 0, double(course)}, {left + 4, 0, double(course)}, {left + 4, 0, course + 1.0}, {left, 0, course + 1.0}},
          brick);
    }
  x.scene.view = scenes::from_direction({0, -1, 0});
  INFO(x.ink());
  CHECK(lines_of(x, "sharp") == 0);
  CHECK(lines_of(x, "visible joint") == 2 + 6);  // two beds, and two head joints in each course
}

/// The ink whatever its class.
std::string by_visibility(std::string ink) {
  for (const char* c : {"sharp", "outline", "boundary", "intersection"})
    for (std::size_t at = ink.find(c); at != std::string::npos; at = ink.find(c))
      ink.replace(at, std::string(c).size(), "line");
  return ink;
}

/// A slab from z = 0 to 1, and a column under it whose head touches it, or stands in it, or is one body with it.
TEST_CASE("a column under a slab is dashed, be it a body of its own or not", "[lines][shape][C17][C19]") {
  Labelled touching, gap, fused;
  touching.add_box({0, 0, 0}, {10, 8, 1}, 0);
  touching.add_box({3, 3, -5}, {6, 5, 0}, 1);
  gap.add_box({0, 0, 0}, {10, 8, 1}, 0);
  gap.add_box({3, 3, -5}, {6, 5, -1}, 1);
  // One body: the underside of the slab has a hole, as a keyhole, where the column begins.
  fused.add_box({0, 0, 0}, {10, 8, 1}, 0);
  fused = recut(fused, [](const Mesh&, FaceId face, const Ring& ring, Labelled& to) {
    if (face.value != 0) return std::vector<Ring>{ring};
    const auto n = static_cast<std::uint32_t>(to.scene.points.size());
    for (const double z : {0.0, -5.0})
      for (const Point3& p : {Point3{3, 3, z}, Point3{6, 3, z}, Point3{6, 5, z}, Point3{3, 5, z}}) to.scene.points.push_back(p);
    return std::vector<Ring>{{ring[0], ring[1], ring[2], ring[3], ring[0], n, n + 1, n + 2, n + 3, n},
                             {n, n + 1, n + 5, n + 4},
                             {n + 1, n + 2, n + 6, n + 5},
                             {n + 2, n + 3, n + 7, n + 6},
                             {n + 3, n, n + 4, n + 7},
                             {n + 4, n + 5, n + 6, n + 7}};
  });
  for (Labelled* x : {&touching, &gap, &fused}) x->scene.view = scenes::from_direction({0, 0, 1});
  CHECK(lines_of(touching, "hidden") == 4);
  CHECK(by_visibility(touching.ink()) == by_visibility(gap.ink()));
  CHECK(by_visibility(touching.ink()) == by_visibility(fused.ink()));
}

/// Boxes of whole numbers with disjoint insides: what a grid of unit cells holds of them.
struct Blocks {
  static constexpr int size = 4;
  std::array<std::array<std::array<int, size>, size>, size> box_at{};  // 0: none
  int count = 0;

  explicit Blocks(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<std::uint64_t>(n)); };
    for (int tries = 0; tries < 12; ++tries) {
      std::array<int, 3> low{}, high{};
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = below(size);
        high[k] = low[k] + 1 + below(size - low[k]);
      }
      if (is_free(low, high)) fill(low, high, ++count);
    }
  }
  int at(int x, int y, int z) const {
    const auto is_inside = [](int i) { return 0 <= i && i < size; };
    return is_inside(x) && is_inside(y) && is_inside(z)
               ? box_at[static_cast<std::size_t>(x)][static_cast<std::size_t>(y)][static_cast<std::size_t>(z)]
               : 0;
  }
  template <class Visit>
  static void cells(const std::array<int, 3>& low, const std::array<int, 3>& high, const Visit& visit) {
    for (int x = low[0]; x < high[0]; ++x)
      for (int y = low[1]; y < high[1]; ++y)
        for (int z = low[2]; z < high[2]; ++z) visit(x, y, z);
  }
  bool is_free(const std::array<int, 3>& low, const std::array<int, 3>& high) const {
    bool is = true;
    cells(low, high, [&](int x, int y, int z) { is = is && at(x, y, z) == 0; });
    return is;
  }
  void fill(const std::array<int, 3>& low, const std::array<int, 3>& high, int box) {
    cells(low, high, [&](int x, int y, int z) {
      box_at[static_cast<std::size_t>(x)][static_cast<std::size_t>(y)][static_cast<std::size_t>(z)] = box;
    });
    boxes.push_back({low, high});
  }
  std::vector<std::pair<std::array<int, 3>, std::array<int, 3>>> boxes;

  Labelled apart() const {
    Labelled x;
    for (const auto& [low, high] : boxes)
      x.add_box({double(low[0]), double(low[1]), double(low[2])}, {double(high[0]), double(high[1]), double(high[2])});
    return x;
  }
  /// The surface of all of them together, a square for each side of a cell that has nothing beside it.
  Labelled together() const {
    Labelled x;
    cells({0, 0, 0}, {size, size, size}, [&](int i, int j, int k) {
      if (at(i, j, k) == 0) return;
      for (std::size_t axis = 0; axis < 3; ++axis)
        for (const int step : {0, 1}) {
          std::array<int, 3> beside = {i, j, k};
          beside[axis] += step == 0 ? -1 : 1;
          if (at(beside[0], beside[1], beside[2]) != 0) continue;
          std::vector<Point3> corners;
          for (const auto& [u, v] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)}) {
            std::array<int, 3> p = {i, j, k};
            p[axis] += step;
            p[(axis + 1) % 3] += u;
            p[(axis + 2) % 3] += v;
            corners.push_back({double(p[0]), double(p[1]), double(p[2])});
          }
          x.add_face(corners);
        }
    });
    return x;
  }
};

void check_blocks(std::uint64_t first_seed, std::uint64_t seeds) {
  for (std::uint64_t seed = first_seed; seed < first_seed + seeds; ++seed) {
    const Blocks blocks(seed);
    Labelled apart = blocks.apart(), together = blocks.together();
    for (const View& view :
         {scenes::from_direction({1, -1, 1}), scenes::from_direction({2, -3, 1}), scenes::from_direction({0, -1, 0}),
          scenes::from_direction({0, 0, 1}), scenes::from_eye({7, -9, 6}, {2, 2, 2})}) {
      apart.scene.view = together.scene.view = view;
      INFO("seed " << seed << ", " << blocks.count << " boxes\n" << scenes::to_text(apart.scene));
      CHECK(difference(apart.ink(), together.ink()) == "");
    }
  }
}

TEST_CASE("bodies that touch are drawn as one body of their shape", "[lines][metamorphic][shape][C17][C21]") {
  check_blocks(730'000, 40);
}

TEST_CASE("many bodies that touch are drawn as one body of their shape", "[lines][metamorphic][shape][.][long]") {
  check_blocks(740'000, 2000);
}

/// The straight lines of an ink, each with what is drawn of it.
std::set<std::string> lines_in(const std::string& ink) {
  std::set<std::string> all;
  for (std::size_t at = 0; at < ink.size();) {
    std::size_t end = at;
    do end = ink.find('\n', end) + 1;
    while (end < ink.size() && ink[end] == ' ');
    all.insert(ink.substr(at, end - at));
    at = end;
  }
  return all;
}

std::set<std::string> without(std::set<std::string> all, const std::set<std::string>& known) {
  for (const std::string& line : known) all.erase(line);
  return all;
}

TEST_CASE("a box whose upper part is there a second time keeps its hidden lines", "[lines][shape][C21][C22]") {
  Labelled box;
  box.add_box({0, 0, 0}, {3, 3, 4});
  Labelled twice = box;
  twice.add_box({0, 0, 2}, {3, 3, 4});  // its walls coincide with those of the box, on the same side
  for (const View& view : {scenes::from_direction({2, -3, 1}), scenes::from_eye({9, -12, 7}, {1, 1, 2})}) {
    box.scene.view = twice.scene.view = view;
    INFO(twice.ink());
    CHECK(without(lines_in(box.ink()), lines_in(twice.ink())).empty());
  }
}

TEST_CASE("where bodies touch nothing is drawn, though one that overlaps another touches there, too",
          "[lines][shape][C21][C22]") {
  Labelled four;
  four.add_box({0, 0, 0}, {10, 6, 3});
  four.add_box({10, 0, 0}, {14, 6, 3});
  four.add_box({0, 6, 0}, {10, 9, 3});
  four.add_box({10, 6, 0}, {14, 9, 3});
  Labelled more = four;
  more.add_box({10, 1, 1}, {11, 4, 2});
  four.scene.view = more.scene.view = scenes::from_direction({2, -3, 1});
  CHECK(lines_in(four.ink()).size() == 12);
  INFO(more.ink());
  CHECK(without(lines_in(four.ink()), lines_in(more.ink())).empty());
  CHECK(without(lines_in(more.ink()), lines_in(four.ink())).size() == 12);  // its own edges
}

/// Every face a second time, behind all others or beside its first, every other one turned over.
Labelled stored_twice(const Labelled& x, bool beside) {
  Labelled y = without_faces(x);
  const auto add = [&](std::size_t f, bool turned) {
    Ring ring(x.scene.polygons[f].begin(), x.scene.polygons[f].end());
    if (turned) std::reverse(ring.begin(), ring.end());
    y.add_face(ring, x.labels.object[f], x.labels.material[f]);
  };
  for (std::size_t f = 0; f < x.scene.polygons.size(); ++f) {
    add(f, false);
    if (beside) add(f, f % 2 == 0);
  }
  for (std::size_t f = 0; !beside && f < x.scene.polygons.size(); ++f) add(f, f % 2 == 0);
  return y;
}

void check_twice(std::uint64_t first_seed, std::uint64_t seeds) {
  for (const scenes::Family& family : scenes::families())
    for (std::uint64_t seed = first_seed; seed < first_seed + seeds; ++seed) {
      const Labelled x = labelled(family.make(seed), seed % 2 == 0);
      INFO(family.name << " " << seed << "\n" << scenes::to_text(x.scene));
      CHECK(difference(x.ink(), stored_twice(x, seed % 3 == 0).ink()) == "");
    }
  for (std::uint64_t seed = first_seed; seed < first_seed + seeds; ++seed) {
    Labelled x = Blocks(seed).apart();
    x.scene.view = scenes::from_direction({1, -1, 1});
    CHECK(difference(x.ink(), stored_twice(x, false).ink()) == "");
  }
}

TEST_CASE("a file in which every face is stored twice is drawn as with each once", "[lines][metamorphic][shape][C21]") {
  check_twice(750'000, 12);
}

TEST_CASE("a box that is stored twice on a floor keeps its hidden lines", "[lines][shape][C21]") {
  Labelled once, twice;
  for (Labelled* x : {&once, &twice}) {
    x->add_face({{-5, -5, 0}, {9, -5, 0}, {9, 9, 0}, {-5, 9, 0}});
    x->add_box({0, 0, 0}, {3, 3, 3});
    x->scene.view = scenes::from_direction({1, -1, 1});
  }
  twice.add_box({0, 0, 0}, {3, 3, 3});
  // Of a box on a floor the foot is hidden twice, and an edge that goes up.
  CHECK(lines_of(once, "hidden") == 3);
  CHECK(by_visibility(once.ink()) == by_visibility(twice.ink()));
}

TEST_CASE("the corner of a doubled sheet on a floor is no place where bodies touch", "[lines][shape][C21]") {
  Labelled x;
  x.add_face({{-5, -5, 0}, {9, -5, 0}, {9, 9, 0}, {-5, 9, 0}});
  for (int k = 0; k < 2; ++k) {
    x.add_face({{0, 0, 0}, {3, 0, 0}, {3, 0, 2}, {0, 0, 2}});
    x.add_face({{0, 0, 0}, {0, 4, 0}, {0, 4, 2}, {0, 0, 2}});
  }
  x.scene.view = scenes::from_direction({1, -2, -1});  // from below: the floor hides all of it
  INFO(x.ink());
  CHECK(lines_of(x, "hidden boundary") == 4);  // its ends and its upper side
  CHECK(lines_of(x, "hidden outline") == 1);   // its corner; at its foot it may be a body on either side
}

TEST_CASE("many files in which every face is stored twice are drawn as with each once",
          "[lines][metamorphic][shape][.][long]") {
  check_twice(760'000, 200);
}

TEST_CASE("the foot of a wall seen edge-on is an edge like any other", "[lines][shape][C2][C7]") {
  Labelled x;
  x.add_face({{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}});
  x.add_face({{2, 4, 0}, {6, 4, 0}, {6, 4, 3}, {2, 4, 3}});
  x.scene.view = scenes::from_direction({0, 0, 1});
  CHECK(lines_of(x, "visible sharp") + lines_of(x, "visible outline") + lines_of(x, "visible boundary") == 5);
  // Under the floor it is behind: hidden, and no line on the floor.
  for (std::size_t k = 4; k < 8; ++k) x.scene.points[k].z = -x.scene.points[k].z;
  CHECK(lines_of(x, "visible") == 4);
  CHECK(lines_of(x, "hidden sharp") + lines_of(x, "hidden boundary") == 1);
}

TEST_CASE("where two boxes touch, their walls seen edge-on make no line", "[lines][shape][C17]") {
  Labelled x = two_boxes(3);
  x.scene.view = scenes::from_direction({0, 0, 1});  // both walls of the joint are edge-on and coincide
  CHECK(lines_of(x, "visible sharp") == 0);
  CHECK(lines_of(x, "visible joint") == 1);
  CHECK(lines_of(x, "hidden") == 0);
}

TEST_CASE("a sheet that is stored twice is pierced as one is", "[lines][shape][C6][C17]") {
  Labelled whole;
  for (int k = 0; k < 2; ++k) whole.add_face({{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}});
  whole.add_face({{0, 2, -1}, {8, 2, -1}, {8, 6, 1}, {0, 6, 1}});
  Labelled cut;
  for (int k = 0; k < 2; ++k) {
    cut.add_face({{0, 0, 0}, {8, 0, 0}, {8, 4, 0}, {0, 4, 0}});
    cut.add_face({{0, 4, 0}, {8, 4, 0}, {8, 8, 0}, {0, 8, 0}});
  }
  cut.add_face({{0, 2, -1}, {8, 2, -1}, {8, 4, 0}, {0, 4, 0}});
  cut.add_face({{0, 4, 0}, {8, 4, 0}, {8, 6, 1}, {0, 6, 1}});
  for (const Point3& direction : {Point3{0, 0, 1}, Point3{1, -1, 1}, Point3{2, -3, 1}}) {
    whole.scene.view = cut.scene.view = scenes::from_direction(direction);
    CHECK(lines_of(whole, "intersection") > 0);
    CHECK(difference(whole.ink(), cut.ink()) == "");
  }
}

TEST_CASE("facets that meet at the crease angle are all alike", "[lines][shape][C20]") {
  Labelled x;
  const int n = 12;  // 30 degrees, but for the rounding of sines
  for (int k = 0; k < n; ++k) {
    const auto at = [](int i) { return 2 * 3.14159265358979323846 * i / 12; };
    x.add_face({{10 * std::cos(at(k)), 10 * std::sin(at(k)), 0},
                {10 * std::cos(at(k + 1)), 10 * std::sin(at(k + 1)), 0},
                {10 * std::cos(at(k + 1)), 10 * std::sin(at(k + 1)), 20},
                {10 * std::cos(at(k)), 10 * std::sin(at(k)), 20}});
  }
  for (Point3& p : x.scene.points) {  // as a file of six digits has it
    p.x = std::round(p.x * 1e5) / 1e5;
    p.y = std::round(p.y * 1e5) / 1e5;
  }
  x.scene.view = scenes::from_direction({2, -3, 1.5});
  CHECK(lines_of(x, "sharp") == 0);
}

}  // namespace
}  // namespace hsr
