#include <catch2/catch.hpp>
#include <exception>

#include "hsr/painter/sort/z_sort.h"
#include "hsr/raster/caster.h"
#include "hsr/raster/depth_buffer.h"
#include "hsr/raster/row_z_buffer.h"
#include "hsr/raster/tiled_z_buffer.h"
#include "hsr/surfaces/visible_fragments.h"
#include "tests/scenes/coincident_faces.h"
#include "tests/scenes/random_scenes.h"

// `last` of a scene is `first` of the scene with its faces listed backwards: whatever the oracle may have wrong.

namespace hsr {

using namespace internal;

namespace {

/// A scene under `last`, and backwards under `first`.
struct Pair {
  Mesh mesh, backwards;
  View view;

  explicit Pair(const scenes::TestScene& scene)
      : mesh(scene.mesh()), backwards(scenes::backwards(scene).mesh()), view(scene.view) {}
  SceneView last() const { return {mesh, view, {.coplanar = Coplanar::last}}; }
  SceneView first() const { return {backwards, view}; }
  FaceId mapped(FaceId f) const { return FaceId(mesh.faces.size() - 1 - f.value); }

  template <class Pixel, class TriangleOf>
  void compare(const Image<Pixel>& of_last, const Image<Pixel>& of_first, const TriangleOf& triangle_of) const {
    std::size_t different = 0;
    for (std::size_t k = 0; k < of_last.pixels.size(); ++k) {
      const TriangleId t = triangle_of(of_last.pixels[k]), u = triangle_of(of_first.pixels[k]);
      different += t.is_valid() != u.is_valid() || (t.is_valid() && mapped(mesh.face_of[t]) != backwards.face_of[u]) ? 1U : 0U;
    }
    CHECK(different == 0);
  }
  template <class Real>
  void compare(const DepthImage<Real>& of_last, const DepthImage<Real>& of_first) const {
    compare(of_last, of_first, [](const DepthPixel<Real>& p) { return p.triangle; });
  }
  void compare(const Image<TriangleId>& of_last, const Image<TriangleId>& of_first) const {
    compare(of_last, of_first, [](TriangleId t) { return t; });
  }
};

template <class Visit>
void for_each_pair(const Visit& visit) {
  for (const char* family : {"triangles", "polygons", "boxes", "slopes", "around_the_eye", "echoes"})
    for (std::uint64_t seed = 100; seed < 130; ++seed) {
      const scenes::TestScene scene = scenes::with_coincident_faces(scenes::family(family).make(seed), seed);
      INFO(family << " " << seed << "\n" << scenes::to_text(scene));
      visit(Pair(scene));
    }
}

/// The exact visible area of each face.
std::vector<Rational> areas(const SceneView& scene) {
  const VisibleFragments found = visible_fragments(scene);
  const std::vector<Rational> of_fragment = visible_areas(scene.mesh(), scene.view(), found);
  std::vector<Rational> of_face(scene.mesh().faces.size());
  for (std::size_t k = 0; k < of_fragment.size(); ++k) {
    Rational& sum = of_face[scene.mesh().face_of[first_triangle(found.fragments[k].facet)].value];
    sum = sum + of_fragment[k];
  }
  return of_face;
}

TEST_CASE("what is visible under last is what is visible under first with the faces backwards", "[ties][metamorphic][S8]") {
  bool differs = false;  // from `first` of the scene itself, or the test would say nothing
  for_each_pair([&](const Pair& p) {
    const std::vector<Rational> last = areas(p.last()), first = areas(p.first());
    for (std::size_t f = 0; f < last.size(); ++f) CHECK(last[f] == first[p.mapped(FaceId(f)).value]);
    differs = differs || last != areas(SceneView(p.mesh, p.view));
  });
  CHECK(differs);
}

TEST_CASE("pictures under last are those under first with the faces backwards", "[ties][metamorphic][G7]") {
  for_each_pair([](const Pair& p) {
    SampleGrid grid;
    CastImage seen;
    try {
      grid = sample_grid(p.view, paper_rectangle(p.mesh, p.view), 16, 16);
      seen = cast(p.last(), grid);
    } catch (const std::exception&) {
      return;  // no samples: the eye is in their plane, or they are no doubles
    }
    p.compare(seen.triangles, cast(p.first(), grid).triangles);
    const TieRule last = Coplanar::last;
    p.compare(z_buffer<float>(p.mesh, p.view, grid, last), z_buffer<float>(p.backwards, p.view, grid));
    p.compare(z_buffer<double>(p.mesh, p.view, grid, last), z_buffer<double>(p.backwards, p.view, grid));
    p.compare(row_z_buffer<float>(p.mesh, p.view, grid, last).image, row_z_buffer<float>(p.backwards, p.view, grid).image);
    p.compare(tiled_z_buffer<float>(p.mesh, p.view, grid, last).image, tiled_z_buffer<float>(p.backwards, p.view, grid).image);
    const DepthRange range = depth_range(p.mesh, p.view, grid);
    for (const DepthFunction function : {DepthFunction::less, DepthFunction::lequal, DepthFunction::greater})
      p.compare(depth_buffer(p.mesh, p.view, grid, range, {.function = function, .ties = last}).triangles,
                depth_buffer(p.backwards, p.view, grid, range, {.function = function}).triangles);
  });
}

TEST_CASE("a sort by depths alone paints equally far faces as the rule says", "[ties][metamorphic][P18]") {
  for_each_pair([](const Pair& p) {
    for (const DepthKey key : {DepthKey::centroid, DepthKey::farthest_vertex}) {
      std::vector<FaceId> last, first;
      for (const OrderedPiece& piece : z_sort(p.last(), key).pieces)
        last.push_back(p.mapped(p.mesh.face_of[first_triangle(piece.facet)]));
      for (const OrderedPiece& piece : z_sort(p.first(), key).pieces)
        first.push_back(p.backwards.face_of[first_triangle(piece.facet)]);
      CHECK(last == first);
    }
  });
}

}  // namespace
}  // namespace hsr
