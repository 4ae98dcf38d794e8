#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <numeric>
#include <random>

#include "hsr/io/read/read.h"
#include "tests/lines/labelled_scene.h"
#include "tests/oracle/exact_vector.h"
#include "tests/scenes/random_scenes.h"

// A drawing depends on the shape, not on how it is cut into faces: random scenes, and models.

namespace hsr {

namespace {

using oracle::Vec;

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

}  // namespace
}  // namespace hsr
