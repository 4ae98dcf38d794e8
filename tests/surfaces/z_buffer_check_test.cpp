#include "hsr/check/z_buffer_check.h"

#include <catch2/catch.hpp>
#include <random>

#include "geometry/error.h"
#include "hsr/surfaces/visible_fragments.h"
#include "tests/scenes/random_scenes.h"

namespace hsr {

using namespace internal;

namespace {

/// The picture of all that is beyond the near plane; not valid where there is none.
struct Picture {
  Mesh mesh;
  View view;
  SampleGrid grid;
  CastImage seen;
  bool is_valid = false;

  Picture(const scenes::TestScene& scene, int width, int height) : mesh(scene.mesh()), view(scene.view) {
    try {
      grid = sample_grid(view, paper_rectangle(mesh, view), width, height);
      seen = cast(mesh, view, grid);
      std::uint64_t overlapping = 0;
      (void)paint(mesh, view, visible_fragments(mesh, view), grid, overlapping);
      is_valid = true;
    } catch (const InputError&) {         // not finite
    } catch (const PreconditionError&) {  // the samples are not where they should be: paint() refuses
    }
  }

  template <class Real>
  DepthImage<Real> drawn() const {
    return z_buffer<Real>(mesh, view, grid);
  }
  template <class Real>
  ZBufferCheck check(const DepthImage<Real>& image) const {
    return check_z_buffer(mesh, view, grid, image, seen.triangles);
  }
};

ZBufferCheck& operator+=(ZBufferCheck& a, const ZBufferCheck& b) {
  a.wrong += b.wrong;
  a.depth += b.depth;
  a.edge += b.edge;
  a.unbounded += b.unbounded;
  a.other += b.other;
  return a;
}

TEST_CASE("every difference of the z-buffer to the caster is explained", "[check][z_buffer][property][K1]") {
  ZBufferCheck single, twice;
  for (const scenes::Family& family : scenes::families())
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      const scenes::TestScene scene = family.make(seed);
      const Picture picture(scene, 40, 30);
      if (!picture.is_valid) continue;
      INFO(family.name << " " << seed << "\n" << scenes::to_text(scene));
      const ZBufferCheck of_float = picture.check(picture.drawn<float>()), of_double = picture.check(picture.drawn<double>());
      CHECK(of_float.other == 0);
      CHECK(of_double.other == 0);
      CHECK(of_float.wrong == of_float.depth + of_float.edge + of_float.unbounded);
      single += of_float;
      twice += of_double;
    }
  // Or the test would say nothing.
  CHECK(single.depth > 100);
  CHECK(single.edge > 100);
  CHECK(twice.wrong < single.wrong);
}

TEST_CASE("what no rounding explains is called a mistake", "[check][z_buffer][K1]") {
  std::mt19937_64 engine(7);
  int planted = 0;
  for (const char* name : {"triangles", "boxes", "polygons"})
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const Picture picture(scenes::family(name).make(seed), 64, 48);
      if (!picture.is_valid || picture.mesh.triangles.size() < 2) continue;
      INFO(name << " " << seed);
      const DepthImage<float> right = picture.drawn<float>();
      const auto i = static_cast<int>(engine() % 64), j = static_cast<int>(engine() % 48);
      const DepthPixel<float> p = right.at(i, j);
      if (!p.triangle.is_valid() || p.triangle != picture.seen.triangles.at(i, j)) continue;
      DepthImage<float> hole = right, other = right;
      hole.at(i, j) = {};
      other.at(i, j).triangle = TriangleId((p.triangle.value + 1U) % picture.mesh.triangles.size());
      CHECK(picture.check(hole).other == 1);
      if (picture.mesh.face_of[other.at(i, j).triangle] != picture.mesh.face_of[p.triangle]) {
        CHECK(picture.check(other).other == 1);
        ++planted;
      }
    }
  CHECK(planted > 10);
}

/// Two squares, the nearer (face 1) `gap` above the other, seen from above; the samples' plane goes through the lower.
scenes::TestScene two_squares(double gap) {
  scenes::TestScene scene;
  scene.view = parallel_view({0, 0, 1}, {0, 1, 0});
  // Sloping, so that the depths of samples are no floats.
  for (const double z : {0.0, gap}) scene.add_face(std::vector<Point3>{{0, 0, z}, {7, 0, z + 3}, {7, 7, z + 4}, {0, 7, z + 1}});
  return scene;
}

TEST_CASE("a gap that floats do not resolve is a depth tie, one that they do is none", "[check][z_buffer]") {
  const Picture close(two_squares(1e-9), 50, 50), far(two_squares(1e-3), 50, 50);
  const ZBufferCheck of_close = close.check(close.drawn<float>());
  CHECK(of_close.covered > 2000);
  CHECK(of_close.depth > 1000);  // the lower was first
  CHECK(of_close.other == 0);
  CHECK(close.check(close.drawn<double>()).wrong == 0);
  CHECK(far.check(far.drawn<float>()).depth == 0);
  // A z-buffer that lets the farther win is caught.
  DepthImage<float> wrong = far.drawn<float>();
  const DepthImage<float> lower = Picture(two_squares(1e-9), 50, 50).drawn<float>();
  int changed = 0;
  for (std::size_t k = 0; k < wrong.pixels.size(); ++k)
    if (wrong.pixels[k].triangle.is_valid() && lower.pixels[k].triangle.is_valid()) {
      wrong.pixels[k].triangle = TriangleId(wrong.pixels[k].triangle.value - 2);
      ++changed;
    }
  CHECK(changed > 2000);
  CHECK(far.check(wrong).other > 2000);
}

}  // namespace
}  // namespace hsr
