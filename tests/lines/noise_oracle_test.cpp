#include <catch2/catch.hpp>
#include <cmath>
#include <optional>
#include <random>
#include <sstream>
#include <vector>

#include "hsr/lines/visible_lines.h"
#include "tests/lines/ink.h"
#include "tests/oracle/edge_class_oracle.h"
#include "tests/oracle/exact_vector.h"
#include "tests/oracle/visible_lines_oracle.h"
#include "tests/scenes/random_scenes.h"
#include "tests/scenes/test_scene.h"

// With a tolerance the lines of a scene that noise has moved have the classes of the clean scene, by what hides them clearly: both
// straight from the definitions, in rationals.

namespace hsr {

namespace {

using oracle::Q;
using oracle::Vec;
using scenes::TestScene;

/// A wall, what fills it from side to side, a post in it that is as high, and a sill on it.
TestScene filled_wall() {
  TestScene scene;
  scene.add_box({0, 0, 0}, {10, 0.25, 3});
  scene.add_box({1, 0, 1}, {2, 0.25, 2.125});
  scene.add_box({4, 0, 0}, {4.5, 0.25, 3});
  scene.add_box({6, -0.25, 1}, {7, 0, 1.125});
  return scene;
}

Point3 turned(const Point3& p, double degrees) {
  const double angle = degrees * 3.14159265358979323846 / 180, c = std::cos(angle), s = std::sin(angle);
  return {c * p.x - s * p.y, s * p.x + c * p.y, p.z};
}

/// Whether a point is farther from a triangle than a distance.
bool is_farther(const Mesh& mesh, TriangleId t, const Vec& p, const Q& distance) {
  const auto& c = mesh.triangles[t];
  const Vec a(mesh.points[c[0]]), b(mesh.points[c[1]]), d(mesh.points[c[2]]), corners[3] = {a, b, d};
  const Vec normal = cross(b - a, d - a);
  const Q off = dot(normal, p - a);
  if (off * off > distance * distance * dot(normal, normal)) return true;
  // In its plane, but for the distance: beyond a side of it.
  for (int k = 0; k < 3; ++k) {
    const Vec inward = cross(normal, corners[(k + 1) % 3] - corners[k]);
    const Q within = dot(inward, p - corners[k]);
    if (sgn(within) < 0 && within * within > distance * distance * dot(inward, inward)) return true;
  }
  return false;
}

const oracle::ClassPart* part_at(const std::vector<oracle::ClassPart>& parts, const Q& t) {
  for (const auto& part : parts)
    if (part.part.from < t && t < part.part.to) return &part;
  return nullptr;
}

/// The classes along the edges of the clean scene, which has the same points.
class CleanClasses {
 public:
  explicit CleanClasses(const TestScene& scene) : mesh_(scene.mesh()) {
    const oracle::VisibleLinesOracle visibility(mesh_, scene.view);
    std::vector<std::optional<oracle::Interval>> beyond;
    for (std::size_t e = 0; e < mesh_.edges.size(); ++e) {
      const auto seen = visibility.visibility(EdgeId(e));
      beyond.push_back(seen.is_seen ? std::optional(seen.beyond) : std::nullopt);
    }
    parts_ = oracle::class_parts(mesh_, scene.view, {}, Coplanar::first, 30, beyond);
  }
  const oracle::ClassPart* at(VertexId a, VertexId b, const Q& t) const {
    const EdgeId id = mesh_.find_edge(a, b);
    return id.is_valid() ? part_at(parts_[id.value], t) : nullptr;
  }

 private:
  Mesh mesh_;
  std::vector<std::vector<oracle::ClassPart>> parts_;
};

/// What is compared: hidden parts of lines of two classes. By noise: nothing hides them that does not touch them.
struct Compared {
  int clear = 0, by_noise = 0;
};

/// Each hidden part of an edge of the noisy scene, as a text if its class is not that of the clean one.
std::string wrong_classes(const CleanClasses& clean, const TestScene& noisy, double tolerance, Compared& compared) {
  const Mesh mesh = make_mesh(noisy.points, noisy.polygons, tolerance);
  LineOptions options;
  options.tolerance = tolerance;
  options.classes.fill(true);
  const VisibleLines lines = visible_lines(mesh, noisy.view, options);
  const oracle::VisibleLinesOracle visibility(mesh, noisy.view);
  std::ostringstream wrong;
  for (const Line& line : lines.lines) {
    if (line.is_intersection() || line.is_behind) continue;
    const Edge& edge = mesh.edges[line.edge];
    const SupportingLine support = supporting_line_of(mesh, lines, line);
    const auto cuts = lines.cuts_of(line);
    for (std::uint32_t k = 0; k < line.intervals(); ++k) {
      const Q from = oracle::exact(exact_parameter(mesh, noisy.view, support, cuts[k]));
      const Q to = oracle::exact(exact_parameter(mesh, noisy.view, support, cuts[k + 1])), middle = (from + to) / 2;
      const oracle::ClassPart* const part = clean.at(edge.a, edge.b, middle);
      if (!line.hidden(k) || to - from < 1e-6 || part == nullptr || !part->verdict || !part->hidden) continue;
      const Vec a(mesh.points[edge.a]), p = a + middle * (Vec(mesh.points[edge.b]) - a);
      bool is_clear = false;
      for (std::size_t t = 0; t < mesh.triangles.size() && !is_clear; ++t)
        is_clear = visibility.hides(TriangleId(t), p) && is_farther(mesh, TriangleId(t), p, Q(tolerance));
      ++(is_clear ? compared.clear : compared.by_noise);
      const EdgeClass expected = is_clear ? part->hidden->edge_class : part->verdict->edge_class;
      if (expected == line.edge_class) continue;
      wrong << edge.a.value << "-" << edge.b.value << " from " << from.get_d() << " to " << to.get_d() << ": "
            << edge_class_names[static_cast<std::size_t>(line.edge_class)] << ", expected "
            << edge_class_names[static_cast<std::size_t>(expected)] << (is_clear ? "\n" : ", hidden by noise\n");
    }
  }
  return wrong.str();
}

TEST_CASE("what noise hides has the class of what is seen, and what something hides clearly that of what is hidden",
          "[lines][tolerance][oracle][T2][T5]") {
  TestScene straight = filled_wall();
  const Point3 direction = {1.25, -1.375, 1};
  straight.view = parallel_view(direction, {0, 0, 1});
  const CleanClasses clean(straight);
  std::mt19937_64 random(19);
  Compared compared;
  for (int k = 0; k < 10; ++k) {
    const double degrees = std::uniform_real_distribution<>(0, 360)(random);
    TestScene noisy = straight;
    for (Point3& p : noisy.points) p = turned(p, degrees);
    noisy.view = parallel_view(turned(direction, degrees), {0, 0, 1});
    INFO(degrees << " degrees");
    CHECK(wrong_classes(clean, noisy, 1e-9, compared) == "");
  }
  CHECK(compared.clear > 50);
  CHECK(compared.by_noise > 10);
}

/// Each part of an edge with its visibility and class, by its exact parameters.
std::string edge_parts_of(const SceneView& scene, double tolerance) {
  LineOptions options;
  options.classes.fill(true);
  options.tolerance = tolerance;
  const VisibleLines lines = visible_lines(scene, options);
  std::ostringstream text;
  for (const Line& line : lines.lines) {
    if (line.is_intersection()) continue;
    const SupportingLine support = supporting_line_of(scene.mesh(), lines, line);
    const auto cuts = lines.cuts_of(line);
    for (std::uint32_t k = 0; k < line.intervals(); ++k)
      text << support.a.value << "-" << support.b.value << " "
           << oracle::exact(exact_parameter(scene.mesh(), scene.view(), support, cuts[k])) << " to "
           << oracle::exact(exact_parameter(scene.mesh(), scene.view(), support, cuts[k + 1]))
           << (line.is_behind   ? " behind "
               : line.hidden(k) ? " hidden "
                                : " visible ")
           << edge_class_names[static_cast<std::size_t>(line.edge_class)] << "\n";
  }
  return text.str();
}

TEST_CASE("on a clean scene a tolerance far below its steps changes no ink", "[lines][metamorphic][tolerance][T2][T5]") {
  for (const char* name : {"triangles", "polygons", "boxes", "edge_on"})
    for (std::uint64_t seed = 770'000; seed < 770'040; ++seed) {
      const TestScene scene = scenes::family(name).make(seed);
      INFO(name << " " << seed << "\n" << scenes::to_text(scene));
      const Mesh mesh = scene.mesh();
      const SceneView view(mesh, scene.view);
      CHECK(ink_of(view) == ink_of(view, 1e-9));
    }
}

// Two floors side by side, each with a wall where they meet, seen from above: edge-on. The foot is hidden by the walls, which touch
// it, and not by noise.
TEST_CASE("what a touching face seen edge-on hides toward the eye is not hidden by noise", "[lines][tolerance][T5]") {
  TestScene floors;
  floors.points = {{4, 0, 0}, {4, 3, 0}, {0, 1, 0}, {8, 1, 0}, {4, 2, 1}};
  floors.add_face({0, 1, 2});
  floors.add_face({1, 0, 3});
  for (int k = 0; k < 2; ++k) floors.add_face({0, 1, 4});
  floors.view = parallel_view({0, 0, 1}, {0, 1, 0});
  const Mesh mesh = floors.mesh();
  const SceneView view(mesh, floors.view);
  const std::string parts = edge_parts_of(view, 0);
  CHECK(parts.find("0-1 0 to 1 hidden smooth") != std::string::npos);
  CHECK(edge_parts_of(view, 1e-9) == parts);
}

}  // namespace
}  // namespace hsr
